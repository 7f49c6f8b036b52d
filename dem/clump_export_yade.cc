#include "dem/clump_export_formats.h"

namespace interlock::dem
{
namespace
{
// YADE takes mass, centre and axes of a clump from its spheres, each with the density of its
// material and counted in full (discretization=0), and its Python interface cannot move the frame
// of a clump afterwards. So every sphere wears a material with the density that makes these sums
// the stone's until the clump is made.
constexpr const char* function = R"PY(

def add_stone(position, orientation, material):
    """Appends one stone as a clump and returns (id of the clump, ids of its spheres).

    position: Vector3, its centre of mass [m]; orientation: Quaternion, its principal axes to the
    world's; material: FrictMat or one derived from it. Its density is not used: the stone has the
    mass and inertia above. Do not call O.bodies.updateClumpProperties afterwards: it replaces them.
    """
    spheres = []
    for (x, y, z, r), mass in zip(SPHERES, MEMBER_MASSES):
        sphere = utils.sphere(position + orientation * Vector3(x, y, z), r, material=material)
        sphere.state.mass = mass
        sphere.state.inertia = 0.4 * mass * r * r * Vector3(1, 1, 1)
        sphere.mat = FrictMat(density=mass / (4. / 3. * math.pi * r**3))
        spheres.append(sphere)
    clump_id, sphere_ids = O.bodies.appendClumped(spheres, discretization=0)
    for sphere in spheres:
        sphere.mat = material
    state = O.bodies[clump_id].state
    # Rounding decides the signs of YADE's axes, and their order where two moments are equal.
    axes = (orientation.conjugate() * state.ori).toRotationMatrix()
    away = (state.pos - position).norm()
    if len(spheres) > 1 and away > 1e-6 * SPHERES[0][3]:
        print("add_stone: too few spheres to carry the centre of mass, it is off by %g m" % away)
    inertia = axes.transpose() * Matrix3(*[INERTIA[k // 3] if k % 4 == 0 else 0 for k in range(9)])
    inertia = inertia * axes
    state.mass = MASS
    state.inertia = inertia.diagonal()
    tilt = max(abs(inertia[i, j]) for i in range(3) for j in range(3) if i != j) / max(INERTIA)
    if tilt > 1e-6:
        print("add_stone: too few spheres to carry the axes; products of inertia up to %g" % tilt)
    return clump_id, sphere_ids
)PY";

std::string list(const std::string& name, const std::vector<std::string>& items)
{
  std::string text = name + " = [\n";
  for (const std::string& item : items) text += "    " + item + ",\n";
  return text + "]\n";
}
} // namespace

ExportedFiles yade_files(const ClumpExport& clump)
{
  const Vector3 inertia = clump.inertia();
  std::string text =
      "# -*- coding: utf-8 -*-\n" +
      comment_head(
          clump, "#",
          {"YADE 2023.02a. In a script beside this file, with material = FrictMat(...) appended to",
           "O.materials:", "  exec(open('" + clump.file_name + "').read())",
           "  clump_id, sphere_ids = add_stone(Vector3(0, 0, 1), Quaternion((0, 0, 1), 0), "
           "material)"}) +
      "import math\n\nfrom yade import *\nfrom yade import utils\n\n";
  text += "MASS = " + digits(clump.mass()) + "  # [kg]\n";
  text += "INERTIA = (" + digits({inertia[0], inertia[1], inertia[2]}, ", ") + ")  # [kg m2]\n";
  std::vector<std::string> spheres, masses;
  for (const Sphere& sphere : clump.shape.spheres)
    spheres.push_back("(" + sphere_digits(sphere, ", ") + ")");
  for (const double mass : clump.member_masses()) masses.push_back(digits(mass));
  text += "# x, y, z, r [m]\n" + list("SPHERES", spheres);
  text += "# As solid spheres of these masses [kg] the members have the stone's mass, centre and\n"
          "# inertia.\n" +
          list("MEMBER_MASSES", masses) + function;
  return {{"", text}};
}
} // namespace interlock::dem
