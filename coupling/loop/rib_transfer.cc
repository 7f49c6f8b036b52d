#include "coupling/loop/rib_transfer.h"

#include "fem/layouts/biaxial_layout.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
fem::BiaxialLayout biaxial_layout(const GeogridParameters& p, const dem::Vector3& front)
{
  fem::RibSection section;
  section.width = p.rib_width;
  section.thickness = p.rib_thickness;
  section.youngs_modulus = p.youngs_modulus;
  section.poisson_ratio = p.poisson_ratio;
  section.density = p.density;

  fem::BiaxialLayout layout;
  layout.apertures_along = p.apertures_along;
  layout.apertures_across = p.apertures_across;
  layout.pitch_along = p.pitch_along;
  layout.pitch_across = p.pitch_across;
  layout.elements_per_rib = p.elements_per_rib;
  layout.section_along = layout.section_across = section;
  layout.origin = front;
  return layout;
}
} // namespace

RibTransfer RibTransfer::biaxial(const GeogridParameters& p, const dem::Vector3& front,
                                 double gravity)
{
  const fem::Lattice lattice(rib_lines(biaxial_layout(p, front)));
  fem::DynamicsOptions options;
  options.gravity = {0, 0, -gravity};
  options.mass_damping = p.mass_damping;
  const std::vector<int> front_edge = lattice.front_edge_nodes();
  return RibTransfer(lattice, options, front_edge, p.rigid, p.edge_rounding);
}

RibTransfer::RibTransfer(const fem::Lattice& unloaded, const fem::DynamicsOptions& options,
                         const std::vector<int>& clamped, bool rigid, double edge_rounding)
    : rigid_(rigid), dynamics_(unloaded, options)
{
  if (rigid_)
    dynamics_.clamp_all();
  else
    dynamics_.clamp(clamped);

  ribs_.resize(lattice().n_elements());
  for (int r = 0; r < lattice().n_elements(); ++r) {
    const fem::LatticeElement& element = lattice().element(r);
    unloaded_width_axis_.push_back(element.frame * dem::Vector3::UnitY());
    dem::Rib& rib = ribs_[r];
    rib.line = element.line;
    rib.half_width = 0.5 * lattice().shape(r).width;
    rib.half_thickness = 0.5 * lattice().shape(r).thickness;
    rib.rounding = edge_rounding;
    for (int end : {0, 1}) {
      const int node = element.node[end];
      const bool prescribed =
          rigid_ || std::find(clamped.begin(), clamped.end(), node) != clamped.end();
      rib.inverse_mass[end] = prescribed ? 0 : 1 / dynamics_.mass(node);
    }
  }
  refresh_all_ribs();
}

void RibTransfer::refresh_rib(int r)
{
  dem::Rib& rib = ribs_[r];
  for (int end : {0, 1}) {
    rib.x[end] = dynamics_.end_position(r, end);
    rib.v[end] = dynamics_.velocity_at(r, end);
    rib.w[end] = dynamics_.spin_at(r, end);
    rib.width_axis[end] = dynamics_.end_orientation(r, end) * unloaded_width_axis_[r];
  }
}

void RibTransfer::refresh_ribs(const std::vector<int>& which)
{
  for (const int r : which) refresh_rib(r);
}

void RibTransfer::refresh_all_ribs()
{
  for (int r = 0; r < static_cast<int>(ribs_.size()); ++r) refresh_rib(r);
}

void RibTransfer::apply(const std::vector<dem::RibWrench>& wrenches)
{
  dynamics_.clear_loads();
  for (const dem::RibWrench& w : wrenches) {
    const dem::RodLoads loads = dem::rod_loads(ribs_[w.rib], w);
    for (const int end : {0, 1})
      dynamics_.add_load(w.rib, end, loads.force[end], loads.moment[end]);
  }
}

int RibTransfer::required_substeps(double dt, const dem::RibContacts& contacts) const
{
  if (rigid_) return 1;
  const dem::ContactProperties& pair = contacts.properties();
  std::vector<double> rate(lattice().n_nodes(), 0.); // bound on omega^2 of the contacts [1/s2]
  for (const dem::RibContact& c : contacts.contacts()) {
    if (c.overlap <= 0) continue;
    const dem::Vector3 chord = ribs_[c.rib].x[1] - ribs_[c.rib].x[0];
    const double length = chord.norm(), arm = c.arm.norm();
    const dem::Vector3 normal = c.force.norm() > 0 ? c.force.normalized() : dem::Vector3::UnitZ();
    const dem::Vector3 moment = c.arm.cross(normal); // of a unit force
    const double turning = moment.dot(chord) / length;
    const dem::Vector3 couple = moment.cross(chord) / (length * length);
    // What a unit force along the normal, and one across it in the worst direction, does to each
    // end: along the rod it turns the chord, across the rod the section.
    double pushed[2], dragged[2];
    for (int end : {0, 1}) {
      const int node = lattice().element(c.rib).node[end];
      const double share = end == 0 ? 1 - c.xi : c.xi, side = end == 0 ? -1 : 1;
      const double m = dynamics_.mass(node), j = dynamics_.inertia(node);
      pushed[end] = std::sqrt((share * normal + side * couple).squaredNorm() / m +
                              share * share * turning * turning / j);
      dragged[end] =
          std::max((share + arm / length) / std::sqrt(m), share * std::sqrt(1 / m + arm * arm / j));
    }
    // Blocks of k v v^T, bounded node by node as by Gershgorin.
    for (int end : {0, 1})
      rate[lattice().element(c.rib).node[end]] +=
          std::max(pair.normal_stiffness * pushed[end] * (pushed[0] + pushed[1]),
                   pair.tangential_stiffness * dragged[end] * (dragged[0] + dragged[1]));
  }
  const double beam = 2 / dynamics_.stable_step();
  const double fastest = *std::max_element(rate.begin(), rate.end());
  const double z = pair.damping_ratio;
  const double stable = 2 / std::sqrt(beam * beam + fastest) * (std::sqrt(1 + z * z) - z);
  return std::max(2, static_cast<int>(std::ceil(dt / (0.75 * stable))));
}
} // namespace interlock::coupling
