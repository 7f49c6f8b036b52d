#include "python/cases.h"

#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/nearest_name.h"
#include "apps/output_folder.h"
#include "apps/parameter_file.h"
#include "coupling/run/machine_speed.h"
#include "python/python_run.h"

#include <pybind11/stl.h>

namespace interlock::python
{
namespace
{
// Name -> (value as text, unit, what is allowed, what it is).
py::dict entries_of(const apps::RunInput& input)
{
  py::dict entries;
  for (std::size_t i = 0; i < input.entries.size(); ++i) {
    const coupling::ParameterEntry& entry = input.descriptions[i];
    entries[py::str(input.entries[i].key)] =
        py::make_tuple(input.entries[i].value, entry.unit, entry.allowed, entry.sentence);
  }
  return entries;
}

py::dict dict_of(const coupling::Forecast& forecast)
{
  py::list stages;
  for (const coupling::StageForecast& stage : forecast.stages) {
    py::dict row;
    row["name"] = stage.name;
    row["simulated_time"] = stage.simulated_time;
    row["steps"] = forecast.steps(stage);
    row["processor_time"] = forecast.time(stage);
    stages.append(row);
  }
  py::dict result;
  result["stones"] = forecast.stones;
  result["warnings"] = forecast.warnings;
  result["clumps"] = forecast.clumps;
  result["spheres"] = forecast.spheres;
  result["time_step"] = forecast.time_step;
  result["stages"] = stages;
  result["memory"] = forecast.memory();
  result["disk"] = forecast.disk();
  return result;
}

py::dict forecast(const apps::RunInput& input)
{
  apps::start_mpi();
  coupling::RunRequest request;
  request.entries = input.kept;
  request.monitor.progress = [](const coupling::Progress&) {
    py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  coupling::Forecast expected;
  {
    py::gil_scoped_release others_may_run;
    expected = input.experiment->forecast(input.parameters, request);
    coupling::measure_machine(expected);
  }
  return dict_of(expected);
}

std::string run_case(const apps::RunInput& input, const std::string& folder, bool resume,
                     bool force, const std::string& resume_line, py::object callback, int every,
                     py::object screen)
{
  return run(input,
             {folder, resume, force, resume_line, std::move(callback), every, std::move(screen)});
}
} // namespace

void add_cases(py::module_& module)
{
  py::class_<apps::RunInput>(module, "CaseInput")
      .def("entries", &entries_of)
      .def("text", [](const apps::RunInput& input) { return input.used; })
      .def("experiment", [](const apps::RunInput& input) { return input.experiment->name; })
      .def("forecast", &forecast)
      .def("run", &run_case);
  module.def("read_case", [](const std::string& file, const std::vector<std::string>& changes) {
    return apps::read_parameter_file(file, changes);
  });
  module.def("default_folder",
             [](const std::string& file) { return apps::default_output_folder(file).string(); });
  module.def("nearest_name", &apps::nearest_name);
  module.def("stop_mpi", &apps::stop_mpi);
}
} // namespace interlock::python
