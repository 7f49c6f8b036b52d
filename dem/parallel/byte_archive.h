// Field lists (coupling/state/state_archive.h explains them) as plain bytes, for messages between
// ranks of one run: no names, no units, the byte order of the machine.
#pragma once

#include "dem/parallel/ranks.h"
#include "dem/vector.h"

#include <cstring>
#include <type_traits>

namespace interlock::dem
{
namespace bytes
{
template <class T> struct IsVector : std::false_type {
};
template <class T> struct IsVector<std::vector<T>> : std::true_type {
};
template <class T> constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
} // namespace bytes

class ByteWriter
{
public:
  static constexpr bool reading = false;

  explicit ByteWriter(Bytes& bytes) : bytes_(bytes) {}

  template <class T> void operator()(const char*, const T& field, const char* = "")
  {
    if constexpr (bytes::is_number<T>)
      append(&field, sizeof field);
    else if constexpr (std::is_same_v<T, Vector3>)
      append(field.data(), 3 * sizeof(double));
    else if constexpr (std::is_same_v<T, Quaternion>)
      append(field.coeffs().data(), 4 * sizeof(double));
    else if constexpr (bytes::IsVector<T>::value) {
      (*this)("size", field.size());
      for (const auto& entry : field) (*this)("", entry);
    } else
      exchange(*this, const_cast<T&>(field)); // only read
  }

private:
  void append(const void* data, std::size_t size)
  {
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + size);
    std::memcpy(bytes_.data() + begin, data, size);
  }

  Bytes& bytes_;
};

class ByteReader
{
public:
  static constexpr bool reading = true;

  explicit ByteReader(const Bytes& bytes) : bytes_(bytes) {}

  template <class T> void operator()(const char*, T& field, const char* = "")
  {
    if constexpr (bytes::is_number<T>)
      take(&field, sizeof field);
    else if constexpr (std::is_same_v<T, Vector3>)
      take(field.data(), 3 * sizeof(double));
    else if constexpr (std::is_same_v<T, Quaternion>)
      take(field.coeffs().data(), 4 * sizeof(double));
    else if constexpr (bytes::IsVector<T>::value) {
      std::size_t n = 0;
      (*this)("size", n);
      field.resize(n);
      for (auto& entry : field) (*this)("", entry);
    } else
      exchange(*this, field);
  }

private:
  void take(void* data, std::size_t size)
  {
    std::memcpy(data, bytes_.data() + place_, size);
    place_ += size;
  }

  const Bytes& bytes_;
  std::size_t place_ = 0;
};
} // namespace interlock::dem
