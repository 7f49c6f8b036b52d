// The halo of a rank: its copies of clumps that other ranks move, and theirs of its own.
#pragma once

#include "dem/bodies/clumps.h"

#include <mpi.h>

#include <map>
#include <vector>

namespace interlock::dem
{
class Halo
{
public:
  // Indices of clumps by rank; those of one rank ascend.
  using ClumpsOfRanks = std::map<int, std::vector<int>>;

  explicit Halo(MPI_Comm comm) : comm_(comm) {}
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  // From now on `there` are the clumps of this rank that others have copies of, and `here` the
  // copies that this one has, by the rank that moves them. What one rank says of another must be
  // what that one says of it, in the same order. Sends nothing.
  void connect(const ClumpsOfRanks& there, const ClumpsOfRanks& here);

  // Copies position [m], attitude, and velocity [m/s] and spin [rad/s] of the last step (world) of
  // all of them. Collective among neighbours.
  void refresh(Clumps& clumps);

private:
  void disconnect();

  MPI_Comm comm_;
  // The clumps of all neighbours, one behind the other, and messages.
  struct Neighbours {
    std::vector<int> ranks, lengths, begins; // in numbers
    std::vector<int> clumps;
    std::vector<double> numbers;
  };
  Neighbours to_, from_;
  std::vector<MPI_Request> requests_; // persistent, of both
};
} // namespace interlock::dem
