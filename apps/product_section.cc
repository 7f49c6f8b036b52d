#include "apps/product_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace interlock::apps
{
std::vector<Assignment> product_section(const std::filesystem::path& file, const Assignment& naming,
                                        std::vector<std::string>& errors)
{
  const auto refuse = [&](const std::string& why) {
    errors.push_back(fmt::format("{}: \"{}\": The file \"{}\" {}.", naming.place, naming.key(),
                                 file.string(), why));
    return std::vector<Assignment>();
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return refuse("does not exist; products are in the folder cases/geogrids");
  ScannedFile scanned = scan_parameter_file(file);
  errors.insert(errors.end(), scanned.errors.begin(), scanned.errors.end());
  std::vector<Assignment> product;
  std::copy_if(scanned.assignments.begin(), scanned.assignments.end(), std::back_inserter(product),
               [](const Assignment& assignment) { return assignment.section == "Product"; });
  if (product.empty() && scanned.errors.empty())
    return refuse("is no product: it has no section \"Product\", as those in the folder "
                  "cases/geogrids have");
  return product;
}
} // namespace interlock::apps
