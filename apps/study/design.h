// Which values a study puts together.
#pragma once

#include "apps/study/study_file.h"

namespace interlock::apps
{
// One choice of a level for every factor.
struct Point {
  std::vector<Level> levels; // by factor
  std::vector<int> places;   // of these levels in their factors; -1 where they were drawn
  int filling = -1;          // of Sobol's matrices alone: the filling that belongs to it
};

// grid: all combinations, the last factor changing fastest. one at a time: the first level of every
// factor, then each other level alone. latin hypercube: `samples` points, each range cut into so
// many strata of equal width, one point in each (McKay, Beckman and Conover, Technometrics 21
// (1979) 239-245). sobol: the matrices A, B and A with column i of B, row by row (Saltelli et al.,
// Comput. Phys. Commun. 181 (2010) 259-270); more than one filling is a column, the last one.
// The same file gives the same points everywhere.
std::vector<Point> design_points(const StudyFile& study);

// Numbers in [0, 1), one row a sample, one column a factor.
std::vector<std::vector<double>> latin_hypercube(int samples, int columns, std::uint64_t seed);

// Columns of Sobol's matrices: the factors, and the filling where there are several.
int sobol_columns(const StudyFile& study);
} // namespace interlock::apps
