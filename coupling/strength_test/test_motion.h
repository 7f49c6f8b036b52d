// The motion of a strength test: a wall goes its way, from rest with half a cosine, while forces
// are recorded as means over the steps between two records, and contacts are watched: for overlaps
// that are too large for stones, and for the step that they allow. A member of the last stage,
// which says what moves and which three values are recorded: forces [N] or stresses [Pa].
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/parameters/output_parameters.h"
#include "coupling/run/stage.h"
#include "coupling/strength_test/specimen.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
struct TestMotion {
  bool begun = false, over = false;
  bool is_last = false, record_due = false, frame_due = false; // of the step to come
  double begin = 0;                                            // [s]
  int records = 0, frames = 0;
  // Since the last record: sum of values times time, and that time [s].
  dem::Vector3 impulse = dem::Vector3::Zero();
  double impulse_time = 0;
  EnergyLedger ledger_at_begin, ledger; // at the first and last record
  double largest_overlap = 0;           // of all contacts and steps [m]
  double smallest_stable_step = 1e300;  // at the records [s]
  // Way from which on overlaps are too large for stones; negative: never [m].
  double overlap_left_at = -1;
};
// All but the impulse, whose values have names and units of their own in each test.
template <class Archive> void exchange(Archive& archive, TestMotion& motion)
{
  archive("begun", motion.begun);
  archive("over", motion.over);
  archive("begin", motion.begin, "s");
  archive("records", motion.records);
  archive("frames", motion.frames);
  archive("impulse_time", motion.impulse_time, "s");
  archive("ledger_at_begin", motion.ledger_at_begin);
  archive("ledger", motion.ledger);
  archive("largest_overlap", motion.largest_overlap, "m");
  archive("smallest_stable_step", motion.smallest_stable_step, "s");
  archive("overlap_left_at", motion.overlap_left_at, "m");
}

// In before_step. True in the first step, with all stones on every rank.
bool begins(TestMotion& motion, World& world);
// What is due in the step to come, `progress` being the share of the way that is done.
StageStatus go_on(TestMotion& motion, const World& world, double progress, double ramp_time,
                  const OutputParameters& output);

// In look. Begins a record; returns the means since the last one. `now`: values of this step; `way`
// of the wall [m].
dem::Vector3 begin_record(TestMotion& motion, const Specimen& specimen, const dem::Vector3& now,
                          double way);
// Ends it: adds contacts and ledger to the row, whose columns are these, and writes it.
void end_record(TestMotion& motion, const World& world, std::vector<History::Cell> row,
                RunRecords& records);
void append_common_columns(std::vector<std::string>& columns);
// After the record: writes the frame that is due. Returns the share of the full speed that the wall
// gets now, or a negative number when it keeps the speed that it has: between forces and motion, as
// the work of a wall is booked with the velocity that it moves with [-].
double end_look(TestMotion& motion, const World& world, double ramp_time, RunRecords& records);

// In after_step, with values and time added to the impulse: overlaps of the last step, of this
// rank.
void note_overlap(TestMotion& motion, const World& world);
void unite_overlaps(TestMotion& motion, const World& world); // in unite_notes

// Why a test is not to be used from `overlap_left_at` on.
extern const char* const overlap_reason;
// In finish: seed, ledger and contacts into the summary. `energy_prefix`: of the energies of the
// motion, "shear"; `name`: what it is called in a sentence, "shearing".
void describe_motion(const TestMotion& motion, const Specimen& specimen,
                     const std::string& energy_prefix, const std::string& name,
                     RunRecords& records);
} // namespace interlock::coupling
