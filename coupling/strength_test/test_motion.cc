#include "coupling/strength_test/test_motion.h"

#include "coupling/stones/soft_start.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// A surface that is pressed in by more than this share of its radius is another surface [-].
constexpr double usable_overlap = 0.1;

bool ramping(const TestMotion& motion, const World& world, double ramp_time)
{
  // One step more, which reaches the full speed.
  return world.clock.time() - motion.begin <= ramp_time + 2 * world.clock.dt;
}

// Overlaps and stable step of all ranks, at a record.
void watch_contacts(TestMotion& motion, const Specimen& specimen, double way)
{
  const World& world = specimen.world();
  note_overlap(motion, world);
  unite_overlaps(motion, world);
  const dem::StableStep live = world.stable_step();
  if (live.step > 0) motion.smallest_stable_step = std::min(motion.smallest_stable_step, live.step);
  if (motion.overlap_left_at < 0 &&
      motion.largest_overlap > usable_overlap * specimen.mean_sphere_radius)
    motion.overlap_left_at = way;
}

void describe_contacts(const TestMotion& motion, const Specimen& specimen, const std::string& name,
                       RunRecords& records)
{
  Summary& summary = records.summary;
  const double dt = specimen.world().clock.dt;
  summary.results["largest_overlap_m"] = motion.largest_overlap;
  summary.results["largest_overlap_over_mean_sphere_radius"] =
      motion.largest_overlap / specimen.mean_sphere_radius;
  summary.results["smallest_stable_step_s"] = motion.smallest_stable_step;
  if (dt > motion.smallest_stable_step)
    records.warn(
        fmt::format("The time step of {:.3g} s was above the live stable step of {:.3g} s.", dt,
                    motion.smallest_stable_step));
  if (motion.overlap_left_at < 0) return;
  const double from = 1e3 * motion.overlap_left_at;
  summary.results["not_usable_from_mm"] = from;
  summary.results["not_usable_because"] = overlap_reason;
  summary.not_usable =
      fmt::format("From {:.1f} mm on the {} is not to be used: {}.", from, name, overlap_reason);
}
} // namespace

const char* const overlap_reason =
    "a contact overlaps by more than a tenth of the mean radius of a sphere (contacts too soft for "
    "this load?)";

bool begins(TestMotion& motion, World& world)
{
  if (motion.begun) return false;
  world.make_whole();
  motion.begun = true;
  motion.begin = world.clock.time();
  return true;
}

StageStatus go_on(TestMotion& motion, const World& world, double progress, double ramp_time,
                  const OutputParameters& output)
{
  motion.is_last = progress >= 1;
  motion.record_due = motion.is_last || progress * output.records >= motion.records;
  motion.frame_due = output.field_frames > 0 &&
                     (motion.is_last || progress * output.field_frames >= motion.frames);
  if (motion.is_last || motion.frame_due) return running(progress, Look::at_everything);
  const bool looks = motion.record_due || ramping(motion, world, ramp_time);
  return running(progress, looks ? Look::at_part : Look::none);
}

dem::Vector3 begin_record(TestMotion& motion, const Specimen& specimen, const dem::Vector3& now,
                          double way)
{
  motion.ledger = specimen.world().ledger();
  if (motion.records == 0) motion.ledger_at_begin = motion.ledger;
  // The first record has no step behind it.
  const dem::Vector3 mean =
      motion.impulse_time > 0 ? dem::Vector3(motion.impulse / motion.impulse_time) : now;
  motion.impulse.setZero();
  motion.impulse_time = 0;
  watch_contacts(motion, specimen, way);
  return mean;
}

void end_record(TestMotion& motion, const World& world, std::vector<History::Cell> row,
                RunRecords& records)
{
  row.emplace_back(static_cast<double>(world.touching_spheres()));
  row.emplace_back(world.largest(world.largest_overlap()));
  append_ledger(row, motion.ledger);
  records.add(row);
  ++motion.records;
}

void append_common_columns(std::vector<std::string>& columns)
{
  columns.insert(columns.end(), {"stone_contacts [-]", "largest_overlap [m]"});
  append_ledger_columns(columns);
}

double end_look(TestMotion& motion, const World& world, double ramp_time, RunRecords& records)
{
  motion.over = motion.is_last;
  if (motion.frame_due) {
    records.add_frame(world);
    ++motion.frames;
  }
  if (!ramping(motion, world, ramp_time)) return -1;
  return soft_start(world.clock.time() - motion.begin, ramp_time);
}

void note_overlap(TestMotion& motion, const World& world)
{
  motion.largest_overlap = std::max(motion.largest_overlap, world.largest_overlap());
}

void unite_overlaps(TestMotion& motion, const World& world)
{
  motion.largest_overlap = world.largest(motion.largest_overlap);
}

void describe_motion(const TestMotion& motion, const Specimen& specimen,
                     const std::string& energy_prefix, const std::string& name, RunRecords& records)
{
  Summary& summary = records.summary;
  summary.seed = specimen.parameters().filling.seed;
  summary.contacts = specimen.world().engine.n_touching_spheres();
  add_ledger(summary, motion.ledger);
  const EnergyLedger change = difference(motion.ledger, motion.ledger_at_begin);
  summary.energy[energy_prefix + "_wall_work_J"] = change.wall_work;
  summary.energy[energy_prefix + "_residual_J"] = change.residual();
  summary.ledger_closes = motion.ledger.relative_error() <= ledger_failure;
  describe_contacts(motion, specimen, name, records);
  warn_of_ledger(motion.ledger, records);
}
} // namespace interlock::coupling
