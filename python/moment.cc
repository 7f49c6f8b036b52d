#include "python/moment.h"

#include "python/arrays.h"

namespace interlock::python
{
namespace
{
using Owner = std::shared_ptr<apps::ReadyExperiment>;

py::object capsule_of(Owner simulation)
{
  return py::capsule(new Owner(std::move(simulation)),
                     [](void* owner) { delete static_cast<Owner*>(owner); });
}
} // namespace

Moment::Moment(const coupling::Progress& progress, Owner simulation)
    : stage(progress.stage), fraction(progress.fraction), time(progress.simulated_time),
      step(progress.steps), number(progress.number), stages(progress.stages),
      time_step(progress.world->clock.dt), world_(progress.world),
      owner_(capsule_of(std::move(simulation)))
{
}

const coupling::World& Moment::world() const
{
  if (!world_)
    throw std::runtime_error("This moment of the run is over: take copies of what is needed later "
                             "while the callback has it.");
  return *world_;
}

py::array Moment::positions() const
{
  return view(clumps().position, owner_);
}
py::array Moment::orientations() const
{
  return view(clumps().orientation, owner_);
}
py::array Moment::velocities() const
{
  return view(clumps().velocity, owner_);
}
py::array Moment::angular_momenta() const
{
  return view(clumps().angular_momentum, owner_);
}
py::array Moment::spins() const
{
  return view(clumps().spin, owner_);
}
py::array Moment::forces() const
{
  return view(clumps().force, owner_);
}
py::array Moment::torques() const
{
  return view(clumps().torque, owner_);
}
py::array Moment::masses() const
{
  return view(clumps().mass, owner_);
}
py::array Moment::ids() const
{
  return view(clumps().id, owner_);
}
py::array Moment::shapes() const
{
  return view(clumps().shape, owner_);
}

py::object Moment::geogrid_nodes() const
{
  if (!world().geogrid()) return py::none();
  const coupling::RibTransfer& geogrid = *world().geogrid();
  std::vector<dem::Vector3> nodes;
  for (int node = 0; node < geogrid.lattice().n_nodes(); ++node)
    nodes.push_back(geogrid.dynamics().position(node));
  return array_of(nodes);
}

py::object Moment::clamp_force() const
{
  if (!world().geogrid()) return py::none();
  return array_of(std::vector<dem::Vector3>{world().geogrid()->clamp_force()}).attr("reshape")(3);
}

bool Moment::end()
{
  world_ = nullptr;
  const auto is_alone = [&] { return owner_.ref_count() == 1; };
  if (!is_alone()) py::module_::import("gc").attr("collect")(); // arrays in a cycle
  const bool nobody_kept_any = is_alone();
  owner_ = py::none();
  return nobody_kept_any;
}

void add_moment(py::module_& module)
{
  py::class_<Moment, std::shared_ptr<Moment>>(
      module, "Moment",
      "The stones of a run between two steps, n of them, world frame, SI units. Arrays are "
      "read-only "
      "views of the simulation's own memory, without copies, and valid while the callback has the "
      "moment: copy what is to be kept.")
      .def_readonly("stage", &Moment::stage, "Name of the stage.")
      .def_readonly("fraction", &Moment::fraction,
                    "Of the stage that is done, 0 to 1; negative where nobody can tell.")
      .def_readonly("time", &Moment::time, "Simulated time [s]. Positions belong to it.")
      .def_readonly("step", &Moment::step, "Steps since the start of the run.")
      .def_readonly("number", &Moment::number, "Of the stage, from 1.")
      .def_readonly("stages", &Moment::stages, "How many stages there are.")
      .def_readonly("time_step", &Moment::time_step, "[s].")
      .def_property_readonly("positions", &Moment::positions, "(n, 3) centres of mass [m].")
      .def_property_readonly("orientations", &Moment::orientations,
                             "(n, 4) rotations from body to world frame, x, y, z, w.")
      .def_property_readonly("velocities", &Moment::velocities, "(n, 3) half a step ago [m/s].")
      .def_property_readonly("angular_momenta", &Moment::angular_momenta,
                             "(n, 3) about the centres of mass, half a step ago [kg m2/s].")
      .def_property_readonly("spins", &Moment::spins,
                             "(n, 3) angular velocities of the last motion [rad/s].")
      .def_property_readonly("forces", &Moment::forces,
                             "(n, 3) of all contacts at the last step, without gravity [N].")
      .def_property_readonly("torques", &Moment::torques, "(n, 3) about the centres of mass [N m].")
      .def_property_readonly("masses", &Moment::masses, "(n,) [kg].")
      .def_property_readonly("ids", &Moment::ids, "(n,) ascending; a stone keeps its id.")
      .def_property_readonly("shapes", &Moment::shapes, "(n,) number of the shape of each stone.")
      .def_property_readonly(
          "geogrid_nodes", &Moment::geogrid_nodes,
          "(m, 3) nodes of the beams [m], a copy; None before there is a geogrid.")
      .def_property_readonly("clamp_force", &Moment::clamp_force,
                             "(3,) force of the clamp on the geogrid, mean over the last step [N], "
                             "a copy; None before there is one.")
      .def("__len__", &Moment::size);
}
} // namespace interlock::python
