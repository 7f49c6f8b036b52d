// How the time step of a run follows the stable step of the contacts that there are.
#pragma once

#include "dem/engine/engine.h"

#include <algorithm>

namespace interlock::coupling
{
struct StepRule {
  double share = 0;    // of the stable step; 0: the time step stays as it was set [-]
  double expected = 0; // stable step of the packing that is to come, an estimate [s]

  // [s]. Before there are contacts, and where only a few stones touch yet, the live stable step
  // says nothing about the packing; that of a packing comes out up to so much above the estimate,
  // whose contacts all sit where a stone is most mobile.
  double step(const dem::StableStep& live) const
  {
    constexpr double loosest = 1.4;
    const double most = loosest * expected;
    return share * (live.step > 0 ? std::min(live.step, most) : most);
  }
};

template <class Archive> void exchange(Archive& archive, StepRule& rule)
{
  archive("share", rule.share);
  archive("expected", rule.expected, "s");
}
} // namespace interlock::coupling
