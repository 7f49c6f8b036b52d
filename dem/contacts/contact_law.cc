#include "dem/contacts/contact_law.h"

namespace interlock::dem
{
ContactProperties hertz_mindlin_pair(const Elastic& a, const Elastic& b, double friction,
                                     double damping_ratio)
{
  const auto compliance = [](const Elastic& m) {
    return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  };
  const auto shear_compliance = [](const Elastic& m) {
    return (2 - m.poisson_ratio) * 2 * (1 + m.poisson_ratio) / m.youngs_modulus;
  };
  ContactProperties pair;
  pair.model = ContactModel::hertz_mindlin;
  pair.effective_modulus = 1 / (compliance(a) + compliance(b));
  pair.effective_shear_modulus = 1 / (shear_compliance(a) + shear_compliance(b));
  pair.friction = friction;
  pair.damping_ratio = damping_ratio;
  return pair;
}

double damping_ratio_for_restitution(double restitution)
{
  const double l = std::log(restitution);
  return -l / std::sqrt(M_PI * M_PI + l * l);
}

TangentStiffness tangent_stiffness(const ContactProperties& pair, double overlap,
                                   double reduced_radius)
{
  if (pair.model == ContactModel::linear) return {pair.normal_stiffness, pair.tangential_stiffness};
  const double root = std::sqrt(reduced_radius * std::max(0., overlap));
  return {2 * pair.effective_modulus * root, 8 * pair.effective_shear_modulus * root};
}

double stored_energy(const ContactProperties& pair, double overlap, double reduced_radius,
                     double spring, const ContactShare& last_share)
{
  // A share may be left over from before the properties were changed.
  const ContactShare share = pair.share_among_contacts ? last_share : ContactShare();
  const double depth = share.depth > 0 ? share.depth : overlap;
  const double root = std::sqrt(reduced_radius * depth);
  const bool linear = pair.model == ContactModel::linear;
  const double normal = linear ? 0.5 * pair.normal_stiffness * depth
                               : 8. / 15 * pair.effective_modulus * root * depth;
  const double k_t = linear ? pair.tangential_stiffness : 8 * pair.effective_shear_modulus * root;
  return share.gradient * normal * overlap +
         std::max(0., share.gradient) * 0.5 * k_t * spring * spring;
}
} // namespace interlock::dem
