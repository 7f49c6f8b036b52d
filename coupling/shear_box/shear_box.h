// The shear box experiment: stones in a box of two halves, pressed by a plate that keeps its force;
// the lower half moves. What is measured and why: docs/theory/ballast_laboratory.md.
//
// Frame: that of shear_box_walls.h.
#pragma once

#include "coupling/run/run_request.h"
#include "coupling/shear_box/shear_box_parameters.h"
#include "coupling/shear_box/shear_box_stages.h"
#include "coupling/shear_box/shear_box_walls.h"
#include "coupling/strength_test/specimen.h"

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
  explicit ShearBox(const ShearBoxParameters& p) : specimen(p.specimen), parameters_(p) {}

  // Makes the stones and the empty box. Throws InputError, one full sentence, when a stone or the
  // time step cannot be used.
  void prepare(const Monitor& monitor, const std::vector<CaseEntry>&)
  {
    set_up(specimen.make_stones(monitor));
  }
  // The same with these stones, which need not fit into the box in any attitude.
  void set_up(const std::vector<Stone>& stones);

  std::vector<Stage> plan() const
  {
    return {specimen.fill_stage(), ConsolidateStage(), ShearStage()};
  }
  std::vector<std::string> history_columns() const;
  PhysicsLimits limits() const;
  void begin(RunRecords& records) const { specimen.log_preparation(records); }
  void finish(std::vector<Stage>& plan, RunRecords& records) const;

  World& world() { return specimen.world(); }
  const World& world() const { return specimen.world(); }

  // --- What the stages need to know -------------------------------------------------------------
  const ShearBoxParameters& parameters() const { return parameters_; }
  double area() const;               // of the plane [m2]
  double weight_above_plane() const; // of stones with their centre there [N]
  dem::ContactProperties stone_on_floor_and_plate() const;
  // With which the plate has to press for a normal stress [Pa] on the plane. Throws RunFailure when
  // the stones above the plane weigh more [N].
  double plate_force(double normal_stress) const;
  double plate_height() const { return world().engine.wall(walls.plate).corner.z(); } // [m]
  double volume() const { return area() * plate_height(); } // below the plate [m3]
  double porosity() const { return specimen.porosity(volume()); }

  Specimen specimen;
  ShearBoxWalls walls;

private:
  ShearBoxParameters parameters_;
};

template <class Archive> void exchange(Archive& archive, ShearBox& box)
{
  exchange(archive, box.specimen);
  archive("walls", box.walls);
}

// Leaves what the stones are like before the shearing in the results.
void describe_specimen(const ShearBox& box, RunRecords& records);

// What a run that has been prepared will take.
Forecast forecast(const ShearBox& box);
} // namespace interlock::coupling
