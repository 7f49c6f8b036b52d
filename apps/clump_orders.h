// Both orders of the spheres beside each other: how good clumps of so many spheres are.
#pragma once

#include "apps/clump_table.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace interlock::apps
{
// Clumps of several stones, of at most so many spheres, in one order; means over the stones.
struct OrderRow {
  std::string order; // random | gain
  int asked = 0;     // number of spheres
  double spheres = 0, in_pieces = 0, volume_error = 0;
  double distance_mean = 0, distance_95 = 0, bulge = 0; // [m]
  double equal_mass_error = 0;                          // of the principal moments [-]
};

// Of `stones` stones; `make` gives the clump of one under some parameters. All are those of
// `parameters` but order, number of spheres and targets.
std::vector<OrderRow>
compare_orders(const std::vector<int>& numbers, const dem::ClumpParameters& parameters, int stones,
               const std::function<ClumpResult(int stone, const dem::ClumpParameters&)>& make);

void print_orders(const std::vector<OrderRow>& rows);

nlohmann::ordered_json orders_json(const std::vector<OrderRow>& rows);
} // namespace interlock::apps
