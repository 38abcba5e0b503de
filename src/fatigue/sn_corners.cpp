#include "boxbeam/fatigue/sn_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sn_formulas.hpp"

namespace boxbeam {
namespace {

/// The corner from which the branch of some cycles comes.
const SnCorner& corner_before(const std::vector<SnCorner>& corners, double cycles) {
  const auto behind = std::find_if(corners.begin(), corners.end(),
                                   [&](const SnCorner& at) { return at.cycles >= cycles; });
  return behind == corners.begin() ? corners.front() : *std::prev(behind);
}

/// The slope of the branch of some cycles.
double slope_at(const SnCurve& curve, double cycles) {
  for (const SnBranch& branch : curve.branches) {
    if (cycles <= branch.until) return branch.slope;
  }
  return curve.branches.back().slope;
}

Traced cycles_of(double cycles) { return Derivation::literal(cycles, ValueKind::cycles); }

Traced strength_of(const SnCorner& corner) {
  return Derivation::known({corner.symbol, ""}, corner.strength);
}

Traced from_corner(const SnCorner& corner, double slope, double cycles) {
  if (corner.cycles == cycles) return strength_of(corner);
  return sn::strength_from(strength_of(corner), cycles_of(corner.cycles), cycles_of(cycles), slope);
}

}  // namespace

const char* to_text(SnCorner::Kind kind) {
  switch (kind) {
    case SnCorner::Kind::reference: return "reference";
    case SnCorner::Kind::branch_end: return "end of a branch";
    case SnCorner::Kind::constant_amplitude_limit: return "constant-amplitude limit";
    case SnCorner::Kind::cut_off: return "cut-off";
  }
  return "";
}

std::string symbol_of(const SnCurve& curve) {
  return curve.kind == StressKind::direct ? "d_sigma" : "d_tau";
}

std::vector<SnCorner> corners_of(const SnCurve& curve) {
  const std::string prefix = symbol_of(curve);
  std::vector<SnCorner> corners{
      {SnCorner::Kind::reference, prefix + "_C", curve.reference_cycles, curve.reference}};
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
    SnCorner corner{SnCorner::Kind::branch_end, "", end,
                    si<Stress>(line.strength_at(end, Loading::spectrum))};
    if (end == curve.constant_amplitude_limit) {
      corner.kind = SnCorner::Kind::constant_amplitude_limit;
      corner.symbol = prefix + "_D";
    } else if (end == curve.cut_off) {
      corner.kind = SnCorner::Kind::cut_off;
      corner.symbol = prefix + "_L";
    } else {
      corner.symbol = fmt::format("{}_K{}", prefix, ++number);
    }
    corners.push_back(std::move(corner));
  }
  return corners;
}

void derive_corners(Derivation& steps, const SnCurve& curve) {
  const std::vector<SnCorner> corners = corners_of(curve);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const SnCorner& corner = corners[i];
    steps.define({corner.symbol, ""},
                 from_corner(corners[i - 1], slope_at(curve, corner.cycles), corner.cycles));
    steps.note([&] { return fmt::format("{}, {{}} cycles", to_text(corner.kind)); },
               cycles_of(corner.cycles));
  }
}

Traced derive_strength(Derivation& steps, const SnCurve& curve, double cycles, Loading loading) {
  const std::string symbol = symbol_of(curve) + "_R";
  const std::vector<SnCorner> corners = corners_of(curve);
  for (const SnCorner& corner : corners) {
    const bool limit = corner.kind == SnCorner::Kind::constant_amplitude_limit &&
                       loading == Loading::constant_amplitude;
    if ((!limit && corner.kind != SnCorner::Kind::cut_off) || cycles < corner.cycles) continue;
    Traced strength = steps.define({symbol, ""}, strength_of(corner));
    steps.note(
        [&] {
          return fmt::format("at {{}} cycles and beyond, the {}: no smaller range does damage",
                             to_text(corner.kind));
        },
        cycles_of(corner.cycles));
    return strength;
  }
  const double slope = slope_at(curve, cycles);
  Traced strength =
      steps.define({symbol, ""}, from_corner(corner_before(corners, cycles), slope, cycles));
  steps.note([&] { return fmt::format("strength at {{}} cycles, branch m = {:g}", slope); },
             cycles_of(cycles));
  return strength;
}

Traced derive_endurance(Derivation& steps, const SnCurve& curve, Symbol symbol, const Traced& range,
                        double cycles) {
  const std::vector<SnCorner> corners = corners_of(curve);
  const SnCorner& corner = corner_before(corners, cycles);
  return steps.define(symbol,
                      sn::endured_from(strength_of(corner), cycles_of(corner.cycles), range,
                                       slope_at(curve, cycles)),
                      "", {ValueKind::cycles, 4});
}

void derive_equivalent_range(Derivation& steps, const SnCurve& curve, double damage,
                             const Traced& gammas) {
  const Traced C = steps.known({symbol_of(curve), "_C"}, curve.reference);
  const Traced D = steps.known("D", damage, {ValueKind::share});
  constexpr double cycles = 2e6;
  const Traced at_reference = curve.reference_cycles == cycles
                                  ? D
                                  : D * cycles_of(curve.reference_cycles) / cycles_of(cycles);
  steps.define({symbol_of(curve), "_E,2"},
               sn::equivalent_from(C, at_reference, curve.branches.front().slope, gammas),
               "2e6 cycles of this range do as much damage");
}

}  // namespace boxbeam
