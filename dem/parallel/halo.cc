#include "dem/parallel/halo.h"

#include <array>

namespace interlock::dem
{
namespace
{
// Numbers of a ghost: position, attitude, velocity and spin of the step.
constexpr int numbers_of_a_ghost = 13;

std::array<double*, numbers_of_a_ghost> rows_of_a_ghost(Clumps& clumps)
{
  VectorField &x = clumps.position, &v = clumps.step_velocity, &w = clumps.step_spin;
  QuaternionField& q = clumps.orientation;
  return {x.row(0), x.row(1), x.row(2), q.row(0), q.row(1), q.row(2), q.row(3),
          v.row(0), v.row(1), v.row(2), w.row(0), w.row(1), w.row(2)};
}
} // namespace

Halo::~Halo()
{
  disconnect();
}

void Halo::disconnect()
{
  for (MPI_Request& request : requests_) MPI_Request_free(&request);
  requests_.clear();
}

void Halo::connect(const ClumpsOfRanks& there, const ClumpsOfRanks& here)
{
  const auto take = [](const ClumpsOfRanks& lists, Neighbours& neighbours) {
    neighbours = Neighbours();
    for (const auto& [rank, list] : lists) {
      neighbours.ranks.push_back(rank);
      neighbours.begins.push_back(numbers_of_a_ghost * static_cast<int>(neighbours.clumps.size()));
      neighbours.lengths.push_back(numbers_of_a_ghost * static_cast<int>(list.size()));
      neighbours.clumps.insert(neighbours.clumps.end(), list.begin(), list.end());
    }
    neighbours.numbers.resize(numbers_of_a_ghost * neighbours.clumps.size());
  };
  take(there, to_);
  take(here, from_);
  // Of every step until the next deal.
  disconnect();
  constexpr int tag = 1;
  const auto request_of = [&](Neighbours& neighbours, std::size_t k, const auto& init) {
    requests_.emplace_back();
    init(neighbours.numbers.data() + neighbours.begins[k], neighbours.lengths[k], MPI_DOUBLE,
         neighbours.ranks[k], tag, comm_, &requests_.back());
  };
  for (std::size_t k = 0; k < from_.ranks.size(); ++k) request_of(from_, k, MPI_Recv_init);
  for (std::size_t k = 0; k < to_.ranks.size(); ++k) request_of(to_, k, MPI_Send_init);
}

void Halo::refresh(Clumps& clumps)
{
  const std::array<double*, numbers_of_a_ghost> rows = rows_of_a_ghost(clumps);
  double* out = to_.numbers.data();
  for (const int i : to_.clumps)
    for (const double* row : rows) *out++ = row[i];
  // Open MPI takes no empty list.
  if (const int n = static_cast<int>(requests_.size()); n > 0) {
    MPI_Startall(n, requests_.data());
    MPI_Waitall(n, requests_.data(), MPI_STATUSES_IGNORE);
  }
  const double* in = from_.numbers.data();
  for (const int i : from_.clumps)
    for (double* row : rows) row[i] = *in++;
  // Lists go by these.
  for (const int i : from_.clumps) {
    clumps.velocity[i] = clumps.step_velocity[i];
    clumps.spin[i] = clumps.step_spin[i];
  }
}
} // namespace interlock::dem
