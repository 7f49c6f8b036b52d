// A whole run of an experiment in a folder, as the program makes it.
#pragma once

#include "coupling/output/summary.h"
#include "coupling/run/run.h"

#include <filesystem>

// `Experiment` is made of `parameters`; the folder must exist.
template <class Experiment, class Parameters>
interlock::coupling::Summary run_case(const Parameters& parameters,
                                      const std::filesystem::path& folder)
{
  using namespace interlock::coupling;
  RunRequest request;
  request.folder = folder;
  request.checkpoint_interval = 0;
  Experiment experiment(parameters);
  experiment.prepare(request.monitor, request.entries);
  const Summary summary = Run<Experiment>(experiment, request).run();
  write_summary(folder / "summary.json", summary);
  return summary;
}
