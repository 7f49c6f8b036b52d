#include "coupling/heap/heap_declarations.h"

#include "coupling/parameters/stone_declarations.h"

#include <filesystem>

namespace interlock::coupling
{
namespace
{
const Range friction{0, 5, true};

void declare_contact(ParameterTable& table, HeapContactParameters& contact)
{
  table.open_section("Contact");
  declare_contact_model(table, contact.model);
  table.require(
      "Normal stiffness", contact.normal_stiffness, positive,
      "Normal stiffness of a contact, of two stones or of a stone and the floor; of the linear "
      "model. [N/m]");
  table.require("Tangential ratio", contact.tangential_ratio, {0, 2, false},
                "Tangential over normal contact stiffness, of the linear model. [-]");
  table.require("Stone friction", contact.stone_friction, friction,
                "Friction coefficient between two stones. [-]");
  table.require("Floor friction", contact.floor_friction, friction,
                "Friction coefficient between a stone and the floor. [-]");
  table.require("Local damping", contact.local_damping, {0, 1},
                "Share of the unbalanced force taken from stones that touch something (Cundall's "
                "local damping); a stone in free fall has none. [-]");
  table.offer(
      "Rolling friction", contact.rolling_friction, 0, friction,
      "Rolling resistance of every contact, elastic-plastic; meant for stones of one sphere. "
      "[-]");
}

void declare_mesh_wall(ParameterTable& table, MeshWallParameters& wall)
{
  table.open_section("Mesh wall");
  table.offer_input_file(
      "File", wall.file,
      "A fixed wall of triangles (STL, PLY, OBJ), such as a hopper, relative to this "
      "file; empty: none.");
  table.offer("Length unit", wall.length_unit, 0, not_negative,
              "Length of one unit of the file, 0.001 for millimetres; needed with a file. [m]");
  table.offer("Friction", wall.friction, 0.5, friction, "Friction coefficient with stones. [-]");
}

void declare_drop(ParameterTable& table, DropParameters& drop)
{
  table.open_section("Drop");
  table.offer_seed("Seed", drop.seed,
                   "Seed of the places of the shapes and of the attitudes of the stones. [-]");
  table.require("Batches", drop.batches, {1, 10000, true},
                "Number of batches; each holds every shape once, in the same order. [-]");
  table.require("Height", drop.height, positive,
                "Height of a stone's centre above the floor when it is let go, at rest. [m]");
  table.require("Disc radius", drop.disc_radius, not_negative,
                "Every shape has its own place, the same in each batch, in a horizontal disc of "
                "this radius. [m]");
  table.require("Floor side", drop.floor_side, positive,
                "Side of the square floor, its middle below that of the disc. [m]");
  table.require("Kinetic energy ratio", drop.kinetic_energy_ratio, positive,
                "At rest when the kinetic energy is below this share of total weight x mean stone "
                "size. [-]");
  table.require("Settling time limit", drop.settling_time_limit, positive,
                "The run ends this long after the last stone has fallen at the latest, with a "
                "warning. [s]");
}
} // namespace

void declare_heap(ParameterTable& table, HeapParameters& parameters)
{
  table.open_section("");
  table.require("Gravity", parameters.gravity, positive,
                "Acceleration of gravity, downwards along z. [m/s2]");
  declare_stones(table, parameters.stones);
  declare_contact(table, parameters.contact);
  declare_mesh_wall(table, parameters.mesh_wall);
  declare_drop(table, parameters.drop);

  table.open_section("Measures");
  table.require("Radius", parameters.measures.radius, positive,
                "The share of the mass whose distance from the heap's centroid in plan is larger "
                "is reported. [m]");
  table.require("Elongation limit", parameters.measures.elongation_limit, {0, 1, true},
                "A stone counts as elongated when its intermediate over its longest axis (I/L, "
                "Zingg 1935) is below. [-]");

  declare_time(table, parameters.time);

  table.open_section("Output");
  table.offer("Record interval", parameters.output.record_interval, 0.02, positive,
              "Simulated time between two rows of history.csv. [s]");
  table.offer("Frame interval", parameters.output.frame_interval, 0, not_negative,
              "Simulated time between two frames for ParaView; 0: the last state only. [s]");
  table.offer("Report", parameters.output.report, true,
              "Draw the figures and write report.html at the end of the run.");
  table.offer(
      "Checkpoint interval", parameters.output.checkpoint_interval, 60, not_negative,
      "Wall-clock time between two checkpoints, beside those at the ends of stages; 0: only "
      "those. [s]");
}

std::vector<ParameterProblem> check_heap(const HeapParameters& parameters)
{
  const DropParameters& drop = parameters.drop;
  ParameterProblems problems;
  check_stones(parameters.stones, problems);
  if (drop.disc_radius >= 0.5 * drop.floor_side)
    problems.add("Drop/Disc radius", "The disc from which the stones fall has a radius of ",
                 drop.disc_radius, " m, but it must be smaller than half the side of the floor, ",
                 0.5 * drop.floor_side, " m.");
  const HeapContactParameters& contact = parameters.contact;
  const MeshWallParameters& wall = parameters.mesh_wall;
  check_contact_model(contact.model, parameters.time, problems);
  if (!contact.model.linear() && contact.rolling_friction > 0)
    problems.add(
        "Contact/Rolling friction",
        "Rolling resistance needs linear contacts; set it to 0 or Contact/Model to linear.");
  if (!contact.model.linear() && !wall.file.empty())
    problems.add("Mesh wall/File",
                 "A wall of triangles needs linear contacts; leave it out or set Contact/Model to "
                 "linear.");
  std::error_code error;
  if (!wall.file.empty() && !std::filesystem::is_regular_file(wall.file, error))
    problems.add("Mesh wall/File", "The file \"", wall.file, "\" does not exist.");
  if (!wall.file.empty() && wall.length_unit <= 0)
    problems.add("Mesh wall/Length unit",
                 "The length of one unit of the file must be given with a "
                 "wall of triangles, for example 0.001 m for millimetres.");
  return problems.take();
}
} // namespace interlock::coupling
