#include "coupling/parameters/usual_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
const std::vector<OtherUnit> lengths = {{"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}};
const std::vector<OtherUnit> densities = {{"g/cm3", 1e3}};
const std::vector<OtherUnit> moduli = {{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}};
const std::vector<OtherUnit> stiffnesses = {{"MN/m", 1e6}, {"kN/m", 1e3}};
const std::vector<OtherUnit> pressures = {{"kPa", 1e3}, {"MPa", 1e6}};
const std::vector<OtherUnit> forces = {{"kN", 1e3}};
const std::vector<OtherUnit> speeds = {{"mm/s", 1e-3}, {"mm/min", 1e-3 / 60}};
const std::vector<OtherUnit> times = {{"ms", 1e-3}, {"us", 1e-6}};

struct Row {
  std::vector<std::string> keys;
  UsualRange range;
};

// The whole table. Wide enough for any ballast, gravel and geogrid, centrifuges included.
const std::vector<Row>& table()
{
  static const std::vector<Row> rows = {
      {{"Gravity", "Laboratory/Gravity"}, {0.1, 2000, {{"cm/s2", 1e-2}}}},
      // Rock is 2000 to 3500 kg/m3; slag, steel balls and porous stones are tried, too.
      {{"Stones/Density", "--density"}, {1000, 8000, densities}},
      {{"Stones/Length unit", "Mesh wall/Length unit", "Laboratory/Lattice length unit",
        "Geogrid/Lattice length unit"},
       {1e-7, 1, {}}},
      // Spheres of a clump: the finest mesh of a scan, the largest stone.
      {{"Stones/D min", "Stones/R min", "--d-min", "--r-min", "--bulge", "Stones/Bulge"},
       {1e-6, 0.05, lengths}},
      {{"Box/Length", "Box/Width", "Box/Height", "Drop/Floor side", "Geogrid/Cut width"},
       {0.02, 10, lengths}},
      {{"Box/Slot height", "Box/Gap"}, {5e-4, 0.5, lengths}},
      // Of a contact: 1e5 is foam, 1e11 a steel block.
      {{"Contact/Stone stiffness", "Contact/Box stiffness", "Contact/Geogrid stiffness",
        "Contact/Normal stiffness"},
       {1e4, 1e12, stiffnesses}},
      {{"Contact/Youngs modulus"}, {1e6, 1e12, moduli}},
      // Soft rock at a sharp corner to the hardness of quartz.
      {{"Contact/Crushing pressure"}, {1e6, 1.5e10, moduli}},
      // Rubber to steel.
      {{"Geogrid/Youngs modulus", "Product/Youngs modulus along", "Product/Youngs modulus across"},
       {1e6, 1e12, moduli}},
      {{"Geogrid/Density", "Product/Density"}, {100, 20000, densities}},
      {{"Product/Stiffness at 2 % along", "Product/Stiffness at 2 % across",
        "Product/Stiffness at 5 % along", "Product/Stiffness at 5 % across"},
       {1e3, 1e8, {{"kN/m", 1e3}, {"MN/m", 1e6}}}},
      {{"Product/Strength along", "Product/Strength across"}, {100, 1e7, {{"kN/m", 1e3}}}},
      // As data sheets state them: these entries are not in SI.
      {{"Data sheet/Force at 2 % along", "Data sheet/Force at 2 % across",
        "Data sheet/Force at 5 % along", "Data sheet/Force at 5 % across"},
       {0.1, 1000, {{"N/m", 1e-3}}}},
      {{"Data sheet/Aperture stability"}, {0.01, 100, {{"kg cm/deg", 0.0980665}}}},
      {{"Data sheet/Flexural rigidity"}, {1e3, 1e8, {{"g cm", 1e3}}}},
      {{"Data sheet/Mass per area"}, {0.01, 20, {{"g/m2", 1e-3}}}},
      // From a loose knot to a weld.
      {{"Product/Junction stiffness"}, {1e-4, 1e6, {}}},
      {{"Geogrid/Pitch along", "Geogrid/Pitch across", "Product/Pitch along",
        "Product/Pitch across"},
       {0.002, 2, lengths}},
      {{"Geogrid/Rib width", "Product/Rib width along", "Product/Rib width across"},
       {1e-4, 0.1, lengths}},
      {{"Geogrid/Rib thickness", "Product/Rib thickness along", "Product/Rib thickness across",
        "Product/Junction thickness", "Product/Junction reach"},
       {1e-5, 0.05, lengths}},
      {{"Geogrid/Edge rounding"}, {1e-6, 0.05, lengths}},
      {{"Geogrid/Overhang"}, {1e-4, 2, lengths}},
      {{"Filling/Drop height", "Drop/Height", "Drop/Disc radius", "Measures/Radius"},
       {1e-4, 10, lengths}},
      // From half-empty to rolled ballast of heavy rock.
      {{"Filling/Lower bulk density", "Filling/Upper bulk density"}, {500, 4000, densities}},
      {{"Filling/Plate speed"}, {1e-4, 10, speeds}},
      {{"Filling/Plate force limit"}, {1, 1e6, forces}},
      {{"Filling/Settling time limit", "Drop/Settling time limit"}, {1e-3, 1000, times}},
      {{"Surcharge/Force"}, {0.1, 1e6, forces}},
      {{"Surcharge/Sphere radius"}, {1e-3, 1, lengths}},
      {{"Load/Normal stress", "Load/Cell pressure", "Load/Compaction stress"},
       {100, 1e7, pressures}},
      {{"Pull/Speed", "Shear/Speed"}, {1e-6, 10, speeds}},
      {{"Compression/Strain rate"}, {1e-6, 10, {{"%/s", 1e-2}, {"%/min", 1e-2 / 60}}}},
      {{"Pull/Distance", "Shear/Distance", "Output/Frames at"}, {1e-5, 2, lengths}},
      {{"Pull/Ramp time", "Shear/Ramp time", "Compression/Ramp time"}, {1e-5, 100, times}},
      {{"Packing/Throw speed"}, {1e-6, 100, speeds}},
      {{"Packing/Throw spin"}, {1e-3, 1e4, {{"rpm", 0.10471975511965977}}}},
      // Of a contact: from its stiffness and mass, so nearly anything.
      {{"Contact/Normal damping rate", "Contact/Tangential damping rate"}, {1e-3, 1e8, {}}},
      {{"Geogrid/Mass damping"}, {1e-3, 1e5, {}}},
      {{"Neighbour lists/Inner skin", "Neighbour lists/Middle skin"}, {1e-12, 0.05, lengths}},
      {{"Output/Record interval", "Output/Frame interval"}, {1e-6, 1000, times}},
      {{"Output/Checkpoint interval"}, {0.01, 1e6, times}},
      {{"Time/Step"}, {1e-9, 1e-2, {{"us", 1e-6}, {"ms", 1e-3}}}},
      {{"Laboratory/Largest torque"}, {1e-3, 1e3, {}}},
  };
  return rows;
}
} // namespace

const UsualRange* usual_range(const std::string& key)
{
  for (const Row& row : table())
    if (std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end()) return &row.range;
  return nullptr;
}

std::vector<std::string> keys_with_usual_range()
{
  std::vector<std::string> keys;
  for (const Row& row : table()) keys.insert(keys.end(), row.keys.begin(), row.keys.end());
  return keys;
}

std::string why_unusual(const std::string& key, double value, const std::string& unit)
{
  const UsualRange* range = usual_range(key);
  const auto usual = [&](double x) { return x >= range->lower && x <= range->upper; };
  if (!range || value == 0 || usual(value)) return "";
  std::string text = fmt::format("but {:g} to {:g} {} are usual", range->lower, range->upper, unit);
  for (const OtherUnit& other : range->others)
    if (usual(value * other.factor)) {
      text += fmt::format("; {:g} {} are {:g} {}", value, other.name, value * other.factor, unit);
      break;
    }
  return text;
}
} // namespace interlock::coupling
