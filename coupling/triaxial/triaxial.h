// The true-triaxial test: stones between six rigid walls, four of which keep the cell pressure
// while the plate squeezes them. What is measured and why: docs/theory/triaxial.md.
//
// Frame: that of triaxial_walls.h.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/stone_shapes.h"
#include "coupling/triaxial/triaxial_parameters.h"
#include "coupling/triaxial/triaxial_stages.h"
#include "coupling/triaxial/triaxial_walls.h"

#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
class Triaxial
{
public:
  static constexpr const char* name = "triaxial";
  using Stage = std::variant<FillStage, IsotropicStage, CompressStage>;

  // Nothing but the parameters: for reading a state into.
  explicit Triaxial(const TriaxialParameters& parameters);

  // Makes the stones and the empty box. Throws InputError, one full sentence, when a stone or the
  // time step cannot be used.
  void prepare(const Monitor& monitor, const std::vector<CaseEntry>& entries);
  // The same with these stones, which need not fit into the box in any attitude.
  void set_up(const std::vector<Stone>& stones);

  std::vector<Stage> plan() const;
  std::vector<std::string> history_columns() const;
  PhysicsLimits limits() const;
  void begin(RunRecords& records) const;                          // logs the preparation
  const std::string& preparation() const { return preparation_; } // what was made, for the log
  const std::vector<std::string>& stone_warnings() const { return stone_warnings_; }
  void finish(std::vector<Stage>& plan, RunRecords& records) const;

  World& world() { return world_; }
  const World& world() const { return world_; }

  // --- What the stages need to know -------------------------------------------------------------
  const TriaxialParameters& parameters() const { return parameters_; }
  Filling filling();
  dem::Vector3 size() const { return block_size(world_.engine, walls); } // below the plate [m]
  dem::Vector3 stresses() const { return wall_stresses(world_.engine, walls); } // [Pa]
  double porosity() const; // share of the volume between the walls that is no stone [-]

  double mean_size = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // [m]
  int n_shapes = 0;
  TriaxialWalls walls;

private:
  TriaxialParameters parameters_;
  World world_;
  std::string preparation_; // what it made, for the log
  std::vector<std::string> stone_warnings_;
  double preparation_time_ = 0; // wall-clock [s]
};

template <class Archive> void exchange(Archive& archive, Triaxial& test)
{
  archive("mean_stone_size", test.mean_size, "m");
  archive("mean_sphere_radius", test.mean_sphere_radius, "m");
  archive("stone_shapes", test.n_shapes);
  archive("walls", test.walls);
  archive("world", test.world());
}

// Leaves what the stones are like before the compression in the results.
void describe_specimen(const Triaxial& test, RunRecords& records);
} // namespace interlock::coupling
