// What the next step of an engine needs is in its field list. A state is written in the middle of
// contacts, read into an engine that was made from nothing, and both go on. Fails when any digit of
// either differs later: of a pose, of what a contact remembers, of an energy or of a wall; or when
// saving what was read gives another state.
#include "tests/carry_over.h"
#include "tests/dem_bodies.h"
#include "tests/dem_crowd.h"
#include "tests/dem_wall_bench.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <functional>
#include <memory>

using namespace interlock;
using namespace carry;
using dem::Engine;
using dem::Vector3;

namespace
{
void expect_same_energies(const Engine& a, const Engine& b, double dt)
{
  const dem::EngineEnergy p = a.energy(dt), q = b.energy(dt);
  EXPECT_EQ(p.kinetic, q.kinetic);
  EXPECT_EQ(p.gravitational, q.gravitational);
  EXPECT_EQ(p.contact.elastic, q.contact.elastic);
  EXPECT_EQ(p.contact.friction, q.contact.friction);
  EXPECT_EQ(p.contact.damping, q.contact.damping);
  EXPECT_EQ(p.contact.crushing, q.contact.crushing);
  EXPECT_EQ(p.local_damping, q.local_damping);
  EXPECT_EQ(p.wall_work, q.wall_work);
  EXPECT_EQ(p.inserted, q.inserted);
  EXPECT_EQ(a.kinetic_energy(), b.kinetic_energy());
  EXPECT_EQ(a.elastic_energy(), b.elastic_energy());
}

// --- Scenes ------------------------------------------------------------------------------------

struct Scene {
  std::string name;
  std::function<Engine()> make; // as at the start of a run
  // What a new process has before it reads: nothing but the walls of triangles.
  std::function<Engine()> make_empty;
  bool has_meshes = false;
};
void PrintTo(const Scene& scene, std::ostream* out)
{
  *out << scene.name;
}

constexpr double dt = crowd::time_step;

// Four sides and a lid around the space from `low` to `high`. The lid presses, or, under Hertz's
// law, which force control does not know, comes down.
void close_box(Engine& engine, const Vector3& low, const Vector3& high,
               const dem::ContactProperties& pair)
{
  const Vector3 x(high.x() - low.x(), 0, 0), y(0, high.y() - low.y(), 0), up(0, 0, 0.5);
  engine.add_wall(dem::rectangle_wall("left", low, y, up, pair));
  engine.add_wall(dem::rectangle_wall("right", low + x, y, up, pair));
  engine.add_wall(dem::rectangle_wall("front", low, x, up, pair));
  engine.add_wall(dem::rectangle_wall("back", low + y, x, up, pair));
  const dem::WallId lid =
      engine.add_wall(dem::rectangle_wall("lid", {low.x(), low.y(), high.z()}, x, y, pair));
  if (pair.model == dem::ContactModel::linear) {
    dem::ForceControl control;
    control.axis = {0, 0, -1};
    control.force = 20;
    control.largest_speed = 1;
    engine.control_wall(lid, control);
  } else {
    engine.wall(lid).velocity = {0, 0, -0.5};
  }
}

Engine crowd_in_a_box(const dem::ContactProperties& pair)
{
  Engine engine = crowd::thrown(11, pair).engine;
  close_box(engine, {-0.021, -0.021, 0}, {0.171, 0.171, 0.172}, pair);
  engine.set_local_damping(0.1);
  return engine;
}

dem::ContactProperties soft_pair()
{
  return crowd::laws().front().pair;
}

// A tray of triangles that tilts and sinks, at the edge of a floor.
dem::MeshWall tray()
{
  dem::MeshWall wall = dem::mesh_wall(
      "tray", wall_bench::rectangle({-0.001, -0.05, 0.003}, {0.15, 0, -0.004}, {0, 0.2, 0}, 5, 4));
  wall.contact = soft_pair();
  wall.velocity = {0.02, 0, -0.01};
  wall.spin = {0, 0.05, 0.3};
  return wall;
}

// Balls that resist rolling, pressed on each other, on a floor, on the sides of a box and on the
// tray.
Engine balls_on_a_tray()
{
  constexpr double radius = 0.008, spacing = 0.0158; // [m]
  Engine engine({bodies::ball(radius)}, soft_pair(), 9.81);
  dem::RandomStream random(13);
  for (int n = 0; n < 90; ++n) {
    const Vector3 place(-0.041 + n % 6 * spacing, n / 6 % 5 * spacing, 0.013 + n / 30 * spacing);
    const int i = engine.add_clump(0, 2650, place + 4e-4 * random.direction(),
                                   dem::Quaternion(random.rotation()), 0.1 * random.direction());
    bodies::set_spin(engine, i, 30 * random.direction());
  }
  engine.add_wall(
      dem::rectangle_wall("floor", {-0.2, -0.05, 0.004}, {0.2, 0, 0}, {0, 0.2, 0}, soft_pair()));
  close_box(engine, {-0.049, -0.008, -0.05}, {-0.033 + 5 * spacing, 0.008 + 4 * spacing, 0.053},
            soft_pair());
  engine.set_local_damping(0.1);
  engine.add_mesh_wall(tray());
  engine.set_rolling({0.3, 0.2});
  return engine;
}

std::vector<Scene> scenes()
{
  const auto nothing = [] { return Engine({}, dem::ContactProperties(), 0); };
  std::vector<Scene> all;
  for (const crowd::Law& law : crowd::laws())
    all.push_back({law.name, [pair = law.pair] { return crowd_in_a_box(pair); }, nothing, false});
  all.push_back({"RollingOnTriangles", balls_on_a_tray,
                 [nothing] {
                   Engine engine = nothing();
                   dem::MeshWall wall = tray();
                   wall.velocity = wall.spin = Vector3::Zero(); // these are read
                   wall.contact = {};
                   engine.add_mesh_wall(wall);
                   return engine;
                 },
                 true});
  return all;
}

class EngineState : public TemporaryFolderTest, public testing::WithParamInterface<Scene>
{
protected:
  static void run(Engine& engine, int steps)
  {
    for (int n = 0; n < steps; ++n) engine.step(dt);
  }

  // A state in which nothing can hide: springs of every kind are under load.
  static Engine in_the_middle()
  {
    Engine engine = GetParam().make();
    for (int n = 0; n < 8000; ++n) {
      run(engine, 1);
      if (everything_is_loaded(engine.memory())) return engine;
    }
    ADD_FAILURE() << "there was no moment with springs of every kind under load";
    return engine;
  }

  static bool everything_is_loaded(const dem::ContactMemory& memory)
  {
    const auto rubs = [](const auto& c) { return c.lane.spring.norm() > 0; };
    const auto pairs = std::count_if(memory.pairs.begin(), memory.pairs.end(), rubs);
    const auto at_walls = std::count_if(memory.walls.begin(), memory.walls.end(), rubs);
    std::set<dem::WallId> walls;
    for (const dem::WallMemory& c : memory.walls) walls.insert(c.wall);
    if (!GetParam().has_meshes) return pairs > 20 && at_walls > 5 && walls.size() >= 4;
    std::array<int, 3> rolling = {0, 0, 0};
    for (const dem::RollingMemory& s : memory.rolling) ++rolling[s.kind];
    return pairs > 0 && at_walls > 0 && !memory.meshes.empty() && rolling[0] > 0 &&
           rolling[1] > 0 && rolling[2] > 0;
  }
};
INSTANTIATE_TEST_SUITE_P(Scenes, EngineState, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.name; });
} // namespace

TEST_P(EngineState, GoesOnWithTheSameDigits)
{
  Engine one = in_the_middle(), two = GetParam().make_empty();
  ASSERT_NO_FATAL_FAILURE(carry_over(one, two, folder / "state.h5"));
  for (int hundred = 1; hundred <= 5; ++hundred) {
    run(one, 100);
    run(two, 100);
    ASSERT_NO_FATAL_FAILURE(expect_same(one, two, std::to_string(100 * hundred) + " steps later"));
    one.compute_forces(dt);
    two.compute_forces(dt);
    expect_same_energies(one, two, dt);
  }
}

// What happens to bodies later must find the same things, too.
TEST_P(EngineState, LaterRemovalsHaveTheSameDigits)
{
  Engine one = in_the_middle(), two = GetParam().make_empty();
  ASSERT_NO_FATAL_FAILURE(carry_over(one, two, folder / "state.h5"));
  for (Engine* engine : {&one, &two}) {
    std::vector<bool> remove(engine->clumps().size(), false);
    remove[3] = remove[20] = true;
    engine->remove_clumps(remove);
    run(*engine, 50);
    engine->remove_walls({engine->walls().back().id});
    const int i = engine->add_clump(0, 2650, {0.3, 0, 0.5}, dem::Quaternion::Identity());
    EXPECT_EQ(engine->clumps().id[i], engine->clumps().next_id() - 1);
    engine->add_wall(
        dem::rectangle_wall("new", {-1, -1, 0.49}, {2, 0, 0}, {0, 2, 0}, engine->stone_contact()));
    run(*engine, 150);
  }
  ASSERT_NO_FATAL_FAILURE(expect_same(one, two, "after the removals"));
  expect_same_energies(one, two, dt);
}

// Thirty processes in a row against one.
TEST_P(EngineState, ManyInterruptionsChangeNoDigit)
{
  Engine one = in_the_middle();
  auto many = std::make_unique<Engine>(one);
  for (int part = 0; part < 30; ++part) {
    auto next = std::make_unique<Engine>(GetParam().make_empty());
    ASSERT_NO_FATAL_FAILURE(carry_over(*many, *next, folder / "state.h5"));
    many = std::move(next);
    run(*many, 1 + part % 13);
    run(one, 1 + part % 13);
    ASSERT_NO_FATAL_FAILURE(expect_same(one, *many, "part " + std::to_string(part)));
  }
}

// Nobody has moved or rubbed yet.
TEST_P(EngineState, ReadsTheFirstMoment)
{
  Engine one = GetParam().make(), two = GetParam().make_empty();
  ASSERT_NO_FATAL_FAILURE(carry_over(one, two, folder / "state.h5"));
  run(one, 100);
  run(two, 100);
  ASSERT_NO_FATAL_FAILURE(expect_same(one, two, "100 steps later"));
}

TEST_P(EngineState, RemovedWallsLeaveTheHistoriesOfTheOthers)
{
  Engine engine = in_the_middle();
  const dem::ContactMemory before = engine.memory();
  std::vector<dem::WallId> gone = {engine.walls()[0].id};
  if (engine.walls().size() > 3) gone.push_back(engine.walls()[3].id);
  const auto is_gone = [&](dem::WallId id) {
    return std::find(gone.begin(), gone.end(), id) != gone.end();
  };
  const double stored = engine.elastic_energy(), inserted = engine.energy(dt).inserted;
  engine.remove_walls(gone);

  dem::ContactMemory expected = before;
  expected.walls.erase(std::remove_if(expected.walls.begin(), expected.walls.end(),
                                      [&](const dem::WallMemory& c) { return is_gone(c.wall); }),
                       expected.walls.end());
  expected.rolling.erase(
      std::remove_if(expected.rolling.begin(), expected.rolling.end(),
                     [&](const dem::RollingMemory& s) { return s.kind == 1 && is_gone(s.second); }),
      expected.rolling.end());
  EXPECT_LT(expected.walls.size(), before.walls.size());
  ASSERT_NO_FATAL_FAILURE(expect_same(engine.memory(), expected, "after the removal"));
  // What went with them is booked.
  EXPECT_LT(engine.elastic_energy(), stored);
  EXPECT_NEAR(inserted - engine.energy(dt).inserted, stored - engine.elastic_energy(),
              1e-12 * stored);
  for (const dem::WallId id : gone) EXPECT_THROW(engine.wall(id), std::invalid_argument);
}

// An engine that has walls of triangles which the state does not know, or lacks some.
TEST(EngineMemory, OtherWallsOfTrianglesAreRefused)
{
  const Engine engine = balls_on_a_tray();
  StateTree tree;
  StateWriter(tree, "")("engine", engine);
  Engine bare({}, dem::ContactProperties(), 0);
  StateReader reader(tree);
  EXPECT_THROW(reader("engine", bare), std::logic_error);
}
