#include "robot_text.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "boxbeam/project/limits.hpp"

namespace boxbeam::robots {
namespace {

/// A number that a case takes: what it would refuse as too small to be meant is none.
double meant(double value, const WantedDimension& of) {
  return std::abs(value) < limits::range_of(of).smallest ? 0.0 : value;
}

}  // namespace

std::string quantity(double value, const WantedDimension& of, const char* unit) {
  return fmt::format("\"{} {}\"", meant(value, of), unit);
}

std::string place_text(const Eigen::Vector3d& p) {
  std::array<std::string, 3> parts;
  for (int k = 0; k < 3; ++k)
    parts[static_cast<std::size_t>(k)] = quantity(p[k], wanted::length, "m");
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::string inertia_text(const Eigen::Matrix3d& I) {
  const auto row = [](const Eigen::Vector3d& of) {
    std::array<std::string, 3> parts;
    for (int k = 0; k < 3; ++k)
      parts[static_cast<std::size_t>(k)] = quantity(of[k], wanted::inertia, "kg m^2");
    return fmt::format("[{}]", fmt::join(parts, ", "));
  };
  const auto is_none = [](double value) { return meant(value, wanted::inertia) == 0.0; };
  if (is_none(I(0, 1)) && is_none(I(0, 2)) && is_none(I(1, 2))) return row(I.diagonal());
  return fmt::format("[{}, {}, {}]", row(I.row(0)), row(I.row(1)), row(I.row(2)));
}

std::string direction_text(const Eigen::Vector3d& given) {
  const Eigen::Vector3d direction = given.normalized();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(direction[k]) < 1.0 || direction.cwiseAbs().sum() > 1.0) continue;
    return fmt::format("\"{}{}\"", direction[k] < 0.0 ? "-" : "", "xyz"[k]);
  }
  return fmt::format("[{}, {}, {}]", direction.x() + 0.0, direction.y() + 0.0, direction.z() + 0.0);
}

std::string turn_text(const std::vector<Turn>& given) {
  std::string turns;
  for (const Turn& turn : given) {
    if (meant(turn.angle, wanted::angle) == 0.0) continue;
    turns += fmt::format("{}[{}, {}]", turns.empty() ? "" : ", ", direction_text(turn.axis),
                         quantity(turn.angle, wanted::angle, "rad"));
  }
  return turns.empty() ? "" : fmt::format("turn = [{}]\n", turns);
}

InertiaDoubt doubt_of(const Inertial& of) {
  if (of.inertia.isZero(0.0)) {
    return {of.mass > 0.0 ? "no inertia about its centre: a point mass" : "", false};
  }
  if (of.mass == 0.0) return {"a body without mass has no inertia", true};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(of.inertia);
  const Eigen::Vector3d& moments = principal.eigenvalues();
  const double slack = 1e-9 * moments.cwiseAbs().maxCoeff();
  const std::string are = fmt::format("principal moments {:.4g}, {:.4g} and {:.4g} kg m^2",
                                      moments[0], moments[1], moments[2]);
  if (moments[0] < -slack) return {are + ": one is below zero", true};
  if (moments[2] > moments[0] + moments[1] + slack)
    return {are + ": one is above the sum of the other two", true};
  if (moments[0] <= slack) return {are + ": only of a thin rod one is zero", false};
  return {};
}

}  // namespace boxbeam::robots
