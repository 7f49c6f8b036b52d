// What stones near a geogrid remember of it: what travels with them when stones change ranks.
#pragma once

#include "dem/contacts/contact_memory.h"
#include "dem/vector.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace interlock::coupling
{
// What ribs did to one stone near them, mean over the last step: local damping takes it for that of
// the step to come.
struct MeanLoad {
  std::int64_t clump = 0;                                                   // id
  dem::Vector3 force = dem::Vector3::Zero(), torque = dem::Vector3::Zero(); // [N], [N m]
};

template <class Archive> void exchange(Archive& archive, MeanLoad& load)
{
  archive("clump", load.clump);
  archive("force", load.force, "N");
  archive("torque", load.torque, "N m");
}

struct RibSide {
  std::vector<dem::RibMemory> contacts; // in the order of (clump, sphere, line)
  std::vector<MeanLoad> mean_loads;     // ascending ids

  // Adds that of other stones.
  void append(const RibSide& other)
  {
    contacts.insert(contacts.end(), other.contacts.begin(), other.contacts.end());
    mean_loads.insert(mean_loads.end(), other.mean_loads.begin(), other.mean_loads.end());
    std::sort(contacts.begin(), contacts.end(), [](const auto& p, const auto& q) {
      return std::tie(p.clump, p.a, p.line) < std::tie(q.clump, q.a, q.line);
    });
    std::sort(mean_loads.begin(), mean_loads.end(),
              [](const auto& p, const auto& q) { return p.clump < q.clump; });
  }
  // Lets go of that of stones for which `wanted` is false.
  template <class Function> void keep(const Function& wanted)
  {
    const auto filter = [&](auto& list) {
      list.erase(std::remove_if(list.begin(), list.end(),
                                [&](const auto& entry) { return !wanted(entry.clump); }),
                 list.end());
    };
    filter(contacts);
    filter(mean_loads);
  }
};

template <class Archive> void exchange(Archive& archive, RibSide& side)
{
  archive("mean_loads", side.mean_loads);
  archive("contacts", side.contacts);
}
} // namespace interlock::coupling
