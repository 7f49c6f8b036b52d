// Laboratory tests of geogrids as virtual experiments: equilibrium paths of a piece of the product.
// Set-ups after the standards named; how each is read: docs/theory/geogrid.md.
#pragma once

#include "fem/layouts/product.h"
#include "fem/statics/static_solver.h"

#include <functional>
#include <memory>
#include <vector>

namespace interlock::fem
{
// One state of a test.
struct LaboratoryPoint {
  double deformation = 0; // strain [-], rotation [rad] or tip deflection [m], by test
  double load = 0;        // force per width [N/m], torque [N m] or weight share [-], by test
};

// A finished test. The solver holds the last state.
struct LaboratoryTest {
  std::vector<LaboratoryPoint> path; // from the unloaded state on
  std::unique_ptr<StaticSolver> solver;
};

// Called after each step with the share that is done; may throw to end the test.
using LaboratoryProgress = std::function<void(double share)>;

// Sum of what supports exert on these nodes, each moment about its own node [N, N m]. Nodes that a
// junction joins share one force, which counts once: for the first of them.
NodeLoad total_reaction(const StaticSolver& solver, const std::vector<int>& nodes);

// Load of a path at a deformation, linear between its points.
// Throws std::invalid_argument when the path does not reach it.
double load_at(const std::vector<LaboratoryPoint>& path, double deformation);

// Tension along the machine direction (turn the product for the other one) of a piece about 200 mm
// wide, and at least 100 mm and two apertures long (after ISO 10319). The first row of junctions is
// held, the last moved along x; neither turns. Strain by the distance of both rows, force per width
// with every rib counting for one pitch. `steps` equal steps.
LaboratoryTest wide_width_tension(const GeogridProduct& product, double largest_strain, int steps,
                                  const LaboratoryProgress& progress = {});

// Tension of one rib between two junctions that do not turn (after ASTM D6637, method A); force of
// the rib over the pitch.
LaboratoryTest single_rib_tension(const GeogridProduct& product, double largest_strain, int steps,
                                  const LaboratoryProgress& progress = {});

// In-plane torque on the middle junction of a piece of about 229 mm by 229 mm whose rim is held
// (after ASTM D7864); an even number of apertures each way. Path: rotation of the junction, torque.
LaboratoryTest aperture_stability(const GeogridProduct& product, double largest_torque, int steps,
                                  const LaboratoryProgress& progress = {});

struct OverhangResult {
  double length = 0;            // that hangs over, before bending [m]
  double flexural_rigidity = 0; // mass per area times g times (length/2)^3, per width [N m]
  LaboratoryTest test;          // of that length; path: fall of the tip, share of the weight
};

// A strip `ribs` ribs wide that is held on a table up to its edge and hangs over it by its weight
// (after ASTM D7748): finds the length at which the line from edge to tip falls by 41.5 degrees. A
// transverse rib lies at the tip. `gravity` [m/s2].
OverhangResult flexural_overhang(const GeogridProduct& product, int ribs, double gravity,
                                 const LaboratoryProgress& progress = {});
} // namespace interlock::fem
