#include "apps/output_folder.h"

#include "dem/input_error.h"

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
} // namespace interlock::apps
