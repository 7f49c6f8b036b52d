// What a single entry's range cannot tell: parameters that contradict each other or the disk.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace interlock::coupling
{
struct ParameterProblem {
  std::string entry;    // "Section/Name" of the entry to change first
  std::string sentence; // full sentence with the values and what is allowed
  bool unusual = false; // no contradiction: can be asked for with `Unusual values`
};

// A list of problems in the making.
class ParameterProblems
{
public:
  // Joins the parts, numbers and words, into one sentence.
  template <typename... Parts> void add(const std::string& entry, const Parts&... parts)
  {
    std::ostringstream sentence;
    (sentence << ... << parts);
    list_.push_back({entry, sentence.str(), false});
  }

  // The same of what can be run, but is most likely a slip.
  template <typename... Parts> void add_unusual(const std::string& entry, const Parts&... parts)
  {
    add(entry, parts...);
    list_.back().unusual = true;
  }

  std::size_t size() const { return list_.size(); }
  std::vector<ParameterProblem> take() { return std::move(list_); }

private:
  std::vector<ParameterProblem> list_;
};
} // namespace interlock::coupling
