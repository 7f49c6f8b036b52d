// What a pair of materials brings to its contacts, and the energies that contacts keep and take.
#pragma once

namespace interlock::dem
{
enum class ContactModel { linear, hertz_mindlin };

// Of one pair of materials.
struct ContactProperties {
  ContactModel model = ContactModel::linear;
  // Of the linear model, of the pair [N/m].
  double normal_stiffness = 0;
  double tangential_stiffness = 0;
  // Of the Hertz-Mindlin model [Pa]: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2, 1/G* = (2-nu1)/G1 +
  // (2-nu2)/G2.
  double effective_modulus = 0;
  double effective_shear_modulus = 0;
  double friction = 0; // Coulomb coefficient [-]
  // Dashpots, normal and tangential: c / (2 sqrt(k m)) for the linear model; for Hertz-Mindlin the
  // ratio that gives the same restitution (damping_ratio_for_restitution) [-].
  double damping_ratio = 0;
  // Besides: dashpots of this rate times the reduced mass [1/s].
  double normal_damping_rate = 0;
  double tangential_damping_rate = 0;
  // Convention for the end of an impact: at zero force (no tension, the default), or at zero
  // overlap, with tension in between. The same damping ratio gives different restitution (Schwager
  // and Poeschel, Granular Matter 9 (2007) 465-469).
  bool tension = false;
  // Contacts of the same two clumps (or of a clump and a wall) share one stiffness and one dashpot
  // instead of bringing one each (docs/theory/engine.md).
  bool share_among_contacts = false;
  // Mean pressure at which the surfaces crush; 0: they never do. Granite: 3e8 to 7.5e8, three times
  // (Johnson 1985, section 6.2) an unconfined strength of 1e8 to 2.5e8; single crystals are an
  // order harder. That crushed contacts of granite go on at a constant stiffness is measured by
  // Altuhafi, Baudet and Coop, Granular Matter 26 (2024), doi 10.1007/s10035-024-01394-7. Not
  // together with shared contacts, and not at walls of triangles [Pa].
  double crushing_pressure = 0;
};

struct Elastic {
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
};
// Hertz-Mindlin properties of two elastic bodies.
ContactProperties hertz_mindlin_pair(const Elastic& a, const Elastic& b, double friction,
                                     double damping_ratio);

// -ln e / sqrt(pi^2 + ln^2 e): exact for impacts with tension, of either model. 0 < e <= 1.
double damping_ratio_for_restitution(double restitution);

// Tangent stiffnesses of one contact at this overlap [N/m].
struct TangentStiffness {
  double normal = 0, tangential = 0;
};
TangentStiffness tangent_stiffness(const ContactProperties& pair, double overlap,
                                   double reduced_radius);

// Springs in series [N/m].
inline double series_stiffness(double k1, double k2)
{
  return k1 * k2 / (k1 + k2);
}

// Running sums over contacts and steps [J]. `elastic` is the energy stored now; the others have
// gone since the beginning.
struct ContactEnergy {
  double elastic = 0;
  double friction = 0; // slip, and what tangential springs lose when they become softer
  double damping = 0;
  double crushing = 0; // work that permanent overlap has taken
};

template <class Archive> void exchange(Archive& archive, ContactProperties& pair)
{
  archive("model", pair.model);
  archive("normal_stiffness", pair.normal_stiffness, "N/m");
  archive("tangential_stiffness", pair.tangential_stiffness, "N/m");
  archive("effective_modulus", pair.effective_modulus, "Pa");
  archive("effective_shear_modulus", pair.effective_shear_modulus, "Pa");
  archive("friction", pair.friction);
  archive("damping_ratio", pair.damping_ratio);
  archive("normal_damping_rate", pair.normal_damping_rate, "1/s");
  archive("tangential_damping_rate", pair.tangential_damping_rate, "1/s");
  archive("tension", pair.tension);
  archive("share_among_contacts", pair.share_among_contacts);
  archive("crushing_pressure", pair.crushing_pressure, "Pa");
}
template <class Archive> void exchange(Archive& archive, ContactEnergy& energy)
{
  archive("elastic", energy.elastic, "J");
  archive("friction", energy.friction, "J");
  archive("damping", energy.damping, "J");
  archive("crushing", energy.crushing, "J");
}
} // namespace interlock::dem
