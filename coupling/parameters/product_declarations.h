// The section "Product" of parameter files: declared by the laboratory, and by a pull-out that
// takes its geogrid from a product file.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"
#include "coupling/parameters/product_parameters.h"

namespace interlock::coupling
{
// `product` must outlive the table.
void declare_product(ParameterTable& table, ProductParameters& product);

// What no single entry can tell: ribs that overlap, a stiffness that is given twice or not at all,
// triangles of another height than their sides say, junctions thinner than ribs or longer than half
// a pitch.
void check_product(const ProductParameters& product, ParameterProblems& problems);
} // namespace interlock::coupling
