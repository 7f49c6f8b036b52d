// The processes that share one simulation.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace interlock::dem
{
using Bytes = std::vector<std::byte>;

class Ranks
{
public:
  explicit Ranks(MPI_Comm comm);

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  // Sums over all ranks, entry by entry. Collective.
  std::vector<int> sum(std::vector<int> mine) const;
  // Sends `to`[r] to each rank r, this one too, and returns what each rank has sent here. Empty
  // messages cost nothing but their length. Collective.
  std::vector<Bytes> exchange(const std::vector<Bytes>& to) const;

private:
  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};
} // namespace interlock::dem
