#include "dem/parallel/partition.h"

#include <metis.h>

#include <stdexcept>
#include <string>

namespace interlock::dem
{
std::vector<int> partition(const CellGrid& grid, const std::vector<int>& cost, int ranks)
{
  if (ranks == 1 || grid.size() < ranks) return std::vector<int>(grid.size(), 0);

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
  idx_t n = grid.size(), constraints = 1, parts = ranks, cut = 0;
  std::vector<idx_t> part(n, 0);
  const int result = METIS_PartGraphRecursive(&n, &constraints, begin.data(), neighbours.data(),
                                              weight.data(), nullptr, edge_weight.data(), &parts,
                                              nullptr, nullptr, options, &cut, part.data());
  if (result != METIS_OK)
    throw std::runtime_error("METIS could not divide " + std::to_string(grid.size()) +
                             " cells among " + std::to_string(parts) + " ranks.");
  return {part.begin(), part.end()};
}
} // namespace interlock::dem
