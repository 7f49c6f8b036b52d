// The element kernel's constants for an element of a lattice.
#pragma once

#include "fem/beam/beam_element.h"
#include "fem/lattice/lattice.h"

namespace interlock::fem
{
// `rbf`: residual bending flexibility in both shear stiffnesses, see residual_shear and
// residual_bowing. `plastic_stretch`: what the element's history has left, see tension_law.h.
inline BeamConstants<double> beam_constants(const Lattice& lattice, int e, bool rbf,
                                            double plastic_stretch = 0)
{
  const LatticeElement& element = lattice.element(e);
  const BeamSection& s = lattice.section(e);
  const double h = element.length;
  const Eigen::Quaterniond& q = element.frame;
  // Shear along e2 belongs to bending about e3, and the other way round.
  const double shear_2 = rbf ? residual_shear(s.shear_2, s.bending_3, h) : s.shear_2;
  const double shear_3 = rbf ? residual_shear(s.shear_3, s.bending_2, h) : s.shear_3;
  return {h,
          1 / h,
          {q.w(), q.x(), q.y(), q.z()},
          {s.axial, shear_2, shear_3},
          {s.torsion, s.bending_2, s.bending_3},
          {rbf ? residual_bowing(s.shear_2, s.bending_3, h) : 0,
           rbf ? residual_bowing(s.shear_3, s.bending_2, h) : 0, rbf ? h * h / 12 : 0},
          s.softening,
          s.yield_force / s.axial,
          plastic_stretch};
}
} // namespace interlock::fem
