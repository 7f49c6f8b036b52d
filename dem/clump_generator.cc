#include "dem/clump_generator.h"

#include "dem/input_error.h"
#include "dem/largest_ball.h"
#include "dem/random_stream.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace interlock::dem
{
namespace
{
void check(const ClumpParameters& parameters)
{
  const auto require = [](bool good, const char* name, double value, const char* range) {
    if (good) return;
    std::ostringstream text;
    text << "The clump parameter " << name << " is " << value << ", but must be " << range << ".";
    throw InputError(text.str());
  };
  const auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  require(is_length(parameters.d_min), "d_min", parameters.d_min, "a length of 0 m or more");
  require(is_length(parameters.r_min), "r_min", parameters.r_min, "a length of 0 m or more");
  require(parameters.p_max > 0 && parameters.p_max <= 100, "p_max", parameters.p_max,
          "above 0 % and at most 100 %");
}

// The spheres in the frame of the mesh. Counts nodes into `report`.
std::vector<Sphere> grow_spheres(const TriangleMesh& stone, const ClumpParameters& parameters,
                                 ClumpReport& report)
{
  const LargestBall balls(stone.vertices);
  const std::vector<Vector3> normals = node_normals(stone);
  const int nodes = static_cast<int>(stone.vertices.size());
  // A sphere touches the node on its far side to within round-off, which must not count as nearer
  // than d_min = 0.
  const double threshold = parameters.d_min - 1e-9 * extents(stone).maxCoeff();
  const double allowed = parameters.p_max / 100 * nodes;

  std::vector<Sphere> spheres;
  report.nodes = nodes;
  for (const int node : RandomStream(parameters.seed).permutation(nodes)) {
    if (report.nodes_used >= allowed) break;
    const Vector3& p = stone.vertices[node];
    if (std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& s) {
          return (p - s.centre).squaredNorm() < std::pow(std::max(0., s.radius + threshold), 2);
        }))
      continue;
    ++report.nodes_used;
    const double radius = balls.radius(node, -normals[node]);
    if (std::isfinite(radius) && radius >= parameters.r_min)
      spheres.push_back({p - radius * normals[node], radius});
    else
      ++report.rejected;
  }
  return spheres;
}

double mean_relative_error(const Vector3& value, const Vector3& reference)
{
  return (value - reference).cwiseQuotient(reference).cwiseAbs().mean();
}

void compare_schemes(const MassProperties& stone, const std::vector<Sphere>& spheres,
                     ClumpReport& report)
{
  const Vector3 exact = principal_frame(stone).moments;
  for (const auto scheme : {MassScheme::uniform, MassScheme::equal_mass, MassScheme::mesh}) {
    const MassProperties mass = clump_mass_properties(stone, spheres, scheme);
    const auto entry = static_cast<std::size_t>(scheme);
    report.inertia_error[entry] = mean_relative_error(principal_frame(mass).moments, exact);
    report.centre_offset[entry] = (mass.centre - stone.centre).norm();
  }
}

ClumpShape in_body_frame(const std::vector<Sphere>& spheres, const MassProperties& mass)
{
  const PrincipalFrame frame = principal_frame(mass);
  ClumpShape shape;
  shape.volume = mass.volume;
  shape.unit_inertia = frame.moments;
  for (const Sphere& s : spheres)
    shape.spheres.push_back({frame.axes.transpose() * (s.centre - mass.centre), s.radius});
  std::sort(shape.spheres.begin(), shape.spheres.end(), [](const Sphere& a, const Sphere& b) {
    const auto key = [](const Sphere& s) {
      return std::make_tuple(-s.radius, s.centre[0], s.centre[1], s.centre[2]);
    };
    return key(a) < key(b);
  });
  return shape;
}
} // namespace

MassProperties clump_mass_properties(const MassProperties& stone,
                                     const std::vector<Sphere>& spheres, MassScheme scheme)
{
  if (scheme == MassScheme::mesh) return stone;
  std::vector<double> volumes;
  double total = 0;
  for (const Sphere& s : spheres) {
    volumes.push_back(scheme == MassScheme::uniform ? std::pow(s.radius, 3) : 1);
    total += volumes.back();
  }
  for (double& volume : volumes) volume *= stone.volume / total;
  MassProperties mass = mass_properties(spheres, volumes);
  mass.volume = stone.volume; // to the last digit
  return mass;
}

ClumpShape make_clump(const TriangleMesh& stone, const ClumpParameters& parameters,
                      ClumpReport* report)
{
  check(parameters);
  ClumpReport counts;
  const std::vector<Sphere> spheres = grow_spheres(stone, parameters, counts);
  if (spheres.empty()) {
    std::ostringstream text;
    text << "No sphere is left in the clump: all " << counts.rejected
         << " balls that were grown are smaller than r_min = " << parameters.r_min
         << " m; choose a smaller r_min (the stone's shortest side is " << extents(stone).minCoeff()
         << " m).";
    throw InputError(text.str());
  }
  const MassProperties exact = mass_properties(stone);
  if (report) {
    *report = counts;
    compare_schemes(exact, spheres, *report);
    measure_surface(stone, spheres, *report);
  }
  return in_body_frame(spheres, clump_mass_properties(exact, spheres, parameters.mass_scheme));
}

MassScheme mass_scheme(const std::string& name)
{
  if (name == "uniform") return MassScheme::uniform;
  if (name == "equal-mass") return MassScheme::equal_mass;
  if (name == "mesh") return MassScheme::mesh;
  throw InputError("The mass properties of clumps are '" + name +
                   "', but must be one of 'uniform', 'equal-mass' and 'mesh'.");
}
} // namespace interlock::dem
