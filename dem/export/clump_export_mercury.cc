#include "dem/export/clump_export_formats.h"

namespace interlock::dem
{
ExportedFiles mercury_files(const ClumpExport& clump)
{
  // The reader takes every line for numbers, so no comments.
  std::string spheres;
  for (const Sphere& sphere : clump.shape.spheres) spheres += sphere_digits(sphere, ",") + "\n";
  const auto rows = [](const Vector3& diagonal) {
    return digits({diagonal[0], 0, 0}, ",") + "\n" + digits({0, diagonal[1], 0}, ",") + "\n" +
           digits({0, 0, diagonal[2]}, ",") + "\n";
  };
  const std::string about = comment_head(
      clump, "",
      {"One clump of MercuryDPM's MClump tool. Copy this folder to Tools/MClump/Clumps/ of the",
       "source; LoadClumps() of ClumpInput.h finds it there. It reads seven digits (float).",
       "Clump/Clump.txt: x,y,z,r a sphere [m]. Inertia/Mass.txt [kg].",
       "Inertia/TOI.txt: tensor of inertia about the centre [kg m2].",
       "Inertia/PD.txt: principal directions, one a line."});
  return {{"/readme.txt", about},
          {"/Clump/Clump.txt", spheres},
          {"/Inertia/Mass.txt", digits(clump.mass()) + "\n"},
          {"/Inertia/TOI.txt", rows(clump.inertia())},
          {"/Inertia/PD.txt", rows(Vector3::Ones())}};
}
} // namespace interlock::dem
