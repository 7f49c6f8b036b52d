#include "dem/export/clump_export_formats.h"

namespace interlock::dem
{
ExportedFiles csv_files(const ClumpExport& clump)
{
  std::string text = comment_head(clump, "#",
                                  {"Spheres of the clump. pandas.read_csv('" +
                                   plain_name(clump.file_name) + "', comment='#') reads them."});
  text += "x [m],y [m],z [m],r [m]\n";
  for (const Sphere& sphere : clump.shape.spheres) text += sphere_digits(sphere, ",") + "\n";
  return {{"", text}};
}
} // namespace interlock::dem
