// Series of frames in a test's folder, and a reader of them: the XDMF text is read as XML, the
// numbers with deal.II's HDF5 classes.
#pragma once

#include "coupling/output/field_output.h"
#include "tests/temporary_folder.h"

#include <deal.II/base/hdf5.h>

#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace field_output_test
{
using namespace interlock::coupling;
namespace fs = std::filesystem;
namespace h5 = dealii::HDF5;
using Tree = boost::property_tree::ptree;

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

inline const std::vector<double> two_points = {0, 0.5, 1, 2, 2.5, 3};
} // namespace field_output_test
