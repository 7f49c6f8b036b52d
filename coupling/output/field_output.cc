#include "coupling/output/field_output.h"

#include "coupling/files/atomic_file.h"

#include <deal.II/base/hdf5.h>

#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
namespace h5 = dealii::HDF5;

void require(const bool condition, const std::string& sentence)
{
  if (!condition) throw std::invalid_argument("Field output: " + sentence);
}

std::string frame_name(const int frame)
{
  std::ostringstream name;
  name << "frame_" << std::setw(6) << std::setfill('0') << frame;
  return name.str();
}

// A data set of `rows` rows (of `columns` columns, where there is more than one) with its unit.
template <typename Stored, typename Value>
void write_rows(h5::Group& group, const std::string& name, const std::string& unit,
                const std::vector<Value>& values, const std::size_t columns)
{
  std::vector<hsize_t> dimensions = {values.size() / columns};
  if (columns > 1) dimensions.push_back(columns);
  h5::DataSet data = group.create_dataset<Stored>(name, dimensions);
  data.set_attribute("unit", unit);
  if (!values.empty()) data.write(std::vector<Stored>(values.begin(), values.end()));
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
  std::ostringstream text;
  text << "        <Attribute Name=\"" << field.name << "\" AttributeType=\""
       << (columns == 3 ? "Vector" : "Scalar") << "\" Center=\""
       << (field.support == FieldSupport::points ? "Node" : "Cell") << "\">"
       << data_item(path + field.name, field.values.size() / columns, columns, false)
       << "<Information Name=\"unit\" Value=\"" << field.unit << "\"/></Attribute>\n";
  return text.str();
}

std::string topology_element(const XdmfSeries::Topology topology, const std::string& path,
                             const std::size_t points, const std::size_t lines)
{
  const bool vertices = topology == XdmfSeries::Topology::points;
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
} // namespace

XdmfSeries::XdmfSeries(const std::filesystem::path& stem, const Topology topology)
    : hdf5_file_(stem.string() + ".h5"), xdmf_file_(stem.string() + ".xdmf"), topology_(topology)
{
  std::filesystem::remove(xdmf_file_);
  std::filesystem::remove(hdf5_file_);
}

void XdmfSeries::write_frame(const std::string& group_name, const double time,
                             const std::vector<double>& points, const std::vector<int>& lines,
                             const std::vector<OutputField>& fields) const
{
  h5::File file(hdf5_file_.string(),
                grids_.empty() ? h5::File::FileAccessMode::create : h5::File::FileAccessMode::open);
  h5::Group group = file.create_group(group_name);
  group.set_attribute("time", time);
  write_rows<float>(group, "points", "m", points, 3);
  if (topology_ == Topology::lines) {
    write_rows<int>(group, "lines", "-", lines, 2);
  } else {
    std::vector<int> vertices(points.size() / 3);
    std::iota(vertices.begin(), vertices.end(), 0);
    write_rows<int>(group, "vertices", "-", vertices, 1);
  }
  for (const OutputField& field : fields)
    write_rows<float>(group, field.name, field.unit, field.values, field.components);
}

void XdmfSeries::write(const double time, const std::vector<double>& points,
                       const std::vector<int>& lines, const std::vector<OutputField>& fields)
{
  const std::size_t n_points = points.size() / 3, n_lines = lines.size() / 2;
  require(points.size() % 3 == 0, "the coordinates must come in threes");
  require(lines.size() % 2 == 0, "the point numbers of lines must come in pairs");
  require(topology_ == Topology::lines || lines.empty(), "a series of points has no lines");
  for (const OutputField& field : fields) check_field(field, n_points, n_lines);

  const std::string group = frame_name(frames());
  write_frame(group, time, points, lines, fields);

  const std::string path = hdf5_file_.filename().string() + ":/" + group + "/";
  std::ostringstream grid;
  grid << "      <Grid Name=\"" << group << "\" GridType=\"Uniform\">\n        <Time Value=\""
       << std::setprecision(17) << time << "\"/>\n        <Geometry GeometryType=\"XYZ\">"
       << data_item(path + "points", n_points, 3, false) << "</Geometry>\n        "
       << topology_element(topology_, path, n_points, n_lines) << '\n';
  for (const OutputField& field : fields) grid << attribute(field, path);
  grid << "      </Grid>\n";
  grids_.push_back(grid.str());
  write_xdmf();
}

// After the numbers, and by renaming: the file never mentions a frame that is not there yet.
void XdmfSeries::write_xdmf() const
{
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n    <Grid Name=\""
       << hdf5_file_.stem().string() << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const std::string& grid : grids_) text << grid;
  text << "    </Grid>\n  </Domain>\n</Xdmf>\n";
  write_atomically(xdmf_file_, text.str());
}
} // namespace interlock::coupling
