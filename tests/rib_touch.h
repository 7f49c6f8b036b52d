// What clumps and ribs do to each other where they are.
#pragma once

#include "dem/ribs/rib_contacts.h"

struct RibTouch {
  interlock::dem::SubcycledClumps clumps; // the near ones
  std::vector<interlock::dem::RodLoads> loads;
};

// Renews the list and evaluates the contacts once, as a sub-step of this length [s] does.
inline RibTouch touch_ribs(interlock::dem::RibContacts& contacts,
                           const interlock::dem::Clumps& clumps, const interlock::dem::RibSet& ribs,
                           double step, interlock::dem::ContactEnergy& energy)
{
  contacts.update_list(clumps, ribs, step);
  RibTouch touch;
  touch.clumps.take(clumps, contacts.near_clumps());
  touch.loads = contacts.evaluate(touch.clumps, ribs, step, energy);
  return touch;
}
