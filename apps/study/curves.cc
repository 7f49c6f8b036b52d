// Force over displacement of all runs of a study on one grid of displacements.
#include "apps/study/study_results.h"
#include "coupling/files/hdf5_memory.h"
#include "coupling/stones/curve_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlock::apps
{
namespace
{
using Numbers = std::vector<double>;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int n_places = 401;

struct Curve {
  Numbers place, force;
};

// Of a pull-out and of a shear box; the centred mean.
Curve read_curve(const Plan& plan, const RunRow& row)
{
  const auto history = read_history(plan.folder / plan.tasks[row.task].folder);
  const auto place = history.find("displacement");
  for (const char* name : {"pull_force", "shear_force"}) {
    const auto force = history.find(name);
    if (place == history.end() || force == history.end() || place->second.size() < 3) continue;
    return {place->second,
            coupling::centred_mean(place->second, force->second, plan.study.measures.mean_over)};
  }
  return {};
}

Numbers on_grid(const Curve& curve, const Numbers& grid)
{
  Numbers values;
  for (const double at : grid) {
    if (curve.place.empty() || at > curve.place.back() || at < curve.place.front()) {
      values.push_back(unknown);
      continue;
    }
    const auto above = std::lower_bound(curve.place.begin(), curve.place.end(), at);
    const std::size_t k = above - curve.place.begin();
    const double share =
        k == 0 ? 0 : (at - curve.place[k - 1]) / (curve.place[k] - curve.place[k - 1]);
    values.push_back(k == 0 ? curve.force[0]
                            : curve.force[k - 1] + share * (curve.force[k] - curve.force[k - 1]));
  }
  return values;
}

// Means over the fillings of each point, place by place.
void write_means(const RunTable& table, const Numbers& grid, const std::vector<Numbers>& forces,
                 coupling::Hdf5Memory& file)
{
  const Plan& plan = *table.plan;
  std::vector<std::string> names;
  Numbers n, mean, deviation, half_width;
  for (int p = 0; p < static_cast<int>(plan.points.size()); ++p) {
    names.push_back(point_name(plan, p));
    for (std::size_t k = 0; k < grid.size(); ++k) {
      Numbers values;
      for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const RunRow& row = table.rows[r];
        if (plan.tasks[row.task].point == p && row.status != "failed" &&
            grid[k] < row.not_usable_from && std::isfinite(forces[r][k]))
          values.push_back(forces[r][k]);
      }
      const SampleMean sample = sample_mean(values, plan.study.confidence);
      n.push_back(sample.n);
      mean.push_back(sample.mean);
      deviation.push_back(sample.deviation);
      half_width.push_back(sample.half_width);
    }
  }
  file.write("points", names, 1, "");
  file.write("n", n, n_places, "");
  file.write("mean", mean, n_places, "N");
  file.write("deviation", deviation, n_places, "N");
  file.write("half_width", half_width, n_places, "N");
}
} // namespace

std::string curves_h5(const RunTable& table)
{
  std::vector<Curve> curves;
  double longest = 0;
  for (const RunRow& row : table.rows) {
    curves.push_back(read_curve(*table.plan, row));
    if (!curves.back().place.empty()) longest = std::max(longest, curves.back().place.back());
  }
  if (!(longest > 0)) return {};
  Numbers grid;
  for (int k = 0; k < n_places; ++k) grid.push_back(longest * k / (n_places - 1));
  std::vector<std::string> names;
  std::vector<Numbers> forces;
  Numbers all, points, usable_to;
  for (std::size_t r = 0; r < curves.size(); ++r) {
    const Task& task = table.plan->tasks[table.rows[r].task];
    names.push_back(task.name);
    points.push_back(task.point);
    usable_to.push_back(table.rows[r].not_usable_from);
    forces.push_back(on_grid(curves[r], grid));
    all.insert(all.end(), forces.back().begin(), forces.back().end());
  }
  coupling::Hdf5Memory file;
  file.write("displacement", grid, 1, "m");
  file.write("runs", names, 1, "");
  file.write("point_of_run", points, 1, "");
  file.write("not_usable_from", usable_to, 1, "m");
  file.write("force", all, n_places, "N");
  write_means(table, grid, forces, file);
  return file.bytes();
}
} // namespace interlock::apps
