// A sheet that is cut off beside its last whole apertures.
#pragma once

#include "fem/ribs/rib_line.h"

#include <vector>

namespace interlock::fem
{
// Where a plane sheet is cut: at a distance of half a width from its middle line, along x. Cut
// edges at its ends are those of the lines [m].
struct SheetCut {
  double middle = 0; // y of the middle line
  double width = 0;
};

// The same lines with tails: a rib that ends at the last junction before a cut goes on straight to
// it, if that is not beyond the first and the last x of the lines. Elements of tails are about as
// long as those of the rib. A tail shorter than half its rib's width is left out: it would lie in
// the junction. Throws std::invalid_argument when a line reaches beyond the cut already.
std::vector<RibLine> run_to_cut(std::vector<RibLine> lines, const SheetCut& cut);
} // namespace interlock::fem
