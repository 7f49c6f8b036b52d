#include "coupling/stones/stone_scans.h"

#include "coupling/stones/stone_shapes.h"
#include "dem/meshes/mass_properties.h"
#include "dem/scans/stone_file.h"
#include "dem/scans/stone_names.h"
#include "dem/stones/synthetic_stone.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>

namespace interlock::coupling
{
namespace
{
std::vector<StoneScan> read_scans(const StoneParameters& parameters, const Monitor& monitor)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(parameters.folder))
    if (dem::is_stone_file(entry, dem::mesh_endings)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<StoneScan> meshes;
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

std::vector<StoneScan> synthetic(const StoneParameters& parameters)
{
  std::vector<StoneScan> meshes;
  for (dem::TriangleMesh& mesh : dem::make_stones(parameters.count, parameters.seed))
    meshes.push_back({"stone_" + std::to_string(meshes.size() + 1), std::move(mesh)});
  return meshes;
}

// x_scan = origin + rotation x_body
struct BodyFrame {
  dem::Vector3 origin;
  dem::Quaternion rotation;
};

BodyFrame body_frame(const dem::TriangleMesh& mesh, const dem::ClumpParameters& parameters)
{
  if (parameters.mass_scheme == dem::MassScheme::mesh) {
    const dem::MassProperties mass = dem::mass_properties(mesh);
    return {mass.centre, dem::Quaternion(dem::principal_frame(mass).axes)};
  }
  dem::ClumpReport report;
  dem::make_clump(mesh, parameters, &report);
  return {report.origin, report.rotation};
}
} // namespace

std::vector<StoneScan> stone_scans(const StoneParameters& parameters, const Monitor& monitor)
{
  return parameters.folder.empty() ? synthetic(parameters) : read_scans(parameters, monitor);
}

dem::ClumpParameters clump_parameters(const StoneParameters& parameters, std::size_t index)
{
  dem::ClumpParameters clump;
  clump.seed = parameters.seed + index;
  clump.d_min = parameters.d_min;
  clump.r_min = parameters.r_min;
  clump.p_max = parameters.p_max;
  clump.max_spheres = parameters.max_spheres;
  clump.sphere_order = dem::sphere_order(parameters.sphere_order);
  clump.bulge = parameters.bulge;
  clump.mass_scheme = dem::mass_scheme(parameters.mass_properties);
  return clump;
}

std::vector<StoneScan> scans_in_body_frames(const StoneParameters& parameters)
{
  if (holds_clumps(parameters)) return {};
  std::vector<StoneScan> scans = stone_scans(parameters, {});
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const BodyFrame frame = body_frame(scans[k].mesh, clump_parameters(parameters, k));
    for (dem::Vector3& x : scans[k].mesh.vertices)
      x = frame.rotation.conjugate() * (x - frame.origin);
  }
  return scans;
}
} // namespace interlock::coupling
