#include "coupling/loop/lattice_parts.h"

#include "dem/parallel/byte_archive.h"
#include "dem/ribs/rib_search.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>
#include <tuple>

namespace interlock::coupling
{
namespace
{
// What a block of slots costs in a step, in the units of dem::PlaceCost; measured with two
// sub-steps.
constexpr int cost_of_a_block = 20;

dem::Vector3 place_of(const fem::ExplicitDynamics& dynamics, int block)
{
  const fem::Lanes3& x = dynamics.slot_positions();
  const int slot = block * fem::ExplicitDynamics::slots_of_block();
  return {x[0][slot], x[1][slot], x[2][slot]};
}

// A block's part of all that a lattice has besides contacts that touch.
std::vector<double*> rows_of(RibTransfer& geogrid)
{
  std::vector<double*> rows = geogrid.dynamics().all_rows();
  if (RibWalls* walls = geogrid.walls())
    for (double* row : walls->rows()) rows.push_back(row);
  return rows;
}

// Messages of whole numbers.
dem::Bytes packed(const std::vector<int>& numbers)
{
  dem::Bytes bytes(numbers.size() * sizeof(int));
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<int> unpacked(const dem::Bytes& bytes)
{
  std::vector<int> numbers(bytes.size() / sizeof(int));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}
} // namespace

bool has_parts(const fem::Lattice& lattice)
{
  int most = 2000;
  // For tests.
  if (const char* elements = std::getenv("INTERLOCK_WHOLE_LATTICE_UP_TO"))
    most = std::atoi(elements);
  return lattice.n_elements() > most;
}

std::vector<dem::PlaceCost> costs_of_parts(const RibTransfer& geogrid)
{
  std::vector<dem::PlaceCost> costs;
  if (!has_parts(geogrid.lattice())) return costs;
  for (int block = 0; block < geogrid.dynamics().n_blocks(); ++block)
    costs.push_back({place_of(geogrid.dynamics(), block), cost_of_a_block});
  return costs;
}

double reach_until_dealt(double room)
{
  // A stone is near before it touches (RibContacts::near_clumps).
  return dem::RibContacts::largest_skin + 2 * room;
}

LatticeParts::LatticeParts(const dem::Domain& domain, const dem::Clumps& clumps,
                           RibTransfer& geogrid)
    : ranks_(domain.ranks()), geogrid_(geogrid), blocks_(ranks_.size()),
      motion_rows_(geogrid.dynamics().motion_rows()), halo_(ranks_.comm(), 3)
{
  const fem::ExplicitDynamics& dynamics = geogrid.dynamics();
  const int width = fem::ExplicitDynamics::slots_of_block(), me = ranks_.rank();
  for (int block = 0; block < dynamics.n_blocks(); ++block) {
    const int owner = domain.owner_of(place_of(dynamics, block));
    blocks_[owner].push_back(block);
    owner_.insert(owner_.end(), width, owner);
  }

  const std::vector<int> ribs = near_ribs(domain, clumps);
  geogrid.hold_part(blocks_[me], {});
  std::set<int> needed(dynamics.border_slots().begin(), dynamics.border_slots().end());
  std::vector<bool> loads(ranks_.size(), false);
  const std::vector<std::vector<int>> slots = dynamics.slots_of_nodes();
  for (const int rib : ribs)
    for (const int end : {0, 1}) {
      const int slot = dynamics.first_slot(rib) + end;
      if (owner_[slot] != me) needed.insert(slot);
      // A load moves its node, and that is at all slots of a junction.
      for (const int of_node : slots[dynamics.lattice().element(rib).node[end]])
        loads[owner_[of_node]] = true;
    }
  const std::vector<int> known(needed.begin(), needed.end());
  geogrid.hold_part(blocks_[me], known);
  connect(known, loads);
}

// Those that stones of this rank could touch.
std::vector<int> LatticeParts::near_ribs(const dem::Domain& domain, const dem::Clumps& clumps) const
{
  const dem::RibSearch search(geogrid_.ribs(), reach_until_dealt(domain.room()));
  std::set<int> all;
  std::vector<int> found;
  for (int i = 0; i < clumps.size(); ++i) {
    if (clumps.ghost[i] == 1) continue;
    const dem::Vector3 x = clumps.position[i];
    const double radius = clumps.bounding_radius(i);
    search.find({x.array() - radius, x.array() + radius}, found);
    all.insert(found.begin(), found.end());
  }
  return {all.begin(), all.end()};
}

// Each rank tells every other one whose slots it needs, and whether its contacts may load any.
void LatticeParts::connect(const std::vector<int>& needed, const std::vector<bool>& loads)
{
  dem::Halo::EntriesOfRanks there, here;
  for (const int slot : needed) here[owner_[slot]].push_back(slot);
  std::vector<dem::Bytes> wishes(ranks_.size());
  for (int rank = 0; rank < ranks_.size(); ++rank)
    if (rank != ranks_.rank() && (loads[rank] || here.count(rank) > 0)) {
      std::vector<int> numbers = {1}; // of a message that says something
      if (here.count(rank) > 0) numbers.insert(numbers.end(), here[rank].begin(), here[rank].end());
      wishes[rank] = packed(numbers);
    }
  const std::vector<dem::Bytes> theirs = ranks_.exchange(wishes);
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    const std::vector<int> numbers = unpacked(theirs[rank]);
    if (numbers.size() > 1) there[rank].assign(numbers.begin() + 1, numbers.end());
    if (!numbers.empty() || !wishes[rank].empty()) neighbours_.push_back(rank);
  }
  halo_.connect(there, here, static_cast<int>(motion_rows_.size()));
}

void LatticeParts::gather() const
{
  fem::ExplicitDynamics& dynamics = geogrid_.dynamics();
  const std::vector<double*> rows = rows_of(geogrid_);
  const std::size_t size = fem::ExplicitDynamics::slots_of_block() * sizeof(double);
  // Calls `copy` with each place of a rank's message and the place of the rows that it belongs to.
  const auto for_each_place = [&](int rank, dem::Bytes& message, const auto& copy) {
    std::byte* place = message.data();
    for (const int block : blocks_[rank])
      for (double* row : rows) {
        copy(place, row + block * fem::ExplicitDynamics::slots_of_block());
        place += size;
      }
  };
  const int me = ranks_.rank();
  dem::Bytes mine(blocks_[me].size() * rows.size() * size);
  for_each_place(me, mine, [&](std::byte* to, const double* from) { std::memcpy(to, from, size); });
  std::vector<dem::Bytes> all = ranks_.all(mine);
  for (int rank = 0; rank < ranks_.size(); ++rank)
    if (rank != me)
      for_each_place(rank, all[rank],
                     [&](const std::byte* from, double* to) { std::memcpy(to, from, size); });

  gather_touches();
  const fem::LatticeExtremes here = dynamics.extremes(false);
  dynamics.set_extremes({ranks_.largest(here.force), ranks_.largest(here.plastic_stretch), 0});
}

// Each rank has evaluated those of its slots, and some of others.
void LatticeParts::gather_touches() const
{
  if (!geogrid_.walls()) return;
  std::vector<RibTouch> mine, all;
  for (const RibTouch& touch : geogrid_.walls()->touches())
    if (owner_[touch.vertex] == ranks_.rank()) mine.push_back(touch);
  dem::Bytes bytes;
  dem::ByteWriter writer(bytes);
  writer("touches", mine);
  for (const dem::Bytes& said : ranks_.all(bytes)) {
    std::vector<RibTouch> theirs;
    dem::ByteReader reader(said);
    reader("touches", theirs);
    all.insert(all.end(), theirs.begin(), theirs.end());
  }
  std::sort(all.begin(), all.end(), [](const RibTouch& p, const RibTouch& q) {
    return std::tie(p.vertex, p.side) < std::tie(q.vertex, q.side);
  });
  geogrid_.walls()->set_touches(std::move(all));
}
} // namespace interlock::coupling
