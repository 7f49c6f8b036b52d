// What the ribs of a pull-out touch, and with which springs: stones, and the box.
#pragma once

#include "coupling/loop/rib_wall_points.h"
#include "coupling/pull_out/pull_out_parameters.h"
#include "dem/contacts/contact_properties.h"

namespace interlock::coupling
{
// Springs of stone and rib in series; without Contact/Geogrid stiffness Hertz's and Mindlin's, of
// the ribs' material. The limit of crushing is that of the stone: nothing is known here of how ribs
// are bruised.
dem::ContactProperties stone_on_geogrid(const PullOutParameters& parameters);

// The box with its slot about the geogrid, and the contact of its walls with ribs: springs of wall
// and rib in series. Without Contact/Geogrid stiffness the rib has that of a rigid round punch as
// wide as the narrowest ribs on a half-space of their material, E/(1 - nu^2) times the width
// (Johnson, Contact Mechanics, 1985, section 3.4).
RibBox box_of_ribs(const PullOutParameters& parameters);
} // namespace interlock::coupling
