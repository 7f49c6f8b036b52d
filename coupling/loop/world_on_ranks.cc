// How several ranks share a world: who has which part when (docs/theory/parallel.md).
#include "coupling/loop/stopwatch.h"
#include "coupling/loop/world.h"
#include "dem/parallel/byte_archive.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
// What a contact with a rib costs in a step, in contacts between stones; measured with two
// sub-steps.
constexpr int cost_of_a_rib_contact = 8;

// What ranks ask for once a step, as bits.
constexpr int stop_bit = 1, keep_bit = 2, deal_bit = 4, inner_bit = 8, middle_bit = 16;
} // namespace

void World::share_among(const dem::Ranks& ranks)
{
  if (ranks.size() == 1) return;
  domain_.emplace(ranks);
  if (const char* every = std::getenv("INTERLOCK_DEAL_EVERY")) deal_every_ = std::atoi(every);
  agreement_.emplace(ranks);
  ribs.share(*domain_);
}

void World::require_whole() const
{
  if (!is_whole()) throw std::logic_error("This rank has only a part of the world.");
}

void World::make_whole()
{
  if (is_whole()) return;
  note_times();
  const Stopwatch watch(times_.sharing);
  RibSide side;
  if (geogrid_) {
    receive_geogrid();
    ribs.unite_sums();
    side = rib_side_of_all();
  }
  domain_->gather(engine);
  ++times_.gathers;
  if (geogrid_) ribs.restore(std::move(side));
}

// The stones near a geogrid are few: everybody gets what all of them remember, and keeps what is
// of the own ones.
RibSide World::rib_side_of_all() const
{
  RibSide mine = ribs.memory(), all;
  dem::Bytes bytes;
  dem::ByteWriter writer(bytes);
  writer("ribs", mine);
  for (const dem::Bytes& said : domain_->ranks().all(bytes)) {
    dem::ByteReader reader(said);
    RibSide theirs;
    reader("ribs", theirs);
    all.append(theirs);
  }
  return all;
}

void World::begin_step(bool whole)
{
  if (!domain_) return;
  if (whole)
    make_whole();
  else if (is_whole() || deal_is_due_)
    deal();
}

void World::deal()
{
  if (!is_whole()) note_times();
  const Stopwatch watch(times_.sharing);
  RibSide side;
  std::vector<dem::ClumpCost> costs;
  if (geogrid_) {
    ribs.unite_sums();
    if (is_whole())
      side = ribs.memory();
    else {
      receive_geogrid();
      side = rib_side_of_all();
    }
    for (const dem::RibMemory& contact : side.contacts)
      costs.push_back({contact.clump, cost_of_a_rib_contact});
    dealt_ribs_ = geogrid_->ribs().position;
  }
  domain_->deal(engine, costs,
                geogrid_ ? costs_of_parts(*geogrid_) : std::vector<dem::PlaceCost>());
  if (geogrid_) {
    ribs.restore(std::move(side));
    ribs.choose_geogrid_ranks();
  }
  ++times_.deals;
  deal_is_due_ = false;
  fulfilled_ |= deal_bit;
}

// Of the steps since the last deal.
void World::note_times()
{
  times_.lattice = ribs.lattice_time();
  times_.ribs = ribs.rib_time();
  times_.messages = ribs.message_time();
  const double steps = static_cast<double>(times_.steps - noted_steps_);
  const dem::ScalarField& ghost = engine.clumps().ghost;
  const double ghosts = static_cast<double>(std::count(ghost.begin(), ghost.end(), 1.));
  times_.ghosts += steps * ghosts;
  times_.clumps += steps * (engine.clumps().size() - ghosts);
  noted_steps_ = times_.steps;
}

std::vector<RankTimes> World::times() const
{
  std::vector<RankTimes> all;
  if (!domain_) return all;
  dem::Bytes mine(sizeof times_);
  std::memcpy(mine.data(), &times_, sizeof times_);
  for (const dem::Bytes& said : domain_->ranks().all(mine)) {
    all.emplace_back();
    std::memcpy(&all.back(), said.data(), sizeof times_);
    const double steps = std::max<double>(1, all.back().steps);
    all.back().clumps /= steps, all.back().ghosts /= steps;
  }
  return all;
}

// The motion of the geogrid, from those that have moved it. Its ribs are where they are now on all
// ranks.
void World::receive_geogrid()
{
  ribs.complete_geogrid();
  geogrid_->hold_all();
  geogrid_->refresh_ribs();
  if (ribs.all_move_geogrid()) return;
  dem::Bytes bytes;
  dem::ByteWriter writer(bytes);
  writer("geogrid", *geogrid_);
  ribs.exchange_step(writer);
  bytes = domain_->ranks().from(0, std::move(bytes));
  if (ribs.moves_geogrid()) return;
  dem::ByteReader reader(bytes);
  reader("geogrid", *geogrid_);
  ribs.exchange_step(reader);
}

// Every rank that moves it looks at what it moves.
bool World::geogrid_has_moved() const
{
  if (!geogrid_ || !ribs.moves_geogrid()) return false;
  const dem::VectorField& x = geogrid_->ribs().position;
  double moved = 0; // square
  for (const dem::EndRange& ends : geogrid_->ribs().present_ends())
    for (int e = ends.begin; e < std::min(ends.end, x.size()); ++e)
      moved = std::max(moved, dem::Vector3(x[e] - dealt_ribs_[e]).squaredNorm());
  const double room = domain_->room();
  if (moved > room * room)
    throw std::runtime_error("The geogrid moved too far before the ranks could agree to deal the "
                             "stones anew.");
  return moved > 0.8 * room * room;
}

World::Wishes World::agree(const Wishes& mine)
{
  if (!domain_) return mine;
  const bool asked_to = deal_every_ > 0 && clock.step % deal_every_ == 0;
  const bool deal =
      !is_whole() && (asked_to || domain_->has_expired(engine, clock.dt) || geogrid_has_moved());
  const dem::NeighbourLists::Levels lists = engine.expiring_lists();
  int answer = agreement_->exchange((mine.stop ? stop_bit : 0) | (mine.keep ? keep_bit : 0) |
                                    (deal ? deal_bit : 0) | (lists.inner ? inner_bit : 0) |
                                    (lists.middle ? middle_bit : 0));
  ribs.receive_ghosts();
  // What was asked for before it was done is asked for no more.
  answer &= ~fulfilled_;
  fulfilled_ = answer & keep_bit;
  engine.renew_lists({(answer & inner_bit) != 0, (answer & middle_bit) != 0});
  deal_is_due_ = (answer & deal_bit) != 0;
  return {(answer & stop_bit) != 0, (answer & keep_bit) != 0};
}

std::string World::first_sentence(const std::string& mine) const
{
  if (!domain_) return mine;
  const dem::Ranks& ranks = domain_->ranks();
  const double silent = ranks.size();
  const double first = -ranks.largest(-(mine.empty() ? silent : ranks.rank()));
  return first < silent ? ranks.from(static_cast<int>(first), mine) : "";
}

dem::StableStep World::stable_step() const
{
  dem::StableStep step = engine.stable_step(&ribs.rib_contacts());
  if (is_whole()) return step;
  // Of the clumps that are moved here: those of ghosts do not know all of their contacts.
  dem::Bytes bytes;
  dem::ByteWriter writer(bytes);
  writer("step", step);
  for (const dem::Bytes& said : domain_->ranks().all(bytes)) {
    dem::StableStep other;
    dem::ByteReader reader(said);
    reader("step", other);
    const bool smaller =
        other.step < step.step || (other.step == step.step && other.clump_id < step.clump_id);
    if (other.step > 0 && (step.step == 0 || smaller)) step = other;
  }
  return step;
}
} // namespace interlock::coupling
