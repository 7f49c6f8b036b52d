// Contacts of stones with each other and with walls: linear springs of bodies in series. SI units.
// The comment beside each member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"
#include "dem/contacts/contact_properties.h"

namespace interlock::coupling
{
// Springs in series at a contact, k = k1 k2/(k1 + k2); friction of a pair is the smaller of the
// two.
struct StoneContactParameters {
  double stone_stiffness = 0;        // [N/m]
  double box_stiffness = 0;          // of walls and plates [N/m]
  double stone_friction = 0;         // [-]
  double box_friction = 0;           // [-]
  double stone_on_box_friction = -1; // of the pair, instead of the smaller one; -1: not given [-]
  double tangential_ratio = 0;       // k_t / k_n [-]
  double damping_ratio = 0;          // normal and tangential dashpot, share of critical [-]
  bool share_among_contacts = false; // ContactProperties, between stones and at walls
  double crushing_pressure = 0;      // ContactProperties, of stones at whatever they touch [Pa]
};

// Frictions of pairs are -1 where they are not given, see check_pair_friction.
const Range friction_range{0, 5, true}, pair_friction_range{-1, 5, true};
const Range damping_ratio_range{0, 1, true};

// Opens the section Contact and declares every member of `contact`, which must outlive the table.
void declare_stone_contact(ParameterTable& table, StoneContactParameters& contact);

// Declares Crushing pressure in the section Contact, which is open, behind Share among contacts.
void declare_crushing(ParameterTable& table, double& pressure);
// A contact that is shared cannot crush.
void check_crushing(double pressure, bool share_among_contacts, ParameterProblems& problems);
// What lies between -1 and 0 is a slip. `entry`: "Section/Name".
void check_pair_friction(const std::string& entry, double given, ParameterProblems& problems);
// Both, of the entries of `contact`.
void check_stone_contact(const StoneContactParameters& contact, ParameterProblems& problems);

// The friction of a pair: what was given for it, or, where that is negative, the smaller of the two
// [-].
double pair_friction(double given, double one, double other);

// Two bodies with these normal stiffnesses [N/m] in series.
dem::ContactProperties linear_pair(double k1, double k2, double friction, double tangential_ratio,
                                   double damping_ratio);

dem::ContactProperties stone_on_stone(const StoneContactParameters& contact);
dem::ContactProperties stone_on_box(const StoneContactParameters& contact);
} // namespace interlock::coupling
