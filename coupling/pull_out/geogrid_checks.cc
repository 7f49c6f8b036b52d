#include "coupling/pull_out/geogrid_checks.h"

#include "coupling/parameters/product_declarations.h"

#include <algorithm>
#include <cstddef>

namespace interlock::coupling
{
namespace
{
// Room for decimal lengths such as 3 x 0.065 + 0.005 that have no exact binary form [m].
constexpr double length_tolerance = 1e-9;

// Of the ribs of a product, or of the entries [m].
struct RibSizes {
  double pitch_along = 0, pitch_across = 0;
  double width_along = 0, width_across = 0;
  double thickest = 0, thinnest = 0; // junctions included in the first one
};

RibSizes sizes_of(const GeogridParameters& g)
{
  if (!g.product)
    return {g.pitch_along, g.pitch_across,  g.rib_width,
            g.rib_width,   g.rib_thickness, g.rib_thickness};
  const ProductParameters& p = *g.product;
  const double junction = p.junction_reach > 0 ? p.junction_thickness : 0;
  return {p.pitch_along,
          p.pitch_across,
          p.along.width,
          p.across.width,
          std::max({p.along.thickness, p.across.thickness, junction}),
          std::min(p.along.thickness, p.across.thickness)};
}

void check_box(const BoxParameters& box, const RibSizes& ribs, ParameterProblems& problems)
{
  if (box.slot_height >= 0.5 * box.height)
    problems.add("Box/Slot height", "The slot is ", box.slot_height,
                 " m high, but must be lower than half the box, ", 0.5 * box.height, " m.");
  if (box.slot_height <= ribs.thickest)
    problems.add("Box/Slot height", "The slot is ", box.slot_height,
                 " m high, but must be higher than the ribs, ", ribs.thickest,
                 " m, to let them out.");
}

void check_lattice(const GeogridParameters& geogrid, const RibSizes& ribs, const BoxParameters& box,
                   ParameterProblems& problems)
{
  const double width = geogrid.apertures_across * ribs.pitch_across + ribs.width_along;
  if (width > box.width + length_tolerance)
    problems.add("Geogrid/Apertures across", "The geogrid is ", width, " m wide (",
                 geogrid.apertures_across, " x ", ribs.pitch_across, " m and one rib of ",
                 ribs.width_along, " m), but the box is only ", box.width, " m wide.");
  const double length = geogrid.apertures_along * ribs.pitch_along + ribs.width_across;
  if (length > box.length + length_tolerance)
    problems.add("Geogrid/Apertures along", "The geogrid is ", length, " m long (",
                 geogrid.apertures_along, " x ", ribs.pitch_along, " m and one rib of ",
                 ribs.width_across, " m), but the box is only ", box.length, " m long.");
}

void check_cut(const GeogridParameters& geogrid, const RibSizes& ribs, const BoxParameters& box,
               ParameterProblems& problems)
{
  if (geogrid.cut_width == 0) return;
  const double whole = geogrid.apertures_across * ribs.pitch_across;
  if (geogrid.cut_width < whole || geogrid.cut_width >= whole + ribs.pitch_across)
    problems.add("Geogrid/Cut width", "The sheet is cut at a width of ", geogrid.cut_width,
                 " m, but ", geogrid.apertures_across, " apertures across are ", whole,
                 " m wide, and from ", whole + ribs.pitch_across,
                 " m on there is room for another.");
  else if (geogrid.cut_width > box.width)
    problems.add("Geogrid/Cut width", "The sheet is cut at a width of ", geogrid.cut_width,
                 " m, but the box is only ", box.width, " m wide.");
}

// A box that was made longer or wider and kept the geogrid of the smaller one.
void check_cover(const GeogridParameters& geogrid, const RibSizes& ribs, const BoxParameters& box,
                 ParameterProblems& problems)
{
  const auto check = [&](const char* entry, int apertures, double pitch, double rib_width,
                         double inside, const char* direction) {
    const double gap = inside - apertures * pitch - rib_width;
    if (gap > 2 * pitch)
      problems.add_unusual(entry, "The geogrid ends ", gap,
                           " m before the walls of the box, which is ", inside, " m ", direction,
                           "; ", apertures + static_cast<int>(gap / pitch),
                           " apertures would fill it.");
  };
  check("Geogrid/Apertures along", geogrid.apertures_along, ribs.pitch_along, ribs.width_across,
        box.length, "long");
  check("Geogrid/Apertures across", geogrid.apertures_across, ribs.pitch_across, ribs.width_along,
        box.width, "wide");
}

// What a product says, the entries of the section Geogrid must not say again.
void check_left_to_product(const GeogridParameters& g, ParameterProblems& problems)
{
  struct Entry {
    const char* key;
    double value, left; // what it is where it is left alone
  };
  for (const Entry& entry :
       {Entry{"Geogrid/Pitch along", g.pitch_along, 0},
        {"Geogrid/Pitch across", g.pitch_across, 0},
        {"Geogrid/Rib width", g.rib_width, 0},
        {"Geogrid/Rib thickness", g.rib_thickness, 0},
        {"Geogrid/Youngs modulus", g.youngs_modulus, 0},
        {"Geogrid/Poisson ratio", g.poisson_ratio, 0},
        {"Geogrid/Density", g.density, 0},
        {"Geogrid/Elements per rib", static_cast<double>(g.elements_per_rib), 8}})
    if (entry.value != entry.left)
      problems.add(entry.key, "It is ", entry.value,
                   ", but the section Product says what the ribs are; leave it out, or set it to ",
                   entry.left, ".");
}

void check_given_without_product(const GeogridParameters& g, ParameterProblems& problems)
{
  const auto check = [&](const char* entry, double value) {
    if (value <= 0)
      problems.add(entry, "It is ", value,
                   ", but must be greater than 0 where no Geogrid/Product says what the ribs are.");
  };
  check("Geogrid/Pitch along", g.pitch_along);
  check("Geogrid/Pitch across", g.pitch_across);
  check("Geogrid/Rib width", g.rib_width);
  check("Geogrid/Rib thickness", g.rib_thickness);
  check("Geogrid/Youngs modulus", g.youngs_modulus);
  check("Geogrid/Density", g.density);
}

void check_ribs(const GeogridParameters& geogrid, const RibSizes& ribs, ParameterProblems& problems)
{
  const double pitch = std::min(ribs.pitch_along, ribs.pitch_across);
  if (!geogrid.product && geogrid.rib_width >= pitch)
    problems.add("Geogrid/Rib width", "The ribs are ", geogrid.rib_width,
                 " m wide, but must be narrower than their smallest distance, ", pitch, " m.");
  const double half = 0.5 * std::min({ribs.thinnest, ribs.width_along, ribs.width_across});
  if (geogrid.edge_rounding > half + length_tolerance)
    problems.add(
        "Geogrid/Edge rounding", "The edges of the ribs are rounded with ", geogrid.edge_rounding,
        " m, but half the thickness and half the width of a rib allow at most ", half, " m.");
}

// True where the ribs have sizes to go on with.
bool check_source_of_ribs(const GeogridParameters& geogrid, ParameterProblems& problems)
{
  const std::size_t before = problems.size();
  if (geogrid.product) {
    check_left_to_product(geogrid, problems);
    check_product(*geogrid.product, problems);
    if (geogrid.product->junction_stiffness > 0)
      problems.add("Product/Junction stiffness", "It is ", geogrid.product->junction_stiffness,
                   " N m/rad, but junctions of the geogrid of a pull-out are rigid: set it to 0.");
  } else {
    check_given_without_product(geogrid, problems);
  }
  return problems.size() == before;
}
} // namespace

void check_geogrid(const GeogridParameters& geogrid, const BoxParameters& box,
                   ParameterProblems& problems)
{
  if (!check_source_of_ribs(geogrid, problems)) return;
  const RibSizes ribs = sizes_of(geogrid);
  check_box(box, ribs, problems);
  if (geogrid.lattice_file.empty()) {
    check_lattice(geogrid, ribs, box, problems);
    check_cut(geogrid, ribs, box, problems);
    check_cover(geogrid, ribs, box, problems);
  } else if (geogrid.cut_width > 0) {
    problems.add("Geogrid/Cut width", "It is ", geogrid.cut_width,
                 " m, but the sheet of a lattice file is drawn with its edges: set it to 0.");
  }
  check_ribs(geogrid, ribs, problems);
}

double length_of_geogrid(const GeogridParameters& geogrid)
{
  return geogrid.apertures_along * sizes_of(geogrid).pitch_along;
}
} // namespace interlock::coupling
