// The geogrid as it is laid into the box. Fails when the same ribs by entries and by a product are
// not the same to the last digit, when a row of transverse ribs is not what lies at one x, when a
// sheet does not end at its cut or has other ribs than the cut leaves, when a drawing is put
// elsewhere or held elsewhere, or when a junction is not as thick for stones as it is.
#include "coupling/pull_out/geogrid_sheet.h"

#include "coupling/loop/rib_names.h"
#include "coupling/loop/rib_transfer.h"
#include "dem/input_error.h"
#include "tests/geogrid_products.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
const BoxParameters box{0.4, 0.2, 0.3, 0.02};

GeogridSheet laid(const GeogridParameters& p)
{
  return lay_geogrid(p, front_of_geogrid(p, box));
}

double length_of_ribs(const fem::Lattice& lattice)
{
  double sum = 0;
  for (int e = 0; e < lattice.n_elements(); ++e) sum += lattice.element(e).length;
  return sum;
}

// Overlap with the ribs of a ball whose centre lies at a place [m].
double overlap(const GeogridSheet& sheet, double rounding, const Vector3& centre, double radius)
{
  const RibTransfer geogrid(sheet.lattice, {}, sheet.clamped, false, rounding);
  double most = -1e300;
  for (const dem::Rib& rib : geogrid.ribs().all())
    most = std::max(most, dem::rib_proximity(rib, centre, radius).overlap);
  return most;
}

class DrawnSheet : public TemporaryFolderTest
{
protected:
  // Three lines in mm: two along, one across that closes them at the far end, one at the near end.
  std::filesystem::path drawing(const std::string& more_points = "", double height = 0)
  {
    const bool clamp = !more_points.empty();
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n";
    text += clamp ? "3\n0 3 \"clamp\"\n" : "2\n";
    text += "1 1 \"along\"\n1 2 \"across\"\n$EndPhysicalNames\n$Nodes\n6\n"
            "1 0 0 7\n2 50 0 7\n3 100 0 7\n4 0 80 7\n5 50 80 7\n6 100 80 " +
            std::to_string(7 + height) + "\n$EndNodes\n$Elements\n";
    text += clamp ? "8\n" : "7\n";
    text += "1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n3 1 2 1 2 4 5\n4 1 2 1 2 5 6\n"
            "5 1 2 2 3 1 4\n6 1 2 2 4 2 5\n7 1 2 2 5 3 6\n" +
            more_points + "$EndElements\n";
    return write("sheet.msh", text);
  }
};
} // namespace

TEST(GeogridSheet, SameRibsByProductAndByEntriesAreTheSameToTheLastDigit)
{
  GeogridParameters entries;
  entries.apertures_along = 3, entries.apertures_across = 2;
  entries.overhang = 5e-3;
  entries.pitch_along = 0.065, entries.pitch_across = 0.06;
  entries.rib_width = 5e-3, entries.rib_thickness = 2.5e-3;
  entries.youngs_modulus = 2.4e9, entries.poisson_ratio = 0.3, entries.density = 910;
  entries.elements_per_rib = 8;
  ProductParameters same;
  same.pitch_along = 0.065, same.pitch_across = 0.06;
  same.along = same.across = {5e-3, 2.5e-3, 2.4e9};
  same.poisson_ratio = 0.3, same.density = 910;
  GeogridParameters product = test_products::of(same, 3, 2);

  const GeogridSheet a = laid(entries), b = laid(product);
  ASSERT_EQ(a.lattice.n_elements(), b.lattice.n_elements());
  for (int n = 0; n < a.lattice.n_nodes(); ++n)
    EXPECT_EQ(a.lattice.reference_position(n), b.lattice.reference_position(n));
  for (int e = 0; e < a.lattice.n_elements(); ++e) {
    EXPECT_EQ(a.lattice.section(e).axial, b.lattice.section(e).axial);
    EXPECT_EQ(a.lattice.section(e).torsion, b.lattice.section(e).torsion);
    EXPECT_EQ(a.lattice.section(e).line_density, b.lattice.section(e).line_density);
    EXPECT_EQ(a.lattice.section(e).softening, 0);
  }
  EXPECT_EQ(a.clamped, b.clamped);
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.thickness, 2.5e-3);
  EXPECT_NEAR(a.room_behind, 0.06, 1e-15); // between ribs of 5 mm, 65 mm apart
  // The near edge of the front rib lies an overhang before the wall.
  EXPECT_DOUBLE_EQ(a.lattice.reference_position(a.clamped[0]).x(), -7.5e-3);
}

TEST(GeogridSheet, RowsAreWhatLiesAcrossAtOneX)
{
  const GeogridSheet biaxial = laid(test_products::of(test_products::biaxial(), 5, 2));
  EXPECT_EQ(biaxial.along, (std::vector<int>{0, 1, 2}));
  ASSERT_EQ(biaxial.rows.size(), 6u);
  for (int row = 0; row < 6; ++row) EXPECT_EQ(biaxial.rows[row], std::vector<int>{3 + row});
  EXPECT_EQ(name_of_line(biaxial.lattice, 3), "transverse rib 1");
  EXPECT_EQ(name_of_line(biaxial.lattice, 2), "longitudinal rib 3");

  const GeogridSheet uniaxial = laid(test_products::of(test_products::uniaxial(), 2, 8));
  EXPECT_EQ(uniaxial.along.size(), 9u);
  EXPECT_EQ(uniaxial.rows.size(), 3u);
  EXPECT_EQ(uniaxial.thickness, 0.0027);          // of a bar
  EXPECT_EQ(uniaxial.clamped.size(), 2u * 8 + 1); // two elements of a bar between two ribs

  // Of triangles the transverse family alone: diagonal ribs count as running along.
  const GeogridSheet triaxial = laid(test_products::of(test_products::triaxial(), 9, 4));
  ASSERT_EQ(triaxial.rows.size(), 10u);
  for (std::size_t row = 0; row < triaxial.rows.size(); ++row) {
    ASSERT_EQ(triaxial.rows[row].size(), 1u);
    const fem::RibLine& line = triaxial.lattice.line(triaxial.rows[row][0]);
    for (const Vector3& x : line.points) EXPECT_NEAR(x.x(), -0.00565 + 0.04 * row, 1e-12);
    EXPECT_EQ(name_of_line(triaxial.lattice, triaxial.rows[row][0]),
              "transverse rib " + std::to_string(row + 1));
  }
  EXPECT_EQ(name_of_line(triaxial.lattice, triaxial.along[0]).find("diagonal rib "), 0u);
  EXPECT_EQ(triaxial.clamped.size(), 4u * 4 + 1);
}

// Four sides of 46.188 mm are 184.752 mm; cut at 198 mm, rows with five junctions have a tail of
// 6.624 mm on either side, those with four one of 6.624 mm and half a side. Of a diagonal rib the
// tail is 1/sin(30 deg) = 2 times as long as it reaches across; it leaves each of the junctions at
// the rim but the first row's forwards and the last one's backwards, and where no whole rib of its
// line lies inside: at the last row that falls and at the first one that rises.
TEST(GeogridSheet, GoesOnToItsCut)
{
  GeogridParameters p = test_products::of(test_products::triaxial(), 8, 4);
  const double whole = length_of_ribs(laid(p).lattice);
  p.cut_width = 0.198;
  const GeogridSheet sheet = laid(p);
  const double side = 0.08 / std::sqrt(3.), gap = 0.099 - 2 * side;
  // Nine rows: five with five junctions, four with four. Rim junctions of the five: forwards and
  // backwards diagonals at three of them on both sides, one each at the first and the last row,
  // which is left out since its line has no whole rib.
  const double transverse = 2 * (5 * gap + 4 * (gap + 0.5 * side));
  const double diagonal = 2 * (3 * 2) * 2 * gap;
  EXPECT_NEAR(length_of_ribs(sheet.lattice) - whole, transverse + diagonal, 1e-9);
  double reach = 0;
  for (int n = 0; n < sheet.lattice.n_nodes(); ++n)
    reach = std::max(reach, std::abs(sheet.lattice.reference_position(n).y() - 0.1));
  EXPECT_NEAR(reach, 0.099, 1e-12);
  check_sheet_fits(sheet, box);

  // Transverse ribs of a biaxial sheet; the clamp holds the whole front rib.
  GeogridParameters b = test_products::of(test_products::biaxial(), 3, 2);
  const GeogridSheet uncut = laid(b);
  b.cut_width = 0.17;
  const GeogridSheet cut = laid(b);
  EXPECT_NEAR(length_of_ribs(cut.lattice) - length_of_ribs(uncut.lattice), 4 * 0.04, 1e-12);
  EXPECT_EQ(cut.clamped.size(), uncut.clamped.size() + 2); // one element of 20 mm each
  EXPECT_EQ(cut.rows, uncut.rows);
}

TEST(GeogridSheet, MustLieInTheBox)
{
  const GeogridSheet sheet = laid(test_products::of(test_products::biaxial(), 5, 2));
  EXPECT_THROW(check_sheet_fits(sheet, {0.4, 0.133, 0.3, 0.02}), InputError);
  EXPECT_THROW(check_sheet_fits(sheet, {0.3, 0.2, 0.3, 0.02}), InputError);
}

// A ball above a junction touches it at half the junction's thickness, beside it at half the rib's;
// and where the thick zone ends, its flat face bears on a ball that comes along the rib.
TEST(GeogridSheet, JunctionsAreThickForStones)
{
  ProductParameters product = test_products::biaxial();
  product.junction_thickness = 0.007;
  product.junction_reach = 0.005;
  const GeogridParameters p = test_products::of(product, 3, 2);
  const GeogridSheet sheet = laid(p);
  EXPECT_EQ(sheet.thickness, 0.007);
  const double rounding = 5e-4, radius = 0.0015, plane = 0.15, y = 0.1;
  const double junction = front_of_geogrid(p, box).x() + 0.065, inward = 1e-5;
  const auto at = [&](double x, double z) {
    return overlap(sheet, rounding, {junction + x, y, plane + z}, radius);
  };
  EXPECT_NEAR(at(0, 0.0035 + radius - inward), inward, 1e-12);
  EXPECT_NEAR(at(0.0325, 0.00085 + radius - inward), inward, 1e-12);
  // The face lies at the reach; ribs are rounded, so that the solid ends there by its rounding
  // more.
  EXPECT_NEAR(at(0.005 + rounding + radius - inward, 0.0029), inward, 1e-12);
}

TEST_F(DrawnSheet, ComesToTheClampAndTheMiddle)
{
  GeogridParameters p = test_products::of(test_products::biaxial(), 1, 1);
  p.lattice_file = drawing().string();
  p.lattice_length_unit = 1e-3;
  const GeogridSheet sheet = laid(p);
  EXPECT_EQ(sheet.rows.size(), 3u);
  EXPECT_EQ(sheet.along.size(), 2u);
  EXPECT_NEAR(sheet.room_behind, 0.046, 1e-12);
  ASSERT_EQ(sheet.clamped.size(), 2u);
  for (const int node : sheet.clamped) {
    const Vector3 x = sheet.lattice.reference_position(node);
    EXPECT_NEAR(x.x(), -0.007, 1e-12); // overhang and half a rib
    EXPECT_NEAR(std::abs(x.y() - 0.1), 0.04, 1e-12);
    EXPECT_NEAR(x.z(), 0.15, 1e-12);
  }
  for (const std::vector<int>& row : sheet.rows)
    EXPECT_EQ(sheet.lattice.line(row[0]).shape.thickness, 0.0015);
  EXPECT_EQ(sheet.lattice.line(sheet.along[0]).shape.thickness, 0.0017);
}

TEST_F(DrawnSheet, IsHeldAtTheGroupClamp)
{
  GeogridParameters p = test_products::of(test_products::biaxial(), 1, 1);
  p.lattice_file = drawing("8 15 2 3 6 1\n").string();
  p.lattice_length_unit = 1e-3;
  const GeogridSheet sheet = laid(p);
  ASSERT_EQ(sheet.clamped.size(), 1u);
  EXPECT_NEAR(sheet.lattice.reference_position(sheet.clamped[0]).y(), 0.06, 1e-12);
}

TEST_F(DrawnSheet, MustBePlane)
{
  GeogridParameters p = test_products::of(test_products::biaxial(), 1, 1);
  p.lattice_file = drawing("", 5).string();
  p.lattice_length_unit = 1e-3;
  EXPECT_THROW(laid(p), InputError);
}
