// What a study varies: the values of an entry, a range of it, or named changes of several entries.
#pragma once

#include "apps/parameter_scanner.h"

#include <string>
#include <vector>

namespace interlock::apps
{
// One of the values of a factor.
struct Level {
  std::string name;                // as in the study file: "2.4e9", "rigid"
  std::vector<Assignment> entries; // that it sets; none: the base case as it is
};

// Which of the three shares of the variance a factor belongs to.
enum class FactorKind { filling, geogrid, set_up };
std::string kind_name(FactorKind kind); // "filling", "geogrid", "set-up"

struct Factor {
  std::string name;          // "ribs", or the key of its entry
  std::vector<Level> levels; // the first one is the reference; none of a range without a count
  bool is_range = false;
  bool is_logarithmic = false; // of a range: equal steps of the logarithm
  double low = 0, high = 0;    // of a range
  Assignment source;           // the line of the study file

  // The level at `share` of the way through the range, 0 to 1, or through the list of levels.
  Level at(double share) const;
  // Of the geogrid when all entries that it sets are.
  FactorKind kind() const;
};

// Reads one line of the subsection "Parameters":
//     Section/Entry = VALUE, VALUE, ...
//     Section/Entry = LOW to HIGH [in COUNT] [log]
//     NAME = LEVEL: Section/Entry=VALUE & Section/Entry=VALUE, LEVEL: ...
// Throws InputError, one sentence with the place, for a line that is none of these. Whether the
// entries and values are good ones is not known here.
Factor read_factor(const Assignment& line);

// What stands between commas, without blanks around it.
std::vector<std::string> split_list(const std::string& text);
} // namespace interlock::apps
