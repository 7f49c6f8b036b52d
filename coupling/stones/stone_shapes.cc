#include "coupling/stones/stone_shapes.h"

#include "dem/generator/clump_generator.h"
#include "dem/generator/sphere_groups.h"
#include "dem/generator/union_volume.h"
#include "dem/input_error.h"
#include "dem/scans/stone_file.h"
#include "dem/scans/stone_names.h"
#include "dem/stones/stone_size.h"
#include "dem/stones/synthetic_stone.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>

namespace interlock::coupling
{
namespace
{
struct NamedMesh {
  std::string name;
  dem::TriangleMesh mesh;
};

std::vector<NamedMesh> read_scans(const StoneParameters& parameters, const Monitor& monitor)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(parameters.folder))
    if (dem::is_stone_file(entry, dem::mesh_endings)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<NamedMesh> meshes;
  dem::StoneFileOptions options;
  options.length_unit = parameters.length_unit;
  for (const std::filesystem::path& file : files) {
    dem::MeshDiagnosis diagnosis;
    meshes.push_back(
        {file.stem().string(), dem::read_stone_mesh(file.string(), options, &diagnosis)});
    if (monitor.message)
      for (const std::string& note : diagnosis.notes)
        monitor.message("Stone " + meshes.back().name + ": " + note + ".");
  }
  return meshes;
}

std::vector<NamedMesh> synthetic(const StoneParameters& parameters)
{
  std::vector<NamedMesh> meshes;
  for (dem::TriangleMesh& mesh : dem::make_stones(parameters.count, parameters.seed))
    meshes.push_back({"stone_" + std::to_string(meshes.size() + 1), std::move(mesh)});
  return meshes;
}

dem::TriangleMesh in_body_frame(dem::TriangleMesh mesh, const dem::ClumpReport& report)
{
  for (dem::Vector3& x : mesh.vertices) x = report.rotation.conjugate() * (x - report.origin);
  return mesh;
}

Stone make_stone(const dem::TriangleMesh& mesh, const dem::ClumpParameters& parameters,
                 dem::ClumpReport& report)
{
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

std::vector<Stone> make_stones(const StoneParameters& parameters, const Monitor& monitor,
                               std::vector<dem::TriangleMesh>* surfaces)
{
  if (holds_clumps(parameters)) return read_clumps(dem::clump_files(parameters.folder));
  const std::vector<NamedMesh> meshes =
      parameters.folder.empty() ? synthetic(parameters) : read_scans(parameters, monitor);

  dem::ClumpParameters clump;
  clump.d_min = parameters.d_min;
  clump.r_min = parameters.r_min;
  clump.p_max = parameters.p_max;
  clump.max_spheres = parameters.max_spheres;
  clump.sphere_order = dem::sphere_order(parameters.sphere_order);
  clump.bulge = parameters.bulge;
  clump.mass_scheme = dem::mass_scheme(parameters.mass_properties);

  std::vector<Stone> stones;
  for (const NamedMesh& scan : meshes) {
    if (monitor.progress)
      monitor.progress({"stones", static_cast<double>(stones.size()) / meshes.size(), 0, 0});
    clump.seed = parameters.seed + stones.size();
    dem::ClumpReport report;
    try {
      stones.push_back(make_stone(scan.mesh, clump, report));
    } catch (const InputError& error) {
      throw InputError("Stone " + scan.name + ": " + error.what());
    }
    stones.back().shape.name = scan.name;
    if (surfaces) surfaces->push_back(in_body_frame(scan.mesh, report));
  }
  return stones;
}

BodyPose body_pose(const Stone& stone, const dem::Vector3& place, const dem::Quaternion& attitude)
{
  const dem::Quaternion orientation = (attitude * stone.axes).normalized();
  return {place - orientation * stone.centre, orientation};
}
} // namespace interlock::coupling
