#include "boxbeam/mechanism/common/friction.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// The contact forces at the two ends of a guide.
struct GuideEnds {
  Eigen::Vector3d one, other;
};

GuideEnds ends_of_guide(const Friction& law, const GuideLoad& load) {
  const Eigen::Vector3d half = 0.5 * load.head<3>();
  if (law.guide == 0.0) return {half, half};
  const Eigen::Vector3d pair = load.tail<3>() / law.guide;
  return {half + pair, half - pair};
}

/// How the pressure changes with a change of the load.
double pressure_change(const Friction& law, const GuideLoad& load, const GuideLoad& change) {
  const GuideEnds at = ends_of_guide(law, load), by = ends_of_guide(law, change);
  const auto along = [](const Eigen::Vector3d& of, const Eigen::Vector3d& changed) {
    const double size = of.norm();
    return size > 0.0 ? of.dot(changed) / size : 0.0;
  };
  return along(at.one, by.one) + along(at.other, by.other);
}

/// Of the pressure, with its sign against the sliding.
double coulomb_share(const Friction& law, double v, Slip slip) {
  if (law.creep == 0.0) return -law.coulomb * static_cast<double>(slip);
  return -law.coulomb * v / std::hypot(v, law.creep);
}

}  // namespace

double pressure_of(const Friction& law, const GuideLoad& load) {
  const GuideEnds ends = ends_of_guide(law, load);
  return ends.one.norm() + ends.other.norm();
}

FrictionResponse::FrictionResponse(std::size_t contacts) {
  const auto count = static_cast<Eigen::Index>(contacts);
  velocity.setZero(count);
  load_0.setZero(6 * count);
  load.setZero(6 * count, count);
  rate_0.setZero(count);
  rate.setZero(count, count);
}

std::optional<Eigen::VectorXd> solve_friction(const std::vector<Friction>& laws,
                                              const std::vector<Slip>& slips,
                                              const FrictionResponse& response) {
  constexpr int most = 50;
  const auto count = static_cast<Eigen::Index>(laws.size());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd load = response.load_0;
  Eigen::MatrixXd slope(count, count);
  Eigen::VectorXd gap(count);
  for (int iteration = 0; iteration < most; ++iteration) {
    double largest = 0.0;
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto contact = static_cast<std::size_t>(j);
      const Friction& law = laws[contact];
      const double v = response.velocity[j];
      const Slip slip = slips.empty() ? slip_of(v) : slips[contact];
      if (!slips.empty() && can_stick(law) && slip == Slip::none) {
        const double own = response.rate(j, j);
        if (!(own > 0.0)) return {};  // no force moves it
        gap[j] = (response.rate_0[j] + response.rate.row(j).dot(force)) / own;
        slope.row(j) = response.rate.row(j) / own;
      } else {
        const GuideLoad at = load.segment<6>(6 * j);
        const double share = coulomb_share(law, v, slip);
        gap[j] = force[j] - share * pressure_of(law, at) + law.viscous * v;
        for (Eigen::Index k = 0; k < count; ++k) {
          const GuideLoad by = response.load.col(k).segment<6>(6 * j);
          slope(j, k) = (j == k ? 1.0 : 0.0) - share * pressure_change(law, at, by);
        }
      }
      largest = std::max(largest, std::abs(force[j]) + std::abs(gap[j]));
    }
    if (gap.lpNorm<Eigen::Infinity>() <= 1e-13 * largest) return force;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(slope);
    // Without friction the determinant is 1, of contacts that stick that of how they move each
    // other; where it reaches zero, friction holds any force.
    if (!(lu.determinant() > 1e-9)) return {};
    force -= lu.solve(gap);
    load = response.load_0 + response.load * force;
  }
  return {};
}

void say_locked(const std::vector<std::string>& joints, double time) {
  std::string names;
  for (const std::string& joint : joints) names += (names.empty() ? "joint " : ", joint ") + joint;
  throw AnalysisError(
      {"friction locks the mechanism: the pressure it causes asks for more friction than the "
       "driver can overcome; lower the friction coefficient or guide the slider otherwise",
       names, time});
}

double fitted_creep(const Friction& law, double v_max, double waves) {
  constexpr double share = 0.02, most_instants = 24576.0, instants_to_resolve = 20.0;
  constexpr double stands = 1e-9;  // [m/s]: round-off of what does not move
  if (v_max < stands) return law.creep;
  return std::min(law.creep, std::max(share, instants_to_resolve * waves / most_instants) * v_max);
}

}  // namespace boxbeam
