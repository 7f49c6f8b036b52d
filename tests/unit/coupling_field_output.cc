// ParaView's time series. It takes a wrong value, shape or unit in the HDF5 file, an XDMF file that
// points at a data set that is not there or has another size, or a frame that is listed before it
// is complete, to fail.
#include "coupling/files/hdf5_memory.h"
#include "coupling/state/state_archive.h"
#include "tests/field_output_test.h"

#include <deal.II/lac/full_matrix.h>

#include <hdf5.h>

#include <memory>

using namespace field_output_test;

TEST_F(FieldOutput, ReadsBackPointsWithScalarAndVectorFields)
{
  FieldSeries series(folder / "clumps", FieldSeries::Topology::points);
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
  // Named with its unit for ParaView's menus; in the HDF5 file the name stands alone.
  EXPECT_EQ(attributes["radius [m]"].get<std::string>("<xmlattr>.Center"), "Node");
  h5::DataSet radius = data_of(attributes["radius [m]"]);
  EXPECT_EQ(radius.read<std::vector<double>>(), (std::vector<double>{0.125, 0.25}));
  EXPECT_EQ(radius.get_attribute<std::string>("unit"), "m");
  EXPECT_EQ(attributes["velocity [m/s]"].get<std::string>("<xmlattr>.AttributeType"), "Vector");
  h5::DataSet velocity = data_of(attributes["velocity [m/s]"]);
  EXPECT_EQ(velocity.read<dealii::FullMatrix<double>>()(1, 0), 4);
  EXPECT_EQ(velocity.get_attribute<std::string>("unit"), "m/s");
}

TEST_F(FieldOutput, ReadsBackLinesWithFieldsOnCells)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  series.write(0, {0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 1, 2, 1},
               {{"kind", "-", FieldSupport::cells, 1, {10, 20}}});

  const Tree frame = frames("contacts").at(0);
  EXPECT_EQ(frame.get<std::string>("Topology.<xmlattr>.TopologyType"), "Polyline");
  EXPECT_EQ(frame.get<int>("Topology.<xmlattr>.NumberOfElements"), 2);
  EXPECT_EQ(frame.get<int>("Topology.<xmlattr>.NodesPerElement"), 2);
  const auto lines = data_of(frame.get_child("Topology")).read<dealii::FullMatrix<double>>();
  EXPECT_EQ(lines(1, 0), 2);
  EXPECT_EQ(lines(1, 1), 1);
  EXPECT_EQ(frame.get<std::string>("Attribute.<xmlattr>.Center"), "Cell");
  EXPECT_EQ(frame.get<std::string>("Attribute.<xmlattr>.Name"), "kind"); // a pure number
  EXPECT_EQ(data_of(frame.get_child("Attribute")).read<std::vector<double>>(),
            (std::vector<double>{10, 20}));
}

// Stones come and go, and so do contacts, down to none at all: such a frame is in the HDF5 file,
// but not in the XDMF file, since ParaView cannot read a data set of size 0.
TEST_F(FieldOutput, FramesMayDifferInSizeAndCanBeReadAfterEach)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  for (int frame = 0; frame < 4; ++frame) {
    const bool any = frame == 1 || frame == 3;
    series.write(0.1 * frame, any ? two_points : std::vector<double>(),
                 any ? std::vector<int>{0, 1} : std::vector<int>(),
                 {{"force", "N", FieldSupport::cells, 1,
                   any ? std::vector<double>{1. * frame} : std::vector<double>()}});
    EXPECT_EQ(series.frames(), frame + 1);
    h5::File index((folder / "contacts.h5").string(), h5::File::FileAccessMode::open);
    EXPECT_EQ(index.open_dataset("frame_00000" + std::to_string(frame) + "/force").get_size(),
              any ? 1u : 0u);
    EXPECT_FALSE(fs::exists(folder / "contacts.xdmf.part"));
    EXPECT_EQ(fs::exists(folder / "contacts.xdmf"), frame > 0); // while there is nothing to see
    if (frame == 0) continue;
    const std::vector<Tree> read = frames("contacts");
    ASSERT_EQ(read.size(), frame < 3 ? 1u : 2u);
    const int last = frame < 3 ? 1 : 3;
    EXPECT_EQ(read.back().get<double>("Time.<xmlattr>.Value"), 0.1 * last);
    EXPECT_EQ(data_of(read.back().get_child("Attribute")).read<std::vector<double>>(),
              std::vector<double>{1. * last});
  }
}

// Lines without points to join cannot be; points without lines are as little to be seen.
TEST_F(FieldOutput, PointsWithoutLinesAreLeftOutToo)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  series.write(0, two_points, {}, {});
  EXPECT_FALSE(fs::exists(folder / "contacts.xdmf"));
  write_frame(series);
  EXPECT_EQ(frames("contacts").size(), 1u);
}

// A frame as VTK's own reader of its format finds it: one cell for all points, one for each line.
TEST_F(FieldOutput, FramesAreVtkHdfFiles)
{
  FieldSeries points(folder / "clumps", FieldSeries::Topology::points);
  points.write(0, two_points, {}, {{"radius", "m", FieldSupport::points, 1, {0.125, 0.25}}});
  FieldSeries lines(folder / "contacts", FieldSeries::Topology::lines);
  lines.write(0, {0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 1, 2, 1},
              {{"kind", "-", FieldSupport::cells, 1, {10, 20}}});
  lines.write(1, {}, {}, {{"kind", "-", FieldSupport::cells, 1, {}}});

  using Numbers = std::vector<std::int64_t>;
  const auto open = [&](const std::string& name) {
    return std::make_unique<Hdf5Memory>(file_text(folder / "frames" / name));
  };
  const auto integers = [](const Hdf5Memory& file, const std::string& name) {
    Numbers values;
    file.read("VTKHDF/" + name, values);
    return values;
  };
  const auto numbers = [](const Hdf5Memory& file, const std::string& name) {
    std::vector<double> values;
    file.read("VTKHDF/" + name, values);
    return values;
  };
  const auto clumps = open("clumps_000000.vtkhdf");
  EXPECT_EQ(integers(*clumps, "NumberOfPoints"), Numbers{2});
  EXPECT_EQ(integers(*clumps, "NumberOfCells"), Numbers{1});
  EXPECT_EQ(integers(*clumps, "NumberOfConnectivityIds"), Numbers{2});
  EXPECT_EQ(integers(*clumps, "Connectivity"), (Numbers{0, 1}));
  EXPECT_EQ(integers(*clumps, "Offsets"), (Numbers{0, 2}));
  EXPECT_EQ(integers(*clumps, "Types"), Numbers{2});
  EXPECT_EQ(numbers(*clumps, "Points"), two_points);
  EXPECT_EQ(numbers(*clumps, "PointData/radius"), (std::vector<double>{0.125, 0.25}));

  const auto contacts = open("contacts_000000.vtkhdf");
  EXPECT_EQ(integers(*contacts, "NumberOfPoints"), Numbers{3});
  EXPECT_EQ(integers(*contacts, "NumberOfCells"), Numbers{2});
  EXPECT_EQ(integers(*contacts, "NumberOfConnectivityIds"), Numbers{4});
  EXPECT_EQ(integers(*contacts, "Connectivity"), (Numbers{0, 1, 2, 1}));
  EXPECT_EQ(integers(*contacts, "Offsets"), (Numbers{0, 2, 4}));
  EXPECT_EQ(integers(*contacts, "Types"), (Numbers{3, 3}));
  EXPECT_EQ(numbers(*contacts, "CellData/kind"), (std::vector<double>{10, 20}));

  const auto none = open("contacts_000001.vtkhdf");
  EXPECT_EQ(integers(*none, "NumberOfCells"), Numbers{0});
  EXPECT_EQ(integers(*none, "Offsets"), Numbers{0});

  // What kind of grid it is stands in a text of fixed length, which deal.II does not read.
  const hid_t file = H5Fopen((folder / "frames" / "contacts_000000.vtkhdf").c_str(), H5F_ACC_RDONLY,
                             H5P_DEFAULT),
              attribute = H5Aopen_by_name(file, "VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT),
              type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), ' ');
  EXPECT_GE(H5Aread(attribute, type, text.data()), 0);
  EXPECT_EQ(text, "UnstructuredGrid");
  EXPECT_EQ(H5Tis_variable_str(type), 0);
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(file);
}

// Where displacements are measured from: as the file has it, before and after a restart.
TEST_F(FieldOutput, KnowsTheFirstFrameAfterARestart)
{
  FieldSeries series(folder / "geogrid", FieldSeries::Topology::lines);
  series.start();
  EXPECT_TRUE(series.first_points().empty());
  series.write(0, {0.1, 0.2, 0.3, 1, 2, 3}, {0, 1}, {});
  series.write(1, two_points, {0, 1}, {});
  const std::vector<float> first = {0.1f, 0.2f, 0.3f, 1, 2, 3};
  EXPECT_EQ(series.first_points(), first);

  StateTree tree;
  StateWriter writer(tree);
  writer("series", series);
  FieldSeries later(folder / "geogrid", FieldSeries::Topology::lines);
  StateReader reader(tree);
  reader("series", later);
  later.rewind();
  EXPECT_EQ(later.first_points(), first);
  later.start();
  EXPECT_TRUE(later.first_points().empty());
}

TEST_F(FieldOutput, ReplacesTheSeriesOfAnEarlierRun)
{
  for (int run = 0; run < 2; ++run) {
    FieldSeries series(folder / "clumps", FieldSeries::Topology::points);
    EXPECT_EQ(fs::exists(folder / "clumps.xdmf"), run > 0); // nothing is done before start()
    series.start();
    EXPECT_FALSE(fs::exists(folder / "clumps.xdmf"));
    EXPECT_FALSE(fs::exists(folder / "clumps.h5"));
    EXPECT_EQ(frame_files(), 0);
    for (int frame = 0; frame < 3 - run; ++frame) series.write(run, two_points, {}, {});
    EXPECT_EQ(frames("clumps").size(), 3u - run);
    EXPECT_EQ(frames("clumps").at(0).get<int>("Time.<xmlattr>.Value"), run);
    EXPECT_EQ(frame_files(), 3 - run);
  }
}

// The file for scripts: every frame, by links that hold wherever the reader stands.
TEST_F(FieldOutput, IndexLeadsToEveryFrame)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  series.start();
  for (int frame = 0; frame < 3; ++frame) {
    write_frame(series);
    h5::File index((folder / "contacts.h5").string(), h5::File::FileAccessMode::open);
    for (int n = 0; n <= frame; ++n) {
      const std::string group = "frame_00000" + std::to_string(n);
      EXPECT_TRUE(
          fs::exists(folder / "frames" / ("contacts_00000" + std::to_string(n) + ".vtkhdf")));
      h5::DataSet force = index.open_dataset(group + "/force");
      EXPECT_EQ(force.read<std::vector<double>>(), std::vector<double>{10. * n});
      EXPECT_EQ(force.get_attribute<std::string>("unit"), "N");
      EXPECT_EQ(index.open_group(group).get_attribute<double>("time"), 0.1 * n);
    }
  }
}

TEST_F(FieldOutput, RefusesSizesThatDoNotFitAndWritesNothing)
{
  FieldSeries series(folder / "clumps", FieldSeries::Topology::points);
  EXPECT_THROW(series.write(0, {1, 2}, {}, {}), std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {0, 1}, {}), std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {}, {{"radius", "m", FieldSupport::points, 1, {1}}}),
               std::invalid_argument);
  EXPECT_THROW(series.write(0, two_points, {}, {{"stress", "Pa", FieldSupport::points, 6, {}}}),
               std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(folder));
}
