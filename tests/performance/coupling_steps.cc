// Time of the hot loops, apart: one step of the beams of the pull-out lattice, one step of settled
// stones. Run with: cmake --build build/release --target benchmarks &&
// build/release/tests/benchmark_steps
#include "coupling/loop/rib_transfer.h"
#include "dem/engine/engine.h"
#include "dem/random_stream.h"
#include "tests/laid_geogrid.h"

#include <benchmark/benchmark.h>

using namespace interlock;
using dem::Vector3;

namespace
{
coupling::GeogridParameters geogrid(int apertures_along, int apertures_across)
{
  coupling::GeogridParameters p;
  p.apertures_along = apertures_along;
  p.apertures_across = apertures_across;
  p.pitch_along = p.pitch_across = 0.065;
  p.rib_width = 5e-3;
  p.rib_thickness = 2.5e-3;
  p.edge_rounding = 5e-4;
  p.youngs_modulus = 2.4e9;
  p.poisson_ratio = 0.3;
  p.density = 910;
  return p;
}

// 150 clumps of 40 spheres that fell 0.5 s into a box of 0.2 m x 0.2 m.
dem::Engine settled_stones()
{
  dem::RandomStream random(1);
  dem::ClumpShape shape;
  for (int a = 0; a < 40; ++a)
    shape.spheres.push_back({random.direction().cwiseProduct(Vector3(0.014, 0.011, 0.008)), 6e-3});
  shape.volume = 2.8e-5;
  shape.unit_inertia = shape.volume * Vector3(7e-5, 9e-5, 1.1e-4);
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 3e7;
  pair.friction = 0.6;
  pair.damping_ratio = 0.3;
  dem::Engine engine({shape}, pair, 9.81);
  const Vector3 x(0.2, 0, 0), y(0, 0.2, 0), z(0, 0, 3), origin(0, 0, 0);
  const Vector3 rectangles[][3] = {
      {origin, x, y}, {origin, y, z}, {x, y, z}, {origin, x, z}, {y, x, z}};
  for (const auto& r : rectangles) {
    dem::Wall wall;
    wall.corner = r[0], wall.edge1 = r[1], wall.edge2 = r[2], wall.contact = pair;
    engine.add_wall(wall);
  }
  for (int n = 0; n < 150; ++n)
    engine.add_clump(0, 2650,
                     {0.03 + 0.045 * (n % 4), 0.03 + 0.045 * (n / 4 % 4), 0.03 + 0.045 * (n / 16)},
                     dem::Quaternion(Eigen::AngleAxisd(random.uniform(0, 3), random.direction())));
  engine.set_local_damping(0.5);
  for (int n = 0; n < 200000; ++n) engine.step(2.5e-6);
  return engine;
}
} // namespace

static void beam_step(benchmark::State& state)
{
  coupling::RibTransfer grid =
      laid_geogrid(geogrid(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))),
                   Vector3::Zero(), 9.81);
  for (auto _ : state) grid.dynamics().step(1e-6);
  state.counters["elements"] = grid.lattice().n_elements();
}
// The lattice of the pull-out case, and one of 480 elements.
BENCHMARK(beam_step)->Args({6, 3})->Args({5, 5})->Unit(benchmark::kMicrosecond);

static void stone_step(benchmark::State& state)
{
  dem::Engine engine = settled_stones();
  for (auto _ : state) engine.step(2.5e-6);
  state.counters["clumps"] = engine.clumps().size();
  state.counters["touching"] = engine.n_touching_spheres();
}
BENCHMARK(stone_step)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
