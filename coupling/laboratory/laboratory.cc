#include "coupling/laboratory/laboratory.h"

#include "coupling/files/atomic_file.h"
#include "coupling/output/lattice_output.h"
#include "coupling/parameters/geogrid_product.h"
#include "dem/input_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
constexpr double degree = M_PI / 180, standard_gravity = 9.80665;

std::string number(double value, int digits = 4)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string padded(std::string text, std::size_t width, bool right = true)
{
  text.insert(right ? 0 : text.size(), width > text.size() ? width - text.size() : 0, ' ');
  return text;
}
} // namespace

Laboratory::Laboratory(const LaboratoryParameters& parameters, const Monitor& monitor)
    : parameters_(parameters), monitor_(monitor)
{
  try {
    product_ = geogrid_product(parameters.product);
    fem::piece(product_, 1, 1);
    supports_ = parse_supports(parameters.test.supports);
    loads_ = parse_loads(parameters.test.loads);
    const std::string& test = parameters.test.test;
    if (test == "supports and loads" || test == "modes") {
      make_lattice();
      check_conditions();
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(error.what());
  }
}

// The lattice of supports and loads, and of modes: a piece of the product, or that of a file.
void Laboratory::make_lattice()
{
  const LaboratoryTestParameters& p = parameters_.test;
  if (p.lattice_file.empty()) {
    lattice_ =
        std::make_unique<fem::Lattice>(fem::piece(product_, p.apertures_along, p.apertures_across));
    sets_ = node_sets_of_piece(*lattice_);
    return;
  }
  const fem::GmshLattice file = drawn_lattice(p.lattice_file, p.lattice_length_unit, product_);
  lattice_ = std::make_unique<fem::Lattice>(file.lines);
  sets_ = fem::node_sets(file, *lattice_);
  for (int i = 0; i < lattice_->n_nodes(); ++i) sets_["everywhere"].push_back(i);
}

// Unknown sets, or a lattice that can move as a whole: before anything is written.
void Laboratory::check_conditions() const
{
  for (const SupportCondition& support : supports_) nodes_of(support.set, sets_);
  for (const LoadCondition& load : loads_) nodes_of(load.set, sets_);
  const std::unique_ptr<fem::StaticSolver> solver = new_solver();
  apply(supports_, 1, sets_, *solver);
  if (parameters_.test.test != "modes") {
    fem::require_held(solver->state());
    return;
  }
  const int free = fem::n_free_freedoms(solver->state()), modes = parameters_.test.modes;
  if (modes > free)
    throw InputError("Laboratory/Modes is " + std::to_string(modes) + ", but must be at most " +
                     std::to_string(free) + ", the number of free freedoms of the lattice.");
}

std::unique_ptr<fem::StaticSolver> Laboratory::new_solver(bool stable_branch) const
{
  fem::StaticOptions options;
  options.stable_branch = stable_branch;
  if (stable_branch) options.longest_turn = 0.5;
  options.load_steps = 1;
  return std::make_unique<fem::StaticSolver>(*lattice_, options);
}

fem::LaboratoryProgress Laboratory::progress(const std::string& stage) const
{
  return [this, stage](double share) {
    if (monitor_.progress) monitor_.progress({stage, share, 0, 0});
  };
}

// Files and log of a finished test. `columns`: of deformation and load in history.csv.
void Laboratory::finish(const std::string& test, const std::vector<std::string>& columns,
                        const fem::LaboratoryTest& result, const std::filesystem::path& output)
{
  for (const fem::LaboratoryPoint& point : result.path)
    history_->add({test, columns[0], point.deformation, columns[1], point.load});
  std::string stem = test;
  std::replace(stem.begin(), stem.end(), ' ', '_');
  const std::map<fem::Stability, std::string> words = {{fem::Stability::stable, "stable"},
                                                       {fem::Stability::unstable, "unstable"},
                                                       {fem::Stability::not_known, "not known"}};
  summary_.results[stem + "_equilibrium"] = words.at(result.solver->stability());
  summary_.results[stem + "_imbalance"] = result.solver->imbalance();
  summary_.results[stem + "_uncertainty"] = result.solver->uncertainty();
  write_lattice(output / stem, *result.solver);
  const Clock::time_point now = Clock::now();
  StageSummary stage;
  stage.name = test;
  stage.steps = static_cast<std::int64_t>(result.path.size()) - 1;
  stage.wall_time = std::chrono::duration<double>(now - stage_start_).count();
  stage_start_ = now;
  summary_.steps += stage.steps;
  summary_.wall_time += stage.wall_time;
  if (monitor_.message)
    monitor_.message(test + ": " + std::to_string(result.solver->lattice().n_elements()) +
                     " beam elements, " + std::to_string(stage.steps) + " steps (" +
                     number(stage.wall_time, 2) + " s)");
  summary_.stages.push_back(stage);
}

void Laboratory::add_row(const std::string& quantity, const std::string& key,
                         const std::string& unit, double measured, double stated, bool is_input)
{
  rows_.push_back({quantity, unit, measured, stated, is_input});
  summary_.results[key] = measured;
  if (stated > 0) summary_.results[key + "_stated"] = stated;
}

void Laboratory::tension(const std::string& direction, bool single_rib,
                         const std::filesystem::path& output)
{
  const bool along = direction == "along";
  const DataSheetParameters& sheet = parameters_.data_sheet;
  const fem::GeogridProduct product = along ? product_ : fem::turned(product_);
  const std::string kind = single_rib ? "single-rib tension" : "wide-width tension";
  const std::string name = kind + " " + direction;
  const LaboratoryTestParameters& p = parameters_.test;
  const auto test = single_rib ? fem::single_rib_tension : fem::wide_width_tension;
  const fem::LaboratoryTest result = test(product, p.largest_strain, p.steps, progress(name));
  finish(name, {"strain [-]", "force_per_width [N/m]"}, result, output);
  const std::string stem = std::string(single_rib ? "single_rib" : "wide_width") + "_force_at_";
  const ProductRibsParameters& ribs =
      along ? parameters_.product.along : parameters_.product.across;
  const auto row = [&](double strain, const std::string& percent, double stated, double given) {
    if (p.largest_strain < strain * (1 - 1e-9)) return;
    add_row(kind + ", " + direction + ", force at " + percent + " %",
            stem + percent + "_percent_" + direction + "_kN_per_m", "kN/m",
            1e-3 * fem::load_at(result.path, strain), stated, !single_rib && given > 0);
  };
  row(0.02, "2", along ? sheet.force_2_along : sheet.force_2_across, ribs.stiffness_2);
  row(0.05, "5", along ? sheet.force_5_along : sheet.force_5_across, ribs.stiffness_5);
}

void Laboratory::stability(const std::filesystem::path& output)
{
  const LaboratoryTestParameters& p = parameters_.test;
  const fem::LaboratoryTest result =
      fem::aperture_stability(product_, p.largest_torque, p.steps, progress("aperture stability"));
  finish("aperture stability", {"rotation [rad]", "torque [N m]"}, result, output);
  add_row("aperture stability at " + number(p.largest_torque) + " N m",
          "aperture_stability_N_m_per_deg", "N m/deg",
          result.path.back().load / (result.path.back().deformation / degree),
          parameters_.data_sheet.aperture_stability);
}

void Laboratory::overhang(const std::string& direction, const std::filesystem::path& output)
{
  const bool along = direction == "along";
  const std::string name = "flexural overhang " + direction;
  const fem::OverhangResult result =
      fem::flexural_overhang(along ? product_ : fem::turned(product_), parameters_.test.strip_ribs,
                             parameters_.test.gravity, progress(name));
  finish(name, {"tip_fall [m]", "weight_share [-]"}, result.test, output);
  add_row("overhang length, " + direction, "overhang_length_" + direction + "_m", "m",
          result.length, 0);
  // One mg cm is a force of 1e-6 kg g over a length of 1e-2 m.
  add_row("flexural rigidity, " + direction, "flexural_rigidity_" + direction + "_mg_cm", "mg cm",
          result.flexural_rigidity / (1e-8 * standard_gravity),
          along ? parameters_.data_sheet.flexural_rigidity : 0);
}

// `load_share`: where the path met an unstable equilibrium for the first time; 0: nowhere.
void Laboratory::warn_of_instability(const fem::StaticSolver& solver, double load_share)
{
  if (load_share == 0) return;
  const int directions = solver.unstable_directions();
  const std::string sentence =
      (directions > 0 ? "The equilibrium found is unstable, with " + std::to_string(directions) +
                            " negative pivots of the tangent: the ribs buckle away from it; it "
                            "became so"
                      : std::string("The path to this equilibrium met an unstable one, so slow "
                                    "loading may reach another branch; this happened")) +
      " at " + number(load_share, 3) +
      " of the loads. More steps (Laboratory/Steps) find the stable branch where a small side load "
      "leads to it.";
  summary_.warnings.push_back(sentence);
  if (monitor_.message) monitor_.message("warning: " + sentence);
}

void Laboratory::loaded(const std::filesystem::path& output)
{
  const LaboratoryTestParameters& p = parameters_.test;
  fem::LaboratoryTest test;
  test.solver = new_solver(true);
  const fem::Lattice& lattice = *lattice_;
  test.path.push_back({});
  double largest = 0, unstable_from = 0;
  for (int k = 1; k <= p.steps; ++k) {
    apply(supports_, static_cast<double>(k) / p.steps, sets_, *test.solver);
    apply(loads_, 1. / p.steps, sets_, *test.solver);
    test.solver->solve();
    if (test.solver->unstable_on_the_way() > 0 && unstable_from == 0)
      unstable_from = static_cast<double>(k) / p.steps;
    for (int i = 0; i < lattice.n_nodes(); ++i)
      largest = std::max(largest, test.solver->displacement(i).norm());
    test.path.push_back({largest, static_cast<double>(k) / p.steps});
    progress("supports and loads")(static_cast<double>(k) / p.steps);
  }
  warn_of_instability(*test.solver, unstable_from);
  finish("supports and loads", {"largest_displacement [m]", "load_share [-]"}, test, output);
  add_row("largest displacement", "largest_displacement_m", "m", largest, 0);
  double axial = 0, stretch = 0;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double force = test.solver->section_forces(e).axial;
    axial = std::max(axial, std::abs(force));
    stretch = std::max(stretch, force / lattice.section(e).axial);
  }
  add_row("largest axial force of a rib", "largest_axial_force_N", "N", axial, 0);
  for (const SupportCondition& support : supports_) {
    const fem::NodeLoad sum = fem::total_reaction(*test.solver, sets_.at(support.set));
    const char* names[] = {"x", "y", "z"};
    for (int c = 0; c < 3; ++c)
      add_row("reaction of " + support.set + ", " + names[c],
              "reaction_" + support.set + "_" + names[c] + "_N", "N", sum[c], 0);
  }
}

void Laboratory::modes(const std::filesystem::path& output)
{
  const std::unique_ptr<fem::StaticSolver> solver = new_solver();
  const fem::Lattice& lattice = *lattice_;
  apply(supports_, 1, sets_, *solver);
  progress("modes")(-1);
  const std::vector<fem::NaturalMode> modes =
      fem::natural_modes(solver->state(), parameters_.test.modes);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    history_->add(
        {"modes", "mode [-]", static_cast<double>(m + 1), "frequency [Hz]", modes[m].frequency});
    add_row("natural frequency " + std::to_string(m + 1),
            "natural_frequency_" + std::to_string(m + 1) + "_Hz", "Hz", modes[m].frequency, 0);
  }
  write_modes(output / "modes", lattice, modes);
  if (monitor_.message)
    monitor_.message("modes: " + std::to_string(lattice.n_elements()) + " beam elements");
}

Summary Laboratory::run(const std::filesystem::path& output)
{
  stage_start_ = Clock::now();
  summary_.experiment = "laboratory";
  summary_.results["product"] = parameters_.product.name;
  history_ = std::make_unique<History>(
      output / "history.csv",
      std::vector<std::string>{"test", "deformation_name", "deformation", "load_name", "load"});
  const LaboratoryTestParameters& p = parameters_.test;
  const bool all = p.test == "data sheet";
  if (all || p.test == "wide-width tension") tension(all ? "along" : p.direction, false, output);
  if (all && product_.pattern == fem::Pattern::biaxial) tension("across", false, output);
  if (p.test == "single-rib tension") tension(p.direction, true, output);
  if ((all && product_.pattern != fem::Pattern::uniaxial) || p.test == "aperture stability")
    stability(output);
  if ((all && product_.pattern != fem::Pattern::triaxial) || p.test == "flexural overhang")
    overhang(all ? "along" : p.direction, output);
  if (p.test == "supports and loads") loaded(output);
  if (p.test == "modes") modes(output);
  if (all)
    add_row("mass per area", "mass_per_area_kg_per_m2", "kg/m2", product_.mass_per_area(),
            parameters_.data_sheet.mass_per_area);
  write_table(output / "table.csv");
  print_table();
  return summary_;
}

void Laboratory::write_table(const std::filesystem::path& file) const
{
  std::ostringstream out;
  out << "quantity,unit,measured,stated,stated_is_input\n";
  for (const Row& row : rows_)
    out << '"' << row.quantity << "\"," << row.unit << ',' << number(row.measured, 6) << ','
        << (row.stated > 0 ? number(row.stated, 6) : "") << ','
        << (row.is_input && row.stated > 0 ? "yes" : "") << '\n';
  write_atomically(file, out.str());
}

void Laboratory::print_table() const
{
  if (!monitor_.message) return;
  std::string text = padded(parameters_.product.name, 46, false) + padded("measured", 12) +
                     padded("data sheet", 12) + padded("ratio", 8);
  for (const Row& row : rows_) {
    text += "\n  " + padded(row.quantity + " [" + row.unit + "]", 44, false) +
            padded(number(row.measured), 12);
    if (row.stated > 0)
      text += padded(number(row.stated), 12) +
              padded(row.is_input ? "input" : number(row.measured / row.stated, 3), 8);
  }
  if (!parameters_.data_sheet.source.empty())
    text += "\n  data sheet: " + parameters_.data_sheet.source;
  monitor_.message(text);
}
} // namespace interlock::coupling
