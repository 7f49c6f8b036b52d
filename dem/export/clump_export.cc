#include "dem/export/clump_export.h"

#include "dem/export/clump_export_formats.h"
#include "dem/input_error.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

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

void write(const std::string& path, const std::string& text)
{
  const std::string temporary = path + ".tmp";
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) fs::rename(temporary, path, error);
  if (file && !error) return;
  fs::remove(temporary, error);
  throw InputError("Clump file '" + path + "' cannot be written.");
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

std::string clump_export_path(const std::string& clump_file, const ClumpFormat format)
{
  const std::string ending = ".clump.json";
  const bool json = clump_file.size() > ending.size() &&
                    !clump_file.compare(clump_file.size() - ending.size(), ending.size(), ending);
  const std::string stem = json ? clump_file.substr(0, clump_file.size() - ending.size())
                                : fs::path(clump_file).replace_extension().string();
  return stem + clump_extension(format);
}

void export_clump(const std::string& path, const ClumpShape& shape, const ClumpFormat format,
                  const double density)
{
  if (!(density > 0 && std::isfinite(density)))
    throw InputError("The density of the clump for '" + path + "' is " + digits(density) +
                     " kg/m3, but must be above 0.");
  if (shape.spheres.empty()) throw InputError("The clump for '" + path + "' has no sphere.");
  const ClumpExport clump{shape, density, fs::path(path).filename().string()};
  for (const ExportedFile& file : entry(format).files(clump)) {
    // Folders inside the export are made, the one that it goes to is not.
    const fs::path parent = fs::absolute(path).parent_path();
    std::error_code error; // write() says so when a folder is not there
    if (fs::is_directory(parent, error))
      fs::create_directories(fs::path(path + file.suffix).parent_path(), error);
    write(path + file.suffix, file.text);
  }
}
} // namespace interlock::dem
