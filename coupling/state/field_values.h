// Which types are plain values, and how they become numbers in an array and numbers become them.
#pragma once

#include "dem/bodies/component_arrays.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace interlock::coupling::detail
{
template <class T, class = void> struct FieldValue {
  static constexpr bool known = false;
};

// Numbers of one kind.
template <class T> struct FieldValue<T, std::enable_if_t<std::is_floating_point_v<T>>> {
  static constexpr bool known = true;
  static constexpr int columns = 1;
  using Number = double;
  static void put(const T& x, Number* to) { *to = x; }
  static void get(T& x, const Number* from) { x = static_cast<T>(*from); }
};
template <class T>
struct FieldValue<T, std::enable_if_t<std::is_integral_v<T> || std::is_enum_v<T>>> {
  static constexpr bool known = true;
  static constexpr int columns = 1;
  using Number = std::int64_t;
  static void put(const T& x, Number* to) { *to = static_cast<Number>(x); }
  static void get(T& x, const Number* from) { x = static_cast<T>(*from); }
};

template <> struct FieldValue<std::string> {
  static constexpr bool known = true;
  static constexpr int columns = 1;
  using Number = std::string;
  static void put(const std::string& x, Number* to) { *to = x; }
  static void get(std::string& x, const Number* from) { x = *from; }
};

// Vectors and matrices of fixed size, in the order of their storage.
template <class T> struct FixedMatrix : std::false_type {
};
template <int Rows, int Columns, int Options>
struct FixedMatrix<Eigen::Matrix<double, Rows, Columns, Options>>
    : std::bool_constant<(Rows > 0 && Columns > 0)> {
};
template <class T> struct FieldValue<T, std::enable_if_t<FixedMatrix<T>::value>> {
  static constexpr bool known = true;
  static constexpr int columns = T::SizeAtCompileTime;
  using Number = double;
  static void put(const T& x, Number* to) { std::copy_n(x.data(), columns, to); }
  static void get(T& x, const Number* from) { std::copy_n(from, columns, x.data()); }
};

// x, y, z, w, bit by bit: not made a unit quaternion again.
template <> struct FieldValue<Eigen::Quaterniond> {
  static constexpr bool known = true;
  static constexpr int columns = 4;
  using Number = double;
  static void put(const Eigen::Quaterniond& q, Number* to)
  {
    std::copy_n(q.coeffs().data(), 4, to);
  }
  static void get(Eigen::Quaterniond& q, const Number* from)
  {
    std::copy_n(from, 4, q.coeffs().data());
  }
};

template <class T, std::size_t N>
struct FieldValue<std::array<T, N>, std::enable_if_t<FieldValue<T>::known>> {
  static constexpr bool known = true;
  static constexpr int columns = static_cast<int>(N) * FieldValue<T>::columns;
  using Number = typename FieldValue<T>::Number;
  static void put(const std::array<T, N>& x, Number* to)
  {
    for (std::size_t k = 0; k < N; ++k) FieldValue<T>::put(x[k], to + k * FieldValue<T>::columns);
  }
  static void get(std::array<T, N>& x, const Number* from)
  {
    for (std::size_t k = 0; k < N; ++k) FieldValue<T>::get(x[k], from + k * FieldValue<T>::columns);
  }
};

// Rows of a list of values. `T` is the list; specialised for those that are no std::vector.
template <class T> struct FieldRows {
  static constexpr bool known = false;
};
template <class T> struct FieldRows<std::vector<T>> {
  static constexpr bool known = FieldValue<T>::known;
  using Value = T;
  static std::size_t size(const std::vector<T>& list) { return list.size(); }
  static void resize(std::vector<T>& list, std::size_t n) { list.assign(n, T()); }
  static T get(const std::vector<T>& list, std::size_t k) { return list[k]; }
  static void set(std::vector<T>& list, std::size_t k, const T& value) { list[k] = value; }
};
template <int Rows> struct FieldRows<dem::ComponentArrays<Rows>> {
  static constexpr bool known = true;
  using Value = Eigen::Matrix<double, Rows, 1>;
  using List = dem::ComponentArrays<Rows>;
  static std::size_t size(const List& list) { return list.size(); }
  static void resize(List& list, std::size_t n)
  {
    list.resize(0);
    list.resize(static_cast<int>(n));
  }
  static Value get(const List& list, std::size_t k)
  {
    Value value;
    for (int c = 0; c < Rows; ++c) value[c] = list.row(c)[k];
    return value;
  }
  static void set(List& list, std::size_t k, const Value& value)
  {
    for (int c = 0; c < Rows; ++c) list.row(c)[k] = value[c];
  }
};
template <> struct FieldRows<dem::QuaternionField> {
  static constexpr bool known = true;
  using Value = Eigen::Quaterniond;
  using List = dem::QuaternionField;
  static std::size_t size(const List& list) { return list.size(); }
  static void resize(List& list, std::size_t n)
  {
    list.resize(0);
    list.resize(static_cast<int>(n));
  }
  static Value get(const List& list, std::size_t k) { return list[static_cast<int>(k)]; }
  static void set(List& list, std::size_t k, const Value& q) { list.set(static_cast<int>(k), q); }
};
} // namespace interlock::coupling::detail
