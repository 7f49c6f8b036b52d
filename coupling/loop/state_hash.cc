#include "coupling/loop/state_hash.h"

#include <cstring>

namespace interlock::coupling
{
namespace
{
class Fnv1a
{
public:
  void add_bytes(const void* data, std::size_t n)
  {
    const unsigned char* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < n; ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3ULL;
  }
  template <class Derived> void add(const Eigen::PlainObjectBase<Derived>& values)
  {
    add_bytes(values.derived().data(), values.size() * sizeof(double));
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};
} // namespace

std::uint64_t state_hash(const dem::Clumps& clumps, const fem::ExplicitDynamics* lattice)
{
  Fnv1a hash;
  for (int i = 0; i < clumps.size(); ++i) {
    hash.add_bytes(&clumps.id[i], sizeof(clumps.id[i]));
    hash.add(dem::Vector3(clumps.position[i]));
    hash.add(clumps.orientation[i].coeffs());
    hash.add(dem::Vector3(clumps.velocity[i]));
    hash.add(dem::Vector3(clumps.angular_momentum[i]));
  }
  if (!lattice) return hash.value();
  for (int node = 0; node < lattice->lattice().n_nodes(); ++node) {
    const Eigen::Vector3d x = lattice->position(node), v = lattice->velocity(node),
                          w = lattice->spin(node);
    const Eigen::Quaterniond q = lattice->orientation(node);
    hash.add(x);
    hash.add(q.coeffs());
    hash.add(v);
    hash.add(w);
  }
  return hash.value();
}
} // namespace interlock::coupling
