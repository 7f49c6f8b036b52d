// Time of a step of a packed box on several ranks, by the engine alone: forces, motion, ghosts.
//   cmake --build build/release --target benchmark_ranks
//   mpirun -n 2 --bind-to core build/release/tests/benchmark_ranks
//   cases/benchmark/w2_settled.json.gz
// After 1000 steps come four times 1000 timed ones; contact law and step are those of
// cases/benchmark/w1.prm.
#include "coupling/packing/packed_state.h"
#include "dem/parallel/domain.h"

#include <chrono>
#include <cstdio>
#include <exception>

namespace
{
using namespace interlock;
using dem::Vector3;
using Clock = std::chrono::steady_clock;

constexpr double dt = 1e-5; // [s]
constexpr int steps = 1000;
constexpr double cells = 2.4; // width over the largest bounding radius

// All stones, on every rank; rank 0 moves them until they are dealt.
dem::Engine packed(const coupling::PackedState& state, bool ours)
{
  dem::ContactProperties pair;
  pair.normal_stiffness = 1e7;
  pair.tangential_stiffness = 2. / 3 * 1e7;
  pair.friction = 0.7;
  pair.normal_damping_rate = 4000;
  pair.tangential_damping_rate = 2000;
  dem::Engine engine(state.shapes, pair, 9.81);
  const Vector3 x(state.box.x(), 0, 0), y(0, state.box.y(), 0), z(0, 0, state.box.z() + 1),
      origin(0, 0, 0);
  engine.add_wall(dem::rectangle_wall("floor", origin, x, y, pair));
  engine.add_wall(dem::rectangle_wall("x = 0", origin, y, z, pair));
  engine.add_wall(dem::rectangle_wall("x = length", x, y, z, pair));
  engine.add_wall(dem::rectangle_wall("y = 0", origin, x, z, pair));
  engine.add_wall(dem::rectangle_wall("y = width", y, x, z, pair));
  for (const coupling::PackedClump& c : state.clumps)
    engine.add_clump(c.shape, state.density, c.position, c.orientation);
  engine.compute_forces(dt);
  for (int i = 0; i < engine.clumps().size(); ++i) {
    engine.clumps().set_motion(i, state.clumps[i].velocity, state.clumps[i].spin);
    engine.clumps().ghost[i] = ours ? 0 : 1;
  }
  return engine;
}

// Adds the time of a call to a sum [s].
template <class Function> void timed(double& sum, const Function& f)
{
  const auto begin = Clock::now();
  f();
  sum += std::chrono::duration<double>(Clock::now() - begin).count();
}

void run(const char* file)
{
  const dem::Ranks ranks(MPI_COMM_WORLD);
  const coupling::PackedState state = coupling::read_packed_state(file);
  dem::Engine engine = packed(state, ranks.rank() == 0);
  double largest = 0;
  for (const dem::ClumpShape& shape : state.shapes)
    largest = std::max(largest, shape.bounding_radius());
  dem::Domain domain(ranks, dem::CellGrid(Vector3::Zero(), state.box, cells * largest));
  domain.deal(engine);
  for (int round = 0; round <= 4; ++round) {
    double all = 0, dealing = 0, computing = 0, copying = 0;
    int deals = 0;
    MPI_Barrier(ranks.comm());
    timed(all, [&] {
      for (int n = 0; n < steps; ++n) {
        timed(dealing, [&] {
          if (!domain.has_expired(engine)) return;
          domain.deal(engine);
          ++deals;
        });
        timed(computing, [&] {
          engine.compute_forces(dt);
          engine.kick_all(dt);
          engine.drift_all(dt, &engine.clumps().ghost);
        });
        timed(copying, [&] { domain.refresh(engine); });
        engine.move_walls(dt);
      }
      MPI_Barrier(ranks.comm());
    });
    if (round == 0) continue; // warms up
    int ghosts = 0;
    for (int i = 0; i < engine.clumps().size(); ++i) ghosts += engine.clumps().ghost[i] == 1;
    const double us = 1e6 / steps;
    std::printf("rank %d of %d: %.1f us a step; engine %.1f, copying ghosts and waiting %.1f, "
                "agreeing and dealing %.1f (%d times); %d stones, %d ghosts\n",
                ranks.rank(), ranks.size(), us * all, us * computing, us * copying, us * dealing,
                deals, engine.clumps().size() - ghosts, ghosts);
    std::fflush(stdout);
  }
}
} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    if (argc != 2) throw std::runtime_error("Give one file: a packed state.");
    run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_ranks: %s\n", error.what());
    code = 2;
  }
  if (code != 0) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return code;
}
