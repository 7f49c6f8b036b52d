#include "coupling/loop/state_hash.h"

#include "coupling/state/state_archive.h"

namespace interlock::coupling
{
std::uint64_t state_hash(const World& world)
{
  StateTree tree;
  StateWriter archive(tree);
  archive("world", world);
  return hash_of(tree);
}
} // namespace interlock::coupling
