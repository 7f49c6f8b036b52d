// The pull-out experiment: fill the lower half of the box, place the geogrid, fill the upper half,
// load it, let it settle, pull (Ferellec and McDowell 2010, section 4).
//
// Frame: x along the pull, the front wall with its slot at x = 0 and the pull towards -x; y across;
// z up from the floor of the box.
#pragma once

#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"
#include "coupling/loop/world.h"
#include "coupling/pull_out/geogrid_sheet.h"
#include "coupling/pull_out/pull_out_parameters.h"
#include "coupling/pull_out/pull_out_stages.h"
#include "coupling/pull_out/start_from.h"
#include "coupling/stones/box_walls.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/pouring.h"
#include "coupling/stones/settling.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
class PullOut
{
public:
  static constexpr const char* name = "pull-out";
  using Stage = std::variant<FillStage, FlattenStage, PlaceStage, LoadStage, AdaptStage,
                             SettleStage, PullStage>;

  // Nothing but the parameters, and the sheet that they describe: for reading a state into. Throws
  // InputError when there is no such sheet.
  explicit PullOut(const PullOutParameters& parameters);

  // Makes the stones and the empty box, and checks what only they can tell (the stable step); or
  // begins where another run left off (start_from.h), for which it needs the entries of the case.
  // Throws InputError, one full sentence, when a stone, the time step or the state cannot be used.
  void prepare(const Monitor& monitor, const std::vector<CaseEntry>& entries);

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
  const PullOutParameters& parameters() const { return parameters_; }
  const dem::ContactProperties& stone_on_stone() const { return stone_on_stone_; }
  const dem::ContactProperties& stone_on_box() const { return stone_on_box_; }
  const dem::ContactProperties& stone_on_rib() const { return stone_on_rib_; }
  // Between stones while the box is filled (Filling/Stone friction).
  dem::ContactProperties filling_contact() const;
  // The box is full: stones have the friction of the test from now on.
  void end_filling() { world_.engine.stone_contact() = stone_on_stone_; }
  double geogrid_height() const { return 0.5 * parameters_.box.height; } // of its middle plane [m]
  const GeogridSheet& sheet() const { return sheet_; }
  std::unique_ptr<RibTransfer> make_geogrid() const; // unloaded, where it is placed
  Pouring pouring() const;
  Filling filling();
  SettlingParameters settling() const;
  // Gives a state that was made with other entries those of this case (start_from.h).
  void adapt();
  // Between the second transverse rib and the front wall before the pull; infinite if there is but
  // one [m].
  double room_at_wall() const { return sheet_.room_behind - parameters_.geogrid.overhang; }
  // Of the clamp, from which on stones may be squeezed there (protocol.h) [m].
  double displacement_of_rib_at_wall() const;
  // Takes out what fell through the slot: it would fall for ever.
  void drop_lost_stones();
  // Whether a stage may settle no longer: true when the stones lie still, and, with a warning, when
  // the time limit has passed.
  bool has_settled(const Settling& settling, RunRecords& records) const;

  double mean_size = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // [m]
  int n_shapes = 0;              // of stones; the shape of the surcharge comes after them
  BoxWalls walls;
  dem::WallId surcharge_plate = -1; // -1: none
  std::int64_t first_above = 0;     // id of the first stone that was poured on the geogrid
  int lost = 0;                     // stones that fell out of the slot

private:
  void start_from(const std::filesystem::path& file, const std::vector<CaseEntry>& entries);
  std::vector<Stage> plan_from_state() const;
  void append_lower_half(std::vector<Stage>& plan) const;
  void append_upper_half(std::vector<Stage>& plan) const;
  double mass_of_half(double bulk_density) const; // [kg]
  dem::StableStep expected_stable_step() const;   // of the stones, without a surcharge
  void choose_step(const dem::StableStep& stable);

  PullOutParameters parameters_;
  GeogridSheet sheet_;
  dem::ContactProperties stone_on_stone_, stone_on_box_, stone_on_rib_;
  World world_;
  std::string preparation_; // what it made, for the log
  std::vector<std::string> stone_warnings_;
  double preparation_time_ = 0;     // wall-clock [s]
  std::optional<StartState> start_; // empty: an empty box
};

template <class Archive> void exchange(Archive& archive, PullOut& experiment)
{
  archive("mean_stone_size", experiment.mean_size, "m");
  archive("mean_sphere_radius", experiment.mean_sphere_radius, "m");
  archive("stone_shapes", experiment.n_shapes);
  archive("walls", experiment.walls);
  archive("surcharge_plate", experiment.surcharge_plate);
  archive("first_stone_above_geogrid", experiment.first_above);
  archive("lost_stones", experiment.lost);
  bool placed = experiment.world().geogrid() != nullptr;
  archive("geogrid_is_placed", placed);
  if (Archive::reading && placed) experiment.world().attach_geogrid(experiment.make_geogrid());
  archive("world", experiment.world());
}

// Leaves what the stones are like before the pull in the results.
void describe_packing(const PullOut& experiment, RunRecords& records);
} // namespace interlock::coupling
