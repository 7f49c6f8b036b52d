#include "apps/output_folder.h"

#include "dem/input_error.h"

#include <fstream>

namespace interlock::apps
{
namespace fs = std::filesystem;

fs::path default_output_folder(const fs::path& parameter_file)
{
  return fs::path("results") / parameter_file.stem();
}

void check_output_folder(const fs::path& folder)
{
  for (fs::path part = fs::absolute(folder).lexically_normal(); part != part.root_path();
       part = part.parent_path()) {
    std::error_code error;
    const fs::file_status status = fs::status(part, error);
    if (fs::is_directory(status)) return;
    if (fs::exists(status))
      throw InputError("The output folder \"" + folder.string() + "\" cannot be made: \"" +
                       part.string() + "\" is a file.");
  }
}

void create_output_folder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError("The output folder \"" + folder.string() +
                     "\" cannot be made: " + error.message() + ".");
}

void check_writable(const std::string& what, const fs::path& path)
{
  const auto refuse = [&](const std::string& reason) {
    throw InputError(what + " '" + path.string() + "' cannot be written: " + reason + ".");
  };
  std::error_code error;
  const fs::path folder = fs::absolute(path).parent_path(), probe = path.string() + ".check";
  fs::path there = folder; // the nearest folder that exists
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, error)) refuse("'" + there.string() + "' is a file");
  fs::create_directories(folder, error);
  const bool good = bool(std::ofstream(probe));
  fs::remove(probe, error);
  for (fs::path made = folder; made != there; made = made.parent_path()) fs::remove(made, error);
  if (!good) refuse("no file can be made in '" + there.string() + "'");
}
} // namespace interlock::apps
