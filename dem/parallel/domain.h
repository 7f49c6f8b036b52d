// How several ranks share the clumps of an engine: the same digits as on one.
//
// A rank holds the clumps that it moves and copies (ghosts) of all that could touch them, together,
// ascending in id. A contact between a clump of its own and a ghost is evaluated on both ranks,
// from the same numbers, and forces are summed in the order of ids on both; so nothing of a force
// ever travels, and histories only with a clump that changes ranks. The loop reads
//     if (agreement.exchange(domain.has_expired(engine, dt))) domain.deal(engine);
//     engine.compute_forces(dt);
//     engine.kick_all(dt);
//     engine.drift_all(dt, &engine.clumps().ghost);
//     domain.start_refresh(engine);
//     engine.move_walls(dt);
//     domain.finish_refresh(engine);
// Why this changes no digit: docs/theory/parallel.md.
#pragma once

#include "dem/engine/engine.h"
#include "dem/parallel/cell_grid.h"
#include "dem/parallel/halo.h"
#include "dem/parallel/ranks.h"

namespace interlock::dem
{
// What a clump costs beside its contacts with others and walls, each of which counts 1.
struct ClumpCost {
  std::int64_t clump = 0; // id
  int cost = 0;
};

// What the owner of a place has to do besides [m].
struct PlaceCost {
  Vector3 place;
  int cost = 0;
};

class Domain
{
public:
  // At first the engine of every rank has everything. `ranks` must outlive this object.
  explicit Domain(const Ranks& ranks) : ranks_(ranks), halo_(ranks.comm(), 1) {}

  // Whether every rank has everything, none of it a ghost, as on one rank.
  bool is_whole() const { return whole_; }
  const Ranks& ranks() const { return ranks_; }
  // How far clumps may move before they are dealt anew [m].
  double room() const { return room_; }

  // Gives every clump to the rank that owns its cell, with what its contacts remember, and copies
  // to the ranks that own cells near it. Cells are first shared out anew, by the clumps in them,
  // their contacts, `besides` and `elsewhere`, if that has become uneven; `elsewhere` is the same
  // on all ranks. To be called when ghosts are as their
  // originals are. Collective, as all that follow but has_expired(). Throws std::runtime_error when
  // METIS cannot divide the cells.
  void deal(Engine& engine, const std::vector<ClumpCost>& besides = {},
            const std::vector<PlaceCost>& elsewhere = {});
  // Gives everything to every rank.
  void gather(Engine& engine);

  // Whether clumps of this rank have moved so far that all should be dealt anew within two steps of
  // `dt` [s]. Throws std::runtime_error when a clump has been too fast for that.
  bool has_expired(const Engine& engine, double dt) const;

  // The rank that a place belongs to since the last deal [m].
  int owner_of(const Vector3& place) const { return owner_[grid_.cell_of(place)]; }

  // Poses and the step's motion of all ghosts, from the ranks that move them. In between, while
  // messages are under way, ghosts are where they were before the step.
  void start_refresh(Engine& engine);
  void finish_refresh(Engine& engine);

private:
  // Where a clump goes: who moves it, and who needs a copy, ascending.
  struct Place {
    int owner = 0;
    std::vector<int> copies;
  };
  Place place_of(const Clumps& clumps, int clump) const;
  void lay_cells(const Clumps& clumps);
  void share_out_cells(const Clumps& clumps, const ContactMemory& contacts,
                       const std::vector<ClumpCost>& besides,
                       const std::vector<PlaceCost>& elsewhere);
  void deal_whole(Engine& engine, ContactMemory memory);
  void deal_parts(Engine& engine, const ContactMemory& memory);
  void connect(const Clumps& clumps);

  const Ranks& ranks_;
  bool whole_ = true;
  CellGrid grid_{Vector3::Zero(), Vector3::Ones(), 1};
  std::vector<int> owner_; // of the cells
  VectorField dealt_;      // positions of all clumps here when they were dealt [m]
  double room_ = 0;        // [m]
  double largest_ = 0;     // bounding radius [m]
  Halo halo_;
};
} // namespace interlock::dem
