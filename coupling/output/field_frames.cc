#include "coupling/output/field_frames.h"

#include "coupling/output/lattice_output.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

void append(std::vector<double>& values, const Vector3& v)
{
  values.insert(values.end(), {v.x(), v.y(), v.z()});
}

OutputField field(const std::string& name, const std::string& unit, FieldSupport support,
                  int components)
{
  OutputField result;
  result.name = name;
  result.unit = unit;
  result.support = support;
  result.components = components;
  return result;
}
} // namespace

FieldFrames::FieldFrames(const std::filesystem::path& folder)
    : clumps_(folder / "clumps", FieldSeries::Topology::points),
      geogrid_(folder / "geogrid", FieldSeries::Topology::lines),
      contacts_(folder / "contacts", FieldSeries::Topology::lines)
{
}

void FieldFrames::start()
{
  for (FieldSeries* series : {&clumps_, &geogrid_, &contacts_}) series->start();
  first_id_.clear();
  first_position_.resize(0);
}

void FieldFrames::rewind()
{
  for (FieldSeries* series : {&clumps_, &geogrid_, &contacts_}) series->rewind();
}

void FieldFrames::write(double time, const dem::Engine& engine, const StaggeredStep& loop)
{
  write_clumps(time, engine);
  if (loop.geogrid()) write_geogrid(time, *loop.geogrid());
  write_contacts(time, engine, loop.rib_contacts().contacts());
}

void FieldFrames::write(double time, const dem::Engine& engine)
{
  write_clumps(time, engine);
  write_contacts(time, engine, {});
}

void FieldFrames::write_clumps(double time, const dem::Engine& engine)
{
  const dem::Clumps& clumps = engine.clumps();
  if (first_id_.empty()) {
    first_id_ = clumps.id;
    first_position_ = clumps.position;
  }
  std::vector<double> points;
  OutputField radius = field("radius", "m", FieldSupport::points, 1);
  OutputField id = field("clump", "-", FieldSupport::points, 1);
  OutputField velocity = field("velocity", "m/s", FieldSupport::points, 3);
  OutputField displacement = field("displacement", "m", FieldSupport::points, 3);
  for (int i = 0; i < clumps.size(); ++i) {
    const auto first = std::lower_bound(first_id_.begin(), first_id_.end(), clumps.id[i]);
    const bool known = first != first_id_.end() && *first == clumps.id[i];
    const Vector3 moved =
        known ? Vector3(clumps.position[i] - first_position_[first - first_id_.begin()])
              : Vector3::Zero();
    for (std::size_t a = 0; a < clumps.shape_of(i).spheres.size(); ++a) {
      append(points, clumps.position[i] + clumps.member_offset(i, a));
      radius.values.push_back(clumps.shape_of(i).spheres[a].radius);
      id.values.push_back(static_cast<double>(clumps.id[i]));
      append(velocity.values, clumps.velocity[i]);
      append(displacement.values, moved);
    }
  }
  clumps_.write(time, points, {}, {radius, id, velocity, displacement});
}

void FieldFrames::write_geogrid(double time, const RibTransfer& geogrid)
{
  const fem::Lattice& lattice = geogrid.lattice();
  const fem::ExplicitDynamics& dynamics = geogrid.dynamics();
  LatticeFields frame = lattice_fields(
      lattice, [&](int node) { return dynamics.position(node); },
      [&](int e) { return dynamics.section_forces(e); });
  frame.fields.front().name = "displacement_from_unloaded";
  OutputField velocity = field("velocity", "m/s", FieldSupport::points, 3);
  for (int node = 0; node < lattice.n_nodes(); ++node)
    append(velocity.values, dynamics.velocity(node));
  // Both in single precision: where nothing has moved, zero.
  OutputField displacement = field("displacement", "m", FieldSupport::points, 3);
  const std::vector<float> now(frame.points.begin(), frame.points.end());
  const std::vector<float>& first = geogrid_.frames() > 0 ? geogrid_.first_points() : now;
  for (std::size_t k = 0; k < now.size(); ++k) displacement.values.push_back(now[k] - first.at(k));
  frame.fields.insert(frame.fields.begin(), {displacement, velocity});
  geogrid_.write(time, frame.points, frame.lines, frame.fields);
}

void FieldFrames::write_contacts(double time, const dem::Engine& engine,
                                 const std::vector<dem::RibContact>& rib_contacts)
{
  const dem::Clumps& clumps = engine.clumps();
  std::vector<double> points;
  std::vector<int> lines;
  OutputField force = field("force", "N", FieldSupport::cells, 1);
  OutputField kind = field("kind", "-", FieldSupport::cells, 1);
  OutputField body = field("body", "-", FieldSupport::points, 1);
  OutputField force_on_body = field("force_on_body", "N", FieldSupport::points, 3);
  // Of clump i, `on_clump` is the force on it.
  auto add = [&](int i, const Vector3& to, const Vector3& on_clump, double what, double partner) {
    const int n = static_cast<int>(points.size() / 3);
    append(points, clumps.position[i]);
    append(points, to);
    lines.insert(lines.end(), {n, n + 1});
    force.values.push_back(on_clump.norm());
    kind.values.push_back(what);
    body.values.insert(body.values.end(), {static_cast<double>(clumps.id[i]), partner});
    append(force_on_body.values, on_clump);
    append(force_on_body.values, -on_clump);
  };
  for (const dem::SphereContact& c : engine.sphere_contacts())
    if (c.touching) add(c.i, clumps.position[c.j], c.force, 0, static_cast<double>(clumps.id[c.j]));
  for (const dem::WallContact& c : engine.wall_contacts())
    if (c.touching) add(c.i, c.point, c.force, 1, engine.walls()[c.wall].id);
  for (const dem::RibContact& c : rib_contacts)
    if (c.overlap > 0) add(c.i, c.point, c.force, 2, c.rib);
  contacts_.write(time, points, lines, {force, kind, body, force_on_body});
}
} // namespace interlock::coupling
