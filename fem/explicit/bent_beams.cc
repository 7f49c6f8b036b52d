#include "fem/explicit/bent_beams.h"

#include "fem/explicit/wide_beams.h"
#include "fem/lattice/beam_constants.h"

#include <algorithm>

namespace interlock::fem
{
Eigen::Vector3d end_inertia(const Lattice& lattice, int e, const std::vector<NodeInertia>& nodes,
                            bool spherical)
{
  const BeamSection& section = lattice.section(e);
  const LatticeElement& element = lattice.element(e);
  if (!spherical)
    return 0.5 * element.length *
           Eigen::Vector3d(section.rotary_1, section.rotary_2, section.rotary_3);
  double share = nodes[element.node[0]].tensor(0, 0) / nodes[element.node[0]].valence;
  share = std::min(share, nodes[element.node[1]].tensor(0, 0) / nodes[element.node[1]].valence);
  return Eigen::Vector3d::Constant(share);
}

void BentBeams::resize(std::size_t size)
{
  for (Lane* lane : {&stretch_, &shear_, &bend_, &moment_}) lane->assign(size, 0.);
  for (Lanes3* lanes : {&turning_, &bending_})
    for (Lane& lane : *lanes) lane.assign(size, 0.);
}

void BentBeams::set(int slot, const Lattice& lattice, int e, const std::vector<NodeInertia>& nodes,
                    bool spherical, bool rbf)
{
  const BeamConstants<double> beam = beam_constants(lattice, e, rbf);
  const double h = beam.length, m = 0.5 * lattice.section(e).line_density * h;
  const Eigen::Vector3d j = end_inertia(lattice, e, nodes, spherical);
  const double moving = 2 / (h * m);
  stretch_[slot] = moving * beam.force_stiffness[0];
  shear_[slot] = std::max(beam.force_stiffness[1] * (moving + h / (2 * j[2])),
                          beam.force_stiffness[2] * (moving + h / (2 * j[1])));
  for (int c = 0; c < 3; ++c) {
    bend_[slot] = std::max(bend_[slot], 2 * beam.moment_stiffness[c] / (h * j[c]));
    turning_[c][slot] = beam.force_stiffness[0] * h / (2 * j[c]);
    bending_[c][slot] = beam.force_stiffness[0] * 2 * beam.bowing[2] * beam.bowing[2] / (h * j[c]);
  }
  moment_[slot] = 0.5 / j.minCoeff();
}

namespace
{
using std::experimental::max, std::experimental::min, std::experimental::sqrt;

// The larger eigenvalue of [a, sqrt(a q); sqrt(a q), d + q].
Wide larger_eigenvalue(const Wide& a, const Wide& d, const Wide& q)
{
  const Wide half = 0.5 * (d + q - a);
  return 0.5 * (a + d + q) + sqrt(Wide(half * half + a * q));
}

// As in the header; `q_one` is q where one end is clamped.
struct Squares {
  Wide a, d_s, d_b, q_s, q_b, q_one;
};

// `one_clamped`: 1 where an element has one clamped end, else 0.
Wide bound(const Squares& s, const Wide& one_clamped)
{
  const Wide t = 1. + sqrt(Wide(s.q_s / (s.a + s.q_b)));
  const Wide bending = larger_eigenvalue(t * s.a, s.d_b, t * s.q_b),
             shear = s.d_s + s.q_s + sqrt(Wide(s.q_s * (s.a + s.q_b)));
  Wide together = larger_eigenvalue(s.a, max(s.d_s, s.d_b), s.q_s + s.q_b);
  Wide apart = max(bending, shear);
  where(one_clamped > 0., together) = larger_eigenvalue(0.5 * s.a, 0.5 * (s.d_s + s.d_b), s.q_one);
  where(one_clamped > 0., apart) = 0.5 * (bending + shear);
  return min(together, apart);
}
} // namespace

double BentBeams::largest(const BeamLanes& beams, const Lanes3& position, const Lanes4& orientation,
                          const Lane& clamped, const std::vector<int>& blocks) const
{
  Wide largest = 0.;
  for (const int s : blocks) {
    const BeamConstants<Wide> beam = load_constants(beams, s);
    const BeamStrains<Wide> strains = beam_strains(load_ends(position, orientation, s), beam);
    const Triple<Wide>&g = strains.gamma, &k = strains.kappa;
    const Triple<Wide> turning = load_wide(turning_, s), bending = load_wide(bending_, s);
    const Wide by2 = beam.bowing[0] * g[1], by3 = beam.bowing[1] * g[2];
    const Wide about3 = g[1] - by2 * (1. + g[0]), about2 = g[2] - by3 * (1. + g[0]);
    const Wide about1 = by2 * g[2] - by3 * g[1];
    const Wide turn = beam.length * beam.length * detail::dot(k, k); // squared
    const Wide swing = 1. + turn * (1. / 6);
    Squares squares;
    squares.a = load_wide(stretch_.data() + s);
    squares.d_s = swing * load_wide(shear_.data() + s);
    squares.d_b = swing * load_wide(bend_.data() + s);
    const Wide q_move = squares.a * (by2 * by2 + by3 * by3);
    squares.q_s = q_move + turning[0] * about1 * about1 + turning[1] * about2 * about2 +
                  turning[2] * about3 * about3;
    squares.q_b = bending[1] * k[1] * k[1] + bending[2] * k[2] * k[2];
    Wide moment = 0.; // squared
    for (int c = 0; c < 3; ++c)
      moment += beam.moment_stiffness[c] * beam.moment_stiffness[c] * k[c] * k[c];
    // 1: the second end is clamped, -1: the first.
    const Wide side = load_wide(clamped.data() + s + 1) - load_wide(clamped.data() + s);
    const Wide one_clamped = side * side;
    const Wide arm = 2. * beam.inverse_length * beam.bowing[2] * side;
    const Wide both2 = about2 + arm * k[1], both3 = about3 - arm * k[2];
    const Wide swung = max(turning[0], max(turning[1], turning[2])) * turn * (1. / 16) *
                       (about1 * about1 + about2 * about2 + about3 * about3);
    squares.q_one =
        0.5 * (q_move + swung) + 0.5 * swing *
                                     (turning[0] * about1 * about1 + turning[1] * both2 * both2 +
                                      turning[2] * both3 * both3);
    where(one_clamped > 0., moment) = moment * turn * (1. / 36);
    std::array<Wide, 1> square{bound(squares, one_clamped) +
                               load_wide(moment_.data() + s) * sqrt(moment)};
    where(!(squares.q_s + squares.q_b + turn > 0.), square[0]) = 0.;
    drop_gaps(beam.inverse_length, square);
    largest = max(largest, square[0]);
  }
  return hmax(largest);
}
} // namespace interlock::fem
