// Coordinates far from the origin. Fails when a stone that single precision has deformed passes
// without a word, when one that it has not deformed gets one, or when the steps are not those of
// IEEE 754: 2^-8 m at 54 km, 2^-15 m at 300 m.
#include "dem/scans/point_cloud.h"
#include "dem/scans/resolution.h"
#include "tests/dem_clouds.h"
#include "tests/dem_solids.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock::dem;

class ScanResolution : public TemporaryFolderTest
{
protected:
  static TriangleMesh stone(double distance)
  {
    TriangleMesh mesh = solids::subdivide(solids::box(0.06, 0.04, 0.03), 8);
    for (Vector3& x : mesh.vertices) x += Vector3(0.1 * distance, distance, 0);
    return mesh;
  }

  std::string single(const TriangleMesh& mesh) const
  {
    write_stl((folder / "stone.stl").string(), mesh);
    return (folder / "stone.stl").string();
  }

  // In text; `digits` behind the point, or those of a double.
  std::string text(const TriangleMesh& mesh, int digits = -1) const
  {
    std::ostringstream out;
    out.precision(digits < 0 ? 17 : digits);
    if (digits >= 0) out << std::fixed;
    for (const Vector3& x : mesh.vertices) out << "v " << x.transpose() << "\n";
    for (const auto& t : mesh.triangles)
      out << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
    return write("stone.obj", out.str()).string();
  }

  static std::vector<std::string> notes(const std::string& file)
  {
    MeshDiagnosis found;
    read_stone_mesh(file, {}, &found);
    return found.notes;
  }
};

TEST_F(ScanResolution, SinglePrecisionTooFarAwayIsRefused)
{
  const std::string file = single(stone(54000));
  expect_refusal([&] { read_stone_mesh(file, 1); }, file,
                 {"single precision", "steps are 3.9 mm", "6.6 % of its length",
                  "move it to the origin", "(54000 m)"});
}

TEST_F(ScanResolution, SinglePrecisionFarAwayIsNoted)
{
  const auto found = notes(single(stone(300)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("steps are 0.031 mm, 0.051 % of its length"), std::string::npos)
      << found[0];
  EXPECT_NE(found[0].find("move it to the origin"), std::string::npos);
}

TEST_F(ScanResolution, NearTheOriginNothingIsSaid)
{
  EXPECT_TRUE(notes(single(stone(0))).empty());
  EXPECT_TRUE(notes(single(stone(10))).empty());
  EXPECT_TRUE(notes(text(stone(54000))).empty());
  EXPECT_TRUE(notes(text(stone(0), 3)).empty()); // a drawing in whole millimetres
}

// Written with all digits by a program that kept floats.
TEST_F(ScanResolution, FloatsInTextAreNoted)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.06), 20);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) // no grid
    mesh.vertices[v] *= 1 + 1e-3 * std::sin(double(v));
  for (Vector3& x : mesh.vertices) x += Vector3(300, 300, 300);
  EXPECT_TRUE(notes(text(mesh)).empty());
  for (Vector3& x : mesh.vertices) x = x.cast<float>().cast<double>();
  const auto found = notes(text(mesh));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("numbers of single precision, whose steps are 0.031 mm"),
            std::string::npos)
      << found[0];
}

TEST_F(ScanResolution, FewDigitsAreNoted)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.06), 20);
  for (Vector3& x : mesh.vertices) x += Vector3(6000, 0, 0);
  const InputFile file("Stone mesh", write("a.obj", "v").string());
  EXPECT_EQ(check_resolution(file, mesh.vertices, false, 1), "");
  for (Vector3& x : mesh.vertices) x = (1e3 * x).array().round() / 1e3;
  const std::string note = check_resolution(file, mesh.vertices, false, 1);
  EXPECT_NE(note.find("whole multiples of 1 mm, 1.2 % of its length"), std::string::npos) << note;
  EXPECT_NE(check_resolution(file, mesh.vertices, false, 1e-3).find("0.001 mm, 1.2 %"),
            std::string::npos);
}

TEST_F(ScanResolution, Clouds)
{
  PointCloud cloud = clouds::ellipsoid(Vector3(0.03, 0.02, 0.015), 400);
  for (Vector3& x : cloud.points) x += Vector3(0, 54000, 0);
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 400\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    bytes += std::string("property float ") + name + "\n";
  bytes += "end_header\n";
  for (std::size_t i = 0; i < 400; ++i)
    for (const Vector3& v : {cloud.points[i], cloud.normals[i]}) {
      const Eigen::Vector3f single = v.cast<float>();
      bytes.append(reinterpret_cast<const char*>(single.data()), 12);
    }
  const std::string file = write("a.ply", bytes).string();
  expect_refusal([&] { read_point_cloud(file, 1); }, file, {"single precision", "3.9 mm"});
}
} // namespace
