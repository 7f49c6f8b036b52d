// Any bytes as a stone file: shared by the fuzzer and the test that reads what it has found.
#pragma once

#include "dem/input_error.h"
#include "dem/scans/point_cloud.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

struct Outcome {
  bool is_mesh = false, is_cloud = false; // else refused with InputError
};

// The first byte chooses the extension (modulo 4) and, with bit 2, the option to flip; the rest
// goes to a file in `folder` and through the readers. Lets every exception but InputError escape.
inline Outcome read_any_stone_file(std::string_view bytes, const std::filesystem::path& folder)
{
  using namespace interlock;
  static const char* const extensions[] = {".stl", ".ply", ".obj", ".xyz"};
  Outcome outcome;
  if (bytes.empty()) return outcome;
  const std::string path = (folder / "stone").string() + extensions[bytes[0] & 3];
  std::ofstream(path, std::ios::binary).write(bytes.data() + 1, bytes.size() - 1);
  dem::StoneFileOptions options;
  options.flip = bytes[0] & 4;
  try {
    dem::read_stone_mesh(path, options);
    outcome.is_mesh = true;
  } catch (const InputError&) {
  }
  if (!dem::is_point_cloud(path)) return outcome;
  try {
    dem::read_point_cloud(path, options);
    outcome.is_cloud = true;
  } catch (const InputError&) {
  }
  return outcome;
}
