// What every geogrid layout demands of its numbers.
#pragma once

namespace interlock::fem
{
// Throws std::invalid_argument unless the value is positive and finite. The message says "The
// <name> of a geogrid is ...".
void require_positive(double value, const char* name);

// Throws std::invalid_argument when ribs of this width [m] leave no gap at this pitch, centre line
// to centre line [m]. The message says "The <name> of a geogrid is ...".
void require_gap(double width, double pitch, const char* name);
} // namespace interlock::fem
