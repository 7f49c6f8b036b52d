#include "coupling/pull_out/pull_out_checks.h"

#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_declarations.h"

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// Room for decimal lengths such as 3 x 0.065 + 0.005 that have no exact binary form [m].
constexpr double length_tolerance = 1e-9;

void check_box(const BoxParameters& box, const GeogridParameters& geogrid,
               ParameterProblems& problems)
{
  if (box.slot_height >= 0.5 * box.height)
    problems.add("Box/Slot height", "The slot is ", box.slot_height,
                 " m high, but must be lower than half the box, ", 0.5 * box.height, " m.");
  if (box.slot_height <= geogrid.rib_thickness)
    problems.add("Box/Slot height", "The slot is ", box.slot_height,
                 " m high, but must be higher than the ribs, ", geogrid.rib_thickness,
                 " m, to let them out.");
}

void check_lattice(const GeogridParameters& geogrid, const BoxParameters& box,
                   ParameterProblems& problems)
{
  const double width = geogrid.apertures_across * geogrid.pitch_across + geogrid.rib_width;
  if (width > box.width + length_tolerance)
    problems.add("Geogrid/Apertures across", "The geogrid is ", width, " m wide (",
                 geogrid.apertures_across, " x ", geogrid.pitch_across, " m and one rib of ",
                 geogrid.rib_width, " m), but the box is only ", box.width, " m wide.");
  const double length = geogrid.apertures_along * geogrid.pitch_along + geogrid.rib_width;
  if (length > box.length + length_tolerance)
    problems.add("Geogrid/Apertures along", "The geogrid is ", length, " m long (",
                 geogrid.apertures_along, " x ", geogrid.pitch_along, " m and one rib of ",
                 geogrid.rib_width, " m), but the box is only ", box.length, " m long.");
}

// A box that was made longer or wider and kept the geogrid of the smaller one.
void check_cover(const GeogridParameters& geogrid, const BoxParameters& box,
                 ParameterProblems& problems)
{
  const auto check = [&](const char* entry, int apertures, double pitch, double inside,
                         const char* direction) {
    const double gap = inside - apertures * pitch - geogrid.rib_width;
    if (gap > 2 * pitch)
      problems.add_unusual(entry, "The geogrid ends ", gap,
                           " m before the walls of the box, which is ", inside, " m ", direction,
                           "; ", apertures + static_cast<int>(gap / pitch),
                           " apertures would fill it.");
  };
  check("Geogrid/Apertures along", geogrid.apertures_along, geogrid.pitch_along, box.length,
        "long");
  check("Geogrid/Apertures across", geogrid.apertures_across, geogrid.pitch_across, box.width,
        "wide");
}

// Pouring them takes days.
void check_volume(const BoxParameters& box, ParameterProblems& problems)
{
  constexpr double largest = 4; // [m3]
  const double volume = box.length * box.width * box.height;
  if (volume > largest)
    problems.add_unusual("Box/Length", "The box holds ", volume,
                         " m3, some 25000 stones of railway ballast in each.");
}

void check_ribs(const GeogridParameters& geogrid, ParameterProblems& problems)
{
  const double pitch = std::min(geogrid.pitch_along, geogrid.pitch_across);
  if (geogrid.rib_width >= pitch)
    problems.add("Geogrid/Rib width", "The ribs are ", geogrid.rib_width,
                 " m wide, but must be narrower than their smallest distance, ", pitch, " m.");
  const double half = 0.5 * std::min(geogrid.rib_thickness, geogrid.rib_width);
  if (geogrid.edge_rounding > half + length_tolerance)
    problems.add(
        "Geogrid/Edge rounding", "The edges of the ribs are rounded with ", geogrid.edge_rounding,
        " m, but half the thickness and half the width of a rib allow at most ", half, " m.");
}

void check_surcharge(const SurchargeParameters& surcharge, const BoxParameters& box,
                     ParameterProblems& problems)
{
  if (surcharge.force <= 0 || surcharge.kind != "spheres") return;
  const double largest = 0.5 * std::min(box.length, box.width);
  if (surcharge.sphere_radius <= 0 || surcharge.sphere_radius > largest)
    problems.add("Surcharge/Sphere radius", "The spheres of the surcharge have a radius of ",
                 surcharge.sphere_radius, " m, but it must be greater than 0 and at most ", largest,
                 " m to fit into the box.");
}

void check_pull(const PullParameters& pull, const GeogridParameters& geogrid,
                ParameterProblems& problems)
{
  const double length = geogrid.apertures_along * geogrid.pitch_along;
  if (pull.distance > length + length_tolerance)
    problems.add("Pull/Distance", "The geogrid is pulled over ", pull.distance, " m, but only ",
                 length, " m of it lie in the box.");
  const double ramp = 0.5 * pull.speed * pull.ramp_time;
  if (ramp > pull.distance)
    problems.add("Pull/Ramp time", "The pull needs ", ramp, " m to reach full speed in ",
                 pull.ramp_time, " s, but is only ", pull.distance, " m long.");
}

void check_frames(const std::vector<double>& frames_at, const PullParameters& pull,
                  ParameterProblems& problems)
{
  for (const double place : frames_at)
    if (place > pull.distance)
      problems.add("Output/Frames at", "A frame is asked for at ", place,
                   " m, but the geogrid is pulled over ", pull.distance, " m only.");
}
} // namespace

std::vector<ParameterProblem> check_pull_out(const PullOutParameters& parameters)
{
  ParameterProblems problems;
  check_stones(parameters.stones, problems);
  check_box(parameters.box, parameters.geogrid, problems);
  check_lattice(parameters.geogrid, parameters.box, problems);
  check_cover(parameters.geogrid, parameters.box, problems);
  check_volume(parameters.box, problems);
  check_ribs(parameters.geogrid, problems);
  check_surcharge(parameters.surcharge, parameters.box, problems);
  check_pull(parameters.pull, parameters.geogrid, problems);
  check_frames(parameters.frames_at, parameters.pull, problems);
  check_stone_contact(parameters.contact, problems);
  check_pair_friction("Contact/Stone on geogrid friction",
                      parameters.geogrid_contact.stone_friction, problems);
  check_pair_friction("Filling/Stone friction", parameters.filling.stone_friction, problems);
  return problems.take();
}
} // namespace interlock::coupling
