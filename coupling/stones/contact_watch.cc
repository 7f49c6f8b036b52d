#include "coupling/stones/contact_watch.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// A surface that is pressed in by more than this share of its radius is another surface [-].
constexpr double usable_overlap = 0.1;
} // namespace

void note_overlap(ContactWatch& watch, const World& world)
{
  watch.largest_overlap = std::max(watch.largest_overlap, world.largest_overlap());
}

void note_record(ContactWatch& watch, const World& world, double way, double mean_sphere_radius)
{
  note_overlap(watch, world);
  watch.largest_overlap = world.largest(watch.largest_overlap);
  const dem::StableStep live = world.stable_step();
  if (live.step > 0) watch.smallest_stable_step = std::min(watch.smallest_stable_step, live.step);
  if (watch.overlap_left_at < 0 && watch.largest_overlap > usable_overlap * mean_sphere_radius)
    watch.overlap_left_at = way;
}

void describe_contacts(const ContactWatch& watch, const World& world, double mean_sphere_radius,
                       const std::string& test, RunRecords& records)
{
  Summary& summary = records.summary;
  summary.results["largest_overlap_m"] = watch.largest_overlap;
  summary.results["largest_overlap_over_mean_sphere_radius"] =
      watch.largest_overlap / mean_sphere_radius;
  summary.results["smallest_stable_step_s"] = watch.smallest_stable_step;
  if (world.clock.dt > watch.smallest_stable_step)
    records.warn(
        fmt::format("The time step of {:.3g} s was above the live stable step of {:.3g} s.",
                    world.clock.dt, watch.smallest_stable_step));
  if (watch.overlap_left_at < 0) return;
  const std::string reason = "a contact overlaps by more than a tenth of the mean radius of a "
                             "sphere (contacts too soft for this load?)";
  summary.results["not_usable_from_mm"] = 1e3 * watch.overlap_left_at;
  summary.results["not_usable_because"] = reason;
  summary.not_usable = fmt::format("From {:.1f} mm on the {} is not to be used: {}.",
                                   1e3 * watch.overlap_left_at, test, reason);
}
} // namespace interlock::coupling
