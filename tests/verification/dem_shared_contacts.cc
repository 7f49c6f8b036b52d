// One stone built with 20, 100 and 500 spheres lands on a plane in the same attitude: restitution
// and contact time must not depend on the number of spheres (docs/theory/engine.md: contacts of the
// same two bodies share stiffness and dashpots). Mass, axes and moments are those of the surface.
//
// Reference: the single linear contact, Schwager and Poeschel, Granular Matter 9 (2007) 465-469.
// With n equal contacts that do not share, k and c count n times: restitution and duration fall
// with the root of n; that spread is computed beside. Fails when the share of a contact lags, when
// changing shares feed energy, or when unequal depths make a contact of many spheres softer than
// one of few.
#include "tests/dem_bodies.h"
#include "tests/dem_solids.h"

#include "dem/generator/clump_generator.h"
#include "dem/stones/geodesic_sphere.h"

using namespace bodies;

namespace
{
constexpr double k = 2e7, v = 1, density = 2600, ratio = 0.1;

struct Landing {
  double restitution, duration, energy; // [-], times w0, kinetic after over before
};

Landing land(const TriangleMesh& stone, int n_spheres, bool share, bool may_rock,
             double damping_ratio, double step = 0.02)
{
  ClumpParameters parameters;
  parameters.max_spheres = n_spheres;
  parameters.r_min = 5e-4;
  ClumpShape shape = make_clump(stone, parameters);
  EXPECT_EQ(int(shape.spheres.size()), n_spheres);
  if (!may_rock) shape.unit_inertia *= 1e9;
  ContactProperties contact = smooth_contact(k, damping_ratio, false);
  contact.share_among_contacts = share;
  Engine engine({shape}, {}, 0);
  engine.add_wall(plane(contact));
  // The axis of the largest moment down: the flattest side.
  const Quaternion q(0, 1, 0, 0); // half a turn about x
  double low = 1;
  for (const Sphere& s : shape.spheres) low = std::min(low, (q * s.centre).z() - s.radius);
  const double w0 = std::sqrt(k / (density * shape.volume)), dt = step / w0;
  engine.add_clump(0, density, {0, 0, -low + 0.5 * v * dt}, q, {0, 0, -v});
  const double before = engine.kinetic_energy();
  const Impact impact = run_impact(engine, dt);
  const Vector3 u = engine.clumps().velocity[0];
  return {u.z() / v, impact.duration * w0, engine.kinetic_energy() / before};
}

void compare(const TriangleMesh& stone, bool may_rock)
{
  std::vector<Landing> shared;
  for (const int n : {20, 100, 500}) {
    shared.push_back(land(stone, n, true, may_rock, ratio));
    const Landing plain = land(stone, n, false, may_rock, ratio, 0.001);
    const double gain = land(stone, n, true, may_rock, 0).energy;
    record("restitution_" + std::to_string(n), shared.back().restitution);
    record("restitution_plain_" + std::to_string(n), plain.restitution);
    record("duration_" + std::to_string(n), shared.back().duration);
    record("duration_plain_" + std::to_string(n), plain.duration);
    record("undamped_energy_" + std::to_string(n), gain);
    EXPECT_NEAR(gain, 1, 0.03) << n << " spheres";
  }
  for (const Landing& a : shared) {
    EXPECT_NEAR(a.restitution, shared[2].restitution, 0.03 * shared[2].restitution);
    EXPECT_NEAR(a.duration, shared[2].duration, 0.03 * shared[2].duration);
  }
}

TriangleMesh brick()
{
  return solids::subdivide(solids::box(0.04, 0.03, 0.02), 12);
}

TriangleMesh pebble()
{
  TriangleMesh mesh = geodesic_sphere(14);
  for (Vector3& x : mesh.vertices) x *= 0.02;
  return mesh;
}
} // namespace

// Flat side down, kept from rocking by large moments: all contacts are equally deep.
TEST(SharedContacts, BrickThatCannotRock)
{
  compare(brick(), false);
}

TEST(SharedContacts, Brick)
{
  compare(brick(), true);
}

// Every sphere is nearly the whole pebble: contacts of unequal depth under its lowest point.
TEST(SharedContacts, RoundPebble)
{
  compare(pebble(), true);
}
