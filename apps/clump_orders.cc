#include "apps/clump_orders.h"

#include "apps/interruption.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace interlock::apps
{
namespace
{
void add_share(const ClumpResult& result, double share, OrderRow& row)
{
  const dem::ClumpReport& report = result.report;
  row.spheres += share * result.shape.spheres.size();
  row.in_pieces += share * (report.groups > 1);
  row.volume_error += share * report.volume_error;
  row.distance_mean += share * report.surface_distance_mean;
  row.distance_95 += share * report.surface_distance_95;
  row.bulge += share * report.bulge;
  row.equal_mass_error +=
      share * report.inertia_error[static_cast<std::size_t>(dem::MassScheme::equal_mass)];
}
} // namespace

std::vector<OrderRow>
compare_orders(const std::vector<int>& numbers, const dem::ClumpParameters& parameters, int stones,
               const std::function<ClumpResult(int, const dem::ClumpParameters&)>& make)
{
  std::vector<OrderRow> rows;
  for (const auto order : {dem::SphereOrder::random, dem::SphereOrder::gain})
    for (const int number : numbers) {
      dem::ClumpParameters changed = parameters;
      changed.sphere_order = order;
      changed.max_spheres = number;
      changed.target_volume_error = changed.target_inertia_error = 0;
      OrderRow row;
      row.order = order == dem::SphereOrder::gain ? "gain" : "random";
      row.asked = number;
      for (int stone = 0; stone < stones; ++stone) {
        throw_if_interrupted();
        add_share(make(stone, changed), 1. / stones, row);
      }
      rows.push_back(row);
    }
  return rows;
}

void print_orders(const std::vector<OrderRow>& rows)
{
  std::printf("Both orders, means over the stones:\n%-8s %8s %10s %14s %13s %10s %8s %14s\n",
              "order", "spheres", "in pieces", "union volume", "surface off", "95 %", "bulge",
              "moments off");
  std::printf("%-8s %8s %10s %14s %13s %10s %8s %14s\n", "", "", "[%]", "off by [%]", "mean [mm]",
              "[mm]", "[mm]", "eq.-mass [%]");
  for (const OrderRow& row : rows)
    std::printf("%-8s %8.1f %10.0f %+14.2f %13.3f %10.3f %8.3f %14.1f\n", row.order.c_str(),
                row.spheres, 100 * row.in_pieces, 100 * row.volume_error, 1e3 * row.distance_mean,
                1e3 * row.distance_95, 1e3 * row.bulge, 100 * row.equal_mass_error);
}

nlohmann::ordered_json orders_json(const std::vector<OrderRow>& rows)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OrderRow& row : rows)
    list.push_back({{"order", row.order},
                    {"max_spheres", row.asked},
                    {"spheres", row.spheres},
                    {"share_in_pieces", row.in_pieces},
                    {"volume_error", row.volume_error},
                    {"surface_distance_mean_m", row.distance_mean},
                    {"surface_distance_95_m", row.distance_95},
                    {"bulge_m", row.bulge},
                    {"equal_mass_inertia_error", row.equal_mass_error}});
  return list;
}
} // namespace interlock::apps
