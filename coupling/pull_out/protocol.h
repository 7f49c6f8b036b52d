// The numbers of the protocol of a pull-out test that are nobody's parameters, each with its
// reason.
#pragma once

namespace interlock::coupling::protocol
{
// Stones whose centre is above the surface by more than this share of a mean stone are taken off:
// more of them stay in where the geogrid is laid on an uneven surface, and fewer where a plate
// presses the surface flat [-].
constexpr double margin_not_flattened = 0.25, margin_at_top = 0.5;

// A surface is level when the plate came this near to its height, as share of a mean stone [-].
constexpr double level_tolerance = 0.1;

// A half that is weighed in is pressed down so far below the geogrid, so that the ribs touch no
// stone when they are laid: what springs back would be taken out whole, and leave a pit [m].
constexpr double room_below_ribs = 1e-3;

// Stones are left to settle at least so long after the plate was lifted, which unloads them without
// a fall [s].
constexpr double settling_after_plate = 0.01;

// Beyond these the pull is no measurement of ballast and geogrid any more. Overlap of a contact
// over the mean radius of a member sphere: a surface that is pressed in by a tenth of its radius is
// another surface [-]. Stretch of a rib, plastic stretch included: data sheets state forces up to
// 5 %, and beyond that the law of ribs is a guess [-].
constexpr double usable_overlap = 0.1, usable_stretch = 0.05;
// The second transverse rib squeezes stones against the front wall from this share of a mean stone
// between them on [-].
constexpr double room_at_wall = 0.5;

// Between the spheres of a surcharge [m].
constexpr double surcharge_gap = 1e-3;
// The filtered pull force is the mean over this displacement: a fortieth of a stone [m].
constexpr double filter_length = 1e-3;
} // namespace interlock::coupling::protocol
