// Body of a cloud against closed forms, and its files. Fails when the cells of the points do not
// add up to the surface, when separators or comments of a text file are taken for data, or when a
// binary PLY cloud comes out otherwise than a text one.
#include "dem/scans/cloud_cells.h"
#include "tests/dem_clouds.h"
#include "tests/temporary_folder.h"

#include <cstring>
#include <random>

namespace
{
using namespace interlock::dem;

// Of a solid ellipsoid: 4/3 pi abc and m/5 (b^2 + c^2).
void expect_ellipsoid(const CloudProperties& found, const Vector3& half, double of_volume,
                      double of_moments)
{
  const double volume = 4 * std::acos(-1.) / 3 * half.prod();
  EXPECT_NEAR(found.body.volume / volume, 1, of_volume);
  for (int k = 0; k < 3; ++k) {
    const double exact = volume / 5 * (half.squaredNorm() - half[k] * half[k]);
    EXPECT_NEAR(found.body.inertia(k, k) / exact, 1, of_moments) << "axis " << k;
  }
  EXPECT_LT(found.body.centre.norm(), 0.01 * half.maxCoeff());
  EXPECT_LT(found.closure, 0.02);
  EXPECT_EQ(found.disagreeing_normals, 0);
}

TEST(PointCloud, EvenEllipsoid)
{
  const Vector3 half(0.02, 0.015, 0.01);
  expect_ellipsoid(cloud_properties(clouds::ellipsoid(half, 500)), half, 0.005, 0.005);
  expect_ellipsoid(cloud_properties(clouds::ellipsoid(half, 5000)), half, 0.0005, 0.0005);
}

TEST(PointCloud, RandomEllipsoid)
{
  RandomStream generator(1);
  const Vector3 half(0.02, 0.015, 0.01);
  expect_ellipsoid(cloud_properties(clouds::ellipsoid(half, 1000, &generator)), half, 0.01, 0.01);
}

TEST(PointCloud, NoisyEllipsoid)
{
  RandomStream generator(1);
  const Vector3 half(0.02, 0.015, 0.01);
  PointCloud cloud = clouds::ellipsoid(half, 5000, &generator);
  const double spacing = 6e-4; // sqrt(area / points)
  const auto noise = [&](double size) {
    return Vector3(generator.uniform(-size, size), generator.uniform(-size, size),
                   generator.uniform(-size, size));
  };
  for (Vector3& x : cloud.points) x += noise(0.1 * spacing);
  for (Vector3& n : cloud.normals) n = (n + noise(0.1)).normalized();
  expect_ellipsoid(cloud_properties(cloud), half, 0.015, 0.015);
}

// Gaussian noise along the normals. The body is known, so that the error of its volume is; what
// the scatter says of it must agree.
TEST(PointCloud, ScatterTellsTheErrorOfTheVolume)
{
  const Vector3 half(0.030, 0.020, 0.012);
  const double volume = 4 * std::acos(-1.) / 3 * half.prod();
  const PointCloud even = clouds::ellipsoid(half, 2000);
  const CloudProperties quiet = cloud_properties(even);
  EXPECT_LT(quiet.scatter, 0.002 * quiet.spacing) << "curvature counts as noise";
  for (const double ratio : {0.05, 0.1, 0.14, 0.2}) {
    PointCloud noisy = even;
    const double noise = ratio * quiet.spacing;
    std::mt19937 generator(1);
    std::normal_distribution<double> normal(0, noise);
    for (std::size_t i = 0; i < noisy.points.size(); ++i)
      noisy.points[i] += normal(generator) * noisy.normals[i];
    const CloudProperties found = cloud_properties(noisy);
    EXPECT_NEAR(found.scatter, noise, 0.05 * noise);
    const double excess = found.body.volume / volume - 1;
    EXPECT_NEAR(found.volume_excess, excess, 0.1 * excess)
        << "noise " << ratio << " of the spacing";
    EXPECT_LT(found.closure, 0.02) << "the gap does not see noise";
  }
}

TEST(PointCloud, Cube)
{
  // Side 2, points in the middle of a grid's squares: the cells are the squares themselves.
  PointCloud cube;
  constexpr int n = 10;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1})
      for (int i = 0; i < n * n; ++i) {
        Vector3 normal = Vector3::Zero(), x;
        normal[axis] = side;
        x[axis] = side;
        x[(axis + 1) % 3] = (i % n + 0.5) * 2 / n - 1;
        x[(axis + 2) % 3] = (i / n + 0.5) * 2 / n - 1;
        cube.points.push_back(x);
        cube.normals.push_back(normal);
      }
  const CloudProperties found = cloud_properties(cube);
  EXPECT_NEAR(found.area, 24, 1e-9);
  EXPECT_NEAR(found.body.volume, 8, 1e-9);
  EXPECT_LT((found.body.inertia - 16. / 3 * Matrix3::Identity()).norm(), 1e-9);
}

class PointCloudFiles : public TemporaryFolderTest
{
};

TEST_F(PointCloudFiles, TextWithCommentsCommasAndDuplicates)
{
  std::string text = clouds::as_text(clouds::ellipsoid(Vector3(20, 15, 10), 400));
  for (char& c : text)
    if (c == ' ') c = ',';
  const std::string first = text.substr(0, text.find('\n') + 1);
  const auto file = write("a.xyz", "//X,Y,Z,Nx,Ny,Nz\n# by hand\n\n" + first + text);
  EXPECT_TRUE(is_point_cloud(file.string()));
  PointCloudDiagnosis diagnosis;
  StoneFileOptions millimetres;
  millimetres.length_unit = 0.001;
  const PointCloud cloud = read_point_cloud(file.string(), millimetres, &diagnosis);
  EXPECT_EQ(cloud.points.size(), 400u);
  EXPECT_EQ(diagnosis.points_read, 401);
  EXPECT_EQ(diagnosis.duplicates_dropped, 1);
  EXPECT_NEAR(diagnosis.body.volume, 4 * std::acos(-1.) * 1e-6, 0.02 * 4 * std::acos(-1.) * 1e-6);
}

TEST_F(PointCloudFiles, BinaryPly)
{
  const PointCloud cloud = clouds::ellipsoid(Vector3(0.02, 0.015, 0.01), 400);
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 400\n";
  for (const char* name : {"nx", "ny", "nz", "x", "y", "z"})
    bytes += std::string("property double ") + name + "\n";
  bytes += "end_header\n";
  for (std::size_t i = 0; i < 400; ++i)
    for (const Vector3* v : {&cloud.normals[i], &cloud.points[i]})
      bytes.append(reinterpret_cast<const char*>(v->data()), 3 * sizeof(double));
  const auto file = write("a.ply", bytes);
  EXPECT_TRUE(is_point_cloud(file.string()));
  const PointCloud copy = read_point_cloud(file.string(), 1);
  ASSERT_EQ(copy.points.size(), 400u);
  for (std::size_t i = 0; i < 400; ++i) {
    EXPECT_EQ(copy.points[i], cloud.points[i]);
    EXPECT_LT((copy.normals[i] - cloud.normals[i]).norm(), 1e-12);
  }
}

TEST_F(PointCloudFiles, NamesOfNormals)
{
  const std::string rows = clouds::as_text(clouds::ellipsoid(Vector3(0.02, 0.015, 0.01), 400));
  const std::vector<std::array<const char*, 6>> all = {
      {"x", "y", "z", "normal_x", "normal_y", "normal_z"},
      {"X", "Y", "Z", "NX", "NY", "NZ"},
      {"x", "y", "z", "Normal_X", "Normal_Y", "Normal_Z"},
      {"x", "y", "z", "scalar_Nx", "scalar_Ny", "scalar_Nz"}};
  for (const auto& names : all) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 400\n";
    for (const char* name : names) text += std::string("property float ") + name + "\n";
    const auto file = write("a.ply", text + "end_header\n" + rows);
    EXPECT_TRUE(is_point_cloud(file.string()));
    EXPECT_EQ(read_point_cloud(file.string(), 1).points.size(), 400u) << names[3];
  }
}

TEST_F(PointCloudFiles, ByteOrderMarkAndLineEnds)
{
  const std::string rows = clouds::as_text(clouds::ellipsoid(Vector3(0.02, 0.015, 0.01), 400));
  for (const char end : {'\n', '\r'}) {
    std::string text = rows;
    for (char& c : text)
      if (c == '\n') c = end;
    const auto file = write("a.xyz", "\xEF\xBB\xBF" + text);
    EXPECT_EQ(read_point_cloud(file.string(), 1).points.size(), 400u);
  }
}

TEST_F(PointCloudFiles, MeshesAndMissingFilesAreNoClouds)
{
  EXPECT_FALSE(is_point_cloud("absent.ply"));
  EXPECT_FALSE(is_point_cloud(write("a.stl", "solid a").string()));
  EXPECT_FALSE(is_point_cloud(write("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"
                                             "property float x\nelement face 1\n"
                                             "property list uchar int vertex_indices\n"
                                             "end_header\n0\n3 0 0 0\n")
                                  .string()));
}
} // namespace
