// What values of ballast, geogrids and their tests usually are. A value outside has most often been
// typed in another unit: 2.65 for g/cm3, 2400 for MPa, 160 for mm.
#pragma once

#include <string>
#include <vector>

namespace interlock::coupling
{
struct OtherUnit {
  std::string name; // "g/cm3"
  double factor;    // one of it in the unit of the entry
};

struct UsualRange {
  double lower, upper; // both included, in the unit of the entry
  std::vector<OtherUnit> others;
};

// Of the entry "Section/Name" of a parameter file; null for an entry without one: pure numbers and
// names. A value of 0 stands for `not given` or `none` wherever
// the entry takes it, and is usual.
const UsualRange* usual_range(const std::string& key);

// All entries with a range, "Section/Name", and options of the commands, "--density".
std::vector<std::string> keys_with_usual_range();

// Empty when `value` is usual for the entry; else the end of a sentence that begins with the entry
// and its value, without a full stop: "but 1000 to 8000 kg/m3 are usual; 2.65 g/cm3 are 2650
// kg/m3".
std::string why_unusual(const std::string& key, double value, const std::string& unit);
} // namespace interlock::coupling
