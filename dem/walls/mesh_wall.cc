#include "dem/walls/mesh_wall.h"

#include "dem/input_error.h"
#include "dem/scans/facet_file.h"
#include "dem/scans/mesh_cleaning.h"
#include "dem/scans/resolution.h"
#include "dem/scans/stone_file.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace interlock::dem
{
namespace
{
namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;
using Entry = std::pair<BoostBox, int>;

BoostBox box_of(const Vector3& low, const Vector3& high)
{
  return {BoostPoint(low[0], low[1], low[2]), BoostPoint(high[0], high[1], high[2])};
}

bool has_area(const TriangleMesh& mesh, const std::array<int, 3>& t)
{
  const Vector3& a = mesh.vertices[t[0]];
  const Vector3 ab = mesh.vertices[t[1]] - a, ac = mesh.vertices[t[2]] - a;
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return ab.cross(ac).norm() > 1e-9 * longest;
}

void check(const TriangleMesh& mesh)
{
  for (const Vector3& v : mesh.vertices)
    if (!v.allFinite())
      throw InputError("A wall of triangles has a vertex with a coordinate that is not a finite "
                       "number.");
  const int n = static_cast<int>(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      if (v < 0 || v >= n)
        throw InputError("A wall of triangles has a triangle with corner " + std::to_string(v) +
                         ", but its vertices are numbered from 0 to " + std::to_string(n - 1) +
                         ".");
}
} // namespace

struct MeshSurface::Tree {
  bg::index::rtree<Entry, bg::index::quadratic<16>> boxes;
};

MeshSurface::MeshSurface(TriangleMesh mesh)
{
  check(mesh);
  merge_vertices(mesh);
  std::set<std::array<int, 3>> known;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> corners = t;
    std::sort(corners.begin(), corners.end());
    if (!has_area(mesh, t))
      ++degenerate_dropped_;
    else if (!known.insert(corners).second)
      ++duplicates_dropped_;
    else
      mesh_.triangles.push_back(t);
  }
  if (mesh_.triangles.empty())
    throw InputError("A wall of triangles has no triangle with an area (" +
                     std::to_string(degenerate_dropped_) + " without one).");
  mesh_.vertices = std::move(mesh.vertices);
  tolerance_ = 1e-6 * extents(mesh_).maxCoeff();

  std::vector<Entry> boxes;
  for (const auto& t : mesh_.triangles) {
    const Vector3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
    facets_.push_back({a, b - a, c - a, (b - a).cross(c - a).normalized()});
    boxes.emplace_back(box_of(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)),
                       static_cast<int>(boxes.size()));
  }
  tree_ = std::make_unique<const Tree>(Tree{decltype(Tree::boxes)(boxes)});
}

MeshSurface::~MeshSurface() = default;

MeshSurface::Nearest MeshSurface::nearest(int triangle, const Vector3& x) const
{
  const Facet& f = facets_[triangle];
  const auto at = [&](const Vector3& p) { return Nearest{p, (x - p).norm(), false}; };
  const Vector3 ap = x - f.a;
  const double d1 = f.ab.dot(ap), d2 = f.ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return at(f.a);
  const Vector3 bp = ap - f.ab;
  const double d3 = f.ab.dot(bp), d4 = f.ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return at(f.a + f.ab);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(f.a + d1 / (d1 - d3) * f.ab);
  const Vector3 cp = ap - f.ac;
  const double d5 = f.ab.dot(cp), d6 = f.ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return at(f.a + f.ac);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(f.a + d2 / (d2 - d6) * f.ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return at(f.a + f.ab + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (f.ac - f.ab));
  const double h = f.normal.dot(ap);
  return {x - h * f.normal, std::abs(h), true};
}

void MeshSurface::triangles_within(const Vector3& x, double distance, std::vector<int>& found) const
{
  found.clear();
  const Vector3 reach = Vector3::Constant(distance);
  const auto box = box_of(x - reach, x + reach);
  for (auto hit = tree_->boxes.qbegin(bg::index::intersects(box)); hit != tree_->boxes.qend();
       ++hit)
    if (nearest(hit->second, x).distance < distance) found.push_back(hit->second);
  std::sort(found.begin(), found.end());
}

void MeshWall::move(double time_step)
{
  booked_work += half_work();
  moved = time_step * velocity;
  turned = time_step * spin;
  booked_work += half_work();
  centre += moved;
  const double angle = turned.norm();
  if (angle == 0) return;
  orientation = Quaternion(Eigen::AngleAxisd(angle, turned / angle)) * orientation;
  orientation.normalize();
}

MeshWall mesh_wall(const std::string& name, TriangleMesh world_mesh, const Vector3& centre)
{
  for (Vector3& v : world_mesh.vertices) v -= centre;
  MeshWall wall;
  wall.name = name;
  wall.surface = std::make_shared<const MeshSurface>(std::move(world_mesh));
  wall.centre = centre;
  return wall;
}

TriangleMesh read_wall_mesh(const std::string& path, double length_unit,
                            std::vector<std::string>* notes)
{
  InputFile file("Wall mesh", path);
  check_length_unit(file, length_unit);
  FacetData data = read_facets(file);
  TriangleMesh& mesh = data.mesh;
  if (mesh.triangles.empty()) file.refuse("has no facet.");
  merge_vertices(mesh);
  const std::string coarse =
      check_resolution(file, mesh.vertices, data.single_precision, length_unit);
  if (notes && !coarse.empty()) notes->push_back(coarse);
  for (Vector3& v : mesh.vertices) v *= length_unit;
  if (std::none_of(mesh.triangles.begin(), mesh.triangles.end(),
                   [&](const auto& t) { return has_area(mesh, t); }))
    file.refuse("has ", mesh.triangles.size(), " facets, but none with an area.");
  return mesh;
}
} // namespace interlock::dem
