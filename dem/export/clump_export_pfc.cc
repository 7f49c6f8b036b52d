#include "dem/export/clump_export_formats.h"

namespace interlock::dem
{
ExportedFiles pfc_files(const ClumpExport& clump)
{
  const std::string name = plain_name(clump.shape.name);
  std::string text = comment_head(
      clump, ";",
      {"PFC3D data file: program call '" + clump.file_name + "', then clump replicate, generate or",
       "distribute with the template '" + name + "'. Templates have unit density: volume in m3,",
       "inertia in m5, and the stone's density is given afterwards: clump attribute density " +
           digits(clump.density)});
  text += "clump template create ...\n  name '" + name + "' ...\n  pebbles " +
          std::to_string(clump.shape.spheres.size()) + " ...\n";
  for (const Sphere& sphere : clump.shape.spheres) {
    const Vector3& c = sphere.centre;
    text += "    " + digits({sphere.radius, c[0], c[1], c[2]}, " ") + " ...\n";
  }
  const Vector3& inertia = clump.shape.unit_inertia;
  text += "  volume " + digits(clump.shape.volume) + " ...\n  inertia " +
          digits({inertia[0], inertia[1], inertia[2], 0, 0, 0}, " ") + " ...\n  position 0 0 0\n";
  return {{"", text}};
}
} // namespace interlock::dem
