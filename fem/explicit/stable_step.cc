#include "fem/explicit/stable_step.h"

#include "fem/explicit/bent_beams.h"
#include "fem/lattice/beam_constants.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
BeamFrequency beam_frequency(const Lattice& lattice, const std::vector<NodeInertia>& nodes,
                             bool spherical, bool rbf)
{
  BeamFrequency bound;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamSection& s = lattice.section(e);
    const BeamConstants<double> beam = beam_constants(lattice, e, rbf);
    const double h = beam.length, m = 0.5 * s.line_density * h;
    const Eigen::Vector3d j = end_inertia(lattice, e, nodes, spherical);
    if (!(m > 0) || !(j.minCoeff() > 0))
      throw std::invalid_argument(
          "Rib line " + std::to_string(lattice.element(e).line) +
          " has no mass or no rotary inertia, which explicit dynamics needs "
          "(given_section completes a section).");
    // Shear along e2 goes with turning about e3, and the other way round.
    const double moving = 2 / (h * m);
    const double shearing[2] = {moving + h / (2 * j[2]), moving + h / (2 * j[1])};
    bound.unloaded =
        std::max({bound.unloaded, moving * s.axial, 2 * s.torsion / (h * j[0]),
                  2 * s.bending_2 / (h * j[1]), 2 * s.bending_3 / (h * j[2]),
                  beam.force_stiffness[1] * shearing[0], beam.force_stiffness[2] * shearing[1]});
    for (const int c : {0, 1}) {
      // Shear turns the sections at the stretched length a = 1 + N/EA + e_p, with the plastic
      // stretch e_p: (S* + b N) a^2 - N a; here a form linear in N and e_p that lies above it up to
      // a = 1.2.
      const double turning = h / (2 * j[2 - c]);
      const double lengthening = 2.2 * beam.force_stiffness[1 + c] * turning;
      const double lever = lengthening / s.axial;
      const double tipping = std::max(0., 1.44 * beam.bowing[c] - 1.2) * turning;
      bound.per_tension = std::max({bound.per_tension, beam.bowing[c] * moving + lever + tipping,
                                    2 * beam.bowing[2] / (h * j[2 - c])});
      bound.per_plastic_stretch = std::max(bound.per_plastic_stretch, lengthening);
    }
  }
  return bound;
}
} // namespace interlock::fem
