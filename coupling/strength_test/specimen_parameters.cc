#include "coupling/strength_test/specimen_parameters.h"

#include "coupling/parameters/stone_declarations.h"

namespace interlock::coupling
{
void declare_stones_and_box(ParameterTable& table, SpecimenParameters& specimen,
                            const std::string& gravity, const std::string& length,
                            const std::string& height)
{
  table.open_section("");
  table.require("Gravity", specimen.gravity, positive, gravity);
  declare_stones(table, specimen.stones);
  table.open_section("Box");
  table.require("Length", specimen.box.length, positive, length);
  table.require("Width", specimen.box.width, positive, "Inner width along y. [m]");
  table.require("Height", specimen.box.height, positive, height);
}

void declare_load(ParameterTable& table, SpecimenParameters& specimen, const std::string& name,
                  double& stress, const std::string& text, const std::string& compaction)
{
  table.open_section("Load");
  table.require(name, stress, positive, text);
  table.offer("Compaction stress", specimen.compaction_stress, 0, not_negative, compaction);
}

void check_compaction(const SpecimenParameters& specimen, double stress, const std::string& name,
                      ParameterProblems& problems)
{
  const double compaction = specimen.compaction_stress;
  if (compaction > 0 && compaction < stress)
    problems.add("Load/Compaction stress", "The compaction stress is ", compaction,
                 " Pa, but must be at least the ", name, ", ", stress,
                 " Pa, or 0 for no compaction.");
}
} // namespace interlock::coupling
