#include "dem/parallel/rank_group.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
constexpr int tag = 2; // those of halos are others
} // namespace

RankGroup::RankGroup(const Ranks& ranks, bool joins) : ranks_(&ranks), is_member_(joins)
{
  std::vector<int> flags(ranks.size(), 0);
  flags[ranks.rank()] = joins ? 1 : 0;
  flags = ranks.sum(flags);
  for (int rank = 0; rank < ranks.size(); ++rank)
    if (flags[rank] == 1) members_.push_back(rank);
}

RankGroup::RankGroup(const Ranks& ranks, const std::vector<int>& neighbours)
    : ranks_(&ranks), members_(neighbours), is_member_(true)
{
  members_.push_back(ranks.rank());
  std::sort(members_.begin(), members_.end());
}

MPI_Request RankGroup::send(int rank, const void* bytes, std::size_t size) const
{
  MPI_Request request;
  MPI_Isend(bytes, static_cast<int>(size), MPI_BYTE, rank, tag, ranks_->comm(), &request);
  return request;
}

std::size_t RankGroup::expect(int rank, MPI_Message& message) const
{
  MPI_Status status;
  int size = 0;
  MPI_Mprobe(rank, tag, ranks_->comm(), &message, &status);
  MPI_Get_count(&status, MPI_BYTE, &size);
  return static_cast<std::size_t>(size);
}

void RankGroup::receive(MPI_Message& message, void* bytes, std::size_t size)
{
  MPI_Mrecv(bytes, static_cast<int>(size), MPI_BYTE, &message, MPI_STATUS_IGNORE);
}
} // namespace interlock::dem
