// Units of stone files: length_of_unit and check_stone_size of stone_file.h.
#include "dem/scans/input_file.h"
#include "dem/scans/stone_file.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
struct Unit {
  const char* name;
  const char* plural;
  double length; // [m]
};
constexpr Unit units[] = {{"m", "metres", 1},
                          {"cm", "centimetres", 0.01},
                          {"mm", "millimetres", 0.001},
                          {"inch", "inches", 0.0254}};
constexpr double usual_stone = 0.05; // ballast [m]

bool is_stone(double extent)
{
  return extent >= smallest_stone && extent <= largest_stone;
}

std::string plural(double length_unit)
{
  for (const Unit& unit : units)
    if (std::abs(unit.length / length_unit - 1) < 1e-9) return unit.plural;
  return "this unit";
}
} // namespace

double length_of_unit(const std::string& name)
{
  for (const Unit& unit : units)
    if (name == unit.name) return unit.length;
  throw InputError("The length unit of the stone is " + quoted(name) +
                   ", but must be 'm', 'cm', 'mm' or 'inch'.");
}

void check_length_unit(const InputFile& file, double length_unit)
{
  if (!(length_unit > 0) || !std::isfinite(length_unit))
    file.refuse("was given a file unit of ", length_unit, " m, but it must be above 0.");
}

void check_stone_size(const InputFile& file, double extent, double length_unit)
{
  if (is_stone(extent)) return;
  std::vector<Unit> fitting;
  for (const Unit& unit : units)
    if (is_stone(extent / length_unit * unit.length)) fitting.push_back(unit);
  const auto oddity = [&](const Unit& unit) {
    return std::abs(std::log(extent / length_unit * unit.length / usual_stone));
  };
  std::sort(fitting.begin(), fitting.end(),
            [&](const Unit& a, const Unit& b) { return oddity(a) < oddity(b); });
  std::ostringstream hint;
  for (const Unit& unit : fitting)
    hint << (hint.tellp() > 0 ? " or " : " (it looks like ") << unit.plural << " read as "
         << plural(length_unit) << ": " << extent / length_unit * unit.length << " m";
  if (hint.tellp() > 0) hint << ")";
  file.refuse("is ", extent, " m long with a file unit of ", length_unit, " m, but stones measure ",
              smallest_stone, " m to ", largest_stone, " m: check the length unit", hint.str(),
              ".");
}
} // namespace interlock::dem
