#include "dem/scans/stl_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace interlock::dem
{
namespace
{
constexpr std::size_t head_size = 84, facet_size = 50; // [bytes]

// The file is little endian, as are all machines that this program is built for.
FacetData read_binary(const InputFile& file, std::size_t facets)
{
  FacetData data;
  data.single_precision = true;
  data.mesh.vertices.reserve(3 * facets);
  data.mesh.triangles.reserve(facets);
  for (std::size_t f = 0; f < facets; ++f) {
    float values[12]; // normal and three corners
    std::memcpy(values, file.bytes().data() + head_size + f * facet_size, sizeof(values));
    std::array<Vector3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const float* v = values + 3 * (k + 1);
      if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
        file.refuse("has a coordinate that is not a finite number in facet ", f + 1, ": (", v[0],
                    ", ", v[1], ", ", v[2], ").");
      corners[k] = Vector3(v[0], v[1], v[2]);
    }
    append_triangle(corners, data.mesh);
  }
  return data;
}

// What the head of a binary file promises, and what there is.
struct BinaryLength {
  std::uint64_t promised = 0, whole = 0; // facets
  std::string_view rest;                 // bytes behind the promised facets
};

BinaryLength binary_length(const InputFile& file)
{
  const std::string_view bytes = file.bytes();
  BinaryLength length;
  if (bytes.size() < head_size) return length;
  std::uint32_t facets = 0;
  std::memcpy(&facets, bytes.data() + 80, sizeof(facets));
  length.promised = facets;
  length.whole = (bytes.size() - head_size) / facet_size;
  if (length.promised <= length.whole)
    length.rest = bytes.substr(head_size + facet_size * length.promised);
  return length;
}

bool is_padding(std::string_view rest)
{
  return rest.size() < facet_size || rest.find_first_not_of(rest[0]) == std::string_view::npos;
}

// A binary file of another length than its head promises, where no facet can be lost.
FacetData read_odd_binary(const InputFile& file, const BinaryLength& length)
{
  const bool is_whole = (file.bytes().size() - head_size) % facet_size == 0 && length.whole > 0;
  std::ostringstream note;
  if (is_whole &&
      (length.promised == 0 || length.promised == std::numeric_limits<std::uint32_t>::max())) {
    note << "its head promises " << length.promised << " facets; those that fit its length, "
         << length.whole << ", were read";
    FacetData data = read_binary(file, length.whole);
    data.notes.push_back(note.str());
    return data;
  }
  if (length.promised > 0 && length.promised <= length.whole && is_padding(length.rest)) {
    note << length.rest.size() << " bytes behind its last facet were left out";
    FacetData data = read_binary(file, length.promised);
    data.notes.push_back(note.str());
    return data;
  }
  const std::uint64_t expected = head_size + facet_size * length.promised;
  file.refuse("cannot be read as a mesh: a binary STL file of ", length.promised, " facets has ",
              expected, " bytes, but it has ", file.bytes().size(),
              file.bytes().size() < expected ? "; it is cut short or no STL file."
                                             : "; it is damaged or no STL file.");
}
} // namespace

void append_triangle(const std::array<Vector3, 3>& corners, TriangleMesh& mesh)
{
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

bool is_binary_stl(const InputFile& file)
{
  const BinaryLength length = binary_length(file);
  return file.bytes().size() == head_size + facet_size * length.promised;
}

FacetData read_stl(const InputFile& file)
{
  const std::string_view bytes = file.bytes();
  const BinaryLength length = binary_length(file);
  if (is_binary_stl(file)) return read_binary(file, length.promised);
  const std::string_view start = bytes.substr(0, 1000);
  const bool is_text = std::none_of(start.begin(), start.end(),
                                    [](unsigned char c) { return c < 32 && !std::isspace(c); });
  if (is_text) return {read_text_stl(file), false, {}};
  if (bytes.size() < head_size)
    file.refuse("cannot be read as a mesh: it has ", bytes.size(),
                " bytes, but a binary STL file has at least ", head_size, ".");
  return read_odd_binary(file, length);
}
} // namespace interlock::dem
