// When the clump generator has spheres enough.
#pragma once

#include "dem/generator/clump_generator.h"
#include "dem/generator/union_volume.h"

#include <optional>

namespace interlock::dem
{
class StopRules
{
public:
  // The rules of `parameters` for a stone with these mass properties and this box around it.
  StopRules(const ClumpParameters& parameters, const MassProperties& stone,
            const Eigen::AlignedBox3d& box);

  // Spheres come without the bulge that they may get. The error of the volume is the one with the
  // bulge that brings it nearest, that of the moments the one without.
  // To be called after each kept sphere, the last of `spheres` (frame of the stone): the rule that
  // now holds, if any does.
  std::optional<Stop> after(const std::vector<Sphere>& spheres);

private:
  const ClumpParameters& parameters_;
  MassProperties stone_;
  std::optional<UnionVolume> union_; // kept only for its rule
};
} // namespace interlock::dem
