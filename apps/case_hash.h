// Whether the files of an output folder are those of one run.
#pragma once

#include <filesystem>
#include <string>

namespace interlock::apps
{
// 16 digits that change when any entry of the parameter file changes: the hash
// (coupling/state/state_tree.h) of the lines "Section/Name=value" in ascending order. Comments,
// layout and order of the file do not change them. Throws InputError when the file cannot be read.
std::string case_hash(const std::filesystem::path& parameter_file);

// 16 digits that change when any byte of the file changes; empty when it cannot be read.
std::string file_hash(const std::filesystem::path& file);

// Throws InputError, one sentence, when summary.json in the folder has an entry `parameters_hash`
// that is not the case_hash of used.prm beside it: another run has begun there, or parts of two
// were copied together. A folder that lacks one of the files or that entry is not refused.
void require_one_run(const std::filesystem::path& folder);
} // namespace interlock::apps
