// The highest frequency of beams that are bent or sheared, for the stable step.
#pragma once

#include "fem/explicit/beam_lanes.h"
#include "fem/lattice/lattice.h"
#include "fem/lattice/lumped_inertia.h"

#include <vector>

namespace interlock::fem
{
// Rotary inertia about e1, e2, e3 that the weaker end of an element can count on [kg m2]. With
// `spherical` inertia every element end takes an equal share of its node's, otherwise its own.
Eigen::Vector3d end_inertia(const Lattice& lattice, int e, const std::vector<NodeInertia>& nodes,
                            bool spherical);

// Bound on omega^2 of elements in their present shape, without axial force (BeamFrequency adds
// that). With the bowing of residual_bowing the stretch e of a bent element changes in first order
// when it is bent or sheared further, so the axial stiffness comes in: energy h/2 EA e^2 with
//   de = dx1/h + sum of b g dx/h + (1 - b (1 + g1)) g dt  over both planes + (h^2/12) k dk
// for relative displacements dx, mean turn dt, curvature k and shear strain g. Let a be omega^2 of
// stretch alone, d_s of shear and d_b of bending and twist, and q_s and q_b the parts of EA de^2
// that move shear and bending. With d = max(d_s, d_b) and q = q_s + q_b, omega^2 is at most
//   the larger eigenvalue of [a, sqrt(a q); sqrt(a q), d + q],
// and, as (x + y)^2 <= (1 + t) x^2 + (1 + 1/t) y^2 with t = sqrt(q_s/(a + q_b)), at most the larger
//   of the same for (1 + t) a, (1 + t) q_b and d_b, and of d_s + (1 + 1/t) q_s.
// The smaller bound holds. A turn p within the element makes d_s and d_b larger by p^2/6 for the
// inverse tangent of the rotation and its swing (bounds of what the kernel has), and the moment M
// adds M/(2 J). Straight elements have q = 0 and add nothing.
//
// Where one end is clamped only the other has inertia: a, d_s and d_b are half of these, but mean
// turn and bending are one motion then, so sums stand where the larger was enough, (d_s + d_b)/2
// for d and the mean of both for the second bound; in q what both ask of the free end's turn, half
// the factor of dt and +- h k/12, is added with its sign before it is squared. The moment's term is
// its product with the turns of both ends; with one of them it is of second order, M.(p d^2 - d
// (p.d))/24 for the turn d of the free end (symmetric Baker-Campbell-Hausdorff series), and adds M
// p/(12 J).
class BentBeams
{
public:
  void resize(std::size_t size);
  void set(int slot, const Lattice& lattice, int e, const std::vector<NodeInertia>& nodes,
           bool spherical, bool rbf);
  // The largest of all elements in these blocks of lanes, given by their first slots; 0 where all
  // are straight [1/s2]. `clamped`: 1 where the node of a slot does not move, else 0. An element
  // between two of those counts as free, so that a rigid lattice has a step, too.
  double largest(const BeamLanes& beams, const Lanes3& position, const Lanes4& orientation,
                 const Lane& clamped, const std::vector<int>& blocks) const;

private:
  Lane stretch_, shear_, bend_, moment_; // a, d_s, d_b [1/s2], 1/(2 J) [1/(kg m2)]
  Lanes3 turning_, bending_;             // of EA: h/(2 J), 2 (h^2/12)^2/(h J), about e1, e2, e3
};
} // namespace interlock::fem
