#include "fem/layouts/uniaxial_layout.h"

#include "fem/layouts/layout_checks.h"

namespace interlock::fem
{
namespace
{
void check(const UniaxialLayout& layout)
{
  require_positive(layout.apertures_along, "number of apertures along the load");
  require_positive(layout.apertures_across, "number of apertures across the load");
  require_positive(layout.bar_pitch, "pitch of bars");
  require_positive(layout.rib_pitch, "pitch of ribs");
  require_positive(layout.elements_per_rib, "number of elements per rib");
  require_positive(layout.elements_per_bar, "number of elements per bar");
  require_gap(layout.rib.width, layout.rib_pitch, "width of ribs");
  require_gap(layout.bar.width, layout.bar_pitch, "width of bars");
}

RibLine line_of(const RibSection& section)
{
  RibLine line;
  line.shape = section;
  line.section = beam_section(section);
  return line;
}
} // namespace

std::vector<RibLine> rib_lines(const UniaxialLayout& layout)
{
  check(layout);
  // Fractions of whole numbers, so that vertices of ribs and bars are equal to the last digit.
  const int n = layout.elements_per_rib, m = layout.elements_per_bar;
  const auto vertex = [&](int i, int j) -> Eigen::Vector3d {
    const double x = layout.bar_pitch * (static_cast<double>(i) / n);
    const double y =
        layout.rib_pitch * (static_cast<double>(j) / m - 0.5 * layout.apertures_across);
    return layout.origin + Eigen::Vector3d(x, y, 0);
  };

  std::vector<RibLine> lines;
  for (int b = 0; b <= layout.apertures_across; ++b) {
    lines.push_back(line_of(layout.rib));
    for (int i = 0; i <= n * layout.apertures_along; ++i)
      lines.back().points.push_back(vertex(i, m * b));
  }
  for (int a = 0; a <= layout.apertures_along; ++a) {
    lines.push_back(line_of(layout.bar));
    for (int j = 0; j <= m * layout.apertures_across; ++j)
      lines.back().points.push_back(vertex(n * a, j));
  }
  return lines;
}
} // namespace interlock::fem
