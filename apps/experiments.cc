#include "apps/experiments.h"

#include "apps/case_templates.h"
#include "apps/run_cost.h"
#include "coupling/heap/heap.h"
#include "coupling/heap/heap_declarations.h"
#include "coupling/heap/heap_forecast.h"
#include "coupling/laboratory/laboratory.h"
#include "coupling/laboratory/laboratory_declarations.h"
#include "coupling/packing/packing.h"
#include "coupling/packing/packing_declarations.h"
#include "coupling/packing/packing_forecast.h"
#include "coupling/parameters/product_declarations.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/pull_out/pull_out_declarations.h"
#include "coupling/pull_out/pull_out_forecast.h"
#include "coupling/run/machine_speed.h"
#include "coupling/run/run.h"
#include "coupling/shear_box/shear_box.h"
#include "coupling/shear_box/shear_box_declarations.h"
#include "coupling/triaxial/triaxial.h"
#include "coupling/triaxial/triaxial_declarations.h"
#include "dem/input_error.h"

#include <algorithm>
#include <memory>

namespace interlock::apps
{
namespace
{
// An experiment that runs through stages (coupling/run/run.h).
template <class Simulation, class Parameters>
ReadyExperiment staged(const Parameters& parameters, double checkpoint_interval,
                       const coupling::RunRequest& request)
{
  auto simulation = std::make_shared<Simulation>(parameters);
  std::vector<double> stage_times;
  if (!request.resume) {
    simulation->prepare(request.monitor, request.entries);
    coupling::Forecast expected = forecast(*simulation);
    coupling::measure_machine(expected);
    if (request.monitor.message)
      request.monitor.message(cost_text(expected, request.ranks ? request.ranks->size() : 1));
    for (const coupling::StageForecast& stage : expected.stages)
      stage_times.push_back(expected.time(stage));
  }
  return [=](coupling::RunRequest run) {
    run.checkpoint_interval = checkpoint_interval;
    run.stage_times = stage_times;
    return coupling::Run<Simulation>(*simulation, run).run();
  };
}

ReadyExperiment pull_out(const coupling::PullOutParameters& p, const coupling::RunRequest& request)
{
  return staged<coupling::PullOut>(p, p.output.checkpoint_interval, request);
}

ReadyExperiment heap(const coupling::HeapParameters& p, const coupling::RunRequest& request)
{
  return staged<coupling::Heap>(p, p.output.checkpoint_interval, request);
}

ReadyExperiment shear_box(const coupling::ShearBoxParameters& p,
                          const coupling::RunRequest& request)
{
  return staged<coupling::ShearBox>(p, p.output.checkpoint_interval, request);
}

ReadyExperiment triaxial(const coupling::TriaxialParameters& p, const coupling::RunRequest& request)
{
  return staged<coupling::Triaxial>(p, p.output.checkpoint_interval, request);
}

// Nothing but the end of a stage interrupts what is timed.
ReadyExperiment packing(const coupling::PackingParameters& p, const coupling::RunRequest& request)
{
  coupling::PackingParameters mine = p;
  if (!request.writes) mine.state.written.clear(); // another rank writes it
  return staged<coupling::Packing>(mine, 0, request);
}

// Solves for equilibrium: there is no state to go on from but the last test that ended.
ReadyExperiment laboratory(const coupling::LaboratoryParameters& p,
                           const coupling::RunRequest& request)
{
  if (request.resume)
    throw InputError("The experiment \"laboratory\" keeps no state to resume from; start it anew.");
  if (request.ranks)
    throw InputError("The experiment \"laboratory\" runs on one rank; start it without mpirun.");
  auto simulation = std::make_shared<coupling::Laboratory>(p, request.monitor);
  return [=](const coupling::RunRequest& run) { return simulation->run(run.folder); };
}

// What a run of an experiment with stages would take.
template <class Simulation, class Parameters>
coupling::Forecast forecast_of(const Parameters& parameters, const coupling::RunRequest& request)
{
  Simulation simulation(parameters);
  simulation.prepare(request.monitor, request.entries);
  return forecast(simulation);
}

coupling::Forecast packing_forecast(const coupling::PackingParameters& parameters,
                                    const coupling::RunRequest& request)
{
  coupling::PackingParameters p = parameters;
  p.state.written.clear(); // a forecast writes nothing
  return forecast_of<coupling::Packing>(p, request);
}

// Equilibria have no steps in time: there is nothing to add to what the constructor checks.
coupling::Forecast laboratory_forecast(const coupling::LaboratoryParameters& p,
                                       const coupling::RunRequest& request)
{
  const coupling::Laboratory simulation(p, request.monitor);
  return {};
}

// A row of the table from functions that know their own parameters only.
template <class Parameters>
Experiment row(const std::string& name, const char* template_text,
               void (*declare)(coupling::ParameterTable&, Parameters&),
               std::vector<coupling::ParameterProblem> (*check)(const Parameters&),
               ReadyExperiment (*prepare)(const Parameters&, const coupling::RunRequest&),
               coupling::Forecast (*forecast)(const Parameters&, const coupling::RunRequest&),
               bool (*draws_figures)(const Parameters&))
{
  const auto mine = [](const ExperimentParameters& p) -> const Parameters& {
    return std::get<Parameters>(p);
  };
  Experiment experiment;
  experiment.name = name;
  experiment.template_text = template_text;
  experiment.defaults = Parameters();
  experiment.declare = [=](coupling::ParameterTable& table, ExperimentParameters& p) {
    declare(table, std::get<Parameters>(p));
  };
  experiment.check = [=](const ExperimentParameters& p) { return check(mine(p)); };
  experiment.prepare = [=](const ExperimentParameters& p, const coupling::RunRequest& request) {
    return prepare(mine(p), request);
  };
  experiment.forecast = [=](const ExperimentParameters& p, const coupling::RunRequest& request) {
    return forecast(mine(p), request);
  };
  experiment.draws_figures = [=](const ExperimentParameters& p) { return draws_figures(mine(p)); };
  return experiment;
}

Experiment with_product(Experiment experiment)
{
  experiment.product_entry = "Geogrid/Product";
  experiment.declare_product = [](coupling::ParameterTable& table, ExperimentParameters& p) {
    coupling::declare_product(table,
                              std::get<coupling::PullOutParameters>(p).geogrid.product.emplace());
  };
  return experiment;
}
} // namespace

const std::vector<Experiment>& experiments()
{
  static const std::vector<Experiment> table = {
      with_product(row<coupling::PullOutParameters>(
          "pull-out", pull_out_template(), coupling::declare_pull_out, coupling::check_pull_out,
          pull_out, forecast_of<coupling::PullOut>,
          [](const coupling::PullOutParameters& p) { return p.output.report; })),
      row<coupling::HeapParameters>(
          "heap", heap_template(), coupling::declare_heap, coupling::check_heap, heap,
          forecast_of<coupling::Heap>,
          [](const coupling::HeapParameters& p) { return p.output.report; }),
      row<coupling::PackingParameters>("packing", packing_template(), coupling::declare_packing,
                                       coupling::check_packing, packing, packing_forecast,
                                       [](const coupling::PackingParameters&) { return false; }),
      row<coupling::LaboratoryParameters>(
          "laboratory", laboratory_template(), coupling::declare_laboratory,
          coupling::check_laboratory, laboratory, laboratory_forecast,
          [](const coupling::LaboratoryParameters& p) { return p.report; }),
      row<coupling::ShearBoxParameters>(
          "shear box", shear_box_template(), coupling::declare_shear_box, coupling::check_shear_box,
          shear_box, forecast_of<coupling::ShearBox>,
          [](const coupling::ShearBoxParameters& p) { return p.output.report; }),
      row<coupling::TriaxialParameters>(
          "triaxial", triaxial_template(), coupling::declare_triaxial, coupling::check_triaxial,
          triaxial, forecast_of<coupling::Triaxial>,
          [](const coupling::TriaxialParameters& p) { return p.output.report; }),
  };
  return table;
}

const Experiment* find_experiment(const std::string& name)
{
  const std::string present = present_name(name);
  const auto& table = experiments();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Experiment& e) { return e.name == present; });
  return found == table.end() ? nullptr : &*found;
}

std::string present_name(const std::string& name)
{
  return name == "geogrid" ? "laboratory" : name;
}

std::vector<std::string> experiment_names()
{
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments()) names.push_back(experiment.name);
  return names;
}
} // namespace interlock::apps
