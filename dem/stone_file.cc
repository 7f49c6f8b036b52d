// Files of stones: read_stone_mesh and write_stl of triangle_mesh.h.
#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/triangle_mesh.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace interlock::dem
{
namespace
{
// The sentence "Stone mesh 'file' ...".
template <class... Parts> [[noreturn]] void refuse(const std::string& path, const Parts&... parts)
{
  std::ostringstream text;
  text << "Stone mesh '" << path << "' ";
  (text << ... << parts);
  throw InputError(text.str());
}

void check_file(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error)) refuse(path, "does not exist.");
  if (!fs::is_regular_file(path, error)) refuse(path, "is not a file.");
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (extension != ".stl" && extension != ".ply" && extension != ".obj")
    refuse(path, "has the extension '", extension, "', but must be .stl, .ply or .obj.");
  if (!std::ifstream(path, std::ios::binary)) refuse(path, "cannot be opened for reading.");
}

using Coordinates = std::array<float, 3>;

// Appends the facets of one Assimp mesh. Own merging instead of aiProcess_JoinIdenticalVertices:
// that one keeps vertices apart where facet normals differ, and never joins across the groups of a
// file.
void append(const std::string& path, const aiMesh& part, double length_unit,
            std::map<Coordinates, int>& known, TriangleMesh& mesh)
{
  for (unsigned int f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue; // loose points and lines
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const aiVector3D& v = part.mVertices[face.mIndices[k]];
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        refuse(path, "has a coordinate that is not a finite number in facet ", f + 1, ": (", v.x,
               ", ", v.y, ", ", v.z, ").");
      const auto [entry, is_new] =
          known.try_emplace(Coordinates{v.x, v.y, v.z}, static_cast<int>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(length_unit * Vector3(v.x, v.y, v.z));
      triangle[k] = entry->second;
    }
    // Facets with two equal corners close nothing; their edges cancel when they go.
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      mesh.triangles.push_back(triangle);
  }
}

void drop_unused_vertices(TriangleMesh& mesh)
{
  std::vector<int> number(mesh.vertices.size(), -1);
  std::vector<Vector3> kept;
  for (auto& triangle : mesh.triangles)
    for (int& v : triangle) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(kept.size());
        kept.push_back(mesh.vertices[v]);
      }
      v = number[v];
    }
  mesh.vertices = std::move(kept);
}

void check_size(const std::string& path, const TriangleMesh& mesh, double length_unit)
{
  const double size = extents(mesh).maxCoeff();
  if (size >= smallest_stone && size <= largest_stone) return;
  const auto fits = [&](double factor) {
    return size * factor >= smallest_stone && size * factor <= largest_stone;
  };
  std::string hint;
  if (fits(1e-3)) hint = " (it looks like millimetres read as metres)";
  if (fits(1e3)) hint = " (it looks like metres read as millimetres)";
  refuse(path, "is ", size, " m long with a file unit of ", length_unit, " m, but stones measure ",
         smallest_stone, " m to ", largest_stone, " m: check the length unit", hint, ".");
}

void check_surface(const std::string& path, const TriangleMesh& mesh)
{
  const EdgeDiagnosis edges = diagnose_edges(mesh);
  if (edges.open > 0)
    refuse(path, "is open: ", edges.open,
           " edges have a facet on one side only; close the holes before making a clump.");
  if (edges.branching > 0)
    refuse(path, "is not a surface: ", edges.branching, " edges have more than two facets.");
  if (edges.flipped > 0)
    refuse(path, "is not consistently oriented: at ", edges.flipped,
           " edges the two facets disagree about which side is outside.");
  const double volume = mass_properties(mesh).volume;
  if (volume < 0)
    refuse(path, "is inside out: its facets point inwards (volume ", volume,
           " m3); reverse the order of their corners.");
  if (volume == 0) refuse(path, "encloses no volume.");
}

void append_floats(std::string& bytes, const Vector3& vector)
{
  const Eigen::Vector3f single = vector.cast<float>();
  bytes.append(reinterpret_cast<const char*>(single.data()), 3 * sizeof(float));
}
} // namespace

TriangleMesh read_stone_mesh(const std::string& path, double length_unit)
{
  if (!(length_unit > 0) || !std::isfinite(length_unit))
    refuse(path, "was given a file unit of ", length_unit, " m, but it must be above 0.");
  check_file(path);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene) {
    std::string reason = importer.GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    refuse(path, "cannot be read as a mesh (", reason, ").");
  }

  TriangleMesh mesh;
  std::map<Coordinates, int> known;
  for (unsigned int m = 0; m < scene->mNumMeshes; ++m)
    append(path, *scene->mMeshes[m], length_unit, known, mesh);
  drop_unused_vertices(mesh);
  if (mesh.triangles.empty()) refuse(path, "has no facet.");
  check_size(path, mesh, length_unit);
  check_surface(path, mesh);
  return mesh;
}

void write_stl(const std::string& path, const TriangleMesh& mesh)
{
  // 80 bytes of title, the number of facets, then normal, corners and two spare bytes for each.
  std::string bytes = "Interlock stone, metres";
  bytes.resize(80, ' ');
  const auto facets = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&facets), sizeof(facets));
  for (const auto& triangle : mesh.triangles) {
    const Vector3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                  &c = mesh.vertices[triangle[2]];
    append_floats(bytes, (b - a).cross(c - a).stableNormalized());
    for (const Vector3* corner : {&a, &b, &c}) append_floats(bytes, *corner);
    bytes.append(2, '\0');
  }
  const std::string temporary = path + ".tmp";
  std::ofstream file(temporary, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) refuse(path, "cannot be written.");
}
} // namespace interlock::dem
