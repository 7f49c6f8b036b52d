#include "dem/generator/surface_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
Vector3 nearest_on_triangle(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a, ac = c - a;
  const auto on_edge = [&x](const Vector3& from, const Vector3& edge) {
    const double length_squared = edge.squaredNorm();
    const double t = length_squared > 0 ? (x - from).dot(edge) / length_squared : 0;
    return Vector3(from + std::clamp(t, 0., 1.) * edge);
  };
  // Barycentric coordinates of the foot on the plane; inside when all are positive.
  const Vector3 normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const Vector3 ax = x - a;
    const double v = ax.cross(ac).dot(normal) / area, w = ab.cross(ax).dot(normal) / area;
    if (v >= 0 && w >= 0 && v + w <= 1) return x - ax.dot(normal) / area * normal;
  }
  Vector3 best = on_edge(a, ab);
  for (const Vector3& other : {on_edge(a, ac), on_edge(b, c - b)})
    if ((other - x).squaredNorm() < (best - x).squaredNorm()) best = other;
  return best;
}

// Embree's tree of boxes, in single precision: it proposes facets, and their distances are then
// computed in double precision. Coordinates are scaled to +-1 around the middle.
struct SurfaceTree::Tree {
  explicit Tree(const TriangleMesh& mesh)
      : device(rtcNewDevice("threads=1")), scene(rtcNewScene(device))
  {
    Eigen::AlignedBox3d box;
    for (const Vector3& x : mesh.vertices) box.extend(x);
    middle = box.center();
    scale = 2 / box.sizes().maxCoeff();
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* nodes = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                              mesh.vertices.size()));
    for (const Vector3& x : mesh.vertices)
      for (int k = 0; k < 3; ++k) *nodes++ = static_cast<float>(scale * (x[k] - middle[k]));
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& t : mesh.triangles)
      for (const int v : t) *corners++ = static_cast<unsigned>(v);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  ~Tree()
  {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  // Radius of a search around `x` that misses nothing within `reach` for single precision's sake.
  float scaled(double reach) const { return static_cast<float>(1.0001 * scale * reach + 1e-6); }

  RTCDevice device;
  RTCScene scene;
  Vector3 middle;
  double scale = 1; // [1/m]
};

SurfaceTree::SurfaceTree(const TriangleMesh& mesh)
    : mesh_(mesh), first_(mesh.vertices.size() + 1, 0), around_(3 * mesh.triangles.size()),
      tree_(std::make_unique<Tree>(mesh))
{
  for (const auto& t : mesh.triangles)
    for (const int v : t) ++first_[v + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) first_[v + 1] += first_[v];
  std::vector<int> next = first_;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (const int v : mesh.triangles[f]) around_[next[v]++] = static_cast<int>(f);
}

SurfaceTree::~SurfaceTree() = default;

Vector3 SurfaceTree::area_vector(int facet) const
{
  const auto& t = mesh_.triangles[facet];
  return (mesh_.vertices[t[1]] - mesh_.vertices[t[0]])
      .cross(mesh_.vertices[t[2]] - mesh_.vertices[t[0]]);
}

SurfaceTree::Nearest SurfaceTree::nearest(const Vector3& x, double reach, Facets which, int node,
                                          const Vector3& direction) const
{
  const auto wanted = [&](int facet) {
    if (which == Facets::all) return true;
    const auto& t = mesh_.triangles[facet];
    if (t[0] == node || t[1] == node || t[2] == node) return false;
    return (area_vector(facet).dot(direction) > 0) == (which == Facets::ahead);
  };
  struct Search {
    const SurfaceTree& surface;
    const Vector3& x;
    const decltype(wanted)& is_wanted;
    Nearest best;
    double best_squared;
  } search{*this, x, wanted, {}, reach * reach};
  // Called for each facet whose box is within the radius, which shrinks as nearer ones are found.
  const auto visit = [](RTCPointQueryFunctionArguments* call) {
    auto& s = *static_cast<Search*>(call->userPtr);
    const int facet = static_cast<int>(call->primID);
    if (!s.is_wanted(facet)) return false;
    const auto& t = s.surface.mesh_.triangles[facet];
    const auto& nodes = s.surface.mesh_.vertices;
    const Vector3 q = nearest_on_triangle(s.x, nodes[t[0]], nodes[t[1]], nodes[t[2]]);
    const double squared = (q - s.x).squaredNorm();
    // Of equally near facets the first counts, whatever the order of the visits.
    if (squared > s.best_squared || (squared == s.best_squared && !(facet < s.best.facet)))
      return false;
    s.best_squared = squared;
    s.best.facet = facet;
    s.best.point = q;
    call->query->radius = s.surface.tree_->scaled(std::sqrt(squared));
    return true;
  };
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const Vector3 at = tree_->scale * (x - tree_->middle);
  RTCPointQuery query{float(at[0]), float(at[1]), float(at[2]), 0, tree_->scaled(reach)};
  rtcPointQuery(tree_->scene, &query, &context, visit, &search);
  search.best.distance = std::sqrt(search.best_squared);
  return search.best;
}

bool SurfaceTree::is_outward(int node, const Vector3& outward) const
{
  return std::all_of(around_.begin() + first_[node], around_.begin() + first_[node + 1],
                     [&](int facet) { return area_vector(facet).dot(outward) > 0; });
}
} // namespace interlock::dem
