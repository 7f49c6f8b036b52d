#include "apps/study/study_file.h"

#include "apps/unknown_entry.h"
#include "apps/value_error.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using coupling::ParameterTable;
using coupling::Range;

// Lists, as text.
struct Texts {
  std::string base_case, fillings, filling_entry, refilled, forces_at;
};

void declare(ParameterTable& table, StudyFile& study, Texts& texts)
{
  table.require_file("Base case", texts.base_case,
                     "Parameter file of every run, but for what is varied.");
  table.offer_choice("Design", study.design, "grid",
                     {"grid", "one at a time", "latin hypercube", "sobol"},
                     "How values are put together.");
  table.offer("Samples", study.samples, 0, {0, 100000},
              "Of a latin hypercube or of Sobol's matrices. [-]");
  table.offer_seed("Seed", study.seed, "Of the samples. [-]");
  table.offer_text("Fillings", texts.fillings, "Seeds of the fillings, separated by commas.");
  table.offer_text("Filling entry", texts.filling_entry, "Entry that takes them.");
  table.offer_choice("Start from", study.start_from, "nothing", {"nothing", "placed", "packed"},
                     "State that runs of one filling share.");
  table.offer_text("Refilled", texts.refilled,
                   "Entries for whose values the box is filled anew, separated by commas.");
  table.offer("Ranks per run", study.ranks_per_run, 1, {1, 10000}, "Processes of each run. [-]");
  table.open_section("Measures");
  table.offer_text("Forces at", texts.forces_at, "Displacements, separated by commas. [m]");
  table.offer("Mean over", study.measures.mean_over, 1e-3, coupling::positive,
              "Length of the centred mean of a force. [m]");
  table.offer("Stiffness over", study.measures.stiffness_over, 2e-3, coupling::positive,
              "Way within which the initial stiffness is looked for. [m]");
  table.offer("Fluctuation from", study.measures.fluctuation_from, 0.5, {0, 0.9},
              "Share of the way from which on the fluctuation is taken. [-]");
  table.offer("Confidence", study.confidence, 0.95, {0.5, 0.9999}, "Of the intervals. [-]");
}

// Fills the table, sorts the rest, and gathers what is wrong.
class Reader
{
public:
  explicit Reader(const fs::path& file)
  {
    study_.file = file;
    ScannedFile scanned = scan_parameter_file(file);
    errors_ = std::move(scanned.errors);
    declare(table_, study_, texts_);
    for (const Assignment& line : scanned.assignments) read_line(line);
    if (places_.count("Base case") == 0 && errors_.empty())
      errors_.push_back(file.string() +
                        ": the entry \"Base case\" is missing; it must be the name of a file.");
    throw_errors();
    finish();
    throw_errors();
  }

  StudyFile take() { return std::move(study_); }

private:
  void read_line(const Assignment& line)
  {
    if (line.section == "Fixed") {
      Assignment entry = parse_override(line.name + "=" + line.value);
      entry.place = line.place, entry.base = line.base, entry.file = line.file;
      study_.fixed.push_back(entry);
      return;
    }
    if (line.section == "Parameters") {
      attempt([&] { study_.factors.push_back(read_factor(line)); });
      return;
    }
    places_[line.key()] = line;
    const coupling::ParameterEntry* entry = find_entry(table_, line.key());
    if (!entry) {
      errors_.push_back(line.place + ": " + explain_unknown(table_, line));
      return;
    }
    const std::string value = entry->is_path && !line.value.empty()
                                  ? fs::absolute(line.base / line.value).lexically_normal().string()
                                  : line.value;
    if (!table_.set(*entry, value))
      errors_.push_back(line.place + ": " + explain_bad_value(*entry, line.value));
  }

  void finish()
  {
    study_.base_case = texts_.base_case;
    std::error_code error;
    if (!fs::is_regular_file(study_.base_case, error))
      add("Base case", "is \"" + texts_.base_case + "\", but there is no such file.");
    read_fillings();
    study_.refilled = split_list(texts_.refilled);
    read_forces();
    check_design();
    check_names();
  }

  void read_fillings()
  {
    Assignment line = places_.count("Fillings") ? places_["Fillings"] : Assignment();
    line.section.clear();
    line.name = texts_.filling_entry.empty() ? "Filling/Seed" : texts_.filling_entry;
    line.value = texts_.fillings;
    if (split_list(texts_.fillings).empty())
      study_.fillings.levels = {{"base", {}}};
    else
      attempt([&] { study_.fillings = read_factor(line); });
    study_.fillings.name = "filling";
  }

  void read_forces()
  {
    const bool given = places_.count("Measures/Forces at") > 0;
    for (const std::string& text :
         split_list(given ? texts_.forces_at : "0.002, 0.005, 0.01, 0.02")) {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (text.empty() || *end != '\0' || !(value > 0) || !(value < 10))
        add("Measures/Forces at",
            "has \"" + text + "\", which is no displacement in m, greater than 0.");
      study_.measures.forces_at.push_back(value);
    }
  }

  void check_design()
  {
    const bool drawn = study_.design == "latin hypercube" || study_.design == "sobol";
    if (drawn && study_.samples < 2)
      add("Samples", "must be 2 or more for the design \"" + study_.design + "\".");
    if (!drawn && study_.samples > 0)
      add("Samples", "is given, but the design \"" + study_.design + "\" draws none.");
    if (drawn && study_.factors.empty())
      add("Design", "is \"" + study_.design + "\", but the subsection \"Parameters\" is empty.");
  }

  // One name, one column; an entry that stands in two places would be overwritten unasked.
  void check_names()
  {
    std::map<std::string, std::string> owners; // of entries
    for (const Assignment& entry : study_.fixed) owners[entry.key()] = "the subsection \"Fixed\"";
    std::vector<const Factor*> all = {&study_.fillings};
    for (const Factor& factor : study_.factors) all.push_back(&factor);
    for (const Factor* factor : all) {
      std::set<std::string> mine;
      for (const Level& level : factor->levels)
        for (const Assignment& entry : level.entries) mine.insert(entry.key());
      for (const std::string& key : mine) {
        if (key == "Start from" || key == "Experiment")
          errors_.push_back(factor->source.place + ": \"" + key +
                            "\" cannot be varied in a study.");
        const auto [owner, first] = owners.emplace(key, "\"" + factor->name + "\"");
        if (!first)
          errors_.push_back(factor->source.place + ": \"" + factor->name + "\" sets \"" + key +
                            "\", which " + owner->second + " sets too.");
      }
    }
    for (const Assignment& entry : study_.fixed)
      if (entry.key() == "Start from" && study_.start_from != "nothing")
        errors_.push_back(entry.place +
                          ": \"Start from\" of a run is what the study itself makes with its "
                          "entry \"Start from = " +
                          study_.start_from + "\".");
  }

  template <class F> void attempt(const F& f)
  {
    try {
      f();
    } catch (const InputError& error) {
      errors_.push_back(error.what());
    }
  }

  void add(const std::string& key, const std::string& sentence)
  {
    const auto place = places_.find(key);
    errors_.push_back((place == places_.end() ? study_.file.string() : place->second.place) +
                      ": \"" + key + "\" " + sentence);
  }

  void throw_errors() const
  {
    if (!errors_.empty()) throw InputError(boost::algorithm::join(errors_, "\n"));
  }

  StudyFile study_;
  Texts texts_;
  ParameterTable table_;
  std::map<std::string, Assignment> places_; // by key
  std::vector<std::string> errors_;
};
} // namespace

StudyFile read_study_file(const fs::path& file)
{
  return Reader(file).take();
}
} // namespace interlock::apps
