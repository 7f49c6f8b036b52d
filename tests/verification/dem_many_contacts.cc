// A brick built with 20, 100 and 500 spheres lands flat on a plane, each sphere with a spring and
// dashpot of its own (the paper's plain rule).
//
// N equal contacts are one with N k and N c, so with sqrt(N) times the damping ratio b:
//     e = exp(-B/sqrt(1 - B^2) (pi - atan(2 B sqrt(1 - B^2)/(1 - 2 B^2)))),  B = b sqrt(N) <
//     1/sqrt(2)
// (Schwager and Poeschel, Granular Matter 9 (2007) 465-469), and the duration falls with sqrt(N):
// the same stone bounces otherwise when it is built of more spheres. Large moments keep it from
// rocking. Fails when contacts of one clump are lost, doubled or share what they should not. What
// is left: spheres that touch the face only to some 0.1 um.
#include "tests/dem_bodies.h"
#include "tests/dem_solids.h"

#include "dem/generator/clump_generator.h"

using namespace bodies;

namespace
{
constexpr double k = 2e6, v = 3, density = 2600, ratio = 0.02;
} // namespace

TEST(ManyContacts, PlainRuleDependsOnTheNumberOfSpheres)
{
  for (const int n : {20, 100, 500}) {
    ClumpParameters parameters;
    parameters.max_spheres = n;
    parameters.r_min = 5e-4;
    ClumpShape shape = make_clump(solids::subdivide(solids::box(0.04, 0.03, 0.02), 12), parameters);
    ASSERT_EQ(int(shape.spheres.size()), n);
    shape.unit_inertia *= 1e9;

    Engine engine({shape}, {}, 0);
    engine.add_wall(plane(smooth_contact(k, ratio, false)));
    double low = 1; // the flattest side is across z
    for (const Sphere& s : shape.spheres) low = std::min(low, s.centre.z() - s.radius);
    const double w0 = std::sqrt(k / (density * shape.volume)), dt = 2e-4 / w0;
    engine.add_clump(0, density, {0, 0, -low + 0.5 * v * dt}, Quaternion::Identity(), {0, 0, -v});
    double duration = 0;
    std::size_t touching = 0;
    while (engine.clumps().position[0].z() < -low + v * dt) {
      engine.step(dt);
      if (engine.clumps().force[0].norm() > 0) duration += dt;
      std::size_t now = 0;
      for (const WallContact& c : engine.wall_contacts()) now += c.touching;
      touching = std::max(touching, now);
    }
    const double b = ratio * std::sqrt(touching), root = std::sqrt(1 - b * b);
    const double phase = M_PI - std::atan(2 * b * root / (1 - 2 * b * b));
    const double e = Vector3(engine.clumps().velocity[0]).z() / v;
    EXPECT_NEAR(e, std::exp(-b / root * phase), 0.02) << touching << " contacts";
    EXPECT_NEAR(duration * w0, phase / root / std::sqrt(touching), 0.02 * duration * w0)
        << touching;
    record("contacts_" + std::to_string(n), touching);
    record("restitution_" + std::to_string(n), e);
    record("restitution_error", e - std::exp(-b / root * phase));
    record("duration_" + std::to_string(n), duration * w0);
    record("duration_error", duration * w0 * root / phase * std::sqrt(touching) - 1);
  }
}
