// A state on disk: an HDF5 file with a block of text in front. What it holds, and how to open it
// with h5py: docs/checkpoint_format.md.
#pragma once

#include "coupling/state/state_tree.h"

#include <filesystem>
#include <string>

namespace interlock::coupling
{
// Raised when a file of this version can no longer be read by an older program, or the other way.
constexpr int state_format = 7;

// The name under which write_checkpoint keeps the file that was there: a/checkpoint.h5 becomes
// a/checkpoint.previous.h5.
std::filesystem::path previous_of(const std::filesystem::path& file);

// Writes `file` under a temporary name, makes sure that it is on the disk, and renames it. Throws
// std::runtime_error, one sentence with the reason, when the disk is full or the folder is gone;
// the old file is untouched then, and no temporary one is left.
void write_state(const std::filesystem::path& file, const StateTree& state,
                 const std::string& program_version);

// The same; the file that was there is kept as previous_of(file). At every moment one of the two
// names holds a whole file.
void write_checkpoint(const std::filesystem::path& file, const StateTree& state,
                      const std::string& program_version);

// Reads what either has written. Throws InputError, one sentence that names the file, when it is
// not there, cut off, no state of this program, of another format, or when any bit of it has
// changed: the checksum is looked at before anything else. Where previous_of(file) is good, the
// sentence ends with its name.
StateTree read_state(const std::filesystem::path& file);
} // namespace interlock::coupling
