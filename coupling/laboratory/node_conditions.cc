#include "coupling/laboratory/node_conditions.h"

#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
struct Condition {
  std::string set;
  std::vector<std::string> words;
};

// "set: word word; set: word".
std::vector<Condition> split(const std::string& text, const std::string& entry,
                             const std::string& example)
{
  std::vector<Condition> conditions;
  std::vector<std::string> parts;
  boost::split(parts, text, boost::is_any_of(";"));
  for (const std::string& part : parts) {
    const std::string trimmed = boost::trim_copy(part);
    if (trimmed.empty()) continue;
    const auto colon = trimmed.find(':');
    Condition condition;
    if (colon != std::string::npos) {
      condition.set = boost::trim_copy(trimmed.substr(0, colon));
      std::string rest = boost::trim_copy(trimmed.substr(colon + 1));
      if (!rest.empty())
        boost::split(condition.words, rest, boost::is_space(), boost::token_compress_on);
    }
    if (condition.set.empty() || condition.words.empty())
      throw InputError("Laboratory/" + entry + ": \"" + trimmed +
                       "\" is not a set of nodes, a colon and what happens there, such as \"" +
                       example + "\".");
    conditions.push_back(condition);
  }
  return conditions;
}

// Position of a word's name in `names`, and the number behind its equals sign (`unset` without
// one).
std::pair<int, double> component(const std::string& word, const std::vector<std::string>& names,
                                 const std::string& entry, double unset)
{
  const auto equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("Laboratory/" + entry + ": \"" + name + "\" is none of " +
                     boost::algorithm::join(names, ", ") + ".");
  double value = unset;
  if (equals != std::string::npos) {
    const std::string number = word.substr(equals + 1);
    std::size_t read = 0;
    try {
      value = std::stod(number, &read);
    } catch (const std::exception&) {
      read = 0;
    }
    if (read == 0 || read != number.size() || !std::isfinite(value))
      throw InputError("Laboratory/" + entry + ": \"" + number + "\" behind \"" + name +
                       "=\" is not a number.");
  }
  if (!std::isfinite(value))
    throw InputError("Laboratory/" + entry + ": \"" + word + "\" has no value, such as \"" + name +
                     "=-5\".");
  return {static_cast<int>(found - names.begin()), value};
}

} // namespace

const std::vector<int>& nodes_of(const std::string& set, const NodeSets& sets)
{
  const auto found = sets.find(set);
  if (found != sets.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& entry : sets) names.push_back(entry.first);
  throw InputError("There is no set of nodes \"" + set + "\"; there are " +
                   boost::algorithm::join(names, ", ") + ".");
}
std::vector<SupportCondition> parse_supports(const std::string& text)
{
  static const std::vector<std::string> names = {"x", "y", "z", "rx", "ry", "rz"};
  std::vector<SupportCondition> supports;
  for (const Condition& condition : split(text, "Supports", "front: x y z")) {
    SupportCondition support;
    support.set = condition.set;
    for (const std::string& word : condition.words)
      if (word == "all")
        for (int c = 0; c < 6; ++c) support.freedoms.emplace_back(c, 0.);
      else
        support.freedoms.push_back(component(word, names, "Supports", 0));
    supports.push_back(support);
  }
  return supports;
}

std::vector<LoadCondition> parse_loads(const std::string& text)
{
  static const std::vector<std::string> names = {"fx", "fy", "fz", "mx", "my", "mz"};
  std::vector<LoadCondition> loads;
  for (const Condition& condition : split(text, "Loads", "middle: fz=-5")) {
    LoadCondition load;
    load.set = condition.set;
    for (const std::string& word : condition.words) {
      const auto [c, value] = component(word, names, "Loads", NAN);
      load.load[c] += value;
    }
    loads.push_back(load);
  }
  return loads;
}

void apply(const std::vector<SupportCondition>& supports, double share, const NodeSets& sets,
           fem::StaticSolver& solver)
{
  for (const SupportCondition& support : supports)
    for (const int node : nodes_of(support.set, sets))
      for (const auto& [c, value] : support.freedoms) solver.prescribe(node, c, share * value);
}

void apply(const std::vector<LoadCondition>& loads, double share, const NodeSets& sets,
           fem::StaticSolver& solver)
{
  for (const LoadCondition& load : loads) {
    const std::vector<int>& nodes = nodes_of(load.set, sets);
    const fem::NodeLoad each = share / static_cast<double>(nodes.size()) * load.load;
    for (const int node : nodes) solver.add_load(node, each.head<3>(), each.tail<3>());
  }
}

NodeSets node_sets_of_piece(const fem::Lattice& lattice)
{
  Eigen::Vector3d low = lattice.reference_position(0), high = low;
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    low = low.cwiseMin(lattice.reference_position(i));
    high = high.cwiseMax(lattice.reference_position(i));
  }
  const double near = 1e-6 * (high - low).norm();
  NodeSets sets;
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Eigen::Vector3d& x = lattice.reference_position(i);
    const std::pair<const char*, bool> edges[] = {{"front", x.x() < low.x() + near},
                                                  {"back", x.x() > high.x() - near},
                                                  {"right", x.y() < low.y() + near},
                                                  {"left", x.y() > high.y() - near}};
    bool at_rim = false;
    for (const auto& [name, is_there] : edges) {
      if (is_there) sets[name].push_back(i);
      at_rim = at_rim || is_there;
    }
    if (at_rim) sets["rim"].push_back(i);
    sets["everywhere"].push_back(i);
  }
  sets["middle"] = {lattice.nearest_node(0.5 * (low + high))};
  return sets;
}
} // namespace interlock::coupling
