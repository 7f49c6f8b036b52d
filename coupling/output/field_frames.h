// The three time series of a run for ParaView: clumps, geogrid, contacts.
#pragma once

#include "coupling/loop/staggered_step.h"
#include "coupling/output/field_output.h"
#include "dem/engine/engine.h"

#include <filesystem>

namespace interlock::coupling
{
// `displacement` [m] is that since the first frame, which a pull-out writes at the start of the
// pull. clumps: a point for each member sphere with `radius` [m], `clump` (its id) [-], `velocity`
// [m/s] and `displacement` of the clump. geogrid: lines between nodes with `displacement`,
// `displacement_from_unloaded` (as it was laid) [m], `velocity` and section forces. contacts: lines
// from a clump's centre to its partner's centre, or to the contact point on a wall or rib, with
// `force` (size) [N] and `kind` (0 stones, 1 wall, 2 rib) [-]; at both ends of a line `body` (id of
// the clump, id of the wall, or number of the rib, a line of geogrid) [-] and `force_on_body`, a
// vector [N].
class FieldFrames
{
public:
  // Writes nothing yet.
  explicit FieldFrames(const std::filesystem::path& folder);
  // FieldSeries::start and rewind of all three.
  void start();
  void rewind();

  void write(double time, const dem::Engine& engine, const StaggeredStep& loop);
  // Of stones and walls alone: there is no geogrid.
  void write(double time, const dem::Engine& engine);

  template <class Archive> friend void exchange(Archive& archive, FieldFrames& frames)
  {
    archive("clumps", frames.clumps_);
    archive("geogrid", frames.geogrid_);
    archive("contacts", frames.contacts_);
    archive("first_id", frames.first_id_);
    archive("first_position", frames.first_position_, "m");
  }

private:
  void write_clumps(double time, const dem::Engine& engine);
  void write_geogrid(double time, const RibTransfer& geogrid);
  void write_contacts(double time, const dem::Engine& engine,
                      const std::vector<dem::RibContact>& rib_contacts);

  FieldSeries clumps_, geogrid_, contacts_;
  std::vector<std::int64_t> first_id_; // ids at the first frame, ascending
  dem::VectorField first_position_;
};
} // namespace interlock::coupling
