#include "coupling/pull_out/pull_out_checks.h"

#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_declarations.h"
#include "coupling/pull_out/geogrid_checks.h"

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// Room for decimal lengths such as 3 x 0.065 + 0.005 that have no exact binary form [m].
constexpr double length_tolerance = 1e-9;

// Pouring them takes days.
void check_volume(const BoxParameters& box, ParameterProblems& problems)
{
  constexpr double largest = 4; // [m3]
  const double volume = box.length * box.width * box.height;
  if (volume > largest)
    problems.add_unusual("Box/Length", "The box holds ", volume,
                         " m3, some 25000 stones of railway ballast in each.");
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
  const double length = length_of_geogrid(geogrid);
  if (geogrid.lattice_file.empty() && pull.distance > length + length_tolerance)
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
  check_geogrid(parameters.geogrid, parameters.box, problems);
  check_volume(parameters.box, problems);
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
