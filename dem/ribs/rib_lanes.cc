#include "dem/ribs/rib_lanes.h"

#include "dem/bodies/field_rows.h"
#include "dem/ribs/rod_lanes.h"

namespace interlock::dem
{
namespace
{
void resize_index(std::vector<std::int64_t>& index, int n)
{
  index.resize(padded(n));
  std::fill(index.begin() + n, index.end(), 0);
}

// What the loops read of the rods.
struct RodReader {
  RodReader(const RibSet& ribs, const RodRows& rows)
      : position(ribs.position), velocity(ribs.velocity), spin(ribs.spin), rotation(ribs.rotation),
        end(rows.end.data()), axis1(rows.axis1), axis2(rows.axis2),
        core_width(rows.core_width.row(0)), core_thickness(rows.core_thickness.row(0)),
        rounding(rows.rounding.row(0)), inverse_mass1(rows.inverse_mass1.row(0)),
        inverse_mass2(rows.inverse_mass2.row(0))
  {
  }
  INTERLOCK_LANE RodLane rod(std::int64_t k) const
  {
    const std::int64_t e = end[k];
    return {position.get(e),
            position.get(e + 1),
            rotate(rotation.get(e), axis1.get(k)),
            rotate(rotation.get(e + 1), axis2.get(k)),
            core_width[k],
            core_thickness[k],
            rounding[k]};
  }
  INTERLOCK_LANE RodMotionLane motion(std::int64_t k) const
  {
    const std::int64_t e = end[k];
    return {velocity.get(e), velocity.get(e + 1), spin.get(e), spin.get(e + 1)};
  }
  Rows3<const double> position, velocity, spin;
  QuaternionRows<const double> rotation;
  const std::int64_t* __restrict end;
  Rows3<const double> axis1, axis2;
  const double* __restrict core_width, * __restrict core_thickness, * __restrict rounding;
  const double* __restrict inverse_mass1, * __restrict inverse_mass2;
};

struct PoseRows {
  template <class Bodies>
  explicit PoseRows(const Bodies& b) : position(b.position), attitude(b.orientation)
  {
  }
  // From the centre of mass to a point of the body, world axes.
  INTERLOCK_LANE Lane3 arm(std::int64_t i, Lane3 in_body) const
  {
    return rotate(attitude.get(i), in_body);
  }
  Rows3<const double> position;
  QuaternionRows<const double> attitude;
};

template <class Bodies> void measure(const Bodies& clumps, const RibSet& ribs, RodPairs& pairs)
{
  if (pairs.size() == 0) return;
  const PoseRows poses(clumps);
  const RodReader rods(ribs, pairs.rod);
  const Rows3<const double> centre(pairs.centre);
  const double* __restrict radius = pairs.radius.row(0);
  const std::int64_t* __restrict body = pairs.body.data();
  double* __restrict overlap = pairs.overlap.row(0);
  const int n = pairs.overlap.padded_size();
#pragma GCC ivdep
  for (std::int64_t k = 0; k < n; ++k) {
    const Lane3 sphere = poses.position.get(body[k]) + poses.arm(body[k], centre.get(k));
    overlap[k] = nearest_on_rod(rods.rod(k), sphere, radius[k]).overlap;
  }
}
} // namespace

void RodRows::resize(int n)
{
  resize_index(rib, n);
  resize_index(end, n);
  axis1.resize(n);
  axis2.resize(n);
  for (ScalarField* field :
       {&core_width, &core_thickness, &rounding, &inverse_mass1, &inverse_mass2})
    field->resize(n);
}

void RodRows::set(int k, int rod, const RibSet& ribs)
{
  const RibShape& shape = ribs.shape(rod);
  rib[k] = rod;
  end[k] = shape.first_end;
  axis1[k] = shape.width_axis[0];
  axis2[k] = shape.width_axis[1];
  core_width[k] = shape.half_width - shape.rounding;
  core_thickness[k] = shape.half_thickness - shape.rounding;
  rounding[k] = shape.rounding;
  inverse_mass1[k] = shape.inverse_mass[0];
  inverse_mass2[k] = shape.inverse_mass[1];
}

void RodPairs::resize(int n)
{
  resize_index(body, n);
  rod.resize(n);
  centre.resize(n);
  radius.resize(n);
  overlap.resize(n);
}

void RodPairs::set(int k, int body_of_sphere, const Sphere& sphere, int rod_of_lane,
                   const RibSet& ribs)
{
  body[k] = body_of_sphere;
  rod.set(k, rod_of_lane, ribs);
  centre[k] = sphere.centre;
  radius[k] = sphere.radius;
}

void measure_overlaps(const Clumps& clumps, const RibSet& ribs, RodPairs& pairs)
{
  measure(clumps, ribs, pairs);
}

void measure_overlaps(const SubcycledClumps& clumps, const RibSet& ribs, RodPairs& pairs)
{
  measure(clumps, ribs, pairs);
}

void RibLanes::resize(int n)
{
  resize_index(place, n);
  rod.resize(n);
  for (VectorField* field : {&centre, &spring, &dashpot, &point, &arm, &force, &push, &torque,
                             &rod_force1, &rod_force2, &rod_moment1, &rod_moment2})
    field->resize(n);
  for (ScalarField* field : {&radius, &depth, &overlap, &tangential_stiffness, &crushed, &xi,
                             &elastic, &friction, &damping, &crushing})
    field->resize(n);
}

namespace
{
template <class Law>
void evaluate(const SubcycledClumps& clumps, const RibSet& ribs, const Law& law_of_pair, double h,
              RibLanes& lanes)
{
  const Law law = law_of_pair;
  const PoseRows poses(clumps);
  const Rows3<const double> velocity(clumps.drift_velocity), spin(clumps.spin);
  const double* __restrict inverse_mass = clumps.inverse_mass.row(0);
  const RodReader rods(ribs, lanes.rod);
  const std::int64_t* __restrict place = lanes.place.data();
  const Rows3<const double> centre(lanes.centre);
  const double* __restrict radius = lanes.radius.row(0);
  const double* __restrict depth = lanes.depth.row(0);
  const Rows3<double> spring(lanes.spring), dashpot(lanes.dashpot), point_rows(lanes.point),
      arm_rows(lanes.arm), force_rows(lanes.force), push_rows(lanes.push), torque(lanes.torque);
  const Rows3<double> force1(lanes.rod_force1), force2(lanes.rod_force2),
      moment1(lanes.rod_moment1), moment2(lanes.rod_moment2);
  double* __restrict overlap = lanes.overlap.row(0);
  double* __restrict stiffness = lanes.tangential_stiffness.row(0);
  [[maybe_unused]] double* __restrict crushed = lanes.crushed.row(0);
  [[maybe_unused]] double* __restrict crushing = lanes.crushing.row(0);
  double* __restrict xi = lanes.xi.row(0);
  double* __restrict elastic = lanes.elastic.row(0);
  double* __restrict friction = lanes.friction.row(0);
  double* __restrict damping = lanes.damping.row(0);
  const int n = lanes.depth.padded_size();
#pragma GCC ivdep
  for (std::int64_t k = 0; k < n; ++k) {
    const std::int64_t i = place[k];
    const Lane3 stone = poses.position.get(i), to_sphere = poses.arm(i, centre.get(k));
    const Lane3 sphere = stone + to_sphere;
    const RodLane rod = rods.rod(k);
    const RodMotionLane motion = rods.motion(k);
    const RodNearest near = nearest_on_rod(rod, sphere, radius[k]);
    const RodTurning turning = turning_about_chord(rod, near);
    const Lane3 point = near.core + (rod.rounding - 0.5 * depth[k]) * near.normal;
    const Lane3 arm = point - near.centre, stone_arm = point - stone;

    const double n1 = 1 - near.xi, n2 = near.xi;
    const double reduced_mass =
        1 / (inverse_mass[i] + n1 * n1 * rods.inverse_mass1[k] + n2 * n2 * rods.inverse_mass2[k]);
    const Lane3 w = spin.get(i);
    const Lane3 of_rod =
        n1 * motion.v1 + n2 * motion.v2 + cross(spin_of_rod(near, turning, motion), arm);
    const Lane3 relative = (velocity.get(i) + cross(w, stone_arm)) - of_rod;
    const Lane3 turn = 0.5 * h * (w + n1 * motion.w1 + n2 * motion.w2);

    const ContactConstants constants{reduced_mass, std::sqrt(reduced_mass), radius[k]};
    LaneHistory history{spring.get(k), dashpot.get(k), overlap[k], stiffness[k], 0};
    if constexpr (Law::crushes) history.crushed = crushed[k];
    LaneEnergy energy;
    const Lane3 force = contact_force<false>(law, constants, depth[k], near.normal, relative, turn,
                                             {}, h, history, energy);
    spring.set(k, history.spring);
    dashpot.set(k, history.dashpot);
    overlap[k] = history.overlap;
    stiffness[k] = history.tangential_stiffness;
    elastic[k] = energy.elastic;
    friction[k] = energy.friction;
    damping[k] = energy.damping;
    double pressed = history.overlap; // what makes force
    if constexpr (Law::crushes) {
      crushed[k] = history.crushed;
      crushing[k] = energy.crushing;
      pressed = larger(history.overlap - history.crushed, 0);
    }

    // The part that comes from the lean acts at the sphere's centre, on which the overlap depends.
    const Lane3 lean = law.at(pressed, constants).force * near.lean;
    const Lane3 push = force + lean;
    xi[k] = near.xi;
    point_rows.set(k, point);
    arm_rows.set(k, arm);
    force_rows.set(k, force);
    push_rows.set(k, push);
    torque.set(k, cross(stone_arm, force) + cross(to_sphere, lean));
    const Lane3 moment = cross(arm, force) + cross(sphere - near.centre, lean);
    const RodLoadsLane loads = loads_on_rod(near, turning, -1. * push, -1. * moment);
    force1.set(k, loads.force1);
    force2.set(k, loads.force2);
    moment1.set(k, loads.moment1);
    moment2.set(k, loads.moment2);
  }
}
} // namespace

void evaluate_rib_lanes(const SubcycledClumps& clumps, const RibSet& ribs,
                        const ContactProperties& pair, double h, RibLanes& lanes)
{
  if (lanes.size() == 0) return;
  const bool linear = pair.model == ContactModel::linear, crushes = pair.crushing_pressure > 0;
  if (linear && !crushes) evaluate(clumps, ribs, LinearLaw(pair), h, lanes);
  if (linear && crushes) evaluate(clumps, ribs, Crushing<LinearLaw>(pair), h, lanes);
  if (!linear && !crushes) evaluate(clumps, ribs, HertzMindlinLaw(pair), h, lanes);
  if (!linear && crushes) evaluate(clumps, ribs, Crushing<HertzMindlinLaw>(pair), h, lanes);
}
} // namespace interlock::dem
