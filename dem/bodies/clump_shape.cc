#include "dem/bodies/clump_shape.h"

#include "dem/atomic_files.h"
#include "dem/input_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace interlock::dem
{
namespace
{
using nlohmann::json;
constexpr const char* format = "interlock clump 1";

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
  throw InputError("Clump file '" + path + "' " + what);
}

const json& entry(const std::string& path, const json& object, const char* name)
{
  const auto found = object.find(name);
  if (found != object.end()) return *found;
  std::string present;
  for (const auto& [key, value] : object.items()) present += (present.empty() ? "" : ", ") + key;
  refuse(path, std::string("has no entry '") + name + "' (it has: " + present + ").");
}

// `size` numbers under `name`.
std::vector<double> numbers(const std::string& path, const json& value, const std::string& name,
                            std::size_t size)
{
  const bool good =
      value.is_array() && value.size() == size &&
      std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); });
  if (!good)
    refuse(path, "has '" + name + "' = " + value.dump() + ", but it must be " +
                     std::to_string(size) + " numbers in brackets.");
  return value.get<std::vector<double>>();
}

void require_positive(const std::string& path, const std::string& name, double value)
{
  if (!(value > 0))
    refuse(path, "has '" + name + "' = " + json(value).dump() + ", but it must be above 0.");
}

json parse(const std::string& path)
{
  if (!std::filesystem::is_regular_file(path)) refuse(path, "does not exist.");
  std::ifstream file(path);
  try {
    json object = json::parse(file);
    if (!object.is_object()) refuse(path, "does not hold a JSON object.");
    return object;
  } catch (const json::parse_error& error) {
    refuse(path, "is not JSON: error at byte " + std::to_string(error.byte) + ".");
  }
}
} // namespace

double ClumpShape::bounding_radius() const
{
  double radius = 0;
  for (const Sphere& s : spheres) radius = std::max(radius, s.centre.norm() + s.radius);
  return radius;
}

std::string clump_shape_text(const ClumpShape& shape)
{
  // One line a sphere, which people can read; json prints the shortest digits that read back the
  // same.
  std::string text = "{\n";
  const auto add = [&](const char* name, const json& value) {
    // Names of files may hold bytes that are no UTF-8.
    text += json(name).dump() + ": " + value.dump(-1, ' ', false, json::error_handler_t::replace) +
            ",\n";
  };
  const Vector3& inertia = shape.unit_inertia;
  add("format", format);
  add("name", shape.name);
  add("volume_m3", shape.volume);
  add("unit_inertia_m5", {inertia[0], inertia[1], inertia[2]});
  text += "\"spheres_x_y_z_r_m\": [";
  const char* separator = "\n";
  for (const Sphere& s : shape.spheres) {
    text += separator + json({s.centre[0], s.centre[1], s.centre[2], s.radius}).dump();
    separator = ",\n";
  }
  text += "\n]}\n";
  return text;
}

void write_clump_shape(const std::string& path, const ClumpShape& shape)
{
  if (!write_atomically(path, clump_shape_text(shape))) refuse(path, "cannot be written.");
}

ClumpShape read_clump_shape(const std::string& path)
{
  const json object = parse(path);
  if (entry(path, object, "format") != format)
    refuse(path,
           "has 'format' = " + object["format"].dump() + ", but it must be \"" + format + "\".");
  ClumpShape shape;
  const json& name = entry(path, object, "name");
  if (!name.is_string()) refuse(path, "has 'name' = " + name.dump() + ", but it must be a text.");
  shape.name = name.get<std::string>();
  const json& volume = entry(path, object, "volume_m3");
  shape.volume = numbers(path, json::array({volume}), "volume_m3", 1)[0];
  require_positive(path, "volume_m3", shape.volume);
  const auto inertia = numbers(path, entry(path, object, "unit_inertia_m5"), "unit_inertia_m5", 3);
  for (int k = 0; k < 3; ++k) {
    require_positive(path, "unit_inertia_m5[" + std::to_string(k) + "]", inertia[k]);
    shape.unit_inertia[k] = inertia[k];
  }
  const json& spheres = entry(path, object, "spheres_x_y_z_r_m");
  if (!spheres.is_array() || spheres.empty())
    refuse(path, "has no sphere under 'spheres_x_y_z_r_m'.");
  for (const json& sphere : spheres) {
    const std::string place = "spheres_x_y_z_r_m[" + std::to_string(shape.spheres.size()) + "]";
    const auto x = numbers(path, sphere, place, 4);
    require_positive(path, place + "[3]", x[3]);
    shape.spheres.push_back({{x[0], x[1], x[2]}, x[3]});
  }
  return shape;
}
} // namespace interlock::dem
