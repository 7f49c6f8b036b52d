// What contacts with ribs remember, taken out by ids of clumps and put back.
#include "dem/ribs/rib_contacts.h"

#include <stdexcept>
#include <string>

namespace interlock::dem
{
std::vector<RibMemory> RibContacts::memory(const Clumps& clumps) const
{
  std::vector<RibMemory> memory;
  for (const RibContact& c : contacts_) {
    const bool holds_nothing = c.overlap <= 0 && c.shared <= 0 && c.history.overlap <= 0 &&
                               c.history.spring.isZero(0) && c.history.dashpot.isZero(0);
    if (holds_nothing) continue;
    memory.push_back({clumps.id[c.i], c.a, c.line, c.history, c.force, c.point, c.arm, c.overlap,
                      c.shared, c.tangential_stiffness, c.rib, c.xi});
  }
  return memory;
}

// The list has no candidates yet: the next update makes it anew and takes the histories over.
void RibContacts::restore(const Clumps& clumps, const std::vector<RibMemory>& memory)
{
  clear();
  for (const RibMemory& m : memory) {
    RibContact c;
    c.i = clumps.index_of(m.clump);
    if (c.i < 0)
      throw std::logic_error("A contact with a rib belongs to clump " + std::to_string(m.clump) +
                             ", which is not there.");
    c.a = m.a, c.line = m.line;
    c.radius = clumps.shape_of(c.i).spheres[c.a].radius;
    c.history = m.history;
    c.force = m.force, c.point = m.point, c.arm = m.arm;
    c.overlap = m.overlap, c.shared = m.shared;
    c.tangential_stiffness = m.tangential_stiffness;
    c.rib = m.rib, c.xi = m.xi;
    contacts_.push_back(c);
  }
}
} // namespace interlock::dem
