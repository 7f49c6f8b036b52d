// Writing stones: write_stl of triangle_mesh.h.
#include "dem/atomic_files.h"
#include "dem/input_error.h"
#include "dem/meshes/triangle_mesh.h"

#include <cstdint>

namespace interlock::dem
{
namespace
{
void append_floats(std::string& bytes, const Vector3& vector)
{
  const Eigen::Vector3f single = vector.cast<float>();
  bytes.append(reinterpret_cast<const char*>(single.data()), 3 * sizeof(float));
}
} // namespace

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
  if (!write_atomically(path, bytes))
    throw InputError("Stone mesh '" + path + "' cannot be written.");
}
} // namespace interlock::dem
