// Clumps that are far from everything else, put between the others by index. Fails when any digit
// of a clump, a wall or the contacts' energy depends on how many clumps there are, on the index of
// a clump, or on the lane that its contacts come to lie in; only the order of the clumps may count.
// Ranks that hold some clumps each, in the order of their ids, stand on this.
#include "tests/dem_crowd.h"

#include <gtest/gtest.h>

using namespace interlock::dem;
using crowd::Crowd;
using crowd::time_step;

namespace
{
// Besides the floor (wall 0): a side (wall 1) and a plate above that presses with 20 N (wall 2).
Crowd between_walls(const ContactProperties& pair, int strangers)
{
  Crowd result = crowd::thrown(11, pair, strangers);
  // Only linear contacts let a wall keep its force.
  ContactProperties plate = crowd::laws().front().pair;
  plate.share_among_contacts = pair.share_among_contacts;
  result.engine.add_wall(rectangle_wall("side", {-0.05, -1, 0}, {0, 2, 0}, {0, 0, 2}, pair));
  const int top =
      result.engine.add_wall(rectangle_wall("plate", {-1, -1, 0.19}, {2, 0, 0}, {0, 2, 0}, plate));
  ForceControl control;
  control.axis = {0, 0, -1};
  control.force = 20;
  control.largest_speed = 2;
  result.engine.control_wall(top, control);
  return result;
}

// The first member whose state differs, or -1.
int first_that_differs(const Crowd& x, const Crowd& y)
{
  const Clumps &p = x.engine.clumps(), &q = y.engine.clumps();
  for (int n = 0; n < crowd::n_members; ++n) {
    const int i = x.members[n], j = y.members[n];
    if (p.position[i] != q.position[j] || p.orientation[i].coeffs() != q.orientation[j].coeffs() ||
        p.velocity[i] != q.velocity[j] || p.angular_momentum[i] != q.angular_momentum[j])
      return n;
  }
  return -1;
}

// Takes away every other clump that is no member.
void remove_some_strangers(Crowd& crowd)
{
  std::vector<bool> remove(crowd.engine.clumps().size(), true);
  for (const int i : crowd.members) remove[i] = false;
  bool spare = false;
  for (std::size_t i = 0; i < remove.size(); ++i)
    if (remove[i]) remove[i] = spare = !spare;
  const std::vector<int> new_index = crowd.engine.remove_clumps(remove);
  for (int& i : crowd.members) i = new_index[i];
}
} // namespace

class Strangers : public testing::TestWithParam<crowd::Law>
{
};
INSTANTIATE_TEST_SUITE_P(Laws, Strangers, testing::ValuesIn(crowd::laws()),
                         [](const auto& law) { return law.param.name; });

TEST_P(Strangers, ChangeNoDigit)
{
  Crowd alone = between_walls(GetParam().pair, 0);
  Crowd one = between_walls(GetParam().pair, 1), three = between_walls(GetParam().pair, 3);
  ASSERT_EQ(three.engine.clumps().size(), 4 * crowd::n_members);
  double largest_push = 0;
  for (int n = 0; n < 2500; ++n) {
    if (n == 1000) remove_some_strangers(three);
    for (Crowd* crowd : {&alone, &one, &three}) crowd->engine.step(time_step);
    largest_push = std::max(largest_push, alone.engine.walls()[2].force.z());
    for (const Crowd* other : {&one, &three}) {
      ASSERT_EQ(first_that_differs(alone, *other), -1) << "step " << n;
      for (int w = 0; w < 3; ++w) {
        ASSERT_EQ(alone.engine.walls()[w].force, other->engine.walls()[w].force) << "step " << n;
        ASSERT_EQ(alone.engine.walls()[w].corner, other->engine.walls()[w].corner) << "step " << n;
      }
    }
  }
  EXPECT_GT(alone.engine.n_touching_spheres(), 50);
  EXPECT_GT(largest_push, 1); // the plate does press [N]
  const EngineEnergy a = alone.engine.energy(time_step);
  for (const Crowd* other : {&one, &three}) {
    const EngineEnergy b = other->engine.energy(time_step);
    EXPECT_EQ(a.contact.elastic, b.contact.elastic);
    EXPECT_EQ(a.contact.friction, b.contact.friction);
    EXPECT_EQ(a.contact.damping, b.contact.damping);
    EXPECT_EQ(a.contact.crushing, b.contact.crushing);
    EXPECT_EQ(a.wall_work, b.wall_work);
  }
}

// The kinetic energy decides when stages end. It is a sum that knows no order, of what each clump
// has alone: no clump's part may depend on its place, in a whole register or in the rest behind
// them.
TEST(Strangers, ChangeNoDigitOfTheKineticEnergy)
{
  RandomStream random(2);
  const ClumpShape shape = crowd::random_shape(random, 3);
  const auto throw_one = [](int which, Engine& engine) {
    RandomStream from(100 + which);
    const int i = engine.add_clump(0, 2650, from.direction(), Quaternion::Identity(),
                                   from.uniform(0, 3) * from.direction());
    Clumps& clumps = engine.clumps();
    clumps.angular_momentum[i] = 40 * clumps.inertia[i].mean() * from.direction();
    clumps.spin[i] = clumps.spin_of(i, clumps.angular_momentum[i]);
  };
  for (int n = 1; n < 67; ++n) {
    Engine forwards({shape}, crowd::laws().front().pair, 9.81), backwards = forwards;
    double sum = 0;
    for (int k = 0; k < n; ++k) {
      throw_one(k, forwards);
      throw_one(n - 1 - k, backwards);
      Engine alone({shape}, crowd::laws().front().pair, 9.81);
      throw_one(k, alone);
      sum += alone.kinetic_energy();
    }
    ASSERT_EQ(forwards.kinetic_energy(), backwards.kinetic_energy()) << "of " << n << " clumps";
    ASSERT_NEAR(forwards.kinetic_energy(), sum, 1e-14 * sum * n);
  }
}
