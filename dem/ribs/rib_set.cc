#include "dem/ribs/rib_set.h"

#include <algorithm>
#include <iterator>

namespace interlock::dem
{
RibSet::RibSet(std::vector<RibShape> shapes, int n_ends) : shapes_(std::move(shapes))
{
  for (VectorField* field : {&position, &velocity, &spin}) field->resize(n_ends);
  rotation.resize(n_ends);
  measure();
}

RibSet::RibSet(const std::vector<Rib>& rods)
{
  for (const Rib& rod : rods) {
    RibShape shape;
    shape.line = rod.line;
    shape.first_end = position.size();
    shape.half_width = rod.half_width;
    shape.half_thickness = rod.half_thickness;
    shape.rounding = rod.rounding;
    for (int end : {0, 1}) {
      shape.inverse_mass[end] = rod.inverse_mass[end];
      shape.width_axis[end] = rod.width_axis[end];
      position.push_back(rod.x[end]);
      velocity.push_back(rod.v[end]);
      spin.push_back(rod.w[end]);
      rotation.push_back(Quaternion::Identity());
    }
    shapes_.push_back(shape);
  }
  measure();
}

std::vector<Rib> RibSet::all() const
{
  std::vector<Rib> ribs;
  for (int r = 0; r < size(); ++r) ribs.push_back((*this)[r]);
  return ribs;
}

void RibSet::measure()
{
  for (const RibShape& s : shapes_) {
    largest_half_thickness_ = std::max(largest_half_thickness_, s.half_thickness);
    largest_half_girth_ = std::max(largest_half_girth_, s.half_width + s.half_thickness);
  }
  set_all_present();
}

void RibSet::set_all_present()
{
  set_present_ends({{0, position.padded_size()}}); // whole registers
}

void RibSet::set_present_ends(std::vector<EndRange> ends)
{
  present_ends_ = std::move(ends);
  present_.clear();
  for (int r = 0; r < size(); ++r) {
    const int first = shape(r).first_end;
    // The range that begins last up to there.
    const auto next =
        std::upper_bound(present_ends_.begin(), present_ends_.end(), first,
                         [](int end, const EndRange& range) { return end < range.begin; });
    if (next != present_ends_.begin() && first + 1 < std::prev(next)->end) present_.push_back(r);
  }
}

Rib RibSet::operator[](int r) const
{
  const RibShape& s = shape(r);
  Rib rib;
  rib.line = s.line;
  rib.half_width = s.half_width;
  rib.half_thickness = s.half_thickness;
  rib.rounding = s.rounding;
  for (int end : {0, 1}) {
    const int e = s.first_end + end;
    rib.inverse_mass[end] = s.inverse_mass[end];
    rib.x[end] = position[e];
    rib.v[end] = velocity[e];
    rib.w[end] = spin[e];
    rib.width_axis[end] = rotation[e] * s.width_axis[end];
  }
  return rib;
}
} // namespace interlock::dem
