// Where a run writes.
#pragma once

#include <filesystem>

namespace interlock::apps
{
// results/NAME for a parameter file NAME.prm, relative to the working directory.
std::filesystem::path default_output_folder(const std::filesystem::path& parameter_file);

// Throws InputError when `folder` is a file or lies below one. Changes nothing.
void check_output_folder(const std::filesystem::path& folder);

// Creates the folder and those above it. Throws InputError when the disk does not allow it.
void create_output_folder(const std::filesystem::path& folder);
} // namespace interlock::apps
