// Time series of points or lines with fields on them, for ParaView and for scripts: NAME.xdmf says
// what there is, NAME.h5 holds the numbers.
//
// Each frame is a file of its own, frames/NAME_000012.vtkhdf, written whole under a temporary name
// and then renamed: a kill, a full disk or a reader in the middle can spoil none. NAME.h5 is their
// index: /frame_000012 in it is a link to the data of that frame. So in Python:
//   f = h5py.File("contacts.h5"); f["frame_000003/force"][:]; f["frame_000003/force"].attrs["unit"]
//
// A frame holds the attribute `time` [s] and the data sets
//   points   n x 3   float    coordinates in the world frame, attribute unit = "m"
//   lines    m x 2   integer  the two points of each line, from 0 (a series of lines only)
//   vertices n       integer  0 to n - 1 (a series of points only: ParaView's newer XDMF reader
//                             makes no cells without it, and shows nothing)
//   FIELD    n, n x 3, m or m x 3   float, attribute unit, for example "N"
// where n counts points and m lines. The same arrays stand, by links, in the group VTKHDF as the
// format of this name wants them (VTK File Formats, "VTKHDF"; an unstructured grid, version 1.0),
// so that VTK, which Debian builds without a reader of XDMF, reads a frame:
//   r = vtkHDFReader(); r.SetFileName("frames/contacts_000003.vtkhdf"); r.Update(); r.GetOutput()
//
// NAME.xdmf names a field with its unit, "velocity [m/s]", for ParaView's menus and colour bars; an
// HDF5 file cannot, for the sake of the slash. It leaves out frames without a point or without a
// line, which ParaView's older XDMF reader cannot read; it is not there while there is no other
// frame. NAME.h5 has all of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace interlock::coupling
{
enum class FieldSupport {
  points, // one value for each point
  cells   // one value for each line, in a series of lines
};

struct OutputField {
  std::string name; // lower_case
  std::string unit; // "N"; "-" for pure numbers
  FieldSupport support = FieldSupport::points;
  int components = 1; // 1 or 3 (a vector in the world frame)
  std::vector<double>
      values; // components x number of points or lines, a vector's components together
};

class FieldSeries
{
public:
  enum class Topology { points, lines };

  // `stem` is the path without ending: "results/quick/contacts". Writes nothing yet.
  FieldSeries(const std::filesystem::path& stem, Topology topology);

  // Deletes the files of an earlier run, or makes what is there fit the frames that this series has
  // read from a state: those beyond are deleted. Throws InputError, one sentence, when one of its
  // frames is not there any more.
  void start();
  void rewind();

  // Adds a frame. `points`: x, y, z of each point [m]; `lines`: both point numbers of each line,
  // empty for a series of points. Afterwards all files are closed and complete. Throws
  // std::invalid_argument when the sizes do not fit, std::runtime_error, with the reason, when a
  // file cannot be written; the frames before are as they were then.
  void write(double time, const std::vector<double>& points, const std::vector<int>& lines,
             const std::vector<OutputField>& fields);

  // Frames so far.
  int frames() const { return static_cast<int>(grids_.size()); }

  // Coordinates of the first frame as they are in its file, in single precision [m]: what
  // displacements are measured from, after a restart too. Empty before the first frame.
  const std::vector<float>& first_points();

  template <class Archive> friend void exchange(Archive& archive, FieldSeries& series)
  {
    archive("grids", series.grids_);
  }

private:
  std::filesystem::path frame_file(int frame) const;
  void delete_frames_from(int frame) const;
  std::string grid_text(double time, std::size_t n_points, std::size_t n_lines,
                        const std::vector<OutputField>& fields) const;
  void write_index() const;

  std::filesystem::path stem_;
  Topology topology_;
  std::vector<std::string> grids_;  // XDMF text of each frame, empty where that is left out
  std::vector<float> first_points_; // in the file of the first frame, so not in a state
};
} // namespace interlock::coupling
