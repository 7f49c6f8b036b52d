// The halo of a rank: its copies of what other ranks move (clumps, ends of ribs), and theirs of its
// own.
#pragma once

#include <mpi.h>

#include <map>
#include <vector>

namespace interlock::dem
{
class Halo
{
public:
  // Indices by rank, in arrays with an entry for each of all that this rank knows; those of one
  // rank ascend.
  using EntriesOfRanks = std::map<int, std::vector<int>>;

  // Halos whose messages may be under way at the same time have different tags.
  Halo(MPI_Comm comm, int tag) : comm_(comm), tag_(tag) {}
  ~Halo();
  Halo(const Halo&) = delete;
  Halo& operator=(const Halo&) = delete;

  // From now on `there` are the entries of this rank that others have copies of, and `here` the
  // copies that this one has, by the rank that moves them; `numbers` for each. What one rank says
  // of another must be what that one says of it, in the same order. Sends nothing.
  void connect(const EntriesOfRanks& there, const EntriesOfRanks& here, int numbers);

  // Copies the numbers of all of them, one from each of the arrays: sends the own ones, which are
  // taken at once, and waits for the copies, which change only then. Collective among neighbours.
  void start(const std::vector<double*>& arrays);
  void finish(const std::vector<double*>& arrays);
  void refresh(const std::vector<double*>& arrays) { start(arrays), finish(arrays); }

  const std::vector<int>& copies() const { return from_.entries; }

private:
  void await();
  void disconnect();

  MPI_Comm comm_;
  int tag_;
  // The entries of all neighbours, one behind the other, and messages.
  struct Neighbours {
    std::vector<int> ranks, lengths, begins; // in numbers
    std::vector<int> entries;
    std::vector<double> numbers;
  };
  Neighbours to_, from_;
  std::vector<MPI_Request> requests_; // persistent, of both
  bool under_way_ = false;
};
} // namespace interlock::dem
