// Which rank owns which cells.
#pragma once

#include "dem/parallel/cell_grid.h"

namespace interlock::dem
{
// Owner of each cell: parts of about equal sums of `cost` (one entry a cell, 0 and more) with few
// neighbours in others, by METIS (Karypis and Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392). The
// same on every rank that calls it with the same numbers. Throws std::runtime_error when METIS
// cannot.
std::vector<int> partition(const CellGrid& grid, const std::vector<int>& cost, int ranks);
} // namespace interlock::dem
