#include "fem/layouts/biaxial_layout.h"

#include "fem/layouts/layout_checks.h"

namespace interlock::fem
{
std::vector<RibLine> rib_lines(const BiaxialLayout& layout)
{
  require_positive(layout.apertures_along, "number of apertures along the pull");
  require_positive(layout.apertures_across, "number of apertures across the pull");
  require_positive(layout.pitch_along, "pitch along the pull");
  require_positive(layout.pitch_across, "pitch across the pull");
  require_positive(layout.elements_per_rib, "number of elements per rib");
  require_gap(layout.section_along.width, layout.pitch_across, "width of ribs along the pull");
  require_gap(layout.section_across.width, layout.pitch_along, "width of ribs across the pull");

  // One expression for every vertex, so that vertices of crossing lines are equal to the last
  // digit.
  const int n = layout.elements_per_rib;
  const auto vertex = [&](int i, int j) -> Eigen::Vector3d {
    const double x = layout.pitch_along * i / n;
    const double y =
        layout.pitch_across * (static_cast<double>(j) / n - 0.5 * layout.apertures_across);
    return layout.origin + Eigen::Vector3d(x, y, 0);
  };

  RibLine along, across;
  along.shape = layout.section_along;
  along.section = beam_section(layout.section_along);
  across.shape = layout.section_across;
  across.section = beam_section(layout.section_across);

  std::vector<RibLine> lines;
  for (int b = 0; b <= layout.apertures_across; ++b) {
    lines.push_back(along);
    for (int i = 0; i <= n * layout.apertures_along; ++i)
      lines.back().points.push_back(vertex(i, n * b));
  }
  for (int a = 0; a <= layout.apertures_along; ++a) {
    lines.push_back(across);
    for (int j = 0; j <= n * layout.apertures_across; ++j)
      lines.back().points.push_back(vertex(n * a, j));
  }
  return lines;
}
} // namespace interlock::fem
