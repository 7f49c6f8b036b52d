// The rules of the clump generator and the mass schemes. Fails when a sphere leaves the solid by
// more than the node spacing allows, when d_min, r_min, p_max or the seed do not do what they say,
// when the body frame is not that of the scheme, or when the report compares the wrong things.
#include "dem/generator/clump_generator.h"
#include "dem/input_error.h"
#include "dem/stones/synthetic_stone.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

ClumpParameters parameters(double d_min, double r_min, double p_max)
{
  ClumpParameters p;
  p.d_min = d_min;
  p.r_min = r_min;
  p.p_max = p_max;
  return p;
}

// Sides that differ, along x, y, z in ascending order of moment, so that the body frame is the
// input's.
const Vector3 sides(0.06, 0.05, 0.04);
constexpr double spacing = 0.002;

TriangleMesh lattice_box()
{
  TriangleMesh mesh = solids::box(1, 1, 1);
  mesh = solids::subdivide(mesh, 20);
  for (Vector3& x : mesh.vertices) x = x.cwiseProduct(sides);
  return mesh;
}

TEST(ClumpGenerator, SpheresTouchAFaceAndStayInTheBox)
{
  const double r_min = 3 * spacing;
  const ClumpShape clump = make_clump(lattice_box(), parameters(0.0001, r_min, 100));
  ASSERT_GT(clump.spheres.size(), 100u);
  for (const Sphere& s : clump.spheres) {
    EXPECT_GE(s.radius, r_min);
    // Gaps between the sphere and the three nearest faces: one closed, none negative.
    const Vector3 gaps = (sides / 2 - s.centre.cwiseAbs()).array() - s.radius;
    EXPECT_NEAR(gaps.minCoeff(), 0, 1e-12);
  }
}

TEST(ClumpGenerator, MeshSchemeHasTheMassPropertiesOfTheBox)
{
  const ClumpShape clump = make_clump(lattice_box(), parameters(0.001, 0.002, 100));
  const double volume = sides.prod();
  const Vector3 squares = sides.cwiseAbs2();
  EXPECT_NEAR(clump.volume, volume, 1e-12 * volume);
  for (int k = 0; k < 3; ++k) {
    const double exact = volume / 12 * (squares.sum() - squares[k]);
    EXPECT_NEAR(clump.unit_inertia[k], exact, 1e-12 * exact);
  }
}

TEST(ClumpGenerator, SpheresSchemesPutTheOriginAtTheirOwnCentre)
{
  const TriangleMesh stone = make_stones(1, 3)[0];
  for (const auto scheme : {MassScheme::uniform, MassScheme::equal_mass}) {
    ClumpParameters p = parameters(0.001, 0.001, 100);
    p.mass_scheme = scheme;
    const ClumpShape clump = make_clump(stone, p);
    std::vector<double> volumes;
    double total = 0;
    for (const Sphere& s : clump.spheres)
      volumes.push_back(scheme == MassScheme::uniform ? std::pow(s.radius, 3) : 1);
    for (const double v : volumes) total += v;
    for (double& v : volumes) v *= clump.volume / total;
    const MassProperties mass = mass_properties(clump.spheres, volumes);
    const double scale = clump.unit_inertia.norm();
    EXPECT_LT(mass.centre.norm(), 1e-15);
    EXPECT_NEAR(clump.volume, mass_properties(stone).volume, 1e-15 * clump.volume);
    EXPECT_LT((mass.inertia - Matrix3(clump.unit_inertia.asDiagonal())).norm(), 1e-12 * scale);
    EXPECT_LE(clump.unit_inertia[0], clump.unit_inertia[1]);
    EXPECT_LE(clump.unit_inertia[1], clump.unit_inertia[2]);
  }
}

TEST(ClumpGenerator, DoesNotDependOnTheFrameOfTheScan)
{
  const TriangleMesh stone = make_stones(1, 5)[0];
  const Matrix3 turn = Eigen::AngleAxisd(1.1, Vector3(2, 1, -1).normalized()).toRotationMatrix();
  const ClumpParameters p = parameters(0.001, 0.001, 5);
  const ClumpShape a = make_clump(stone, p);
  const ClumpShape b = make_clump(solids::moved(stone, turn, Vector3(0.3, -0.2, 0.1)), p);
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  EXPECT_LT((a.unit_inertia - b.unit_inertia).norm(), 1e-10 * a.unit_inertia.norm());
  EXPECT_NEAR(a.bounding_radius(), b.bounding_radius(), 1e-12);
  for (std::size_t i = 0; i < a.spheres.size(); ++i) {
    EXPECT_NEAR(a.spheres[i].radius, b.spheres[i].radius, 1e-12);
    // The axes may point either way.
    EXPECT_LT((a.spheres[i].centre.cwiseAbs() - b.spheres[i].centre.cwiseAbs()).norm(), 1e-11);
  }
}

bool contains(const ClumpShape& large, const Sphere& s)
{
  return std::any_of(large.spheres.begin(), large.spheres.end(), [&](const Sphere& other) {
    return other.centre == s.centre && other.radius == s.radius;
  });
}

TEST(ClumpGenerator, MoreNodesKeepTheSpheresOfFewer)
{
  const TriangleMesh stone = make_stones(1, 11)[0];
  ClumpShape fewer = make_clump(stone, parameters(0.0005, 0.001, 1));
  for (const double p_max : {2., 5., 10., 100.}) {
    ClumpReport report;
    const ClumpShape more = make_clump(stone, parameters(0.0005, 0.001, p_max), &report);
    EXPECT_GT(more.spheres.size(), fewer.spheres.size());
    for (const Sphere& s : fewer.spheres) EXPECT_TRUE(contains(more, s));
    EXPECT_LT(report.nodes_used, p_max / 100 * report.nodes + 1);
    EXPECT_EQ(report.nodes_used, report.rejected + int(more.spheres.size()));
    fewer = more;
  }
}

TEST(ClumpGenerator, CountFallsWithDistanceAndRadius)
{
  const TriangleMesh stone = make_stones(1, 11)[0];
  std::size_t last = stone.vertices.size() + 1;
  for (const double d_min : {0., 0.0002, 0.0005, 0.001, 0.003}) {
    const ClumpShape clump = make_clump(stone, parameters(d_min, 0.001, 100));
    EXPECT_LT(clump.spheres.size(), last) << d_min;
    last = clump.spheres.size();
  }
  last = stone.vertices.size() + 1;
  for (const double r_min : {0.0005, 0.002, 0.004, 0.007}) {
    const ClumpShape clump = make_clump(stone, parameters(0.0005, r_min, 100));
    EXPECT_LT(clump.spheres.size(), last) << r_min;
    EXPECT_GE(clump.spheres.back().radius, r_min);
    last = clump.spheres.size();
  }
}

// With all nodes used, a node is nearer than d_min to a sphere or has been refused for r_min = 0:
// none.
TEST(ClumpGenerator, DistanceBoundsTheErrorOfTheSurface)
{
  const TriangleMesh stone = make_stones(1, 2)[0];
  ClumpReport report;
  make_clump(stone, parameters(0.0005, 0, 100), &report);
  EXPECT_LE(report.surface_distance_max, 0.0005 + 1e-12);
  EXPECT_LE(report.surface_distance_mean, report.surface_distance_95);
  EXPECT_LE(report.surface_distance_95, report.surface_distance_max);
}

TEST(ClumpGenerator, SameSeedSameDigits)
{
  const TriangleMesh stone = make_stones(1, 4)[0];
  ClumpParameters p = parameters(0.001, 0.001, 3);
  const ClumpShape a = make_clump(stone, p), b = make_clump(stone, p);
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  for (const Sphere& s : a.spheres) EXPECT_TRUE(contains(b, s));
  p.seed = 2;
  EXPECT_FALSE(contains(make_clump(stone, p), a.spheres[1]));
}

// The parameters of the pull-out cases: some 40 spheres on every stone of the batch.
TEST(ClumpGenerator, BatchOfThePullOutCases)
{
  const auto stones = make_stones(41, 1);
  double mean = 0, equal_mass_error = 0, uniform_error = 0;
  for (const TriangleMesh& stone : stones) {
    ClumpReport report;
    const ClumpShape clump = make_clump(stone, parameters(0.001, 0.001, 2), &report);
    EXPECT_GE(clump.spheres.size(), 20u);
    EXPECT_LE(clump.spheres.size(), 60u);
    mean += clump.spheres.size() / 41.;
    uniform_error += report.inertia_error[0] / 41;
    equal_mass_error += report.inertia_error[1] / 41;
    EXPECT_LT(report.inertia_error[2], 1e-12);
    EXPECT_LT(report.centre_offset[2], 1e-12);
    // The union lies inside the stone but for bulges between nodes.
    EXPECT_LT(report.volume_error, 0);
  }
  EXPECT_NEAR(mean, 40, 5);
  // The correction of the paper: equal masses come much nearer than equal densities (Fig. 6).
  EXPECT_LT(equal_mass_error, uniform_error / 2);
}

TEST(ClumpGenerator, StopsAtTheFirstSphereThatMeetsATarget)
{
  const TriangleMesh stone = make_stones(1, 2)[0];
  const MassProperties exact = mass_properties(stone);
  ClumpReport report;
  ClumpParameters p = parameters(0.0001, 0.0005, 100);
  p.max_spheres = 30;
  EXPECT_EQ(make_clump(stone, p, &report).spheres.size(), 30u);
  EXPECT_EQ(report.stop, Stop::max_spheres);

  p.max_spheres = 0;
  p.target_volume_error = 0.05;
  const int by_volume = make_clump(stone, p, &report).spheres.size();
  EXPECT_EQ(report.stop, Stop::volume_error);
  EXPECT_LE(std::abs(report.volume_error), 0.05 + report.volume_uncertainty);
  p.target_volume_error = 0;
  p.max_spheres = by_volume - 1;
  make_clump(stone, p, &report);
  EXPECT_GT(std::abs(report.volume_error), 0.05 - report.volume_uncertainty);

  p.max_spheres = 0;
  p.target_inertia_error = 0.2;
  p.mass_scheme = MassScheme::equal_mass;
  const ClumpShape by_inertia = make_clump(stone, p, &report);
  EXPECT_EQ(report.stop, Stop::inertia_error);
  const Vector3 moments = principal_frame(exact).moments;
  EXPECT_LE((by_inertia.unit_inertia - moments).cwiseQuotient(moments).cwiseAbs().mean(), 0.2);
}

TEST(ClumpGenerator, SaysWhyItStopped)
{
  const TriangleMesh stone = make_stones(1, 2)[0];
  ClumpReport report;
  make_clump(stone, parameters(0.001, 0.001, 2), &report);
  EXPECT_EQ(report.stop, Stop::p_max);
  make_clump(stone, parameters(0.001, 0.001, 100), &report);
  EXPECT_EQ(report.stop, Stop::all_nodes);
}

// The axes of a box of three different sides are known; two equal sides leave them open.
TEST(ClumpGenerator, ReportsTheAxes)
{
  ClumpReport report;
  make_clump(lattice_box(), parameters(0.0005, 0.004, 100), &report);
  EXPECT_TRUE(report.axes_are_distinct);
  EXPECT_LT(report.axis_error[0], 5);
  EXPECT_LT(report.axis_error[2], 1e-6);
  make_clump(solids::subdivide(solids::box(0.04, 0.04, 0.06), 10), parameters(0.0005, 0.004, 100),
             &report);
  EXPECT_FALSE(report.axes_are_distinct);
}

// Origin and rotation of the report lay the clump over the scan that it was made from.
TEST(ClumpGenerator, ReportsTheBodyFrame)
{
  const Matrix3 turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
  const TriangleMesh scan = solids::moved(lattice_box(), turn, Vector3(0.1, -0.2, 0.3));
  ClumpParameters p = parameters(0.0005, 0.004, 100);
  p.touching_radius = TouchingRadius::nodes;
  ClumpReport report;
  const ClumpShape shape = make_clump(scan, p, &report);
  const MassProperties exact = mass_properties(scan);
  EXPECT_LT((report.origin - exact.centre).norm(), 1e-12);
  const Matrix3 axes = report.rotation.toRotationMatrix();
  const Matrix3 inertia = axes * shape.unit_inertia.asDiagonal() * axes.transpose();
  EXPECT_LT((inertia - exact.inertia).norm(), 1e-9 * exact.inertia.norm());
  // Each ball touches a node of the scan, and has none inside.
  for (const Sphere& sphere : shape.spheres) {
    const Vector3 centre = report.origin + report.rotation * sphere.centre;
    double nearest = INFINITY;
    for (const Vector3& node : scan.vertices)
      nearest = std::min(nearest, (node - centre).norm() - sphere.radius);
    EXPECT_NEAR(nearest, 0, 1e-9);
  }
}

TEST(ClumpGenerator, BadParametersAreInputErrors)
{
  const TriangleMesh mesh = lattice_box();
  EXPECT_THROW(make_clump(mesh, parameters(-1e-4, 0.001, 10)), interlock::InputError);
  EXPECT_THROW(make_clump(mesh, parameters(1e-4, std::nan(""), 10)), interlock::InputError);
  EXPECT_THROW(make_clump(mesh, parameters(1e-4, 0.001, 0)), interlock::InputError);
  EXPECT_THROW(make_clump(mesh, parameters(1e-4, 0.001, 101)), interlock::InputError);
  EXPECT_THROW(make_clump(mesh, parameters(1e-4, 0.5, 10)), interlock::InputError);
  ClumpParameters p = parameters(1e-4, 0.001, 10);
  p.max_spheres = -1;
  EXPECT_THROW(make_clump(mesh, p), interlock::InputError);
  p.max_spheres = 0;
  p.target_volume_error = 1.5;
  EXPECT_THROW(make_clump(mesh, p), interlock::InputError);
  p.target_volume_error = 0;
  p.target_inertia_error = 0.1; // of `mesh`, which has no error
  EXPECT_THROW(make_clump(mesh, p), interlock::InputError);
  EXPECT_THROW(touching_radius("facets"), interlock::InputError);
  EXPECT_THROW(mass_scheme("equal mass"), interlock::InputError);
  EXPECT_EQ(mass_scheme("equal-mass"), MassScheme::equal_mass);
}

} // namespace
