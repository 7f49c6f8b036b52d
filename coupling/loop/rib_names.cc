#include "coupling/loop/rib_names.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace interlock::coupling
{
namespace
{
enum class Kind { transverse, longitudinal, diagonal };

Kind kind_of(const fem::RibLine& line)
{
  const Eigen::Vector3d way = line.points.back() - line.points.front();
  if (std::abs(way.y()) > std::abs(way.x())) return Kind::transverse;
  return std::abs(way.y()) < 0.05 * std::abs(way.x()) ? Kind::longitudinal : Kind::diagonal;
}
} // namespace

std::string name_of_line(const fem::Lattice& lattice, int line)
{
  const Kind kind = kind_of(lattice.line(line));
  const auto place = [&](int l) {
    const Eigen::Vector3d& x = lattice.line(l).points.front();
    return kind == Kind::transverse ? std::pair(x.x(), x.y()) : std::pair(x.y(), x.x());
  };
  int number = 1;
  for (int l = 0; l < lattice.n_lines(); ++l)
    number += kind_of(lattice.line(l)) == kind && place(l) < place(line);
  return fmt::format("{} rib {}",
                     kind == Kind::transverse     ? "transverse"
                     : kind == Kind::longitudinal ? "longitudinal"
                                                  : "diagonal",
                     number);
}
} // namespace interlock::coupling
