#include "apps/product_section.h"

#include "apps/shared_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace interlock::apps
{
namespace fs = std::filesystem;

namespace
{
fs::path library()
{
  return shared_folder() / "cases/geogrids";
}
} // namespace

fs::path product_file(const Assignment& naming)
{
  const fs::path beside = fs::absolute(naming.base / naming.value).lexically_normal();
  const fs::path of_library = library() / naming.value;
  std::error_code error;
  const bool plain = !fs::path(naming.value).has_parent_path();
  const bool take = plain && !fs::exists(beside, error) && fs::is_regular_file(of_library, error);
  return take ? of_library : beside;
}

std::vector<Assignment> product_section(const std::filesystem::path& file, const Assignment& naming,
                                        std::vector<std::string>& errors)
{
  const auto refuse = [&](const std::string& why) {
    errors.push_back(fmt::format("{}: \"{}\": The file \"{}\" {}.", naming.place, naming.key(),
                                 file.string(), why));
    return std::vector<Assignment>();
  };
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return refuse("does not exist; products are in the folder " + library().string());
  ScannedFile scanned = scan_parameter_file(file);
  errors.insert(errors.end(), scanned.errors.begin(), scanned.errors.end());
  std::vector<Assignment> product;
  std::copy_if(scanned.assignments.begin(), scanned.assignments.end(), std::back_inserter(product),
               [](const Assignment& assignment) { return assignment.section == "Product"; });
  if (product.empty() && scanned.errors.empty())
    return refuse("is no product: it has no section \"Product\", as those in the folder " +
                  library().string() + " have");
  return product;
}
} // namespace interlock::apps
