// Supports and loads of a laboratory test as a user writes them, by the names of node sets:
//   Supports = front: all; back: x=0.002 y z      Loads = middle: fz=-5 mx=0.1
#pragma once

#include "fem/statics/static_solver.h"

#include <map>
#include <string>
#include <vector>

namespace interlock::coupling
{
using NodeSets = std::map<std::string, std::vector<int>>;

// Freedoms x y z [m], rx ry rz [rad] of a set of nodes, held or moved to a value; "all": all six,
// held.
struct SupportCondition {
  std::string set;
  std::vector<std::pair<int, double>> freedoms; // component 0-5, value
};
// A force fx fy fz [N] and a moment mx my mz [N m] that the nodes of a set share equally.
struct LoadCondition {
  std::string set;
  fem::NodeLoad load = fem::NodeLoad::Zero();
};

// Conditions are separated by semicolons. Throw InputError, one sentence with what was not
// understood.
std::vector<SupportCondition> parse_supports(const std::string& text);
std::vector<LoadCondition> parse_loads(const std::string& text);

// Throws InputError, with the names that there are, for an unknown set.
const std::vector<int>& nodes_of(const std::string& set, const NodeSets& sets);

// Sets `share` of the values on the solver; loads add to those that are there. Throw as nodes_of.
void apply(const std::vector<SupportCondition>& supports, double share, const NodeSets& sets,
           fem::StaticSolver& solver);
void apply(const std::vector<LoadCondition>& loads, double share, const NodeSets& sets,
           fem::StaticSolver& solver);

// Of a flat piece: front (smallest x), back, right (smallest y), left, rim (all four), middle (the
// node nearest to the middle), everywhere.
NodeSets node_sets_of_piece(const fem::Lattice& lattice);
} // namespace interlock::coupling
