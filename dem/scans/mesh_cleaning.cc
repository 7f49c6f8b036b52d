#include "dem/scans/mesh_cleaning.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace interlock::dem
{
namespace
{
// Numbers points by place, with open addressing: a std::unordered_map takes five times as long and
// three times the memory for the millions of corners of an STL file.
class VertexNumbers
{
public:
  explicit VertexNumbers(std::size_t most) : slots_(power_of_two(most + most / 2 + 2), -1) {}

  int operator()(const Vector3& x)
  {
    for (std::size_t slot = hash(x);; ++slot) {
      int& number = slots_[slot & (slots_.size() - 1)];
      if (number < 0) {
        number = static_cast<int>(points.size());
        points.push_back(x);
      }
      if (points[number] == x) return number;
    }
  }

  std::vector<Vector3> points;

private:
  static std::size_t power_of_two(std::size_t least)
  {
    std::size_t size = 1;
    while (size < least) size *= 2;
    return size;
  }

  static std::size_t hash(const Vector3& x)
  {
    // Steele, Lea and Flood, OOPSLA (2014): the finaliser of SplitMix64. Adding zero makes -0 and 0
    // alike.
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      const double value = x[k] + 0.;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      h = (h ^ bits) + 0x9E3779B97F4A7C15u;
      h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
      h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
      h ^= h >> 31;
    }
    return h;
  }

  std::vector<int> slots_;
};

// The corners, rotated so that the smallest comes first: equal for facets of the same sense.
std::array<int, 3> rotated(std::array<int, 3> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}
} // namespace

int merge_vertices(TriangleMesh& mesh)
{
  const std::size_t before = mesh.vertices.size();
  VertexNumbers numbers(before);
  std::vector<int> number(before, -1); // old to new
  for (auto& triangle : mesh.triangles)
    for (int& v : triangle) {
      if (number[v] < 0) number[v] = numbers(mesh.vertices[v]);
      v = number[v];
    }
  mesh.vertices = std::move(numbers.points);
  return static_cast<int>(before - mesh.vertices.size());
}

int drop_degenerate_facets(TriangleMesh& mesh)
{
  const std::size_t before = mesh.triangles.size();
  const auto is_degenerate = [](const std::array<int, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_degenerate),
                       mesh.triangles.end());
  return static_cast<int>(before - mesh.triangles.size());
}

int drop_duplicate_facets(TriangleMesh& mesh)
{
  // Facets by their smallest corner: a handful each, so that sorting each handful is quick.
  std::vector<int> start(mesh.vertices.size() + 1, 0), order(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) ++start[rotated(triangle)[0] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (std::size_t t = 0; t < order.size(); ++t)
    order[next[rotated(mesh.triangles[t])[0]]++] = static_cast<int>(t);

  const auto corners = [&](int t) { return rotated(mesh.triangles[t]); };
  std::vector<char> is_copy(mesh.triangles.size(), 0);
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto first = order.begin() + start[v], last = order.begin() + start[v + 1];
    std::sort(first, last, [&](int a, int b) {
      return std::make_pair(corners(a), a) < std::make_pair(corners(b), b);
    });
    for (auto t = first; t != last; ++t)
      if (t != first && corners(*t) == corners(*(t - 1))) is_copy[*t] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!is_copy[t]) mesh.triangles[kept++] = mesh.triangles[t];
  const int dropped = static_cast<int>(mesh.triangles.size() - kept);
  mesh.triangles.resize(kept);
  return dropped;
}
} // namespace interlock::dem
