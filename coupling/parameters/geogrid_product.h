// From entries to the product of fem that lattices are cut from.
#pragma once

#include "coupling/parameters/geogrid_parameters.h"
#include "coupling/parameters/product_parameters.h"
#include "fem/gmsh/gmsh_lattice.h"
#include "fem/layouts/product.h"

#include <string>

namespace interlock::coupling
{
// Ribs of the given modulus, or those whose sheet has the given secant stiffnesses and strength.
// Throws std::invalid_argument when a tension law or a section cannot be (fem/ribs/tension_law.h).
fem::GeogridProduct geogrid_product(const ProductParameters& parameters);

// That of the product of a pull-out, or of its own entries: a biaxial one with equal ribs both
// ways.
fem::GeogridProduct geogrid_product(const GeogridParameters& parameters);

// The lattice of a Gmsh file (fem/gmsh/gmsh_lattice.h) whose groups of lines are called "along" or
// "across" and take those ribs of the product; `length_unit` is that of the file [m]. Throws
// InputError for a group of another name, std::runtime_error where the file cannot be a lattice.
fem::GmshLattice drawn_lattice(const std::string& file, double length_unit,
                               const fem::GeogridProduct& product);
} // namespace interlock::coupling
