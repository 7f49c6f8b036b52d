#include "fem/layouts/junction_zones.h"

#include "fem/lattice/lattice.h"
#include "fem/layouts/layout_checks.h"
#include "fem/ribs/number_text.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
// Vertices of each line that another line has too.
std::vector<std::vector<int>> junction_vertices(const std::vector<RibLine>& lines)
{
  const Lattice lattice(lines);
  std::vector<std::set<int>> lines_at(lattice.n_nodes());
  for (int e = 0; e < lattice.n_elements(); ++e)
    for (const int node : lattice.element(e).node) lines_at[node].insert(lattice.element(e).line);
  std::vector<std::vector<int>> vertices(lines.size());
  for (int l = 0; l < lattice.n_lines(); ++l) {
    const std::vector<int> nodes = lattice.nodes_of_line(l);
    for (std::size_t v = 0; v < nodes.size(); ++v)
      if (lines_at[nodes[v]].size() > 1) vertices[l].push_back(static_cast<int>(v));
  }
  return vertices;
}

RibProfile thickened(const RibProfile& rib, double thickness)
{
  if (rib.shape.thickness > thickness)
    throw std::invalid_argument("The thickness of junctions is " + number_text(thickness) +
                                " m but must be at least that of their ribs, " +
                                number_text(rib.shape.thickness) + " m.");
  RibProfile zone = rib;
  zone.shape.thickness = thickness;
  if (rib.shape.form == SectionForm::circle) zone.shape.width = thickness;
  const BeamSection thin = beam_section(rib.shape), thick = beam_section(zone.shape);
  for (double BeamSection::*member :
       {&BeamSection::axial, &BeamSection::shear_2, &BeamSection::shear_3, &BeamSection::torsion,
        &BeamSection::bending_2, &BeamSection::bending_3, &BeamSection::line_density,
        &BeamSection::rotary_1, &BeamSection::rotary_2, &BeamSection::rotary_3})
    zone.section.*member *= thick.*member / thin.*member;
  zone.section.yield_force *= thick.axial / thin.axial;
  return zone;
}

// Distance of each vertex from the first one along the line [m].
std::vector<double> arc_lengths(const RibLine& line)
{
  std::vector<double> s{0};
  for (std::size_t p = 1; p < line.points.size(); ++p)
    s.push_back(s.back() + (line.points[p] - line.points[p - 1]).norm());
  return s;
}

RibLine thicken_line(const RibLine& line, const std::vector<int>& junctions,
                     const JunctionZone& zone)
{
  const std::vector<double> s = arc_lengths(line);
  RibLine result = line;
  result.points = {line.points.front()};
  result.profiles.clear();
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    // Borders of zones inside this element, as shares of its length; none closer to a vertex than
    // rounding.
    const double length = s[i + 1] - s[i];
    std::vector<double> cuts{0, 1};
    for (const int j : junctions)
      for (const double border : {s[j] - zone.reach, s[j] + zone.reach}) {
        const double share = (border - s[i]) / length;
        if (share > 1e-6 && share < 1 - 1e-6) cuts.push_back(share);
      }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(
        std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a <= 1e-6; }),
        cuts.end());

    const RibProfile own{shape_of_element(line, static_cast<int>(i)),
                         section_of_element(line, static_cast<int>(i))};
    for (std::size_t c = 1; c < cuts.size(); ++c) {
      const double middle = s[i] + 0.5 * (cuts[c - 1] + cuts[c]) * length;
      const bool inside = std::any_of(junctions.begin(), junctions.end(),
                                      [&](int j) { return std::abs(middle - s[j]) < zone.reach; });
      result.profiles.push_back(inside ? thickened(own, zone.thickness) : own);
      // The vertex itself to the last digit, so that junctions stay junctions.
      result.points.push_back(cuts[c] == 1 ? line.points[i + 1]
                                           : line.points[i] +
                                                 cuts[c] * (line.points[i + 1] - line.points[i]));
    }
  }
  return result;
}
} // namespace

std::vector<RibLine> thicken_junctions(const std::vector<RibLine>& lines, const JunctionZone& zone)
{
  require_positive(zone.reach, "reach of junctions");
  require_positive(zone.thickness, "thickness of junctions");
  const std::vector<std::vector<int>> junctions = junction_vertices(lines);
  std::vector<RibLine> result;
  for (std::size_t l = 0; l < lines.size(); ++l)
    result.push_back(thicken_line(lines[l], junctions[l], zone));
  return result;
}
} // namespace interlock::fem
