// Polygon files (PLY), text and binary of either byte order: meshes, and clouds with normals.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

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
    // Names mean the same in capitals.
    bool is_named(const std::string& other) const;
    bool is_facet() const; // face or tristrips
    bool is_strip() const;
    // The first property with one of these names that is a list, or none; -1 if there is none.
    int column(std::initializer_list<const char*> names, bool is_list = false) const;
    std::string property_names() const; // "'x', 'y' and 'red'", for sentences
  };

  Format format = Format::text;
  std::vector<Element> elements;
  std::size_t data = 0; // position of the first byte behind the header, in the text of the file
  int data_line = 0;    // its line

  std::size_t rows(const std::string& element) const; // 0 if there is none
  bool has_facets() const;                            // rows of them, to be precise
  bool is_single(const Type& type) const; // whether the data keep values of it in single precision
  // Elements with rows that no reader asks for, as an insertion (", with its elements 'a' and 'b',
  // which are not read"); empty if there are none.
  std::string unknown_elements() const;
};

// What the components of a normal are called, by the paper of PLY's authors, PCL and others.
constexpr std::initializer_list<const char*> normal_names[3] = {
    {"nx", "normal_x", "normalx", "scalar_nx"},
    {"ny", "normal_y", "normaly", "scalar_ny"},
    {"nz", "normal_z", "normalz", "scalar_nz"}};

// The names in quotes, for sentences: "'a', 'b' and 'c'".
std::string listed(const std::vector<std::string>& names);

// Throws InputError when the header is none, has no vertices or has them behind the facets, or
// claims more rows than the bytes behind it can hold.
PlyHeader read_ply_header(const InputFile& file);

struct PlyData {
  TriangleMesh mesh;             // file units; vertices as in the file, facets cut into triangles
  std::vector<Vector3> normals;  // of a cloud, as in the file; empty unless it has all of them
  bool single_precision = false; // one of the coordinates is kept so
};

// Reads the elements `vertex` (x, y, z), `face` and `tristrips` (vertex_indices or vertex_index; -1
// ends a strip), and skips all others. What is not used may be anything ("nan"): other values, the
// normals of a mesh, and vertices that no facet uses. Throws InputError on any fault, naming line
// (text) or row (binary).
PlyData read_ply(const InputFile& file, const PlyHeader& header);
} // namespace interlock::dem
