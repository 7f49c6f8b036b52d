// The experiments that `interlock run` knows: what `set Experiment = NAME` chooses from. A new one
// is its parameters in the variant and one row in experiments.cc.
#pragma once

#include "coupling/heap/heap_parameters.h"
#include "coupling/laboratory/laboratory_parameters.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"
#include "coupling/packing/packing_parameters.h"
#include "coupling/parameters/parameter_table.h"
#include "coupling/pull_out/pull_out_checks.h"
#include "coupling/pull_out/pull_out_parameters.h"
#include "coupling/run/forecast.h"
#include "coupling/run/run_request.h"
#include "coupling/shear_box/shear_box_parameters.h"
#include "coupling/triaxial/triaxial_parameters.h"

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace interlock::apps
{
using ExperimentParameters =
    std::variant<coupling::PullOutParameters, coupling::HeapParameters, coupling::PackingParameters,
                 coupling::LaboratoryParameters, coupling::ShearBoxParameters,
                 coupling::TriaxialParameters>;

// An experiment that has accepted its parameters. Writes its files into the folder of the request,
// which must exist.
using ReadyExperiment = std::function<coupling::Summary(const coupling::RunRequest& request)>;

struct Experiment {
  std::string name;
  const char* template_text;     // of `interlock template NAME`: a documented case
  ExperimentParameters defaults; // holds the parameters of this experiment
  // Binds the entries of its parameter file to the parameters, which must outlive the table.
  std::function<void(coupling::ParameterTable&, ExperimentParameters&)> declare;
  // What no single entry's range can tell.
  std::function<std::vector<coupling::ParameterProblem>(const ExperimentParameters&)> check;
  // Throws InputError when the parameters cannot be run; writes nothing. Of the request it heeds
  // what the folder need not exist for: entries, resume, monitor.
  std::function<ReadyExperiment(const ExperimentParameters&, const coupling::RunRequest&)> prepare;
  // What a run would take; throws as `prepare`.
  std::function<coupling::Forecast(const ExperimentParameters&, const coupling::RunRequest&)>
      forecast;
  std::function<bool(const ExperimentParameters&)> draws_figures; // at the end of a run
  // Where a case may take its geogrid from a product file: the entry that names it, and the section
  // "Product" of that file or of the case. Null elsewhere.
  std::string product_entry;
  std::function<void(coupling::ParameterTable&, ExperimentParameters&)> declare_product;
};

const std::vector<Experiment>& experiments();

// Null when there is none of this name, present or former.
const Experiment* find_experiment(const std::string& name);

// What an experiment of a former name is called now; any other text as it is. Files and folders of
// users hold former names.
std::string present_name(const std::string& name);

std::vector<std::string> experiment_names();
} // namespace interlock::apps
