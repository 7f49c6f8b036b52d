#include "dem/parallel/ranks.h"

#include <limits>
#include <numeric>
#include <stdexcept>

namespace interlock::dem
{
namespace
{
// Where each of several messages begins that lie one behind the other; the end comes last.
std::vector<int> begins(const std::vector<int>& lengths)
{
  if (std::accumulate(lengths.begin(), lengths.end(), 0.) > std::numeric_limits<int>::max())
    throw std::runtime_error("The stones of all ranks together need a message of more than 2 GB.");
  std::vector<int> begin(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), begin.begin() + 1);
  return begin;
}

std::vector<Bytes> apart(const Bytes& bytes, const std::vector<int>& begin)
{
  std::vector<Bytes> messages;
  for (std::size_t m = 0; m + 1 < begin.size(); ++m)
    messages.emplace_back(bytes.begin() + begin[m], bytes.begin() + begin[m + 1]);
  return messages;
}
} // namespace

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
  const std::vector<int> out_begin = begins(out), in_begin = begins(in);
  Bytes sent, received(in_begin.back());
  sent.reserve(out_begin.back());
  for (const Bytes& message : to) sent.insert(sent.end(), message.begin(), message.end());
  MPI_Alltoallv(sent.data(), out.data(), out_begin.data(), MPI_BYTE, received.data(), in.data(),
                in_begin.data(), MPI_BYTE, comm_);
  return apart(received, in_begin);
}

void Ranks::sum(std::vector<double>& numbers) const
{
  MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_SUM,
                comm_);
}

double Ranks::sum_of(double mine) const
{
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return mine;
}

void Ranks::largest(std::vector<double>& numbers) const
{
  MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_MAX,
                comm_);
}

double Ranks::largest(double mine) const
{
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return mine;
}

std::vector<Bytes> Ranks::all(const Bytes& mine) const
{
  const int length = static_cast<int>(mine.size());
  std::vector<int> lengths(size_);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, comm_);
  const std::vector<int> begin = begins(lengths);
  Bytes received(begin.back());
  MPI_Allgatherv(mine.data(), length, MPI_BYTE, received.data(), lengths.data(), begin.data(),
                 MPI_BYTE, comm_);
  return apart(received, begin);
}

Bytes Ranks::from(int rank, Bytes mine) const
{
  int length = static_cast<int>(mine.size());
  MPI_Bcast(&length, 1, MPI_INT, rank, comm_);
  mine.resize(length);
  MPI_Bcast(mine.data(), length, MPI_BYTE, rank, comm_);
  return mine;
}

std::string Ranks::from(int rank, const std::string& mine) const
{
  const auto* text = reinterpret_cast<const std::byte*>(mine.data());
  const Bytes bytes = from(rank, Bytes(text, text + mine.size()));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
} // namespace interlock::dem
