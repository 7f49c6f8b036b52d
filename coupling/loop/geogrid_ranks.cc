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
  double section = 0;
  for (const dem::Rib& rib : ribs.all()) {
    for (const dem::Vector3& x : rib.x) box.extend(x);
    section = std::max(section, dem::section_reach(rib));
  }
  // A stone is near before it touches (RibContacts::near_clumps).
  const double reach = section + dem::RibContacts::largest_skin + 2 * room;
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.ghost[i] == 0 &&
        box.exteriorDistance(dem::Vector3(clumps.position[i])) <= clumps.bounding_radius(i) + reach)
      return true;
  return false;
}
} // namespace

GeogridRanks::GeogridRanks(const dem::Ranks& ranks, const dem::Clumps& clumps,
                           const dem::RibSet& ribs, double room)
    : group_(ranks, ranks.rank() == 0 || some_could_come(clumps, ribs, room))
{
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
} // namespace interlock::coupling
