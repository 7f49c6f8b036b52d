// Nested neighbour lists: clump pairs, sphere pairs, sphere pairs about to touch. Each level is a
// filter of the one above and proves its own validity (docs/theory/engine.md). The step touches the
// inner level only. Lists never change a digit, of forces or of energies: an entry that does not
// touch contributes exact zero, and one that touched stays until it has been evaluated open.
#pragma once

#include "dem/lanes/contact_lanes.h"
#include "dem/lists/list_reference.h"
#include "dem/lists/sphere_pairs.h"

namespace interlock::dem
{
// Skins of clumps at rest [m]; 0: chosen from the size of the clumps and adapted to the number of
// candidates. They set the speed and nothing else.
struct ListSettings {
  double inner_skin = 0;
  double middle_skin = 0;
};

// How often each level was built, and its present size.
struct ListCounts {
  std::int64_t outer_builds = 0, middle_builds = 0, inner_builds = 0;
  std::int64_t clump_pairs = 0, candidates = 0, lanes = 0;
};

class NeighbourLists
{
public:
  void set(const ListSettings& settings);

  // Makes the lanes complete for the present poses; rebuilds only what has expired. `time_step`
  // [s] and `gravity` (along -z) [m/s2] choose skins that last some tens of steps at the present
  // speeds and forces. Returns whether there are new lanes.
  bool update(const Clumps& clumps, const std::vector<Wall>& walls, double time_step,
              double gravity);

  // Levels of the lists: for ranks, which wait for each other at every step, and so should build
  // the same level in the same step. It changes no digit when they are built.
  struct Levels {
    bool inner = false, middle = false;
  };
  // Those that will have to be built soon.
  Levels expiring() const { return expiring_; }
  // The next update builds these anew, unless the last one has just done so.
  void renew(const Levels& levels)
  {
    if (!built_now_) renewed_ = levels;
  }
  // Forces a full rebuild at the next update, keeping the histories.
  void invalidate() { valid_ = false; }
  // After clumps were removed: drops their contacts and renumbers the others.
  void renumber_clumps(const Clumps& clumps, const std::vector<int>& new_index);
  // After walls were removed: for every old wall the new index, ascending, or -1.
  void renumber_walls(const Clumps& clumps, const std::vector<int>& new_index);
  // Goes on from contacts of an earlier run, pairs and walls in the order of the lanes below.
  struct Remembered {
    ContactKey key;
    LaneMemory memory;
  };
  void restore(const Clumps& clumps, int n_walls, const std::vector<Remembered>& pairs,
               const std::vector<Remembered>& at_walls);

  // Sorted by (i, j, a, b); and by (wall, i, a), one segment for each wall. Forces are summed in
  // this order, apart for a clump as first and as second body (BodySums).
  ContactLanes& pair_lanes() { return pairs_; }
  const ContactLanes& pair_lanes() const { return pairs_; }
  ContactLanes& wall_lanes() { return wall_lanes_; }
  const ContactLanes& wall_lanes() const { return wall_lanes_; }
  const std::vector<WallSegment>& wall_segments() const { return wall_segments_; }

  const ListCounts& counts() const { return counts_; }
  // Time spent so far on the outer and on the other levels [s].
  double broad_phase_time() const { return broad_phase_time_; }

private:
  // Candidates [first, last) of a clump pair.
  struct ClumpPair {
    int i, j;
    int first = 0, last = 0;
  };
  // Candidates [first, last) of a clump at a wall.
  struct WallClump {
    int i;
    int first, last;
  };
  struct WallCandidates {
    std::vector<WallClump> clumps;
    std::vector<NearSpheres> near;       // gap: lower bound at the references
    Vector3 reference = Vector3::Zero(); // of the corner [m]
    double skin = 0;                     // middle [m]
    double inner_skin = 0;
    Vector3 inner_reference = Vector3::Zero();
  };

  void choose_sizes(const Clumps& clumps);
  bool inner_holds(const Clumps& clumps, const std::vector<Wall>& walls);
  void choose_inner_skins(const Clumps& clumps, const std::vector<Wall>& walls, double dt);
  bool middle_is_nearly_used_up() const;
  bool middle_holds(const std::vector<Wall>& walls) const;
  void build_outer(const Clumps& clumps, double dt);
  void build_middle(const Clumps& clumps, const std::vector<Wall>& walls, double dt);
  void mark(const Clumps& clumps, const std::vector<Wall>& walls, double dt);
  void walk_clump_pairs(const Clumps& clumps);
  void walk_walls(const Clumps& clumps, const std::vector<Wall>& walls);
  void append_keys(const ContactLanes& old, WallSegment from);
  void build_pair_lanes(const Clumps& clumps);
  void build_wall_lanes(const Clumps& clumps, const std::vector<Wall>& walls);
  void adapt();

  ListSettings settings_;
  Levels expiring_, renewed_;
  bool built_now_ = false; // by the last update
  int inner_since_middle_ = 0;
  bool valid_ = false;
  // Smallest and largest skins [m], from the mean bounding radius.
  double inner_rest_ = 0, inner_most_ = 0, middle_rest_ = 0, middle_most_ = 0, outer_rest_ = 0,
         outer_most_ = 0;
  double inner_steps_ = 70; // that inner skins are meant to last
  double size_ = 0;         // mean bounding radius that the above belong to [m]
  ListReference outer_, middle_, inner_;
  ScalarField middle_used_, next_inner_skin_;
  // Bounds for any member centre, at the last build [m/s], [m/s2].
  ScalarField speed_, acceleration_;
  std::vector<bool> marked_, wall_marked_;

  std::vector<ClumpPair> clump_pairs_;
  std::vector<NearSpheres> candidates_, old_candidates_; // gap: lower bound at the references
  std::vector<WallCandidates> at_walls_;
  WallCandidates old_at_wall_;
  SphereWalk walk_;

  // Being built: contacts about to touch, and the lanes that are made of them.
  struct NewLane {
    ContactKey key;
    int old = -1; // the lane of the same contact before, -1: none that touched
  };
  std::vector<ContactKey> keys_;
  std::vector<NewLane> new_lanes_;
  ContactLanes pairs_, old_pairs_, wall_lanes_, old_wall_lanes_;
  std::vector<WallSegment> wall_segments_, old_wall_segments_;
  ListCounts counts_;
  double broad_phase_time_ = 0;
};
} // namespace interlock::dem
