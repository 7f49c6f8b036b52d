#include "coupling/parameters/stone_contact.h"

#include <algorithm>

namespace interlock::coupling
{
void declare_stone_contact(ParameterTable& table, StoneContactParameters& contact)
{
  table.open_section("Contact");
  table.require(
      "Stone stiffness", contact.stone_stiffness, positive,
      "Normal contact stiffness of a stone; two bodies act in series, k = k1 k2/(k1 + k2). "
      "[N/m]");
  table.require("Box stiffness", contact.box_stiffness, positive,
                "Normal contact stiffness of the walls and the plate. [N/m]");
  table.require("Stone friction", contact.stone_friction, friction_range,
                "Friction coefficient of the stones; a pair takes the smaller of its two. [-]");
  table.require("Box friction", contact.box_friction, friction_range,
                "Friction coefficient of the walls. [-]");
  table.offer("Stone on box friction", contact.stone_on_box_friction, -1, pair_friction_range,
              "Friction coefficient between stones and walls; -1: the smaller of the two. [-]");
  table.require("Tangential ratio", contact.tangential_ratio, {0, 2, false},
                "Tangential over normal contact stiffness. [-]");
  table.require("Damping ratio", contact.damping_ratio, damping_ratio_range,
                "Normal and tangential contact dashpots between stones and at walls, share of the "
                "critical damping. [-]");
  table.require(
      "Share among contacts", contact.share_among_contacts,
      "Contacts of the same two stones (or of a stone and a wall) share one stiffness and one "
      "dashpot, so that neither grows with the number of spheres.");
  declare_crushing(table, contact.crushing_pressure);
}

void declare_crushing(ParameterTable& table, double& pressure)
{
  table.offer("Crushing pressure", pressure, 0, not_negative,
              "Where the elastic force of a contact of a stone would pass this pressure times the "
              "area of the cut, 2 pi R d, the stone crushes and keeps a part of the overlap d for "
              "good; 0: never. Granite 3e8 to 7.5e8. [Pa]");
}

void check_crushing(double pressure, bool share_among_contacts, ParameterProblems& problems)
{
  if (pressure > 0 && share_among_contacts)
    problems.add("Contact/Crushing pressure",
                 "A contact that is shared cannot crush: set Crushing pressure = 0, or Share among "
                 "contacts = false.");
}

void check_pair_friction(const std::string& entry, double given, ParameterProblems& problems)
{
  if (given < 0 && given != -1)
    problems.add(entry, "It is ", given, ", but must be 0 or more, or -1 for not given.");
}

void check_stone_contact(const StoneContactParameters& contact, ParameterProblems& problems)
{
  check_crushing(contact.crushing_pressure, contact.share_among_contacts, problems);
  check_pair_friction("Contact/Stone on box friction", contact.stone_on_box_friction, problems);
}

double pair_friction(double given, double one, double other)
{
  return given >= 0 ? given : std::min(one, other);
}

dem::ContactProperties linear_pair(double k1, double k2, double friction, double tangential_ratio,
                                   double damping_ratio)
{
  dem::ContactProperties properties;
  properties.normal_stiffness = dem::series_stiffness(k1, k2);
  properties.tangential_stiffness = tangential_ratio * properties.normal_stiffness;
  properties.friction = friction;
  properties.damping_ratio = damping_ratio;
  return properties;
}

dem::ContactProperties stone_on_stone(const StoneContactParameters& c)
{
  dem::ContactProperties properties = linear_pair(
      c.stone_stiffness, c.stone_stiffness, c.stone_friction, c.tangential_ratio, c.damping_ratio);
  properties.share_among_contacts = c.share_among_contacts;
  properties.crushing_pressure = c.crushing_pressure;
  return properties;
}

dem::ContactProperties stone_on_box(const StoneContactParameters& c)
{
  dem::ContactProperties properties =
      linear_pair(c.stone_stiffness, c.box_stiffness,
                  pair_friction(c.stone_on_box_friction, c.stone_friction, c.box_friction),
                  c.tangential_ratio, c.damping_ratio);
  properties.share_among_contacts = c.share_among_contacts;
  properties.crushing_pressure = c.crushing_pressure;
  return properties;
}
} // namespace interlock::coupling
