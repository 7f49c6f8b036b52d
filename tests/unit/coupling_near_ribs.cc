// Which stones are sub-cycled with the ribs, and what local damping knows of the ribs' forces, must
// follow from the present state alone. Fails when a digit of a stone, of the lattice or of the
// interface's energy depends on when the list of contacts with ribs was made, on a stone far away,
// or on a removal of nobody.
#include "coupling/loop/staggered_step.h"

#include <gtest/gtest.h>

#include <functional>

using namespace interlock;
using dem::Vector3;

namespace
{
constexpr double half_length = 0.06, rib_thickness = 2.5e-3, time_step = 2.5e-6;
constexpr int n_steps = 1500;

// Two flexible ribs that cross in the origin and are held at their four ends.
coupling::RibTransfer flexible_cross()
{
  fem::RibSection section;
  section.width = 5e-3;
  section.thickness = rib_thickness;
  section.youngs_modulus = 2.4e9;
  section.poisson_ratio = 0.3;
  section.density = 910;
  std::vector<fem::RibLine> lines;
  for (const Vector3& end : {Vector3(half_length, 0, 0), Vector3(0, half_length, 0)}) {
    lines.push_back(fem::straight_line(-end, end, 16, fem::beam_section(section)));
    lines.back().shape = section;
  }
  fem::Lattice lattice(lines);
  std::vector<int> held;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    if (lattice.reference_position(node).norm() > 0.999 * half_length) held.push_back(node);
  fem::DynamicsOptions options;
  options.mass_damping = 100;
  return coupling::RibTransfer(std::move(lattice), options, held, false, 5e-4);
}

dem::ClumpShape stone(std::vector<dem::Sphere> spheres)
{
  dem::ClumpShape shape;
  shape.spheres = std::move(spheres);
  shape.volume = 6e-6;
  shape.unit_inertia = Vector3(2.2, 2.9, 3.6) * 1e-10;
  return shape;
}

// A stone that rests on the crossing (index 1) and one that spins `gap` above a rib and comes down
// at `speed` (index 2); index 0 is far above both.
class Scene
{
public:
  Scene(double gap, double speed, double local_damping, bool fast_stranger = false)
      : geogrid_(flexible_cross()),
        engine_({stone({{Vector3::Zero(), 0.011}}), stone({{Vector3(0.005, 0.001, 0), 0.008},
                                                           {Vector3(-0.006, 0, 0.001), 0.007},
                                                           {Vector3(0, 0.004, 0.002), 0.006}})},
                pair(), 9.81),
        loop_(engine_, pair())
  {
    engine_.set_local_damping(local_damping);
    const double surface = 0.5 * rib_thickness;
    engine_.add_clump(0, 2650, {0, 0, 3}, dem::Quaternion::Identity());
    engine_.add_clump(0, 2650, {0, 0, surface + 0.011}, dem::Quaternion::Identity());
    const int i = engine_.add_clump(1, 2650, {0.035, 0.0005, surface + 0.008 + gap},
                                    dem::Quaternion::Identity(), {0.01, 0.02, -speed});
    dem::Clumps& clumps = engine_.clumps();
    clumps.angular_momentum[i] = Vector3(clumps.inertia[i]).cwiseProduct(Vector3(0.3, 0.2, 4));
    clumps.spin[i] = clumps.step_spin[i] = clumps.spin_of(i, clumps.angular_momentum[i]);
    if (fast_stranger)
      engine_.add_clump(0, 2650, {10, 0, 5}, dem::Quaternion::Identity(), {8, 0, 0});
    loop_.place_geogrid(geogrid_);
  }

  // `before_step` may remove clumps.
  void run(const std::function<void(Scene&, int)>& before_step = {})
  {
    for (int n = 0; n < n_steps; ++n) {
      if (before_step) before_step(*this, n);
      loop_.advance(time_step, Vector3::Zero(), &ledger_);
      for (const dem::RibContact& c : loop_.rib_contacts().contacts())
        landed_ |= c.i == first_ + 1 && c.overlap > 0;
    }
  }

  void remove_nobody() { loop_.remove_clumps(std::vector<bool>(engine_.clumps().size(), false)); }

  void remove_first()
  {
    std::vector<bool> remove(engine_.clumps().size(), false);
    remove[0] = true;
    loop_.remove_clumps(remove);
    first_ = 0;
  }

  bool landed() const { return landed_; }

  // Everything that must stay the same: both stones, the lattice, the interface.
  std::vector<double> digits() const
  {
    std::vector<double> all;
    const auto take = [&all](const auto& numbers) {
      for (int k = 0; k < numbers.size(); ++k) all.push_back(numbers[k]);
    };
    const dem::Clumps& clumps = engine_.clumps();
    for (const int i : {first_, first_ + 1}) {
      take(Vector3(clumps.position[i]));
      take(clumps.orientation[i].coeffs());
      take(Vector3(clumps.velocity[i]));
      take(Vector3(clumps.angular_momentum[i]));
      take(Vector3(clumps.step_velocity[i]));
      take(Vector3(clumps.step_spin[i]));
    }
    for (int node = 0; node < geogrid_.lattice().n_nodes(); ++node)
      take(Vector3(geogrid_.dynamics().position(node)));
    take(Vector3(loop_.clamp_force()));
    all.insert(all.end(), {ledger_.interface_work_on_stones, ledger_.interface_stored_and_lost,
                           ledger_.interface_work_on_geogrid});
    return all;
  }

private:
  static dem::ContactProperties pair()
  {
    dem::ContactProperties pair;
    pair.normal_stiffness = pair.tangential_stiffness = 5.65e7;
    pair.friction = 0.6;
    pair.damping_ratio = 0.1;
    return pair;
  }

  coupling::RibTransfer geogrid_;
  dem::Engine engine_;
  coupling::StaggeredStep loop_;
  coupling::EnergyLedger ledger_;
  int first_ = 1; // index of the stone that rests
  bool landed_ = false;
};

// The second stone hovers close to the rib, or lands on it; with and without local damping.
struct Case {
  std::string name;
  double gap, speed, local_damping; // [m], [m/s], [-]
  bool lands;
};
void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.name;
}

class NearRibs : public testing::TestWithParam<Case>
{
protected:
  Scene scene(bool fast_stranger = false) const
  {
    return Scene(GetParam().gap, GetParam().speed, GetParam().local_damping, fast_stranger);
  }
};
INSTANTIATE_TEST_SUITE_P(Stones, NearRibs,
                         testing::Values(Case{"Hovers", 1.6e-4, 0, 0, false},
                                         Case{"HoversDamped", 1.6e-4, 0, 0.5, false},
                                         Case{"Lands", 1.2e-4, 0.1, 0, true},
                                         Case{"LandsDamped", 1.2e-4, 0.1, 0.5, true}),
                         [](const auto& c) { return c.param.name; });
} // namespace

TEST_P(NearRibs, ListsRenewedEveryStepChangeNoDigit)
{
  Scene lazy = scene(), eager = scene();
  lazy.run();
  eager.run([](Scene& s, int) { s.remove_nobody(); });
  EXPECT_EQ(lazy.landed(), GetParam().lands);
  EXPECT_EQ(lazy.digits(), eager.digits());
}

TEST_P(NearRibs, AStoneFarAwayChangesNoDigit)
{
  Scene alone = scene(), two = scene(true);
  alone.run();
  two.run();
  EXPECT_EQ(alone.digits(), two.digits());
}

TEST_P(NearRibs, RemovalOfNobodyChangesNoDigit)
{
  Scene kept = scene(), once = scene();
  kept.run();
  once.run([](Scene& s, int n) {
    if (n == n_steps / 2) s.remove_nobody();
  });
  EXPECT_EQ(kept.digits(), once.digits());
}

// Indices shift; a stone's record must go with it.
TEST_P(NearRibs, RemovalOfAnotherStoneChangesNoDigit)
{
  Scene kept = scene(), shifted = scene();
  kept.run();
  shifted.run([](Scene& s, int n) {
    if (n == n_steps / 2) s.remove_first();
  });
  EXPECT_EQ(kept.digits(), shifted.digits());
}
