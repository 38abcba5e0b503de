#include "boxbeam/verification/code_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "boxbeam/project/sn_catalogue.hpp"

namespace boxbeam {
namespace {

/// The curves of a code for strengths at 2e6 cycles, each looked up once.
class CurveTable {
 public:
  explicit CurveTable(std::string code) : code_(std::move(code)) {}

  const std::optional<SnCurve>& at(double strength) {
    const auto found = curves_.find(strength);
    if (found != curves_.end()) return found->second;
    return curves_
        .emplace(strength, curve_of_same_strength(code_, StressKind::direct, si<Stress>(strength)))
        .first->second;
  }

 private:
  std::string code_;
  std::map<double, std::optional<SnCurve>> curves_;
};

double strength_at_reference(const SnCurve& curve) {
  constexpr double reference_cycles = 2e6;
  return strength_at(curve, reference_cycles, Loading::spectrum).value();
}

/// The cycles of a check, of which a code that allows less than the whole damage sees more. The
/// smaller sum is for ranges of many sizes: one size is what the curves were measured with.
std::vector<Cycle> cycles_of(const CheckBasis& basis, double damage_limit) {
  std::vector<Cycle> cycles;
  for (const SpectrumRow& row : basis.spectrum) {
    cycles.push_back(row.cycle);
    cycles.back().count /= damage_limit;
  }
  return cycles;
}

bool one_size(const CheckBasis& basis) {
  constexpr double same = 1e-6;
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (const SpectrumRow& row : basis.spectrum) {
    if (row.cycle.count == 0.0) continue;
    low = std::min(low, row.cycle.range.value());
    high = std::max(high, row.cycle.range.value());
  }
  return high - low <= same * high;
}

CodeResult governing_under(const std::string& code, const Project& project,
                           const std::vector<CheckResult>& checks) {
  CodeResult worst;
  worst.code = code;
  CurveTable curves(code);
  bool found = false;
  for (const CheckResult& result : checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis) continue;
    // Of the detail itself: each code has a size effect of its own.
    const BeamDetail* at = result.basis->point.detail;
    const SnCurve& own = at != nullptr ? at->detail.curve : result.basis->curves.front();
    const double strength = strength_at_reference(own);
    const std::optional<SnCurve>& curve = curves.at(strength);
    if (!curve) {
      worst.missing =
          fmt::format("no curve is as low as {:.3g} MPa at 2e6 cycles (s = {} m, {})",
                      strength * 1e-6, to_text(result.check.station), result.check.point);
      return worst;
    }
    const Length thickness = result.basis->point.plate;
    const auto rule = thickness_rule_of(code, *curve, at != nullptr ? at->detail.row : "");
    double size_factor = rule ? factor_of(*rule, thickness) : 1.0;
    if (code.starts_with("EN 1993-1-9") && at != nullptr) size_factor = at->detail.size_factor;
    const double limit = one_size(*result.basis) ? 1.0 : damage_limit_of(code);
    const double factor = largest_factor(cycles_of(*result.basis, limit),
                                         scaled(*curve, size_factor), project.fatigue.demand);
    if (found && factor >= worst.safety_factor) continue;
    found = true;
    worst.thickness = thickness;
    worst.size_factor = size_factor;
    worst.size_rule = rule ? to_text(*rule, thickness) : "";
    worst.damage_limit = limit;
    worst.code = curve->code;
    worst.curve = curve->name;
    worst.unconfirmed = curve->unconfirmed || (rule && rule->unconfirmed && size_factor != 1.0);
    worst.station = result.check.station;
    worst.point = result.check.point;
    worst.safety_factor = factor;
    worst.required = result.check.required;
  }
  return worst;
}

}  // namespace

std::vector<CodeResult> compare_codes(const Project& project,
                                      const std::vector<CheckResult>& checks) {
  std::vector<CodeResult> results;
  if (project.fatigue.codes.empty()) return results;
  for (const CheckResult& result : checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis) continue;
    // The checks stand worst first.
    const SnCurve& curve = result.basis->curves.front();
    CodeResult& own = results.emplace_back();
    own.code = curve.code;
    own.curve = curve.name;
    own.unconfirmed = curve.unconfirmed;
    own.station = result.check.station;
    own.point = result.check.point;
    own.safety_factor = result.check.safety_factor;
    own.required = result.check.required;
    own.thickness = result.basis->point.plate;
    if (result.basis->point.detail != nullptr) {
      own.size_factor = result.basis->point.detail->detail.size_factor;
    }
    break;
  }
  if (results.empty()) return results;
  for (const std::string& code : project.fatigue.codes) {
    results.push_back(governing_under(code, project, checks));
  }
  return results;
}

}  // namespace boxbeam
