// Walls of triangles by themselves: nearest points, the search tree, motion, work and files. Fails
// when a nearest point is not nearest, the tree drops a triangle, or a file's unit, open rim or
// merged corners are lost.
#include "dem/walls/mesh_wall.h"
#include "tests/dem_wall_bench.h"
#include "tests/temporary_folder.h"

#include <random>

using namespace wall_bench;

namespace
{
class WallMeshFile : public TemporaryFolderTest
{
};

TriangleMesh soup(int triangles, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Vector3(unit(random), unit(random), unit(random)); };
  TriangleMesh mesh;
  for (int t = 0; t < triangles; ++t) {
    const Vector3 at = point();
    for (int c = 0; c < 3; ++c) mesh.vertices.push_back(at + 0.2 * point());
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}
} // namespace

// The nearest point of a convex set: no corner lies on the far side of the plane through it, and
// it is itself a mean of the corners with weights from 0 to 1.
TEST(MeshSurface, NearestPointIsNearest)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const MeshSurface surface(soup(200, random));
  int on_faces = 0, on_edges = 0;
  for (int t = 0; t < surface.size(); ++t)
    for (int n = 0; n < 50; ++n) {
      const auto& corners = surface.mesh().triangles[t];
      const Vector3& a = surface.mesh().vertices[corners[0]];
      const Vector3 x = a + 0.4 * Vector3(unit(random), unit(random), unit(random));
      const MeshSurface::Nearest nearest = surface.nearest(t, x);
      EXPECT_NEAR(nearest.distance, (x - nearest.point).norm(), 1e-15);
      Matrix3 basis;
      for (int c = 0; c < 3; ++c) {
        const Vector3& corner = surface.mesh().vertices[corners[c]];
        EXPECT_LT((corner - nearest.point).dot(x - nearest.point), 1e-13);
        basis.col(c) = corner;
      }
      Eigen::Matrix<double, 4, 3> rows;
      rows << basis, Eigen::RowVector3d::Ones();
      Eigen::Vector4d target;
      target << nearest.point, 1;
      const Vector3 weights = rows.colPivHouseholderQr().solve(target);
      EXPECT_LT((rows * weights - target).norm(), 1e-12);
      EXPECT_GT(weights.minCoeff(), -1e-9);
      ++(nearest.inside ? on_faces : on_edges);
    }
  EXPECT_GT(on_faces, 300);
  EXPECT_GT(on_edges, 500);
}

TEST(MeshSurface, TreeFindsAllTrianglesInReach)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.2, 1.2);
  const MeshSurface surface(soup(500, random));
  std::vector<int> found;
  for (int n = 0; n < 200; ++n) {
    const Vector3 x(unit(random), unit(random), unit(random));
    surface.triangles_within(x, 0.3, found);
    std::vector<int> all;
    for (int t = 0; t < surface.size(); ++t)
      if (surface.nearest(t, x).distance < 0.3) all.push_back(t);
    EXPECT_EQ(found, all);
  }
}

// A quarter turn about a shifted centre while it moves; work of a constant force and torque.
TEST(MeshWall, MovesTurnsAndWorks)
{
  const Vector3 centre(1, 2, 3), corner(1.5, 2, 3);
  MeshWall wall = mesh_wall("w", rectangle(corner, {0.1, 0, 0}, {0, 0.1, 0}), centre);
  wall.velocity = {0, 0, 0.5};
  wall.spin = {0, 0, M_PI};
  wall.force = {0, 0, -4};
  wall.torque = {0, 0, 0.3};
  for (int n = 0; n < 1000; ++n) wall.move(0.5e-3);
  const auto world = [&](const Vector3& x) {
    return Vector3(wall.orientation * (x - centre) + wall.centre);
  };
  EXPECT_LT((world(corner) - Vector3(1, 2.5, 3.25)).norm(), 1e-12);
  EXPECT_NEAR(wall.work(), 4 * 0.25 - 0.3 * M_PI / 2, 1e-12);
  const Vector3 point(1, 2.5, 3.25);
  EXPECT_LT((wall.velocity_at(point) - Vector3(-0.5 * M_PI, 0, 0.5)).norm(), 2e-3);
}

TEST_F(WallMeshFile, OpenSurfacesAreRead)
{
  const TriangleMesh open = rectangle({0, 0, 0.25}, {2, 0, 0}, {0, 1, 0}, 4, 2);
  write_stl((folder / "floor.stl").string(), open);
  const TriangleMesh stl = read_wall_mesh((folder / "floor.stl").string(), 0.5);
  EXPECT_EQ(stl.triangles.size(), 16u);
  EXPECT_EQ(stl.vertices.size(), 15u); // merged
  EXPECT_NEAR(surface_area(stl), 0.5, 1e-12);
  EXPECT_EQ(stl.vertices[0].z(), 0.125);

  const TriangleMesh obj = read_wall_mesh(
      write("plate.obj", "v 0 0 0\nv 1000 0 0\nv 1000 1000 0\nv 0 1000 0\nf 1 2 3 4\n").string(),
      0.001);
  EXPECT_EQ(obj.triangles.size(), 2u);
  EXPECT_NEAR(surface_area(obj), 1, 1e-12);

  const TriangleMesh ply = read_wall_mesh(
      write("t.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
          .string(),
      1);
  EXPECT_EQ(ply.triangles.size(), 1u);
}
