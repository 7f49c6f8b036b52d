#include "dem/lanes/contact_lanes.h"

namespace interlock::dem
{
void ContactLanes::resize(int n)
{
  const auto resize_index = [n](auto& index) {
    index.resize(padded(n));
    std::fill(index.begin() + n, index.end(), 0);
  };
  resize_index(i), resize_index(j), resize_index(a), resize_index(b);
  for (VectorField* field : {&centre1, &centre2, &spring, &dashpot, &force, &torque1, &torque2})
    field->resize(n);
  for (ScalarField* field :
       {&radius1, &radius2, &reduced_mass, &root_mass, &reduced_radius, &shared_depth, &gradient,
        &overlap, &tangential_stiffness, &elastic, &friction, &damping})
    field->resize(n);
}

void ContactLanes::set_pair(int k, const ContactKey& key, const Clumps& clumps)
{
  i[k] = key.i, j[k] = key.j, a[k] = key.a, b[k] = key.b;
  const Sphere &sa = clumps.shape_of(key.i).spheres[key.a],
               &sb = clumps.shape_of(key.j).spheres[key.b];
  centre1[k] = sa.centre;
  centre2[k] = sb.centre;
  radius1[k] = sa.radius;
  radius2[k] = sb.radius;
  const double m1 = clumps.mass[key.i], m2 = clumps.mass[key.j];
  reduced_mass[k] = m1 * m2 / (m1 + m2);
  root_mass[k] = std::sqrt(reduced_mass[k]);
  reduced_radius[k] = sa.radius * sb.radius / (sa.radius + sb.radius);
}

void ContactLanes::set_wall(int k, const ContactKey& key, const Clumps& clumps)
{
  i[k] = key.i, j[k] = key.j, a[k] = key.a, b[k] = 0;
  const Sphere& sphere = clumps.shape_of(key.i).spheres[key.a];
  centre1[k] = sphere.centre;
  radius1[k] = reduced_radius[k] = sphere.radius;
  reduced_mass[k] = clumps.mass[key.i];
  root_mass[k] = std::sqrt(reduced_mass[k]);
}

LaneMemory ContactLanes::memory(int k) const
{
  return {spring[k],       dashpot[k], force[k], overlap[k], tangential_stiffness[k],
          shared_depth[k], gradient[k]};
}

void ContactLanes::remember(int k, const LaneMemory& memory)
{
  spring[k] = memory.spring;
  dashpot[k] = memory.dashpot;
  force[k] = memory.force;
  overlap[k] = memory.overlap;
  tangential_stiffness[k] = memory.tangential_stiffness;
  shared_depth[k] = memory.shared_depth;
  gradient[k] = memory.gradient;
}

void ContactLanes::copy_history(int k, const ContactLanes& from, int from_k)
{
  spring[k] = from.spring[from_k];
  dashpot[k] = from.dashpot[from_k];
  overlap[k] = from.overlap[from_k];
  tangential_stiffness[k] = from.tangential_stiffness[from_k];
  shared_depth[k] = from.shared_depth[from_k];
  gradient[k] = from.gradient[from_k];
  force[k] = from.force[from_k];
  torque1[k] = from.torque1[from_k];
  torque2[k] = from.torque2[from_k];
}
} // namespace interlock::dem
