// Polygon files (PLY), text and binary of either byte order: meshes, and clouds with normals.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

#include <cstdint>

namespace interlock::dem
{
// What the header says, before any of the data is read.
struct PlyHeader {
  enum class Format { text, little_endian, big_endian };
  // Bytes of a binary value; text files name the same types.
  struct Type {
    int size = 0;
    enum Kind { signed_integer, unsigned_integer, floating } kind = floating;
  };
  struct Property {
    std::string name;
    Type type, count; // of a list: type of the entries, and of their number; else count.size is 0
    bool is_list() const { return count.size > 0; }
  };
  struct Element {
    std::string name;
    std::size_t rows = 0;
    std::vector<Property> properties;
    int column(const std::string& property) const; // -1 if there is none
  };

  Format format = Format::text;
  std::vector<Element> elements;
  std::size_t data = 0; // position of the first byte behind the header
  int data_line = 0;    // its line

  std::size_t rows(const std::string& element) const; // 0 if there is none
};

// Throws InputError when the header is none, or claims more rows than the bytes behind it can hold.
PlyHeader read_ply_header(const InputFile& file);

struct PlyData {
  TriangleMesh mesh;            // file units; vertices as in the file, facets cut into triangles
  std::vector<Vector3> normals; // as in the file; empty unless the vertices have nx, ny and nz
};

// Reads the elements `vertex` (x, y, z) and `face` (vertex_indices or vertex_index), and skips all
// others. Throws InputError on any fault, naming line (text) or row (binary).
PlyData read_ply(const InputFile& file, const PlyHeader& header);
} // namespace interlock::dem
