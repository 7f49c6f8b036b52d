// What a study says beyond its rows: means over fillings, paired differences, parts of the
// variance.
#pragma once

#include "apps/study/run_table.h"
#include "apps/study/variance_split.h"

namespace interlock::apps
{
// means.csv: one row a point and measure, over the fillings: n, mean, standard deviation, half
// width of the confidence interval.
std::string means_csv(const RunTable& table);

// differences.csv: one row a level (but the first one of its factor) and measure. A pair are two
// runs of one filling that differ in this factor alone; where several pairs share a filling their
// mean is one value, so that n counts fillings. Empty table for points that were drawn.
std::string differences_csv(const RunTable& table);

// variance.csv: one row a term and measure. Grid: every main effect and interaction of factors and
// filling; hypercube and one at a time: the point, the filling, both together; Sobol's matrices:
// first and total index of every factor. Then, for a grid, the sums over filling, geogrid, set-up,
// and what belongs to several of them. A measure that a run lacks has no row.
std::string variance_csv(const RunTable& table);

// curves.h5: force over displacement of every run, means and deviations over the fillings; empty
// where runs have none. /displacement [m]; /runs, /force: one row a run; /points, /n, /mean,
// /deviation, /half_width: one row a point. Not a number: beyond the end of a run, or for the last
// four from where on it is not to be used.
std::string curves_h5(const RunTable& table);

// "ribs=rigid, Contact/Stone friction=0.6".
std::string point_name(const Plan& plan, int point);
} // namespace interlock::apps
