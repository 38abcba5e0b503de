#include "boxbeam/fatigue/sn_curve.hpp"

#include <fmt/format.h>

#include <cassert>
#include <limits>

#include "sn_formulas.hpp"

namespace boxbeam {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double knee_cycles = 5e6;
constexpr double cut_off_cycles = 1e8;
constexpr const char* edition = "EN 1993-1-9:2005+AC:2009";

}  // namespace

SnLine::SnLine(const SnCurve& curve) {
  assert(!curve.branches.empty());
  double cycles = curve.reference_cycles;
  double strength = curve.reference.value();
  for (const SnBranch& branch : curve.branches) {
    Piece piece{branch.slope, branch.until, 0.0, cycles, strength};
    if (branch.until < infinity) {
      piece.strength = sn::strength_from(strength, cycles, branch.until, branch.slope);
      cycles = branch.until;
      strength = piece.strength;
    }
    pieces_.push_back(piece);
  }
  // The limits are strengths on the spectrum's own line.
  limit_cycles_ = curve.constant_amplitude_limit.value_or(infinity);
  cut_off_cycles_ = curve.cut_off.value_or(infinity);
  const auto on_line = [this](double at) {
    for (const Piece& piece : pieces_) {
      if (at > piece.until) continue;
      return at == piece.until
                 ? piece.strength
                 : sn::strength_from(piece.from_strength, piece.from_cycles, at, piece.slope);
    }
    return pieces_.back().strength;
  };
  if (curve.constant_amplitude_limit) limit_ = on_line(limit_cycles_);
  if (curve.cut_off) cut_off_ = on_line(cut_off_cycles_);
}

double SnLine::strength_at(double cycles, Loading loading) const {
  if (loading == Loading::constant_amplitude && cycles >= limit_cycles_) return limit_;
  if (cycles >= cut_off_cycles_) return cut_off_;
  for (const Piece& piece : pieces_) {
    if (cycles <= piece.until) {
      return sn::strength_from(piece.from_strength, piece.from_cycles, cycles, piece.slope);
    }
  }
  return pieces_.back().strength;
}

double SnLine::cycles_to_failure(double range, Loading loading) const {
  if (loading == Loading::constant_amplitude && limit_ > 0.0 && range < limit_) return infinity;
  if (range < cut_off_ || range <= 0.0) return infinity;
  for (const Piece& piece : pieces_) {
    if (range >= piece.strength) {
      return sn::endured_from(piece.from_strength, piece.from_cycles, range, piece.slope);
    }
  }
  return infinity;
}

Stress strength_at(const SnCurve& curve, double cycles, Loading loading) {
  return si<Stress>(SnLine(curve).strength_at(cycles, loading));
}

double cycles_to_failure(const SnCurve& curve, Stress range, Loading loading) {
  return SnLine(curve).cycles_to_failure(range.value(), loading);
}

Stress knee_of(const SnCurve& curve) { return si<Stress>(SnLine(curve).limit()); }

Stress cut_off_of(const SnCurve& curve) { return si<Stress>(SnLine(curve).cut_off()); }

SnCurve scaled(SnCurve curve, double factor) {
  curve.reference *= factor;
  return curve;
}

SnCurve en_1993_1_9_direct(double category) {
  return {edition,
          fmt::format("{:g}", category),
          StressKind::direct,
          si<Stress>(category * 1e6),
          2e6,
          {{3.0, knee_cycles}, {5.0, cut_off_cycles}},
          knee_cycles,
          cut_off_cycles,
          false,
          "7.1(2), 7.1(3), figure 7.1"};
}

SnCurve en_1993_1_9_shear(double category) {
  return {edition,
          fmt::format("{:g}", category),
          StressKind::shear,
          si<Stress>(category * 1e6),
          2e6,
          {{5.0, cut_off_cycles}},
          {},
          cut_off_cycles,
          false,
          "7.1(2), figure 7.2"};
}

SnCurve published_step(double category) {
  return {"sledge-rig thesis, 4.8.2",
          fmt::format("{:g}", category),
          StressKind::direct,
          si<Stress>(category * 1e6),
          knee_cycles,
          {{3.0, knee_cycles}, {5.0, cut_off_cycles}},
          knee_cycles,
          cut_off_cycles,
          false,
          "the category taken at 5e6 cycles (not EN 1993-1-9)"};
}

}  // namespace boxbeam
