#include "fem/layouts/cut_sheet.h"

#include "fem/ribs/number_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
using Eigen::Vector3d;

struct Span {
  double low = 1e300, high = -1e300;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

// Points that follow `end` on the way from `before` to the cut; none where the rib runs along x or
// away from the cut, or leaves the sheet before.
std::vector<Vector3d> tail(const Vector3d& before, const Vector3d& end, const SheetCut& cut,
                           const Span& sheet, double width)
{
  const Vector3d way = end - before;
  const double side = end.y() > cut.middle ? 1 : -1;
  const double rate = side * way.y() / way.norm(); // towards the cut
  if (!(rate > 1e-6)) return {};
  const double length = (0.5 * cut.width - side * (end.y() - cut.middle)) / rate;
  const Vector3d tip = end + length / way.norm() * way;
  const double room = 1e-6 * way.norm();
  if (length < 0.5 * width || tip.x() < sheet.low - room || tip.x() > sheet.high + room) return {};
  const int n = std::max(1, static_cast<int>(std::lround(length / way.norm())));
  std::vector<Vector3d> points;
  for (int i = 1; i <= n; ++i)
    points.emplace_back(end + (static_cast<double>(i) / n) * (tip - end));
  return points;
}

void require_inside(const RibLine& line, const SheetCut& cut)
{
  for (const Vector3d& x : line.points)
    if (std::abs(x.y() - cut.middle) > 0.5 * cut.width * (1 + 1e-9))
      throw std::invalid_argument("A sheet is to be cut at a width of " + number_text(cut.width) +
                                  " m, but a junction lies " +
                                  number_text(std::abs(x.y() - cut.middle)) +
                                  " m beside its middle.");
}
} // namespace

std::vector<RibLine> run_to_cut(std::vector<RibLine> lines, const SheetCut& cut)
{
  Span sheet;
  for (const RibLine& line : lines) {
    require_inside(line, cut);
    for (const Vector3d& x : line.points) sheet.add(x.x());
  }
  for (RibLine& line : lines) {
    std::vector<Vector3d>& x = line.points;
    const std::size_t n = x.size();
    const auto behind = tail(x[n - 2], x[n - 1], cut, sheet, line.shape.width);
    const auto before = tail(x[1], x[0], cut, sheet, line.shape.width);
    x.insert(x.end(), behind.begin(), behind.end());
    x.insert(x.begin(), before.rbegin(), before.rend());
  }
  return lines;
}
} // namespace interlock::fem
