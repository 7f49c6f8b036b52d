#include "coupling/pull_out/rib_contact.h"

#include "coupling/parameters/geogrid_product.h"
#include "coupling/pull_out/geogrid_sheet.h"

#include <algorithm>
#include <limits>

namespace interlock::coupling
{
namespace
{
// The softer family of ribs, at small strains: what a drawn polymer has across its ribs is not
// known.
dem::Elastic surface_of(const fem::GeogridProduct& product)
{
  return {
      std::min(product.ribs_along.shape.youngs_modulus, product.ribs_across.shape.youngs_modulus),
      product.ribs_along.shape.poisson_ratio};
}

dem::ContactProperties elastic_stone_on_geogrid(const PullOutParameters& p)
{
  const StoneContactParameters& stone = p.contact;
  const GeogridContactParameters& rib = p.geogrid_contact;
  const double friction = pair_friction(rib.stone_friction, stone.stone_friction, rib.friction);
  if (rib.stiffness > 0)
    return linear_pair(stone.stone_stiffness, rib.stiffness, friction, stone.tangential_ratio,
                       rib.damping_ratio);
  // Stone is some twenty times as stiff as polymer: the rib alone is indented.
  const dem::Elastic rock{std::numeric_limits<double>::infinity(), 0};
  return dem::hertz_mindlin_pair(rock, surface_of(geogrid_product(p.geogrid)), friction,
                                 rib.damping_ratio);
}

// Against a wall [N/m].
double stiffness_of_ribs(const PullOutParameters& p)
{
  if (p.geogrid_contact.stiffness > 0) return p.geogrid_contact.stiffness;
  const fem::GeogridProduct product = geogrid_product(p.geogrid);
  const dem::Elastic rib = surface_of(product);
  const double width = std::min(product.ribs_along.shape.width, product.ribs_across.shape.width);
  return rib.youngs_modulus / (1 - rib.poisson_ratio * rib.poisson_ratio) * width;
}
} // namespace

dem::ContactProperties stone_on_geogrid(const PullOutParameters& p)
{
  dem::ContactProperties pair = elastic_stone_on_geogrid(p);
  pair.crushing_pressure = p.contact.crushing_pressure;
  return pair;
}

RibBox box_of_ribs(const PullOutParameters& p)
{
  RibBox box;
  box.length = p.box.length, box.width = p.box.width;
  const double middle = front_of_geogrid(p.geogrid, p.box).z();
  box.slot_bottom = middle - 0.5 * p.box.slot_height;
  box.slot_top = middle + 0.5 * p.box.slot_height;
  box.contact = linear_pair(p.contact.box_stiffness, stiffness_of_ribs(p),
                            pair_friction(-1, p.contact.box_friction, p.geogrid_contact.friction),
                            p.contact.tangential_ratio, p.geogrid_contact.damping_ratio);
  return box;
}
} // namespace interlock::coupling
