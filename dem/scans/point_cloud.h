// Scans without facets: points on the surface of a stone with their normals.
#pragma once

#include "dem/meshes/mass_properties.h"
#include "dem/scans/stone_file.h"

namespace interlock::dem
{
// normals[i] is the unit outward normal at points[i] [m]; any frame.
struct PointCloud {
  std::vector<Vector3> points, normals;
};

struct PointCloudDiagnosis {
  int points_read = 0;
  int duplicates_dropped = 0;  // points at the place of an earlier one
  bool flipped = false;        // normals turned round, as asked
  int disagreeing_normals = 0; // against those of most of the neighbours; kept
  double closure = 0;          // |sum a n| / sum a over the points [-]; 0 for a closed surface
  double spacing = 0;          // mean distance of neighbours [m]
  double scatter = 0;          // of the points along their normals, see cloud_properties [m]
  double volume_excess = 0;    // by which the scatter makes the volume too large, about [-]
  MassProperties body;         // of unit density, see cloud_properties
  // What else the reader has to say, each the end of a sentence without the full stop.
  std::vector<std::string> notes;
};

// Reads a cloud: .xyz is text with the columns x y z nx ny nz, separated by blanks, commas or
// semicolons, with comments behind # or //; .ply has x, y, z, nx, ny, nz (or normal_x and so on, in
// any case of letters) and no facets. Normals of
// .ply may have any length; in .xyz, which does not name its columns, they must be of length 1 to
// within 10 %, or they may be colours. Throws InputError with one sentence that names the file and
// the line (text) or point: the faults of a file as in read_stone_mesh; no normals; a normal of
// length zero; fewer than fewest_points different points; normals that point inwards, or that
// disagree with their neighbours at more than 1 % of the points; a closure above largest_closure;
// points that scatter along their normals so much that the volume is too large by more than
// largest_volume_excess. options.flip turns the normals, accept_crossings has no meaning.
// `diagnosis` gets what was found, also when it throws.
PointCloud read_point_cloud(const std::string& path, const StoneFileOptions& options,
                            PointCloudDiagnosis* diagnosis = nullptr);
PointCloud read_point_cloud(const std::string& path, double length_unit);
constexpr int fewest_points = 100;
constexpr double largest_closure = 0.05;       // [-]
constexpr double largest_volume_excess = 0.05; // [-]

// Whether read_point_cloud is the reader for this file: .xyz, or a .ply without faces. False for
// what cannot be read at all, so that read_stone_mesh gets to say why.
bool is_point_cloud(const std::string& path);
} // namespace interlock::dem
