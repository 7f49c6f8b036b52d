#include "dem/parallel/domain.h"

#include "dem/parallel/byte_archive.h"
#include "dem/parallel/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

namespace interlock::dem
{
template <class Archive> void exchange(Archive& archive, ClumpState& s)
{
  archive("id", s.id);
  archive("shape", s.shape);
  archive("kind", s.kind);
  archive("mass", s.mass, "kg");
  archive("inertia", s.inertia, "kg m2");
  archive("position", s.position, "m");
  archive("orientation", s.orientation);
  archive("velocity", s.velocity, "m/s");
  archive("angular_momentum", s.angular_momentum, "kg m2/s");
  archive("drift_velocity", s.drift_velocity, "m/s");
  archive("spin", s.spin, "rad/s");
  archive("step_velocity", s.step_velocity, "m/s");
  archive("step_spin", s.step_spin, "rad/s");
  archive("force", s.force, "N");
  archive("torque", s.torque, "N m");
  archive("is_ghost", s.is_ghost);
}

struct Domain::Parcel {
  std::vector<ClumpState> clumps;
  ContactMemory contacts;

  template <class Archive> friend void exchange(Archive& archive, Parcel& parcel)
  {
    archive("clumps", parcel.clumps);
    archive("contacts", parcel.contacts);
  }
};

namespace
{
// Numbers of a ghost: position, attitude, velocity and spin of the step.
constexpr int numbers_of_a_ghost = 13;
// Largest load of a rank over the mean with which cells stay where they are.
constexpr double fair = 1.05;

std::array<double*, numbers_of_a_ghost> rows_of_a_ghost(Clumps& clumps)
{
  VectorField &x = clumps.position, &v = clumps.step_velocity, &w = clumps.step_spin;
  QuaternionField& q = clumps.orientation;
  return {x.row(0), x.row(1), x.row(2), q.row(0), q.row(1), q.row(2), q.row(3),
          v.row(0), v.row(1), v.row(2), w.row(0), w.row(1), w.row(2)};
}

template <class T> void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// In the order that ContactMemory promises.
void sort(ContactMemory& memory)
{
  std::sort(memory.pairs.begin(), memory.pairs.end(), [](const auto& p, const auto& q) {
    return std::tie(p.first, p.second, p.a, p.b) < std::tie(q.first, q.second, q.a, q.b);
  });
  std::sort(memory.walls.begin(), memory.walls.end(), [](const auto& p, const auto& q) {
    return std::tie(p.wall, p.clump, p.a) < std::tie(q.wall, q.clump, q.a);
  });
  // Those of one member with one wall stay as the engine found them.
  std::stable_sort(memory.meshes.begin(), memory.meshes.end(), [](const auto& p, const auto& q) {
    return std::tie(p.clump, p.wall, p.a) < std::tie(q.clump, q.wall, q.a);
  });
  std::sort(memory.rolling.begin(), memory.rolling.end(), [](const auto& p, const auto& q) {
    return std::tie(p.kind, p.first, p.second, p.a, p.b) <
           std::tie(q.kind, q.first, q.second, q.a, q.b);
  });
}
} // namespace

Domain::Domain(const Ranks& ranks, const CellGrid& grid) : ranks_(ranks), grid_(grid) {}

Domain::~Domain()
{
  await_answer();
  if (graph_ != MPI_COMM_NULL) MPI_Comm_free(&graph_);
}

std::vector<int> Domain::ranks_near(const Vector3& x, int cell, double radius) const
{
  // Who touches it later, with its centre in the cell now, is this near now.
  const double reach = radius + largest_ + 2 * room_;
  std::set<int> ranks;
  for (const int near : grid_.neighbours(cell))
    if (owner_[near] != owner_[cell] && grid_.distance(x, near) <= reach)
      ranks.insert(owner_[near]);
  return {ranks.begin(), ranks.end()};
}

void Domain::share_out_cells(const Clumps& clumps)
{
  std::vector<int> cost(grid_.size(), 0);
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.ghost[i] == 0) ++cost[grid_.cell_of(clumps.position[i])];
  cost = ranks_.sum(cost);
  if (!owner_.empty()) {
    std::vector<int> load(ranks_.size(), 0);
    for (int cell = 0; cell < grid_.size(); ++cell) load[owner_[cell]] += cost[cell];
    const double mean = std::accumulate(load.begin(), load.end(), 0.) / ranks_.size();
    if (*std::max_element(load.begin(), load.end()) < fair * mean) return;
  }
  owner_ = partition(grid_, cost, ranks_.size());
}

void Domain::deal(Engine& engine)
{
  await_answer();
  const Clumps& clumps = engine.clumps();
  largest_ = 0; // the same on all ranks, unlike the clumps that are here
  for (const ClumpShape& shape : clumps.shapes())
    largest_ = std::max(largest_, shape.bounding_radius());
  room_ = 0.5 * grid_.width() - largest_;
  if (room_ <= 0)
    throw std::logic_error("Cells of " + std::to_string(grid_.width()) +
                           " m are too narrow for clumps with a bounding radius of " +
                           std::to_string(largest_) + " m.");
  share_out_cells(clumps);

  std::vector<Parcel> parcels(ranks_.size());
  const auto owner_of = [&](std::int64_t id) {
    return owner_[grid_.cell_of(clumps.position[clumps.index_of(id)])];
  };
  const auto is_ours = [&](std::int64_t id) { return clumps.ghost[clumps.index_of(id)] == 0; };
  for (int i = 0; i < clumps.size(); ++i) {
    if (clumps.ghost[i] == 1) continue;
    const int cell = grid_.cell_of(clumps.position[i]);
    ClumpState state = clumps.state_of(i);
    parcels[owner_[cell]].clumps.push_back(state);
    state.is_ghost = true;
    for (const int rank : ranks_near(state.position, cell, clumps.bounding_radius(i)))
      parcels[rank].clumps.push_back(state);
  }
  // A contact is remembered on the ranks of both clumps; the one that had the first sends it.
  const ContactMemory memory = engine.memory();
  for (const PairMemory& c : memory.pairs) {
    if (!is_ours(c.first)) continue;
    for (const int rank : std::set<int>{owner_of(c.first), owner_of(c.second)})
      parcels[rank].contacts.pairs.push_back(c);
  }
  for (const WallMemory& c : memory.walls)
    if (is_ours(c.clump)) parcels[owner_of(c.clump)].contacts.walls.push_back(c);
  for (const MeshMemory& c : memory.meshes)
    if (is_ours(c.clump)) parcels[owner_of(c.clump)].contacts.meshes.push_back(c);
  for (const RollingMemory& c : memory.rolling) {
    if (!is_ours(c.first)) continue;
    std::set<int> ranks = {owner_of(c.first)};
    if (c.kind == 0) ranks.insert(owner_of(c.second));
    for (const int rank : ranks) parcels[rank].contacts.rolling.push_back(c);
  }

  std::vector<Bytes> messages(ranks_.size());
  for (int r = 0; r < ranks_.size(); ++r) {
    ByteWriter writer(messages[r]);
    writer("parcel", parcels[r]);
  }
  Parcel mine;
  for (const Bytes& message : ranks_.exchange(messages)) {
    Parcel parcel;
    ByteReader reader(message);
    reader("parcel", parcel);
    append(mine.clumps, parcel.clumps);
    append(mine.contacts.pairs, parcel.contacts.pairs);
    append(mine.contacts.walls, parcel.contacts.walls);
    append(mine.contacts.meshes, parcel.contacts.meshes);
    append(mine.contacts.rolling, parcel.contacts.rolling);
  }
  std::sort(mine.clumps.begin(), mine.clumps.end(),
            [](const ClumpState& p, const ClumpState& q) { return p.id < q.id; });
  sort(mine.contacts);
  engine.replace_clumps(mine.clumps, mine.contacts);
  dealt_ = engine.clumps().position;
  answer_ = 0;
  connect(engine.clumps());
}

// Both sides find the same clumps from the cells alone, in the same order: nothing needs to be
// told.
void Domain::connect(const Clumps& clumps)
{
  std::map<int, std::vector<int>> ghosts_there, ghosts_here;
  for (int i = 0; i < clumps.size(); ++i) {
    const int cell = grid_.cell_of(clumps.position[i]);
    if (clumps.ghost[i] == 1) {
      ghosts_here[owner_[cell]].push_back(i);
      continue;
    }
    for (const int rank : ranks_near(clumps.position[i], cell, clumps.bounding_radius(i)))
      ghosts_there[rank].push_back(i);
  }
  const auto take = [](const std::map<int, std::vector<int>>& lists, Neighbours& neighbours) {
    neighbours = Neighbours();
    for (const auto& [rank, list] : lists) {
      neighbours.ranks.push_back(rank);
      neighbours.begins.push_back(numbers_of_a_ghost * static_cast<int>(neighbours.clumps.size()));
      neighbours.lengths.push_back(numbers_of_a_ghost * static_cast<int>(list.size()));
      append(neighbours.clumps, list);
    }
    neighbours.numbers.resize(numbers_of_a_ghost * neighbours.clumps.size());
  };
  take(ghosts_there, to_);
  take(ghosts_here, from_);
  if (graph_ != MPI_COMM_NULL) MPI_Comm_free(&graph_);
  MPI_Dist_graph_create_adjacent(ranks_.comm(), static_cast<int>(from_.ranks.size()),
                                 from_.ranks.data(), MPI_UNWEIGHTED,
                                 static_cast<int>(to_.ranks.size()), to_.ranks.data(),
                                 MPI_UNWEIGHTED, MPI_INFO_NULL, 0, &graph_);
}

bool Domain::has_expired(const Engine& engine)
{
  if (ranks_.size() == 1) return false; // nothing is missed without ghosts
  const VectorField& x = engine.clumps().position;
  const double *x0 = x.row(0), *x1 = x.row(1), *x2 = x.row(2);
  const double *d0 = dealt_.row(0), *d1 = dealt_.row(1), *d2 = dealt_.row(2);
  double moved = 0; // square
#pragma omp simd reduction(max : moved)
  for (int i = 0; i < x.size(); ++i) {
    const double a = x0[i] - d0[i], b = x1[i] - d1[i], c = x2[i] - d2[i];
    const double square = a * a + b * b + c * c;
    moved = moved > square ? moved : square;
  }
  if (moved > room_ * room_)
    throw std::runtime_error("A clump moved by " + std::to_string(std::sqrt(moved)) +
                             " m before the ranks could agree to deal the clumps anew; " +
                             std::to_string(room_) + " m were left to it.");
  await_answer();
  const bool expired = answer_ > 0;
  asked_ = moved > 0.25 * room_ * room_ ? 1 : 0;
  MPI_Iallreduce(&asked_, &answer_, 1, MPI_INT, MPI_SUM, ranks_.comm(), &question_);
  return expired;
}

void Domain::await_answer()
{
  if (question_ == MPI_REQUEST_NULL)
    answer_ = 0;
  else
    MPI_Wait(&question_, MPI_STATUS_IGNORE);
}

void Domain::refresh(Engine& engine)
{
  Clumps& clumps = engine.clumps();
  const std::array<double*, numbers_of_a_ghost> rows = rows_of_a_ghost(clumps);
  double* out = to_.numbers.data();
  for (const int i : to_.clumps)
    for (const double* row : rows) *out++ = row[i];
  MPI_Neighbor_alltoallv(to_.numbers.data(), to_.lengths.data(), to_.begins.data(), MPI_DOUBLE,
                         from_.numbers.data(), from_.lengths.data(), from_.begins.data(),
                         MPI_DOUBLE, graph_);
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
