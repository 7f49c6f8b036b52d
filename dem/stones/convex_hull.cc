#include "dem/stones/convex_hull.h"

#include "dem/input_error.h"

#include <cstdio>
#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace interlock::dem
{
double convex_hull_volume(const std::vector<Vector3>& points)
{
  static_assert(sizeof(Vector3) == 3 * sizeof(coordT), "Qhull reads the points in place");
  if (points.size() < 4) throw InputError("The convex hull of fewer than 4 points has no volume.");
  qhT state;
  qh_zero(&state, nullptr);
  // Qhull tells its troubles to a file; what it has to say beyond its exit code helps nobody here.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> silent(std::fopen("/dev/null", "w"),
                                                               &std::fclose);
  std::vector<Vector3> copy = points; // Qhull may scale its input
  char command[] = "qhull FA Pp";     // total volume; no warning about narrow hulls
  const int failed = qh_new_qhull(&state, 3, int(copy.size()), copy.front().data(), False, command,
                                  silent.get(), silent.get());
  const double volume = state.totvol;
  qh_freeqhull(&state, !qh_ALL);
  int used = 0, total = 0;
  qh_memfreeshort(&state, &used, &total);
  if (failed)
    throw InputError("The points of the surface span no volume, so it has no convex hull.");
  return volume;
}
} // namespace interlock::dem
