// The geogrid of a pull-out by itself.
#pragma once

#include "coupling/loop/rib_transfer.h"
#include "coupling/pull_out/geogrid_sheet.h"

// `front`: middle of its front transverse rib [m]; `gravity` acts along -z [m/s2].
inline interlock::coupling::RibTransfer
laid_geogrid(const interlock::coupling::GeogridParameters& p, const interlock::dem::Vector3& front,
             double gravity)
{
  const interlock::coupling::GeogridSheet sheet = interlock::coupling::lay_geogrid(p, front);
  interlock::fem::DynamicsOptions options;
  options.gravity = {0, 0, -gravity};
  options.mass_damping = p.mass_damping;
  return {sheet.lattice, options, sheet.clamped, p.rigid, p.edge_rounding};
}
