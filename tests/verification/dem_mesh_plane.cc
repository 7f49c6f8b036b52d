// A plane of triangles is the plane: the trajectory on a mesh, coarse or fine, equals the one on a
// rectangle wall to rounding, at rest, rolling and sliding over many edges, and bouncing obliquely
// exactly on an edge, a vertex, a rim. Fails when an edge is counted twice or not at all, when the
// tangential spring is lost on the way from one triangle to the next, or when the force depends on
// the triangulation.
#include "tests/dem_wall_bench.h"

#include <gtest/gtest.h>

using namespace wall_bench;

namespace
{
constexpr double radius = 0.01, stiffness = 1e6, dt = 2e-6;

struct Start {
  Vector3 position, velocity, spin;
};

struct End {
  Vector3 position, velocity, spin;
  double friction, damping;
  int most_contacts = 0;
};

// The plane z = 0, 0.2 m square around the origin; cells = 0: the rectangle wall.
End run(const Start& start, int cells, int steps, double friction, double damping)
{
  const ContactProperties pair = springs(stiffness, friction, damping);
  Stage stage({ball(radius)}, pair, 9.81);
  const Vector3 corner(-0.1, -0.1, 0), e1(0.2, 0, 0), e2(0, 0.2, 0);
  if (cells == 0)
    stage.engine.add_wall(rectangle_wall(corner, e1, e2, pair));
  else
    stage.add_mesh(rectangle(corner, e1, e2, cells, cells), pair);
  stage.add(0, start.position, start.velocity, start.spin);
  End end;
  for (int n = 0; n < steps; ++n) {
    stage.step(dt);
    end.most_contacts =
        std::max(end.most_contacts, static_cast<int>(stage.contacts.contacts().size()));
  }
  const Clumps& c = stage.engine.clumps();
  const EngineEnergy e = stage.engine.energy(dt);
  end.position = c.position[0];
  end.velocity = c.velocity[0];
  end.spin = c.spin[0];
  end.friction = e.contact.friction;
  end.damping = e.contact.damping;
  return end;
}

void expect_same(const Start& start, int steps, double friction, double damping)
{
  const End plane = run(start, 0, steps, friction, damping);
  for (const int cells : {1, 2, 7, 40}) {
    const End mesh = run(start, cells, steps, friction, damping);
    EXPECT_EQ(mesh.most_contacts, 1) << cells;
    EXPECT_LT((mesh.position - plane.position).norm(), 1e-12 * radius) << cells;
    EXPECT_LT((mesh.velocity - plane.velocity).norm(), 1e-12 * (plane.velocity.norm() + 0.1))
        << cells;
    EXPECT_LT((mesh.spin - plane.spin).norm(), 1e-12 * (plane.spin.norm() + 0.1 / radius)) << cells;
    EXPECT_NEAR(mesh.friction, plane.friction, 1e-12 * plane.friction + 1e-18) << cells;
    EXPECT_NEAR(mesh.damping, plane.damping, 1e-12 * plane.damping + 1e-18) << cells;
  }
}
} // namespace

TEST(MeshPlane, RestOnEdgeVertexAndFace)
{
  for (const Vector3& at : {Vector3(0, 0, 0), Vector3(0.013, 0.013, 0), Vector3(0.0141, 0.003, 0)})
    expect_same({at + Vector3(0, 0, radius), Vector3::Zero(), Vector3::Zero()}, 5000, 0.5, 0.1);
}

// Thrown on with spin: slides, then rolls, over some twenty edges of the finest mesh.
TEST(MeshPlane, SlideAndRollOverManyEdges)
{
  expect_same({{-0.05, -0.03, radius}, {0.9, 0.37, 0}, {5, -20, 3}}, 40000, 0.4, 0.05);
}

// The spring of a rolling ball is what the closed form needs: sliding stops at 5/7 of the speed.
TEST(MeshPlane, SlidingTurnsIntoRollingAtFiveSeventhsOfTheSpeed)
{
  const End end =
      run({{-0.08, -0.031, radius}, {0.5, 0.1, 0}, Vector3::Zero()}, 40, 100000, 0.4, 0.1);
  EXPECT_NEAR(end.velocity.x(), 5. / 7 * 0.5, 2e-3);
  EXPECT_NEAR(end.velocity.y(), 5. / 7 * 0.1, 2e-3);
  EXPECT_NEAR(end.spin.y(), end.velocity.x() / radius, 5e-3 * end.spin.y());
}

TEST(MeshPlane, ObliqueBounceOnEdgeVertexAndRim)
{
  // Arrives at (0, 0), a vertex of even meshes and on a diagonal of odd ones, and beside an edge.
  const double t = 0.02, fall = 0.5 * 9.81 * t * t + t * 1.;
  for (const Vector3& at : {Vector3(0, 0, 0), Vector3(0.0125, 0.0125, 0), Vector3(0.02, 0.003, 0),
                            Vector3(0.1 + 0.4 * radius, 0.02, 0)})
    for (const double friction : {0., 0.3})
      expect_same({at + Vector3(-0.7 * t, 0.2 * t, radius + fall), {0.7, -0.2, -1}, {3, 7, -11}},
                  15000, friction, 0.1);
}
