#include "dem/lists/sphere_pairs.h"

namespace interlock::dem
{
void SphereWalk::take_shapes(const std::vector<ClumpShape>& shapes)
{
  while (members_.size() < shapes.size()) {
    members_.emplace_back();
    for (const Sphere& sphere : shapes[members_.size() - 1].spheres) {
      members_.back().centre.push_back(sphere.centre);
      members_.back().radius.push_back(Eigen::Matrix<double, 1, 1>(sphere.radius));
    }
  }
}

double SphereWalk::heights(const Members& members, const Vector3& axis)
{
  const int n = members.centre.padded_size();
  if (static_cast<int>(height_.size()) < n) height_.resize(n);
  const double *x = members.centre.row(0), *y = members.centre.row(1), *z = members.centre.row(2),
               *r = members.radius.row(0);
  const double ax = axis[0], ay = axis[1], az = axis[2];
  double* h = height_.data();
  double front = -1e300;
#pragma omp simd reduction(max : front)
  for (int k = 0; k < n; ++k) {
    h[k] = ax * x[k] + ay * y[k] + az * z[k] + r[k];
    front = front > h[k] ? front : h[k];
  }
  return front;
}

// Without a branch: which of the members are chosen is no rule that a processor could learn.
int SphereWalk::choose(int n, double least)
{
  if (static_cast<int>(chosen_.size()) < n) chosen_.resize(n);
  int count = 0;
  for (int k = 0; k < n; ++k) {
    chosen_[count] = k;
    count += height_[k] >= least;
  }
  return count;
}

// Along the line of centres only members that reach past the front of the other clump can be near
// it. Those that are left are thinned by their boxes and tested in pairs.
void SphereWalk::add_pairs(const Clumps& clumps, int i, int j, double cut,
                           std::vector<NearSpheres>& near)
{
  const Members &mi = members_[clumps.shape[i]], &mj = members_[clumps.shape[j]];
  const Quaternion qi = clumps.orientation[i];
  const Matrix3 to_i = (qi.conjugate() * clumps.orientation[j]).toRotationMatrix();
  const Vector3 between = qi.conjugate()._transformVector(clumps.position[j] - clumps.position[i]);
  const double distance = between.norm();
  const Vector3 axis = distance > 0 ? Vector3(between / distance) : Vector3::UnitX();

  const Vector3 axis_j = to_i.transpose() * -axis;
  const double front_j = distance - heights(mj, axis_j); // of j towards i, from the centre of i
  const double front_i = heights(mi, axis);
  if (front_i + cut < front_j) return;
  first_.resize(choose(mi.centre.size(), front_j - cut));
  for (std::size_t k = 0; k < first_.index.size(); ++k)
    first_.set(k, chosen_[k], mi.centre[chosen_[k]], mi.radius[chosen_[k]]);
  heights(mj, axis_j);
  second_.resize(choose(mj.centre.size(), distance - front_i - cut));
  for (std::size_t k = 0; k < second_.index.size(); ++k)
    second_.set(k, chosen_[k], between + to_i * mj.centre[chosen_[k]], mj.radius[chosen_[k]]);

  Vector3 low, high;
  second_.box(low, high);
  first_.keep_reaching(low.array() - cut, high.array() + cut);
  if (first_.index.empty()) return;
  first_.box(low, high);
  second_.keep_reaching(low.array() - cut, high.array() + cut);
  test_all(cut, near);
}

void SphereWalk::test_all(double cut, std::vector<NearSpheres>& near)
{
  second_.pad();
  const int n = static_cast<int>(second_.x.size());
  const double *x = second_.x.data(), *y = second_.y.data(), *z = second_.z.data(),
               *r = second_.r.data();
  for (std::size_t a = 0; a < first_.index.size(); ++a) {
    const double ax = first_.x[a], ay = first_.y[a], az = first_.z[a], ar = first_.r[a] + cut;
    double nearest = 1e300;
#pragma omp simd reduction(min : nearest)
    for (int b = 0; b < n; ++b) {
      const double dx = ax - x[b], dy = ay - y[b], dz = az - z[b], reach = ar + r[b];
      const double over = dx * dx + dy * dy + dz * dz - reach * reach;
      nearest = nearest < over ? nearest : over;
    }
    if (nearest > 0) continue;
    for (std::size_t b = 0; b < second_.index.size(); ++b) {
      const double gap = std::sqrt((ax - x[b]) * (ax - x[b]) + (ay - y[b]) * (ay - y[b]) +
                                   (az - z[b]) * (az - z[b])) -
                         first_.r[a] - r[b];
      if (gap <= cut) near.push_back({first_.index[a], second_.index[b], gap});
    }
  }
}

void SphereWalk::add_at_wall(const Clumps& clumps, int i, const Wall& wall, double cut,
                             std::vector<NearSpheres>& near)
{
  // Towards the wall, from the side on which the clump's centre is; the plane first.
  const Vector3 x = clumps.position[i], normal = wall.edge1.cross(wall.edge2).normalized();
  const double height = normal.dot(x - wall.corner);
  const Vector3 down =
      clumps.orientation[i].conjugate()._transformVector(height > 0 ? Vector3(-normal) : normal);
  const Members& members = members_[clumps.shape[i]];
  if (heights(members, down) + cut < std::abs(height)) return;
  for (int a = 0; a < members.centre.size(); ++a) {
    if (height_[a] + cut < std::abs(height)) continue;
    const Vector3 centre = x + clumps.member_offset(i, a);
    const double gap = (centre - wall.nearest_point(centre)).norm() - members.radius[a];
    if (gap <= cut) near.push_back({a, 0, gap});
  }
}

void SphereWalk::Chosen::resize(std::size_t n)
{
  index.resize(n);
  for (std::vector<double>* values : {&x, &y, &z, &r}) values->resize(n);
}

void SphereWalk::Chosen::pad()
{
  const std::size_t n = padded(static_cast<int>(index.size()));
  for (std::vector<double>* values : {&x, &y, &z, &r}) values->resize(n, 1e3);
  std::fill(r.begin() + index.size(), r.end(), 0.);
}

void SphereWalk::Chosen::box(Vector3& low, Vector3& high) const
{
  const auto extent = [&](const std::vector<double>& centre, double& least, double& most) {
    const double *c = centre.data(), *radius = r.data();
    double from = 1e300, to = -1e300;
#pragma omp simd reduction(min : from) reduction(max : to)
    for (std::size_t k = 0; k < index.size(); ++k) {
      const double begin = c[k] - radius[k], end = c[k] + radius[k];
      from = from < begin ? from : begin;
      to = to > end ? to : end;
    }
    least = from;
    most = to;
  };
  extent(x, low[0], high[0]);
  extent(y, low[1], high[1]);
  extent(z, low[2], high[2]);
}

void SphereWalk::Chosen::keep_reaching(const Vector3& low, const Vector3& high)
{
  std::size_t kept = 0;
  for (std::size_t k = 0; k < index.size(); ++k) {
    const double xk = x[k], yk = y[k], zk = z[k], rk = r[k];
    const bool reaches = (xk + rk >= low[0]) & (xk - rk <= high[0]) & (yk + rk >= low[1]) &
                         (yk - rk <= high[1]) & (zk + rk >= low[2]) & (zk - rk <= high[2]);
    index[kept] = index[k];
    x[kept] = xk, y[kept] = yk, z[kept] = zk, r[kept] = rk;
    kept += reaches;
  }
  resize(kept);
}
} // namespace interlock::dem
