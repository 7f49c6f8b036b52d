// The numbers of the protocol of a pull-out test that are nobody's parameters, each with its
// reason.
#pragma once

namespace interlock::coupling::protocol
{
// Poured stones fill about this share of the volume (clumps with their pores between them): rather
// too much than another round, the excess is taken off [-].
constexpr double expected_solid_share = 0.62;
// A filling that is not there after so many rounds does not get there: every round brings the
// surface about nine tenths of the missing height nearer.
constexpr int most_rounds = 8;
// The surface is as high as asked for when it is nearer than this share of a mean stone [-].
constexpr double surface_tolerance = 0.2;
// Stones whose centre is above the surface by more than this share of a mean stone are taken off:
// more of them stay in where the geogrid is laid on an uneven surface, and fewer where a plate
// presses the surface flat [-].
constexpr double margin_not_flattened = 0.25, margin_at_top = 0.5;

// Times that stones are left to settle at least [s]: after some were taken off or out, about what a
// stone needs to fall into the hole of another one by half its size, ...
constexpr double settling_after_removal = 0.02;
// ... after the plate was lifted, which unloads them without a fall, ...
constexpr double settling_after_plate = 0.01;
// ... and below a new load, which has to compact the stones first.
constexpr double settling_below_load = 0.1;

// Beyond these the pull is no measurement of ballast and geogrid any more. Overlap of a contact
// over the mean radius of a member sphere: a surface that is pressed in by a tenth of its radius is
// another surface [-]. Stretch of a rib: data sheets state forces up to 5 %, and ribs here stay
// elastic at any stretch [-].
constexpr double usable_overlap = 0.1, usable_stretch = 0.05;
// The second transverse rib squeezes stones against the front wall from this share of a mean stone
// between them on [-].
constexpr double room_at_wall = 0.5;

// Between the spheres of a surcharge [m].
constexpr double surcharge_gap = 1e-3;
// The filtered pull force is the mean over this displacement: a fortieth of a stone [m].
constexpr double filter_length = 1e-3;
} // namespace interlock::coupling::protocol
