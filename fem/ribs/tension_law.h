// What a polypropylene rib does in tension: softening along a hyperbola, yield, elastic unloading.
//
//   envelope     N = EA e/(1 + s e) for stretch e > 0, EA e for e <= 0
//                (hyperbola of Kondner, J. Soil Mech. Found. Div. ASCE 89 (1963) SM1, 115-143:
//                slope EA at the start, asymptote EA/s)
//   yield        N <= N_y
//   unloading    N = EA (e - e_p), and so reloading until the envelope is met again
//
// The least of the three holds. The history is the plastic stretch e_p: what remains when the force
// is taken off. It only grows. EA is the largest stiffness of the law. Energy stored per length is
// N^2/(2 EA); the rest of the work is lost.
#pragma once

#include <algorithm>
#include <limits>

namespace interlock::fem
{
struct TensionLaw {
  double axial = 0;                                             // EA [N]
  double softening = 0;                                         // s [-]; 0: linear elastic
  double yield_force = std::numeric_limits<double>::infinity(); // N_y [N]
};

// Law of one rib from a data sheet: `secant_2` and `secant_5` are force per width over strain at
// 2 % and 5 % strain [N/m], `spacing` the distance between ribs [m], `strength` the largest force
// per width [N/m], which becomes the yield force. Both secants equal: linear elastic until yield.
//
// Throws std::invalid_argument when a value is not positive, when secant_5 exceeds secant_2 (no
// stiffening), when the force at 5 % does not exceed that at 2 %, or when the strength is below the
// force at 5 %.
TensionLaw tension_law(double secant_2, double secant_5, double spacing,
                       double strength = std::numeric_limits<double>::infinity());

// Plastic stretch e_p [-] at a stretch that is reached from the plastic stretch `before`;
// `yield_stretch` is N_y/EA. For every number type of the element kernel.
template <class Number, class Constant>
Number plastic_stretch(const Number& stretch, const Constant& softening,
                       const Constant& yield_stretch, const Constant& before)
{
  using std::max, std::min;
  // Stretch that the largest force possible here would recover. With s = 0, or in compression, it
  // is the stretch itself to the last digit, so that e_p stays what it was.
  const Number envelope = stretch / (1. + softening * max(stretch, Number(0.)));
  const Number recovered = min(envelope, Number(yield_stretch));
  return max(Number(before), Number(stretch - recovered));
}

// The same, and the axial force [N] there.
double plastic_stretch(const TensionLaw& law, double stretch, double before);
double axial_force(const TensionLaw& law, double stretch, double before);

// Work per length [J/m] lost until the plastic stretch e_p was reached: the integral of N de_p. It
// depends on e_p alone, because N grows with e_p while e_p grows.
double plastic_work(const TensionLaw& law, double plastic_stretch);
} // namespace interlock::fem
