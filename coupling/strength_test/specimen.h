// The stones of a strength test and the world they are in: made, poured into the box of their
// experiment, and described. Walls and what moves them belong to the experiment.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/output/monitor.h"
#include "coupling/run/forecast.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/stone_shapes.h"
#include "coupling/strength_test/specimen_parameters.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
class Specimen
{
public:
  // Stones get the friction of the filling. Nothing but the parameters: for reading a state into.
  explicit Specimen(const SpecimenParameters& parameters);

  // Throws InputError, one full sentence, when a stone cannot be used or does not fit into the box.
  std::vector<Stone> make_stones(const Monitor& monitor);
  // As shapes of the world; chooses the time step. Throws InputError when the given one is too
  // long.
  void add(const std::vector<Stone>& stones);

  // The first stage of a test, and what it needs to know.
  FillStage fill_stage() const;
  Filling filling();

  void log_preparation(RunRecords& records) const;
  const std::string& preparation() const { return preparation_; } // what was made, for the log
  const std::vector<std::string>& stone_warnings() const { return stone_warnings_; }

  const SpecimenParameters& parameters() const { return parameters_; }
  World& world() { return world_; }
  const World& world() const { return world_; }
  // Of which the walls press until the stones have the friction of the test, when they press with
  // `stress` in it [Pa].
  double first_stress(double stress) const;
  double porosity(double volume) const; // share of the volume that is no stone [-]
  // Stones stay between the origin and this corner.
  PhysicsLimits limits(const dem::Vector3& far_corner) const;

  double mean_size = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // [m]
  int n_shapes = 0;

private:
  SpecimenParameters parameters_;
  World world_;
  std::string preparation_;
  std::vector<std::string> stone_warnings_;
  double preparation_time_ = 0; // wall-clock [s]
};

template <class Archive> void exchange(Archive& archive, Specimen& specimen)
{
  archive("mean_stone_size", specimen.mean_size, "m");
  archive("mean_sphere_radius", specimen.mean_sphere_radius, "m");
  archive("stone_shapes", specimen.n_shapes);
  archive("world", specimen.world());
}

// Into the results: how many stones and of which kind; how densely they lie in `volume` [m3].
void describe_stones(const Specimen& specimen, nlohmann::ordered_json& results);
void describe_density(const Specimen& specimen, double volume, nlohmann::ordered_json& results);

// What a test of this specimen will take. `consolidation`, `motion`: simulated times of the stages
// [s]; `frames`: of the motion.
Forecast forecast(const Specimen& specimen, double consolidation, const std::string& motion_name,
                  double motion, int frames);
} // namespace interlock::coupling
