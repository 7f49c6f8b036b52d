// What the next step of an engine and of a whole world needs is in their field lists. A state is
// written in the middle of contacts, read into an engine that was made from nothing, and both go
// on. Fails when any digit of either differs later: of a pose, of what a contact remembers, of an
// energy, of a wall or of the lattice; or when saving what was read gives another state.
#include "coupling/loop/world.h"
#include "coupling/state/checkpoint_file.h"
#include "coupling/state/state_archive.h"
#include "tests/cross_of_ribs.h"
#include "tests/dem_bodies.h"
#include "tests/dem_crowd.h"
#include "tests/dem_wall_bench.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <functional>
#include <memory>

using namespace interlock;
using namespace interlock::coupling;
using dem::Engine;
using dem::Vector3;

namespace
{
// Both go by the same digits or by none.
template <class T> void expect_same(const T& a, const T& b, const std::string& when)
{
  StateTree one, two;
  StateWriter(one, "state/")("whole", a);
  StateWriter(two, "state/")("whole", b);
  ASSERT_EQ(first_difference(one, two), std::nullopt) << when;
  ASSERT_EQ(hash_of(one), hash_of(two)) << when;
}

// Through a file, as a checkpoint goes.
template <class T> void carry_over(const T& from, T& to, const std::filesystem::path& file)
{
  StateTree tree, again;
  StateWriter(tree, "state/")("whole", from);
  write_state(file, tree, "1.2.3");
  const StateTree read = read_state(file);
  ASSERT_EQ(first_difference(read, tree), std::nullopt);
  StateReader reader(read, "state/");
  reader("whole", to);
  reader.expect_all_read();
  StateWriter(again, "state/")("whole", to);
  ASSERT_EQ(first_difference(again, tree), std::nullopt) << "saved again";
}

void expect_same_energies(const Engine& a, const Engine& b, double dt)
{
  const dem::EngineEnergy p = a.energy(dt), q = b.energy(dt);
  EXPECT_EQ(p.kinetic, q.kinetic);
  EXPECT_EQ(p.gravitational, q.gravitational);
  EXPECT_EQ(p.contact.elastic, q.contact.elastic);
  EXPECT_EQ(p.contact.friction, q.contact.friction);
  EXPECT_EQ(p.contact.damping, q.contact.damping);
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

// --- The engine --------------------------------------------------------------------------------

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

// --- The world ---------------------------------------------------------------------------------

namespace
{
dem::ClumpShape three_balls()
{
  dem::ClumpShape shape;
  shape.spheres = {{Vector3(0.005, 0.001, 0), 0.008},
                   {Vector3(-0.006, 0, 0.001), 0.007},
                   {Vector3(0, 0.004, 0.002), 0.006}};
  shape.volume = 6e-6;
  shape.unit_inertia = Vector3(2.2, 2.9, 3.6) * 1e-10;
  return shape;
}

std::unique_ptr<RibTransfer> geogrid()
{
  return std::make_unique<RibTransfer>(cross_of_ribs::cross(12, 100));
}

std::unique_ptr<World> empty_world()
{
  const dem::ContactProperties pair = cross_of_ribs::contact(0.1);
  return std::make_unique<World>(std::vector<dem::ClumpShape>(), dem::ContactProperties(), pair, 0);
}

// A ball on the crossing with another one on top, and a clump that spins on a rib, while the clamp
// pulls.
std::unique_ptr<World> start(double local_damping)
{
  const dem::ContactProperties pair = cross_of_ribs::contact(0.1);
  auto world = std::make_unique<World>(
      std::vector<dem::ClumpShape>{cross_of_ribs::ball(0.011), three_balls()}, pair, pair, 9.81);
  Engine& engine = world->engine;
  engine.set_local_damping(local_damping);
  const double surface = 0.5 * cross_of_ribs::rib_section().thickness;
  engine.add_clump(0, 2650, {5e-4, 2e-4, surface + 0.011 + 1e-5}, dem::Quaternion::Identity(),
                   {0.05, 0, -0.2});
  engine.add_clump(0, 2650, {2e-3, 0, surface + 0.033 + 1e-5}, dem::Quaternion::Identity(),
                   {0, 0, -0.3});
  const int i = engine.add_clump(1, 2650, {0.035, 5e-4, surface + 0.008 + 2e-5},
                                 dem::Quaternion::Identity(), {0.01, 0.02, -0.2});
  bodies::set_spin(engine, i, Vector3(0.3, 0.2, 4));
  engine.add_clump(1, 2650, {0.3, 0, 0.5}, dem::Quaternion::Identity()); // far from all ribs
  world->clock.set_step(2.5e-6);
  world->clamp_velocity = {0.05, 0, 0};
  world->place_geogrid(geogrid());
  return world;
}

void run(World& world, int steps)
{
  for (int n = 0; n < steps; ++n) {
    world.compute_forces();
    world.move();
  }
}

std::unique_ptr<World> carried_over(const World& world, const std::filesystem::path& file)
{
  std::unique_ptr<World> next = empty_world();
  next->attach_geogrid(geogrid());
  carry_over(world, *next, file);
  return next;
}

class WorldState : public TemporaryFolderTest, public testing::WithParamInterface<double>
{
protected:
  std::unique_ptr<World> in_the_middle() const
  {
    std::unique_ptr<World> world = start(GetParam());
    for (int n = 0; n < 4000; ++n) {
      run(*world, 1);
      int rubbing = 0;
      for (const dem::RibContact& c : world->ribs.rib_contacts().contacts())
        rubbing += c.overlap > 0 && c.history.spring.norm() > 0;
      if (rubbing >= 1 && world->engine.n_touching_spheres() >= 1) return world;
    }
    ADD_FAILURE() << "there was no moment with a contact with a rib and one of stones";
    return world;
  }
};
INSTANTIATE_TEST_SUITE_P(LocalDamping, WorldState, testing::Values(0., 0.5),
                         [](const auto& share) { return share.param > 0 ? "On" : "Off"; });

void expect_same_ledgers(World& a, World& b)
{
  a.compute_forces();
  b.compute_forces();
  const auto p = a.ledger().entries(), q = b.ledger().entries();
  for (std::size_t k = 0; k < p.size(); ++k) EXPECT_EQ(p[k].second, q[k].second) << p[k].first;
  EXPECT_EQ(a.ribs.clamp_force(), b.ribs.clamp_force());
  EXPECT_EQ(a.ribs.substeps(), b.ribs.substeps());
  EXPECT_EQ(a.clock.time(), b.clock.time());
  a.move();
  b.move();
}
} // namespace

TEST_P(WorldState, GoesOnWithTheSameDigits)
{
  const std::unique_ptr<World> one = in_the_middle();
  const std::unique_ptr<World> two = carried_over(*one, folder / "state.h5");
  ASSERT_FALSE(HasFatalFailure());
  for (int hundred = 1; hundred <= 5; ++hundred) {
    run(*one, 99);
    run(*two, 99);
    expect_same_ledgers(*one, *two);
    ASSERT_NO_FATAL_FAILURE(
        expect_same(*one, *two, std::to_string(100 * hundred) + " steps later"));
  }
}

// From before the first touch to after it, cut at uneven places.
TEST_P(WorldState, ManyInterruptionsChangeNoDigit)
{
  const std::unique_ptr<World> one = start(GetParam());
  std::unique_ptr<World> many = start(GetParam());
  for (int part = 0; part < 40; ++part) {
    many = carried_over(*many, folder / "state.h5");
    run(*one, 1 + part % 23);
    run(*many, 1 + part % 23);
    ASSERT_NO_FATAL_FAILURE(expect_same(*one, *many, "part " + std::to_string(part)));
  }
  EXPECT_GT(many->largest_overlap(), 0);
}

// The stone that is sub-cycled with the ribs goes; the indices of the others shift.
TEST_P(WorldState, LaterRemovalsHaveTheSameDigits)
{
  const std::unique_ptr<World> one = in_the_middle();
  const std::unique_ptr<World> two = carried_over(*one, folder / "state.h5");
  ASSERT_FALSE(HasFatalFailure());
  for (World* world : {one.get(), two.get()}) {
    world->remove({true, false, false, false});
    run(*world, 200);
  }
  ASSERT_NO_FATAL_FAILURE(expect_same(*one, *two, "after the removal"));
  expect_same_ledgers(*one, *two);
}
