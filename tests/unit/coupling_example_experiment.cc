// The example of CONTRIBUTING.md: an experiment of one stage, run, stopped and resumed. Fails when
// an experiment needs more than its parameters, a stage and a plan, when a ball does not bounce as
// high as its restitution says, or when a resumed run is not the one that was stopped.
#include "coupling/run/run.h"
#include "tests/temporary_folder.h"

using namespace interlock;
using namespace interlock::coupling;

// [example]
// A ball falls on a floor: how high does it bounce?
struct BounceParameters {
  double height = 0.05;     // of the fall [m]
  double restitution = 0.8; // [-]
};

class Bounce;

// The only stage: until the ball is at the top of its flight after the impact.
struct FlightStage {
  static constexpr const char* kind = "flight";
  double lowest = 1e300; // height so far [m]
  bool has_risen = false;
};
template <class Archive> void exchange(Archive& archive, FlightStage& stage)
{
  archive("lowest", stage.lowest, "m");
  archive("has_risen", stage.has_risen);
}
std::string stage_name(const FlightStage&)
{
  return FlightStage::kind;
}
StageStatus before_step(FlightStage& stage, Bounce& bounce, RunRecords& records);
void look(FlightStage& stage, Bounce& bounce, RunRecords& records);
void after_step(FlightStage&, Bounce&, RunRecords&) {}

class Bounce
{
public:
  static constexpr const char* name = "bounce";
  using Stage = std::variant<FlightStage>;

  explicit Bounce(const BounceParameters& p) : parameters_(p), world_({}, contact(p), {}, 9.81) {}

  void prepare(const Monitor&, const std::vector<CaseEntry>&)
  {
    dem::Engine& engine = world_.engine;
    const int shape = engine.clumps().add_shape(ball());
    engine.add_wall(
        dem::rectangle_wall("floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, engine.stone_contact()));
    engine.add_clump(shape, 2650, {0, 0, radius + parameters_.height}, dem::Quaternion::Identity());
    world_.clock.set_step(5e-6);
  }
  std::vector<Stage> plan() const { return {FlightStage()}; }
  std::vector<std::string> history_columns() const { return {"time [s]", "height [m]"}; }
  PhysicsLimits limits() const { return {}; }
  void begin(RunRecords&) const {}
  void finish(std::vector<Stage>&, RunRecords& records) const
  {
    records.summary.results["bounce_height_m"] = height();
  }
  World& world() { return world_; }
  double height() const { return world_.engine.clumps().position[0].z() - radius; }

private:
  static constexpr double radius = 0.01;
  static dem::ContactProperties contact(const BounceParameters& p)
  {
    dem::ContactProperties pair;
    pair.normal_stiffness = pair.tangential_stiffness = 1e6;
    pair.tension = true; // for which the damping ratio below is exact
    pair.damping_ratio = dem::damping_ratio_for_restitution(p.restitution);
    return pair;
  }
  static dem::ClumpShape ball()
  {
    dem::ClumpShape shape;
    shape.name = "ball";
    shape.spheres = {{dem::Vector3::Zero(), radius}};
    shape.volume = 4 * M_PI / 3 * std::pow(radius, 3);
    shape.unit_inertia = dem::Vector3::Constant(0.4 * shape.volume * radius * radius);
    return shape;
  }
  BounceParameters parameters_;
  World world_;
};
template <class Archive> void exchange(Archive& archive, Bounce& bounce)
{
  archive("world", bounce.world());
}

// The protocol: nothing is done to the ball; the stage ends when it falls for the second time.
StageStatus before_step(FlightStage& stage, Bounce& bounce, RunRecords&)
{
  const double speed = bounce.world().engine.clumps().velocity[0].z();
  if (speed > 0) stage.has_risen = true;
  if (stage.has_risen && speed <= 0)
    return finished(fmt::format("bounced up to {:.1f} mm", 1e3 * bounce.height()));
  return running(stage.has_risen ? 0.9 : 0.5, Look::at_everything);
}

// The measures: a row of history.csv every millisecond.
void look(FlightStage& stage, Bounce& bounce, RunRecords& records)
{
  stage.lowest = std::min(stage.lowest, bounce.height());
  if (bounce.world().clock.step % 200 == 0)
    records.add({bounce.world().clock.time(), bounce.height()});
}
// [example]

namespace
{
class ExampleExperiment : public TemporaryFolderTest
{
protected:
  // `stop_at`: step at which the run is asked to stop; 0: never.
  Summary run(const std::string& name, bool resume, int stop_at = 0)
  {
    RunRequest request;
    request.folder = folder / name;
    std::filesystem::create_directories(request.folder);
    request.resume = resume;
    int steps = 0;
    request.monitor.stop_requested = [&] { return ++steps == stop_at; };
    Bounce bounce{BounceParameters()};
    if (!resume) bounce.prepare(request.monitor, {});
    return coupling::Run<Bounce>(bounce, request).run();
  }
};
} // namespace

TEST_F(ExampleExperiment, BouncesAsHighAsItsRestitutionSays)
{
  const Summary s = run("whole", false);
  EXPECT_NEAR(s.results["bounce_height_m"].get<double>(), 0.8 * 0.8 * 0.05, 1e-4);
  EXPECT_EQ(s.stages.size(), 1u);
}

TEST_F(ExampleExperiment, StopsAndGoesOn)
{
  const Summary whole = run("whole", false);
  // In free fall, while it touches (the impact is at about 0.101 s), and on its way up.
  for (const int step : {1, 5000, 20210, 30000}) {
    const std::string name = "stopped_" + std::to_string(step);
    EXPECT_THROW(run(name, false, step), RunStopped);
    const Summary resumed = run(name, true);
    EXPECT_EQ(resumed.state_hash, whole.state_hash) << name;
    EXPECT_EQ(resumed.steps, whole.steps);
    EXPECT_EQ(file_text(folder / name / "history.csv"),
              file_text(folder / "whole" / "history.csv"));
  }
}
