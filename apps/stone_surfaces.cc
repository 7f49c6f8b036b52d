#include "apps/stone_surfaces.h"

#include "apps/parameter_file.h"
#include "coupling/files/atomic_file.h"
#include "coupling/stones/stone_scans.h"
#include "dem/meshes/decimation.h"
#include "dem/meshes/mass_properties.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace interlock::apps
{
namespace
{
using coupling::StoneParameters;

// The entries of an experiment that makes its stones; null of the others.
const StoneParameters* stones_of(const coupling::PullOutParameters& p)
{
  return &p.stones;
}
const StoneParameters* stones_of(const coupling::HeapParameters& p)
{
  return &p.stones;
}
const StoneParameters* stones_of(const coupling::ShearBoxParameters& p)
{
  return &p.specimen.stones;
}
const StoneParameters* stones_of(const coupling::TriaxialParameters& p)
{
  return &p.specimen.stones;
}
const StoneParameters* stones_of(const coupling::PackingParameters&)
{
  return nullptr;
}
const StoneParameters* stones_of(const coupling::LaboratoryParameters&)
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

nlohmann::json to_json(const coupling::StoneScan& scan)
{
  return {{"name", scan.name},
          {"volume", dem::mass_properties(scan.mesh).volume},
          {"fine", to_json(dem::decimated(scan.mesh, 300))},
          {"coarse", to_json(dem::decimated(scan.mesh, 80))}};
}
} // namespace

std::string write_stone_surfaces(const std::filesystem::path& folder,
                                 const std::filesystem::path& file)
try {
  const RunInput input = read_parameter_file(folder / "used.prm");
  const StoneParameters* parameters =
      std::visit([](const auto& p) { return stones_of(p); }, input.parameters);
  if (!parameters) return "The experiment makes no stones of its own.";
  const std::vector<coupling::StoneScan> scans = coupling::scans_in_body_frames(*parameters);
  if (scans.empty()) return "The clumps of the run came without the surfaces of their stones.";
  nlohmann::json list = nlohmann::json::array();
  for (const coupling::StoneScan& scan : scans) list.push_back(to_json(scan));
  coupling::write_atomically(file, list.dump());
  return "";
} catch (const std::exception& error) { // a disk that is full, too

  const std::string text = error.what();
  return text.substr(0, text.find('\n')); // the first of many errors
}
} // namespace interlock::apps
