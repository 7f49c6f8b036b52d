#include "fem/layouts/product.h"

#include "fem/layouts/biaxial_layout.h"
#include "fem/layouts/triaxial_layout.h"
#include "fem/layouts/uniaxial_layout.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace interlock::fem
{
namespace
{
// Layouts take shapes only. The first `n_first` lines get the section of one family, the rest that
// of the other.
std::vector<RibLine> with_sections(std::vector<RibLine> lines, int n_first, const RibProfile& first,
                                   const RibProfile& rest)
{
  for (int l = 0; l < static_cast<int>(lines.size()); ++l)
    lines[l].section = (l < n_first ? first : rest).section;
  return lines;
}

std::vector<RibLine> biaxial_lines(const GeogridProduct& product, int along, int across,
                                   const Eigen::Vector3d& front)
{
  BiaxialLayout layout;
  layout.origin = front;
  layout.apertures_along = along;
  layout.apertures_across = across;
  layout.pitch_along = product.pitch_along;
  layout.pitch_across = product.pitch_across;
  layout.elements_per_rib = product.elements_per_rib;
  layout.section_along = product.ribs_along.shape;
  layout.section_across = product.ribs_across.shape;
  return with_sections(rib_lines(layout), across + 1, product.ribs_along, product.ribs_across);
}

std::vector<RibLine> uniaxial_lines(const GeogridProduct& product, int along, int across,
                                    const Eigen::Vector3d& front)
{
  UniaxialLayout layout;
  layout.origin = front;
  layout.apertures_along = along;
  layout.apertures_across = across;
  layout.bar_pitch = product.pitch_along;
  layout.rib_pitch = product.pitch_across;
  layout.elements_per_rib = product.elements_per_rib;
  layout.rib = product.ribs_along.shape;
  layout.bar = product.ribs_across.shape;
  return with_sections(rib_lines(layout), across + 1, product.ribs_along, product.ribs_across);
}

std::vector<RibLine> triaxial_lines(const GeogridProduct& product, int along, int across,
                                    const Eigen::Vector3d& front)
{
  TriaxialLayout layout;
  layout.origin = front;
  layout.side = product.pitch_across;
  layout.length = along * std::sqrt(0.75) * layout.side; // a sheet's pitch along is rounded
  layout.width = across * product.pitch_across;
  layout.elements_per_rib = product.elements_per_rib;
  layout.section_across = product.ribs_across.shape;
  layout.section_rising = layout.section_falling = product.ribs_along.shape;
  return with_sections(rib_lines(layout), along + 1, product.ribs_across, product.ribs_along);
}
} // namespace

double GeogridProduct::mass_per_area() const
{
  // Rib lengths per area: of a triangular lattice two diagonals and one transverse rib of a side
  // each, in an area of side times height.
  const double along = pattern == Pattern::triaxial ? 2 / pitch_along : 1 / pitch_across;
  return along * ribs_along.section.line_density + ribs_across.section.line_density / pitch_along;
}

GeogridProduct turned(const GeogridProduct& product)
{
  if (product.pattern != Pattern::biaxial)
    throw std::invalid_argument("Only a biaxial geogrid is tested in both directions.");
  GeogridProduct other = product;
  std::swap(other.pitch_along, other.pitch_across);
  std::swap(other.ribs_along, other.ribs_across);
  return other;
}

std::vector<RibLine> lines_of_piece(const GeogridProduct& product, int apertures_along,
                                    int apertures_across, const Eigen::Vector3d& front)
{
  const auto lines_of = product.pattern == Pattern::biaxial    ? biaxial_lines
                        : product.pattern == Pattern::uniaxial ? uniaxial_lines
                                                               : triaxial_lines;
  return lines_of(product, apertures_along, apertures_across, front);
}

Lattice piece(const GeogridProduct& product, int apertures_along, int apertures_across)
{
  std::vector<RibLine> lines =
      lines_of_piece(product, apertures_along, apertures_across, Eigen::Vector3d::Zero());
  if (product.junctions.reach > 0) lines = thicken_junctions(lines, product.junctions);
  return Lattice(std::move(lines), product.junction_stiffness);
}

double width_of_piece(const GeogridProduct& product, int apertures_across)
{
  return (product.pattern == Pattern::triaxial ? apertures_across : apertures_across + 1) *
         product.pitch_across;
}
} // namespace interlock::fem
