// The three time series of a run for ParaView: clumps, geogrid, contacts.
#pragma once

#include "coupling/field_output.h"
#include "coupling/staggered_step.h"
#include "dem/engine.h"

#include <filesystem>

namespace interlock::coupling
{
// clumps: a point for each member sphere with `radius` [m], `clump` (its id) [-], `velocity` [m/s]
// and `displacement` [m] of the clump since the first frame. geogrid: lines between nodes with
// displacement, velocity and section forces. contacts: lines from a clump's centre to its partner's
// centre, or to the contact point on a wall or rib, with `force` (size) [N] and `kind` (0 stones, 1
// wall, 2 rib) [-].
class FieldFrames
{
public:
  explicit FieldFrames(const std::filesystem::path& folder);

  void write(double time, const dem::Engine& engine, const StaggeredStep& loop);

private:
  void write_clumps(double time, const dem::Engine& engine);
  void write_geogrid(double time, const Geogrid& geogrid);
  void write_contacts(double time, const dem::Engine& engine, const StaggeredStep& loop);

  XdmfSeries clumps_, geogrid_, contacts_;
  std::vector<std::int64_t> first_id_; // ids at the first frame, ascending
  dem::VectorField first_position_;
};
} // namespace interlock::coupling
