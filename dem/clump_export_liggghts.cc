#include "dem/clump_export_formats.h"
#include "dem/input_error.h"

namespace interlock::dem
{
ExportedFiles liggghts_files(const ClumpExport& clump)
{
  const std::size_t count = clump.shape.spheres.size();
  if (count < 2)
    throw InputError("Clump '" + clump.shape.name +
                     "' has one sphere, but a multisphere template "
                     "of LIGGGHTS needs two or more.");
  const std::string commands = clump.file_name + ".in", id = identifier(clump.shape.name);
  std::string spheres = comment_head(
      clump, "#", {"LIGGGHTS spheres file: x y z r. Load it with `include " + commands + "`."});
  for (const Sphere& sphere : clump.shape.spheres) spheres += sphere_digits(sphere, " ") + "\n";

  // use_density keeps the origin of the file as the centre of mass; use_volume would move it to the
  // Monte Carlo estimate of the centre of the union.
  const Vector3 inertia = clump.inertia();
  const std::string text =
      comment_head(
          clump, "#",
          {"LIGGGHTS 3.8 template, units si. Change the atom type and the number after",
           "`type` (1, 2, ... without gaps over all templates), then:", "  fix ms all multisphere",
           "  include " + commands,
           "  fix mix all particledistribution/discrete 32452843 1 " + id + " 1.0",
           "  fix ins all insert/pack ... distributiontemplate mix ...",
           "The sampling of `ntry` points only spreads the volume over the spheres (CFD)."}) +
      "\nfix " + id +
      " all particletemplate/multisphere 32452867 &\n  atom_type 1 density constant " +
      digits(clump.density) + " &\n  nspheres " + std::to_string(count) +
      " ntry 100000 spheres file " + clump.file_name + " scale 1.0 type 1 &\n  mass " +
      digits(clump.mass()) + " &\n  inertia_tensor " +
      digits({inertia[0], 0, 0, inertia[1], 0, inertia[2]}, " ") + " use_density\n";
  return {{"", spheres}, {".in", text}};
}
} // namespace interlock::dem
