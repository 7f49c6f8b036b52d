// Products for tests, with round numbers of the library's kind.
#pragma once

#include "coupling/parameters/geogrid_parameters.h"

#include <cmath>

namespace test_products
{
using interlock::coupling::GeogridParameters;
using interlock::coupling::ProductParameters;

// Biaxial, 65 mm, with other ribs across than along; linear.
inline ProductParameters biaxial()
{
  ProductParameters p;
  p.name = "biaxial";
  p.pitch_along = p.pitch_across = 0.065;
  p.along = {0.004, 0.0017, 5e9};
  p.across = {0.004, 0.0015, 6e9};
  p.poisson_ratio = 0.4;
  p.density = 910;
  p.elements_per_rib = 4;
  return p;
}

// The same with ribs that soften and yield: secant stiffnesses of a 30 kN/m product.
inline ProductParameters softening()
{
  ProductParameters p = biaxial();
  for (auto* ribs : {&p.along, &p.across}) {
    ribs->youngs_modulus = 0;
    ribs->stiffness_2 = 550e3;
    ribs->stiffness_5 = 440e3;
    ribs->strength = 30e3;
  }
  return p;
}

// Triangles with a side of 46.2 mm.
inline ProductParameters triaxial()
{
  ProductParameters p = biaxial();
  p.name = p.pattern = "triaxial";
  p.pitch_across = 0.08 / std::sqrt(3.);
  p.pitch_along = 0.04;
  p.along = {0.0011, 0.0018, 5e9};
  p.across = {0.0013, 0.0015, 5e9};
  return p;
}

// Ribs 250 mm long between wide bars.
inline ProductParameters uniaxial()
{
  ProductParameters p = biaxial();
  p.name = p.pattern = "uniaxial";
  p.pitch_along = 0.12, p.pitch_across = 0.022;
  p.along = {0.006, 0.001, 5e9};
  p.across = {0.016, 0.0027, 5e9};
  return p;
}

inline GeogridParameters of(const ProductParameters& product, int along, int across)
{
  GeogridParameters g;
  g.product = product;
  g.apertures_along = along;
  g.apertures_across = across;
  g.overhang = 5e-3;
  g.edge_rounding = 5e-4;
  g.mass_damping = 100;
  return g;
}
} // namespace test_products
