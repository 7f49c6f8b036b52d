// Which member spheres of two clumps, or of a clump and a wall, are near each other.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/walls/wall.h"

namespace interlock::dem
{
// Member spheres `a` and `b` with the gap between them [m]; for a wall, b = 0.
struct NearSpheres {
  int a, b;
  double gap;
};

// Finds near spheres; keeps its work space, so that no memory is asked for in the long run.
class SphereWalk
{
public:
  // Takes over the shapes that have come since the last call.
  void take_shapes(const std::vector<ClumpShape>& shapes);

  // Appends the member pairs of clumps i and j with a gap of at most `cut` [m], sorted by a, then
  // b.
  void add_pairs(const Clumps& clumps, int i, int j, double cut, std::vector<NearSpheres>& near);
  // The same for members of clump i and a wall.
  void add_at_wall(const Clumps& clumps, int i, const Wall& wall, double cut,
                   std::vector<NearSpheres>& near);

private:
  // Member spheres in the body frame, padded with spheres of a large negative radius.
  struct Members {
    VectorField centre;
    ScalarField radius{Eigen::Matrix<double, 1, 1>::Constant(-1e3)};
  };
  // Chosen members of one clump in the frame of clump i.
  struct Chosen {
    std::vector<int> index;
    std::vector<double> x, y, z, r;

    void resize(std::size_t n);
    void set(std::size_t k, int member, const Vector3& centre, double radius)
    {
      index[k] = member;
      x[k] = centre[0], y[k] = centre[1], z[k] = centre[2], r[k] = radius;
    }
    void pad(); // with spheres that are near nothing
    // Drops what does not reach the box from `low` to `high`.
    void keep_reaching(const Vector3& low, const Vector3& high);
    void box(Vector3& low, Vector3& high) const; // around the spheres
  };

  // Front of the members along `axis` (body frame): height[k] = axis . centre + radius; returns the
  // largest.
  double heights(const Members& members, const Vector3& axis);
  // Puts those of the first n members that are at least as high as `least` to the begin of chosen_,
  // ascending; returns how many.
  int choose(int n, double least);
  void test_all(double cut, std::vector<NearSpheres>& near);

  std::vector<Members> members_; // of the shapes
  std::vector<double> height_;
  std::vector<int> chosen_;
  Chosen first_, second_;
};
} // namespace interlock::dem
