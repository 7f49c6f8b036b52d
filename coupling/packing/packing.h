// The packing experiment: a packed state from a file, run and timed. It shows what a step costs,
// and checks forces, lists and energies of a known packing on the way.
//
// Frame: the box of the file, x and y along its sides from 0, z up from its floor; open at the top.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/packing/packed_state.h"
#include "coupling/packing/packing_parameters.h"
#include "coupling/packing/packing_stages.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"

#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
class Packing
{
public:
  static constexpr const char* name = "packing";
  using Stage = std::variant<WarmUpStage, TimedStage>;

  // Nothing but the parameters: for reading a state into.
  explicit Packing(const PackingParameters& parameters);

  // Reads and prepares the state (small spheres, squeeze, throws), and writes it where the
  // parameters say so. Throws InputError, one full sentence, when the state or the time step cannot
  // be used.
  void prepare(const Monitor& monitor, const std::vector<CaseEntry>& entries);

  std::vector<Stage> plan() const;
  std::vector<std::string> history_columns() const;
  PhysicsLimits limits() const { return {}; }
  void begin(RunRecords& records) const; // logs the preparation
  void finish(std::vector<Stage>& plan, RunRecords& records) const;

  World& world() { return world_; }
  const World& world() const { return world_; }
  const PackingParameters& parameters() const { return parameters_; }

private:
  void build(const PackedState& state);
  void throw_stones(const PackedState& state);

  PackingParameters parameters_;
  World world_;
  std::string preparation_;     // what it made, for the log
  double preparation_time_ = 0; // wall-clock [s]
};

template <class Archive> void exchange(Archive& archive, Packing& packing)
{
  archive("world", packing.world());
}
} // namespace interlock::coupling
