// The files of a time series over restarts and on full disks. It takes a series that goes on
// otherwise than without the interruption, one that touches another's files, or a full disk that
// spoils a frame, to fail.
#include "coupling/files/atomic_file.h"
#include "coupling/state/state_archive.h"
#include "tests/field_output_test.h"
#include "tests/refusal.h"
#include "tests/small_disk.h"

using namespace field_output_test;

namespace
{
class FieldSeriesFiles : public FieldOutput
{
};
} // namespace

// The run is stopped when it has written more frames than its state knows of; it goes on in another
// process, and nothing tells the files from those of a run that was left alone.
TEST_F(FieldSeriesFiles, GoesOnWithTheSameFiles)
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

TEST_F(FieldSeriesFiles, RefusesToGoOnWithoutAFrame)
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
TEST_F(FieldSeriesFiles, LeavesOtherSeriesAlone)
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

// The frame, or the index that would list it, finds no room: the frames before are as they were,
// and the series goes on when there is room again.
TEST_F(FieldSeriesFiles, FullDiskSpoilsNoFrame)
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
