// The true-triaxial test: stones between six rigid walls, four of which keep the cell pressure
// while the plate squeezes them. What is measured and why: docs/theory/triaxial.md.
//
// Frame: that of triaxial_walls.h.
#pragma once

#include "coupling/run/run_request.h"
#include "coupling/strength_test/specimen.h"
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
  using Stage = std::variant<FillStage, ConsolidateStage, CompressStage>;

  // Nothing but the parameters: for reading a state into.
  explicit Triaxial(const TriaxialParameters& p) : specimen(p.specimen), parameters_(p) {}

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
    return {specimen.fill_stage(), ConsolidateStage(), CompressStage()};
  }
  std::vector<std::string> history_columns() const;
  PhysicsLimits limits() const;
  void begin(RunRecords& records) const { specimen.log_preparation(records); }
  void finish(std::vector<Stage>& plan, RunRecords& records) const;

  World& world() { return specimen.world(); }
  const World& world() const { return specimen.world(); }

  // --- What the stages need to know -------------------------------------------------------------
  const TriaxialParameters& parameters() const { return parameters_; }
  dem::Vector3 size() const { return block_size(world().engine, walls); } // below the plate [m]
  dem::Vector3 stresses() const { return wall_stresses(world().engine, walls); } // [Pa]
  double porosity() const { return specimen.porosity(size().prod()); }

  Specimen specimen;
  TriaxialWalls walls;

private:
  TriaxialParameters parameters_;
};

template <class Archive> void exchange(Archive& archive, Triaxial& test)
{
  exchange(archive, test.specimen);
  archive("walls", test.walls);
}

// Leaves what the stones are like before the compression in the results.
void describe_specimen(const Triaxial& test, RunRecords& records);

// What a run that has been prepared will take.
Forecast forecast(const Triaxial& test);
} // namespace interlock::coupling
