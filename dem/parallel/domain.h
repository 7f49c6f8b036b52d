// How several ranks share the clumps of an engine: the same digits as on one.
//
// A rank holds the clumps that it moves and copies (ghosts) of all that could touch them, together,
// ascending in id. A contact between a clump of its own and a ghost is evaluated on both ranks,
// from the same numbers, and forces are summed in the order of ids on both; so nothing of a force
// ever travels, and histories only with a clump that changes ranks. The loop reads
//     if (domain.has_expired(engine)) domain.deal(engine);
//     engine.compute_forces(dt);
//     engine.kick_all(dt);
//     engine.drift_all(dt, &engine.clumps().ghost);
//     domain.refresh(engine);
//     engine.move_walls(dt);
// Why this changes no digit: docs/theory/parallel.md.
#pragma once

#include "dem/engine/engine.h"
#include "dem/parallel/cell_grid.h"
#include "dem/parallel/ranks.h"

namespace interlock::dem
{
class Domain
{
public:
  // The cells must be wider than two bounding radii of the largest clump; half of the rest of their
  // width is how far clumps may move before they are dealt anew. Collective, as all that follows.
  Domain(const Ranks& ranks, const CellGrid& grid);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  // Gives every clump that is not a ghost to the rank that owns its cell, with what its contacts
  // remember, and copies to the owners of neighbouring cells. Cells are first shared out anew, by
  // the number of clumps in them, if that has become uneven. To be called when ghosts are as their
  // originals are.
  void deal(Engine& engine);

  // Whether the clumps of some rank have moved so far that they should be dealt anew now. To be
  // called once a step. Nobody waits: what is answered is the question of the step before, and the
  // present one is under way. Throws std::runtime_error when a clump has been too fast for that.
  bool has_expired(const Engine& engine);

  // Poses and the step's motion of all ghosts, from the ranks that move them.
  void refresh(Engine& engine);

private:
  struct Parcel; // for one rank: clumps and memories
  // Ranks that need a copy of a clump with this bounding radius which is in this cell, ascending.
  std::vector<int> ranks_near(const Vector3& x, int cell, double radius) const;
  void share_out_cells(const Clumps& clumps);
  void connect(const Clumps& clumps);
  void await_answer();

  const Ranks& ranks_;
  CellGrid grid_;
  std::vector<int> owner_; // of the cells
  VectorField dealt_;      // positions of all clumps here when they were dealt [m]
  double room_ = 0;        // how far they may move from there [m]
  double largest_ = 0;     // bounding radius [m]
  // Whether somebody has used half of the room: the sum over ranks that is under way.
  MPI_Request question_ = MPI_REQUEST_NULL;
  int asked_ = 0, answer_ = 0;
  // Of refresh(): ranks that have ghosts of ours and of which we have ghosts, the clumps for each
  // of them one behind the other, ascending in id, and messages.
  struct Neighbours {
    std::vector<int> ranks, lengths, begins; // in numbers
    std::vector<int> clumps;
    std::vector<double> numbers;
  };
  Neighbours to_, from_;
  MPI_Comm graph_ = MPI_COMM_NULL;
};
} // namespace interlock::dem
