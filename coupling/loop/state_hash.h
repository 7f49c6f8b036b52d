// A number that changes when any digit of the state changes: proof that two runs are the same.
#pragma once

#include "dem/bodies/clumps.h"
#include "fem/explicit/explicit_dynamics.h"

#include <cstdint>

namespace interlock::coupling
{
// FNV-1a (64 bit) over the bytes of ids, positions, attitudes, velocities and angular momenta of
// all clumps, in their order, and of positions, attitudes, velocities and spins of all lattice
// nodes. `lattice` may be null.
std::uint64_t state_hash(const dem::Clumps& clumps, const fem::ExplicitDynamics* lattice);
} // namespace interlock::coupling
