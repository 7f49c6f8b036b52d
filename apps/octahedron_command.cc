#include "apps/octahedron_command.h"

#include "dem/generator/octahedron_tables.h"
#include "dem/input_error.h"

#include <cmath>
#include <cstdio>

namespace interlock::apps
{
void print_published_table(const std::string& name)
{
  if (name != "octahedron")
    throw InputError("There is no published table '" + name + "'; the known one is 'octahedron'.");
  std::printf("Spheres in a regular octahedron of %.0f mm edge, %zu nodes (size and mesh are not "
              "published), mean of 6 seeds\n",
              1e3 * dem::octahedron_edge, dem::irregular_octahedron(1).vertices.size());
  double largest = 0;
  for (const dem::OctahedronTable& table : dem::published_octahedron_tables()) {
    std::printf("\n%s\n%10s %10s %9s %11s %11s %11s %12s\n", table.title, "d_min [mm]",
                "r_min [mm]", "p_max [%]", "published", "ours", "off by [%]", "N d_min [mm]");
    for (const dem::OctahedronCell& cell : table.cells) {
      const double count = dem::mean_sphere_count(cell);
      const double error = 100 * (count / cell.published - 1);
      largest = std::max(largest, std::abs(error));
      std::printf("%10.1f %10.0f %9.0f %11d %11.1f %+11.1f", cell.d_min, cell.r_min, cell.p_max,
                  cell.published, count, error);
      if (cell.d_min > 0 && cell.p_max == 100 && cell.r_min == 2)
        std::printf(" %12.1f", cell.d_min * count);
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("\nLargest difference: %.1f %%\n", largest);
}
} // namespace interlock::apps
