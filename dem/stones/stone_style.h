// How synthetic stones look on the whole: the distributions that their forms are drawn from.
#pragma once

namespace interlock::dem
{
// The default values give fresh railway ballast of crushed granite; docs/theory/stones.md compares
// them with published measurements. A spread is the standard deviation of what is drawn; draws
// outside 0.3 to 1 are drawn again, and what stone_size() measures scatters a little more. Numbers
// of features vary from stone to stone about their means.
struct StoneStyle {
  double flatness = 0.76;          // mean of shortest/intermediate axis, 0.4-0.95
  double flatness_spread = 0.12;   // 0-0.2
  double elongation = 0.76;        // mean of intermediate/longest axis, 0.4-0.95
  double elongation_spread = 0.11; // 0-0.2

  // Fracture faces: fewer give a more angular stone. 5-40.
  int faces = 10;
  // Width of the rounding of edges and corners, relative to the distance from the centre: at 0.06
  // a right-angled edge of a 40 mm stone has lost about 0.3 mm. 0.005-0.5.
  double edge_wear = 0.06;

  // Conchoidal scars: mean number of faces that are hollow (parts of spheres), 0-20, and how deep a
  // hollow is whose rim is half a sieve size across, relative to the sieve size, 0-0.1.
  int scars = 4;
  double scar_depth = 0.022;
  // Mean number of steps, where a flake broke off across a part of a face, 0-6; they are one to two
  // and a half scar depths high.
  int steps = 2;

  // Roughness: rms height [m] of the waves of 10 mm, 0-0.002. Waves of length l have it times
  // (l/10 mm)^exponent: fracture surfaces of rock are self-affine with an exponent near 0.8
  // (Bouchaud, J. Phys.: Condens. Matter 9 (1997) 4319). Exponent 0.3-1.5. Wavelengths go down by
  // octaves from half a stone to 2.5 times the spacing of nodes.
  double roughness = 0.00012;
  double roughness_exponent = 0.8;

  // Mean distance of neighbouring nodes [m], 0.00005-0.005. 0: about 0.0016, but never less than
  // 1692 nor more than 2562 nodes a stone. A finer mesh has finer roughness on the same stone.
  double spacing = 0;
};

// Throws InputError with one sentence (entry, value, allowed range) when an entry is out of range.
void check_style(const StoneStyle& style);
} // namespace interlock::dem
