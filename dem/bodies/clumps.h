// The state of all clumps: rigid bodies that share shapes. World frame, SI units.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/bodies/component_arrays.h"

#include <cstdint>

namespace interlock::dem
{
// What a body is there for.
enum class BodyKind {
  stone,
  surcharge // a load on top of the stones
};

// Everything that belongs to one clump: how it travels from rank to rank. As the fields of Clumps.
struct ClumpState {
  std::int64_t id = -1;
  int shape = 0;
  BodyKind kind = BodyKind::stone;
  double mass = 0;
  Vector3 inertia, position;
  Quaternion orientation;
  Vector3 velocity, angular_momentum, drift_velocity, spin, step_velocity, step_spin, force, torque;
  Vector3 lost;
  double lost_to_crushing = 0;
  bool is_ghost = false;
};

// One array a quantity, one contiguous row a component; index = clump. Velocities and angular
// momenta live at half steps (leapfrog): after a kick they belong to the middle of the step that
// the next drift makes.
class Clumps
{
public:
  explicit Clumps(std::vector<ClumpShape> shapes);

  // Adds a stone at rest and returns its index. `density` in kg/m3. Its id is next_id(), and is
  // kept for life: ids ascend with the index, and indices shift when clumps are removed.
  int add(int shape, double density, const Vector3& position, const Quaternion& orientation);
  std::int64_t next_id() const { return next_id_; }
  int index_of(std::int64_t id) const; // -1: there is none

  // Sets the motion of a clump as if it had drifted with it: the three velocities [m/s], the spins
  // and the angular momentum that go with `spin` (world) [rad/s] at its present attitude.
  void set_motion(int clump, const Vector3& velocity, const Vector3& spin);

  // Throws std::logic_error, one sentence, when arrays differ in length, ids do not ascend, a shape
  // is not there, a mass is not positive, an attitude is not a rotation or a number is not finite.
  void validate() const;

  // Adds one more shape (for example the sphere of a surcharge) and returns its index.
  int add_shape(ClumpShape shape);

  ClumpState state_of(int clump) const;
  // These clumps, ids ascending, instead of those that are there. The next new id stays.
  void assign(const std::vector<ClumpState>& states);

  // Removes the clumps with remove[i] true; the others keep their order. Returns for every old
  // index the new one, or -1.
  std::vector<int> remove(const std::vector<bool>& remove);

  int size() const { return position.size(); }
  const ClumpShape& shape_of(int clump) const { return shapes_[shape[clump]]; }
  const std::vector<ClumpShape>& shapes() const { return shapes_; }
  double bounding_radius(int clump) const { return bounding_radius_[shape[clump]]; } // [m]
  // Largest distance of a member's centre from the centre of mass [m].
  double member_reach(int clump) const { return member_reach_[clump]; }
  const ScalarField& member_reach() const { return member_reach_; }

  // Centre of member sphere `a` from the clump's centre of mass, world axes [m].
  Vector3 member_offset(int clump, int a) const
  {
    return orientation[clump]._transformVector(shape_of(clump).spheres[a].centre);
  }
  // World spin from the angular momentum at the present attitude [rad/s].
  Vector3 spin_of(int clump, const Vector3& momentum) const;

  // Moves every clump by dt [s]: position with its velocity, attitude with advance_attitude()
  // (rigid_motion.h). Those with `held`[i] = 1 stay as they are (0: move).
  void drift_all(double dt, const ScalarField& held);

  std::int64_t n_spheres() const; // of all clumps together

  std::vector<int> shape;
  std::vector<std::int64_t> id;
  std::vector<BodyKind> kind;
  ScalarField mass{one};                        // [kg]
  ScalarField inverse_mass{one};                // [1/kg]
  VectorField inertia{Vector3::Ones()};         // principal, body frame [kg m2]
  VectorField inverse_inertia{Vector3::Ones()}; // [1/(kg m2)]
  VectorField position;                         // of the centre of mass [m]
  QuaternionField orientation;                  // body to world
  VectorField velocity;                         // [m/s]
  VectorField angular_momentum;                 // [kg m2/s]
  // Of the last drift: what the contacts of a sub-step saw move. The momenta may have been kicked
  // since.
  VectorField drift_velocity, spin; // [m/s], [rad/s]
  // Mean over the last whole step: what the contacts of the step saw move. Equal to that of the
  // drift, unless the step was made of several drifts and the caller wrote their mean here.
  VectorField step_velocity, step_spin;
  // 1 for copies of clumps that another rank moves, 0 for those that are moved here. Not part of a
  // state: whoever reads one moves all of it.
  ScalarField ghost;
  VectorField force;  // of this step, without gravity [N]
  VectorField torque; // about the centre of mass [N m]
  // Dissipated since the clump came: by friction and by dashpots at its contacts, half of what
  // those with other clumps lose and all of the others, and by local damping [J]. Kept by clump so
  // that the sums over all do not depend on who shares them.
  enum Loss { to_friction, to_damping, to_local_damping };
  VectorField lost;
  // Likewise, to what contacts crushed [J].
  ScalarField lost_to_crushing;

  template <class Archive> friend void exchange(Archive& archive, Clumps& clumps)
  {
    archive("shapes", clumps.shapes_);
    archive("next_id", clumps.next_id_);
    archive("id", clumps.id);
    archive("shape", clumps.shape);
    archive("kind", clumps.kind);
    archive("mass", clumps.mass, "kg");
    archive("inverse_mass", clumps.inverse_mass, "1/kg");
    archive("inertia", clumps.inertia, "kg m2");
    archive("inverse_inertia", clumps.inverse_inertia, "1/(kg m2)");
    archive("position", clumps.position, "m");
    archive("orientation", clumps.orientation);
    archive("velocity", clumps.velocity, "m/s");
    archive("angular_momentum", clumps.angular_momentum, "kg m2/s");
    archive("drift_velocity", clumps.drift_velocity, "m/s");
    archive("spin", clumps.spin, "rad/s");
    archive("step_velocity", clumps.step_velocity, "m/s");
    archive("step_spin", clumps.step_spin, "rad/s");
    archive("force", clumps.force, "N");
    archive("torque", clumps.torque, "N m");
    archive("lost", clumps.lost, "J");
    archive("lost_to_crushing", clumps.lost_to_crushing, "J");
    if (Archive::reading) clumps.derive_from_shapes();
  }

private:
  void derive_from_shapes();

  inline static const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();

  std::vector<ClumpShape> shapes_;
  std::vector<double> bounding_radius_; // of the shapes
  ScalarField member_reach_;
  std::int64_t next_id_ = 0;
};
} // namespace interlock::dem
