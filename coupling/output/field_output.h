// Time series of points or lines with fields on them, for ParaView and for scripts: NAME.xdmf says
// what there is, NAME.h5 holds the numbers.
//
// Layout of NAME.h5: one group for each frame, /frame_000000, /frame_000001, ..., with the
// attribute `time` [s] and the data sets
//   points   n x 3   float    coordinates in the world frame, attribute unit = "m"
//   lines    m x 2   integer  the two points of each line, from 0 (a series of lines only)
//   vertices n       integer  0 to n - 1 (a series of points only: ParaView's newer XDMF reader
//   makes no
//                             cells without it, and shows nothing)
//   FIELD    n, n x 3, m or m x 3   float, attribute unit, for example "N"
// where n counts points and m lines. So in Python:
//   f = h5py.File("contacts.h5"); f["frame_000003/force"][:]; f["frame_000003/force"].attrs["unit"]
#pragma once

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

class XdmfSeries
{
public:
  enum class Topology { points, lines };

  // `stem` is the path without ending: "results/quick/contacts". Deletes the series of an earlier
  // run.
  XdmfSeries(const std::filesystem::path& stem, Topology topology);

  // Adds a frame. `points`: x, y, z of each point [m]; `lines`: both point numbers of each line,
  // empty for a series of points. Afterwards both files are closed and complete, so the series can
  // be opened while the run goes on, and survives its end by force. Throws std::invalid_argument
  // when the sizes do not fit, std::runtime_error when the files cannot be written.
  void write(double time, const std::vector<double>& points, const std::vector<int>& lines,
             const std::vector<OutputField>& fields);

  // Frames so far.
  int frames() const { return static_cast<int>(grids_.size()); }

private:
  void write_frame(const std::string& group, double time, const std::vector<double>& points,
                   const std::vector<int>& lines, const std::vector<OutputField>& fields) const;
  void write_xdmf() const;

  std::filesystem::path hdf5_file_, xdmf_file_;
  Topology topology_;
  std::vector<std::string> grids_; // XDMF text of each frame
};
} // namespace interlock::coupling
