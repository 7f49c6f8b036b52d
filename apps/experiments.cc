#include "apps/experiments.h"

#include "apps/case_templates.h"
#include "coupling/heap/heap.h"
#include "coupling/heap/heap_declarations.h"
#include "coupling/laboratory/laboratory.h"
#include "coupling/laboratory/laboratory_declarations.h"
#include "coupling/packing/packing.h"
#include "coupling/packing/packing_declarations.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/pull_out/pull_out_declarations.h"

#include <algorithm>
#include <memory>

namespace interlock::apps
{
namespace
{
// A row of the table from functions that know their own parameters only. `Simulation` is made of
// parameters and monitor, and has `Summary run(output)`.
template <class Simulation, class Parameters>
Experiment row(const std::string& name, const char* template_text,
               void (*declare)(coupling::ParameterTable&, Parameters&),
               std::vector<coupling::ParameterProblem> (*check)(const Parameters&),
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
  experiment.prepare = [=](const ExperimentParameters& p, const coupling::Monitor& monitor) {
    auto simulation = std::make_shared<Simulation>(mine(p), monitor);
    return [simulation](const std::filesystem::path& output) { return simulation->run(output); };
  };
  experiment.draws_figures = [=](const ExperimentParameters& p) { return draws_figures(mine(p)); };
  return experiment;
}
} // namespace

const std::vector<Experiment>& experiments()
{
  static const std::vector<Experiment> table = {
      row<coupling::PullOut, coupling::PullOutParameters>(
          "pull-out", pull_out_template(), coupling::declare_pull_out, coupling::check_pull_out,
          [](const coupling::PullOutParameters& p) { return p.output.report; }),
      row<coupling::Heap, coupling::HeapParameters>(
          "heap", heap_template(), coupling::declare_heap, coupling::check_heap,
          [](const coupling::HeapParameters& p) { return p.output.report; }),
      row<coupling::Packing, coupling::PackingParameters>(
          "packing", packing_template(), coupling::declare_packing, coupling::check_packing,
          [](const coupling::PackingParameters&) { return false; }),
      row<coupling::Laboratory, coupling::LaboratoryParameters>(
          "laboratory", laboratory_template(), coupling::declare_laboratory,
          coupling::check_laboratory,
          [](const coupling::LaboratoryParameters& p) { return p.report; }),
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
