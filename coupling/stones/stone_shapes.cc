#include "coupling/stones/stone_shapes.h"

#include "coupling/stones/stone_scans.h"
#include "dem/generator/clump_generator.h"
#include "dem/generator/sphere_groups.h"
#include "dem/generator/union_volume.h"
#include "dem/input_error.h"
#include "dem/scans/stone_names.h"
#include "dem/stones/stone_size.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>

namespace interlock::coupling
{
namespace
{
Stone make_stone(const dem::TriangleMesh& mesh, const dem::ClumpParameters& parameters)
{
  dem::ClumpReport report;
  Stone stone;
  stone.shape = dem::make_clump(mesh, parameters, &report);
  stone.axes = report.rotation;
  stone.centre = report.rotation.conjugate() * (dem::mass_properties(mesh).centre - report.origin);
  const dem::StoneSize size = dem::stone_size(mesh);
  stone.elongation = size.elongation();
  stone.longest = size.longest;
  stone.groups = report.groups;
  stone.volume_error = report.volume_error;
  return stone;
}

// Extents of the spheres along the axes of the body.
Stone stone_of_clump(const dem::ClumpShape& shape)
{
  Stone stone;
  stone.shape = shape;
  stone.centre = dem::Vector3::Zero();
  stone.axes = dem::Quaternion::Identity();
  Eigen::AlignedBox3d box;
  for (const dem::Sphere& sphere : shape.spheres) {
    box.extend(sphere.centre + dem::Vector3::Constant(sphere.radius));
    box.extend(sphere.centre - dem::Vector3::Constant(sphere.radius));
  }
  dem::Vector3 extents = box.sizes();
  std::sort(extents.data(), extents.data() + 3);
  stone.longest = extents[2];
  stone.elongation = extents[1] / extents[2];
  stone.groups = dem::sphere_groups(shape.spheres);
  stone.volume_error = dem::UnionVolume(shape.spheres).volume() / shape.volume - 1;
  return stone;
}

std::vector<Stone> read_clumps(const std::vector<std::filesystem::path>& files)
{
  std::vector<Stone> stones;
  for (const std::filesystem::path& file : files)
    stones.push_back(stone_of_clump(dem::read_clump_shape(file.string())));
  return stones;
}
} // namespace

bool holds_clumps(const StoneParameters& parameters)
{
  return !parameters.folder.empty() && !dem::clump_files(parameters.folder).empty();
}

std::vector<Stone> make_stones(const StoneParameters& parameters, const Monitor& monitor)
{
  if (holds_clumps(parameters)) return read_clumps(dem::clump_files(parameters.folder));
  const std::vector<StoneScan> scans = stone_scans(parameters, monitor);
  std::vector<Stone> stones;
  for (const StoneScan& scan : scans) {
    if (monitor.progress)
      monitor.progress({"stones", static_cast<double>(stones.size()) / scans.size(), 0, 0});
    try {
      stones.push_back(make_stone(scan.mesh, clump_parameters(parameters, stones.size())));
    } catch (const InputError& error) {
      throw InputError("Stone " + scan.name + ": " + error.what());
    }
    stones.back().shape.name = scan.name;
  }
  return stones;
}

BodyPose body_pose(const Stone& stone, const dem::Vector3& place, const dem::Quaternion& attitude)
{
  const dem::Quaternion orientation = (attitude * stone.axes).normalized();
  return {place - orientation * stone.centre, orientation};
}
} // namespace interlock::coupling
