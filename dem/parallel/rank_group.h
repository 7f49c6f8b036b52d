// Some of the ranks, which tell each other something several times a step.
#pragma once

#include "dem/parallel/ranks.h"

#include <type_traits>
#include <vector>

namespace interlock::dem
{
class RankGroup
{
public:
  // Of all ranks those for which `joins` is true. Collective among all.
  RankGroup(const Ranks& ranks, bool joins);
  // This rank and its neighbours, which have it as theirs: each rank has a group of its own.
  RankGroup(const Ranks& ranks, const std::vector<int>& neighbours);

  const std::vector<int>& members() const { return members_; } // ascending
  bool is_member() const { return is_member_; }
  bool is_everybody() const { return static_cast<int>(members_.size()) == ranks_->size(); }

  // What every member says, by member. To be called by all members: each sends one message to each
  // other one.
  template <class T> std::vector<std::vector<T>> all(const std::vector<T>& mine) const
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<MPI_Request> sent;
    for (const int rank : members_)
      if (rank != ranks_->rank()) sent.push_back(send(rank, mine.data(), mine.size() * sizeof(T)));
    std::vector<std::vector<T>> said;
    for (const int rank : members_) {
      said.emplace_back(mine);
      if (rank == ranks_->rank()) continue;
      MPI_Message message;
      said.back().resize(expect(rank, message) / sizeof(T));
      receive(message, said.back().data(), said.back().size() * sizeof(T));
    }
    MPI_Waitall(static_cast<int>(sent.size()), sent.data(), MPI_STATUSES_IGNORE);
    return said;
  }

private:
  MPI_Request send(int rank, const void* bytes, std::size_t size) const;
  std::size_t expect(int rank, MPI_Message& message) const; // its size in bytes
  static void receive(MPI_Message& message, void* bytes, std::size_t size);

  const Ranks* ranks_;
  std::vector<int> members_;
  bool is_member_;
};
} // namespace interlock::dem
