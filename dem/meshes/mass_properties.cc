#include "dem/meshes/mass_properties.h"

namespace interlock::dem
{
namespace
{
// From the volume, its first moment and its second moment (integrals of x and of x x^T) about
// `origin`.
MassProperties about_centre(double volume, const Vector3& first, const Matrix3& second,
                            const Vector3& origin)
{
  MassProperties result;
  result.volume = volume;
  // A body without volume has no centre; the caller sees the zero volume.
  const Vector3 offset = volume != 0 ? Vector3(first / volume) : Vector3(Vector3::Zero());
  const Matrix3 central = second - volume * offset * offset.transpose();
  result.centre = origin + offset;
  result.inertia = central.trace() * Matrix3::Identity() - central;
  return result;
}

Vector3 mean_of(const std::vector<Vector3>& points)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points) sum += point;
  return points.empty() ? sum : Vector3(sum / points.size());
}
} // namespace

MassProperties mass_properties(const TriangleMesh& mesh)
{
  // The apex of all tetrahedra may lie anywhere; near the body it costs no digits to cancellation.
  const Vector3 apex = mean_of(mesh.vertices);
  double volume = 0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Vector3 a = mesh.vertices[triangle[0]] - apex;
    const Vector3 b = mesh.vertices[triangle[1]] - apex;
    const Vector3 c = mesh.vertices[triangle[2]] - apex;
    const Vector3 sum = a + b + c;
    const double six_volumes = a.dot(b.cross(c));
    volume += six_volumes / 6;
    first += six_volumes / 24 * sum;
    second += six_volumes / 120 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  return about_centre(volume, first, second, apex);
}

MassProperties mass_properties(const std::vector<Sphere>& spheres,
                               const std::vector<double>& volumes)
{
  const Vector3 origin = spheres.empty() ? Vector3(Vector3::Zero()) : spheres.front().centre;
  double volume = 0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Vector3 x = spheres[i].centre - origin;
    const double r = spheres[i].radius;
    volume += volumes[i];
    first += volumes[i] * x;
    // The second moment of a solid sphere about its own centre is m r^2/5 on each axis.
    second += volumes[i] * (x * x.transpose() + r * r / 5 * Matrix3::Identity());
  }
  return about_centre(volume, first, second, origin);
}

PrincipalFrame principal_frame(const MassProperties& properties)
{
  // Eigen sorts the eigenvalues in ascending order. Scaling keeps tiny moments [m5] clear of
  // underflow in its iteration.
  const double scale = properties.inertia.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return {Vector3::Zero(), Matrix3::Identity()};
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(properties.inertia / scale);
  PrincipalFrame frame{scale * solver.eigenvalues(), solver.eigenvectors()};
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Index largest;
    frame.axes.col(axis).cwiseAbs().maxCoeff(&largest);
    if (frame.axes(largest, axis) < 0) frame.axes.col(axis) *= -1;
  }
  frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
  return frame;
}
} // namespace interlock::dem
