#include "dem/parallel/ranks.h"

#include <numeric>

namespace interlock::dem
{
Ranks::Ranks(MPI_Comm comm) : comm_(comm)
{
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

std::vector<int> Ranks::sum(std::vector<int> mine) const
{
  MPI_Allreduce(MPI_IN_PLACE, mine.data(), static_cast<int>(mine.size()), MPI_INT, MPI_SUM, comm_);
  return mine;
}

std::vector<Bytes> Ranks::exchange(const std::vector<Bytes>& to) const
{
  std::vector<int> out(size_), in(size_);
  for (int r = 0; r < size_; ++r) out[r] = static_cast<int>(to[r].size());
  MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, comm_);
  const auto begins = [](const std::vector<int>& lengths) {
    std::vector<int> begin(lengths.size() + 1, 0);
    std::partial_sum(lengths.begin(), lengths.end(), begin.begin() + 1);
    return begin;
  };
  const std::vector<int> out_begin = begins(out), in_begin = begins(in);
  Bytes sent, received(in_begin.back());
  sent.reserve(out_begin.back());
  for (const Bytes& message : to) sent.insert(sent.end(), message.begin(), message.end());
  MPI_Alltoallv(sent.data(), out.data(), out_begin.data(), MPI_BYTE, received.data(), in.data(),
                in_begin.data(), MPI_BYTE, comm_);
  std::vector<Bytes> from(size_);
  for (int r = 0; r < size_; ++r)
    from[r].assign(received.begin() + in_begin[r], received.begin() + in_begin[r + 1]);
  return from;
}
} // namespace interlock::dem
