// A sheet of a product pulled in the pull-out's own explicit dynamics, by forces on its rear edge,
// slowly and damped. References: ribs in parallel and the tension law of
// docs/theory/geogrid.md in closed form. Fails when the sheet carries another force than its law,
// keeps another stretch when the forces are gone, or when the ledger does not close while ribs
// lose work.
#include "coupling/pull_out/geogrid_sheet.h"

#include "coupling/loop/rib_transfer.h"
#include "fem/ribs/tension_law.h"
#include "tests/geogrid_products.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double pitch = 0.065;

struct PulledSheet {
  PulledSheet(const ProductParameters& product, int along, int across)
      : parameters(test_products::of(product, along, across)),
        sheet(lay_geogrid(parameters, Vector3(0, 0.1, 0.15))),
        geogrid(sheet.lattice, options(), sheet.clamped, false, parameters.edge_rounding)
  {
  }
  static fem::DynamicsOptions options()
  {
    fem::DynamicsOptions options;
    options.mass_damping = 3000; // near critical for the lowest mode along: 2 w = 2 (pi/2) c/L
    return options;
  }
  // From one force on each longitudinal rib to another: half a cosine, then rest.
  void pull(double from, double to, double time)
  {
    fem::ExplicitDynamics& d = geogrid.dynamics();
    const double h = 0.8 * d.stable_step();
    const int n = static_cast<int>(time / h);
    for (int i = 0; i < 2 * n; ++i) {
      const double share = i < n ? 0.5 - 0.5 * std::cos(M_PI * i / n) : 1;
      d.clear_loads();
      for (const int line : sheet.along)
        d.add_nodal_load(sheet.lattice.nodes_of_line(line).back(),
                         Vector3(from + share * (to - from), 0, 0), Vector3::Zero());
      d.step(h);
    }
  }
  // Mean way of the rear edge at the longitudinal ribs over the sheet's length [-].
  double strain() const
  {
    double way = 0;
    for (const int line : sheet.along) {
      const int node = sheet.lattice.nodes_of_line(line).back();
      way += geogrid.dynamics().position(node).x() - sheet.lattice.reference_position(node).x();
    }
    return way / sheet.along.size() /
           (parameters.apertures_along * parameters.product->pitch_along);
  }

  GeogridParameters parameters;
  GeogridSheet sheet;
  RibTransfer geogrid;
};
} // namespace

TEST(PulledSheet, HasTheStiffnessOfItsSheet)
{
  PulledSheet pulled(test_products::biaxial(), 2, 2);
  const double stiffness = 5e9 * 0.004 * 0.0017; // of a rib [N]
  pulled.pull(0, 100, 0.01);
  EXPECT_NEAR(pulled.strain(), 100 / stiffness, 1e-5 * 100 / stiffness);
}

// Bars of a uniaxial sheet are pulled through: ribs alone stretch.
TEST(PulledSheet, UniaxialRibsCarryAlone)
{
  PulledSheet pulled(test_products::uniaxial(), 1, 2);
  const double stiffness = 5e9 * 0.006 * 0.001;
  pulled.pull(0, 100, 0.01);
  EXPECT_NEAR(pulled.strain(), 100 / stiffness, 1e-5 * 100 / stiffness);
}

// A force per width of F5 = 22 kN/m stretches a product whose sheet says so by 5 %; without it
// e_p = e - N/EA stays.
TEST(PulledSheet, SoftensAsItsDataSheetSaysAndKeepsPlasticStretch)
{
  PulledSheet pulled(test_products::softening(), 2, 2);
  const fem::TensionLaw law = fem::tension_law(550e3, 440e3, pitch);
  const double force = 0.05 * 440e3 * pitch;
  pulled.pull(0, force, 0.01);
  EXPECT_NEAR(pulled.strain(), 0.05, 1e-5);
  const fem::LatticeEnergies at_force = pulled.geogrid.dynamics().energies();
  pulled.pull(force, 0, 0.01);
  const double left = 0.05 - force / law.axial;
  EXPECT_NEAR(pulled.strain(), left, 1e-5);
  // Three ribs of two pitches each have lost the work of their law, and the ledger knows.
  const fem::LatticeEnergies e = pulled.geogrid.dynamics().energies();
  const double lost = 3 * 2 * pitch * fem::plastic_work(law, left);
  EXPECT_NEAR(e.plastic_loss, lost, 2e-3 * lost);
  EXPECT_NEAR(at_force.plastic_loss, lost, 2e-3 * lost);
  EXPECT_NEAR(e.ledger(), 0, 1e-3 * lost);
}

// Thicker junctions strain less, and the ribs between them are made so much softer that the sheet
// has its stiffness at small strain all the same.
TEST(PulledSheet, ThickJunctionsLeaveTheSheetItsStiffness)
{
  ProductParameters product = test_products::softening();
  for (auto* ribs : {&product.along, &product.across}) ribs->stiffness_5 = ribs->strength = 0;
  product.junction_reach = 0.005, product.junction_thickness = 0.007;
  PulledSheet pulled(product, 2, 2);
  const double force = 100; // of a rib: strain of 0.28 %
  pulled.pull(0, force, 0.01);
  const double strain = force / (550e3 * pitch);
  EXPECT_NEAR(pulled.strain(), strain, 1e-4 * strain);
}
