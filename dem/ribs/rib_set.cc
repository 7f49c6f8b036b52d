#include "dem/ribs/rib_set.h"

namespace interlock::dem
{
RibSet::RibSet(std::vector<RibShape> shapes, int n_ends) : shapes_(std::move(shapes))
{
  for (VectorField* field : {&position, &velocity, &spin}) field->resize(n_ends);
  rotation.resize(n_ends);
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

std::vector<Rib> RibSet::all() const
{
  std::vector<Rib> ribs;
  for (int r = 0; r < size(); ++r) ribs.push_back((*this)[r]);
  return ribs;
}
} // namespace interlock::dem
