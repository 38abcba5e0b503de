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
double coulomb_share(const Friction& law, double v) {
  return -law.coulomb * v / std::hypot(v, law.creep);
}

}  // namespace

double pressure_of(const Friction& law, const GuideLoad& load) {
  const GuideEnds ends = ends_of_guide(law, load);
  return ends.one.norm() + ends.other.norm();
}

double friction_force_of(const Friction& law, const GuideLoad& load, double v) {
  return coulomb_share(law, v) * pressure_of(law, load) - law.viscous * v;
}

std::optional<Eigen::VectorXd> solve_friction(const std::vector<Friction>& laws,
                                              const Eigen::VectorXd& v,
                                              const Eigen::VectorXd& load_0,
                                              const Eigen::MatrixXd& response) {
  constexpr int most = 50;
  const auto count = static_cast<Eigen::Index>(laws.size());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd load = load_0;
  Eigen::MatrixXd slope(count, count);
  Eigen::VectorXd gap(count);
  for (int iteration = 0; iteration < most; ++iteration) {
    double largest = 0.0;
    for (Eigen::Index j = 0; j < count; ++j) {
      const Friction& law = laws[static_cast<std::size_t>(j)];
      const GuideLoad at = load.segment<6>(6 * j);
      const double share = coulomb_share(law, v[j]);
      gap[j] = force[j] - friction_force_of(law, at, v[j]);
      largest = std::max(largest, std::abs(force[j]) + std::abs(gap[j]));
      for (Eigen::Index k = 0; k < count; ++k) {
        const GuideLoad by = response.col(k).segment<6>(6 * j);
        slope(j, k) = (j == k ? 1.0 : 0.0) - share * pressure_change(law, at, by);
      }
    }
    if (gap.lpNorm<Eigen::Infinity>() <= 1e-13 * largest) return force;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(slope);
    // Without friction the determinant is 1; where it reaches zero, friction holds any force.
    if (!(lu.determinant() > 1e-9)) return {};
    force -= lu.solve(gap);
    load = load_0 + response * force;
  }
  return {};
}

void say_locked(const std::vector<std::string>& joints, double time) {
  std::string names;
  for (const std::string& joint : joints) names += (names.empty() ? "joint " : ", joint ") + joint;
  throw AnalysisError(
      {"friction locks the mechanism: the pressure it causes asks for more friction than the "
       "driver can overcome; lower the friction coefficient or guide the slider otherwise",
       names,
       time,
       {},
       {}});
}

double fitted_creep(const Friction& law, double v_max, double waves) {
  constexpr double share = 0.02, most_instants = 24576.0, instants_to_resolve = 20.0;
  constexpr double stands = 1e-9;  // [m/s]: round-off of what does not move
  if (v_max < stands) return law.creep;
  return std::min(law.creep, std::max(share, instants_to_resolve * waves / most_instants) * v_max);
}

}  // namespace boxbeam
