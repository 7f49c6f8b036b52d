// Parameter files of a pull-out for tests of how they are read.
#pragma once

#include "apps/case_templates.h"

#include <map>
#include <stdexcept>
#include <string>

// The template with the geogrid that its entries describe, ribs of 5 x 2.5 mm, instead of a
// product: a file in which every entry of the section Geogrid has an effect.
inline std::string pull_out_by_entries()
{
  std::string text = interlock::apps::pull_out_template();
  const auto product = text.find("subsection Product");
  if (product != std::string::npos)
    text.erase(product, text.find("\nend\n", product) + 5 - product);
  const std::map<std::string, std::string> values = {
      {"Pitch along", "0.065"},    {"Pitch across", "0.065"},   {"Rib width", "0.005"},
      {"Rib thickness", "0.0025"}, {"Youngs modulus", "2.4e9"}, {"Poisson ratio", "0.3"},
      {"Density", "910"}};
  const auto section = text.find("subsection Geogrid");
  for (const auto& [name, value] : values) {
    const std::string line = "\n  set " + name + " = ";
    const auto begin = text.find(line, section);
    if (begin == std::string::npos) throw std::logic_error("The template lacks " + name + ".");
    text.replace(begin, text.find('\n', begin + 1) - begin, line + value);
  }
  return text;
}
