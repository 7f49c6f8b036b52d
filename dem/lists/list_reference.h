// How far clumps have moved since a neighbour list was made.
#pragma once

#include "dem/bodies/clumps.h"

namespace interlock::dem
{
// A reference pose and a skin for each clump. A list that holds all pairs with gap <= s_i + s_j at
// the references misses nothing while every clump has used no more than its skin
// (docs/theory/engine.md).
class ListReference
{
public:
  VectorField position;
  QuaternionField orientation;
  ScalarField skin{Eigen::Matrix<double, 1, 1>::Constant(1e300)}; // [m]

  void resize(int n);
  // Takes the present pose of one clump.
  void take(const Clumps& clumps, int i, double new_skin);
  // Bound on how far any member centre of any clump has moved since its reference, per clump [m].
  void measure(const Clumps& clumps, ScalarField& used) const;
  // True while no clump has used more than its skin; may say false a little early, for speed.
  bool holds(const Clumps& clumps);
  // Whether some clump had used more than 0.93 of its skin when holds() was asked.
  bool is_nearly_used_up() const { return nearly_used_up_; }

private:
  bool nearly_used_up_ = false;
  ScalarField excess_; // work space
};
} // namespace interlock::dem
