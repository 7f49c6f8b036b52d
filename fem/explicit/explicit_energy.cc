// Energies of the explicit integrator.
#include "fem/beam/beam_tangent.h"
#include "fem/explicit/explicit_dynamics.h"
#include "fem/explicit/wide_beams.h"

#include <numeric>

namespace interlock::fem
{
// Strain energy at the positions `time_back` before the present ones, along the present velocities.
template <Tension tension>
[[gnu::flatten]] double ExplicitDynamics::elastic_energy(double time_back) const
{
  Lanes3 position = position_;
  Lanes4 orientation = orientation_;
  for (int s = 0; s < n_padded_; s += wide_lanes) {
    Triple<Wide> x = load_wide(position_, s), turn = load_wide(spin_, s);
    const Triple<Wide> velocity = load_wide(velocity_, s);
    for (int c = 0; c < 3; ++c) {
      x[c] -= time_back * velocity[c];
      turn[c] *= -time_back;
    }
    store_wide(x, position, s);
    store_wide(turned(load_wide(orientation_, s), turn), orientation, s);
  }
  Wide sum = 0.;
  for (int s = 0; s < n_padded_; s += wide_lanes) {
    const BeamConstants<Wide> beam = load_constants(beams_, s);
    std::array<Wide, 1> energy{
        strain_energy<tension>(beam_strains(load_ends(position, orientation, s), beam), beam)};
    drop_gaps(beam.inverse_length, energy);
    sum += energy[0];
  }
  return reduce(sum);
}

// Plastic work up to the positions `time_back` before the present ones, along the present
// velocities. The history ends a step back, so what is met on the way there is added.
double ExplicitDynamics::plastic_loss(double time_back) const
{
  double sum = 0;
  for (int e = 0; e < lattice_.n_elements(); ++e) {
    std::array<Eigen::Vector3d, 2> x;
    std::array<Eigen::Quaterniond, 2> q;
    for (int v = 0; v < 2; ++v) {
      const int s = element_slot_[e] + v;
      x[v] = vector_at(position_, s) - time_back * vector_at(velocity_, s);
      q[v] = rotation_exponential(-time_back * vector_at(spin_, s)) * quaternion_at(s);
    }
    const BeamSection& section = lattice_.section(e);
    const BeamConstants<double> beam = constants(e);
    sum +=
        beam.length * plastic_work({section.axial, section.softening, section.yield_force},
                                   fem::plastic_stretch(beam_strains(beam_ends(x, q), beam), beam));
  }
  return sum;
}

LatticeEnergies ExplicitDynamics::energies() const
{
  LatticeEnergies energies;
  const double back = 0.5 * previous_step_;
  for (int i = 0; i < lattice_.n_nodes(); ++i) {
    const int s = node_slot_[i];
    const Eigen::Vector3d v = velocity(i), w = spin(i);
    const Eigen::Vector3d l = options_.spherical_inertia ? Eigen::Vector3d(inertia_[0][s] * w)
                                                         : vector_at(angular_momentum_, s);
    energies.kinetic += 0.5 * (mass_[s] * v.squaredNorm() + l.dot(w));
    energies.gravitational -= mass_[s] * options_.gravity.dot(position(i) - back * v);
  }
  // For linear laws the leapfrog rule conserves kinetic energy plus x_n . K x_{n+1}/2, which is
  // this combination of the energies at the half step and at the steps around it.
  const auto centred = [&](const auto& energy) {
    return 2 * energy(back) - 0.5 * (energy(0) + energy(previous_step_));
  };
  if (softens_) {
    energies.elastic = centred([&](double t) { return elastic_energy<Tension::softening>(t); });
    energies.plastic_loss = centred([&](double t) { return plastic_loss(t); });
  } else {
    energies.elastic = centred([&](double t) { return elastic_energy<Tension::linear>(t); });
  }
  const auto sum = [this](const Lane& work) {
    return std::accumulate(work.begin(), work.begin() + n_slots_, 0.);
  };
  energies.clamp_work = sum(clamp_work_);
  energies.load_work = sum(load_work_);
  energies.damping_loss = sum(damping_loss_);
  return energies;
}
} // namespace interlock::fem
