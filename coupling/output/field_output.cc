#include "coupling/output/field_output.h"

#include "coupling/files/atomic_file.h"
#include "coupling/files/hdf5_memory.h"
#include "dem/input_error.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;

void require(const bool condition, const std::string& sentence)
{
  if (!condition) throw std::invalid_argument("Field output: " + sentence);
}

constexpr const char* frame_ending = ".vtkhdf";

std::string frame_name(const int frame)
{
  std::ostringstream name;
  name << "frame_" << std::setw(6) << std::setfill('0') << frame;
  return name.str();
}

std::vector<float> single(const std::vector<double>& values)
{
  return {values.begin(), values.end()};
}

// The <DataItem> that points at a data set.
std::string data_item(const std::string& path, const std::size_t rows, const std::size_t columns,
                      const bool integer)
{
  std::ostringstream item;
  item << "<DataItem Dimensions=\"" << rows;
  if (columns > 1) item << ' ' << columns;
  item << "\" NumberType=\"" << (integer ? "Int" : "Float") << "\" Precision=\"4\" Format=\"HDF\">"
       << path << "</DataItem>";
  return item.str();
}

std::string attribute(const OutputField& field, const std::string& path)
{
  const std::size_t columns = field.components;
  const std::string shown = field.unit == "-" ? field.name : field.name + " [" + field.unit + "]";
  std::ostringstream text;
  text << "        <Attribute Name=\"" << shown << "\" AttributeType=\""
       << (columns == 3 ? "Vector" : "Scalar") << "\" Center=\""
       << (field.support == FieldSupport::points ? "Node" : "Cell") << "\">"
       << data_item(path + field.name, field.values.size() / columns, columns, false)
       << "<Information Name=\"unit\" Value=\"" << field.unit << "\"/></Attribute>\n";
  return text.str();
}

std::string topology_element(const FieldSeries::Topology topology, const std::string& path,
                             const std::size_t points, const std::size_t lines)
{
  const bool vertices = topology == FieldSeries::Topology::points;
  std::ostringstream text;
  text << "<Topology TopologyType=\"" << (vertices ? "Polyvertex" : "Polyline")
       << "\" NumberOfElements=\"" << (vertices ? points : lines) << "\" NodesPerElement=\""
       << (vertices ? 1 : 2) << "\">"
       << (vertices ? data_item(path + "vertices", points, 1, true)
                    : data_item(path + "lines", lines, 2, true))
       << "</Topology>";
  return text.str();
}

void check_field(const OutputField& field, const std::size_t points, const std::size_t lines)
{
  const std::size_t places = field.support == FieldSupport::points ? points : lines;
  require(field.components == 1 || field.components == 3,
          "the field " + field.name + " must have 1 or 3 components");
  require(field.values.size() == places * field.components,
          "the field " + field.name + " has " + std::to_string(field.values.size()) +
              " values instead of " + std::to_string(places * field.components));
}
// What VTK's own reader looks for beside the group of the frame. All points are one cell, each line
// is one.
void add_vtk_group(Hdf5Memory& file, const std::string& group, const FieldSeries::Topology topology,
                   const std::size_t n_points, const std::vector<int>& lines,
                   const std::vector<OutputField>& fields)
{
  constexpr std::uint8_t poly_vertex = 2, line = 3; // VTK's cell types
  const bool are_points = topology == FieldSeries::Topology::points;
  const std::size_t n_cells = are_points ? n_points > 0 : lines.size() / 2;
  const std::size_t per_cell = are_points ? n_points : 2;
  const auto count = [&](const std::string& name, const std::size_t n) {
    file.write("VTKHDF/" + name, std::vector<std::int64_t>{static_cast<std::int64_t>(n)}, 1, "");
  };
  file.make_group("/VTKHDF");
  file.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  file.set_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
  count("NumberOfPoints", n_points);
  count("NumberOfCells", n_cells);
  count("NumberOfConnectivityIds", n_cells * per_cell);
  file.link("VTKHDF/Points", group + "/points");
  if (are_points)
    file.link("VTKHDF/Connectivity", group + "/vertices");
  else
    file.write("VTKHDF/Connectivity", lines, 1, "");
  std::vector<int> offsets;
  for (std::size_t k = 0; k <= n_cells; ++k) offsets.push_back(static_cast<int>(k * per_cell));
  file.write("VTKHDF/Offsets", offsets, 1, "");
  file.write("VTKHDF/Types", std::vector<std::uint8_t>(n_cells, are_points ? poly_vertex : line), 1,
             "");
  for (const OutputField& field : fields)
    file.link(std::string("VTKHDF/") +
                  (field.support == FieldSupport::points ? "PointData/" : "CellData/") + field.name,
              group + "/" + field.name);
}
} // namespace

FieldSeries::FieldSeries(const fs::path& stem, const Topology topology)
    : stem_(stem), topology_(topology)
{
}

fs::path FieldSeries::frame_file(int frame) const
{
  std::ostringstream number;
  number << '_' << std::setw(6) << std::setfill('0') << frame << frame_ending;
  return stem_.parent_path() / "frames" / (stem_.filename().string() + number.str());
}

void FieldSeries::start()
{
  grids_.clear();
  first_points_.clear();
  fs::remove(stem_.string() + ".xdmf");
  fs::remove(stem_.string() + ".h5");
  delete_frames_from(0);
}

void FieldSeries::rewind()
{
  for (int frame = 0; frame < frames(); ++frame)
    if (!fs::exists(frame_file(frame)))
      throw InputError("The run cannot go on: its \"" + frame_file(frame).string() +
                       "\" is not there any more.");
  delete_frames_from(frames());
  if (frames() > 0)
    write_index();
  else
    start();
}

void FieldSeries::delete_frames_from(int frame) const
{
  while (fs::remove(frame_file(frame))) ++frame;
}

void FieldSeries::write(const double time, const std::vector<double>& points,
                        const std::vector<int>& lines, const std::vector<OutputField>& fields)
{
  const std::size_t n_points = points.size() / 3, n_lines = lines.size() / 2;
  require(points.size() % 3 == 0, "the coordinates must come in threes");
  require(lines.size() % 2 == 0, "the point numbers of lines must come in pairs");
  require(topology_ == Topology::lines || lines.empty(), "a series of points has no lines");
  for (const OutputField& field : fields) check_field(field, n_points, n_lines);

  const std::string group = frame_name(frames());
  Hdf5Memory file;
  file.make_group("/" + group);
  file.set_attribute("/" + group, "time", time);
  const auto place = [&](const std::string& name) { return group + "/" + name; };
  file.write(place("points"), single(points), 3, "m");
  if (topology_ == Topology::lines) {
    file.write(place("lines"), lines, 2, "-");
  } else {
    std::vector<int> vertices(n_points);
    std::iota(vertices.begin(), vertices.end(), 0);
    file.write(place("vertices"), vertices, 1, "-");
  }
  for (const OutputField& field : fields)
    file.write(place(field.name), single(field.values), field.components, field.unit);
  add_vtk_group(file, group, topology_, n_points, lines, fields);
  fs::create_directories(frame_file(0).parent_path());
  write_atomically(frame_file(frames()), file.bytes());

  const bool empty = n_points == 0 || (topology_ == Topology::lines && n_lines == 0);
  grids_.push_back(empty ? "" : grid_text(time, n_points, n_lines, fields));
  try {
    write_index();
  } catch (...) {
    grids_.pop_back();
    throw;
  }
  if (frames() == 1) first_points_ = single(points);
}

const std::vector<float>& FieldSeries::first_points()
{
  if (frames() == 0 || !first_points_.empty()) return first_points_;
  std::ifstream in(frame_file(0), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::vector<double> points;
  Hdf5Memory(bytes).read(frame_name(0) + "/points", points);
  first_points_ = single(points);
  return first_points_;
}

// Of the frame that comes next.
std::string FieldSeries::grid_text(const double time, const std::size_t n_points,
                                   const std::size_t n_lines,
                                   const std::vector<OutputField>& fields) const
{
  const std::string group = frame_name(frames());
  const std::string path =
      "frames/" + frame_file(frames()).filename().string() + ":/" + group + "/";
  std::ostringstream grid;
  grid << "      <Grid Name=\"" << group << "\" GridType=\"Uniform\">\n        <Time Value=\""
       << std::setprecision(17) << time << "\"/>\n        <Geometry GeometryType=\"XYZ\">"
       << data_item(path + "points", n_points, 3, false) << "</Geometry>\n        "
       << topology_element(topology_, path, n_points, n_lines) << '\n';
  for (const OutputField& field : fields) grid << attribute(field, path);
  grid << "      </Grid>\n";
  return grid.str();
}

// After the numbers, and by renaming: it never mentions a frame that is not there yet.
void FieldSeries::write_index() const
{
  const std::string name = stem_.filename().string();
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n    <Grid Name=\"" << name
       << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const std::string& grid : grids_) text << grid;
  text << "    </Grid>\n  </Domain>\n</Xdmf>\n";
  const auto is_empty = [](const std::string& grid) { return grid.empty(); };
  if (std::all_of(grids_.begin(), grids_.end(), is_empty))
    fs::remove(stem_.string() + ".xdmf");
  else
    write_atomically(stem_.string() + ".xdmf", text.str());

  Hdf5Memory index;
  for (int frame = 0; frame < frames(); ++frame)
    index.link("/" + frame_name(frame), "frames/" + frame_file(frame).filename().string(),
               "/" + frame_name(frame));
  write_atomically(stem_.string() + ".h5", index.bytes());
}
} // namespace interlock::coupling
