#include "coupling/packing/packed_state.h"

#include "coupling/files/compressed_file.h"
#include "dem/input_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;
using dem::Vector3;
using nlohmann::json;
constexpr const char* format = "clump-workload-1";

// The mass and inertia of a file have as many digits as their writer gave them [-].
constexpr double rounding = 1e-6;

std::string six_digits(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// One file, to name it in every sentence. `place` is the way to a value: "shapes[2]/mass".
class Reader
{
public:
  explicit Reader(const fs::path& file) : file_(file) {}

  PackedState read() const
  {
    const json root = parse();
    if (!root.is_object()) refuse("does not hold a JSON object.");
    const json& name = entry(root, "", "format");
    if (name != format) refuse_value("format", name, std::string("\"") + format + "\"");

    PackedState state;
    state.box = positive_vector(root, "", "box");
    state.density = positive_number(root, "", "density");
    for (const json& shape : list(root, "shapes"))
      state.shapes.push_back(
          shape_of(shape, element("shapes", state.shapes.size()), state.density));
    for (const json& clump : list(root, "clumps"))
      state.clumps.push_back(clump_of(clump, element("clumps", state.clumps.size()), state));
    return state;
  }

private:
  [[noreturn]] void refuse(const std::string& what) const
  {
    throw InputError("The packed state \"" + file_.string() + "\" " + what);
  }

  [[noreturn]] void refuse_value(const std::string& place, const json& value,
                                 const std::string& allowed) const
  {
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 80) text = text.substr(0, 80) + " ...";
    refuse("has " + place + " = " + text + ", but it must be " + allowed + ".");
  }

  json parse() const
  {
    try {
      return json::parse(read_maybe_compressed(file_));
    } catch (const json::parse_error& error) {
      refuse("is not JSON: error at byte " + std::to_string(error.byte) + ".");
    } catch (const json::exception&) {
      refuse("holds a number that is too large.");
    }
  }

  static std::string element(const std::string& name, std::size_t index)
  {
    return name + "[" + std::to_string(index) + "]";
  }
  static std::string join(const std::string& place, const char* name)
  {
    return place.empty() ? name : place + "/" + name;
  }

  const json& entry(const json& object, const std::string& place, const char* name) const
  {
    if (!object.is_object()) refuse_value(place, object, "an object with named entries");
    const auto found = object.find(name);
    if (found != object.end()) return *found;
    std::string present;
    for (const auto& item : object.items()) present += (present.empty() ? "" : ", ") + item.key();
    refuse("has no entry \"" + join(place, name) + "\" (there is: " + present + ").");
  }

  const json& list(const json& root, const char* name) const
  {
    const json& value = entry(root, "", name);
    if (!value.is_array() || value.empty())
      refuse_value(name, value, "a list in brackets with one element or more");
    return value;
  }

  double number(const json& object, const std::string& place, const char* name) const
  {
    const json& value = entry(object, place, name);
    if (!value.is_number()) refuse_value(join(place, name), value, "a number");
    return value.get<double>();
  }

  double positive_number(const json& object, const std::string& place, const char* name) const
  {
    const double value = number(object, place, name);
    if (!(value > 0)) refuse_value(join(place, name), value, "a number greater than 0");
    return value;
  }

  std::vector<double> numbers(const json& value, const std::string& place, std::size_t size) const
  {
    const auto is_number = [](const json& x) { return x.is_number(); };
    if (!value.is_array() || value.size() != size ||
        !std::all_of(value.begin(), value.end(), is_number))
      refuse_value(place, value, std::to_string(size) + " numbers in brackets");
    return value.get<std::vector<double>>();
  }

  Vector3 vector(const json& object, const std::string& place, const char* name) const
  {
    const auto x = numbers(entry(object, place, name), join(place, name), 3);
    return {x[0], x[1], x[2]};
  }

  Vector3 positive_vector(const json& object, const std::string& place, const char* name) const
  {
    const Vector3 x = vector(object, place, name);
    if (!(x.minCoeff() > 0))
      refuse_value(join(place, name), object[name], "3 numbers greater than 0");
    return x;
  }

  dem::ClumpShape shape_of(const json& object, const std::string& place, double density) const
  {
    dem::ClumpShape shape;
    shape.name = place;
    shape.volume = positive_number(object, place, "volume");
    const double mass = positive_number(object, place, "mass");
    if (std::abs(mass / (density * shape.volume) - 1) > rounding)
      refuse_value(join(place, "mass"), mass,
                   "density times volume, " + six_digits(density * shape.volume) + " kg");
    const Vector3 inertia = positive_vector(object, place, "inertia");
    if (2 * inertia.maxCoeff() > (1 + rounding) * inertia.sum())
      refuse_value(join(place, "inertia"), object["inertia"],
                   "3 moments of which none is larger than the sum of the other two");
    shape.unit_inertia = inertia / density;

    const json& spheres = entry(object, place, "spheres");
    if (!spheres.is_array() || spheres.empty())
      refuse_value(join(place, "spheres"), spheres, "a list in brackets with one sphere or more");
    for (const json& sphere : spheres) {
      const std::string sphere_place = element(join(place, "spheres"), shape.spheres.size());
      const auto x = numbers(sphere, sphere_place, 4);
      if (!(x[3] > 0)) refuse_value(sphere_place, sphere, "x, y, z and a radius greater than 0");
      shape.spheres.push_back({{x[0], x[1], x[2]}, x[3]});
    }
    return shape;
  }

  PackedClump clump_of(const json& object, const std::string& place, const PackedState& state) const
  {
    PackedClump clump;
    const json& shape = entry(object, place, "shape");
    const auto n_shapes = state.shapes.size();
    if (!shape.is_number_unsigned() || shape.get<std::size_t>() >= n_shapes)
      refuse_value(join(place, "shape"), shape,
                   "a whole number from 0 to " + std::to_string(n_shapes - 1) +
                       ", the index of a shape");
    clump.shape = shape.get<int>();
    clump.position = vector(object, place, "pos");
    const Vector3& x = clump.position;
    if (!(x.minCoeff() > 0 && x.x() < state.box.x() && x.y() < state.box.y()))
      refuse_value(join(place, "pos"), object["pos"],
                   "above the floor and between the walls of the box");
    const auto q = numbers(entry(object, place, "quat"), join(place, "quat"), 4);
    clump.orientation = dem::Quaternion(q[0], q[1], q[2], q[3]);
    if (!(std::abs(clump.orientation.norm() - 1) < rounding))
      refuse_value(join(place, "quat"), object["quat"], "of length 1 (w, x, y, z)");
    clump.orientation.normalize();
    clump.velocity = vector(object, place, "vel");
    clump.spin = vector(object, place, "omega");
    return clump;
  }

  fs::path file_;
};

json array(const Vector3& x)
{
  return {x[0], x[1], x[2]};
}

json to_json(const dem::ClumpShape& shape, double density)
{
  json spheres = json::array();
  for (const dem::Sphere& s : shape.spheres)
    spheres.push_back({s.centre[0], s.centre[1], s.centre[2], s.radius});
  return {{"volume", shape.volume},
          {"mass", density * shape.volume},
          {"inertia", array(density * shape.unit_inertia)},
          {"rbound", shape.bounding_radius()},
          {"spheres", spheres}};
}

json to_json(const PackedClump& clump)
{
  const dem::Quaternion& q = clump.orientation;
  return {{"shape", clump.shape},
          {"pos", array(clump.position)},
          {"quat", {q.w(), q.x(), q.y(), q.z()}},
          {"vel", array(clump.velocity)},
          {"omega", array(clump.spin)}};
}
} // namespace

bool is_packed_state_name(const fs::path& file)
{
  const fs::path name = file.extension() == ".gz" ? file.stem() : file.filename();
  return name.extension() == ".json";
}

PackedState read_packed_state(const fs::path& file)
{
  return Reader(file).read();
}

void write_packed_state(const fs::path& file, const PackedState& state)
{
  json root = {{"format", format}, {"box", array(state.box)}, {"density", state.density}};
  for (const dem::ClumpShape& shape : state.shapes)
    root["shapes"].push_back(to_json(shape, state.density));
  for (const PackedClump& clump : state.clumps) root["clumps"].push_back(to_json(clump));
  write_maybe_compressed(file, root.dump() + '\n');
}

void squeeze(PackedState& state, double share)
{
  state.box *= 1 - share;
  for (PackedClump& clump : state.clumps) clump.position *= 1 - share;
}
} // namespace interlock::coupling
