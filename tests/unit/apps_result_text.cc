// The numbers of a summary on the terminal. It takes a unit that is missing or wrong, or more than
// four digits, to fail.
#include "apps/result_text.h"

#include <gtest/gtest.h>

using interlock::apps::result_text;

TEST(ResultText, HasFourDigitsAndTheUnit)
{
  EXPECT_EQ(result_text("pull_force_at_end_N", 282.113055118146), "pull force at end = 282.1 N");
  EXPECT_EQ(result_text("bulk_density_kg_per_m3", 1538.7654), "bulk density = 1539 kg/m3");
  EXPECT_EQ(result_text("rms_speed_before_pull_m_per_s", 0.0123456),
            "rms speed before pull = 0.01235 m/s");
  EXPECT_EQ(result_text("aperture_stability_N_m_per_deg", 0.3456789),
            "aperture stability = 0.3457 N m/deg");
  EXPECT_EQ(result_text("wide_width_force_at_2_percent_along_kN_per_m", 4.1),
            "wide width force at 2 percent along = 4.1 kN/m");
}

TEST(ResultText, TakesTheUnitThatSuitsTheSize)
{
  EXPECT_EQ(result_text("displacement_at_peak_m", 0.012650191434313986),
            "displacement at peak = 12.65 mm");
  EXPECT_EQ(result_text("box_length_m", 1.25), "box length = 1.25 m");
  EXPECT_EQ(result_text("smallest_stable_step_s", 3.5521972974475988e-06),
            "smallest stable step = 3.552 us");
  EXPECT_EQ(result_text("contacts_s_per_step", 1.2345678e-05), "contacts = 12.35 us a step");
  EXPECT_EQ(result_text("peak_pull_force_N", 523456.789), "peak pull force = 523.5 kN");
  EXPECT_EQ(result_text("cell_pressure_Pa", 30123.4), "cell pressure = 30.12 kPa");
  EXPECT_EQ(result_text("surcharge_N", 0.), "surcharge = 0 N");
}

TEST(ResultText, LeavesWordsAndWholeNumbers)
{
  EXPECT_EQ(result_text("stones", 123456), "stones = 123456");
  EXPECT_EQ(result_text("rigid", true), "rigid = true");
  EXPECT_EQ(result_text("placement", "flattened"), "placement = flattened");
  EXPECT_EQ(result_text("speed_m_per_s", nullptr), "speed = not finite");
}
