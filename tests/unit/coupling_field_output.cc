// ParaView's time series. It takes a wrong value, shape or unit in the HDF5 file, an XDMF file that
// points at a data set that is not there or has another size, a frame that is listed before it is
// complete, a series that goes on otherwise than without the interruption, or a full disk that
// spoils a frame, to fail. The XDMF text is read as XML, the numbers with deal.II's HDF5 classes.
#include "coupling/files/atomic_file.h"
#include "coupling/files/hdf5_memory.h"
#include "coupling/output/field_output.h"
#include "coupling/state/state_archive.h"
#include "tests/refusal.h"
#include "tests/small_disk.h"
#include "tests/temporary_folder.h"

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>

#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <hdf5.h>

#include <filesystem>
#include <memory>
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

  // A frame of a series of lines that tells which one it is.
  static void write_frame(FieldSeries& series)
  {
    const int n = series.frames();
    series.write(0.1 * n, {0, 0.5, 1, 2, 2.5, 3. + n}, {0, 1},
                 {{"force", "N", FieldSupport::cells, 1, {10. * n}}});
  }

  int frame_files(const std::string& sub = "") const
  {
    const fs::path frames = folder / sub / "frames";
    if (!fs::exists(frames)) return 0;
    return static_cast<int>(
        std::distance(fs::directory_iterator(frames), fs::directory_iterator()));
  }

  // Relative to the sub-folder, sorted.
  std::vector<fs::path> files_below(const std::string& sub) const
  {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / sub))
      if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder / sub));
    std::sort(files.begin(), files.end());
    return files;
  }
};

const std::vector<double> two_points = {0, 0.5, 1, 2, 2.5, 3};
} // namespace

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

// --- Going on ----------------------------------------------------------------------------------

// The run is stopped when it has written more frames than its state knows of; it goes on in another
// process, and nothing tells the files from those of a run that was left alone.
TEST_F(FieldOutput, GoesOnWithTheSameFiles)
{
  FieldSeries whole(folder / "whole" / "contacts", FieldSeries::Topology::lines);
  fs::create_directory(folder / "whole");
  whole.start();
  for (int frame = 0; frame < 5; ++frame) write_frame(whole);

  fs::create_directory(folder / "cut");
  for (int kept = 0; kept <= 5; ++kept)
    for (const int beyond : {0, 1, 3}) {
      const StateTree state = [&] {
        FieldSeries series(folder / "cut" / "contacts", FieldSeries::Topology::lines);
        series.start();
        for (int frame = 0; frame < kept; ++frame) write_frame(series);
        StateTree tree;
        StateWriter archive(tree);
        archive("series", series);
        for (int frame = 0; frame < beyond; ++frame)
          series.write(9, {}, {}, {}); // not what comes then
        return tree;
      }();
      FieldSeries series(folder / "cut" / "contacts", FieldSeries::Topology::lines);
      StateReader archive(state);
      archive("series", series);
      series.rewind();
      EXPECT_EQ(series.frames(), kept);
      EXPECT_EQ(frame_files("cut"), kept); // those beyond are gone
      if (kept > 0) {
        EXPECT_EQ(frames("cut/contacts").size(), std::size_t(kept));
      } else {
        EXPECT_FALSE(fs::exists(folder / "cut" / "contacts.xdmf"));
      }
      while (series.frames() < 5) write_frame(series);
      const std::vector<fs::path> files = files_below("whole");
      ASSERT_EQ(files.size(), 7u);
      ASSERT_EQ(files_below("cut"), files);
      for (const fs::path& file : files)
        ASSERT_EQ(file_text(folder / "cut" / file), file_text(folder / "whole" / file))
            << file << " after " << kept << " frames and " << beyond << " beyond";
    }
}

TEST_F(FieldOutput, RefusesToGoOnWithoutAFrame)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  series.start();
  for (int frame = 0; frame < 3; ++frame) write_frame(series);
  fs::remove(folder / "frames" / "contacts_000001.vtkhdf");
  expect_refusal([&] { series.rewind(); }, (folder / "frames" / "contacts_000001.vtkhdf").string(),
                 {"is not there any more"});
  EXPECT_TRUE(fs::exists(folder / "frames" / "contacts_000002.vtkhdf"));
}

// Another series in the folder is none of its business.
TEST_F(FieldOutput, LeavesOtherSeriesAlone)
{
  FieldSeries clumps(folder / "clumps", FieldSeries::Topology::points);
  clumps.start();
  clumps.write(0, two_points, {}, {});
  FieldSeries contacts(folder / "contacts", FieldSeries::Topology::lines);
  contacts.start();
  write_frame(contacts);
  contacts.start();
  EXPECT_EQ(frame_files(), 1);
  EXPECT_EQ(frames("clumps").size(), 1u);
}

// --- Full disks --------------------------------------------------------------------------------

// The frame, or the index that would list it, finds no room: the frames before are as they were,
// and the series goes on when there is room again.
TEST_F(FieldOutput, FullDiskSpoilsNoFrame)
{
  FieldSeries series(folder / "contacts", FieldSeries::Topology::lines);
  series.start();
  while (series.frames() < 24) write_frame(series);
  const std::vector<fs::path> files = files_below("");
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(file_text(folder / file));
  const std::size_t frame_size = fs::file_size(folder / "frames" / "contacts_000000.vtkhdf"),
                    xdmf_size = fs::file_size(folder / "contacts.xdmf");
  ASSERT_GT(xdmf_size, frame_size + 100);

  for (const auto& [room, file] :
       {std::pair<std::size_t, fs::path>{frame_size / 2,
                                         folder / "frames" / "contacts_000024.vtkhdf"},
        {frame_size + 100, folder / "contacts.xdmf"}}) {
    try {
      const SmallDisk disk(room);
      write_frame(series);
      ADD_FAILURE() << "written with room for " << room << " bytes";
    } catch (const WriteError& error) {
      EXPECT_EQ(std::string(error.what()),
                "the file " + file.string() + " cannot be written: File too large");
    }
    EXPECT_EQ(series.frames(), 24);
    for (std::size_t k = 0; k < files.size(); ++k)
      EXPECT_EQ(file_text(folder / files[k]), texts[k]) << files[k];
    for (const fs::path& any : files_below("")) EXPECT_NE(any.extension(), ".part") << any;
  }
  write_frame(series);
  EXPECT_EQ(frames("contacts").size(), 25u);
  EXPECT_EQ(data_of(frames("contacts").at(24).get_child("Attribute")).read<std::vector<double>>(),
            std::vector<double>{240});
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
