#include "boxbeam/verification/code_comparison.hpp"

#include <fmt/format.h>

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

std::vector<Cycle> cycles_of(const CheckBasis& basis) {
  std::vector<Cycle> cycles;
  for (const SpectrumRow& row : basis.spectrum) cycles.push_back(row.cycle);
  return cycles;
}

CodeResult governing_under(const std::string& code, const Project& project,
                           const std::vector<CheckResult>& checks) {
  CodeResult worst;
  worst.code = code;
  CurveTable curves(code);
  bool found = false;
  for (const CheckResult& result : checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis) continue;
    const double strength = strength_at_reference(result.basis->curves.front());
    const std::optional<SnCurve>& curve = curves.at(strength);
    if (!curve) {
      worst.missing =
          fmt::format("no curve is as low as {:.3g} MPa at 2e6 cycles (s = {} m, {})",
                      strength * 1e-6, to_text(result.check.station), result.check.point);
      return worst;
    }
    const double factor = largest_factor(cycles_of(*result.basis), *curve, project.fatigue.demand);
    if (found && factor >= worst.safety_factor) continue;
    found = true;
    worst.code = curve->code;
    worst.curve = curve->name;
    worst.unconfirmed = curve->unconfirmed;
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
    results.push_back({curve.code, curve.name, curve.unconfirmed, result.check.station,
                       result.check.point, result.check.safety_factor, result.check.required, ""});
    break;
  }
  if (results.empty()) return results;
  for (const std::string& code : project.fatigue.codes) {
    results.push_back(governing_under(code, project, checks));
  }
  return results;
}

}  // namespace boxbeam
