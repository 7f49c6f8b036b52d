// The contact model of an experiment: linear springs, or Hertz and Mindlin from elastic constants.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"
#include "coupling/parameters/time_step.h"
#include "dem/engine/engine.h"

namespace interlock::coupling
{
// Of stones, walls and floor alike.
struct ContactModelParameters {
  std::string model = "linear";      // linear | hertz-mindlin
  double youngs_modulus = 0;         // hertz-mindlin [Pa]
  double poisson_ratio = 0;          // hertz-mindlin [-]
  double damping_ratio = 0;          // dashpots, share of critical [-]
  bool share_among_contacts = false; // dem::ContactProperties
  double crushing_pressure = 0;      // dem::ContactProperties [Pa]

  bool linear() const { return model == "linear"; }
};

// Declares every member of `model`, which must outlive the table, in the section that is open.
void declare_contact_model(ParameterTable& table, ContactModelParameters& model);

// With hertz-mindlin, elastic constants and the time step must be given.
void check_contact_model(const ContactModelParameters& model, const TimeParameters& time,
                         ParameterProblems& problems);

// Properties of a pair. The stiffnesses [N/m] are those of the linear model, and without meaning
// for the other one.
dem::ContactProperties contact_pair(const ContactModelParameters& model, double normal_stiffness,
                                    double tangential_stiffness, double friction);

// The step of a run before there are contacts: choose_time_step() for the linear model, else the
// one that was given.
double choose_time_step(const ContactModelParameters& model, const TimeParameters& time,
                        const dem::Engine& engine, const std::vector<double>& densities);
} // namespace interlock::coupling
