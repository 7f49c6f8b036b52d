// Arrays for the state of many bodies: one contiguous row a component, so that loops over bodies
// run in vector lanes.
#pragma once

#include "dem/vector.h"

#include <vector>

namespace interlock::dem
{
// Loops over rows may run to padded_size(): whole registers, without a rest that the compiler might
// round differently from the body of the loop. Two of the widest registers, side by side: while one
// waits for its operands the other one works.
constexpr int lane_width = 16;

inline int padded(int n)
{
  return (n + lane_width - 1) / lane_width * lane_width;
}

// `Rows` numbers for each entry. Element [i] is a view of the column (a reference to the number
// when there is one row). Entries beyond size() up to padded_size() hold `filler`.
template <int Rows> class ComponentArrays
{
public:
  using Value = Eigen::Matrix<double, Rows, 1>;

  explicit ComponentArrays(const Value& filler = Value::Zero()) : filler_(filler) {}

  int size() const { return size_; }
  int padded_size() const { return padded(size_); }

  decltype(auto) operator[](int i)
  {
    if constexpr (Rows == 1)
      return (data_(0, i));
    else
      return data_.col(i);
  }
  decltype(auto) operator[](int i) const
  {
    if constexpr (Rows == 1)
      return (data_(0, i));
    else
      return data_.col(i);
  }
  double* row(int component) { return data_.row(component).data(); }
  const double* row(int component) const { return data_.row(component).data(); }
  const double* begin() const { return row(0); } // of the first row
  const double* end() const { return row(0) + size_; }

  void push_back(const Value& value)
  {
    resize(size_ + 1);
    data_.col(size_ - 1) = value;
  }
  // New entries hold the filler. Memory only grows.
  void resize(int n)
  {
    if (padded(n) > data_.cols()) data_.conservativeResize(Rows, padded(n + n / 2));
    const int first = std::min(n, size_), count = padded(n) - first;
    for (int c = 0; c < Rows; ++c) data_.row(c).segment(first, count).setConstant(filler_[c]);
    size_ = n;
  }
  // Keeps the entries with remove[i] false, in their order.
  void compact(const std::vector<bool>& remove)
  {
    int kept = 0;
    for (int i = 0; i < size_; ++i)
      if (!remove[i]) data_.col(kept++) = data_.col(i).eval();
    resize(kept);
  }

private:
  Eigen::Matrix<double, Rows, Eigen::Dynamic, Eigen::RowMajor> data_;
  Value filler_;
  int size_ = 0;
};

using ScalarField = ComponentArrays<1>;
using VectorField = ComponentArrays<3>;

// Unit quaternions; rows x, y, z, w. Read by value, written by set().
class QuaternionField
{
public:
  int size() const { return data_.size(); }
  int padded_size() const { return data_.padded_size(); }
  Quaternion operator[](int i) const { return Quaternion(Eigen::Vector4d(data_[i])); }
  void set(int i, const Quaternion& q) { data_[i] = q.coeffs(); }
  void push_back(const Quaternion& q) { data_.push_back(q.coeffs()); }
  void resize(int n) { data_.resize(n); }
  void compact(const std::vector<bool>& remove) { data_.compact(remove); }
  double* row(int component) { return data_.row(component); }
  const double* row(int component) const { return data_.row(component); }

private:
  ComponentArrays<4> data_{Eigen::Vector4d(0, 0, 0, 1)};
};
} // namespace interlock::dem
