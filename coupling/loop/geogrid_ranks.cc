#include "coupling/loop/geogrid_ranks.h"

#include "dem/ribs/rib_search.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace interlock::coupling
{
namespace
{
bool some_could_come(const dem::Clumps& clumps, const dem::RibSet& ribs, double room)
{
  Eigen::AlignedBox3d box;
  for (const dem::Rib& rib : ribs.all())
    box.extend(dem::RibSearch::box_around(rib, reach_until_dealt(room)));
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.ghost[i] == 0 &&
        box.exteriorDistance(dem::Vector3(clumps.position[i])) <= clumps.bounding_radius(i))
      return true;
  return false;
}
} // namespace

GeogridRanks::GeogridRanks(const dem::Domain& domain, const dem::Clumps& clumps,
                           RibTransfer& geogrid)
    : ranks_(domain.ranks()), group_(ranks_, false)
{
  if (has_parts(geogrid.lattice())) {
    parts_.emplace(domain, clumps, geogrid);
    group_ = dem::RankGroup(ranks_, parts_->neighbours());
  } else {
    const bool near = some_could_come(clumps, geogrid.ribs(), domain.room());
    group_ = dem::RankGroup(ranks_, ranks_.rank() == 0 || near);
  }
}

const std::vector<dem::RodLoads>& GeogridRanks::all_loads(const std::vector<dem::RodLoads>& mine,
                                                          const dem::RibContacts& contacts,
                                                          const dem::Clumps& clumps)
{
  mine_.clear();
  for (std::size_t k = 0; k < mine.size(); ++k) {
    const dem::RibContact& c = contacts.contacts()[contacts.loading_contacts()[k]];
    KeyedLoad load{clumps.id[c.i], c.a, c.line, mine[k].rib, 0, {}};
    double* number = load.numbers;
    for (const auto* vectors : {mine[k].force, mine[k].moment})
      for (const int end : {0, 1}) number = std::copy_n(vectors[end].data(), 3, number);
    mine_.push_back(load);
  }
  const std::vector<std::vector<KeyedLoad>> said = group_.all(mine_);

  // Each one's are in order already, and no two have a contact of the same clump.
  std::vector<const KeyedLoad*> order;
  for (const std::vector<KeyedLoad>& loads : said) {
    const auto middle = static_cast<std::ptrdiff_t>(order.size());
    for (const KeyedLoad& load : loads) order.push_back(&load);
    std::inplace_merge(order.begin(), order.begin() + middle, order.end(),
                       [](const KeyedLoad* a, const KeyedLoad* b) { return a->clump < b->clump; });
  }
  loads_.clear();
  for (const KeyedLoad* load : order) {
    dem::RodLoads loads;
    loads.rib = load->rib;
    const double* number = load->numbers;
    for (auto* vectors : {loads.force, loads.moment})
      for (const int end : {0, 1}) vectors[end] = dem::Vector3(number), number += 3;
    loads_.push_back(loads);
  }
  return loads_;
}

std::vector<NodeRate> GeogridRanks::all_rates(const std::vector<NodeRate>& mine) const
{
  std::vector<NodeRate> rates;
  for (const std::vector<NodeRate>& said : group_.all(mine))
    rates.insert(rates.end(), said.begin(), said.end());
  return rates;
}

SubstepNeeds GeogridRanks::largest_of_parts(const SubstepNeeds& mine) const
{
  if (!parts_) return mine;
  std::vector<double> numbers = {mine.contacts, mine.beams.force, mine.beams.plastic_stretch,
                                 mine.beams.bend};
  ranks_.largest(numbers);
  return {numbers[0], {numbers[1], numbers[2], numbers[3]}};
}

dem::Vector3 GeogridRanks::sum_of_parts(const dem::Vector3& mine) const
{
  if (!parts_) return mine;
  std::vector<double> sum(mine.data(), mine.data() + 3);
  ranks_.sum(sum);
  return dem::Vector3(sum.data());
}

void GeogridRanks::refresh()
{
  if (parts_) parts_->refresh();
}

void GeogridRanks::gather() const
{
  if (parts_) parts_->gather();
}
} // namespace interlock::coupling
