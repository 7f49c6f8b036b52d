#include "coupling/parameters/geogrid_product.h"

#include "dem/input_error.h"
#include "fem/gmsh/gmsh_file.h"
#include "fem/ribs/tension_law.h"

#include <cmath>
#include <map>

namespace interlock::coupling
{
namespace
{
// Ribs of this Young's modulus, or those whose sheet has this stiffness and strength: `spacing` is
// the width of the sheet that one rib carries, `length` that from junction to junction. Thicker
// zones strain less, so the rib between them is made softer to small strains.
fem::RibProfile product_ribs(const ProductRibsParameters& parameters,
                             const ProductParameters& product, double spacing, double length)
{
  fem::RibProfile ribs;
  ribs.shape = {parameters.width, parameters.thickness, parameters.youngs_modulus,
                product.poisson_ratio, product.density};
  fem::TensionLaw law;
  if (parameters.stiffness_2 > 0) {
    const double stiffness_5 =
        parameters.stiffness_5 > 0 ? parameters.stiffness_5 : parameters.stiffness_2;
    const double zones = product.junction_reach > 0 ? 2 * product.junction_reach / length : 0;
    const double thin = zones > 0 ? parameters.thickness / product.junction_thickness : 1;
    law = fem::tension_law(parameters.stiffness_2, stiffness_5, spacing * (1 - zones * (1 - thin)));
    ribs.shape.youngs_modulus = law.axial / fem::area(ribs.shape);
  }
  ribs.section = fem::beam_section(ribs.shape);
  ribs.section.softening = law.softening;
  ribs.section.yield_force =
      parameters.strength > 0 ? spacing * parameters.strength : law.yield_force;
  return ribs;
}
} // namespace

fem::GeogridProduct geogrid_product(const ProductParameters& parameters)
{
  fem::GeogridProduct product;
  product.pitch_along = parameters.pitch_along;
  product.pitch_across = parameters.pitch_across;
  product.elements_per_rib = parameters.elements_per_rib;
  product.junctions = {parameters.junction_reach, parameters.junction_thickness};
  if (parameters.junction_stiffness > 0)
    product.junction_stiffness.in_plane = parameters.junction_stiffness;
  product.pattern = parameters.pattern == "triaxial"   ? fem::Pattern::triaxial
                    : parameters.pattern == "uniaxial" ? fem::Pattern::uniaxial
                                                       : fem::Pattern::biaxial;
  // A sheet of triangles of ribs EA has the stiffness 2 EA/(sqrt(3) side) in every direction.
  const double spacing = std::sqrt(0.75) * parameters.pitch_across;
  const bool triaxial = product.pattern == fem::Pattern::triaxial;
  product.ribs_along =
      triaxial ? product_ribs(parameters.along, parameters, spacing, parameters.pitch_across)
               : product_ribs(parameters.along, parameters, parameters.pitch_across,
                              parameters.pitch_along);
  product.ribs_across =
      product_ribs(parameters.across, parameters, triaxial ? spacing : parameters.pitch_along,
                   parameters.pitch_across);
  return product;
}

fem::GeogridProduct geogrid_product(const GeogridParameters& parameters)
{
  if (parameters.product) return geogrid_product(*parameters.product);
  ProductParameters product;
  product.pitch_along = parameters.pitch_along;
  product.pitch_across = parameters.pitch_across;
  product.along.width = parameters.rib_width;
  product.along.thickness = parameters.rib_thickness;
  product.along.youngs_modulus = parameters.youngs_modulus;
  product.across = product.along;
  product.poisson_ratio = parameters.poisson_ratio;
  product.density = parameters.density;
  product.elements_per_rib = parameters.elements_per_rib;
  return geogrid_product(product);
}

fem::GmshLattice drawn_lattice(const std::string& name, double length_unit,
                               const fem::GeogridProduct& product)
{
  const fem::GmshFile drawn = fem::read_gmsh_file(name);
  std::map<std::string, fem::GmshSection> sections;
  for (const fem::GmshFile::Line& line : drawn.lines)
    if (line.group == "along")
      sections[line.group].profile = product.ribs_along;
    else if (line.group == "across")
      sections[line.group].profile = product.ribs_across;
    else
      throw InputError(
          "The lattice file \"" + name + "\" has lines " +
          (line.group.empty() ? "in no named group" : "in a group \"" + line.group + "\"") +
          ", but groups of lines must be called \"along\" or \"across\" (physical "
          "names in Gmsh) and take those ribs of the product.");
  return fem::gmsh_lattice(drawn, sections, length_unit);
}
} // namespace interlock::coupling
