#include "coupling/parameters/contact_model.h"

#include "coupling/parameters/stone_contact.h"

namespace interlock::coupling
{
void declare_contact_model(ParameterTable& table, ContactModelParameters& model)
{
  table.require_choice("Model", model.model, {"linear", "hertz-mindlin"},
                       "Linear springs, or Hertz's and Mindlin's stiffnesses from the radii of the "
                       "two spheres and the elastic constants.");
  table.offer("Youngs modulus", model.youngs_modulus, 0, not_negative,
              "Young's modulus of stones and walls; needed with hertz-mindlin. [Pa]");
  table.offer("Poisson ratio", model.poisson_ratio, 0.25, {0, 0.5, true},
              "Poisson's ratio of stones and walls, for hertz-mindlin. [-]");
  table.require("Damping ratio", model.damping_ratio, {0, 1, true},
                "Normal and tangential contact dashpots, share of the critical damping. [-]");
  table.require(
      "Share among contacts", model.share_among_contacts,
      "Contacts of the same two stones (or of a stone and a wall) share one stiffness and "
      "one dashpot, so that neither grows with the number of spheres.");
  declare_crushing(table, model.crushing_pressure);
}

void check_contact_model(const ContactModelParameters& model, const TimeParameters& time,
                         ParameterProblems& problems)
{
  check_crushing(model.crushing_pressure, model.share_among_contacts, problems);
  if (model.linear()) return;
  if (model.youngs_modulus <= 0)
    problems.add("Contact/Youngs modulus",
                 "Young's modulus must be given with hertz-mindlin contacts, for example 5e10 Pa.");
  if (time.step <= 0)
    problems.add("Time/Step", "The time step must be given with hertz-mindlin contacts, whose "
                              "stiffness is not known before they are loaded; the run compares it "
                              "with the stable step.");
}

dem::ContactProperties contact_pair(const ContactModelParameters& model, double normal_stiffness,
                                    double tangential_stiffness, double friction)
{
  dem::ContactProperties pair;
  if (!model.linear()) {
    const dem::Elastic stone{model.youngs_modulus, model.poisson_ratio};
    pair = dem::hertz_mindlin_pair(stone, stone, friction, model.damping_ratio);
  } else {
    pair.normal_stiffness = normal_stiffness;
    pair.tangential_stiffness = tangential_stiffness;
    pair.friction = friction;
    pair.damping_ratio = model.damping_ratio;
  }
  pair.share_among_contacts = model.share_among_contacts;
  pair.crushing_pressure = model.crushing_pressure;
  return pair;
}

double choose_time_step(const ContactModelParameters& model, const TimeParameters& time,
                        const dem::Engine& engine, const std::vector<double>& densities)
{
  if (!model.linear()) return time.step;
  return choose_time_step(time, engine.expected_stable_step(densities, expected_contacts));
}
} // namespace interlock::coupling
