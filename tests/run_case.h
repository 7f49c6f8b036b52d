// A whole run of an experiment in a folder, as the program makes it.
#pragma once

#include "coupling/output/summary.h"
#include "coupling/run/run.h"

#include <filesystem>
#include <string>
#include <vector>

// The warnings of a run but those about its clumps: tests make them of few spheres, to be quick,
// and such clumps are in pieces and miss much of their stones' volume.
template <class Warnings> std::vector<std::string> warnings_beside_clumps(const Warnings& warnings)
{
  std::vector<std::string> others;
  for (const std::string& warning : warnings)
    if (warning.find(" in pieces, groups of spheres") == std::string::npos &&
        warning.find(" clumps are off by more than ") == std::string::npos)
      others.push_back(warning);
  return others;
}

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
