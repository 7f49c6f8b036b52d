#include "coupling/output/lattice_output.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
LatticeFields lattice_fields(const fem::Lattice& lattice,
                             const std::function<Eigen::Vector3d(int node)>& position,
                             const std::function<fem::SectionForces(int element)>& forces)
{
  LatticeFields result;
  OutputField displacement{"displacement", "m", FieldSupport::points, 3, {}};
  for (int node = 0; node < lattice.n_nodes(); ++node) {
    const Eigen::Vector3d x = position(node), u = x - lattice.reference_position(node);
    result.points.insert(result.points.end(), {x.x(), x.y(), x.z()});
    displacement.values.insert(displacement.values.end(), {u.x(), u.y(), u.z()});
  }
  OutputField axial{"axial_force", "N", FieldSupport::cells, 1, {}},
      shear{"shear_force", "N", FieldSupport::cells, 1, {}},
      torque{"torque", "N m", FieldSupport::cells, 1, {}},
      out_of_plane{"moment_out_of_plane", "N m", FieldSupport::cells, 1, {}},
      in_plane{"moment_in_plane", "N m", FieldSupport::cells, 1, {}};
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const std::array<int, 2>& node = lattice.element(e).node;
    result.lines.insert(result.lines.end(), {node[0], node[1]});
    const fem::SectionForces f = forces(e);
    axial.values.push_back(f.axial);
    shear.values.push_back(std::hypot(f.shear_2, f.shear_3));
    torque.values.push_back(f.torque);
    out_of_plane.values.push_back(f.moment_2);
    in_plane.values.push_back(f.moment_3);
  }
  result.fields = {displacement, axial, shear, torque, out_of_plane, in_plane};
  return result;
}

void write_lattice(const std::filesystem::path& stem, const fem::StaticSolver& solver)
{
  const LatticeFields frame = lattice_fields(
      solver.lattice(), [&](int node) { return solver.position(node); },
      [&](int e) { return solver.section_forces(e); });
  FieldSeries series(stem, FieldSeries::Topology::lines);
  series.start();
  series.write(0, frame.points, frame.lines, frame.fields);
}

void write_modes(const std::filesystem::path& stem, const fem::Lattice& lattice,
                 const std::vector<fem::NaturalMode>& modes)
{
  Eigen::Vector3d low = lattice.reference_position(0), high = low;
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    low = low.cwiseMin(lattice.reference_position(i));
    high = high.cwiseMax(lattice.reference_position(i));
  }
  FieldSeries series(stem, FieldSeries::Topology::lines);
  series.start();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    double largest = 0;
    for (const auto& u : modes[m].shape) largest = std::max(largest, u.head<3>().norm());
    const double scale = largest > 0 ? 0.1 * (high - low).norm() / largest : 0;
    LatticeFields frame = lattice_fields(
        lattice,
        [&](int node) -> Eigen::Vector3d {
          return lattice.reference_position(node) + scale * modes[m].shape[node].head<3>();
        },
        [](int) { return fem::SectionForces{}; });
    frame.fields.resize(1);
    series.write(static_cast<double>(m + 1), frame.points, frame.lines, frame.fields);
  }
}
} // namespace interlock::coupling
