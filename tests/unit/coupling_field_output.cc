// ParaView's time series. It takes a wrong value, shape or unit in the HDF5 file, an XDMF file that
// points at a data set that is not there or has another size, or a frame that is listed before it
// is complete, to fail. The XDMF text is read as XML, the numbers with deal.II's HDF5 classes.
#include "coupling/output/field_output.h"
#include "tests/temporary_folder.h"

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>

#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

using namespace interlock::coupling;
namespace fs = std::filesystem;
namespace h5 = dealii::HDF5;
using Tree = boost::property_tree::ptree;

namespace
{
class FieldOutput : public TemporaryFolderTest
{
protected:
  // The <Grid> elements of the frames, in order.
  std::vector<Tree> frames(const std::string& name) const
  {
    Tree file;
    boost::property_tree::read_xml((folder / (name + ".xdmf")).string(), file);
    const Tree& collection = file.get_child("Xdmf.Domain.Grid");
    EXPECT_EQ(collection.get<std::string>("<xmlattr>.CollectionType"), "Temporal");
    std::vector<Tree> grids;
    for (const auto& child : collection)
      if (child.first == "Grid") grids.push_back(child.second);
    return grids;
  }

  // The data set behind a <DataItem>; checks that it has the dimensions that the item states.
  h5::DataSet data_of(const Tree& element) const
  {
    const Tree& item = element.get_child("DataItem");
    const std::string reference = item.data();
    const auto colon = reference.find(":/");
    h5::File file((folder / reference.substr(0, colon)).string(), h5::File::FileAccessMode::open);
    h5::DataSet data = file.open_dataset(reference.substr(colon + 2));
    std::istringstream stated(item.get<std::string>("<xmlattr>.Dimensions"));
    std::vector<hsize_t> dimensions;
    for (hsize_t size; stated >> size;) dimensions.push_back(size);
    EXPECT_EQ(data.get_dimensions(), dimensions) << reference;
    return data;
  }
};

const std::vector<double> two_points = {0, 0.5, 1, 2, 2.5, 3};
} // namespace

TEST_F(FieldOutput, ReadsBackPointsWithScalarAndVectorFields)
{
  XdmfSeries series(folder / "clumps", XdmfSeries::Topology::points);
  series.write(0.25, two_points, {},
               {{"radius", "m", FieldSupport::points, 1, {0.125, 0.25}},
                {"velocity", "m/s", FieldSupport::points, 3, {1, 2, 3, 4, 5, 6}}});

  const Tree frame = frames("clumps").at(0);
  EXPECT_EQ(frame.get<double>("Time.<xmlattr>.Value"), 0.25);
  EXPECT_EQ(frame.get<std::string>("Topology.<xmlattr>.TopologyType"), "Polyvertex");
  EXPECT_EQ(frame.get<int>("Topology.<xmlattr>.NumberOfElements"), 2);
  EXPECT_EQ(data_of(frame.get_child("Topology")).read<std::vector<double>>(),
            (std::vector<double>{0, 1}));
  h5::DataSet points = data_of(frame.get_child("Geometry"));
  const auto coordinates = points.read<dealii::FullMatrix<double>>();
  for (int i = 0; i < 6; ++i) EXPECT_EQ(coordinates(i / 3, i % 3), two_points[i]);
  EXPECT_EQ(points.get_attribute<std::string>("unit"), "m");

  std::map<std::string, Tree> attributes;
  for (const auto& child : frame)
    if (child.first == "Attribute")
      attributes[child.second.get<std::string>("<xmlattr>.Name")] = child.second;
  ASSERT_EQ(attributes.size(), 2u);
  EXPECT_EQ(attributes["radius"].get<std::string>("<xmlattr>.Center"), "Node");
  h5::DataSet radius = data_of(attributes["radius"]);
  EXPECT_EQ(radius.read<std::vector<double>>(), (std::vector<double>{0.125, 0.25}));
  EXPECT_EQ(radius.get_attribute<std::string>("unit"), "m");
  EXPECT_EQ(attributes["velocity"].get<std::string>("<xmlattr>.AttributeType"), "Vector");
  h5::DataSet velocity = data_of(attributes["velocity"]);
  EXPECT_EQ(velocity.read<dealii::FullMatrix<double>>()(1, 0), 4);
  EXPECT_EQ(velocity.get_attribute<std::string>("unit"), "m/s");
}

TEST_F(FieldOutput, ReadsBackLinesWithFieldsOnCells)
{
  XdmfSeries series(folder / "contacts", XdmfSeries::Topology::lines);
  series.write(0, {0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 1, 2, 1},
               {{"force", "N", FieldSupport::cells, 1, {10, 20}}});

  const Tree frame = frames("contacts").at(0);
  EXPECT_EQ(frame.get<std::string>("Topology.<xmlattr>.TopologyType"), "Polyline");
  EXPECT_EQ(frame.get<int>("Topology.<xmlattr>.NumberOfElements"), 2);
  EXPECT_EQ(frame.get<int>("Topology.<xmlattr>.NodesPerElement"), 2);
  const auto lines = data_of(frame.get_child("Topology")).read<dealii::FullMatrix<double>>();
  EXPECT_EQ(lines(1, 0), 2);
  EXPECT_EQ(lines(1, 1), 1);
  EXPECT_EQ(frame.get<std::string>("Attribute.<xmlattr>.Center"), "Cell");
  EXPECT_EQ(data_of(frame.get_child("Attribute")).read<std::vector<double>>(),
            (std::vector<double>{10, 20}));
}

// Stones come and go, and so do contacts, down to none at all.
TEST_F(FieldOutput, FramesMayDifferInSizeAndCanBeReadAfterEach)
{
  XdmfSeries series(folder / "contacts", XdmfSeries::Topology::lines);
  for (int frame = 0; frame < 3; ++frame) {
    const bool any = frame != 1;
    series.write(0.1 * frame, any ? two_points : std::vector<double>(),
                 any ? std::vector<int>{0, 1} : std::vector<int>(),
                 {{"force", "N", FieldSupport::cells, 1,
                   any ? std::vector<double>{1. * frame} : std::vector<double>()}});
    EXPECT_EQ(series.frames(), frame + 1);
    const std::vector<Tree> read = frames("contacts");
    ASSERT_EQ(read.size(), frame + 1u);
    EXPECT_EQ(read.back().get<double>("Time.<xmlattr>.Value"), 0.1 * frame);
    EXPECT_EQ(data_of(read.back().get_child("Attribute")).get_size(), any ? 1u : 0u);
    EXPECT_FALSE(fs::exists(folder / "contacts.xdmf.part"));
  }
  EXPECT_EQ(data_of(frames("contacts").at(2).get_child("Attribute")).read<std::vector<double>>(),
            std::vector<double>{2});
}

TEST_F(FieldOutput, ReplacesTheSeriesOfAnEarlierRun)
{
  for (int run = 0; run < 2; ++run) {
    XdmfSeries series(folder / "clumps", XdmfSeries::Topology::points);
    EXPECT_FALSE(fs::exists(folder / "clumps.xdmf"));
    series.write(run, two_points, {}, {});
    EXPECT_EQ(frames("clumps").size(), 1u);
    EXPECT_EQ(frames("clumps").at(0).get<int>("Time.<xmlattr>.Value"), run);
  }
}

TEST_F(FieldOutput, RefusesSizesThatDoNotFitAndWritesNothing)
{
  XdmfSeries series(folder / "clumps", XdmfSeries::Topology::points);
  EXPECT_THROW(series.write(0, {1, 2}, {}, {}), std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {0, 1}, {}), std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {}, {{"radius", "m", FieldSupport::points, 1, {1}}}),
               std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {}, {{"stress", "Pa", FieldSupport::points, 6, {}}}),
               std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(folder));
}
