// How finely the coordinates of a scan tell places apart, far from the origin of its frame.
#pragma once

#include "dem/scans/input_file.h"
#include "dem/vector.h"

#include <vector>

namespace interlock::dem
{
// Single precision has 24 binary digits: at 50 km from the origin its numbers are 3.9 mm apart, and
// a stone in survey coordinates becomes a staircase. Rounding moves each coordinate by up to half a
// step, so lengths are off by up to one; the volume of a box of 60 mm by up to 3 steps / 60 mm.
//
// `points` (used ones only) and `single_precision` are as in the file, `length_unit` is the metres
// of its unit. Throws InputError when single precision has steps above coarsest_step of the largest
// extent. Returns a note, the end of a sentence without the full stop, or nothing:
// * single precision has steps above noted_step, which is what a volume from a scan is off by
//   anyhow;
// * a file that could be finer, of text or doubles, holds single precision all the same: at least
//   30 different coordinates near the largest one are such numbers to nine digits;
// * or it holds so few decimal digits that the steps are above noted_step, more than ten extents
//   from the origin, where digits are used up by the distance. Nearer to it, or with less than
//   twelve different coordinates, whole millimetres are a drawing's.
// That the last two were rounded is likely, not sure: they are never refused.
std::string check_resolution(const InputFile& file, const std::vector<Vector3>& points,
                             bool single_precision, double length_unit);
constexpr double noted_step = 1e-4;    // [-]
constexpr double coarsest_step = 0.01; // [-]
} // namespace interlock::dem
