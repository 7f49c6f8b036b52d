#include "dem/parallel/partition.h"

#include <metis.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace interlock::dem
{
std::vector<double> fair_shares(double cost, double load, int ranks)
{
  const double mean = (cost + load) / ranks, first = std::max(0., mean - load);
  std::vector<double> shares(ranks, (cost - first) / std::max(1, ranks - 1));
  shares[0] = ranks == 1 ? cost : first;
  return shares;
}

std::vector<int> partition(const CellGrid& grid, const std::vector<int>& cost,
                           const std::vector<double>& shares)
{
  // METIS wants a part of something for everybody.
  const double all = std::accumulate(shares.begin(), shares.end(), 0.);
  std::vector<int> rank;       // of each part
  std::vector<real_t> targets; // of each part, of 1
  for (std::size_t r = 0; r < shares.size(); ++r) {
    if (!(shares[r] > 0.02 * all / static_cast<double>(shares.size()))) continue;
    rank.push_back(static_cast<int>(r));
    targets.push_back(static_cast<real_t>(shares[r] / all));
  }
  const real_t sum = std::accumulate(targets.begin(), targets.end(), real_t(0));
  for (real_t& target : targets) target /= sum;
  if (rank.empty()) rank.push_back(0);
  if (rank.size() == 1 || grid.size() < static_cast<int>(rank.size()))
    return std::vector<int>(grid.size(), rank.back());

  std::vector<idx_t> begin = {0}, neighbours, edge_weight, weight;
  for (int cell = 0; cell < grid.size(); ++cell) {
    for (const int other : grid.neighbours(cell)) {
      neighbours.push_back(other);
      // What a cut would copy: the clumps on both sides.
      edge_weight.push_back(1 + cost[cell] + cost[other]);
    }
    begin.push_back(static_cast<idx_t>(neighbours.size()));
    weight.push_back(cost[cell]);
  }
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  idx_t n = grid.size(), constraints = 1, parts = static_cast<idx_t>(rank.size()), cut = 0;
  std::vector<idx_t> part(n, 0);
  const int result = METIS_PartGraphRecursive(&n, &constraints, begin.data(), neighbours.data(),
                                              weight.data(), nullptr, edge_weight.data(), &parts,
                                              targets.data(), nullptr, options, &cut, part.data());
  if (result != METIS_OK)
    throw std::runtime_error("METIS could not divide " + std::to_string(grid.size()) +
                             " cells among " + std::to_string(parts) + " ranks.");
  std::vector<int> owner;
  for (const idx_t p : part) owner.push_back(rank[p]);
  return owner;
}
} // namespace interlock::dem
