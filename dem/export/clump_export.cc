#include "dem/export/clump_export.h"

#include "dem/export/clump_export_formats.h"
#include "dem/input_error.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace interlock::dem
{
namespace
{
namespace fs = std::filesystem;

struct Format {
  ClumpFormat id;
  const char *name, *extension;
  ExportedFiles (*files)(const ClumpExport&);
};

constexpr std::array<Format, 7> formats = {{
    {ClumpFormat::lammps, "lammps", ".mol", lammps_files},
    {ClumpFormat::liggghts, "liggghts", ".multisphere", liggghts_files},
    {ClumpFormat::yade, "yade", ".py", yade_files},
    {ClumpFormat::mercury, "mercury", ".mclump", mercury_files},
    {ClumpFormat::pfc, "pfc", ".dat", pfc_files},
    {ClumpFormat::csv, "csv", ".csv", csv_files},
    {ClumpFormat::vtk, "vtk", ".vtp", vtk_files},
}};

const Format& entry(const ClumpFormat id)
{
  for (const Format& format : formats)
    if (format.id == id) return format;
  throw InputError("The format of the clump is not known.");
}
} // namespace

std::vector<std::string> clump_format_names()
{
  std::vector<std::string> names;
  for (const Format& format : formats) names.push_back(format.name);
  return names;
}

ClumpFormat clump_format(const std::string& name)
{
  std::string list;
  for (const Format& format : formats) {
    if (name == format.name) return format.id;
    list += (list.empty() ? "'" : ", '") + std::string(format.name) + "'";
  }
  throw InputError("The format of the clump is '" + name + "', but must be one of " + list + ".");
}

std::string clump_extension(const ClumpFormat format)
{
  return entry(format).extension;
}

std::string clump_stem(const std::string& clump_file)
{
  const std::string ending = ".clump.json";
  const bool has_ending =
      clump_file.size() > ending.size() &&
      !clump_file.compare(clump_file.size() - ending.size(), ending.size(), ending);
  return has_ending ? clump_file.substr(0, clump_file.size() - ending.size())
                    : fs::path(clump_file).replace_extension().string();
}

std::string clump_export_path(const std::string& clump_file, const ClumpFormat format)
{
  const fs::path stem = clump_stem(clump_file);
  const std::string name = stem.filename().string();
  const bool keeps_name = format == ClumpFormat::csv || format == ClumpFormat::vtk;
  return (stem.parent_path() / (keeps_name ? name : identifier(name))).string() +
         clump_extension(format);
}

std::vector<std::string> clump_export_paths(const std::string& clump_file, const ClumpFormat format)
{
  const std::string path = clump_export_path(clump_file, format);
  if (format == ClumpFormat::liggghts) return {path, path + ".in"};
  return {path};
}

std::vector<FileText> clump_export_files(const std::string& path, const ClumpShape& shape,
                                         const ClumpFormat format, const double density)
{
  if (!(density > 0 && std::isfinite(density)))
    throw InputError("The density of the clump for '" + path + "' is " + digits(density) +
                     " kg/m3, but must be above 0.");
  if (shape.spheres.empty()) throw InputError("The clump for '" + path + "' has no sphere.");
  const ClumpExport clump{shape, density, fs::path(path).filename().string()};
  std::vector<FileText> files;
  for (const ExportedFile& file : entry(format).files(clump))
    files.push_back({path + file.suffix, file.text});
  return files;
}

void export_clump(const std::string& path, const ClumpShape& shape, const ClumpFormat format,
                  const double density)
{
  const std::vector<FileText> files = clump_export_files(path, shape, format, density);
  // Folders inside the export are made, the one that it goes to is not.
  std::error_code error;
  if (!fs::is_directory(fs::absolute(path).parent_path(), error) || write_atomically(files))
    throw InputError("Clump file '" + path + "' cannot be written.");
}
} // namespace interlock::dem
