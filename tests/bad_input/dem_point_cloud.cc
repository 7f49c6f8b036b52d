// A cloud from which no body can be made is refused in one sentence with its line or its numbers.
// Fails when such a cloud passes, in particular a half of one.
#include "dem/scans/point_cloud.h"
#include "tests/dem_clouds.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock::dem;

class PointCloudFile : public TemporaryFolderTest
{
protected:
  void expect_refused(const std::string& name, const std::string& text,
                      const std::vector<std::string>& facts,
                      const StoneFileOptions& options = {}) const
  {
    const std::string file = write(name, text).string();
    expect_refusal([&] { read_point_cloud(file, options); }, file, facts);
  }
};

PointCloud ball()
{
  return clouds::ellipsoid(Vector3(0.02, 0.02, 0.02), 500);
}

TEST_F(PointCloudFile, LinesAreNamed)
{
  const std::string line = "0 0 0.02 0 0 1\n";
  expect_refused("a.xyz", line + "0 0 0.02\n", {"no normals", "line 2"});
  expect_refused("b.xyz", line + "0 0 0.02 1\n", {"4 columns in line 2"});
  expect_refused("c.xyz", line + "0 0 0.02 0 0 1 255\n", {"more than six columns in line 2"});
  expect_refused("d.xyz", "# title\n" + line + "0 0 0.02 0 0 up\n", {"'up' in line 3"});
  expect_refused("e.xyz", line + "0 0 0.02 0 0 0\n", {"length zero in line 2"});
  expect_refused("rgb.xyz", line + "0 0.02 0 120 130 140\n",
                 {"no unit normal in columns 4 to 6 of line 2", "length 225.6"});
  expect_refused("f.xyz", line + "0 0 nan 0 0 1\n", {"'nan'", "finite", "line 2"});
  expect_refused("g.xyz", line, {"1 different points", "at least 100"});
  expect_refused("h.xyz", "# nothing\n", {"0 different points"});
  expect_refused("i.xyz", "", {"is empty"});
  expect_refused("j.txt", line, {"'.txt'", ".xyz or .ply"});
  expect_refused("k.xyz", "\x89PNG\r\n", {"a PNG picture"});
  expect_refusal([&] { read_point_cloud("absent.xyz", 1); }, "absent.xyz", {"does not exist"});
}

TEST_F(PointCloudFile, PlyWithoutNormals)
{
  expect_refused("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n0 0 0\n",
                 {"no normals", "its vertices have 'x', 'y' and 'z'", "nx, ny and nz"});
  expect_refused("b.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                 "end_header\n0 0 0 nan 0 0\n",
                 {"a normal that is not a finite number at point 1"});
}

TEST_F(PointCloudFile, HalfABall)
{
  PointCloud half;
  const PointCloud whole = ball();
  for (std::size_t i = 0; i < whole.points.size(); ++i)
    if (whole.points[i].z() > 0) {
      half.points.push_back(whole.points[i]);
      half.normals.push_back(whole.normals[i]);
    }
  expect_refused("half.xyz", clouds::as_text(half), {"does not enclose a body evenly", "5 %"});
}

TEST_F(PointCloudFile, NormalsInwards)
{
  PointCloud inward = ball();
  for (Vector3& n : inward.normals) n *= -1;
  expect_refused("in.xyz", clouds::as_text(inward), {"is inside out", "--flip"});
  StoneFileOptions flip;
  flip.flip = true;
  EXPECT_NO_THROW(read_point_cloud(write("in.xyz", clouds::as_text(inward)).string(), flip));
  expect_refused("out.xyz", clouds::as_text(ball()), {"is inside out", "leave --flip away"}, flip);
}

TEST_F(PointCloudFile, NormalsDisagree)
{
  PointCloud mixed = ball();
  for (std::size_t i = 0; i < mixed.points.size(); i += 20) mixed.normals[i] *= -1;
  expect_refused("mixed.xyz", clouds::as_text(mixed), {"disagree", "25 of 500 points"});
}

TEST_F(PointCloudFile, Noise)
{
  PointCloud noisy = ball();
  RandomStream generator(1);
  // Points are 3.6 mm apart; uniform noise of 1.2 mm scatters by 0.7 mm, a fifth of it.
  for (std::size_t i = 0; i < noisy.points.size(); ++i)
    noisy.points[i] += generator.uniform(-0.0012, 0.0012) * noisy.normals[i];
  expect_refused("noisy.xyz", clouds::as_text(noisy),
                 {"too noisy", "of their spacing", "at most 5 %"});
}

TEST_F(PointCloudFile, Unit)
{
  PointCloud large = ball();
  for (Vector3& x : large.points) x *= 1000;
  expect_refused("mm.xyz", clouds::as_text(large), {"millimetres read as metres"});
}
} // namespace
