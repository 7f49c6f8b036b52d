// What the log and the refusal of a step say about the stone that sets it. Fails when another shape
// than the most mobile one is named, for example the lightest.
#include "coupling/parameters/time_step.h"
#include "dem/engine/engine.h"
#include "dem/input_error.h"

#include <gtest/gtest.h>

using namespace interlock;
using dem::Vector3;

namespace
{
// A ball, and a dumb-bell four times as heavy that turns easily about its middle.
dem::StableStep ball_and_dumb_bell()
{
  dem::ClumpShape ball, dumb_bell;
  ball.spheres = {{Vector3::Zero(), 0.01}};
  ball.volume = 4e-6;
  ball.unit_inertia = Vector3::Constant(0.4 * ball.volume * 1e-4);
  dumb_bell.spheres = {{Vector3(0.05, 0, 0), 0.01}, {Vector3(-0.05, 0, 0), 0.01}};
  dumb_bell.volume = 16e-6;
  dumb_bell.unit_inertia = 4 * ball.unit_inertia;
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 1e7;
  return dem::Engine({ball, dumb_bell}, pair, 9.81).expected_stable_step({2500, 2500}, 8);
}
} // namespace

TEST(TimeStep, NamesTheShapeThatSetsIt)
{
  const dem::StableStep stable = ball_and_dumb_bell();
  EXPECT_EQ(stable.shape, 1);
  EXPECT_EQ(stable.clump_id, -1); // there is no clump
  EXPECT_NE(coupling::time_step_budget(0.5 * stable.step, stable).find("shape 2 of 40 g"),
            std::string::npos);
  coupling::TimeParameters time;
  time.step = 1.01 * stable.step;
  try {
    coupling::choose_time_step(time, stable);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("which shape 2 of 40 g with 8 contacts sets"),
              std::string::npos)
        << error.what();
  }
  time.step = 0.99 * stable.step;
  EXPECT_EQ(coupling::choose_time_step(time, stable), time.step);
}
