#include "dem/parallel/domain.h"

#include "dem/parallel/parcel.h"
#include "dem/parallel/partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace interlock::dem
{
namespace
{
// Largest load of a rank over its share with which cells stay where they are.
constexpr double fair = 1.05;
// Over the largest bounding radius: half of what is more than two is how far clumps may move.
constexpr double cell_width = 2.4;
// Beside its contacts with others and walls, each of which costs 1 (half of an evaluation).
constexpr int cost_of_a_clump = 3;
// Clumps are dealt anew when one will have gone that share of its way in so many steps, at the
// speed that it has: two pass until all ranks know.
constexpr double usable = 0.95, notice_steps = 4;

// Position, attitude, velocity and spin of the step.
std::vector<double*> numbers_of_ghosts(Clumps& clumps)
{
  VectorField &x = clumps.position, &v = clumps.step_velocity, &w = clumps.step_spin;
  QuaternionField& q = clumps.orientation;
  return {x.row(0), x.row(1), x.row(2), q.row(0), q.row(1), q.row(2), q.row(3),
          v.row(0), v.row(1), v.row(2), w.row(0), w.row(1), w.row(2)};
}
} // namespace

// Who touches a clump later is near it now: both may move by the room. On the rank that moves a
// clump everybody near it is there, too.
Domain::Place Domain::place_of(const Clumps& clumps, int i) const
{
  const Vector3 x = clumps.position[i];
  const int cell = grid_.cell_of(x);
  Place place;
  place.owner = owner_[cell];
  std::set<int> near;
  for (const int other : grid_.neighbours(cell))
    if (grid_.distance(x, other) <= clumps.bounding_radius(i) + largest_ + 2 * room_)
      near.insert(owner_[other]);
  near.erase(place.owner);
  place.copies.assign(near.begin(), near.end());
  return place;
}

void Domain::lay_cells(const Clumps& clumps)
{
  Eigen::AlignedBox3d box(Vector3::Zero());
  if (clumps.size() > 0) box = Eigen::AlignedBox3d(Vector3(clumps.position[0]));
  largest_ = 1e-3;
  for (int i = 0; i < clumps.size(); ++i) {
    box.extend(Vector3(clumps.position[i]));
    largest_ = std::max(largest_, clumps.bounding_radius(i));
  }
  grid_ = CellGrid(box.min(), box.max(), cell_width * largest_);
  room_ = (0.5 * cell_width - 1) * largest_;
  owner_.clear();
}

// By what the clumps in them cost.
void Domain::share_out_cells(const Clumps& clumps, const ContactMemory& contacts,
                             const std::vector<ClumpCost>& besides,
                             const std::vector<PlaceCost>& elsewhere)
{
  std::vector<int> of_clump(clumps.size(), cost_of_a_clump);
  const auto add = [&](std::int64_t id, int cost = 1) {
    const int i = clumps.index_of(id);
    if (i >= 0) of_clump[i] += cost;
  };
  for (const PairMemory& c : contacts.pairs) add(c.first), add(c.second);
  for (const WallMemory& c : contacts.walls) add(c.clump);
  for (const ClumpCost& c : besides) add(c.clump, c.cost);
  std::vector<int> cost(grid_.size(), 0);
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.ghost[i] == 0) cost[grid_.cell_of(clumps.position[i])] += of_clump[i];
  if (!whole_) cost = ranks_.sum(cost);
  for (const PlaceCost& c : elsewhere) cost[grid_.cell_of(c.place)] += c.cost;
  if (!owner_.empty()) {
    std::vector<double> of_rank(ranks_.size(), 0.);
    for (int cell = 0; cell < grid_.size(); ++cell) of_rank[owner_[cell]] += cost[cell];
    const double share = std::accumulate(of_rank.begin(), of_rank.end(), 0.) / ranks_.size();
    if (*std::max_element(of_rank.begin(), of_rank.end()) <= fair * share + 1) return;
  }
  owner_ = partition(grid_, cost, ranks_.size());
}

void Domain::deal(Engine& engine, const std::vector<ClumpCost>& besides,
                  const std::vector<PlaceCost>& elsewhere)
{
  if (whole_) lay_cells(engine.clumps());
  ContactMemory memory = engine.memory();
  share_out_cells(engine.clumps(), memory, besides, elsewhere);
  if (whole_)
    deal_whole(engine, std::move(memory));
  else
    deal_parts(engine, memory);
  whole_ = false;
  engine.set_ranks({[this](std::vector<double>& numbers) { ranks_.sum(numbers); },
                    [this](double mine) { return ranks_.largest(mine); }});
  dealt_ = engine.clumps().position;
  connect(engine.clumps());
}

// Every rank has everything and lets go of what is not its own: nothing is sent.
void Domain::deal_whole(Engine& engine, ContactMemory memory)
{
  const Clumps& clumps = engine.clumps();
  const int me = ranks_.rank();
  Parcel mine;
  std::vector<bool> ours(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) {
    const Place place = place_of(clumps, i);
    ours[i] = place.owner == me;
    if (!ours[i] && !std::binary_search(place.copies.begin(), place.copies.end(), me)) continue;
    mine.clumps.push_back(clumps.state_of(i));
    mine.clumps.back().is_ghost = !ours[i];
  }
  const auto is_ours = [&](std::int64_t id) { return ours[clumps.index_of(id)]; };
  mine.contacts = std::move(memory);
  mine.keep([&](std::int64_t first, std::int64_t second) {
    return is_ours(first) || (second >= 0 && is_ours(second));
  });
  engine.replace_clumps(mine.clumps, mine.contacts);
}

void Domain::deal_parts(Engine& engine, const ContactMemory& memory)
{
  const Clumps& clumps = engine.clumps();
  std::vector<Parcel> parcels(ranks_.size());
  const auto owner_of_clump = [&](std::int64_t id) {
    const int i = clumps.index_of(id);
    return owner_of(clumps.position[i]);
  };
  const auto is_ours = [&](std::int64_t id) { return clumps.ghost[clumps.index_of(id)] == 0; };
  for (int i = 0; i < clumps.size(); ++i) {
    if (clumps.ghost[i] == 1) continue;
    const Place place = place_of(clumps, i);
    ClumpState state = clumps.state_of(i);
    parcels[place.owner].clumps.push_back(state);
    state.is_ghost = true;
    for (const int rank : place.copies) parcels[rank].clumps.push_back(state);
  }
  // A contact is remembered on the ranks of both clumps; the one that had the first sends it.
  for (const PairMemory& c : memory.pairs) {
    if (!is_ours(c.first)) continue;
    for (const int rank : std::set<int>{owner_of_clump(c.first), owner_of_clump(c.second)})
      parcels[rank].contacts.pairs.push_back(c);
  }
  for (const WallMemory& c : memory.walls)
    if (is_ours(c.clump)) parcels[owner_of_clump(c.clump)].contacts.walls.push_back(c);
  for (const MeshMemory& c : memory.meshes)
    if (is_ours(c.clump)) parcels[owner_of_clump(c.clump)].contacts.meshes.push_back(c);
  for (const RollingMemory& c : memory.rolling) {
    if (!is_ours(c.first)) continue;
    std::set<int> ranks = {owner_of_clump(c.first)};
    if (c.kind == 0) ranks.insert(owner_of_clump(c.second));
    for (const int rank : ranks) parcels[rank].contacts.rolling.push_back(c);
  }

  std::vector<Bytes> messages;
  for (const Parcel& parcel : parcels) messages.push_back(parcel.packed());
  const Parcel mine = Parcel::merged(ranks_.exchange(messages));
  engine.replace_clumps(mine.clumps, mine.contacts);
}

void Domain::gather(Engine& engine)
{
  if (whole_) return;
  engine.complete_wall_forces();
  const Clumps& clumps = engine.clumps();
  const auto is_ours = [&](std::int64_t id) { return clumps.ghost[clumps.index_of(id)] == 0; };
  Parcel mine;
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.ghost[i] == 0) mine.clumps.push_back(clumps.state_of(i));
  mine.contacts = engine.memory();
  mine.keep([&](std::int64_t first, std::int64_t) { return is_ours(first); });
  const Parcel all = Parcel::merged(ranks_.all(mine.packed()));
  engine.replace_clumps(all.clumps, all.contacts);
  engine.set_ranks({});
  whole_ = true;
}

// Both sides find the same clumps from their places alone, in the same order: nothing needs to be
// told.
void Domain::connect(const Clumps& clumps)
{
  Halo::EntriesOfRanks ghosts_there, ghosts_here;
  for (int i = 0; i < clumps.size(); ++i) {
    const Place place = place_of(clumps, i);
    if (clumps.ghost[i] == 1)
      ghosts_here[place.owner].push_back(i);
    else
      for (const int rank : place.copies) ghosts_there[rank].push_back(i);
  }
  constexpr int numbers = 13;
  halo_.connect(ghosts_there, ghosts_here, numbers);
}

void Domain::start_refresh(Engine& engine)
{
  halo_.start(numbers_of_ghosts(engine.clumps()));
}

void Domain::finish_refresh(Engine& engine)
{
  Clumps& clumps = engine.clumps();
  halo_.finish(numbers_of_ghosts(clumps));
  // Lists go by these.
  for (const int i : halo_.copies()) {
    clumps.velocity[i] = clumps.step_velocity[i];
    clumps.spin[i] = clumps.step_spin[i];
  }
}

bool Domain::has_expired(const Engine& engine, double dt) const
{
  if (whole_) return false;
  const VectorField &x = engine.clumps().position, &v = engine.clumps().velocity;
  const double *x0 = x.row(0), *x1 = x.row(1), *x2 = x.row(2);
  const double *v0 = v.row(0), *v1 = v.row(1), *v2 = v.row(2);
  const double *d0 = dealt_.row(0), *d1 = dealt_.row(1), *d2 = dealt_.row(2);
  double moved = 0, will_move = 0;
#pragma omp simd reduction(max : moved, will_move)
  for (int i = 0; i < x.size(); ++i) {
    const double a = x0[i] - d0[i], b = x1[i] - d1[i], c = x2[i] - d2[i];
    const double way = std::sqrt(a * a + b * b + c * c);
    const double speed = std::sqrt(v0[i] * v0[i] + v1[i] * v1[i] + v2[i] * v2[i]);
    const double ahead = way + notice_steps * dt * speed;
    moved = moved > way ? moved : way;
    will_move = will_move > ahead ? will_move : ahead;
  }
  if (moved > room_)
    throw std::runtime_error("A clump moved by " + std::to_string(moved) +
                             " m before the ranks could agree to deal the clumps anew; " +
                             std::to_string(room_) + " m were left to it.");
  return will_move > usable * room_;
}
} // namespace interlock::dem
