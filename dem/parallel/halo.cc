#include "dem/parallel/halo.h"

namespace interlock::dem
{
Halo::~Halo()
{
  disconnect();
}

// Messages that a failure has left under way must not come into memory that is gone.
void Halo::disconnect()
{
  if (under_way_) await();
  for (MPI_Request& request : requests_) MPI_Request_free(&request);
  requests_.clear();
}

void Halo::connect(const EntriesOfRanks& there, const EntriesOfRanks& here, int numbers)
{
  const auto take = [numbers](const EntriesOfRanks& lists, Neighbours& neighbours) {
    neighbours = Neighbours();
    for (const auto& [rank, list] : lists) {
      neighbours.ranks.push_back(rank);
      neighbours.begins.push_back(numbers * static_cast<int>(neighbours.entries.size()));
      neighbours.lengths.push_back(numbers * static_cast<int>(list.size()));
      neighbours.entries.insert(neighbours.entries.end(), list.begin(), list.end());
    }
    neighbours.numbers.resize(numbers * neighbours.entries.size());
  };
  take(there, to_);
  take(here, from_);
  // Of every step until the next deal.
  disconnect();
  const auto request_of = [&](Neighbours& neighbours, std::size_t k, const auto& init) {
    requests_.emplace_back();
    init(neighbours.numbers.data() + neighbours.begins[k], neighbours.lengths[k], MPI_DOUBLE,
         neighbours.ranks[k], tag_, comm_, &requests_.back());
  };
  for (std::size_t k = 0; k < from_.ranks.size(); ++k) request_of(from_, k, MPI_Recv_init);
  for (std::size_t k = 0; k < to_.ranks.size(); ++k) request_of(to_, k, MPI_Send_init);
}

void Halo::start(const std::vector<double*>& arrays)
{
  double* out = to_.numbers.data();
  for (const int i : to_.entries)
    for (const double* array : arrays) *out++ = array[i];
  // Open MPI takes no empty list.
  if (!requests_.empty()) MPI_Startall(static_cast<int>(requests_.size()), requests_.data());
  under_way_ = true;
}

void Halo::await()
{
  if (!requests_.empty())
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  under_way_ = false;
}

void Halo::finish(const std::vector<double*>& arrays)
{
  await();
  const double* in = from_.numbers.data();
  for (const int i : from_.entries)
    for (double* array : arrays) array[i] = *in++;
}
} // namespace interlock::dem
