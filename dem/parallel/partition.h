// Which rank owns which cells.
#pragma once

#include "dem/parallel/cell_grid.h"

namespace interlock::dem
{
// What each rank should get of a cost, when the first one has `load` of the same unit besides:
// equal sums, or nothing for the first one where it has more than its share already.
std::vector<double> fair_shares(double cost, double load, int ranks);

// Owner of each cell: parts of about these shares of `cost` (one entry a cell, 0 and more) with few
// neighbours in others, by METIS (Karypis and Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392). The
// same on every rank that calls it with the same numbers. Throws std::runtime_error when METIS
// cannot.
std::vector<int> partition(const CellGrid& grid, const std::vector<int>& cost,
                           const std::vector<double>& shares);
} // namespace interlock::dem
