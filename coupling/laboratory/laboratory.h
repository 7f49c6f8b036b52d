// The laboratory experiment: virtual tests of a geogrid alone, beside its data sheet
// (docs/theory/geogrid.md).
#pragma once

#include "coupling/laboratory/laboratory_parameters.h"
#include "coupling/laboratory/node_conditions.h"
#include "coupling/output/history.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"
#include "fem/implicit/modes.h"
#include "fem/laboratory/laboratory.h"

#include <chrono>
#include <filesystem>
#include <memory>

namespace interlock::coupling
{
class Laboratory
{
public:
  // Writes nothing. Throws InputError, one sentence, when the product cannot be used.
  Laboratory(const LaboratoryParameters& parameters, const Monitor& monitor);

  // Runs the tests, writes history.csv (every path), TEST.xdmf with the deformed piece, and
  // table.csv (measured beside stated) into `output`, which must exist. Throws std::runtime_error
  // when a test finds no equilibrium.
  Summary run(const std::filesystem::path& output);

private:
  using Clock = std::chrono::steady_clock;
  // One line of the table.
  struct Row {
    std::string quantity, unit;
    double measured = 0, stated = 0; // stated 0: not stated
    bool is_input = false;           // the ribs were given so that the two are equal
  };

  void make_lattice();
  void check_conditions() const;
  // Of the lattice below, without supports.
  std::unique_ptr<fem::StaticSolver> new_solver(bool stable_branch = false) const;
  void warn_of_instability(const fem::StaticSolver& solver, double load_share);
  fem::LaboratoryProgress progress(const std::string& stage) const;
  void finish(const std::string& test, const std::vector<std::string>& columns,
              const fem::LaboratoryTest& result, const std::filesystem::path& output);
  void tension(const std::string& direction, bool single_rib, const std::filesystem::path& output);
  void stability(const std::filesystem::path& output);
  void overhang(const std::string& direction, const std::filesystem::path& output);
  void loaded(const std::filesystem::path& output);
  void modes(const std::filesystem::path& output);
  void add_row(const std::string& quantity, const std::string& key, const std::string& unit,
               double measured, double stated, bool is_input = false);
  void write_table(const std::filesystem::path& file) const;
  void print_table() const;

  LaboratoryParameters parameters_;
  Monitor monitor_;
  fem::GeogridProduct product_;
  std::unique_ptr<fem::Lattice> lattice_; // of supports and loads, and of modes
  NodeSets sets_;                         // of that lattice
  std::vector<SupportCondition> supports_;
  std::vector<LoadCondition> loads_;
  std::unique_ptr<History> history_;
  std::vector<Row> rows_;
  Summary summary_;
  Clock::time_point stage_start_;
};
} // namespace interlock::coupling
