// A lattice for ParaView and for scripts: lines between nodes with displacement and section forces.
#pragma once

#include "coupling/output/field_output.h"
#include "fem/beam/section_forces.h"
#include "fem/implicit/modes.h"
#include "fem/lattice/lattice.h"
#include "fem/statics/static_solver.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace interlock::coupling
{
struct LatticeFields {
  std::vector<double> points;
  std::vector<int> lines;
  // displacement [m] of nodes; axial_force, shear_force [N], torque, moment_out_of_plane,
  // moment_in_plane [N m] of elements.
  std::vector<OutputField> fields;
};
LatticeFields lattice_fields(const fem::Lattice& lattice,
                             const std::function<Eigen::Vector3d(int node)>& position,
                             const std::function<fem::SectionForces(int element)>& forces);

// One frame of a lattice in equilibrium: STEM.xdmf, STEM.h5.
void write_lattice(const std::filesystem::path& stem, const fem::StaticSolver& solver);

// A frame a mode, numbered from 1 as its time: shapes scaled so that the largest displacement is a
// tenth of the lattice's size, with `displacement` [m].
void write_modes(const std::filesystem::path& stem, const fem::Lattice& lattice,
                 const std::vector<fem::NaturalMode>& modes);
} // namespace interlock::coupling
