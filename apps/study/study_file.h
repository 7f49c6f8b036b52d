// The study file: a base case, what is varied, fillings, and what is read off the runs. What each
// entry means: docs/studies.md.
#pragma once

#include "apps/study/levels.h"

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
// What is read off the force over displacement of a pull-out.
struct MeasureOptions {
  std::vector<double> forces_at; // displacements [m]
  double mean_over = 0;          // length of the centred mean of a force [m]
  double stiffness_over = 0;     // way within which it is looked for [m]
  double fluctuation_from = 0;   // share of the way
};

struct StudyFile {
  std::filesystem::path file;
  std::filesystem::path base_case;
  std::string design;                // grid, one at a time, latin hypercube, sobol
  int samples = 0;                   // of a hypercube, of Sobol's matrices
  std::uint64_t seed = 1;            // of these
  Factor fillings;                   // values of the entry that draws a filling; one at least
  std::string start_from;            // nothing, placed, packed
  std::vector<std::string> refilled; // keys of entries for whose values the box is filled anew
  int ranks_per_run = 1;
  double confidence = 0.95; // of the intervals
  MeasureOptions measures;
  std::vector<Assignment> fixed; // entries of all runs
  std::vector<Factor> factors;
};

// Throws InputError that names all errors of the study file itself, one sentence a line.
StudyFile read_study_file(const std::filesystem::path& file);
} // namespace interlock::apps
