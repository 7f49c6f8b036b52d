// Types with field lists of every kind, numbers that a careless detour would change, and the way
// through a tree and back.
#pragma once

#include "coupling/state/state_archive.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace state_samples
{
using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;
using Real = std::numeric_limits<double>;

inline double from_bits(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Doubles that a detour over text, float or arithmetic would change.
inline const std::vector<double> delicate = {0.,
                                             -0.,
                                             0.1,
                                             1. / 3,
                                             Real::min(),
                                             Real::max(),
                                             Real::lowest(),
                                             Real::denorm_min(),
                                             -Real::denorm_min(),
                                             from_bits(12345),
                                             Real::infinity(),
                                             -Real::infinity(),
                                             from_bits(0x7ff8000000abcdefu), // a NaN with a payload
                                             from_bits(0xfff8000000000001u)}; // a negative one

template <class T> bool same_bits(const T& a, const T& b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class T> bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

enum class Colour { red, green = 7, blue = -3 };

struct Spring {
  Vector3 stretch = Vector3::Zero();
  int turns = 0;
};
template <class Archive> void exchange(Archive& archive, Spring& spring)
{
  archive("stretch", spring.stretch, "m");
  archive("turns", spring.turns);
}

struct Contact {
  std::int64_t first = 0;
  std::string word;
  Spring spring;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};
template <class Archive> void exchange(Archive& archive, Contact& contact)
{
  archive("first", contact.first);
  archive("word", contact.word);
  archive("spring", contact.spring);
  archive("turn", contact.turn);
}

struct Shape {
  static constexpr bool stored_as_groups = true;
  std::vector<double> radii;
  std::vector<Spring> springs;
};
template <class Archive> void exchange(Archive& archive, Shape& shape)
{
  archive("radii", shape.radii, "m");
  archive("springs", shape.springs);
}

struct Fill {
  static constexpr const char* kind = "fill";
  int batch = 0;
};
template <class Archive> void exchange(Archive& archive, Fill& stage)
{
  archive("batch", stage.batch);
}
struct Pull {
  static constexpr const char* kind = "pull";
  double displacement = 0;
};
template <class Archive> void exchange(Archive& archive, Pull& stage)
{
  archive("displacement", stage.displacement, "m");
}
struct Stay {
  static constexpr const char* kind = "stay";
};
template <class Archive> void exchange(Archive&, Stay&) {}

// Writes a field, reads it into another object of its type, and gives both trees.
template <class T> T round_trip(const T& field, T into = T())
{
  StateTree tree, again;
  StateWriter writer(tree, "state/");
  writer("field", field, "m");
  StateReader reader(tree, "state/");
  reader("field", into);
  reader.expect_all_read();
  StateWriter(again, "state/")("field", into, "m");
  EXPECT_EQ(first_difference(tree, again), std::nullopt);
  EXPECT_EQ(hash_of(tree), hash_of(again));
  return into;
}

template <class T> StateTree written(const T& field)
{
  StateTree tree;
  StateWriter(tree, "state/")("field", field);
  return tree;
}
} // namespace state_samples
