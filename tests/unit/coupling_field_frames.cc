// The contacts of a frame for ParaView, on two balls on a floor whose forces are known: overlap
// times stiffness. It takes a force that is of another size, points the other way, stands at the
// other body or is not opposite and equal at both, or an id of another body, to fail.
#include "coupling/files/hdf5_memory.h"
#include "coupling/output/field_frames.h"
#include "tests/dem_bodies.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

using namespace interlock;
using namespace interlock::coupling;

using FieldFramesFile = TemporaryFolderTest;

TEST_F(FieldFramesFile, ContactsHaveForcesAndBodiesAtBothEnds)
{
  constexpr double k = 1e5, radius = 0.01, at_floor = 1e-5, between = 2e-5;
  const dem::ContactProperties contact = bodies::smooth_contact(k, 0, false);
  dem::Engine engine({bodies::ball(radius)}, contact, 0);
  const dem::WallId gone = engine.add_wall(bodies::plane(contact));
  dem::Wall floor = bodies::plane(contact);
  const dem::WallId wall = engine.add_wall(floor);
  engine.remove_walls({gone}); // so that the id of the floor is not its place in the list
  ASSERT_NE(wall, 0);
  const dem::Quaternion upright = dem::Quaternion::Identity();
  engine.add_clump(0, 2650, {1, 0, 0.5}, upright);
  const double low = radius - at_floor;
  engine.add_clump(0, 2650, {0, 0, low}, upright);
  engine.add_clump(0, 2650, {2 * radius - between, 0, low + 0.5}, upright);
  engine.add_clump(0, 2650, {1 + 2 * radius - between, 0, 0.5}, upright);
  engine.remove_clumps({false, false, true, false}); // ids 0, 1, 3 are left
  engine.compute_forces(1e-6);

  FieldFrames frames(folder);
  frames.start();
  frames.write(0.5, engine);
  const Hdf5Memory file(file_text(folder / "frames" / "contacts_000000.vtkhdf"));
  const auto read = [&](const std::string& name) {
    std::vector<double> values;
    file.read("frame_000000/" + name, values);
    return values;
  };
  EXPECT_EQ(read("body"), (std::vector<double>{0, 3, 1, double(wall)}));
  EXPECT_EQ(read("kind"), (std::vector<double>{0, 1}));
  const std::vector<double> sizes = read("force"), forces = read("force_on_body");
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_NEAR(sizes[0], k * between, 1e-5 * k * between);
  EXPECT_NEAR(sizes[1], k * at_floor, 1e-5 * k * at_floor);
  // The first ball is pushed towards -x, its partner towards +x, the low one upwards.
  const std::vector<double> expected = {-k * between, 0, 0, k * between,  0, 0, 0, 0,
                                        k * at_floor, 0, 0, -k * at_floor};
  ASSERT_EQ(forces.size(), expected.size());
  for (std::size_t c = 0; c < forces.size(); ++c) EXPECT_NEAR(forces[c], expected[c], 1e-5) << c;
  const std::vector<double> points = read("points");
  EXPECT_NEAR(points[3] - points[0], 2 * radius - between, 1e-6);
}
