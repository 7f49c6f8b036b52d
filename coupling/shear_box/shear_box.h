// The shear box experiment: stones in a box of two halves, pressed by a plate that keeps its force;
// the lower half moves. What is measured and why: docs/theory/ballast_laboratory.md.
//
// Frame: that of shear_box_walls.h.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"
#include "coupling/shear_box/shear_box_parameters.h"
#include "coupling/shear_box/shear_box_stages.h"
#include "coupling/shear_box/shear_box_walls.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/stone_shapes.h"

#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
class ShearBox
{
public:
  static constexpr const char* name = "shear box";
  using Stage = std::variant<FillStage, ConsolidateStage, ShearStage>;

  // Nothing but the parameters: for reading a state into.
  explicit ShearBox(const ShearBoxParameters& parameters);

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
  const ShearBoxParameters& parameters() const { return parameters_; }
  Filling filling();
  double area() const { return parameters_.box.length * parameters_.box.width; } // of the plane
  double weight_above_plane() const; // of stones with their centre there [N]
  dem::ContactProperties stone_on_floor_and_plate() const;
  // With which the plate has to press for a normal stress [Pa] on the plane. Throws RunFailure when
  // the stones above the plane weigh more [N].
  double plate_force(double normal_stress) const;
  double plate_height() const { return world_.engine.wall(walls.plate).corner.z(); } // [m]
  // Share of the volume below the plate that is no stone [-].
  double porosity() const;

  double mean_size = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // [m]
  int n_shapes = 0;
  ShearBoxWalls walls;

private:
  ShearBoxParameters parameters_;
  World world_;
  std::string preparation_; // what it made, for the log
  std::vector<std::string> stone_warnings_;
  double preparation_time_ = 0; // wall-clock [s]
};

template <class Archive> void exchange(Archive& archive, ShearBox& box)
{
  archive("mean_stone_size", box.mean_size, "m");
  archive("mean_sphere_radius", box.mean_sphere_radius, "m");
  archive("stone_shapes", box.n_shapes);
  archive("walls", box.walls);
  archive("world", box.world());
}

// Leaves what the stones are like before the shearing in the results.
void describe_specimen(const ShearBox& box, RunRecords& records);
} // namespace interlock::coupling
