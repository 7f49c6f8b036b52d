#include "dem/export/member_volumes.h"

#include "dem/meshes/mass_properties.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Row k: what a unit share of each sphere adds to volume (1 row), first moments (3), products
// of inertia (3) and moments of inertia (3). Lengths in units of `length`, so that all rows are of
// order 1.
Matrix contributions(const ClumpShape& shape, double length)
{
  Matrix rows(10, shape.spheres.size());
  for (Eigen::Index i = 0; i < rows.cols(); ++i) {
    const Vector3 x = shape.spheres[i].centre / length;
    const double r = shape.spheres[i].radius / length;
    const Vector3 square = x.cwiseAbs2();
    const Vector3 moments = Vector3::Constant(square.sum() + 0.4 * r * r) - square;
    rows.col(i) << 1, x, x[0] * x[1], x[0] * x[2], x[1] * x[2], moments;
  }
  return rows;
}

// Positive shares with rows * shares = target, nearest to `prior` in relative entropy:
// share_i = prior_i exp(sum_k multiplier_k rows_ki), where the multipliers minimise the convex
// function sum_i share_i - target . multipliers. False when there are none.
bool fit(const Matrix& rows, const Vector& target, const Vector& prior, Vector& shares)
{
  const auto of = [&](const Vector& multipliers) -> Vector {
    return prior.array() * (rows.transpose() * multipliers).array().exp();
  };
  const auto dual = [&](const Vector& multipliers) {
    return of(multipliers).sum() - target.dot(multipliers);
  };
  Vector multipliers = Vector::Zero(rows.rows());
  for (int iteration = 0; iteration < 200; ++iteration) {
    shares = of(multipliers);
    const Vector missing = target - rows * shares;
    if (missing.cwiseAbs().maxCoeff() < 1e-14) return true;
    // Few spheres leave the matrix singular, hence the decomposition that copes with it.
    const Matrix hessian = rows * shares.asDiagonal() * rows.transpose();
    const Vector step = hessian.completeOrthogonalDecomposition().solve(missing);
    const double value = dual(multipliers), slope = missing.dot(step);
    double length = 1;
    while (length > 1e-6 && !(dual(multipliers + length * step) <=
                              value - 1e-4 * length * slope + 1e-15 * std::abs(value)))
      length /= 2;
    if (length <= 1e-6) break;
    multipliers += length * step;
    if (!multipliers.allFinite()) return false;
  }
  return (target - rows * shares).cwiseAbs().maxCoeff() < 1e-11;
}
} // namespace

std::vector<double> member_volumes(const ClumpShape& shape)
{
  const double length = shape.bounding_radius();
  const Matrix rows = contributions(shape, length);
  Vector target = Vector::Zero(10), prior(rows.cols()), shares;
  target[0] = 1;
  target.tail<3>() = shape.unit_inertia / (shape.volume * length * length);
  for (Eigen::Index i = 0; i < prior.size(); ++i) prior[i] = std::pow(shape.spheres[i].radius, 3);
  prior /= prior.sum();

  shares = prior; // the volume alone
  for (const int conditions : {10, 7, 4})
    if (Vector found; fit(rows.topRows(conditions), target.head(conditions), prior, found)) {
      shares = found;
      break;
    }
  shares *= shape.volume;
  return {shares.data(), shares.data() + shares.size()};
}

double sum_deviation(const ClumpShape& shape, const std::vector<double>& volumes)
{
  const MassProperties sums = mass_properties(shape.spheres, volumes);
  const Vector3 root = shape.unit_inertia.cwiseSqrt();
  const Matrix3 inertia = shape.unit_inertia.asDiagonal();
  const Matrix3 off = (sums.inertia - inertia).cwiseQuotient(root * root.transpose());
  return std::max({std::abs(sums.volume / shape.volume - 1),
                   sums.centre.norm() / shape.bounding_radius(), off.cwiseAbs().maxCoeff()});
}
} // namespace interlock::dem
