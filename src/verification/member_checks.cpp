#include "boxbeam/verification/member_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace boxbeam {
namespace {

/// Moments across the plane, of the straight beam, grow as a bow does.
double bent_by(const SecondOrderEstimate& estimate) {
  if (!(estimate.bending_across > 0.0)) return estimate.bending;
  const double part = estimate.across ? estimate.across->factored : 0.0;
  return estimate.bending + estimate.bending_across / std::max(1e-6, 1.0 - part);
}

CheckResult check_of(const Project& project, double use, const std::string& point,
                     std::size_t situation, Time when, MemberBasis basis) {
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::member;
  check.on_beam = false;
  check.point = point;
  check.id = fmt::format("member-buckling/{}", basis.turns_over ? "sideways" : point);
  std::replace(check.id.begin(), check.id.end(), ' ', '-');
  check.situation = project.situations[situation].name;
  check.time = when;
  check.acting = use;
  check.resisting = 1.0;
  check.safety_factor = 1.0 / use;
  check.required = project.strength.required;
  check.source = basis.turns_over ? "EN 1993-1-1:2005, 6.3.4, curve d"
                                  : "EN 1993-1-1:2005, 6.3.1 and 6.3.4, curve c";
  result.member = std::move(basis);
  return result;
}

}  // namespace

std::vector<CheckResult> check_member(const Project& project, const SecondOrderEstimate& estimate) {
  std::vector<CheckResult> checks;
  const double gamma_M1 = project.strength.gamma_M1;
  MemberLoad load{estimate.compressed, bent_by(estimate), 0.0};
  const auto bends = [&](const BucklingLoad& of, const char* plane) {
    if (of.part <= no_buckling_below || of.part >= 1.0) return;
    load.critical = of.factored;
    const double use = flexural_use(load, BucklingCurve::c, gamma_M1);
    checks.push_back(check_of(project, use, plane, of.situation, of.when, {false, of.held, load}));
  };
  bends(estimate.in_plane, project.in_space ? "along z" : "in the plane of motion");
  if (estimate.across)
    bends(*estimate.across, project.in_space ? "along y" : "across the plane of motion");
  if (const auto& of = estimate.lateral; of && of->part > no_turning_over_below && of->part < 1.0) {
    load.critical = of->part + (estimate.across ? estimate.across->factored : 0.0);
    const double use = lateral_use(load, BucklingCurve::d, gamma_M1);
    checks.push_back(check_of(project, use, "sideways and turning over", of->situation, of->when,
                              {true, of->held, load}));
  }
  return checks;
}

}  // namespace boxbeam
