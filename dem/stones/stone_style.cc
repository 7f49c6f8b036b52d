#include "dem/stones/stone_style.h"

#include "dem/input_error.h"

#include <sstream>

namespace interlock::dem
{
namespace
{
void require(const char* what, double value, double low, double high, const char* unit = "")
{
  if (value >= low && value <= high) return; // a NaN is refused
  std::ostringstream sentence;
  sentence << "The " << what << " of the stones is " << value << unit << ", but must be from "
           << low << " to " << high << unit << ".";
  throw InputError(sentence.str());
}
} // namespace

void check_style(const StoneStyle& style)
{
  require("mean flatness", style.flatness, 0.4, 0.95);
  require("spread of flatness", style.flatness_spread, 0, 0.2);
  require("mean elongation", style.elongation, 0.4, 0.95);
  require("spread of elongation", style.elongation_spread, 0, 0.2);
  require("number of fracture faces", style.faces, 5, 40);
  require("edge wear", style.edge_wear, 0.005, 0.5);
  require("number of scars", style.scars, 0, 20);
  require("scar depth", style.scar_depth, 0, 0.1);
  require("number of steps", style.steps, 0, 6);
  require("roughness", style.roughness, 0, 0.002, " m");
  require("roughness exponent", style.roughness_exponent, 0.3, 1.5);
  if (style.spacing != 0) require("node spacing", style.spacing, 0.00005, 0.005, " m");
}
} // namespace interlock::dem
