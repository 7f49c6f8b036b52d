#include "dem/export/clump_export_formats.h"
#include "dem/input_error.h"

#include <cstdint>

namespace interlock::dem
{
namespace
{
// LIGGGHTS wants a prime above 10000 as seed, and another one for every template. From the name, by
// the FNV-1a hash.
std::uint32_t prime_seed(const std::string& name)
{
  std::uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  const auto prime = [](std::uint32_t n) {
    for (std::uint32_t d = 3; d * d <= n; d += 2)
      if (n % d == 0) return false;
    return true;
  };
  std::uint32_t seed = (10001 + hash % 90000000) | 1;
  while (!prime(seed)) seed += 2;
  return seed;
}

std::string template_command(const ClumpExport& clump, const std::string& id)
{
  // use_density keeps the origin of the file as the centre of mass; use_volume would move it to the
  // Monte Carlo estimate of the centre of the union.
  const Vector3 inertia = clump.inertia();
  return "\nvariable " + id + "_type index 1\nfix " + id + " all particletemplate/multisphere " +
         std::to_string(prime_seed(id)) + " &\n  atom_type 1 density constant " +
         digits(clump.density) + " &\n  nspheres " + std::to_string(clump.shape.spheres.size()) +
         " ntry 100000 spheres file " + clump.file_name + " scale 1.0 type ${" + id +
         "_type} &\n  mass " + digits(clump.mass()) + " &\n  inertia_tensor " +
         digits({inertia[0], 0, 0, inertia[1], 0, inertia[2]}, " ") + " use_density\n";
}
} // namespace

ExportedFiles liggghts_files(const ClumpExport& clump)
{
  if (clump.shape.spheres.size() < 2)
    throw InputError("Clump '" + clump.shape.name +
                     "' has one sphere, but a multisphere template "
                     "of LIGGGHTS needs two or more.");
  const std::string commands = clump.file_name + ".in", id = identifier(clump.shape.name);
  std::string spheres = comment_head(
      clump, "#", {"LIGGGHTS spheres file: x y z r. Load it with `include " + commands + "`."});
  for (const Sphere& sphere : clump.shape.spheres) spheres += sphere_digits(sphere, " ") + "\n";
  const std::string head = comment_head(
      clump, "#",
      {"LIGGGHTS 3.8 template, units si:", "  fix ms all multisphere", "  include " + commands,
       "  fix mix all particledistribution/discrete 32452843 1 " + id + " 1.0",
       "  fix ins all insert/pack ... distributiontemplate mix ...",
       "Templates are numbered without gaps: before the include of the second one",
       "  variable " + id + "_type index 2",
       "The sampling of `ntry` points only spreads the volume over the spheres (CFD)."});
  return {{"", spheres}, {".in", head + template_command(clump, id)}};
}
} // namespace interlock::dem
