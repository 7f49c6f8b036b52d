// Any bytes as a Gmsh file: shared by the fuzzer and the test that reads what it has found.
#pragma once

#include "fem/gmsh/gmsh_file.h"
#include "fem/gmsh/gmsh_lattice.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

// Writes the bytes to a file in `folder` and reads a lattice from it, with one section for all
// groups. Returns whether that is one; lets every exception but std::runtime_error escape.
inline bool read_any_lattice_file(std::string_view bytes, const std::filesystem::path& folder)
{
  using namespace interlock::fem;
  const std::string path = (folder / "lattice.msh").string();
  std::ofstream(path, std::ios::binary).write(bytes.data(), bytes.size());
  GmshSection section;
  RibSection rib;
  rib.width = rib.thickness = 1e-3;
  rib.youngs_modulus = 1e9;
  rib.density = 1000;
  section.profile.section = beam_section(rib);
  try {
    std::map<std::string, GmshSection> sections;
    const GmshFile file = read_gmsh_file(path);
    for (const GmshFile::Line& line : file.lines) sections[line.group] = section;
    gmsh_lattice(file, sections, 1e-3);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}
