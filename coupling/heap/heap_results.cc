// Records, files and results of the heap experiment.
#include "coupling/files/atomic_file.h"
#include "coupling/heap/heap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// Rays of the height map; rings of the profile are half a mean stone wide [m].
constexpr double ray_spacing = 2e-3;

// Where the stone is, whatever its clump's centre of mass.
Vector3 stone_centre(const Heap& heap, int i)
{
  const dem::Clumps& clumps = heap.world().engine.clumps();
  return clumps.position[i] + clumps.orientation[i] * heap.stones[clumps.shape[i]].centre;
}

bool elongated(const Heap& heap, int i)
{
  return heap.stones[heap.world().engine.clumps().shape[i]].elongation <
         heap.parameters().measures.elongation_limit;
}

std::vector<HeapStone> stones_of(const Heap& heap)
{
  const dem::Clumps& clumps = heap.world().engine.clumps();
  std::vector<HeapStone> result;
  for (int i = 0; i < clumps.size(); ++i)
    result.push_back({stone_centre(heap, i), clumps.mass[i], elongated(heap, i)});
  return result;
}

std::vector<dem::Sphere> spheres_of(const Heap& heap, bool touching_only) // in the world
{
  const dem::Clumps& clumps = heap.world().engine.clumps();
  std::vector<dem::Sphere> result;
  for (int i = 0; i < clumps.size(); ++i) {
    if (touching_only && Vector3(clumps.force[i]) == Vector3::Zero()) continue;
    const std::vector<dem::Sphere>& members = clumps.shape_of(i).spheres;
    for (std::size_t a = 0; a < members.size(); ++a)
      result.push_back(
          {clumps.position[i] + clumps.member_offset(i, static_cast<int>(a)), members[a].radius});
  }
  return result;
}

// Height: of the highest point of a stone that touches something, not of one in the air.
void record(Heap& heap, RunRecords& records)
{
  const World& world = heap.world();
  heap.ledger = world.ledger();
  double height = 0;
  for (const dem::Sphere& sphere : spheres_of(heap, true))
    height = std::max(height, sphere.centre.z() + sphere.radius);
  const dem::StableStep live = world.stable_step();
  if (live.step > 0) heap.smallest_stable_step = std::min(heap.smallest_stable_step, live.step);

  std::vector<History::Cell> row = {world.clock.time(),
                                    records.stage_name(),
                                    double(world.engine.clumps().size()),
                                    heap.ledger.kinetic_stones,
                                    height,
                                    plan_spread(stones_of(heap)).radius_of_gyration,
                                    double(world.engine.n_touching_spheres()),
                                    world.engine.largest_overlap()};
  append_ledger(row, heap.ledger);
  records.add(row);
}

void write_stones(const Heap& heap, const std::filesystem::path& file)
{
  std::string out =
      "clump [-],shape,mass [kg],x [m],y [m],z [m],elongation [-],longest [m],elongated [-]\n";
  const dem::Clumps& clumps = heap.world().engine.clumps();
  for (int i = 0; i < clumps.size(); ++i) {
    const Stone& stone = heap.stones[clumps.shape[i]];
    const Vector3 x = stone_centre(heap, i);
    out += fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n", clumps.id[i],
                       stone.shape.name, clumps.mass[i], x.x(), x.y(), x.z(), stone.elongation,
                       stone.longest, int(elongated(heap, i)));
  }
  write_atomically(file, out);
}

// Heights over the distance from the centroid: what the angle of repose was fitted to.
void write_profile(const std::filesystem::path& file, const SurfaceProfile& profile)
{
  std::string out = "sector,radius [m],height [m]\n";
  const auto add = [&](const std::string& sector, const std::vector<SurfaceProfile::Ring>& rings) {
    for (const SurfaceProfile::Ring& ring : rings)
      out += fmt::format("{},{:.6g},{:.6g}\n", sector, ring.radius, ring.height);
  };
  for (int s = 0; s < SurfaceProfile::n_sectors; ++s) add(std::to_string(s), profile.sector[s]);
  add("all", profile.all);
  write_atomically(file, out);
}

void measure_heap(const Heap& heap, RunRecords& records)
{
  const std::vector<HeapStone> stones = stones_of(heap);
  const PlanSpread spread = plan_spread(stones);
  double reach = 0;
  for (const HeapStone& stone : stones)
    reach = std::max(reach, (stone.centre.head<2>() - spread.centroid).norm());
  // The heap's foot is near 2 r50; strays far outside need no rays.
  reach = std::min(reach, 4 * spread.r50) + heap.mean_size;
  const HeightMap map = height_map(spheres_of(heap, false), spread.centroid, reach, ray_spacing);
  const SurfaceProfile profile = surface_profile(map, spread.centroid, 0.5 * heap.mean_size);
  const Repose slope = repose(profile);
  if (records.writes()) write_profile(records.folder() / "profile.csv", profile);

  nlohmann::ordered_json& r = records.summary.results;
  r["angle_of_repose_deg"] = slope.angle;
  r["angle_of_repose_scatter_over_azimuths_deg"] = slope.scatter;
  r["azimuths_with_an_angle"] = slope.sectors;
  r["height_m"] = slope.height;
  r["highest_point_m"] = *std::max_element(map.height.begin(), map.height.end());
  r["radius_of_gyration_m"] = spread.radius_of_gyration;
  r["radius_of_gyration_of_elongated_stones_m"] = spread.elongated_radius_of_gyration;
  r["radius_of_gyration_of_other_stones_m"] = spread.other_radius_of_gyration;
  r["r50_m"] = spread.r50;
  r["mass_share_beyond_1.5_r50"] = spread.mass_beyond;
  r["radius_m"] = heap.parameters().measures.radius;
  r["mass_share_outside_radius"] =
      mass_outside(stones, spread.centroid, heap.parameters().measures.radius);
  r["elongated_stones"] = spread.elongated;
  r["elongated_stones_beyond_1.5_r50"] = spread.elongated_beyond;
  r["other_stones"] = spread.others;
  r["other_stones_beyond_1.5_r50"] = spread.others_beyond;
  r["centroid_x_m"] = spread.centroid.x();
  r["centroid_y_m"] = spread.centroid.y();
}
} // namespace

std::vector<std::string> Heap::history_columns() const
{
  std::vector<std::string> columns = {"time [s]",           "stage",
                                      "stones [-]",         "kinetic_energy [J]",
                                      "height [m]",         "radius_of_gyration [m]",
                                      "stone_contacts [-]", "largest_overlap [m]"};
  append_ledger_columns(columns);
  return columns;
}

void Heap::note_overlap()
{
  largest_overlap = std::max(largest_overlap, world_.engine.largest_overlap());
}

bool Heap::is_row_due() const
{
  return world_.clock.time() >= static_cast<double>(rows) * parameters_.output.record_interval;
}

bool Heap::is_frame_due() const
{
  const double interval = parameters_.output.frame_interval;
  return interval > 0 && world_.clock.time() >= static_cast<double>(frames) * interval;
}

void Heap::record_when_due(RunRecords& records, bool anyway)
{
  unite_notes();
  const bool frame = anyway || is_frame_due();
  if (anyway || is_row_due()) {
    record(*this, records);
    ++rows;
  }
  if (frame) {
    records.add_frame(world_);
    ++frames;
  }
}

void Heap::finish(std::vector<Stage>&, RunRecords& records) const
{
  Summary& s = records.summary;
  s.seed = parameters_.drop.seed;
  s.contacts = world_.engine.n_touching_spheres();
  add_ledger(s, ledger);
  if (records.writes()) write_stones(*this, records.folder() / "stones.csv");

  s.results["mass_properties"] = parameters_.stones.mass_properties;
  s.results["mass_kg"] = world_.weight() / parameters_.gravity;
  if (world_.engine.clumps().size() > 0) measure_heap(*this, records);
  s.results["time_to_rest_after_last_release_s"] = at_rest_time;
  s.results["longest_delay_of_a_release_s"] = longest_delay;
  s.results["stones_lost_over_the_edge"] = lost;
  s.results["largest_overlap_m"] = largest_overlap;
  s.results["largest_overlap_over_mean_sphere_radius"] = largest_overlap / mean_sphere_radius;
  s.results["smallest_stable_step_s"] = smallest_stable_step;

  if (longest_delay > 0)
    records.warn(
        fmt::format("A stone was let go {:.6g} s later than planned: another one was in its "
                    "place, so this drop is not that of other runs with the same seed.",
                    longest_delay));
  if (lost > 0)
    records.warn(fmt::format("{} stones rolled off the floor; make Drop/Floor side larger.", lost));
  if (world_.clock.dt > smallest_stable_step)
    records.warn(
        fmt::format("The time step of {:.6g} s was above the live stable step of {:.6g} s.",
                    world_.clock.dt, smallest_stable_step));
  warn_of_ledger(ledger, records);
  s.ledger_closes = ledger.relative_error() <= ledger_failure;
}
} // namespace interlock::coupling
