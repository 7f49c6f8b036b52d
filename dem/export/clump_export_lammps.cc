#include "dem/export/clump_export_formats.h"
#include "dem/export/member_volumes.h"

#include <cstdio>

namespace interlock::dem
{
namespace
{
// One section of the molecule file: "ID value" for every sphere.
template <typename Value>
std::string section(const std::string& title, const ClumpExport& clump, const Value& value)
{
  std::string text = "\n" + title + "\n\n";
  for (std::size_t i = 0; i < clump.shape.spheres.size(); ++i)
    text += std::to_string(i + 1) + " " + value(i) + "\n";
  return text;
}

// What a code gets that sums the spheres instead of taking the stone's own values.
std::vector<std::string> sums_text(const ClumpExport& clump, const std::string& id)
{
  const double deviation = sum_deviation(clump.shape, member_volumes(clump.shape));
  if (deviation < allowed_sum_deviation)
    return {"The masses of the spheres sum to the stone's mass, centre and inertia, so that",
            "`create_atoms ... mol " + id + "` with fix rigid/small gives the stone too."};
  char text[80];
  std::snprintf(text, sizeof(text), "their moments are off by up to %.2g %%:", 100 * deviation);
  return {"The masses of the spheres sum to the stone's mass, but",
          text + std::string(" insert with fix deposit or fix pour,"), "not with create_atoms."};
}
} // namespace

ExportedFiles lammps_files(const ClumpExport& clump)
{
  // Without `reinit no` the second run computes the bodies anew from their spheres. Without
  // `disable` and `gravity` the weight acts at the spheres, with both at the centre of the body,
  // with `gravity` alone twice.
  const std::string id = identifier(clump.shape.name);
  std::vector<std::string> usage = {
      "LAMMPS molecule file, units si, atom_style sphere, atom_modify map array:",
      "  fix ids all property/atom mol ghost yes",
      "  molecule " + id + " " + clump.file_name,
      "  fix g all gravity 9.81 vector 0 0 -1 disable",
      "  fix stones all rigid/small molecule mol " + id + " reinit no gravity g",
      "then insert with fix deposit or fix pour: ... mol " + id + " rigid stones."};
  for (const std::string& line : sums_text(clump, id)) usage.push_back(line);
  std::string text = comment_head(clump, "#", usage);
  const Vector3 inertia = clump.inertia();
  const std::vector<double> masses = clump.member_masses();
  const std::vector<Sphere>& spheres = clump.shape.spheres;
  text += "\n" + std::to_string(spheres.size()) + " atoms\n" + digits(clump.mass()) + " mass\n" +
          "0 0 0 com\n" + digits({inertia[0], inertia[1], inertia[2], 0, 0, 0}, " ") + " inertia\n";
  text += section("Coords", clump, [&](std::size_t i) {
    const Vector3& c = spheres[i].centre;
    return digits({c[0], c[1], c[2]}, " ");
  });
  text += section("Types", clump, [](std::size_t) { return std::string("1"); });
  text += section("Diameters", clump, [&](std::size_t i) { return digits(2 * spheres[i].radius); });
  text += section("Masses", clump, [&](std::size_t i) { return digits(masses[i]); });
  return {{"", text}};
}
} // namespace interlock::dem
