#include "dem/export/clump_export_formats.h"

namespace interlock::dem
{
namespace
{
// YADE takes mass, centre and axes of a clump from its members when it is made. Spheres count with
// the volume of the sphere and the density of the material, everything else with its state. So the
// spheres weigh nothing while the clump is made, and one more member, a box at the centre of mass,
// brings the stone's mass and inertia; erasing it leaves the frame as it is. This happens in the
// body frame, because YADE turns the inertia of a box that is not along the axes the wrong way.
constexpr const char* function = R"PY(

def add_stone(position, orientation, material):
    """Appends one stone as a clump and returns (id of the clump, ids of its spheres).

    position: Vector3, its centre of mass [m]; orientation: Quaternion, from its principal axes to
    the world; material: FrictMat or one derived from it. Its density does not count: the stone has
    the mass and inertia above, until O.bodies.updateClumpProperties is called, which it must not.
    """
    spheres = [utils.sphere((x, y, z), r, material=material) for x, y, z, r in SPHERES]
    for sphere in spheres:
        sphere.mat = FrictMat(density=0)
    carrier = Body()
    carrier.shape = Box(extents=Vector3(1, 1, 1) * SPHERES[0][3])
    carrier.mat = material
    carrier.bounded = False
    carrier.state.mass, carrier.state.inertia = MASS, Vector3(*INERTIA)
    clump_id, ids = O.bodies.appendClumped(spheres + [carrier], discretization=0)
    O.bodies.erase(ids[-1])
    clump = O.bodies[clump_id]
    # Equal moments leave the order of YADE's axes to rounding.
    axes = clump.state.ori.toRotationMatrix()
    inertia = axes.transpose() * Matrix3(INERTIA[0], 0, 0, 0, INERTIA[1], 0, 0, 0, INERTIA[2]) * axes
    clump.state.mass, clump.state.inertia = MASS, inertia.diagonal()
    for sphere in spheres:
        sphere.mat = material
    for body in spheres + [clump]:
        state = body.state
        state.pos = state.refPos = position + orientation * state.pos
        state.ori = state.refOri = orientation * state.ori
    return clump_id, ids[:-1]
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
  const std::string module = clump.file_name.substr(0, clump.file_name.find('.'));
  std::string text =
      "# -*- coding: utf-8 -*-\n" +
      comment_head(clump, "#",
                   {"YADE 2023.02a, in a script beside this file, whose name must suit `import`:",
                    "  import sys; sys.path.append('.')", "  import " + module,
                    "  material = FrictMat(...); O.materials.append(material)",
                    "  clump_id, sphere_ids = " + module +
                        ".add_stone(Vector3(0, 0, 1), Quaternion((0, 0, 1), 0),",
                    "      material)"}) +
      "from yade import *\nfrom yade import utils\n"
      "try:\n    from yade.minieigenHP import Matrix3, Vector3\n"
      "except ImportError:  # older YADE\n    from minieigen import Matrix3, Vector3\n\n";
  text += "MASS = " + digits(clump.mass()) + "  # [kg]\n";
  text += "INERTIA = (" + digits({inertia[0], inertia[1], inertia[2]}, ", ") + ")  # [kg m2]\n";
  std::vector<std::string> spheres;
  for (const Sphere& sphere : clump.shape.spheres)
    spheres.push_back("(" + sphere_digits(sphere, ", ") + ")");
  text += "# x, y, z, r [m]\n" + list("SPHERES", spheres) + function;
  return {{"", text}};
}
} // namespace interlock::dem
