#include "fem/product.h"

#include <utility>

namespace interlock::fem
{
double GeogridProduct::mass_per_area() const
{
  return ribs_along.section.line_density / pitch_across +
         ribs_across.section.line_density / pitch_along;
}

GeogridProduct turned(const GeogridProduct& product)
{
  GeogridProduct other = product;
  std::swap(other.pitch_along, other.pitch_across);
  std::swap(other.ribs_along, other.ribs_across);
  return other;
}

Lattice piece(const GeogridProduct& product, int apertures_along, int apertures_across)
{
  BiaxialLayout layout;
  layout.apertures_along = apertures_along;
  layout.apertures_across = apertures_across;
  layout.pitch_along = product.pitch_along;
  layout.pitch_across = product.pitch_across;
  layout.elements_per_rib = product.elements_per_rib;
  layout.section_along = product.ribs_along.shape;
  layout.section_across = product.ribs_across.shape;
  std::vector<RibLine> lines = rib_lines(layout);
  for (int l = 0; l < static_cast<int>(lines.size()); ++l)
    lines[l].section = (l <= apertures_across ? product.ribs_along : product.ribs_across).section;
  return Lattice(std::move(lines));
}
} // namespace interlock::fem
