// The triaxial test against statics. Spheres in a cubic lattice, and poured stones: each of the six
// walls carries the cell pressure times its area. Four spheres, one, four, a piece of the
// face-centred cubic packing that is compressed along a cube axis (Thornton, Geotechnique 29, 1979;
// Rowe, Proc. R. Soc. A 269, 1962; derivation in docs/theory/triaxial.md): contacts are inclined by
// theta to the axis, and slip outwards when the plate over a side carries
//     P/F_x = sqrt 2/tan(theta - atan mu),   length = 2 r + 2 sqrt 2 r sin theta
// which is sigma_1/sigma_3 = 2 (1 + mu)/(1 - mu) of the endless packing at 45 degrees. Fails when a
// wall does not keep its pressure or follow its area, a stress is of other walls, a sign is wrong,
// or the energy of gravity is lost when that is switched off.
#include "coupling/triaxial/triaxial.h"
#include "tests/history_rows.h"
#include "tests/placed_stones.h"
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double r = 0.01; // of the spheres [m]
constexpr double pressure = 3e4;

// Without a filling: the stones are put in.
class Placed : public Triaxial
{
public:
  using Triaxial::Triaxial;
  std::vector<Stage> plan() const { return {ConsolidateStage(), CompressStage()}; }
};

// Without a compression.
template <bool pours> class AtRest : public Triaxial
{
public:
  using Triaxial::Triaxial;
  std::vector<Stage> plan() const
  {
    if (!pours) return {ConsolidateStage()};
    std::vector<Stage> plan = Triaxial::plan();
    plan.pop_back();
    return plan;
  }
  void finish(std::vector<Stage>&, RunRecords&) const {}
};

TriaxialParameters parameters(double length, double width, double height)
{
  TriaxialParameters p;
  p.specimen.stones.density = 2650;
  p.specimen.box.length = length, p.specimen.box.width = width, p.specimen.box.height = height;
  p.cell_pressure = pressure;
  p.specimen.contact.stone_stiffness = p.specimen.contact.box_stiffness = 2e8;
  p.specimen.contact.stone_friction = 0.5;
  p.specimen.contact.tangential_ratio = 1;
  p.specimen.contact.damping_ratio = 0.3;
  p.specimen.filling.plate_speed = 0.05;
  p.specimen.filling.local_damping = 0.5;
  p.specimen.filling.kinetic_energy_ratio = 1e-6;
  p.specimen.filling.settling_time_limit = 1;
  p.compression.strain_rate = 0.2;
  p.compression.strain = 0.05;
  p.compression.ramp_time = 0.01;
  p.specimen.time.safety_factor = 0.5;
  p.output.records = 100;
  return p;
}

class TriaxialTest : public TemporaryFolderTest
{
protected:
  template <class Test> Summary run(Test& test)
  {
    RunRequest request;
    request.folder = folder;
    request.checkpoint_interval = 0;
    return coupling::Run<Test>(test, request).run();
  }

  // All six walls, against the pressure on the size that the block has now.
  void expect_cell_pressure(const Triaxial& test) const
  {
    const dem::Engine& engine = test.world().engine;
    const TriaxialWalls& w = test.walls;
    const Vector3 size = test.size();
    for (int d = 0; d < 3; ++d) {
      const double wanted = pressure * size.prod() / size[d];
      const auto [low, high] = std::array<std::pair<dem::WallId, dem::WallId>, 3>{
          {{w.x_fixed, w.x_moving}, {w.y_fixed, w.y_moving}, {w.floor, w.plate}}}[d];
      EXPECT_NEAR(-engine.wall(low).force[d], wanted, 0.005 * wanted) << d;
      EXPECT_NEAR(engine.wall(high).force[d], wanted, 0.005 * wanted) << d;
    }
    EXPECT_EQ(engine.gravity(), 0);
    // The last step has moved stones and walls, so the ledger is that of another evaluation.
    EXPECT_LT(test.world().ledger().relative_error(), 0.01);
  }
};
} // namespace

TEST_F(TriaxialTest, CubicLatticeCarriesTheCellPressure)
{
  const int n[3] = {4, 3, 2};
  AtRest<false> test(parameters(2 * n[0] * r, 2 * n[1] * r, 2 * n[2] * r));
  test.set_up({stone_of({{Vector3::Zero(), r}})});
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k)
        test.world().engine.add_clump(0, 2650, r * Vector3(2 * i + 1, 2 * j + 1, 2 * k + 1),
                                      dem::Quaternion::Identity());
  run(test);
  expect_cell_pressure(test);
}

TEST_F(TriaxialTest, PouredStonesCarryTheCellPressure)
{
  TriaxialParameters p = parameters(0.12, 0.12, 0.12);
  p.specimen.stones.count = 8;
  p.specimen.stones.d_min = p.specimen.stones.r_min = 0.003;
  p.specimen.stones.p_max = 100;
  p.specimen.stones.max_spheres = 15;
  p.specimen.contact.stone_stiffness = p.specimen.contact.box_stiffness = 1e7;
  p.specimen.filling.drop_height = 0.02;
  p.specimen.filling.stone_friction = 0.1;
  AtRest<true> test(p);
  RunRequest request;
  test.prepare(request.monitor, {});
  run(test);
  expect_cell_pressure(test);
  EXPECT_EQ(test.world().engine.stone_contact().friction, 0.5);
  // The sides have followed the stones.
  EXPECT_LT(test.size().x(), 0.12);
}

TEST_F(TriaxialTest, FaceCentredPackingFailsAsItsContactsSlip)
{
  const double root = std::sqrt(2);
  for (const double friction : {0.3, 0.5}) {
    TriaxialParameters p = parameters(4 * r, 4 * r, 2 * r + 2 * root * r);
    p.specimen.contact.stone_friction = friction;
    Placed test(p);
    // In an endless packing symmetry keeps spheres from turning, here their inertia.
    Stone sphere = stone_of({{Vector3::Zero(), r}});
    sphere.shape.unit_inertia *= 1e9;
    test.set_up({sphere});
    const auto add = [&](double x, double y, double z) {
      test.world().engine.add_clump(0, 2650, {x, y, z}, dem::Quaternion::Identity());
    };
    add(2 * r, 2 * r, r + root * r);
    for (const double x : {r, 3 * r})
      for (const double y : {r, 3 * r})
        for (const double z : {r, r + 2 * root * r}) add(x, y, z);
    const Summary summary = run(test);

    int compared = 0;
    double before = 0, strongest = 0;
    for (const auto& row : history_rows(folder)) {
      const double height = row.at("height"), length = row.at("length"), width = row.at("width");
      // Stresses are means since the record before.
      const double theta = std::acos((0.5 * (height + before) - 2 * r) / (4 * r));
      before = height;
      if (row.at("axial_strain") < 0.002) continue; // springs are loaded
      const double force_ratio = row.at("axial_stress") * length /
                                 (0.5 * (row.at("stress_x") + row.at("stress_y")) * height);
      const double expected = root / std::tan(theta - std::atan(friction));
      EXPECT_NEAR(force_ratio, expected, 0.003 * expected) << friction << " " << theta;
      const double layers = (height - 2 * r) / (4 * r);
      const double spread = 2 * r + 2 * root * r * std::sqrt(1 - layers * layers);
      EXPECT_NEAR(length, spread, 2e-4 * spread);
      EXPECT_NEAR(width, spread, 2e-4 * spread);
      EXPECT_NEAR(row.at("volume_change"),
                  spread * spread * height / (16 * r * r * p.specimen.box.height) - 1, 5e-4);
      // sigma_1/sigma_3 of the endless packing, whose cell is root 2 layers high.
      strongest = std::max(strongest, root * force_ratio / std::tan(theta));
      ++compared;
    }
    EXPECT_GT(compared, 90);
    // At the first record that counts theta has grown already.
    const double thornton = 2 * (1 + friction) / (1 - friction);
    EXPECT_NEAR(strongest, thornton, 0.02 * thornton) << friction;
    const double sides = summary.results["mean_stress_x_Pa"];
    EXPECT_NEAR(sides, pressure, 0.002 * pressure);
    EXPECT_LT(summary.energy["relative_error"], 0.01);
  }
}
