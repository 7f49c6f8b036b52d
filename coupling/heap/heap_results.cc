// Records, files and results of the heap experiment.
#include "coupling/heap/heap.h"
#include "coupling/loop/state_hash.h"
#include "coupling/files/atomic_file.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// Rays of the height map; rings of the profile are half a mean stone wide [m].
constexpr double ray_spacing = 2e-3;

std::string number(double value)
{
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}
} // namespace

// Where the stone is, whatever its clump's centre of mass.
Vector3 Heap::stone_centre(int i) const
{
  const dem::Clumps& clumps = engine_->clumps();
  return clumps.position[i] + clumps.orientation[i] * stones_[clumps.shape[i]].centre;
}

bool Heap::elongated(int i) const
{
  return stones_[engine_->clumps().shape[i]].elongation < parameters_.measures.elongation_limit;
}

std::vector<HeapStone> Heap::stones() const
{
  std::vector<HeapStone> result;
  for (int i = 0; i < engine_->clumps().size(); ++i)
    result.push_back({stone_centre(i), engine_->clumps().mass[i], elongated(i)});
  return result;
}

std::vector<dem::Sphere> Heap::spheres(bool touching_only) const
{
  const dem::Clumps& clumps = engine_->clumps();
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
void Heap::record()
{
  ledger_ = ledger_of(engine_->energy(dt_));
  double height = 0;
  for (const dem::Sphere& sphere : spheres(true))
    height = std::max(height, sphere.centre.z() + sphere.radius);
  const dem::StableStep live = engine_->stable_step();
  if (live.step > 0) smallest_stable_step_ = std::min(smallest_stable_step_, live.step);

  std::vector<History::Cell> row = {time_,
                                    summary_.stages.back().name,
                                    double(engine_->clumps().size()),
                                    ledger_.kinetic_stones,
                                    height,
                                    plan_spread(stones()).radius_of_gyration,
                                    double(engine_->n_touching_spheres()),
                                    engine_->largest_overlap()};
  for (const auto& entry : ledger_.entries()) row.push_back(entry.second);
  row.push_back(ledger_.relative_error());
  history_->add(row);
}

void Heap::write_stones(const std::filesystem::path& file) const
{
  std::ostringstream out;
  out << "clump [-],shape,mass [kg],x [m],y [m],z [m],elongation [-],longest [m],elongated [-]\n";
  const dem::Clumps& clumps = engine_->clumps();
  for (int i = 0; i < clumps.size(); ++i) {
    const Stone& stone = stones_[clumps.shape[i]];
    const Vector3 x = stone_centre(i);
    out << clumps.id[i] << ',' << stone.shape.name << ',' << number(clumps.mass[i]) << ','
        << number(x.x()) << ',' << number(x.y()) << ',' << number(x.z()) << ','
        << number(stone.elongation) << ',' << number(stone.longest) << ',' << elongated(i) << '\n';
  }
  write_atomically(file, out.str());
}

// Heights over the distance from the centroid: what the angle of repose was fitted to.
void Heap::write_profile(const std::filesystem::path& file, const SurfaceProfile& profile) const
{
  std::ostringstream out;
  out << "sector,radius [m],height [m]\n";
  const auto add = [&](const std::string& name, const std::vector<SurfaceProfile::Ring>& rings) {
    for (const SurfaceProfile::Ring& ring : rings)
      out << name << ',' << number(ring.radius) << ',' << number(ring.height) << '\n';
  };
  for (int s = 0; s < SurfaceProfile::n_sectors; ++s) add(std::to_string(s), profile.sector[s]);
  add("all", profile.all);
  write_atomically(file, out.str());
}

void Heap::collect_measures(const std::filesystem::path& output)
{
  const std::vector<HeapStone> stones = this->stones();
  const PlanSpread spread = plan_spread(stones);
  double reach = 0;
  for (const HeapStone& stone : stones)
    reach = std::max(reach, (stone.centre.head<2>() - spread.centroid).norm());
  // The heap's foot is near 2 r50; strays far outside need no rays.
  reach = std::min(reach, 4 * spread.r50) + mean_size_;
  const HeightMap map = height_map(spheres(false), spread.centroid, reach, ray_spacing);
  const SurfaceProfile profile = surface_profile(map, spread.centroid, 0.5 * mean_size_);
  const Repose heap = repose(profile);
  write_profile(output / "profile.csv", profile);

  nlohmann::ordered_json& r = summary_.results;
  r["angle_of_repose_deg"] = heap.angle;
  r["angle_of_repose_scatter_over_azimuths_deg"] = heap.scatter;
  r["azimuths_with_an_angle"] = heap.sectors;
  r["height_m"] = heap.height;
  r["highest_point_m"] = *std::max_element(map.height.begin(), map.height.end());
  r["radius_of_gyration_m"] = spread.radius_of_gyration;
  r["radius_of_gyration_of_elongated_stones_m"] = spread.elongated_radius_of_gyration;
  r["radius_of_gyration_of_other_stones_m"] = spread.other_radius_of_gyration;
  r["r50_m"] = spread.r50;
  r["mass_share_beyond_1.5_r50"] = spread.mass_beyond;
  r["radius_m"] = parameters_.measures.radius;
  r["mass_share_outside_radius"] =
      mass_outside(stones, spread.centroid, parameters_.measures.radius);
  r["elongated_stones"] = spread.elongated;
  r["elongated_stones_beyond_1.5_r50"] = spread.elongated_beyond;
  r["other_stones"] = spread.others;
  r["other_stones_beyond_1.5_r50"] = spread.others_beyond;
  r["centroid_x_m"] = spread.centroid.x();
  r["centroid_y_m"] = spread.centroid.y();
}

void Heap::collect_results(const std::filesystem::path& output)
{
  const dem::Clumps& clumps = engine_->clumps();
  Summary& s = summary_;
  s.experiment = "heap";
  s.seed = parameters_.drop.seed;
  s.clumps = clumps.size();
  s.spheres = clumps.n_spheres();
  s.time_step = dt_;
  s.steps = steps_;
  s.simulated_time = time_;
  s.wall_time = std::chrono::duration<double>(Clock::now() - run_start_).count();
  s.contacts = engine_->n_touching_spheres();
  s.state_hash = state_hash(clumps, nullptr);
  add_ledger(s, ledger_);

  s.results["mass_properties"] = parameters_.stones.mass_properties;
  s.results["mass_kg"] = weight() / parameters_.gravity;
  if (clumps.size() > 0) collect_measures(output);
  s.results["time_to_rest_after_last_release_s"] = at_rest_time_;
  s.results["longest_delay_of_a_release_s"] = longest_delay_;
  s.results["stones_lost_over_the_edge"] = n_lost_;
  s.results["largest_overlap_m"] = largest_overlap_;
  s.results["largest_overlap_over_mean_sphere_radius"] = largest_overlap_ / mean_sphere_radius_;
  s.results["smallest_stable_step_s"] = smallest_stable_step_;

  if (longest_delay_ > 0)
    warn("A stone was let go " + number(longest_delay_) +
         " s later than planned: another one was in its place, so this drop is not that of other "
         "runs with the same seed.");
  if (n_lost_ > 0)
    warn(std::to_string(n_lost_) + " stones rolled off the floor; make Drop/Floor side larger.");
  if (dt_ > smallest_stable_step_)
    warn("The time step of " + number(dt_) + " s was above the live stable step of " +
         number(smallest_stable_step_) + " s.");
  if (ledger_.relative_error() > ledger_bound)
    warn("The energy ledger leaves its bound: error " + number(ledger_.relative_error()) +
         " of the work put in, bound " + number(ledger_bound) + ".");
  s.ledger_closes = ledger_.relative_error() <= ledger_failure;
}
} // namespace interlock::coupling
