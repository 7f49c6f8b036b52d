// How good clumps are, for people (on the terminal) and for programs (JSON).
#pragma once

#include "dem/generator/clump_generator.h"
#include "dem/scans/mesh_diagnosis.h"
#include "dem/scans/point_cloud.h"
#include "dem/stones/stone_size.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace interlock::apps
{
// One stone and the clump made of it.
struct ClumpResult {
  std::string file, name;
  std::size_t nodes = 0, facets = 0; // a cloud of points has no facet
  dem::MeshDiagnosis mesh;           // of a mesh
  dem::PointCloudDiagnosis cloud;    // of a cloud of points
  dem::StoneSize size;
  double volume = 0;  // of the stone [m3]
  double density = 0; // of the rock; 0: not given [kg/m3]
  dem::ClumpShape shape;
  dem::ClumpReport report;
  dem::ClumpParameters parameters;
};

// One stone on a page.
void print_clump(const ClumpResult& result);

// What was mended or left as it is in the file, and what its form or its noise makes of the
// numbers, one sentence each; empty for a sound file.
std::string remarks(const ClumpResult& result);

// Many stones, one a row: head, rows, means.
void print_clump_table_head();
void print_clump_table_row(const ClumpResult& result);
void print_clump_table_means(const std::vector<ClumpResult>& results);

// One sentence a target that was asked for and not met; empty when all were.
std::string missed_targets(const ClumpResult& result);

nlohmann::ordered_json clump_json(const ClumpResult& result);
} // namespace interlock::apps
