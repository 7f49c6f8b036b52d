#include "coupling/state/state_tree.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>

namespace interlock::coupling
{
namespace
{
// Feeds values into a hash, each with its length in front, so that no two lists look alike.
class Hasher
{
public:
  Hasher() : state_(XXH3_createState()) { XXH3_64bits_reset(state_); }
  ~Hasher() { XXH3_freeState(state_); }
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  void add(const std::string& text)
  {
    add(static_cast<std::int64_t>(text.size()));
    XXH3_64bits_update(state_, text.data(), text.size());
  }
  void add(std::int64_t number) { XXH3_64bits_update(state_, &number, sizeof number); }
  template <class T> void add(const std::vector<T>& values)
  {
    add(static_cast<std::int64_t>(values.size()));
    if constexpr (std::is_same_v<T, std::string>)
      for (const std::string& value : values) add(value);
    else
      XXH3_64bits_update(state_, values.data(), values.size() * sizeof(T));
  }
  std::uint64_t value() const { return XXH3_64bits_digest(state_); }

private:
  XXH3_state_t* state_;
};

bool same(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T> bool same(const T& a, const T& b)
{
  return a == b;
}

template <class T>
std::optional<std::string> difference(const std::string& path, const std::vector<T>& a,
                                      const std::vector<T>& b, int columns)
{
  if (a.size() != b.size())
    return fmt::format("{} has {} values on one side and {} on the other.", path, a.size(),
                       b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!same(a[k], b[k]))
      return fmt::format("{}, row {}, column {}: {} on one side and {} on the other.", path,
                         k / columns, k % columns, a[k], b[k]);
  return {};
}
} // namespace

std::size_t StateArray::size() const
{
  return std::visit([](const auto& v) { return v.size(); }, values);
}

std::uint64_t hash_of(const StateTree& tree, const std::string& prefix)
{
  Hasher hasher;
  for (auto entry = tree.lower_bound(prefix);
       entry != tree.end() && entry->first.compare(0, prefix.size(), prefix) == 0; ++entry) {
    hasher.add(entry->first.substr(prefix.size()));
    hasher.add(static_cast<std::int64_t>(entry->second.values.index()));
    hasher.add(static_cast<std::int64_t>(entry->second.columns));
    std::visit([&](const auto& values) { hasher.add(values); }, entry->second.values);
  }
  return hasher.value();
}

std::optional<std::string> first_difference(const StateTree& a, const StateTree& b)
{
  for (const auto& entry : a) {
    const std::string& path = entry.first; // C++17's lambdas cannot capture structured bindings
    const StateArray& array = entry.second;
    const auto other = b.find(path);
    if (other == b.end()) return path + " is there on one side only.";
    if (array.values.index() != other->second.values.index() ||
        array.columns != other->second.columns)
      return path + " has another type or shape on the other side.";
    const auto found = std::visit(
        [&](const auto& values) {
          using Values = std::decay_t<decltype(values)>;
          return difference(path, values, std::get<Values>(other->second.values), array.columns);
        },
        array.values);
    if (found) return found;
  }
  for (const auto& entry : b)
    if (a.find(entry.first) == a.end()) return entry.first + " is there on one side only.";
  return {};
}
} // namespace interlock::coupling
