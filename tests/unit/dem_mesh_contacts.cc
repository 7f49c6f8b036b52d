// Contacts of spheres with walls of triangles: number, place and normal in corners, grooves, on
// edges and vertices; surfaces as files bring them; lists against all triangles one by one. Fails
// when a contact is counted twice or missed, depends on how the surface is cut, or goes through a
// list that has expired.
#include "tests/dem_wall_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wall_bench;

namespace
{
constexpr double r = 0.01, k = 1e6;

std::vector<MeshContact> contacts_at(const TriangleMesh& mesh, const Vector3& centre)
{
  Stage stage({ball(r)}, springs(k), 0);
  stage.add_mesh(mesh, springs(k));
  stage.add(0, centre, Vector3::Zero());
  stage.forces(1e-6);
  return stage.contacts.contacts();
}

void expect_contact(const MeshContact& contact, const Vector3& nearest, const Vector3& centre)
{
  const double distance = (centre - nearest).norm();
  EXPECT_LT((contact.normal - (centre - nearest) / distance).norm(), 1e-12);
  EXPECT_NEAR(contact.depth, r - distance, 1e-15);
  EXPECT_LT((contact.force - k * (r - distance) * contact.normal).norm(), 1e-9);
}

// Two planes along y that meet in the line x = z = 0; both rise (angle > 0) or fall beside it.
TriangleMesh roof(double angle, int cells)
{
  const Vector3 start(0, -0.05, 0), along(0, 0.1, 0);
  TriangleMesh mesh =
      rectangle(start, along, 0.1 * Vector3(std::cos(angle), 0, std::sin(angle)), cells, cells);
  append(mesh, rectangle(start, along, 0.1 * Vector3(-std::cos(angle), 0, std::sin(angle)), cells,
                         cells));
  return mesh;
}

TriangleMesh floor_of(int cells)
{
  return rectangle({-0.1, -0.1, 0}, {0.2, 0, 0}, {0, 0.2, 0}, cells, cells);
}
} // namespace

TEST(MeshContacts, CornerOfABoxHasThree)
{
  const Vector3 x(0.2, 0, 0), y(0, 0.2, 0), z(0, 0, 0.2);
  for (const int cells : {1, 3, 8}) {
    TriangleMesh box = rectangle(Vector3::Zero(), x, y, cells, cells);
    append(box, rectangle(Vector3::Zero(), y, z, cells, cells));
    append(box, rectangle(Vector3::Zero(), z, x, cells, cells));
    const Vector3 centre(0.99 * r, 0.98 * r, 0.97 * r);
    const auto contacts = contacts_at(box, centre);
    ASSERT_EQ(contacts.size(), 3u);
    expect_contact(contacts[0], {centre.x(), centre.y(), 0}, centre); // the deepest first
    expect_contact(contacts[1], {centre.x(), 0, centre.z()}, centre);
    expect_contact(contacts[2], {0, centre.y(), centre.z()}, centre);
  }
}

TEST(MeshContacts, GrooveHasTwoAndRidgeOne)
{
  for (const double angle : {M_PI / 12, M_PI / 6, M_PI / 4, 1.4})
    for (const int cells : {1, 4, 9}) {
      const Vector3 in_groove(0, 0.003, 0.99 * r / std::cos(angle));
      const auto groove = contacts_at(roof(angle, cells), in_groove);
      ASSERT_EQ(groove.size(), 2u) << angle;
      for (const MeshContact& c : groove) {
        EXPECT_NEAR(c.depth, 0.01 * r, 1e-15);
        EXPECT_NEAR(std::abs(c.normal.x()), std::sin(angle), 1e-12);
        EXPECT_NEAR(c.normal.z(), std::cos(angle), 1e-12);
      }
      const Vector3 on_ridge(0.2 * r * std::sin(angle), 0.003, 0.97 * r);
      const auto ridge = contacts_at(roof(-angle, cells), on_ridge);
      ASSERT_EQ(ridge.size(), 1u) << angle;
      expect_contact(ridge[0], {0, 0.003, 0}, on_ridge);
    }
}

TEST(MeshContacts, VertexOfAPyramidHasOne)
{
  TriangleMesh pyramid;
  pyramid.vertices = {{0, 0, 0}};
  const int sides = 7;
  for (int s = 0; s < sides; ++s) {
    const double a = 2 * M_PI * s / sides;
    pyramid.vertices.push_back({0.03 * std::cos(a), 0.03 * std::sin(a), -0.02});
    pyramid.triangles.push_back({0, 1 + s, 1 + (s + 1) % sides});
  }
  const Vector3 centre(0.001, -0.002, 0.009);
  const auto contacts = contacts_at(pyramid, centre);
  ASSERT_EQ(contacts.size(), 1u);
  expect_contact(contacts[0], Vector3::Zero(), centre);
}

TEST(MeshContacts, BothSidesOfAPlateAreSolid)
{
  for (const double side : {1., -1.}) {
    const Vector3 centre(0.004, 0.004, side * 0.98 * r);
    const auto contacts = contacts_at(floor_of(3), centre);
    ASSERT_EQ(contacts.size(), 1u);
    expect_contact(contacts[0], {0.004, 0.004, 0}, centre);
  }
}

// A finely cut cylinder is one smooth surface, from inside as from outside: one contact anywhere.
TEST(MeshContacts, CurvedSurfaceHasOne)
{
  TriangleMesh drum;
  const int facets = 36;
  for (int f = 0; f < facets; ++f) {
    const auto at = [&](int n) {
      const double a = 2 * M_PI * n / facets;
      return Vector3(0.05 * std::cos(a), -0.05, 0.05 * std::sin(a));
    };
    append(drum, rectangle(at(f), {0, 0.1, 0}, at(f + 1) - at(f), 3, 2));
  }
  for (int n = 0; n < 400; ++n) {
    const double a = 0.0173 * n;
    const Vector3 direction(std::cos(a), 0, std::sin(a));
    EXPECT_EQ(contacts_at(drum, (0.05 - 0.98 * r) * direction).size(), 1u) << a;
    EXPECT_EQ(contacts_at(drum, (0.05 + 0.98 * r) * direction).size(), 1u) << a;
  }
}

TEST(MeshContacts, CopiesSliversAndHangingVerticesChangeNothing)
{
  // One large triangle beside smaller ones whose vertices hang on its edge x = 0.
  TriangleMesh mesh = rectangle({-0.1, -0.1, 0}, {0.1, 0, 0}, {0, 0.2, 0}, 1, 1);
  append(mesh, rectangle({0, -0.1, 0}, {0.1, 0, 0}, {0, 0.2, 0}, 3, 7));
  const TriangleMesh clean = mesh;
  append(mesh, clean);
  TriangleMesh turned = clean;
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  append(mesh, turned);
  const int n = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back({0.01, 0.01, 0});
  mesh.vertices.push_back({0.02, 0.02, 0});
  mesh.vertices.push_back({0.03, 0.03, 0});
  mesh.triangles.push_back({n, n + 1, n + 2}); // three corners on a line
  mesh.triangles.push_back({n, n, n + 1});

  const MeshSurface surface(mesh);
  EXPECT_EQ(surface.size(), static_cast<int>(clean.triangles.size()));
  EXPECT_EQ(surface.duplicates_dropped(), 2 * surface.size());
  EXPECT_EQ(surface.degenerate_dropped(), 2);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.02, 0.02);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3 centre(trial % 3 ? place(random) : 0, place(random), 0.95 * r);
    const auto contacts = contacts_at(mesh, centre);
    ASSERT_EQ(contacts.size(), 1u) << centre.transpose();
    expect_contact(contacts[0], {centre.x(), centre.y(), 0}, centre);
  }
}

// Vertices as single precision rounds them: facets of one plane are not quite in one plane.
TEST(MeshContacts, RoundedVerticesChangeNothing)
{
  TriangleMesh mesh = floor_of(23);
  const Matrix3 turn = Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3 shift(1.234, 0.7, -0.3);
  for (Vector3& v : mesh.vertices) v = (turn * v + shift).cast<float>().cast<double>();
  std::mt19937 random(1);
  std::uniform_int_distribution<int> cell(-9, 9);
  for (int trial = 0; trial < 200; ++trial) {
    // On or within a float's rounding of an edge or a vertex.
    const Vector3 foot(0.2 / 23 * (cell(random) + 0.5) + 1e-8 * cell(random),
                       0.2 / 23 * (cell(random) + (trial % 2) * 0.31), 0);
    const auto contacts = contacts_at(mesh, turn * (foot + Vector3(0, 0, 0.99 * r)) + shift);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].depth, 0.01 * r, 3e-7);
  }
}

// Three facets at one edge: a fin on a plate. Beside the fin two contacts, above its top one.
TEST(MeshContacts, EdgesWithThreeFacets)
{
  TriangleMesh mesh = floor_of(2); // has an edge along x = 0
  append(mesh, rectangle({0, -0.1, 0}, {0, 0.2, 0}, {0, 0, 0.03}, 2, 1));
  EXPECT_EQ(contacts_at(mesh, {0.99 * r, 0.01, 0.98 * r}).size(), 2u);
  EXPECT_EQ(contacts_at(mesh, {-0.99 * r, 0.01, 0.98 * r}).size(), 2u);
  const Vector3 above(0.001, 0.01, 0.03 + 0.99 * r);
  const auto top = contacts_at(mesh, above);
  ASSERT_EQ(top.size(), 1u);
  expect_contact(top[0], {0, 0.01, 0.03}, above);
}

TEST(MeshContacts, SpringGoesOverAnEdge)
{
  // Pushed along x over the ridge of two planes that fall by 5 degrees, with stiff friction: the
  // spring must only grow.
  const double angle = -5 * M_PI / 180;
  ContactProperties pair = springs(k, 100);
  Stage stage({ball(r)}, pair, 0);
  stage.add_mesh(roof(angle, 3), pair);
  const Vector3 normal(std::sin(-angle), 0, std::cos(angle));
  stage.add(0, -1e-4 * Vector3(1, 0, 0) + 0.99 * r * Vector3(-normal.x(), 0, normal.z()),
            Vector3(0.1, 0, 0));
  double last = 0;
  const double dt = 1e-5;
  for (int n = 0; n < 2000; ++n) {
    stage.engine.clumps().position[0].x() += 0.1 * dt;
    // Keeps its depth: stays at a distance of 0.99 r from the surface.
    const double x = stage.engine.clumps().position[0].x(), s = 0.99 * r * normal.x();
    stage.engine.clumps().position[0].z() =
        std::abs(x) < s ? std::sqrt(0.99 * 0.99 * r * r - x * x)
                        : 0.99 * r * normal.z() - (std::abs(x) - s) * std::tan(-angle);
    stage.forces(dt);
    ASSERT_EQ(stage.contacts.contacts().size(), 1u) << n;
    const double spring = stage.contacts.contacts()[0].history.spring.norm();
    ASSERT_GT(spring, last) << n;
    ASSERT_LT(spring - last, 0.12 * dt) << n;
    last = spring;
  }
}

// A ball held on a turning plate: the spring turns with both.
TEST(MeshContacts, SpringTurnsWithATurningWall)
{
  const ContactProperties pair = springs(k, 10);
  Stage stage({ball(r)}, pair, 0);
  stage.add_mesh(floor_of(4), pair);
  Clumps& c = stage.engine.clumps();
  stage.add(0, {0.05, 0, 0.99 * r}, {0.1, 0, 0});
  stage.forces(1e-5); // 1 um along x
  const Vector3 spin(0, 0, 20);
  const double dt = 2e-5;
  const int quarter = static_cast<int>(0.5 * M_PI / 20 / dt);
  stage.meshes[0].spin = spin;
  c.step_spin[0] = spin;
  for (int n = 1; n <= quarter; ++n) {
    stage.meshes[0].move(dt);
    const double angle = 20 * dt * (n - 0.5); // velocity in the middle of the step
    c.step_velocity[0] = spin.cross(0.05 * Vector3(std::cos(angle), std::sin(angle), 0));
    c.position[0] = Vector3(0.05 * std::cos(20 * dt * n), 0.05 * std::sin(20 * dt * n), 0.99 * r);
    stage.forces(dt);
  }
  ASSERT_EQ(stage.contacts.contacts().size(), 1u);
  const double angle = 20 * dt * quarter;
  EXPECT_LT((stage.contacts.contacts()[0].history.spring -
             1e-6 * Vector3(std::cos(angle), std::sin(angle), 0))
                .norm(),
            2e-8);
}

namespace
{
// All contacts of one sphere by their definition, from every triangle of the surface.
std::vector<double> depths_by_brute_force(const MeshWall& wall, const Vector3& x, double radius)
{
  const MeshSurface& s = *wall.surface;
  const Vector3 centre = wall.orientation.conjugate() * (x - wall.centre);
  std::vector<std::pair<double, Vector3>> minima; // distance, point
  for (int t = 0; t < s.size(); ++t) {
    const auto foot = s.nearest(t, centre);
    if (foot.distance >= radius) continue;
    bool is_minimum = true;
    for (int u = 0; u < s.size() && is_minimum; ++u)
      is_minimum = s.nearest(u, foot.point).distance > s.tolerance() ||
                   s.nearest(u, centre).distance >= foot.distance * (1 - 1e-9);
    if (is_minimum) minima.emplace_back(foot.distance, foot.point);
  }
  std::sort(minima.begin(), minima.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::pair<double, Vector3>> kept;
  for (const auto& m : minima) {
    const auto same = [&](const auto& other) {
      return (centre - m.second).normalized().dot((centre - other.second).normalized()) >
             same_contact_cosine;
    };
    if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(m);
  }
  std::vector<double> depths;
  for (const auto& m : kept) depths.push_back(radius - m.first);
  return depths;
}
} // namespace

// Clumps thrown about in a jagged, turning, moving box.
TEST(MeshContacts, ListsMissNothing)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto direction = [&] { return Vector3(unit(random), unit(random), unit(random)); };
  ClumpShape dumbbell;
  dumbbell.spheres = {{{0.008, 0, 0}, 0.006}, {{-0.008, 0, 0}, 0.005}, {{0, 0.004, 0}, 0.007}};
  dumbbell.volume = 2e-6;
  dumbbell.unit_inertia = {6e-11, 1.2e-10, 1.4e-10};
  const ContactProperties pair = springs(1e5, 0.4, 0.05);
  Stage stage({dumbbell, ball(r)}, pair, 9.81);

  TriangleMesh box;
  const double h = 0.05;
  const Vector3 corner(-h, -h, -h), e[3] = {{2 * h, 0, 0}, {0, 2 * h, 0}, {0, 0, 2 * h}};
  for (int f = 0; f < 3; ++f)
    for (const double side : {0., 1.})
      append(box, rectangle(corner + side * e[f], e[(f + 1) % 3], e[(f + 2) % 3], 3, 2));
  for (Vector3& v : box.vertices) // dents, the same for all copies of a vertex
    v *= 1 + 0.15 * std::sin(300 * v.x() + 170 * v.y() + 230 * v.z());
  stage.add_mesh(box, pair);
  stage.add_mesh(rectangle({-0.02, -0.02, -0.01}, {0.04, 0, 0}, {0, 0.04, 0.01}, 2, 2), pair);
  stage.meshes[0].spin = {0.5, 2, -1};
  stage.meshes[1].velocity = {0.05, 0, 0.02};
  for (int n = 0; n < 12; ++n)
    stage.add(n % 2, 0.02 * direction(), 2 * direction(), 200 * direction());

  int seen = 0, most = 0;
  for (int n = 0; n < 4000; ++n) {
    stage.forces(1e-5);
    if (n % 10 == 0) {
      std::size_t next = 0;
      const auto& contacts = stage.contacts.contacts();
      const Clumps& clumps = stage.engine.clumps();
      for (int i = 0; i < clumps.size(); ++i)
        for (int w = 0; w < 2; ++w)
          for (int a = 0; a < static_cast<int>(clumps.shape_of(i).spheres.size()); ++a) {
            const auto depths = depths_by_brute_force(
                stage.meshes[w], clumps.position[i] + clumps.member_offset(i, a),
                clumps.shape_of(i).spheres[a].radius);
            most = std::max(most, static_cast<int>(depths.size()));
            for (const double depth : depths) {
              ASSERT_LT(next, contacts.size());
              const MeshContact& c = contacts[next++];
              ASSERT_EQ(std::make_tuple(c.i, c.wall, c.a), std::make_tuple(i, w, a));
              ASSERT_NEAR(c.depth, depth, 1e-12);
              ++seen;
            }
          }
      ASSERT_EQ(next, contacts.size());
    }
    stage.move(1e-5);
  }
  EXPECT_GT(seen, 200);
  EXPECT_GE(most, 2);
}

// Dropping clumps and walls keeps the springs of the others.
TEST(MeshContacts, RenumberingKeepsHistory)
{
  const ContactProperties pair = springs(k, 0.5);
  Stage stage({ball(r)}, pair, 0);
  stage.add_mesh(floor_of(2), pair);
  stage.add_mesh(rectangle({-0.1, -0.1, 0.05}, {0.2, 0, 0}, {0, 0.2, 0}), pair);
  stage.add(0, {0.01, 0, 0.05 - 0.99 * r}, {0.1, 0, 0});
  stage.add(0, {-0.04, 0, 0.99 * r}, {0.1, 0, 0});
  stage.forces(1e-5);
  ASSERT_EQ(stage.contacts.contacts().size(), 2u);
  const Vector3 spring = stage.contacts.contacts()[1].history.spring;
  ASSERT_GT(spring.norm(), 0);
  stage.contacts.renumber_clumps(stage.engine.remove_clumps({true, false}));
  stage.contacts.forget_walls(1);
  stage.meshes.pop_back();
  ASSERT_EQ(stage.contacts.contacts().size(), 1u);
  EXPECT_EQ(stage.contacts.contacts()[0].i, 0);
  stage.engine.clumps().step_velocity[0].setZero();
  stage.forces(1e-5);
  ASSERT_EQ(stage.contacts.contacts().size(), 1u);
  EXPECT_EQ(stage.contacts.contacts()[0].history.spring, spring);
}
