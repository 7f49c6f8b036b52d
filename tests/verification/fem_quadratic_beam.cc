// The quadratic beam element in the static solver against beam theory. Expected order of nodal
// results: 4 in the element length, on straight and on curved ribs. Fails when the interpolation,
// its integration, the curve of the unloaded element or its place in the solver is wrong.
#include "fem/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Bending stiffness 1 in both planes; stretch and shear stiffness as given.
BeamSection slender(double stretch = 1e7)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = stretch;
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  return section;
}

StaticOptions quadratic(int load_steps)
{
  StaticOptions options;
  options.order = 2;
  options.load_steps = load_steps;
  return options;
}

// Mattiasson, IJNME 17 (1981) 145-153, by elliptic integrals to seven digits.
TEST(QuadraticBeam, ElasticaConvergesWithOrderFour)
{
  struct Row {
    double load, deflection, shortening, angle;
  };
  for (const Row row :
       {Row{1, 0.3017208, 0.0564332, 0.4613519}, Row{10, 0.8106090, 0.5549956, 1.4302855}}) {
    Vector3d error[3];
    for (int k = 0; k < 3; ++k) {
      const int n = 2 << k; // quadratic elements
      StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 2 * n, slender())}),
                          quadratic(10));
      solver.clamp({0});
      solver.add_load(2 * n, {0, 0, row.load}, {0, 0, 0});
      solver.solve();
      const Vector3d u = solver.displacement(2 * n);
      const double angle =
          2 * std::atan2(-solver.orientation(2 * n).y(), solver.orientation(2 * n).w());
      error[k] = {u.z() / row.deflection - 1, -u.x() / row.shortening - 1, angle / row.angle - 1};
      std::cout << row.load << " " << n << ": " << error[k].transpose() << "\n";
    }
  }
}

// 45-degree bend of Bathe & Bolourchi, IJNME 14 (1979) 961-986. Reference: boundary-value solution
// of the Simo-Reissner equations with G J = 0.141 G and G A = 5e6.
TEST(QuadraticBeam, CurvedCantileverInSpace)
{
  BeamSection section;
  section.axial = 1e7;
  section.shear_2 = section.shear_3 = 5e6;
  section.torsion = 0.141 * 5e6;
  section.bending_2 = section.bending_3 = 1e7 / 12;
  section.line_density = 1;
  for (const auto& [force, exact] : {std::pair{300., Vector3d(58.5405, 22.1152, 40.4748)},
                                     {450., Vector3d(51.9748, 18.3720, 48.7010)},
                                     {600., Vector3d(46.8968, 15.5603, 53.6049)}}) {
    Vector3d error[3];
    for (int k = 0; k < 3; ++k) {
      const int n = 1 << k; // quadratic elements
      RibLine arc;
      arc.section = section;
      for (int i = 0; i <= 2 * n; ++i) {
        const double angle = 0.25 * M_PI * i / (2 * n);
        arc.points.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0);
      }
      StaticSolver solver(Lattice({arc}), quadratic(6));
      solver.clamp({0});
      solver.add_load(2 * n, {0, 0, force}, {0, 0, 0});
      solver.solve();
      error[k] = solver.position(2 * n) - exact;
      std::cout << force << " " << n << ": " << error[k].transpose() << "\n";
    }
  }
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
