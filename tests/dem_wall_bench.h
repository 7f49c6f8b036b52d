// A small stage for tests of walls: an engine, walls of triangles with their contacts, and the
// ledger of both.
#pragma once

#include "dem/engine/engine.h"
#include "dem/walls/mesh_contacts.h"

#include <cmath>

namespace wall_bench
{
using namespace interlock::dem;

inline ClumpShape ball(double radius)
{
  ClumpShape shape;
  shape.name = "ball";
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4. / 3 * M_PI * radius * radius * radius;
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}

inline ContactProperties springs(double k, double friction = 0, double damping = 0)
{
  ContactProperties pair;
  pair.normal_stiffness = k;
  pair.tangential_stiffness = 0.8 * k;
  pair.friction = friction;
  pair.damping_ratio = damping;
  return pair;
}

// A rectangle spanned by two edges from a corner, nu x nv cells of two triangles, whose diagonals
// alternate; every corner of every triangle is a vertex of its own, as in an STL file.
inline TriangleMesh rectangle(const Vector3& corner, const Vector3& edge1, const Vector3& edge2,
                              int nu = 1, int nv = 1)
{
  TriangleMesh mesh;
  const auto at = [&](int u, int v) {
    return Vector3(corner + double(u) / nu * edge1 + double(v) / nv * edge2);
  };
  const auto add = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int u = 0; u < nu; ++u)
    for (int v = 0; v < nv; ++v) {
      const Vector3 a = at(u, v), b = at(u + 1, v), c = at(u + 1, v + 1), d = at(u, v + 1);
      if ((u + v) % 2 == 0)
        add(a, b, c), add(a, c, d);
      else
        add(a, b, d), add(b, c, d);
    }
  return mesh;
}

inline void append(TriangleMesh& mesh, const TriangleMesh& more)
{
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

inline Wall rectangle_wall(const Vector3& corner, const Vector3& edge1, const Vector3& edge2,
                           const ContactProperties& contact)
{
  return interlock::dem::rectangle_wall("rectangle", corner, edge1, edge2, contact);
}

struct Stage {
  Stage(std::vector<ClumpShape> shapes, const ContactProperties& stones, double gravity)
      : engine(std::move(shapes), stones, gravity)
  {
  }

  int add_mesh(const TriangleMesh& mesh, const ContactProperties& contact,
               const Vector3& centre = Vector3::Zero())
  {
    meshes.push_back(mesh_wall("mesh", mesh, centre));
    meshes.back().contact = contact;
    return static_cast<int>(meshes.size()) - 1;
  }

  // A clump at `position` moving at `velocity` and spinning.
  int add(int shape, const Vector3& position, const Vector3& velocity,
          const Vector3& spin = Vector3::Zero(), double density = 2650)
  {
    const int i = engine.add_clump(shape, density, position, Quaternion::Identity(), velocity);
    Clumps& c = engine.clumps();
    c.spin[i] = c.step_spin[i] = spin;
    c.angular_momentum[i] = Vector3(c.inertia[i]).cwiseProduct(spin);
    return i;
  }

  void forces(double dt)
  {
    engine.compute_forces(dt);
    contacts.update_list(engine.clumps(), meshes);
    stored = contacts.evaluate(engine.clumps(), meshes, dt);
  }

  void move(double dt)
  {
    engine.kick_all(dt);
    engine.drift_all(dt);
    engine.move_walls(dt);
    for (MeshWall& wall : meshes) wall.move(dt);
  }

  void step(double dt)
  {
    forces(dt);
    move(dt);
  }

  // Stored and dissipated less put in [J]: constant. Between forces() and move().
  double ledger(double dt) const
  {
    const EngineEnergy e = engine.energy(dt);
    double sum = e.kinetic + e.gravitational + e.contact.elastic + e.contact.friction +
                 e.contact.damping + stored - e.wall_work;
    for (const MeshWall& wall : meshes) sum -= wall.work();
    return sum;
  }

  Engine engine;
  MeshContacts contacts;
  std::vector<MeshWall> meshes;
  double stored = 0; // in the springs of contacts with meshes, and of rolling [J]
};
} // namespace wall_bench
