// The step of the explicit integrator, in vector lanes.
#include "fem/explicit/explicit_dynamics.h"

#include "fem/explicit/wide_beams.h"

#include <cmath>

namespace interlock::fem
{
namespace
{
using detail::dot;

// Product of a symmetric matrix (xx yy zz xy xz yz) and a vector.
Triple<Wide> symmetric_product(const std::array<Wide, 6>& a, const Triple<Wide>& v)
{
  return {a[0] * v[0] + a[3] * v[1] + a[4] * v[2], a[3] * v[0] + a[1] * v[1] + a[5] * v[2],
          a[4] * v[0] + a[5] * v[1] + a[2] * v[2]};
}

// Spin over the coming step for a given angular momentum: the spin that goes with the orientation
// half a step ahead, which it sets itself; a fixed-point loop from the last spin gains a factor |w|
// h a pass.
Triple<Wide> spin_of(const Triple<Wide>& momentum, const std::array<Wide, 6>& inverse_inertia,
                     const Quadruple<Wide>& q, Triple<Wide> spin, double h)
{
  for (int pass = 0; pass < 3; ++pass) {
    const Quadruple<Wide> ahead =
        turned(q, {0.5 * h * spin[0], 0.5 * h * spin[1], 0.5 * h * spin[2]});
    const auto rotation = detail::rotation_matrix<Wide>(ahead, 2.);
    spin = detail::to_world(
        rotation, symmetric_product(inverse_inertia, detail::to_frame(rotation, momentum)));
  }
  return spin;
}
} // namespace

// Flattened: with the kernel called as a function, its results go through memory and a step takes
// half as long again.
template <Tension tension> [[gnu::flatten]] void ExplicitDynamics::compute_element_loads()
{
  Wide largest = 0., largest_plastic = 0.; // force squared, stretch
  for (const std::vector<int>* blocks : {&border_, &moved_}) {
    // In border blocks elements that nobody needs here have ends that stay behind.
    largest = largest_plastic = 0.;
    for (const int s : *blocks) {
      const BeamConstants<Wide> beam = load_constants(beams_, s);
      const BeamStrains<Wide> strains = beam_strains(load_ends(position_, orientation_, s), beam);
      BeamEndLoads<Wide> loads = end_loads<tension>(strains, beam);
      drop_gaps(beam.inverse_length, loads.force1);
      drop_gaps(beam.inverse_length, loads.torque1);
      drop_gaps(beam.inverse_length, loads.torque2);
      largest = max(largest, dot(loads.force1, loads.force1));
      store_wide(loads.force1, beam_force_, s + wide_lanes);
      store_wide(loads.torque1, beam_torque1_, s + wide_lanes);
      store_wide(loads.torque2, beam_torque2_, s + wide_lanes);
      if constexpr (tension == Tension::softening) {
        std::array<Wide, 1> plastic{fem::plastic_stretch(strains, beam)};
        drop_gaps(beam.inverse_length, plastic);
        largest_plastic = max(largest_plastic, plastic[0]);
        store_wide(plastic[0], beams_.plastic_stretch.data() + s);
      }
    }
  }
  largest_force_ = std::sqrt(hmax(largest));
  largest_plastic_stretch_ = hmax(largest_plastic);
}

template void ExplicitDynamics::compute_element_loads<Tension::linear>();
template void ExplicitDynamics::compute_element_loads<Tension::softening>();

void ExplicitDynamics::sum_at_slots(bool with_elements)
{
  for (const std::vector<int>* blocks : {&border_, &moved_})
    for (const int s : *blocks)
      for (int c = 0; c < 3; ++c) {
        Wide force = load_wide(load_force_[c].data() + s);
        Wide torque = load_wide(load_torque_[c].data() + s);
        if (with_elements) {
          const int here = s + wide_lanes; // the beam that starts here; the one before it ends here
          force +=
              load_wide(beam_force_[c].data() + here) - load_wide(beam_force_[c].data() + here - 1);
          torque += load_wide(beam_torque1_[c].data() + here) +
                    load_wide(beam_torque2_[c].data() + here - 1);
        }
        store_wide(force, force_[c].data() + s);
        store_wide(torque, torque_[c].data() + s);
      }
}

void ExplicitDynamics::sum_at_junctions()
{
  for (const int junction : junctions_) {
    const std::vector<int>& slots = junction_slots_[junction];
    for (int c = 0; c < 3; ++c) {
      double force = 0, torque = 0;
      for (const int s : slots) {
        force += force_[c][s];
        torque += torque_[c][s];
      }
      for (const int s : slots) {
        force_[c][s] = force;
        torque_[c][s] = torque;
      }
    }
  }
}

// Velocities over `kick` from force and torque, positions over `h` from the new velocities. Work is
// force times mean velocity times `kick`, which accounts for the kinetic energy exactly. It is kept
// slot by slot: so its sum does not depend on who moves which slots.
template <bool spherical> void ExplicitDynamics::update_nodes(double kick, double h)
{
  const double half_damping = 0.5 * options_.mass_damping * kick;
  const double keep = 1 - half_damping, slow = 1 / (1 + half_damping);
  for (const int s : moved_) {
    Wide clamp_power = 0., load_power = 0., damping_power = 0.;
    const Wide mass = load_wide(mass_.data() + s),
               inverse_mass = load_wide(inverse_mass_.data() + s);
    const Wide counts = load_wide(counts_.data() + s);
    const auto is_clamped = load_wide(clamped_.data() + s) != 0.;
    Wide clamp_counts = 0., free_counts = counts;
    where(is_clamped, clamp_counts) = counts;
    where(is_clamped, free_counts) = 0.;

    Triple<Wide> position = load_wide(position_, s), velocity = load_wide(velocity_, s);
    const Triple<Wide> load_force = load_wide(load_force_, s);
    for (int c = 0; c < 3; ++c) {
      const Wide force = load_wide(force_[c].data() + s) + mass * options_.gravity[c];
      const Wide before = velocity[c];
      Wide after = (before * keep + kick * force * inverse_mass) * slow;
      where(is_clamped, after) = clamp_velocity_[c];
      const Wide mean = 0.5 * (before + after);
      const Wide pull = clamp_counts * (mass * (after - before) * (1 / kick) - force);
      const Wide drag = free_counts * options_.mass_damping * mass * mean;
      store_wide(pull, clamp_force_[c].data() + s);
      clamp_power += pull * mean;
      load_power += load_force[c] * mean;
      damping_power += drag * mean;
      velocity[c] = after;
      position[c] += h * after;
    }
    store_wide(velocity, velocity_, s);
    store_wide(position, position_, s);

    const Quadruple<Wide> q = load_wide(orientation_, s);
    const Triple<Wide> torque = load_wide(torque_, s), load_torque = load_wide(load_torque_, s);
    const Triple<Wide> spin = load_wide(spin_, s);
    const Wide inertia = load_wide(inertia_[0].data() + s); // used by spherical inertia only
    Triple<Wide> momentum, new_momentum, new_spin;
    for (int c = 0; c < 3; ++c) {
      momentum[c] = spherical ? inertia * spin[c] : load_wide(angular_momentum_[c].data() + s);
      new_momentum[c] = (momentum[c] * keep + kick * torque[c]) * slow;
      where(is_clamped, new_momentum[c]) = 0.;
      if (spherical) new_spin[c] = new_momentum[c] * load_wide(inverse_inertia_[0].data() + s);
    }
    if (!spherical) {
      new_spin = spin_of(new_momentum, load_wide(inverse_inertia_, s), q, spin, h);
      store_wide(new_momentum, angular_momentum_, s);
    }
    for (int c = 0; c < 3; ++c) {
      const Wide mean = 0.5 * (spin[c] + new_spin[c]);
      clamp_power +=
          clamp_counts * mean * ((new_momentum[c] - momentum[c]) * (1 / kick) - torque[c]);
      load_power += load_torque[c] * mean;
      damping_power +=
          free_counts * options_.mass_damping * mean * 0.5 * (momentum[c] + new_momentum[c]);
    }
    store_wide(new_spin, spin_, s);
    store_wide(turned(q, {h * new_spin[0], h * new_spin[1], h * new_spin[2]}), orientation_, s);
    const auto add_work = [&](Lane& work, const Wide& power) {
      store_wide(load_wide(work.data() + s) + kick * power, work.data() + s);
    };
    add_work(clamp_work_, clamp_power);
    add_work(load_work_, load_power);
    add_work(damping_loss_, damping_power);
  }
}

template void ExplicitDynamics::update_nodes<true>(double, double);
template void ExplicitDynamics::update_nodes<false>(double, double);
} // namespace interlock::fem
