#include "dem/export/clump_export_text.h"

#include "dem/export/member_volumes.h"

#include <cctype>
#include <cstdio>

namespace interlock::dem
{
std::vector<double> ClumpExport::member_masses() const
{
  std::vector<double> masses = member_volumes(shape);
  for (double& mass : masses) mass *= density;
  return masses;
}

std::string digits(const double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

std::string digits(const std::vector<double>& values, const std::string& separator)
{
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : separator) + digits(value);
  return text;
}

std::string sphere_digits(const Sphere& sphere, const std::string& separator)
{
  const Vector3& c = sphere.centre;
  return digits({c[0], c[1], c[2], sphere.radius}, separator);
}

std::string plain_name(const std::string& name)
{
  std::string plain = name;
  for (char& c : plain)
    if (std::iscntrl(static_cast<unsigned char>(c)) || c == '"' || c == '\'') c = ' ';
  return plain;
}

std::string identifier(const std::string& name)
{
  std::string text;
  for (const char c : name) text += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  const bool letter = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front()));
  return letter ? text : "stone_" + text;
}

std::string comment_head(const ClumpExport& clump, const std::string& prefix,
                         const std::vector<std::string>& usage)
{
  const Vector3 inertia = clump.inertia();
  std::vector<std::string> lines = {
      "Clump '" + plain_name(clump.shape.name) +
          "' by Interlock: " + std::to_string(clump.shape.spheres.size()) + " spheres",
      "density " + digits(clump.density) + " kg/m3, mass " + digits(clump.mass()) + " kg, volume " +
          digits(clump.shape.volume) + " m3",
      "principal moments of inertia [kg m2]: " + digits({inertia[0], inertia[1], inertia[2]}, " "),
      "Lengths in m. Origin: centre of mass; axes: principal axes of inertia.", ""};
  lines.insert(lines.end(), usage.begin(), usage.end());
  std::string text;
  for (const std::string& line : lines) text += prefix + (line.empty() ? "" : " " + line) + "\n";
  return text;
}
} // namespace interlock::dem
