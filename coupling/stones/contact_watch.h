// What the contacts of a strength test are watched for: overlaps that are too large for stones, and
// the step that they allow.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/output/summary.h"
#include "coupling/run/run_records.h"

#include <string>

namespace interlock::coupling
{
struct ContactWatch {
  double largest_overlap = 0;          // of all contacts and steps [m]
  double smallest_stable_step = 1e300; // at the records [s]
  // Way of the test from which on overlaps are too large for stones; negative: never [m].
  double overlap_left_at = -1;
};
template <class Archive> void exchange(Archive& archive, ContactWatch& watch)
{
  archive("largest_overlap", watch.largest_overlap, "m");
  archive("smallest_stable_step", watch.smallest_stable_step, "s");
  archive("overlap_left_at", watch.overlap_left_at, "m");
}

// Overlaps of the last step, of this rank.
void note_overlap(ContactWatch& watch, const World& world);
// Overlaps and stable step of all ranks, at a record. `way` of the test so far [m].
void note_record(ContactWatch& watch, const World& world, double way, double mean_sphere_radius);

// Into results and warnings. `test`: what it is called in a sentence, "shearing".
void describe_contacts(const ContactWatch& watch, const World& world, double mean_sphere_radius,
                       const std::string& test, RunRecords& records);
} // namespace interlock::coupling
