// The section "Product" of another parameter file, for a case that names it.
#pragma once

#include "apps/parameter_scanner.h"

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
// The file that the line `naming` means: relative to its case, or, for a plain name that is not
// there
// ("bx1100.prm"), that of the library which comes with the program, share/interlock/cases/geogrids.
std::filesystem::path product_file(const Assignment& naming);

// The assignments of that section. `naming`: the line that names the file. Adds full sentences to
// `errors` when the file is not there, has no such section, or has lines that are no lines.
std::vector<Assignment> product_section(const std::filesystem::path& file, const Assignment& naming,
                                        std::vector<std::string>& errors);
} // namespace interlock::apps
