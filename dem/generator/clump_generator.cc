#include "dem/generator/clump_generator.h"

#include "dem/generator/bulge.h"
#include "dem/generator/clump_surface.h"
#include "dem/generator/gain_order.h"
#include "dem/generator/largest_ball.h"
#include "dem/generator/random_order.h"
#include "dem/input_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace interlock::dem
{
void check_parameters(const ClumpParameters& parameters)
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
  require(is_length(parameters.bulge), "bulge", parameters.bulge, "a length of 0 m or more");
  require(parameters.p_max > 0 && parameters.p_max <= 100, "p_max", parameters.p_max,
          "above 0 % and at most 100 %");
  require(parameters.max_spheres >= 0, "max_spheres", parameters.max_spheres,
          "0 (no limit) or more");
  const auto is_share = [](double x) { return x >= 0 && x < 1; };
  require(is_share(parameters.target_volume_error), "target_volume_error",
          parameters.target_volume_error, "0 (no target) or a share below 1");
  require(is_share(parameters.target_inertia_error), "target_inertia_error",
          parameters.target_inertia_error, "0 (no target) or a share below 1");
  if (parameters.target_inertia_error > 0 && parameters.mass_scheme == MassScheme::mesh)
    throw InputError("A target for the error of the inertia needs the mass properties 'uniform' or "
                     "'equal-mass': those of 'mesh' have no error.");
}

namespace
{
ClumpShape in_body_frame(const std::vector<Sphere>& spheres, const MassProperties& mass,
                         const PrincipalFrame& frame)
{
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

ClumpShape make_clump(const ClumpSurface& surface, const ClumpParameters& parameters,
                      ClumpReport* report)
{
  ClumpReport counts;
  counts.nodes = static_cast<int>(surface.nodes.size());
  const bool by_gain = parameters.sphere_order == SphereOrder::gain;
  std::vector<Sphere> spheres = by_gain ? spheres_in_gain_order(surface, parameters, counts)
                                        : spheres_in_random_order(surface, parameters, counts);
  if (spheres.empty()) {
    std::ostringstream text;
    text << "No sphere is left in the clump: all " << counts.rejected
         << " balls that were grown are smaller than r_min = " << parameters.r_min
         << " m; choose a smaller r_min.";
    throw InputError(text.str());
  }
  counts.bulge = bulge_for_volume(spheres, surface.mass.volume, parameters.bulge);
  spheres = bulged(std::move(spheres), counts.bulge);
  const MassProperties mass = clump_mass_properties(surface.mass, spheres, parameters.mass_scheme);
  const PrincipalFrame frame = principal_frame(mass);
  if (report) {
    *report = counts;
    report->origin = mass.centre;
    report->rotation = Quaternion(frame.axes);
    measure_errors(surface.nodes, surface.mass, spheres, *report);
  }
  return in_body_frame(spheres, mass, frame);
}

// The ball that touches the node p itself, among `nodes`.
std::function<Sphere(int, const Vector3&)> ball_among_nodes(const std::vector<Vector3>& nodes)
{
  return
      [&nodes, balls = std::make_shared<BallAmongNodes>(nodes)](int node, const Vector3& inward) {
        const double radius = balls->radius(node, inward);
        return Sphere{nodes[node] + radius * inward, radius};
      };
}
} // namespace

ClumpShape make_clump(const TriangleMesh& stone, const ClumpParameters& parameters,
                      ClumpReport* report)
{
  check_parameters(parameters);
  ClumpSurface surface{stone.vertices,
                       node_normals(stone),
                       {},
                       [&] { return node_areas(stone); },
                       mass_properties(stone)};
  if (parameters.touching_radius == TouchingRadius::nodes)
    surface.ball = ball_among_nodes(stone.vertices);
  else
    surface.ball = [balls = std::make_shared<BallInsideSurface>(stone)](
                       int node, const Vector3& inward) { return balls->at(node, inward); };
  return make_clump(surface, parameters, report);
}

ClumpShape make_clump(const PointCloud& stone, const MassProperties& body,
                      const ClumpParameters& parameters, ClumpReport* report)
{
  check_parameters(parameters);
  if (parameters.touching_radius != TouchingRadius::nodes)
    throw InputError("A cloud of points has no facets: its touching radius must be 'nodes'.");
  const auto even_areas = [&] { return std::vector<double>(stone.points.size(), 1.); };
  return make_clump(
      ClumpSurface{stone.points, stone.normals, ball_among_nodes(stone.points), even_areas, body},
      parameters, report);
}

MassScheme mass_scheme(const std::string& name)
{
  if (name == "uniform") return MassScheme::uniform;
  if (name == "equal-mass") return MassScheme::equal_mass;
  if (name == "mesh") return MassScheme::mesh;
  throw InputError("The mass properties of clumps are '" + name +
                   "', but must be one of 'uniform', 'equal-mass' and 'mesh'.");
}

TouchingRadius touching_radius(const std::string& name)
{
  if (name == "surface") return TouchingRadius::surface;
  if (name == "nodes") return TouchingRadius::nodes;
  throw InputError("The touching radius is '" + name + "', but must be 'surface' or 'nodes'.");
}

SphereOrder sphere_order(const std::string& name)
{
  if (name == "random") return SphereOrder::random;
  if (name == "gain") return SphereOrder::gain;
  throw InputError("The order of the spheres is '" + name + "', but must be 'random' or 'gain'.");
}
} // namespace interlock::dem
