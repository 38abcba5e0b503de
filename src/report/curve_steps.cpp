#include "curve_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

/// The strength at some cycles, from the corner before.
Step from_corner(const std::string& symbol, const Corner& corner, double slope, double cycles,
                 double strength) {
  Step step{symbol, {corner.symbol}, {}};
  if (corner.cycles != cycles) {
    const std::string ratio =
        fmt::format("({}/{})^(1/{:g})", text::cycles(corner.cycles), text::cycles(cycles), slope);
    step.formulas = {corner.symbol + " " + ratio, text::MPa(corner.strength) + " x " + ratio};
  }
  step.formulas.push_back(text::MPa(strength));
  return step;
}

std::string size_formula(SizeEffect effect) {
  switch (effect) {
    case SizeEffect::butt: return "(25 mm/t)^0.2";
    case SizeEffect::eccentric_butt:
      return "(25 mm/t_1)^0.2/(1 + (6 e/t_1) t_1^1.5/(t_1^1.5 + t_2^1.5))";
    case SizeEffect::bolt: return "(30 mm/d)^0.25";
    case SizeEffect::none: break;
  }
  return "";
}

}  // namespace

std::string prefix_of(const SnCurve& curve) {
  return curve.kind == StressKind::direct ? "d_sigma" : "d_tau";
}

std::vector<Corner> corners_of(const SnCurve& curve) {
  const std::string prefix = prefix_of(curve);
  std::vector<Corner> corners{{prefix + "_C", curve.reference_cycles, curve.reference.value(),
                               curve.branches.front().slope, ""}};
  std::vector<double> ends;
  for (const SnBranch& branch : curve.branches) {
    if (std::isfinite(branch.until)) ends.push_back(branch.until);
  }
  if (curve.constant_amplitude_limit) ends.push_back(*curve.constant_amplitude_limit);
  if (curve.cut_off) ends.push_back(*curve.cut_off);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const SnLine line(curve);
  int number = 0;
  for (const double end : ends) {
    Corner corner{"", end, line.strength_at(end, Loading::spectrum), 0.0, ""};
    const auto branch =
        std::find_if(curve.branches.begin(), curve.branches.end(),
                     [&](const SnBranch& candidate) { return candidate.until > end; });
    corner.slope = (branch == curve.branches.end() ? curve.branches.back() : *branch).slope;
    if (end == curve.constant_amplitude_limit) {
      corner.symbol = prefix + "_D";
      corner.what = "constant-amplitude limit";
    } else if (end == curve.cut_off) {
      corner.symbol = prefix + "_L";
      corner.what = "cut-off";
    } else {
      corner.symbol = fmt::format("{}_K{}", prefix, ++number);
      corner.what = "end of a branch";
    }
    corners.push_back(corner);
  }
  return corners;
}

Corner corner_before(const std::vector<Corner>& corners, double cycles) {
  const auto behind = std::find_if(corners.begin(), corners.end(),
                                   [&](const Corner& at) { return at.cycles >= cycles; });
  return behind == corners.begin() ? corners.front() : *std::prev(behind);
}

double slope_at(const SnCurve& curve, double cycles) {
  for (const SnBranch& branch : curve.branches) {
    if (cycles <= branch.until) return branch.slope;
  }
  return curve.branches.back().slope;
}

Steps curve_steps(const SnCurve& curve, const BeamDetail* detail) {
  Steps steps;
  const std::string prefix = prefix_of(curve);
  const bool direct = curve.kind == StressKind::direct;
  std::string category =
      fmt::format("{} {} ({} stress): strength at {} cycles", curve.code, curve.name,
                  direct ? "direct" : "shear", text::cycles(curve.reference_cycles));
  Step reference{prefix + "_C", {text::MPa(curve.reference.value())}, {category}};
  if (detail != nullptr) {
    const Detail& of = detail->detail;
    if (!of.row.empty()) reference.notes.push_back(fmt::format("row {}: {}", of.row, of.name));
    if (!detail->assumed.empty()) reference.notes.push_back("ASSUMED: " + detail->assumed);
    if (of.size_factor != 1.0) {
      const std::string k_s = text::significant(of.size_factor);
      Step size{"k_s", {}, {"size effect, 7.2.2"}};
      const std::string formula = size_formula(of.size_effect);
      if (!formula.empty()) size.formulas.push_back(formula);
      size.formulas.push_back(k_s);
      steps.push_back(size);
      const std::string full = text::MPa(curve.reference.value() / of.size_factor);
      reference.formulas = {"k_s d_sigma_cat", fmt::format("{} x {}", k_s, full),
                            text::MPa(curve.reference.value())};
    }
  }
  if (curve.unconfirmed) reference.notes.emplace_back("UNCONFIRMED figures");
  steps.push_back(reference);
  const std::vector<Corner> corners = corners_of(curve);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Step step = from_corner(corners[i].symbol, corners[i - 1], slope_at(curve, corners[i].cycles),
                            corners[i].cycles, corners[i].strength);
    step.notes.push_back(
        fmt::format("{}, {} cycles", corners[i].what, text::cycles(corners[i].cycles)));
    steps.push_back(step);
  }
  return steps;
}

Step strength_step(const SnCurve& curve, double cycles, Loading loading) {
  const std::string symbol = prefix_of(curve) + "_R";
  const std::vector<Corner> corners = corners_of(curve);
  const double strength = strength_at(curve, cycles, loading).value();
  for (const Corner& corner : corners) {
    const bool limit =
        corner.what == "constant-amplitude limit" && loading == Loading::constant_amplitude;
    if ((limit || corner.what == "cut-off") && cycles >= corner.cycles) {
      return {symbol,
              {corner.symbol, text::MPa(strength)},
              {fmt::format("at {} cycles and beyond, the {}: no smaller range does damage",
                           text::cycles(corner.cycles), corner.what)}};
    }
  }
  const double slope = slope_at(curve, cycles);
  Step step = from_corner(symbol, corner_before(corners, cycles), slope, cycles, strength);
  step.notes.push_back(
      fmt::format("strength at {} cycles, branch m = {:g}", text::cycles(cycles), slope));
  return step;
}

}  // namespace boxbeam::report
