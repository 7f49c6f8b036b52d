// The shear box against statics. One stone that stands on the floor and is held by the upper half
// slides with T = mu N. Two rigid layers of spheres in a regular packing, each row in the saddle of
// the one below: the contacts are inclined by alpha, sin alpha = (r - u)/(2 r), so that
//     T/N = tan(alpha + atan mu),   rise = 2 r (cos alpha - cos 30 degrees)
// (a sphere that climbs a slope of alpha under a vertical load: a wedge with friction). A poured
// box at rest: the lower half carries plate and weight, the plane has the normal stress that was
// asked for. Fails when a wall is missing from a sum, a sign is wrong, the weight above the plane
// is left out, or the plate does not keep its force.
#include "coupling/shear_box/shear_box.h"
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

// Without a filling: the stones are put in.
class Placed : public ShearBox
{
public:
  using ShearBox::ShearBox;
  std::vector<Stage> plan() const { return {ConsolidateStage(), ShearStage()}; }
};

// Without a test.
class Poured : public ShearBox
{
public:
  using ShearBox::ShearBox;
  std::vector<Stage> plan() const
  {
    std::vector<Stage> plan = ShearBox::plan();
    plan.pop_back();
    return plan;
  }
  void finish(std::vector<Stage>&, RunRecords&) const {}
};

ShearBoxParameters parameters(double length, double width, double height)
{
  ShearBoxParameters p;
  p.specimen.stones.density = 2650;
  p.specimen.box.length = length, p.specimen.box.width = width, p.specimen.box.height = height;
  p.gap = 0.002;
  p.normal_stress = 5e4;
  p.specimen.contact.stone_stiffness = p.specimen.contact.box_stiffness = 2e8;
  p.specimen.contact.tangential_ratio = 1;
  p.specimen.contact.damping_ratio = 0.3;
  p.specimen.filling.plate_speed = 0.05;
  p.specimen.filling.local_damping = 0.5;
  p.specimen.filling.kinetic_energy_ratio = 1e-5;
  p.specimen.filling.settling_time_limit = 1;
  p.shear.speed = 0.02;
  p.shear.distance = 0.6 * r;
  p.shear.ramp_time = 0.01;
  p.specimen.time.safety_factor = 0.7;
  p.output.records = 60;
  return p;
}

class ShearBoxTest : public TemporaryFolderTest
{
protected:
  template <class Box> Summary run(Box& box)
  {
    RunRequest request;
    request.folder = folder;
    request.checkpoint_interval = 0;
    return coupling::Run<Box>(box, request).run();
  }

  ShearBoxParameters poured_parameters() const
  {
    ShearBoxParameters p = parameters(0.15, 0.15, 0.12);
    p.specimen.stones.count = 8;
    p.specimen.stones.d_min = p.specimen.stones.r_min = 0.003;
    p.specimen.stones.p_max = 100;
    p.specimen.stones.max_spheres = 15;
    p.specimen.contact.stone_stiffness = p.specimen.contact.box_stiffness = 1e7;
    p.specimen.contact.stone_friction = 0.6;
    p.specimen.filling.drop_height = 0.02;
    p.specimen.filling.stone_friction = 0.1;
    p.specimen.filling.kinetic_energy_ratio = 1e-6;
    return p;
  }
  void pour_into(Poured& box) const
  {
    RunRequest request;
    request.folder = folder;
    request.checkpoint_interval = 0;
    box.prepare(request.monitor, {});
    coupling::Run<Poured>(box, request).run();
  }
};
} // namespace

TEST_F(ShearBoxTest, SingleStoneSlidesWithTheFrictionOfTheWall)
{
  for (const auto& [friction, only_floor] :
       {std::pair(0.2, false), std::pair(0.5, false), std::pair(0.5, true)}) {
    // A table on four legs, which stand clear of the lower half.
    std::vector<dem::Sphere> spheres;
    for (const double x : {-1., 1.})
      for (const double y : {-1., 1.}) {
        spheres.push_back({{2 * x * r, 2 * y * r, -1.5 * r}, r});
        spheres.push_back({{3 * x * r, 3 * y * r, 1.5 * r}, r});
      }
    ShearBoxParameters p = parameters(8 * r, 8 * r, 4 * r);
    p.specimen.contact.stone_friction = friction;
    p.specimen.contact.box_friction = only_floor ? 0 : friction;
    if (only_floor) p.floor_and_plate_friction = friction;
    Placed box(p);
    box.set_up({stone_of(spheres)});
    box.world().engine.add_clump(0, 2650, {4 * r, 4 * r, 2.5 * r}, dem::Quaternion::Identity());
    const Summary summary = run(box);
    EXPECT_NEAR(summary.results["residual_friction_ratio"], friction, 0.001 * friction);
    // The floor carries what the plane does, with the friction of the side that holds the stone.
    const Vector3 floor = box.world().engine.wall(box.walls.lower.front()).force;
    const auto last = history_rows(folder).back();
    EXPECT_NEAR(-floor.z(), last.at("normal_force"), 0.002 * last.at("normal_force"));
    EXPECT_NEAR(-floor.x(), last.at("shear_force"), 0.002 * last.at("shear_force"));
    EXPECT_NEAR(last.at("plate_force") + double(summary.results["weight_above_plane_N"]),
                5e4 * box.area(), 0.002 * 5e4 * box.area());
    EXPECT_LT(std::abs(double(summary.results["volume_change_at_end"])), 1e-3);
  }
}

TEST_F(ShearBoxTest, RegularLayersClimbOverEachOther)
{
  constexpr int along = 5, across = 3;
  for (const double friction : {0., 0.5}) {
    std::vector<dem::Sphere> below, above;
    for (int j = 0; j < across; ++j) {
      const double y = (2 * j + 1 - across) * r;
      for (int i = 0; i < along; ++i) below.push_back({{(2 * i + 1 - along) * r, y, 0}, r});
      for (int i = 1; i < along; ++i) above.push_back({{(2 * i - along) * r, y, 0}, r});
      // Half the radius, they hold the layer to the ends of the box.
      for (const double end : {-1., 1.})
        above.push_back({{end * (along - 0.5) * r, y, 0}, 0.5 * r});
    }
    const double height = std::sqrt(3) * r; // from layer to layer
    ShearBoxParameters p = parameters(2 * along * r, 2 * across * r, 2 * r + height);
    p.specimen.contact.stone_friction = friction;
    // A layer stands on more contacts than the usual stone.
    p.specimen.time.safety_factor = 0.2;
    Placed box(p);
    box.set_up({stone_of(below), stone_of(above)});
    const Vector3 middle(along * r, across * r, r);
    box.world().engine.add_clump(0, 2650, middle, dem::Quaternion::Identity());
    box.world().engine.add_clump(1, 2650, middle + Vector3(0, 0, height),
                                 dem::Quaternion::Identity());
    const Summary summary = run(box);
    int compared = 0;
    double before = 0;
    for (const auto& row : history_rows(folder)) {
      const double u = row.at("displacement");
      // Forces are means since the record before. At first the springs are loaded.
      const double alpha = std::asin((r - 0.5 * (u + before)) / (2 * r));
      const double rise = 2 * std::sqrt(r * r - 0.25 * (r - u) * (r - u)) - height;
      before = u;
      if (u < 0.1 * r) continue;
      const double ratio = std::tan(alpha + std::atan(friction));
      EXPECT_NEAR(row.at("friction_ratio"), ratio, 0.005 * ratio) << friction << " " << u;
      EXPECT_NEAR(row.at("dilation"), rise, 0.002 * r) << friction << " " << u;
      ++compared;
    }
    EXPECT_GT(compared, 40);
    EXPECT_LT(summary.energy["relative_error"], 0.01);
  }
}

TEST_F(ShearBoxTest, PouredStonesAreInBalance)
{
  Poured box(poured_parameters());
  pour_into(box);
  const ShearBoxParameters& p = box.parameters();
  dem::Engine& engine = box.world().engine;
  const double weight = box.world().weight(), above = box.weight_above_plane();
  // The rims of the halves carry some stones.
  double below = 0;
  for (const dem::WallId id : box.walls.lower) below -= engine.wall(id).force.z();
  const ShearForces forces = shear_forces(engine, box.walls);
  const double area = box.area();
  EXPECT_EQ(engine.stone_contact().friction, 0.6);
  EXPECT_NEAR(below, forces.plate + weight + forces.friction, 0.002 * below);
  EXPECT_NEAR(forces.plate + above, p.normal_stress * area, 0.005 * p.normal_stress * area);
}

// The stones of a compacted specimen have borne more than the test asks for, and bear what it asks
// for.
TEST_F(ShearBoxTest, CompactionLeavesADenserSpecimenUnderTheSameLoad)
{
  ShearBoxParameters p = poured_parameters();
  p.specimen.filling.stone_friction = 0;
  Poured plain(p);
  pour_into(plain);
  p.specimen.compaction_stress = 4 * p.normal_stress;
  Poured compacted(p);
  pour_into(compacted);
  EXPECT_LT(compacted.porosity(), plain.porosity());
  const ShearForces forces = shear_forces(compacted.world().engine, compacted.walls);
  const double wanted = p.normal_stress * compacted.area();
  EXPECT_NEAR(forces.plate + compacted.weight_above_plane(), wanted, 0.005 * wanted);
}
