// The entries of a pull-out file. It takes a member that no entry fills, two entries that fill the
// same member, a range that lets an impossible value pass, a text without its unit, or a
// contradiction between entries that nobody notices, to fail.
#include "coupling/pull_out/pull_out_checks.h"
#include "coupling/pull_out/pull_out_declarations.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

using namespace interlock::coupling;

namespace
{
class Entries : public testing::Test
{
protected:
  Entries() { declare_pull_out(table, parameters); }

  const ParameterEntry& entry(const std::string& key) const
  {
    for (const ParameterEntry& entry : table.entries())
      if (entry.key() == key) return entry;
    throw std::out_of_range(key);
  }

  bool set(const std::string& key, const std::string& value)
  {
    return table.set(entry(key), value);
  }

  PullOutParameters parameters;
  ParameterTable table;
};

// Sizes of the paper's test, with a plain 3 x 6 lattice that just fits.
PullOutParameters fitting_parameters()
{
  PullOutParameters p;
  p.box = {0.4, 0.2, 0.3, 0.02};
  p.geogrid.apertures_along = 6;
  p.geogrid.apertures_across = 3;
  p.geogrid.pitch_along = p.geogrid.pitch_across = 0.065;
  p.geogrid.rib_width = 0.005;
  p.geogrid.rib_thickness = 0.0025;
  p.geogrid.edge_rounding = 0.00125;
  p.geogrid.youngs_modulus = 2.4e9;
  p.geogrid.density = 910;
  p.surcharge = {"spheres", 500, 0.045};
  p.pull = {0.01, 0.05, 0.05};
  return p;
}

std::vector<std::string> entries_with_problems(const PullOutParameters& parameters)
{
  std::vector<std::string> entries;
  for (const ParameterProblem& problem : check_pull_out(parameters))
    entries.push_back(problem.entry);
  return entries;
}
} // namespace

TEST_F(Entries, FillOneMemberEach)
{
  PullOutParameters& p = parameters;
  const std::map<std::string, double*> numbers = {
      {"Gravity", &p.gravity},
      {"Stones/Length unit", &p.stones.length_unit},
      {"Stones/Density", &p.stones.density},
      {"Stones/D min", &p.stones.d_min},
      {"Stones/R min", &p.stones.r_min},
      {"Stones/P max", &p.stones.p_max},
      {"Stones/Bulge", &p.stones.bulge},
      {"Box/Length", &p.box.length},
      {"Box/Width", &p.box.width},
      {"Box/Height", &p.box.height},
      {"Box/Slot height", &p.box.slot_height},
      {"Contact/Stone stiffness", &p.contact.stone_stiffness},
      {"Contact/Box stiffness", &p.contact.box_stiffness},
      {"Contact/Geogrid stiffness", &p.geogrid_contact.stiffness},
      {"Contact/Stone friction", &p.contact.stone_friction},
      {"Contact/Box friction", &p.contact.box_friction},
      {"Contact/Geogrid friction", &p.geogrid_contact.friction},
      {"Contact/Stone on box friction", &p.contact.stone_on_box_friction},
      {"Contact/Stone on geogrid friction", &p.geogrid_contact.stone_friction},
      {"Contact/Crushing pressure", &p.contact.crushing_pressure},
      {"Contact/Tangential ratio", &p.contact.tangential_ratio},
      {"Contact/Damping ratio", &p.contact.damping_ratio},
      {"Contact/Geogrid damping ratio", &p.geogrid_contact.damping_ratio},
      {"Geogrid/Lattice length unit", &p.geogrid.lattice_length_unit},
      {"Geogrid/Cut width", &p.geogrid.cut_width},
      {"Geogrid/Overhang", &p.geogrid.overhang},
      {"Geogrid/Pitch along", &p.geogrid.pitch_along},
      {"Geogrid/Pitch across", &p.geogrid.pitch_across},
      {"Geogrid/Rib width", &p.geogrid.rib_width},
      {"Geogrid/Rib thickness", &p.geogrid.rib_thickness},
      {"Geogrid/Edge rounding", &p.geogrid.edge_rounding},
      {"Geogrid/Youngs modulus", &p.geogrid.youngs_modulus},
      {"Geogrid/Poisson ratio", &p.geogrid.poisson_ratio},
      {"Geogrid/Density", &p.geogrid.density},
      {"Geogrid/Mass damping", &p.geogrid.mass_damping},
      {"Geogrid/Break strain", &p.geogrid.break_strain},
      {"Filling/Stone friction", &p.filling.stone_friction},
      {"Filling/Lower bulk density", &p.filling.lower_bulk_density},
      {"Filling/Upper bulk density", &p.filling.upper_bulk_density},
      {"Filling/Drop height", &p.filling.drop_height},
      {"Filling/Plate speed", &p.filling.plate_speed},
      {"Filling/Plate force limit", &p.filling.plate_force_limit},
      {"Filling/Local damping", &p.filling.local_damping},
      {"Filling/Kinetic energy ratio", &p.filling.kinetic_energy_ratio},
      {"Filling/Settling time limit", &p.filling.settling_time_limit},
      {"Surcharge/Force", &p.surcharge.force},
      {"Surcharge/Sphere radius", &p.surcharge.sphere_radius},
      {"Pull/Speed", &p.pull.speed},
      {"Pull/Distance", &p.pull.distance},
      {"Pull/Ramp time", &p.pull.ramp_time},
      {"Time/Step", &p.time.step},
      {"Time/Safety factor", &p.time.safety_factor},
      {"Limits/Overlap", &p.limits.overlap},
      {"Output/Checkpoint interval", &p.output.checkpoint_interval}};
  const std::map<std::string, int*> counts = {
      {"Stones/Count", &p.stones.count},
      {"Stones/Max spheres", &p.stones.max_spheres},
      {"Geogrid/Apertures along", &p.geogrid.apertures_along},
      {"Geogrid/Apertures across", &p.geogrid.apertures_across},
      {"Geogrid/Elements per rib", &p.geogrid.elements_per_rib},
      {"Output/Records", &p.output.records},
      {"Output/Field frames", &p.output.field_frames}};
  // Kind, 2 seeds, 4 truth values, folder, placement, mass properties, order, state to start from,
  // product, lattice file, displacements of frames.
  const std::size_t others = 15;
  EXPECT_EQ(table.entries().size(), numbers.size() + counts.size() + others);

  // A different value for each, inside every range; only then are they compared.
  int i = 0;
  for (const auto& number : numbers)
    EXPECT_TRUE(set(number.first, "0." + std::to_string(100 + i++))) << number.first;
  for (const auto& count : counts)
    EXPECT_TRUE(set(count.first, std::to_string(100 + i++))) << count.first;
  i = 0;
  for (const auto& number : numbers)
    EXPECT_DOUBLE_EQ(*number.second, 0.1 + 0.001 * i++) << number.first;
  for (const auto& count : counts) EXPECT_EQ(*count.second, 100 + i++) << count.first;
}

TEST_F(Entries, FillWordsSeedsAndTruthValues)
{
  EXPECT_TRUE(set("Stones/Seed", "7") && set("Filling/Seed", "8"));
  EXPECT_TRUE(set("Stones/Folder", "some/scans") && set("Stones/Mass properties", "equal-mass"));
  EXPECT_TRUE(set("Stones/Sphere order", "gain"));
  EXPECT_TRUE(set("Geogrid/Rigid", "true") && set("Geogrid/Placement", "not flattened"));
  EXPECT_TRUE(set("Output/Report", "false"));
  EXPECT_TRUE(parameters.geogrid_contact.ribs_touch_walls);
  EXPECT_TRUE(set("Contact/Ribs touch walls", "false"));
  EXPECT_EQ(parameters.stones.seed, 7u);
  EXPECT_EQ(parameters.filling.seed, 8u);
  EXPECT_EQ(parameters.stones.folder, "some/scans");
  EXPECT_EQ(parameters.stones.mass_properties, "equal-mass");
  EXPECT_EQ(parameters.stones.sphere_order, "gain");
  EXPECT_FALSE(set("Stones/Sphere order", "volume"));
  EXPECT_TRUE(parameters.geogrid.rigid);
  EXPECT_EQ(parameters.geogrid.placement, "not flattened");
  EXPECT_FALSE(parameters.output.report);
  EXPECT_FALSE(parameters.geogrid_contact.ribs_touch_walls);
}

TEST_F(Entries, FillDisplacementsOfFrames)
{
  EXPECT_TRUE(parameters.frames_at.empty());
  // 17 digits, as a row of history.csv has them.
  EXPECT_TRUE(set("Output/Frames at", "0.012345678901234567, 0.0125,0"));
  EXPECT_EQ(parameters.frames_at, (std::vector<double>{0.012345678901234567, 0.0125, 0}));
  for (const char* value : {"-0.001", "0.001 0.002", "0.001, two", "1 mm", "nan"})
    EXPECT_FALSE(set("Output/Frames at", value)) << value;
  EXPECT_EQ(parameters.frames_at.size(), 3u);
  EXPECT_TRUE(set("Output/Frames at", ""));
  EXPECT_TRUE(parameters.frames_at.empty());
}

TEST_F(Entries, RefuseImpossibleValuesAndChangeNothing)
{
  ASSERT_TRUE(set("Geogrid/Poisson ratio", "0.25"));
  for (const char* value : {"-1", "0.5000001", "0.3 -", "a third", "", "nan", "inf"})
    EXPECT_FALSE(set("Geogrid/Poisson ratio", value)) << value;
  EXPECT_EQ(parameters.geogrid.poisson_ratio, 0.25);

  for (const char* value : {"0", "-6e7", "6e7 N/m", "1e400"})
    EXPECT_FALSE(set("Contact/Stone stiffness", value)) << value;
  for (const char* value : {"-0.1", "5.1"}) EXPECT_FALSE(set("Contact/Box friction", value));
  for (const char* value : {"-0.1", "1.1"}) EXPECT_FALSE(set("Contact/Damping ratio", value));
  for (const char* value : {"0", "1.5", "2 3", "-4"})
    EXPECT_FALSE(set("Geogrid/Apertures along", value)) << value;
  EXPECT_FALSE(set("Stones/P max", "100.5"));
  EXPECT_FALSE(set("Geogrid/Placement", "flat"));
  EXPECT_FALSE(set("Geogrid/Rigid", "maybe"));
  EXPECT_FALSE(set("Stones/Seed", "-1"));
}

TEST_F(Entries, TakeTheEndsOfTheirRanges)
{
  EXPECT_TRUE(set("Geogrid/Poisson ratio", "0.5"));
  EXPECT_TRUE(set("Contact/Box friction", "0") && set("Contact/Box friction", "5"));
  EXPECT_TRUE(set("Contact/Damping ratio", "0") && set("Contact/Damping ratio", "1"));
  EXPECT_TRUE(set("Stones/P max", "100"));
}

TEST_F(Entries, AreDocumentedSentencesWithUnits)
{
  std::set<std::string> keys;
  for (const ParameterEntry& entry : table.entries()) {
    EXPECT_TRUE(keys.insert(entry.key()).second) << entry.key() << " appears twice";
    EXPECT_EQ(entry.sentence.back(), '.') << entry.key();
    const bool is_number = entry.allowed.find("number") != std::string::npos;
    EXPECT_EQ(is_number, !entry.unit.empty()) << entry.key() << " [" << entry.unit << "]";
  }
}

// Only what chooses a seed, a numerical setting or an output may be left out, and what replaces a
// value that follows from others.
TEST_F(Entries, HaveDefaultsOnlyWherePhysicsDoesNotDependOnThem)
{
  const std::set<std::string> may_be_left_out = {"Stones/Folder",
                                                 "Stones/Length unit",
                                                 "Stones/Count",
                                                 "Stones/Seed",
                                                 "Stones/Max spheres",
                                                 "Stones/Sphere order",
                                                 "Stones/Bulge",
                                                 "Filling/Seed",
                                                 "Filling/Stone friction",
                                                 "Filling/Lower bulk density",
                                                 "Filling/Upper bulk density",
                                                 "Stones/Mass properties",
                                                 "Contact/Stone on box friction",
                                                 "Contact/Stone on geogrid friction",
                                                 "Contact/Crushing pressure",
                                                 "Time/Step",
                                                 "Time/Safety factor",
                                                 "Output/Report",
                                                 "Output/Checkpoint interval",
                                                 "Limits/Overlap",
                                                 "Geogrid/Break strain",
                                                 "Geogrid/Product",
                                                 "Geogrid/Lattice file",
                                                 "Geogrid/Lattice length unit",
                                                 "Geogrid/Cut width",
                                                 "Start from",
                                                 "Geogrid/Elements per rib",
                                                 "Output/Field frames",
                                                 "Output/Frames at",
                                                 "Output/Records"};
  for (const ParameterEntry& entry : table.entries())
    EXPECT_EQ(entry.required, may_be_left_out.count(entry.key()) == 0) << entry.key();
}

TEST(CheckParameters, AcceptsWhatJustFits)
{
  EXPECT_EQ(entries_with_problems(fitting_parameters()), std::vector<std::string>());
}

TEST(CheckParameters, NamesTheEntryOfEachContradiction)
{
  using Change = std::function<void(PullOutParameters&)>;
  const std::vector<std::pair<std::string, Change>> changes = {
      {"Geogrid/Apertures across", [](auto& p) { p.geogrid.apertures_across = 4; }},
      {"Contact/Stone on box friction", [](auto& p) { p.contact.stone_on_box_friction = -0.5; }},
      {"Contact/Stone on geogrid friction",
       [](auto& p) { p.geogrid_contact.stone_friction = -0.5; }},
      {"Filling/Stone friction", [](auto& p) { p.filling.stone_friction = -0.5; }},
      {"Geogrid/Apertures across", [](auto& p) { p.geogrid.pitch_across = 0.06501; }},
      {"Geogrid/Apertures along", [](auto& p) { p.box.length = 0.39; }},
      {"Box/Slot height", [](auto& p) { p.box.slot_height = 0.15; }},
      {"Box/Slot height", [](auto& p) { p.box.slot_height = 0.0025; }},
      {"Geogrid/Edge rounding", [](auto& p) { p.geogrid.edge_rounding = 0.0013; }},
      {"Geogrid/Rib width",
       [](auto& p) {
         p.geogrid.rib_width = 0.065;
         p.box.width = 0.3;
         p.box.length = 0.5;
       }},
      {"Geogrid/Youngs modulus", [](auto& p) { p.geogrid.youngs_modulus = 0; }},
      {"Geogrid/Cut width", [](auto& p) { p.geogrid.cut_width = 0.19; }},
      {"Geogrid/Cut width", [](auto& p) { p.geogrid.cut_width = 0.201; }},
      {"Surcharge/Sphere radius", [](auto& p) { p.surcharge.sphere_radius = 0; }},
      {"Surcharge/Sphere radius", [](auto& p) { p.surcharge.sphere_radius = 0.11; }},
      {"Pull/Distance", [](auto& p) { p.pull.distance = 0.4; }},
      {"Pull/Ramp time", [](auto& p) { p.pull.ramp_time = 11; }},
      {"Output/Frames at",
       [](auto& p) {
         p.frames_at = {0, 0.05, 0.0501};
       }},
      {"Stones/Folder", [](auto& p) {
         p.stones.folder = "/no/such/folder";
         p.stones.length_unit = 0.001;
       }}};
  for (const auto& [entry, change] : changes) {
    PullOutParameters parameters = fitting_parameters();
    change(parameters);
    EXPECT_EQ(entries_with_problems(parameters), std::vector<std::string>{entry});
  }
}

TEST(CheckParameters, WantsScansAndTheirUnitInTheStonesFolder)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "interlock_check_stones";
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ofstream(folder / "notes.txt") << "no stone";
  std::ofstream(folder / "._stone.stl") << "no stone either";
  PullOutParameters parameters = fitting_parameters();
  parameters.stones.folder = folder.string();
  parameters.stones.length_unit = 0.001;
  EXPECT_EQ(entries_with_problems(parameters), std::vector<std::string>{"Stones/Folder"});

  std::ofstream(folder / "stone.STL") << "solid";
  EXPECT_EQ(entries_with_problems(parameters), std::vector<std::string>());
  parameters.stones.length_unit = 0;
  EXPECT_EQ(entries_with_problems(parameters), std::vector<std::string>{"Stones/Length unit"});
  fs::remove_all(folder);
}
