// What is wrong with a lattice or its file is one sentence that says what and where. Fails when a
// fault passes, another exception escapes, or the sentence lacks the facts.
#include "fem/gmsh/gmsh_lattice.h"
#include "fem/lattice/lattice_checks.h"
#include "fem/layouts/biaxial_layout.h"
#include "fem/layouts/junction_zones.h"
#include "fem/layouts/triaxial_layout.h"
#include "fem/layouts/uniaxial_layout.h"
#include "tests/gmsh_files.h"
#include "tests/temporary_folder.h"

#include <cmath>
#include <functional>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

void expect_refused(const std::function<void()>& action, const std::vector<std::string>& facts)
{
  try {
    action();
    ADD_FAILURE() << "accepted, although " << (facts.empty() ? "" : facts.front());
  } catch (const std::exception& error) {
    const std::string text = error.what();
    EXPECT_TRUE(dynamic_cast<const std::invalid_argument*>(&error) != nullptr ||
                dynamic_cast<const std::runtime_error*>(&error) != nullptr)
        << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
    for (const std::string& fact : facts) EXPECT_NE(text.find(fact), std::string::npos) << text;
  }
}

const RibSection rectangle{3e-3, 2e-3, 2.4e9, 0.4, 910};
const BeamSection sound = beam_section(rectangle);

RibLine line(const Vector3d& start, const Vector3d& end, int elements = 1)
{
  RibLine line = straight_line(start, end, elements, sound);
  line.shape = rectangle;
  return line;
}

class LatticeFile : public TemporaryFolderTest
{
protected:
  void refuse(const std::string& path, const std::vector<std::string>& facts,
              const std::map<std::string, GmshSection>& sections = {{"rib", {{rectangle, sound}}}},
              double unit = 1) const
  {
    std::vector<std::string> all = facts;
    all.push_back(path);
    expect_refused([&] { gmsh_lattice(read_gmsh_file(path), sections, unit); }, all);
  }
  // Both versions of the file.
  void refuse(const GmshText& text, const std::vector<std::string>& facts) const
  {
    refuse(write("v2.msh", text.version_2()).string(), facts);
    refuse(write("v4.msh", text.version_4()).string(), facts);
  }
};

GmshText cross()
{
  GmshText text;
  text.nodes = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  text.line_groups = {"rib"};
  text.lines = {{1, 0, 0}, {0, 2, 0}, {3, 0, 0}, {0, 4, 0}};
  return text;
}
} // namespace

TEST_F(LatticeFile, WhatIsNoGmshFileIsRefused)
{
  refuse((folder / "missing.msh").string(), {"cannot be opened"});
  refuse(write("text.msh", "hello\n").string(), {"$MeshFormat"});
  refuse(write("empty.msh", "").string(), {"$MeshFormat"});
  refuse(write("geometry.msh", "Point(1) = {0, 0, 0};\n").string(), {"$MeshFormat"});
  refuse(folder.string(), {});
}

TEST_F(LatticeFile, BrokenFilesAreRefused)
{
  const std::string whole = cross().version_2();
  refuse(write("head.msh", "$MeshFormat\n").string(), {});
  refuse(write("cut.msh", whole.substr(0, whole.find("$EndNodes") - 20)).string(), {});
  std::string stray = whole;
  stray.replace(stray.find("\n4 1 2 1 1 1 5"), 14, "\n4 1 2 1 1 1 9"); // a node that is not there
  refuse(write("stray.msh", stray).string(), {"9"});
  stray = cross().version_4();
  stray.replace(stray.find("\n4 1 5\n"), 7, "\n4 1 9\n");
  refuse(write("stray4.msh", stray).string(), {"9"});
}

// Gmsh's library (4.8) may die of a node number -1, or of a name for a group of dimension 9.
TEST_F(LatticeFile, WhatGmshMayCrashOnIsRefused)
{
  const std::string whole = cross().version_4();
  std::string node = whole, group = whole;
  node.replace(node.find("\n4 1 5\n"), 7, "\n4 1 -1\n");
  refuse(write("node.msh", node).string(), {});
  group.replace(group.find("\n1 1 \"rib\""), 10, "\n9 1 \"rib\"");
  refuse(write("group.msh", group).string(), {});
}

TEST_F(LatticeFile, NodesMustBeSomewhere)
{
  for (const char* number : {"nan", "inf", "1e999"}) {
    std::string text = cross().version_2();
    text.replace(text.find("\n2 1 0 0"), 8, std::string("\n2 ") + number + " 0 0");
    refuse(write("nowhere.msh", text).string(), {"node 2", "no numbers"});
  }
}

TEST_F(LatticeFile, LinesAndTheirGroupsAreNeeded)
{
  GmshText text = cross();
  text.lines.clear();
  text.point_groups = {"corner"};
  text.points = {{1, 0}};
  refuse(write("points.msh", text.version_2()).string(), {"no line elements"});

  text = cross();
  std::string none = text.version_2();
  for (std::string::size_type at; (at = none.find(" 1 2 1 1 ")) != std::string::npos;)
    none.replace(at, 9, " 1 2 0 1 ");
  refuse(write("none.msh", none).string(), {"no physical group"});

  std::string mixed = text.version_2();
  mixed.replace(mixed.find("\n4 1 2 1 1 1 5"), 14, "\n4 8 2 1 1 1 5 2");
  refuse(write("mixed.msh", mixed).string(), {"curve 1", "higher order", "2 nodes"});
  std::string second_order = text.version_2();
  second_order.replace(second_order.find("$Elements"), std::string::npos,
                       "$Elements\n1\n1 8 2 1 1 2 3 1\n$EndElements\n");
  refuse(write("second.msh", second_order).string(), {"curve 1", "higher order", "2 nodes"});
}

TEST_F(LatticeFile, GroupsAndSectionsMustMatch)
{
  const std::string file = write("cross.msh", cross().version_4()).string();
  EXPECT_EQ(gmsh_lattice(read_gmsh_file(file), {{"rib", {{rectangle, sound}}}}).lines.size(), 2u);
  refuse(file, {"\"rib\"", "no section", "\"bar\""}, {{"bar", {{rectangle, sound}}}});
  refuse(file, {"\"bar\"", "no lines", "\"rib\""},
         {{"rib", {{rectangle, sound}}}, {"bar", {{rectangle, sound}}}});
  refuse(file, {"\"rib\"", "E A", " 0 "}, {{"rib", {}}});
  for (const double unit : {0., -1e-3, std::nan("")})
    refuse(file, {"unit"}, {{"rib", {{rectangle, sound}}}}, unit);
}

TEST_F(LatticeFile, UnconnectedAndOverlappingRibsAreRefused)
{
  GmshText text = cross();
  text.nodes.insert(text.nodes.end(), {{3, 0, 0}, {4, 0, 0}});
  text.lines.push_back({5, 6, 0});
  refuse(text, {"2 pieces", "5 nodes", "2 nodes", "(3, 0, 0)"});

  text = cross(); // the ribs cross, but only one has a vertex there
  text.lines = {{1, 2, 0}, {3, 0, 0}, {0, 4, 0}, {1, 3, 0}};
  refuse(text, {"(0, 0, 0)", "without a junction"});

  text = cross();
  text.lines.push_back({1, 0, 0});
  refuse(text, {"over each other", "(0.5, 0, 0)"});

  text = cross();
  text.lines.push_back({1, 1, 0});
  refuse(text, {"no length", "(1, 0, 0)"});
}

TEST_F(LatticeFile, PointsMustLieOnLines)
{
  GmshText text = cross();
  text.nodes.push_back({5, 5, 0});
  text.point_groups = {"clamp"};
  text.points = {{5, 0}};
  refuse(text, {"\"clamp\"", "(5, 5, 0)"});
}

TEST(LatticeChecks, PiecesAreCountedAndPlaced)
{
  const std::vector<RibLine> apart = {line({0, 0, 0}, {1, 0, 0}, 4), line({0, 1, 0}, {1, 1, 0}),
                                      line({0, 2, 0}, {1, 2, 0}), line({0, 3, 0}, {1, 3, 0})};
  expect_refused([&] { check_connected(Lattice(apart)); },
                 {"4 pieces", "5 nodes at (0, 0, 0) m", "2 nodes at (0, 2, 0) m", "1 more"});
  std::vector<RibLine> joined = apart;
  joined.resize(2);
  joined.push_back(line({0, 0, 0}, {0, 1, 0}));
  EXPECT_NO_THROW(check_lattice(Lattice(joined)));
  EXPECT_NO_THROW(check_lattice(Lattice(joined, {1, 1}))); // springs connect too
}

TEST(LatticeChecks, OverlapsAreFound)
{
  const auto refuse = [](const std::vector<RibLine>& lines, const std::vector<std::string>& facts) {
    expect_refused([&] { check_overlaps(Lattice(lines)); }, facts);
  };
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0.3, -1, 0}, {0.3, 1, 0})},
         {"0 and 1", "(0.3, 0, 0)", "without a junction"});
  // A rib that ends on another one, away from its vertices.
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0.3, 0, 0}, {0.3, 1, 0})}, {"without a junction"});
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0, 0, 0}, {0.5, 0, 0})}, {"over each other"});
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0.5, 0, 0}, {1.5, 0, 0})}, {"over each other"});
  refuse({line({0, 0, 0}, {1, 0, 0}), line({1.5, 0, 0}, {-0.5, 0, 0})}, {"over each other"});
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0.5, 2.9e-3, 0}, {1.5, 2.9e-3, 0})},
         {"side by side", "0.0029", "0.003"});
  refuse({line({0, 0, 0}, {1, 0, 0}), line({0, 0, 1.9e-3}, {1, 0, 1.9e-3})},
         {"side by side", "0.0019", "0.002"});
  // Near, but apart; one behind the other; and end to end.
  EXPECT_NO_THROW(check_overlaps(
      Lattice({line({0, 0, 0}, {1, 0, 0}, 7), line({0, 3.1e-3, 0}, {1, 3.1e-3, 0}, 5),
               line({1, 0, 0}, {2, 0, 0}, 3), line({2.1, 0, 0}, {3, 0, 0}, 2)})));
}

TEST(LatticeChecks, LinesWithoutLengthOrSectionAreRefused)
{
  RibLine still = line({0, 0, 0}, {1, 0, 0}, 2);
  still.points[1] = still.points[0];
  expect_refused([&] { Lattice({still}); }, {"line 0", "without length", "(0, 0, 0)"});
  RibLine bare = line({0, 0, 0}, {1, 0, 0});
  bare.section = {};
  expect_refused([&] { check_sections(Lattice({bare})); }, {"line 0", "E A"});
  RibLine nowhere = line({0, 0, 0}, {1, 0, 0}, 2);
  nowhere.points[1].y() = std::nan("");
  expect_refused([&] { Lattice({nowhere}); }, {"line 0", "(0.5, nan, 0)", "finite"});
  RibLine speck = line({0, 0, 0}, {1, 0, 0}, 2);
  speck.points.insert(speck.points.begin() + 1, Vector3d(1e-12, 0, 0));
  expect_refused([&] { Lattice({speck}); }, {"line 0", "1e-12 m", "millionth", "(1e-12, 0, 0)"});
  RibLine few = line({0, 0, 0}, {1, 0, 0}, 3);
  few.profiles.resize(2);
  expect_refused([&] { Lattice({few}); }, {"line 0", "2 profiles", "3 elements"});
  BeamSection negative = sound;
  negative.torsion = -1;
  expect_refused([&] { given_section(negative); }, {"G J", "-1"});
  negative = sound;
  negative.rotary_2 = std::nan("");
  expect_refused([&] { given_section(negative); }, {"rotary", "nan"});
  expect_refused([&] { beam_section(round_section(0, 2.4e9, 0.4, 910)); }, {"width", " 0 "});
}

TEST(LatticeChecks, JunctionsWithoutAPlaneOrWithNegativeStiffnessAreRefused)
{
  const std::vector<RibLine> lines = {line({-1, 0, 0}, {1, 0, 0}, 2),
                                      line({0, -1, 0}, {0, 1, 0}, 2)};
  expect_refused([&] { Lattice(lines, {-1, 0}); }, {"rotational stiffness", "-1"});
  std::vector<RibLine> twisted = lines;
  twisted[1].normal = {1, 0, 0};
  expect_refused([&] { Lattice(twisted, {1, 1}); }, {"normals", "(0, 0, 0)"});
  EXPECT_NO_THROW(Lattice{twisted});
  expect_refused([&] { thicken_junctions(lines, {0, 4e-3}); }, {"reach", " 0 "});
  expect_refused([&] { thicken_junctions(lines, {1e-2, 1e-3}); }, {"thickness", "0.001", "0.002"});
}

TEST(LatticeChecks, LayoutsWithoutGapsAreRefused)
{
  BiaxialLayout biaxial;
  biaxial.apertures_along = biaxial.apertures_across = 2;
  biaxial.pitch_along = biaxial.pitch_across = 3e-3;
  biaxial.section_along = biaxial.section_across = rectangle;
  expect_refused([&] { rib_lines(biaxial); }, {"width", "0.003", "pitch"});

  UniaxialLayout uniaxial;
  uniaxial.apertures_along = uniaxial.apertures_across = 2;
  uniaxial.bar_pitch = 0.2;
  uniaxial.rib_pitch = 0.02;
  uniaxial.rib = uniaxial.bar = rectangle;
  EXPECT_NO_THROW(rib_lines(uniaxial));
  uniaxial.bar.width = 0.3;
  expect_refused([&] { rib_lines(uniaxial); }, {"width of bars", "0.3", "0.2"});
  uniaxial.elements_per_bar = 0;
  expect_refused([&] { rib_lines(uniaxial); }, {"elements per bar", " 0 "});

  TriaxialLayout triaxial;
  triaxial.length = triaxial.width = 0.2;
  triaxial.side = 0.04;
  triaxial.section_across = triaxial.section_rising = triaxial.section_falling = rectangle;
  EXPECT_NO_THROW(rib_lines(triaxial));
  triaxial.length = 0.03;
  expect_refused([&] { rib_lines(triaxial); }, {"no room", "0.03 m x 0.2 m"});
  triaxial.length = 0.2;
  triaxial.side = 5.1e-3; // height 4.4 mm, three half widths 4.5 mm
  expect_refused([&] { rib_lines(triaxial); }, {"half rib widths", "0.0045"});
}
