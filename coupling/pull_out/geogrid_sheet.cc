#include "coupling/pull_out/geogrid_sheet.h"

#include "coupling/parameters/geogrid_product.h"
#include "dem/input_error.h"
#include "fem/layouts/cut_sheet.h"
#include "fem/layouts/junction_zones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

Eigen::AlignedBox3d box_of(const std::vector<fem::RibLine>& lines)
{
  Eigen::AlignedBox3d box;
  for (const fem::RibLine& line : lines)
    for (const Vector3& x : line.points) box.extend(x);
  return box;
}

// So that its first x and its middle across come to the front, and its plane to its height.
void move_to_front(fem::GmshLattice& drawn, const Vector3& front, const std::string& name)
{
  const Eigen::AlignedBox3d box = box_of(drawn.lines);
  const Vector3 size = box.sizes();
  if (size.z() > 1e-6 * size.norm())
    throw InputError(fmt::format("The lattice file \"{}\" is {:.4g} m high, but a geogrid that is "
                                 "laid into the box must be plane, with the same z everywhere.",
                                 name, size.z()));
  const Vector3 way = front - Vector3(box.min().x(), box.center().y(), box.center().z());
  for (fem::RibLine& line : drawn.lines)
    for (Vector3& x : line.points) x += way;
  for (auto& [group, points] : drawn.points)
    for (Vector3& x : points) x += way;
}

// Nodes of the group "clamp" of a drawing, if it has one.
std::vector<int> clamped_nodes(const fem::GmshLattice& drawn, const fem::Lattice& lattice)
{
  if (drawn.points.count("clamp") > 0) return fem::node_sets(drawn, lattice).at("clamp");
  return lattice.front_edge_nodes();
}

// Rows of lines that run across, by their place along x; lines of a drawing may end at junctions.
void find_rows(GeogridSheet& sheet)
{
  struct Row {
    double x, half_width; // [m]
    std::vector<int> lines;
  };
  std::vector<Row> rows;
  for (int l = 0; l < sheet.lattice.n_lines(); ++l) {
    const fem::RibLine& line = sheet.lattice.line(l);
    const Vector3 way = line.points.back() - line.points.front();
    if (std::abs(way.y()) <= std::abs(way.x())) {
      sheet.along.push_back(l);
      continue;
    }
    const double half_width = 0.5 * fem::shape_of_element(line, 0).width;
    const double x = 0.5 * (line.points.front() + line.points.back()).x();
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return std::abs(row.x - x) < std::max(1e-6, half_width);
    });
    if (same != rows.end())
      same->lines.push_back(l);
    else
      rows.push_back({x, half_width, {l}});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.x < b.x; });
  for (const Row& row : rows) sheet.rows.push_back(row.lines);
  sheet.room_behind = rows.size() < 2
                          ? std::numeric_limits<double>::infinity()
                          : rows[1].x - rows[0].x - rows[0].half_width - rows[1].half_width;
}

void require_rigid_junctions(const GeogridParameters& p)
{
  if (p.product && p.product->junction_stiffness > 0)
    throw InputError(fmt::format(
        "\"Product/Junction stiffness\" is {:g} N m/rad, but the geogrid of a pull-out has rigid "
        "junctions only: set it to 0.",
        p.product->junction_stiffness));
}

GeogridSheet sheet_of(const GeogridParameters& p, const Vector3& front)
{
  const fem::GeogridProduct product = geogrid_product(p);
  fem::GmshLattice drawn;
  if (p.lattice_file.empty())
    drawn.lines = fem::lines_of_piece(product, p.apertures_along, p.apertures_across, front);
  else {
    drawn = drawn_lattice(p.lattice_file, p.lattice_length_unit, product);
    move_to_front(drawn, front, p.lattice_file);
  }
  std::vector<fem::RibLine> lines = drawn.lines;
  if (p.cut_width > 0) lines = fem::run_to_cut(std::move(lines), {front.y(), p.cut_width});
  if (product.junctions.reach > 0) lines = fem::thicken_junctions(lines, product.junctions);
  fem::Lattice lattice(std::move(lines));
  std::vector<int> clamped = clamped_nodes(drawn, lattice);
  GeogridSheet sheet{std::move(lattice), std::move(clamped), {}, {}};
  for (int e = 0; e < sheet.lattice.n_elements(); ++e)
    sheet.thickness = std::max(sheet.thickness, sheet.lattice.shape(e).thickness);
  find_rows(sheet);
  return sheet;
}
} // namespace

Vector3 front_of_geogrid(const GeogridParameters& p, const BoxParameters& box)
{
  const double width = p.product ? p.product->across.width : p.rib_width;
  return {-p.overhang - 0.5 * width, 0.5 * box.width, 0.5 * box.height};
}

GeogridSheet lay_geogrid(const GeogridParameters& parameters, const Vector3& front)
{
  try {
    require_rigid_junctions(parameters);
    return sheet_of(parameters, front);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(error.what());
  }
}

void check_sheet_fits(const GeogridSheet& sheet, const BoxParameters& box)
{
  constexpr double rounding = 1e-9; // of decimal lengths [m]
  const fem::Lattice& lattice = sheet.lattice;
  std::vector<int> ends(lattice.n_nodes(), 0);
  for (int e = 0; e < lattice.n_elements(); ++e)
    for (const int node : lattice.element(e).node) ++ends[node];
  double beside = 0, behind = 0; // reach from the middle, and beyond the rear wall [m]
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double half_width = 0.5 * lattice.shape(e).width;
    const Vector3 across = half_width * (lattice.element(e).frame * Vector3::UnitY()).cwiseAbs();
    for (const int node : lattice.element(e).node) {
      const Vector3& x = lattice.reference_position(node);
      const double edge = ends[node] == 1 && across.x() > rounding ? 0 : across.y();
      beside = std::max(beside, std::abs(x.y() - 0.5 * box.width) + edge);
      behind = std::max(behind, x.x() + across.x() - box.length);
    }
  }
  if (2 * beside > box.width + rounding)
    throw InputError(fmt::format("The geogrid (Geogrid/Product, Cut width or Lattice file) is "
                                 "{:.6g} m wide, ribs included, but the box is only {:g} m wide.",
                                 2 * beside, box.width));
  if (behind > rounding)
    throw InputError(fmt::format("The geogrid (Geogrid/Product or Lattice file) reaches {:.4g} m "
                                 "beyond the rear wall of the box, "
                                 "which is {:g} m long.",
                                 behind, box.length));
}
} // namespace interlock::coupling
