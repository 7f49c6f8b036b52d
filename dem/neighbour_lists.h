// Nested neighbour lists: clump pairs, sphere pairs, sphere pairs about to touch.
//
// Each level is a filter of the one above with its own reference pose and skin, and proves its own
// validity: since its reference pose a point of clump i has moved at most
//     u_i = |x - x0| + 2 c_i |vec(conj(q0) q)|,  c_i = distance of its farthest sphere centre,
// (chord of the rotation), so a list with skin s misses nothing while 2 max(u) <= s. The step
// touches the inner list only. Lists never change a result: an entry that does not touch
// contributes exact zero.
#pragma once

#include "dem/clumps.h"
#include "dem/wall.h"

namespace interlock::dem
{
// One sphere of clump i against one sphere of clump j, i < j.
struct SphereContact {
  int i = 0, j = 0, a = 0, b = 0;
  ContactHistory history; // of i against j
  bool touching = false;
  Vector3 force = Vector3::Zero(); // on i, zero when not touching [N]
  Vector3 point = Vector3::Zero(); // mid-overlap, world [m]
};

// One sphere of a clump against a wall.
struct WallContact {
  int i = 0, wall = 0, a = 0;
  ContactHistory history; // of the clump against the wall
  bool touching = false;
  Vector3 force = Vector3::Zero(); // on the clump [N]
  Vector3 point = Vector3::Zero();
};

// Skins of the lists [m]; 0: chosen automatically.
struct ListSettings {
  double inner_skin = 0;
  double middle_skin = 0;
};

class NeighbourLists
{
public:
  void set(const ListSettings& settings) { settings_ = settings; }

  // Makes the inner lists complete for the present poses; rebuilds only what has expired.
  // `time_step` is used to choose skins that last some tens of steps at the present speeds.
  void update(const Clumps& clumps, const std::vector<Wall>& walls, double time_step);

  // Forces a full rebuild at the next update, keeping the springs.
  void invalidate() { valid_ = false; }

  // After clumps were removed: drops their contacts and renumbers the others.
  void renumber_clumps(const std::vector<int>& new_index);
  // After walls were removed or exchanged: drops contacts of walls with index >= first.
  void forget_walls(int first);

  // Sorted by (i, j, a, b) and (i, wall, a): forces are summed in this order, so a clump adds its
  // partners in ascending order on any number of ranks.
  std::vector<SphereContact>& sphere_contacts() { return sphere_contacts_; }
  std::vector<WallContact>& wall_contacts() { return wall_contacts_; }
  const std::vector<SphereContact>& sphere_contacts() const { return sphere_contacts_; }
  const std::vector<WallContact>& wall_contacts() const { return wall_contacts_; }

private:
  struct Reference {
    std::vector<Vector3> x;
    std::vector<Quaternion> q;
    std::vector<Vector3> wall;
    double skin = 0; // [m]

    void take(const Clumps& clumps, const std::vector<Wall>& walls, double new_skin);
    // Largest displacement of any point since the reference [m].
    double used(const Clumps& clumps, const std::vector<Wall>& walls, bool with_rotation) const;
  };
  struct ClumpPair {
    int i, j;
  };
  struct MemberPair {
    int i, j, a, b;
  };
  struct WallMember {
    int i, wall, a;
  };

  void build_outer(const Clumps& clumps, const std::vector<Wall>& walls);
  void build_middle(const Clumps& clumps, const std::vector<Wall>& walls);
  void build_inner(const Clumps& clumps, const std::vector<Wall>& walls);
  void add_member_pairs(const Clumps& clumps, int i, int j);
  void place_members(const Clumps& clumps);

  ListSettings settings_;
  bool valid_ = false;
  Reference outer_, middle_, inner_;
  std::vector<ClumpPair> clump_pairs_;
  std::vector<MemberPair> member_pairs_;
  std::vector<WallMember> wall_members_;
  std::vector<SphereContact> sphere_contacts_, old_sphere_contacts_;
  std::vector<WallContact> wall_contacts_, old_wall_contacts_;

  // World centres of all member spheres, only while the middle list is built.
  std::vector<int> first_member_;
  std::vector<Vector3> member_centre_;
  std::vector<int> candidates_i_, candidates_j_;
};
} // namespace interlock::dem
