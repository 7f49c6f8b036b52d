// What the engine knows about single contacts: views for output, stored energies, the stable step.
#include "dem/engine/engine.h"

namespace interlock::dem
{
namespace
{
// Of a sphere against another one (or a point, of radius 0) with centres d apart.
struct Overlap {
  double depth;   // > 0 when touching [m]
  Vector3 normal; // from the second body to the first
};

Overlap overlap_of(const Vector3& d, double reach)
{
  const double distance = d.norm();
  return {reach - distance, d / distance};
}

// The larger of the tangent stiffnesses, normal and tangential [N/m].
double largest_stiffness(const ContactProperties& pair, double overlap, double reduced_radius)
{
  const TangentStiffness k = tangent_stiffness(pair, overlap, reduced_radius);
  return std::max(k.normal, k.tangential);
}

// The most that a unit impulse at `arm` from the centre of mass can move the body's own material
// there, over all directions: 1/m + the largest eigenvalue of [r]x I^-1 [r]x^T; principal axes
// [1/kg].
double largest_mobility(const Vector3& arm, double mass, const Vector3& inertia)
{
  Matrix3 cross;
  cross << 0, -arm[2], arm[1], arm[2], 0, -arm[0], -arm[1], arm[0], 0;
  const Matrix3 turning = cross * inertia.cwiseInverse().asDiagonal() * cross.transpose();
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(turning, Eigen::EigenvaluesOnly);
  return 1 / mass + solver.eigenvalues()[2];
}

// What the last evaluation left in lane k, into a view of it.
template <class Contact> void take_lane(const ContactLanes& lanes, int k, Contact& contact)
{
  const LaneMemory memory = lanes.memory(k);
  contact.overlap = memory.overlap;
  contact.touching = memory.overlap > memory.crushed;
  contact.force = memory.force;
  contact.history = {memory.spring, memory.overlap, memory.dashpot, memory.crushed};
  contact.share = lanes.share(k);
}
} // namespace

std::vector<SphereContact> Engine::sphere_contacts() const
{
  const ContactLanes& lanes = lists_.pair_lanes();
  std::vector<SphereContact> contacts(lanes.size());
  for (int k = 0; k < lanes.size(); ++k) {
    SphereContact& c = contacts[k];
    const ContactKey& key = lanes.key(k);
    c.i = key.i, c.j = key.j, c.a = key.a, c.b = key.b;
    take_lane(lanes, k, c);
    const double rb = clumps_.shape_of(c.j).spheres[c.b].radius;
    const Vector3 xb = clumps_.position[c.j] + clumps_.member_offset(c.j, c.b);
    const Overlap o = overlap_of(clumps_.position[c.i] + clumps_.member_offset(c.i, c.a) - xb,
                                 clumps_.shape_of(c.i).spheres[c.a].radius + rb);
    c.point = xb + (rb - 0.5 * o.depth) * o.normal;
  }
  return contacts;
}

std::vector<WallContact> Engine::wall_contacts() const
{
  const ContactLanes& lanes = lists_.wall_lanes();
  std::vector<WallContact> contacts;
  const std::size_t n_walls = std::min(walls_.size(), lists_.wall_segments().size());
  for (std::size_t w = 0; w < n_walls; ++w) {
    const WallSegment segment = lists_.wall_segments()[w];
    for (int k = segment.begin; k < segment.end; ++k) {
      WallContact c;
      c.i = lanes.key(k).i, c.wall = static_cast<int>(w), c.a = lanes.key(k).a;
      take_lane(lanes, k, c);
      const Vector3 x = clumps_.position[c.i] + clumps_.member_offset(c.i, c.a);
      const Vector3 nearest = walls_[w].nearest_point(x);
      const Overlap o = overlap_of(x - nearest, clumps_.shape_of(c.i).spheres[c.a].radius);
      c.point = nearest - 0.5 * o.depth * o.normal;
      contacts.push_back(c);
    }
  }
  return contacts;
}

// At the present poses, of contacts that touched when forces were last evaluated: those that have
// closed since are on the list or not, as skins will have it, and have done no work yet.
double Engine::elastic_energy(const SphereContact& c) const
{
  if (!c.touching) return 0;
  const double ra = clumps_.shape_of(c.i).spheres[c.a].radius,
               rb = clumps_.shape_of(c.j).spheres[c.b].radius;
  const Vector3 d = clumps_.position[c.i] + clumps_.member_offset(c.i, c.a) -
                    clumps_.position[c.j] - clumps_.member_offset(c.j, c.b);
  const double depth = overlap_of(d, ra + rb).depth - c.history.crushed;
  if (depth <= 0) return 0;
  return stored_energy(stone_on_stone_, depth, ra * rb / (ra + rb), c.history.spring.norm(),
                       c.share);
}

double Engine::elastic_energy(const WallContact& c) const
{
  if (!c.touching) return 0;
  const Wall& wall = walls_[c.wall];
  const Vector3 x = clumps_.position[c.i] + clumps_.member_offset(c.i, c.a);
  const double radius = clumps_.shape_of(c.i).spheres[c.a].radius;
  const double depth = radius - (x - wall.nearest_point(x)).norm() - c.history.crushed;
  if (depth <= 0) return 0;
  return stored_energy(wall.contact, depth, radius, c.history.spring.norm(), c.share);
}

double Engine::elastic_energy() const
{
  double sum = 0;
  for (const SphereContact& c : sphere_contacts()) sum += elastic_energy(c);
  for (const WallContact& c : wall_contacts()) sum += elastic_energy(c);
  for (const MeshContact& c : mesh_contacts_.contacts())
    sum += MeshContacts::elastic_energy(c, mesh_walls_[c.wall].contact);
  for (const RollingSpring& s : rolling_.springs())
    sum += 0.5 * s.stiffness * s.angle.squaredNorm();
  return sum;
}

StableStep Engine::stable_step(const RibContacts* ribs) const
{
  std::vector<double> rate(clumps_.size(), 0.);      // bound of omega^2 [1/s2]
  std::vector<double> stiffness(clumps_.size(), 0.); // sums [N/m]
  std::vector<int> contacts(clumps_.size(), 0);
  auto add = [&](int i, const Vector3& point, double k) {
    const Vector3 arm =
        clumps_.orientation[i].conjugate()._transformVector(point - clumps_.position[i]);
    stiffness[i] += k;
    rate[i] += k * largest_mobility(arm, clumps_.mass[i], clumps_.inertia[i]);
    ++contacts[i];
  };
  const auto radius = [&](int i, int a) { return clumps_.shape_of(i).spheres[a].radius; };
  for (const SphereContact& c : sphere_contacts()) {
    if (!c.touching) continue;
    const double ra = radius(c.i, c.a), rb = radius(c.j, c.b);
    const double k = largest_stiffness(stone_on_stone_, c.overlap, ra * rb / (ra + rb));
    add(c.i, c.point, k);
    add(c.j, c.point, k);
  }
  for (const WallContact& c : wall_contacts())
    if (c.touching)
      add(c.i, c.point, largest_stiffness(walls_[c.wall].contact, c.overlap, radius(c.i, c.a)));
  for (const MeshContact& c : mesh_contacts_.contacts())
    add(c.i, c.point, largest_stiffness(mesh_walls_[c.wall].contact, c.depth, radius(c.i, c.a)));
  if (ribs)
    for (const RibContact& c : ribs->contacts())
      if (c.overlap > 0)
        add(c.i, c.point, largest_stiffness(ribs->properties(), c.overlap, radius(c.i, c.a)));

  StableStep limit;
  double largest = 0;
  for (int i = 0; i < clumps_.size(); ++i)
    if (clumps_.ghost[i] == 0 && rate[i] > largest) {
      largest = rate[i];
      limit = {2 / std::sqrt(2 * rate[i]),
               clumps_.id[i],
               clumps_.shape[i],
               clumps_.mass[i],
               contacts[i],
               stiffness[i] / contacts[i],
               1 - stiffness[i] / clumps_.mass[i] / rate[i]};
    }
  return limit;
}

StableStep Engine::expected_stable_step(const std::vector<double>& densities, int n_contacts) const
{
  StableStep limit;
  double largest = 0;
  for (std::size_t s = 0; s < densities.size(); ++s) {
    const ClumpShape& shape = clumps_.shapes().at(s);
    const double mass = densities[s] * shape.volume;
    double mobility = 0;
    for (const Sphere& sphere : shape.spheres) {
      // Where a sphere is farthest from the centre of mass, and its poles along the axes.
      const auto consider = [&](const Vector3& direction) {
        mobility = std::max(mobility, largest_mobility(sphere.centre + sphere.radius * direction,
                                                       mass, densities[s] * shape.unit_inertia));
      };
      consider(sphere.centre.stableNormalized());
      for (int k = 0; k < 3; ++k) consider(Vector3::Unit(k)), consider(-Vector3::Unit(k));
    }
    const double rate = n_contacts * largest_stiffness(stone_on_stone_, 0, 0) * mobility;
    if (rate > largest) {
      largest = rate;
      limit = {2 / std::sqrt(2 * rate),
               -1,
               static_cast<int>(s),
               mass,
               n_contacts,
               largest_stiffness(stone_on_stone_, 0, 0),
               1 - 1 / (mass * mobility)};
    }
  }
  return limit;
}

int Engine::count_overlaps_brute_force() const
{
  int count = 0;
  for (int i = 0; i < clumps_.size(); ++i)
    for (int j = i + 1; j < clumps_.size(); ++j) {
      const double balls = clumps_.bounding_radius(i) + clumps_.bounding_radius(j);
      if ((clumps_.position[i] - clumps_.position[j]).norm() > balls) continue;
      for (std::size_t a = 0; a < clumps_.shape_of(i).spheres.size(); ++a)
        for (std::size_t b = 0; b < clumps_.shape_of(j).spheres.size(); ++b) {
          const Vector3 d = clumps_.position[i] + clumps_.member_offset(i, a) -
                            clumps_.position[j] - clumps_.member_offset(j, b);
          const double reach =
              clumps_.shape_of(i).spheres[a].radius + clumps_.shape_of(j).spheres[b].radius;
          if (d.squaredNorm() < reach * reach) ++count;
        }
    }
  return count;
}
} // namespace interlock::dem
