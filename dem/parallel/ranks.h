// The processes that share one simulation.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <string>
#include <vector>

namespace interlock::dem
{
using Bytes = std::vector<std::byte>;

// All functions but the first three are collective.
class Ranks
{
public:
  explicit Ranks(MPI_Comm comm);

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  // Sums over all ranks, entry by entry.
  std::vector<int> sum(std::vector<int> mine) const;
  void sum(std::vector<double>& numbers) const;
  double sum_of(double mine) const;
  // The largest of all ranks, entry by entry.
  void largest(std::vector<double>& numbers) const;
  double largest(double mine) const;
  // Sends `to`[r] to each rank r, this one too, and returns what each rank has sent here. Empty
  // messages cost nothing but their length.
  std::vector<Bytes> exchange(const std::vector<Bytes>& to) const;
  // What every rank says, by rank.
  std::vector<Bytes> all(const Bytes& mine) const;
  // What the given rank says; `mine` counts there only.
  Bytes from(int rank, Bytes mine) const;
  std::string from(int rank, const std::string& mine) const;

private:
  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};
} // namespace interlock::dem
