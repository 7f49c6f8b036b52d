// What a callback is shown: the stones of a run between two steps, as NumPy arrays without copies.
#pragma once

#include "apps/experiments.h"
#include "coupling/loop/world.h"

#include <pybind11/numpy.h>

#include <memory>
#include <string>

namespace interlock::python
{
namespace py = pybind11;

// Arrays look at the memory of the simulation, which the next step changes, and which moves when
// stones come. So a moment is over when the callback returns. An array that outlives it keeps the
// simulation alive, and end() finds it.
class Moment
{
public:
  // `progress` has a world, which is part of `simulation`.
  Moment(const coupling::Progress& progress, std::shared_ptr<apps::ReadyExperiment> simulation);

  const std::string stage;
  const double fraction, time; // of the stage [-]; simulated [s]
  const std::int64_t step;
  const int number, stages;
  const double time_step; // [s]

  // Throw std::runtime_error once the moment is over. Index: stone, ids ascending.
  py::array positions() const;       // (n, 3) of the centres of mass [m]
  py::array orientations() const;    // (n, 4) body to world (x, y, z, w)
  py::array velocities() const;      // (n, 3) half a step ago [m/s]
  py::array angular_momenta() const; // (n, 3) half a step ago [kg m2/s]
  py::array spins() const;           // (n, 3) of the last motion [rad/s]
  py::array forces() const;          // (n, 3) of all contacts, without gravity [N]
  py::array torques() const;         // (n, 3) about the centres of mass [N m]
  py::array masses() const;          // (n,) [kg]
  py::array ids() const;             // (n,)
  py::array shapes() const;          // (n,) number of the shape
  // Copies, or None before there is a geogrid.
  py::object geogrid_nodes() const; // (m, 3) of the nodes of its beams [m]
  py::object clamp_force() const;   // (3,) of the clamp on the geogrid, mean over the last step [N]
  int size() const { return clumps().size(); }

  // From now on it is over. False when somebody has kept an array.
  bool end();

private:
  const coupling::World& world() const;
  const dem::Clumps& clumps() const { return world().engine.clumps(); }

  const coupling::World* world_;
  py::object owner_; // a capsule that keeps the simulation alive
};

void add_moment(py::module_& module);
} // namespace interlock::python
