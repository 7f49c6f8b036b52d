#include "coupling/lattice_output.h"

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
  XdmfSeries(stem, XdmfSeries::Topology::lines).write(0, frame.points, frame.lines, frame.fields);
}
} // namespace interlock::coupling
