// Filling a box up to a height: a stage of several experiments.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/run/run_records.h"
#include "coupling/run/stage.h"
#include "coupling/stones/pouring.h"
#include "coupling/stones/settling.h"

#include <string>

namespace interlock::coupling
{
// Pours, lets settle, and pours what is missing, until the mean surface is at `height`; then takes
// off the stones whose centre is higher than `height` + `margin`. Or pours `mass`, in the mean to
// the nearest stone, and takes nothing off: the surface is left for a plate.
struct FillStage {
  static constexpr const char* kind = "fill";
  enum class Phase { begin, pouring, levelling };
  std::string title; // in the log
  double height = 0; // [m]
  double margin = 0; // [m]
  double mass = 0;   // 0: as much as it takes [kg]
  Phase phase = Phase::begin;
  int rounds = 0;    // poured so far
  int taken_off = 0; // stones above the surface
  Settling settling = {};
};

inline std::string stage_name(const FillStage& stage)
{
  return stage.title;
}

template <class Archive> void exchange(Archive& archive, FillStage& stage)
{
  archive("title", stage.title);
  archive("height", stage.height, "m");
  archive("margin", stage.margin, "m");
  archive("mass", stage.mass, "kg");
  archive("phase", stage.phase);
  archive("rounds", stage.rounds);
  archive("taken_off", stage.taken_off);
  archive("settling", stage.settling);
}

// What a filling needs to know of its experiment.
struct Filling {
  World& world;
  const BoxParameters& box;
  Pouring pouring;
  SettlingParameters settling;
};

// before_step of the stage.
StageStatus fill(FillStage& stage, const Filling& filling, RunRecords& records);
} // namespace interlock::coupling
