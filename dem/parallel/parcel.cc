#include "dem/parallel/parcel.h"

#include "dem/parallel/byte_archive.h"

#include <tuple>

namespace interlock::dem
{
template <class Archive> void exchange(Archive& archive, ClumpState& s)
{
  archive("id", s.id);
  archive("shape", s.shape);
  archive("kind", s.kind);
  archive("mass", s.mass, "kg");
  archive("inertia", s.inertia, "kg m2");
  archive("position", s.position, "m");
  archive("orientation", s.orientation);
  archive("velocity", s.velocity, "m/s");
  archive("angular_momentum", s.angular_momentum, "kg m2/s");
  archive("drift_velocity", s.drift_velocity, "m/s");
  archive("spin", s.spin, "rad/s");
  archive("step_velocity", s.step_velocity, "m/s");
  archive("step_spin", s.step_spin, "rad/s");
  archive("force", s.force, "N");
  archive("torque", s.torque, "N m");
  archive("lost", s.lost, "J");
  archive("lost_to_crushing", s.lost_to_crushing, "J");
  archive("is_ghost", s.is_ghost);
}

template <class Archive> void exchange(Archive& archive, Parcel& parcel)
{
  archive("clumps", parcel.clumps);
  archive("contacts", parcel.contacts);
}

namespace
{
template <class T> void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// In the order that ContactMemory promises.
void sort(ContactMemory& memory)
{
  std::sort(memory.pairs.begin(), memory.pairs.end(), [](const auto& p, const auto& q) {
    return std::tie(p.first, p.second, p.a, p.b) < std::tie(q.first, q.second, q.a, q.b);
  });
  std::sort(memory.walls.begin(), memory.walls.end(), [](const auto& p, const auto& q) {
    return std::tie(p.wall, p.clump, p.a) < std::tie(q.wall, q.clump, q.a);
  });
  // Those of one member with one wall stay as the engine found them.
  std::stable_sort(memory.meshes.begin(), memory.meshes.end(), [](const auto& p, const auto& q) {
    return std::tie(p.clump, p.wall, p.a) < std::tie(q.clump, q.wall, q.a);
  });
  std::sort(memory.rolling.begin(), memory.rolling.end(), [](const auto& p, const auto& q) {
    return std::tie(p.kind, p.first, p.second, p.a, p.b) <
           std::tie(q.kind, q.first, q.second, q.a, q.b);
  });
}
} // namespace

Bytes Parcel::packed() const
{
  Bytes message;
  ByteWriter writer(message);
  writer("parcel", *this);
  return message;
}

Parcel Parcel::merged(const std::vector<Bytes>& messages)
{
  Parcel all;
  for (const Bytes& message : messages) {
    Parcel parcel;
    ByteReader reader(message);
    reader("parcel", parcel);
    append(all.clumps, parcel.clumps);
    append(all.contacts.pairs, parcel.contacts.pairs);
    append(all.contacts.walls, parcel.contacts.walls);
    append(all.contacts.meshes, parcel.contacts.meshes);
    append(all.contacts.rolling, parcel.contacts.rolling);
  }
  std::sort(all.clumps.begin(), all.clumps.end(),
            [](const ClumpState& p, const ClumpState& q) { return p.id < q.id; });
  sort(all.contacts);
  return all;
}
} // namespace interlock::dem
