// The contacts about to touch, one lane a contact. A block holds all that the law reads and writes
// of lane_width lanes, so that they are one piece of memory.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_memory.h"
#include "dem/lanes/body_records.h"
#include "dem/walls/wall.h"

namespace interlock::dem
{
// Names one contact: member sphere `a` of clump `i` against member `b` of clump `j` > i, or against
// wall `j` (b = 0).
struct ContactKey {
  int i = 0, j = 0, a = 0, b = 0;
};

// Lanes [begin, end) of one wall; begin is a multiple of the lane width.
struct WallSegment {
  int begin = 0, end = 0;
};

// Rows of one block; a vector is three of them.
struct alignas(64) LaneBlock {
  using Row = double[lane_width];
  Row centre1[3], centre2[3];  // of the member spheres, body frames [m]
  Row radius1, radius2;        // [m]
  Row reduced_mass, root_mass; // ContactConstants
  // LaneHistory.
  Row spring[3], dashpot[3], overlap;
  Row force[3]; // on the clump i at the last evaluation, world [N]
  // Indices of the clumps; at walls `j` is unused. `same_first`: all bits set where the lane before
  // has the same i, none otherwise.
  std::int32_t i[lane_width], j[lane_width];
  std::int64_t same_first[lane_width];
  Row reduced_radius;         // ContactConstants, of Hertz's law [m]
  Row tangential_stiffness;   // LaneHistory, read by laws whose stiffness changes [N/m]
  Row shared_depth, gradient; // ContactShare of the last evaluation with a shared law
  Row crushed;                // LaneHistory, read and written by laws that crush [m]
};

class ContactLanes
{
public:
  int size() const { return static_cast<int>(keys_.size()); }
  // Makes n idle lanes, which cannot touch. The rest of the last block is idle, too.
  void reset(int n);

  const ContactKey& key(int k) const { return keys_[k]; }

  // Numbers of lane k, see LaneBlock.
  double overlap(int k) const { return block(k).overlap[k % lane_width]; }
  ContactShare share(int k) const;
  LaneMemory memory(int k) const;
  void remember(int k, const LaneMemory& memory);
  // What the history of lane k stores in the springs of its contact [J].
  double stored_energy(int k, const ContactProperties& pair) const;

  // Sets the key and constants of lane k; the history is left alone.
  void set_pair(int k, const ContactKey& key, const Clumps& clumps);
  void set_wall(int k, const ContactKey& key, const Clumps& clumps);
  // To be called when all pairs are set: gives idle lanes at the end the clumps of the last one.
  void finish_pairs();
  bool holds_something(int k) const { return overlap(k) > 0; } // an open contact holds nothing

  LaneBlock& block(int k) { return blocks_[k / lane_width]; }
  const LaneBlock& block(int k) const { return blocks_[k / lane_width]; }
  std::vector<LaneBlock>& blocks() { return blocks_; }
  const std::vector<LaneBlock>& blocks() const { return blocks_; }

private:
  std::vector<ContactKey> keys_;
  std::vector<LaneBlock> blocks_;
};

// Forces and new histories of all lanes, from the records of the clumps (their poses and the step's
// motion), into `sums`: those of first bodies are set, those of second bodies added to, with the
// energies that the step has cost. `dt`: step over which springs advance [s].
void evaluate_pairs(const BodyRecords& bodies, const ContactProperties& pair, double dt,
                    ContactLanes& lanes, BodySums& sums);
// The same for the lanes of one wall, whose force is set, too; the clumps' sums as other bodies are
// added to.
void evaluate_wall(const BodyRecords& bodies, double dt, WallSegment segment, ContactLanes& lanes,
                   BodySums& sums, Wall& wall);

int count_touching(const ContactLanes& lanes);
double largest_overlap(const ContactLanes& lanes); // [m]

// Sets the shares of lanes [begin, end) from their present overlaps, which stand in shared_depth:
// lanes of the same i and j share one contact (contact_shares.cc).
void share_contacts(int begin, int end, ContactLanes& lanes);
} // namespace interlock::dem
