#include "apps/clump_making.h"

#include "dem/input_error.h"
#include "dem/meshes/mass_properties.h"
#include "dem/scans/cloud_cells.h"

#include <filesystem>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

ClumpResult start(const std::string& file, const std::string& name, const ClumpOptions& options,
                  const dem::ClumpParameters& parameters)
{
  ClumpResult result;
  result.file = file;
  result.name = name;
  result.density = options.density.value_or(0);
  result.parameters = parameters;
  return result;
}

void make_clump_of_mesh(const dem::TriangleMesh& stone, ClumpResult& result)
{
  result.nodes = stone.vertices.size();
  result.facets = stone.triangles.size();
  result.size = dem::stone_size(stone);
  result.volume = dem::mass_properties(stone).volume;
  result.shape = dem::make_clump(stone, result.parameters, &result.report);
  result.shape.name = result.name;
}

void make_clump_of_cloud(const ClumpOptions& options, ClumpResult& result)
{
  const dem::PointCloud stone =
      dem::read_point_cloud(result.file, file_options(options), &result.cloud);
  const dem::CloudProperties properties = dem::cloud_properties(stone);
  result.parameters.touching_radius = dem::TouchingRadius::nodes; // there are no facets
  result.nodes = stone.points.size();
  result.size = dem::stone_size(stone.points, properties.body, properties.area);
  result.volume = properties.body.volume;
  result.shape = dem::make_clump(stone, properties.body, result.parameters, &result.report);
  result.shape.name = result.name;
}
} // namespace

ClumpResult clump_of_file(const std::string& file, const std::string& name,
                          const ClumpOptions& options, const dem::ClumpParameters& parameters)
{
  ClumpResult result = start(file, name, options, parameters);
  std::error_code error;
  if (fs::is_regular_file(file, error) && !is_named_as_stone(file))
    throw InputError("The stone '" + file +
                     "' is named neither as a mesh (.stl, .ply, .obj) nor as a cloud of points "
                     "(.xyz, .ply).");
  if (dem::is_point_cloud(file))
    make_clump_of_cloud(options, result);
  else
    make_clump_of_mesh(dem::read_stone_mesh(file, file_options(options), &result.mesh), result);
  return result;
}

ClumpResult clump_of_surface(dem::TriangleMesh surface, const std::string& name,
                             const ClumpOptions& options, const dem::ClumpParameters& parameters)
{
  ClumpResult result = start("", name, options, parameters);
  make_clump_of_mesh(
      dem::closed_stone_mesh(std::move(surface), file_options(options), &result.mesh), result);
  return result;
}
} // namespace interlock::apps
