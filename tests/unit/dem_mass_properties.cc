// Volume, centre, inertia and principal frame of solids with closed forms. Fails when a weight of
// the signed tetrahedra, the shift to the centre, the sign of a product of inertia or the order and
// handedness of the principal axes is wrong.
#include "dem/meshes/mass_properties.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

Matrix3 some_rotation()
{
  return Eigen::AngleAxisd(0.7, Vector3(1, -2, 3).normalized()).toRotationMatrix();
}

void expect_near(const Matrix3& value, const Matrix3& exact, double scale)
{
  EXPECT_LT((value - exact).cwiseAbs().maxCoeff(), 1e-12 * scale) << value << "\nnot\n" << exact;
}

Vector3 box_inertia(double a, double b, double c) // unit density
{
  return a * b * c / 12 * Vector3(b * b + c * c, a * a + c * c, a * a + b * b);
}

TEST(MassProperties, Cube)
{
  const double a = 0.03, volume = a * a * a;
  const MassProperties cube = mass_properties(solids::box(a, a, a));
  EXPECT_NEAR(cube.volume, volume, 1e-13 * volume);
  EXPECT_LT(cube.centre.norm(), 1e-14 * a);
  expect_near(cube.inertia, volume * a * a / 6 * Matrix3::Identity(), volume * a * a);
}

TEST(MassProperties, BoxTurnedAndMovedFar)
{
  const double a = 0.02, b = 0.03, c = 0.05;
  const Matrix3 turn = some_rotation();
  const Vector3 shift(2, -1, 0.5);
  const MassProperties box = mass_properties(solids::moved(solids::box(a, b, c), turn, shift));
  EXPECT_NEAR(box.volume, a * b * c, 1e-12 * a * b * c);
  EXPECT_LT((box.centre - shift).norm(), 1e-13);
  const Vector3 moments = box_inertia(a, b, c);
  expect_near(box.inertia, turn * moments.asDiagonal() * turn.transpose(), moments.norm());
}

// Right-angled corner a, b, c: V = abc/6, centre (a, b, c)/4, and about the corner the integral of
// x^2 is V a^2/10, of xy V ab/20.
TEST(MassProperties, Tetrahedron)
{
  const Vector3 s(0.02, 0.03, 0.05);
  const double volume = s.prod() / 6;
  const MassProperties body = mass_properties(solids::corner_tetrahedron(s[0], s[1], s[2]));
  EXPECT_NEAR(body.volume, volume, 1e-13 * volume);
  EXPECT_LT((body.centre - s / 4).norm(), 1e-15);
  Matrix3 second = volume / 20 * s * s.transpose();
  second.diagonal() *= 2;
  second -= volume / 16 * s * s.transpose();
  expect_near(body.inertia, second.trace() * Matrix3::Identity() - second,
              volume * s.squaredNorm());
}

TEST(MassProperties, OctahedronHoweverCut)
{
  const double a = 0.04, volume = std::sqrt(2.) * a * a * a / 3;
  for (const int n : {1, 2, 7}) {
    const MassProperties body = mass_properties(solids::subdivide(solids::octahedron(a), n));
    EXPECT_NEAR(body.volume, volume, 1e-12 * volume);
    expect_near(body.inertia, volume * a * a / 10 * Matrix3::Identity(), volume * a * a);
  }
}

TEST(MassProperties, InsideOutIsNegative)
{
  EXPECT_NEAR(mass_properties(solids::inside_out(solids::box(1, 2, 3))).volume, -6, 1e-12);
}

TEST(MassProperties, CoincidentSpheresAreOneSphere)
{
  const double r = 0.01, volume = 3e-6;
  const Vector3 centre(0.1, 0.2, -0.3);
  const MassProperties body =
      mass_properties(std::vector<Sphere>(5, {centre, r}), std::vector<double>(5, volume / 5));
  EXPECT_NEAR(body.volume, volume, 1e-15 * volume);
  EXPECT_LT((body.centre - centre).norm(), 1e-15);
  expect_near(body.inertia, 0.4 * volume * r * r * Matrix3::Identity(), volume * r * r);
}

// A light and a heavy ball on the x axis: reduced mass times distance squared, across the axis.
TEST(MassProperties, Dumbbell)
{
  const double m1 = 1e-6, m2 = 3e-6, r1 = 0.01, r2 = 0.02, d = 0.05;
  const MassProperties body =
      mass_properties({{{0, 0, 0}, r1}, {{d, 0, 0}, r2}}, std::vector<double>{m1, m2});
  const double own = 0.4 * (m1 * r1 * r1 + m2 * r2 * r2);
  const double across = own + m1 * m2 / (m1 + m2) * d * d;
  EXPECT_NEAR(body.centre[0], m2 / (m1 + m2) * d, 1e-15);
  expect_near(body.inertia, Vector3(own, across, across).asDiagonal(), across);
}

TEST(PrincipalFrame, AscendingRightHandedAndSigned)
{
  const double a = 0.02, b = 0.05, c = 0.03;
  const Matrix3 turn = some_rotation();
  const MassProperties box =
      mass_properties(solids::moved(solids::box(a, b, c), turn, Vector3(0.1, 0, 0)));
  const PrincipalFrame frame = principal_frame(box);
  Vector3 moments = box_inertia(a, b, c);
  std::sort(moments.begin(), moments.end());
  EXPECT_LT((frame.moments - moments).norm(), 1e-12 * moments.norm());
  EXPECT_NEAR(frame.axes.determinant(), 1, 1e-12);
  // The smallest moment is about the longest side (y of the box), the largest about the shortest
  // (x).
  EXPECT_NEAR(std::abs(frame.axes.col(0).dot(turn.col(1))), 1, 1e-12);
  EXPECT_NEAR(std::abs(frame.axes.col(2).dot(turn.col(0))), 1, 1e-12);
  for (int k = 0; k < 2; ++k) {
    Eigen::Index largest;
    frame.axes.col(k).cwiseAbs().maxCoeff(&largest);
    EXPECT_GT(frame.axes(largest, k), 0);
  }
}
} // namespace
