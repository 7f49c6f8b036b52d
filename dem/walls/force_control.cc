#include "dem/walls/force_control.h"

#include "dem/exact_sums.h"
#include "dem/input_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interlock::dem
{
namespace
{
template <class... Parts> [[noreturn]] void refuse(const Parts&... parts)
{
  std::ostringstream text;
  text << "Force control of a wall: ";
  (text << ... << parts);
  throw InputError(text.str());
}

// Of one contact of a clump with this mass.
double response_of(const ContactProperties& pair, double mass, double time_step)
{
  const double k = std::max(pair.normal_stiffness, pair.tangential_stiffness);
  return k * time_step + 2 * pair.damping_ratio * std::sqrt(k * mass);
}

// A wall of either kind.
template <class AnyWall> void set_velocity(ForceControl& control, double response, AnyWall& wall)
{
  constexpr double learning = 0.01;
  const double pressing = -control.axis.dot(wall.force); // wall.force is that on the wall
  const double speed = controlled_speed(control, pressing, response);
  if (response <= 0)
    control.followed_speed = 0;
  else if (std::abs(speed) < control.largest_speed)
    control.followed_speed += learning * (speed - control.followed_speed);
  wall.velocity += (speed - control.axis.dot(wall.velocity)) * control.axis;
}
} // namespace

void check(const ForceControl& control)
{
  if (!(std::abs(control.axis.norm() - 1) < 1e-9))
    refuse("the axis (", control.axis.transpose(), ") must have the length 1, but has ",
           control.axis.norm(), ".");
  if (!(control.force >= 0) || !std::isfinite(control.force))
    refuse("the force is ", control.force, " N, but must be 0 or more: a wall cannot pull.");
  if (!(control.largest_speed > 0) || !std::isfinite(control.largest_speed))
    refuse("the largest speed is ", control.largest_speed, " m/s, but must be above 0.");
  if (!(control.gain > 0 && control.gain <= 0.8))
    refuse("the gain is ", control.gain, ", but must be above 0 and at most 0.8.");
}

double controlled_speed(const ForceControl& control, double pressing_force, double response)
{
  const double limit = control.largest_speed;
  if (response <= 0) return control.force > 0 ? limit : 0;
  const double correction = control.gain * (control.force - pressing_force) / response;
  return std::clamp(control.followed_speed + correction, -limit, limit);
}

double contact_response(const std::vector<WallContact>& contacts, int wall,
                        const ContactProperties& pair, const Clumps& clumps, double time_step)
{
  double sum = 0;
  for (const WallContact& c : contacts)
    if (c.touching && c.wall == wall)
      sum += on_grid<response_grid>(response_of(pair, clumps.mass[c.i], time_step));
  return sum;
}

double contact_response(const std::vector<MeshContact>& contacts, int wall,
                        const ContactProperties& pair, const Clumps& clumps, double time_step)
{
  double sum = 0;
  for (const MeshContact& c : contacts)
    if (c.wall == wall)
      sum += on_grid<response_grid>(response_of(pair, clumps.mass[c.i], time_step));
  return sum;
}

void control_force(ForceControl& control, double response, Wall& wall)
{
  set_velocity(control, response, wall);
}

void control_force(ForceControl& control, double response, MeshWall& wall)
{
  set_velocity(control, response, wall);
}
} // namespace interlock::dem
