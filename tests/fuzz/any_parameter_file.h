// Any bytes as a parameter file: shared by the fuzzer and the test that reads what it has found.
#pragma once

#include "apps/parameter_file.h"
#include "dem/input_error.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

// Writes the bytes to a file in `folder` and reads it as `interlock run` does before it runs.
// Returns whether the parameters were taken. What was taken is written down as a complete
// parameter file, and that must be read to the same again: throws std::logic_error where not. Lets
// every exception but InputError escape.
inline bool read_any_parameter_file(std::string_view bytes, const std::filesystem::path& folder)
{
  using namespace interlock;
  const std::filesystem::path file = folder / "case.prm", used_file = folder / "used.prm";
  std::ofstream(file, std::ios::binary).write(bytes.data(), bytes.size());
  std::string used;
  try {
    used = apps::read_parameter_file(file).used;
  } catch (const InputError&) {
    return false;
  }
  std::ofstream(used_file, std::ios::binary) << used;
  if (apps::read_parameter_file(used_file).used != used)
    throw std::logic_error("a complete parameter file was read to another one:\n" + used);
  return true;
}
