#include "dem/scans/point_cloud.h"

#include "dem/scans/cloud_cells.h"
#include "dem/scans/input_file.h"
#include "dem/scans/mesh_cleaning.h"
#include "dem/scans/ply_file.h"
#include "dem/scans/resolution.h"
#include "dem/scans/text_scanner.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
PointCloud read_xyz(const InputFile& file)
{
  PointCloud cloud;
  TextScanner scanner(file, file.text(), ",;");
  do {
    std::array<double, 6> row;
    std::size_t columns = 0;
    for (;; ++columns) {
      const std::string_view word = scanner.word();
      if (word.empty() || word[0] == '#' || word.substr(0, 2) == "//") break;
      if (columns == row.size())
        file.refuse("has more than six columns in line ", scanner.line(),
                    ", but must have x y z nx ny nz.");
      row[columns] = scanner.number(word);
    }
    if (columns == 3)
      file.refuse("has no normals: line ", scanner.line(),
                  " has three columns, but must have x y z nx ny nz.");
    if (columns != 0 && columns != row.size())
      file.refuse("has ", columns, " columns in line ", scanner.line(),
                  ", but must have x y z nx ny nz.");
    if (columns == 0) continue;
    cloud.points.emplace_back(row[0], row[1], row[2]);
    cloud.normals.emplace_back(row[3], row[4], row[5]);
    if (cloud.normals.back().isZero(0))
      file.refuse("has a normal of length zero in line ", scanner.line(), ".");
    if (const double length = cloud.normals.back().norm(); std::abs(length - 1) > 0.1)
      file.refuse("has no unit normal in columns 4 to 6 of line ", scanner.line(),
                  ", but numbers of length ", length,
                  " (colours?): the columns must be x y z nx ny nz.");
  } while (scanner.next_line());
  return cloud;
}

struct CloudData {
  PointCloud cloud; // file units
  bool single_precision = false;
};

CloudData read_ply_cloud(const InputFile& file)
{
  const PlyHeader header = read_ply_header(file);
  if (header.has_facets()) file.refuse("is no cloud: it has facets.");
  PlyData data = read_ply(file, header);
  if (data.normals.empty())
    for (const PlyHeader::Element& element : header.elements)
      if (element.is_named("vertex"))
        file.refuse("has no normals: its vertices have ", element.property_names(),
                    ", but a cloud needs nx, ny and nz (or normal_x and so on)",
                    header.unknown_elements(), ".");
  return {{std::move(data.mesh.vertices), std::move(data.normals)}, data.single_precision};
}

CloudData read_points(const InputFile& file)
{
  const std::string extension = file.extension(), content = file.content();
  if (extension != ".xyz" && extension != ".ply")
    file.refuse("has the extension ", quoted(extension), ", but must be .xyz or .ply.");
  if (!content.empty() && !(content == "a PLY file" && extension == ".ply"))
    file.refuse("cannot be read as a cloud: its extension is ", extension, ", but it is ", content,
                ".");
  if (extension == ".xyz") return {read_xyz(file), false};
  return read_ply_cloud(file);
}

void normalise(const InputFile& file, PointCloud& cloud, bool flip)
{
  for (std::size_t i = 0; i < cloud.normals.size(); ++i) {
    Vector3& normal = cloud.normals[i];
    if (!normal.allFinite())
      file.refuse("has a normal that is not a finite number at point ", i + 1, ".");
    if (normal.isZero(0)) file.refuse("has a normal of length zero at point ", i + 1, ".");
    normal = (flip ? -1 : 1) * normal.stableNormalized();
  }
}

// Of points at one place the first is kept; it has the normal that stays.
int drop_duplicates(PointCloud& cloud)
{
  std::vector<int> order(cloud.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto place = [&](int i) {
    const Vector3& x = cloud.points[i];
    return std::array<double, 3>{x[0], x[1], x[2]};
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::make_pair(place(a), a) < std::make_pair(place(b), b);
  });
  const auto end =
      std::unique(order.begin(), order.end(), [&](int a, int b) { return place(a) == place(b); });
  order.erase(end, order.end());
  std::sort(order.begin(), order.end());
  PointCloud kept;
  for (const int i : order) {
    kept.points.push_back(cloud.points[i]);
    kept.normals.push_back(cloud.normals[i]);
  }
  const int dropped = static_cast<int>(cloud.points.size() - kept.points.size());
  cloud = std::move(kept);
  return dropped;
}

void check_body(const InputFile& file, int points, const PointCloudDiagnosis& diagnosis)
{
  if (diagnosis.disagreeing_normals > 0.01 * points)
    file.refuse("has normals that disagree: at ", diagnosis.disagreeing_normals, " of ", points,
                " points the normal is against those of most neighbours.");
  if (diagnosis.closure > largest_closure)
    file.refuse("does not enclose a body evenly: its surface leaves a gap of ",
                100 * diagnosis.closure, " % of its area, but at most ", 100 * largest_closure,
                " % can be bridged.");
  if (diagnosis.volume_excess > largest_volume_excess)
    file.refuse("is too noisy: its points scatter by ", diagnosis.scatter,
                " m along their normals, ", 100 * diagnosis.scatter / diagnosis.spacing,
                " % of their spacing, which makes the volume too large by about ",
                100 * diagnosis.volume_excess, " %, but at most ", 100 * largest_volume_excess,
                " % are taken: smooth the points or take fewer of them.");
  if (diagnosis.body.volume < 0)
    file.refuse("is inside out: its normals point inwards (volume ", diagnosis.body.volume,
                diagnosis.flipped ? " m3); leave --flip away." : " m3); turn them with --flip.");
  if (!(diagnosis.body.volume > 0)) file.refuse("encloses no volume.");
}
} // namespace

PointCloud read_point_cloud(const std::string& path, const StoneFileOptions& options,
                            PointCloudDiagnosis* diagnosis)
{
  InputFile file("Point cloud", path);
  check_length_unit(file, options.length_unit);
  CloudData data = read_points(file);
  PointCloud& cloud = data.cloud;
  file.release();
  PointCloudDiagnosis found;
  found.points_read = static_cast<int>(cloud.points.size());
  found.flipped = options.flip;
  normalise(file, cloud, options.flip);
  found.duplicates_dropped = drop_duplicates(cloud);
  const std::string coarse =
      check_resolution(file, cloud.points, data.single_precision, options.length_unit);
  if (!coarse.empty()) found.notes.push_back(coarse);
  for (Vector3& x : cloud.points) x *= options.length_unit;
  if (diagnosis) *diagnosis = found;

  const int points = static_cast<int>(cloud.points.size());
  if (points < fewest_points)
    file.refuse("has ", points, " different points, but must have at least ", fewest_points, ".");
  check_stone_size(file, extents({cloud.points, {}}).maxCoeff(), options.length_unit);
  const CloudProperties properties = cloud_properties(cloud);
  found.disagreeing_normals = properties.disagreeing_normals;
  found.closure = properties.closure;
  found.spacing = properties.spacing;
  found.scatter = properties.scatter;
  found.volume_excess = properties.volume_excess;
  found.body = properties.body;
  if (diagnosis) *diagnosis = found;
  check_body(file, points, found);
  return std::move(cloud);
}

PointCloud read_point_cloud(const std::string& path, double length_unit)
{
  StoneFileOptions options;
  options.length_unit = length_unit;
  return read_point_cloud(path, options);
}

bool is_point_cloud(const std::string& path)
{
  try {
    const InputFile file("Point cloud", path);
    if (file.extension() == ".xyz") return true;
    return file.extension() == ".ply" && !read_ply_header(file).has_facets();
  } catch (const InputError&) {
    return false;
  }
}
} // namespace interlock::dem
