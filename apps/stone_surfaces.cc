#include "apps/stone_surfaces.h"

#include "apps/parameter_file.h"
#include "coupling/files/atomic_file.h"
#include "coupling/stones/stone_shapes.h"
#include "dem/meshes/decimation.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace interlock::apps
{
namespace
{
// The entries of an experiment that makes its stones; null of the others.
template <class Parameters> auto stones_of(const Parameters& p, int) -> decltype(&p.stones)
{
  return &p.stones;
}
template <class Parameters> const coupling::StoneParameters* stones_of(const Parameters&, long)
{
  return nullptr;
}

nlohmann::json to_json(const dem::TriangleMesh& mesh)
{
  nlohmann::json vertices = nlohmann::json::array(), triangles = nlohmann::json::array();
  for (const dem::Vector3& x : mesh.vertices)
    for (int c = 0; c < 3; ++c) vertices.push_back(1e-7 * std::round(1e7 * x[c]));
  for (const auto& t : mesh.triangles)
    for (const int v : t) triangles.push_back(v);
  return {{"vertices", vertices}, {"triangles", triangles}};
}

nlohmann::json to_json(const dem::ClumpShape& shape, const dem::TriangleMesh& mesh)
{
  return {{"name", shape.name},
          {"volume", shape.volume},
          {"spheres", shape.spheres.size()},
          {"fine", to_json(dem::decimated(mesh, 300))},
          {"coarse", to_json(dem::decimated(mesh, 80))}};
}
} // namespace

std::string write_stone_surfaces(const std::filesystem::path& folder,
                                 const std::filesystem::path& file)
try {
  const RunInput input = read_parameter_file(folder / "used.prm");
  const coupling::StoneParameters* parameters =
      std::visit([](const auto& p) -> const coupling::StoneParameters* { return stones_of(p, 0); },
                 input.parameters);
  if (!parameters) return "The experiment makes no stones of its own.";
  std::vector<dem::TriangleMesh> surfaces;
  const std::vector<coupling::Stone> stones = coupling::make_stones(*parameters, {}, &surfaces);
  if (surfaces.empty()) return "The clumps of the run came without the surfaces of their stones.";
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t k = 0; k < stones.size(); ++k)
    list.push_back(to_json(stones[k].shape, surfaces[k]));
  coupling::write_atomically(file, list.dump());
  return "";
} catch (const std::exception& error) { // a disk that is full, too

  return error.what();
}
} // namespace interlock::apps
