// Where a run writes.
#pragma once

#include <filesystem>
#include <string>

namespace interlock::apps
{
// results/NAME for a parameter file NAME.prm, relative to the working directory.
std::filesystem::path default_output_folder(const std::filesystem::path& parameter_file);

// Throws InputError when `folder` is a file or lies below one. Changes nothing.
void check_output_folder(const std::filesystem::path& folder);

// Creates the folder and those above it. Throws InputError when the disk does not allow it.
void create_output_folder(const std::filesystem::path& folder);

// Throws InputError unless a file can be written at `path`: makes the folders above it and a file
// beside it, and removes them again. `what` begins the sentence ("The report").
void check_writable(const std::string& what, const std::filesystem::path& path);
} // namespace interlock::apps
