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
// The larger eigenvalue of [a, sqrt(a q); sqrt(a q), d + q].
Wide larger_eigenvalue(const Wide& a, const Wide& d, const Wide& q)
{
  const Wide half = 0.5 * (d + q - a);
  return 0.5 * (a + d + q) + std::experimental::sqrt(Wide(half * half + a * q));
}
} // namespace

double BentBeams::largest(const BeamLanes& beams, const Lanes3& position, const Lanes4& orientation,
                          const std::vector<int>& blocks) const
{
  using std::experimental::max, std::experimental::min, std::experimental::sqrt;
  Wide largest = 0.;
  for (const int s : blocks) {
    const BeamConstants<Wide> beam = load_constants(beams, s);
    const BeamStrains<Wide> strains = beam_strains(load_ends(position, orientation, s), beam);
    const Triple<Wide>&g = strains.gamma, &k = strains.kappa;
    const Triple<Wide> turning = load_wide(turning_, s), bending = load_wide(bending_, s);
    const Wide a = load_wide(stretch_.data() + s);
    const Wide by2 = beam.bowing[0] * g[1], by3 = beam.bowing[1] * g[2];
    const Wide about3 = g[1] - by2 * (1. + g[0]), about2 = g[2] - by3 * (1. + g[0]);
    const Wide about1 = by2 * g[2] - by3 * g[1];
    const Wide q_s = a * (by2 * by2 + by3 * by3) + turning[0] * about1 * about1 +
                     turning[1] * about2 * about2 + turning[2] * about3 * about3;
    const Wide q_b = bending[1] * k[1] * k[1] + bending[2] * k[2] * k[2];
    const Wide turn = beam.length * beam.length * detail::dot(k, k); // squared
    Wide moment = 0.;                                                // squared
    for (int c = 0; c < 3; ++c)
      moment += beam.moment_stiffness[c] * beam.moment_stiffness[c] * k[c] * k[c];
    const Wide swing = 1. + turn * (1. / 6);
    const Wide d_s = swing * load_wide(shear_.data() + s),
               d_b = swing * load_wide(bend_.data() + s);
    const Wide together = larger_eigenvalue(a, max(d_s, d_b), q_s + q_b);
    const Wide t = 1. + sqrt(Wide(q_s / (a + q_b)));
    const Wide apart =
        max(larger_eigenvalue(t * a, d_b, t * q_b), Wide(d_s + q_s + sqrt(Wide(q_s * (a + q_b)))));
    std::array<Wide, 1> square{min(together, apart) + load_wide(moment_.data() + s) * sqrt(moment)};
    where(!(q_s + q_b + turn > 0.), square[0]) = 0.;
    drop_gaps(beam.inverse_length, square);
    largest = max(largest, square[0]);
  }
  return hmax(largest);
}
} // namespace interlock::fem
