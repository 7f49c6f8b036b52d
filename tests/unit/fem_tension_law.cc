// The tension law of a rib against its own definition: hyperbola, yield, elastic unloading. Fails
// when the numbers of a data sheet are missed, when the least of the three branches does not hold,
// or when stored and lost energy are not the work done.
#include "fem/lattice/lattice.h"
#include "fem/ribs/tension_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace
{
using namespace interlock::fem;

// Biaxial geogrid BX1100 along the machine: 4.1 kN/m at 2 %, 8.5 kN/m at 5 %, 12.4 kN/m at most.
TensionLaw data_sheet()
{
  return tension_law(205e3, 170e3, 0.025, 12.4e3);
}

// A law with EA = 30 kN that softens as strongly but yields at about 9 %.
const TensionLaw softening{30e3, 8, 1.5e3};

double envelope(const TensionLaw& law, double e)
{
  return e > 0 ? law.axial * e / (1 + law.softening * e) : law.axial * e;
}

TEST(TensionLaw, MeetsBothPointsOfTheDataSheet)
{
  const TensionLaw law = data_sheet();
  EXPECT_NEAR(axial_force(law, 0.02, 0), 0.025 * 4.1e3, 1e-14 * 0.025 * 4.1e3);
  EXPECT_NEAR(axial_force(law, 0.05, 0), 0.025 * 8.5e3, 1e-14 * 0.025 * 8.5e3);
  EXPECT_NEAR(axial_force(law, 0.3, 0), 0.025 * 12.4e3, 1e-14 * 0.025 * 12.4e3);
  // s = (205 - 170)/(8.5 - 4.1) and EA = 205 (1 + 0.02 s) by hand.
  EXPECT_NEAR(law.softening, 35 / 4.4, 1e-13);
  EXPECT_NEAR(law.axial, 0.025 * 205e3 * (1 + 0.02 * 35 / 4.4), 1e-10);
}

TEST(TensionLaw, EqualSecantsAreLinear)
{
  const TensionLaw law = tension_law(205e3, 205e3, 0.025);
  EXPECT_EQ(law.softening, 0);
  EXPECT_DOUBLE_EQ(law.axial, 205e3 * 0.025);
  for (const double e : {-0.1, -1e-9, 0., 1e-9, 0.02, 0.4}) {
    EXPECT_EQ(axial_force(law, e, 0), law.axial * e);
    EXPECT_EQ(plastic_stretch(law, e, 0), 0); // to the last digit
  }
}

TEST(TensionLaw, RisesSmoothlyFromCompressionAndBelowItsAsymptote)
{
  const TensionLaw law{30e3, 8};
  for (const double e : {1e-4, 1e-6, 1e-8}) {
    EXPECT_NEAR(axial_force(law, e, 0) / e, law.axial, 1.001 * law.softening * e * law.axial);
    EXPECT_EQ(axial_force(law, -e, 0), -law.axial * e);
  }
  double last = axial_force(law, -0.1, 0);
  for (double e = -0.099; e < 5; e += 1e-3) {
    const double force = axial_force(law, e, 0);
    EXPECT_GT(force, last);
    EXPECT_LT(force, law.axial / law.softening);
    last = force;
  }
}

// Any history: the force is the least of unloading line, envelope and yield force, and the plastic
// stretch is what is left when it is taken off.
TEST(TensionLaw, TheLeastOfTheThreeHolds)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.05, 0.15);
  double plastic = 0;
  for (int step = 0; step < 1000; ++step) {
    const double e = uniform(generator) * std::min(1., step / 500.);
    const double least =
        std::min({softening.axial * (e - plastic), envelope(softening, e), softening.yield_force});
    EXPECT_NEAR(axial_force(softening, e, plastic), least, 1e-14 * softening.axial);
    const double after = plastic_stretch(softening, e, plastic);
    EXPECT_GE(after, plastic);
    EXPECT_NEAR(after, std::max(plastic, e - least / softening.axial), 1e-16);
    if (least == softening.axial * (e - plastic)) {
      EXPECT_EQ(after, plastic);
    }
    plastic = after;
  }
  EXPECT_GT(plastic, 0.05);
}

// Stored N^2/(2 EA) and plastic work are together the integral of N de, whatever the path:
// along the envelope, down and up again, into yield, into compression.
TEST(TensionLaw, StoredAndLostEnergyAreTheWorkDone)
{
  for (const TensionLaw& law : {softening, TensionLaw{30e3, 8}, TensionLaw{30e3, 0, 1.5e3}}) {
    double plastic = 0, e = 0, work = 0;
    for (const double target : {0.04, 0.01, 0.07, -0.02, 0.2, 0.1}) {
      const int n = 20000;
      const double de = (target - e) / n;
      for (int i = 0; i < n; ++i) {
        const double before = axial_force(law, e, plastic);
        e += de;
        work += 0.5 * de * (before + axial_force(law, e, plastic));
        plastic = plastic_stretch(law, e, plastic);
      }
      const double force = axial_force(law, e, plastic);
      const double booked = force * force / (2 * law.axial) + plastic_work(law, plastic);
      EXPECT_NEAR(booked, work, 1e-7 * law.axial * 0.04 * 0.04) << "at stretch " << e;
    }
  }
  EXPECT_EQ(plastic_work(softening, 0), 0);
}

void expect_refusal(double secant_2, double secant_5, double spacing, double strength,
                    const std::string& fact)
{
  try {
    tension_law(secant_2, secant_5, spacing, strength);
    ADD_FAILURE() << fact << " was not missed";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(fact), std::string::npos) << error.what();
  }
}

TEST(TensionLaw, RefusesDataSheetsThatItCannotFollow)
{
  expect_refusal(170e3, 205e3, 0.025, 20e3, "stiffen");
  expect_refusal(205e3, 80e3, 0.025, 20e3, "at 5 % strain"); // 4.0 kN/m after 4.1
  expect_refusal(205e3, 170e3, 0.025, 8e3, "strength");
  expect_refusal(205e3, 170e3, 0, 20e3, "spacing");
  expect_refusal(-1, 170e3, 0.025, 20e3, "2 %");
}

TEST(TensionLaw, LatticeRefusesWhatIsNoLaw)
{
  BeamSection section = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  section.softening = -1;
  EXPECT_THROW(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 2, section)}), std::invalid_argument);
  section.softening = 8;
  section.yield_force = 0;
  EXPECT_THROW(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 2, section)}), std::invalid_argument);
}
} // namespace
