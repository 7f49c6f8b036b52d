#include "apps/clump_command.h"

#include "apps/clump_making.h"
#include "apps/clump_options.h"
#include "apps/clump_orders.h"
#include "apps/clump_warnings.h"
#include "apps/clump_writing.h"
#include "apps/interruption.h"
#include "apps/octahedron_command.h"
#include "dem/input_error.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

ClumpResult make_clump(const StoneFiles& files, const ClumpOptions& options,
                       const dem::ClumpParameters& parameters)
{
  return clump_of_file(files.stone, files.name, options, parameters);
}

// Of the stones from which a clump was made. Empty where no comparison was asked for.
std::vector<OrderRow> compare(const std::vector<const StoneFiles*>& stones,
                              const ClumpOptions& options, const dem::ClumpParameters& parameters)
{
  if (options.compared.empty()) return {};
  const auto rows = compare_orders(options.compared, parameters, static_cast<int>(stones.size()),
                                   [&](int stone, const dem::ClumpParameters& changed) {
                                     return make_clump(*stones[stone], options, changed);
                                   });
  print_orders(rows);
  return rows;
}

void make_one(const ClumpFiles& files, const ClumpOptions& options,
              const dem::ClumpParameters& parameters)
{
  const StoneFiles& stone = files.stones.front();
  const ClumpResult result = make_clump(stone, options, parameters);
  const std::vector<dem::FileText> texts = clump_texts(stone, result);
  throw_if_interrupted();
  print_clump(result);
  std::printf("%s%s", missed_targets(result).c_str(), clump_warnings(result).c_str());
  write_files(texts);
  std::printf("Clump: '%s'\n", stone.clump.c_str());
  std::printf("%s", export_lines(stone, result).c_str());
  write_report(files.report, {result}, {}, compare({&stone}, options, parameters));
  std::printf("Report: '%s'\n", files.report.c_str());
}

// Ends with one sentence a refused stone.
void throw_refusals(const std::vector<Refusal>& refusals, std::size_t stones)
{
  if (refusals.empty()) return;
  std::string text;
  for (const Refusal& refusal : refusals) text += refusal.sentence + "\n";
  throw InputError(text + std::to_string(refusals.size()) + " of " + std::to_string(stones) +
                   (refusals.size() == 1 ? " stones was refused." : " stones were refused."));
}

struct Clumps {
  std::vector<ClumpResult> results;
  std::vector<const StoneFiles*> files; // of the results
  std::vector<Refusal> refusals;
};

// Writes each clump as soon as it is there. A stone that is refused does not stop the others.
void make_clumps(const ClumpFiles& files, const ClumpOptions& options,
                 const dem::ClumpParameters& parameters, Clumps& clumps)
{
  for (const StoneFiles& stone : files.stones) {
    throw_if_interrupted();
    std::vector<dem::FileText> texts;
    try {
      ClumpResult result = make_clump(stone, options, parameters);
      texts = clump_texts(stone, result);
      clumps.results.push_back(std::move(result));
    } catch (const InputError& error) {
      clumps.refusals.push_back({stone.stone, error.what()});
      continue;
    }
    throw_if_interrupted();
    write_files(texts);
    clumps.files.push_back(&stone);
    print_clump_table_row(clumps.results.back());
    std::fflush(stdout);
  }
}

void make_many(const ClumpFiles& files, const ClumpOptions& options,
               const dem::ClumpParameters& parameters)
{
  print_clump_table_head();
  Clumps clumps;
  try {
    make_clumps(files, options, parameters, clumps);
  } catch (const Interrupted&) {
    std::printf("Interrupted: %zu of %zu clumps are in '%s'; there is no report.\n",
                clumps.files.size(), files.stones.size(), files.folder.c_str());
    throw;
  }
  if (clumps.results.empty()) throw_refusals(clumps.refusals, files.stones.size());
  print_clump_table_means(clumps.results);
  for (std::size_t i = 0; i < clumps.results.size(); ++i) {
    const ClumpResult& result = clumps.results[i];
    std::printf("%s%s%s%s", remarks(result).c_str(), missed_targets(result).c_str(),
                clump_warnings(result).c_str(), export_remarks(*clumps.files[i], result).c_str());
  }
  std::printf("%zu clumps in '%s'\n", clumps.results.size(), files.folder.c_str());
  write_report(files.report, clumps.results, clumps.refusals,
               compare(clumps.files, options, parameters));
  std::printf("Report: '%s'\n", files.report.c_str());
  throw_refusals(clumps.refusals, files.stones.size());
}

void make(ClumpOptions& options)
{
  take_stones_from_formats(options.files);
  if (!options.table.empty()) return print_published_table(options.table);
  if (options.files.stones.empty())
    throw InputError("No stone is given: interlock clump STONE... (--help).");
  const dem::ClumpParameters parameters = clump_parameters(options);
  const ClumpFiles files = plan_clump_files(options.files);
  catch_interruption();
  if (files.stones.size() == 1)
    make_one(files, options, parameters);
  else
    make_many(files, options, parameters);
}
} // namespace

void add_clump_command(CLI::App& app)
{
  const auto options = std::make_shared<ClumpOptions>();
  CLI::App* command = app.add_subcommand("clump", "Turn closed stones into clumps of spheres");
  add_clump_options(*command, *options);
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
