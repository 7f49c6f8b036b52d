#include "dem/stones/fragment.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// What is left of the ellipsoid bounds the body beyond the corners of the faces.
constexpr double bound = 1.3;

// The larger of a and b (the larger one positive), with the kink at a = b smoothed over a width of
// `wear` times the value; homogeneous of degree 1.
double worn_maximum(double a, double b, double wear)
{
  const double larger = std::max(a, b), width = wear * larger;
  const double overlap = std::max(0., width - std::abs(a - b));
  return larger + overlap * overlap / (4 * width);
}

// Nearly normal (the sum of twelve uniform numbers), with the same digits everywhere.
double normal_number(RandomStream& random)
{
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

double draw_ratio(double mean, double spread, RandomStream& random)
{
  for (;;) {
    const double ratio = mean + spread * normal_number(random);
    if (ratio >= 0.3 && ratio <= 1) return ratio;
  }
}

// A number of features about `mean`, with a standard deviation of its root at most.
int draw_count(int mean, RandomStream& random)
{
  const double spread = std::min(0.5 * std::sqrt(mean), 2.);
  return std::max(0, int(std::lround(mean + spread * normal_number(random))));
}
} // namespace

double Fragment::Face::gauge(const Vector3& x) const
{
  const double along = normal.dot(x);
  if (along <= 0) return 0;
  if (std::isinf(radius)) return along / distance;
  // The ray t x enters the ball around c = (distance + radius) normal at the smaller root of
  // t^2 |x|^2 - 2 t x.c + |c|^2 - radius^2 = 0; the gauge is 1/t.
  const double power = distance * (distance + 2 * radius);
  const double half = along * (distance + radius);
  const double root = half * half - power * x.squaredNorm();
  return root < 0 ? 0 : (half + std::sqrt(root)) / power;
}

double Fragment::gauge(const Vector3& x) const
{
  double body = x.cwiseQuotient(semi_axes_).norm() / bound;
  for (const Face& face : faces_) body = worn_maximum(body, face.gauge(x), wear_);
  for (const Step& step : steps_)
    body = worn_maximum(body, std::min(step.floor.gauge(x), step.riser.gauge(x)), wear_);
  return body;
}

double Fragment::touching_distance(const Vector3& normal) const
{
  return normal.cwiseProduct(semi_axes_).norm();
}

Fragment::Fragment(const StoneStyle& style, RandomStream& random) : wear_(style.edge_wear)
{
  const double elongation = draw_ratio(style.elongation, style.elongation_spread, random);
  const double flatness = draw_ratio(style.flatness, style.flatness_spread, random);
  semi_axes_ = Vector3(1, elongation, elongation * flatness);
  draw_faces(style, random);
  draw_scars(style, random);
  chip_bare_corners(random);
  draw_steps(style, random);
}

void Fragment::draw_faces(const StoneStyle& style, RandomStream& random)
{
  const int count = std::max(5, draw_count(style.faces, random));
  // Faces that keep apart leave no bare rounded caps; few faces can keep farther apart.
  double nearest = std::min(0.85, 1 - 3. / count);
  while (static_cast<int>(faces_.size()) < count) {
    const Vector3 normal = random.direction();
    if (std::any_of(faces_.begin(), faces_.end(),
                    [&](const Face& other) { return other.normal.dot(normal) > nearest; })) {
      nearest = std::min(0.95, nearest + 0.002); // so that the last ones find room too
      continue;
    }
    faces_.push_back({normal, touching_distance(normal) * random.uniform(0.6, 0.9), INFINITY});
  }
}

void Fragment::draw_scars(const StoneStyle& style, RandomStream& random)
{
  const int count = std::min(draw_count(style.scars, random), int(faces_.size()));
  for (int k = 0; k < count; ++k) {
    // The faces come in random order, so the first ones are as good as any.
    Face& face = faces_[k];
    const double depth = style.scar_depth * random.uniform(0.5, 1.5);
    if (depth <= 0) continue;
    // Sagitta of a hollow whose rim is half a size across; a size is two intermediate semi-axes.
    const double size = 2 * semi_axes_[1], rim = size / 2;
    const double radius = rim * rim / (8 * depth * size);
    // Rays that graze the ball must do so outside the body, or its surface would jump there.
    const double reach = 1.3 * bound;
    face.radius = std::max(radius, (reach * reach / face.distance - face.distance) / 2);
  }
}

void Fragment::chip_bare_corners(RandomStream& random)
{
  for (int k = 0; k < 300; ++k) {
    const Vector3 x = random.direction();
    const double rounded = x.cwiseQuotient(semi_axes_).norm() / bound;
    if (gauge(x) > 1.001 * rounded) continue;
    const Vector3 on_ellipsoid = x.cwiseQuotient(semi_axes_.cwiseProduct(semi_axes_));
    const Vector3 normal = (on_ellipsoid.normalized() + 0.3 * random.direction()).normalized();
    const double distance = bound * touching_distance(normal) * random.uniform(0.84, 0.94);
    faces_.push_back({normal, distance, INFINITY});
  }
}

void Fragment::draw_steps(const StoneStyle& style, RandomStream& random)
{
  const int count = draw_count(style.steps, random);
  for (int k = 0; k < count; ++k) {
    const Vector3 middle = random.direction();
    const Vector3 sideways = middle.cross(random.direction()).normalized();
    const double height = 2 * semi_axes_[1] * style.scar_depth * random.uniform(1, 2.5);
    const Vector3 foot = surface_point(middle) - height * middle;
    // The floor is nearly square to the ray, the riser 25 to 40 degrees off it: a steeper one would
    // pull the nodes of the mesh apart.
    const double tilt = random.uniform(-0.25, 0.25), slope = random.uniform(0.45, 0.7);
    const Vector3 floor = std::cos(tilt) * middle + std::sin(tilt) * sideways;
    const Vector3 riser = std::sin(slope) * middle + std::cos(slope) * sideways;
    if (foot.dot(middle) > 0.2)
      steps_.push_back({{floor, foot.dot(floor), INFINITY}, {riser, foot.dot(riser), INFINITY}});
  }
}
} // namespace interlock::dem
