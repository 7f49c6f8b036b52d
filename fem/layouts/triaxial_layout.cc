#include "fem/layouts/triaxial_layout.h"

#include "fem/layouts/layout_checks.h"
#include "fem/ribs/number_text.h"

#include <stdexcept>

namespace interlock::fem
{
namespace
{
// Junctions have integer coordinates: row i at i triangle heights along x, and k half sides along
// y. They exist for 0 <= i <= rows, |k| <= half_width, where k and half_width are both even or both
// odd in even rows and differ in odd rows.
struct TriangularGrid {
  int rows, half_width;
  bool has(int i, int k) const
  {
    return i >= 0 && i <= rows && std::abs(k) <= half_width && (k - half_width - i) % 2 == 0;
  }
};

void check(const TriaxialLayout& layout, double height)
{
  require_positive(layout.length, "length");
  require_positive(layout.width, "width");
  require_positive(layout.side, "side of the triangles");
  require_positive(layout.elements_per_rib, "number of elements per rib");
  // Inside the three ribs an equilateral triangle is left; the distances of any point from the
  // sides of such a triangle add up to its height (Viviani).
  const double half_widths =
      (layout.section_across.width + layout.section_rising.width + layout.section_falling.width) /
      2;
  require_gap(half_widths, height, "sum of the three half rib widths");
}

TriangularGrid grid_in_rectangle(const TriaxialLayout& layout, double height)
{
  // A rectangle of exactly so many triangles shall hold them in spite of rounding.
  const auto whole = [](double ratio) { return static_cast<int>(std::floor(ratio + 1e-9)); };
  const TriangularGrid grid{whole(layout.length / height), whole(layout.width / layout.side)};
  if (grid.rows < 1 || grid.half_width < 1)
    throw std::invalid_argument("A geogrid of " + number_text(layout.length) + " m x " +
                                number_text(layout.width) +
                                " m has no room for a triangle of height " + number_text(height) +
                                " m and side " + number_text(layout.side) + " m.");
  return grid;
}
} // namespace

std::vector<RibLine> rib_lines(const TriaxialLayout& layout)
{
  const double height = layout.side * std::sqrt(0.75);
  check(layout, height);
  const TriangularGrid grid = grid_in_rectangle(layout, height);

  std::vector<RibLine> lines;
  const int n = layout.elements_per_rib;
  // Follows the ribs from junction (i, k) in steps (di, dk) as far as there are junctions.
  const auto add_line = [&](int i, int k, int di, int dk, const RibLine& family) {
    lines.push_back(family);
    // One expression for every vertex, so that vertices of crossing lines are equal to the last
    // digit.
    const auto add_vertex = [&](int step) {
      const double x = height * (i * n + di * step) / n;
      const double y = 0.5 * layout.side * (k * n + dk * step) / n;
      lines.back().points.push_back(layout.origin + Eigen::Vector3d(x, y, 0));
    };
    add_vertex(0);
    for (int rib = 0; grid.has(i + (rib + 1) * di, k + (rib + 1) * dk); ++rib)
      for (int step = 1; step <= n; ++step) add_vertex(rib * n + step);
  };
  const auto add_family = [&](int di, int dk, const RibSection& section) {
    RibLine family;
    family.shape = section;
    family.section = beam_section(section);
    for (int i = 0; i <= grid.rows; ++i)
      for (int k = -grid.half_width; k <= grid.half_width; ++k)
        if (grid.has(i, k) && !grid.has(i - di, k - dk) && grid.has(i + di, k + dk))
          add_line(i, k, di, dk, family);
  };
  add_family(0, 2, layout.section_across);
  add_family(1, 1, layout.section_rising);
  add_family(1, -1, layout.section_falling);
  return lines;
}
} // namespace interlock::fem
