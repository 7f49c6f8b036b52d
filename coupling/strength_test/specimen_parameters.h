// What both strength tests read from their parameter files about the stones, until something is
// moved. SI units. The comment beside each member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/filling_parameters.h"
#include "coupling/parameters/output_parameters.h"
#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_parameters.h"
#include "coupling/parameters/time_step.h"

#include <string>

namespace interlock::coupling
{
struct SpecimenParameters {
  double gravity = 9.81; // along -z [m/s2]
  StoneParameters stones;
  BoxParameters box; // that the stones are poured into; without a slot
  StoneContactParameters contact;
  FillingParameters filling;
  // What the walls press with while the stones have the friction of the filling; 0: as in the test
  // [Pa].
  double compaction_stress = 0;
  TimeParameters time;
  LimitParameters limits;
};

// Declare the entries of `specimen`, which must outlive the table, in the sections up to Box, where
// a test may add entries, and in Load, with the `stress` of the test [Pa]. The texts say what an
// entry means in this test, with its unit.
void declare_stones_and_box(ParameterTable& table, SpecimenParameters& specimen,
                            const std::string& gravity, const std::string& length,
                            const std::string& height);
void declare_load(ParameterTable& table, SpecimenParameters& specimen, const std::string& name,
                  double& stress, const std::string& text, const std::string& compaction);

// The compaction against the stress of the test, which is called `name` in a sentence.
void check_compaction(const SpecimenParameters& specimen, double stress, const std::string& name,
                      ParameterProblems& problems);
} // namespace interlock::coupling
