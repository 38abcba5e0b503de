#include "member.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "section_areas.hpp"
#include "section_stress.hpp"

namespace oracle {

using namespace boxbeam;

namespace {

/// Of a beam held so: 1 of two pins at its ends, 2 of a clamp at its start; nothing of others.
std::optional<double> length_factor_of(const Project& project) {
  const std::vector<Restraint>& held = project.restraints;
  const auto all = [](const Restraint& at) { return at.along_y && at.along_z && at.turning; };
  if (!std::all_of(held.begin(), held.end(), all) || held.empty()) return std::nullopt;
  if (held.front().s.value() != 0.0) return std::nullopt;
  if (held.size() == 1 && held.front().clamped) return 2.0;
  const bool pins = held.size() == 2 && !held[0].clamped && !held[1].clamped;
  if (pins && held[1].s == project.beam.length()) return 1.0;
  return std::nullopt;
}

/// About one axis, of forces and strengths of design.
struct Axis {
  double slenderness, n;  ///< N/(chi A f_y/gamma_M1)
  double m;               ///< M/(W f_y/gamma_M1)
  bool slender;           ///< whether N counts beside the critical force

  /// Table B.1, class 3.
  double bent(double C_m) const {
    return C_m * std::min(1.0 + 0.6 * slenderness * n, 1.0 + 0.6 * n) * m;
  }
};

struct Strut {
  double A, f_y, alpha, length;

  Axis axis(double I, double half, double N, double M, double gamma_M1) const {
    const double critical = std::numbers::pi * std::numbers::pi * 210e9 * I / (length * length);
    const double slenderness = std::sqrt(A * f_y / critical);
    const double phi = 0.5 * (1.0 + alpha * (slenderness - 0.2) + slenderness * slenderness);
    const double chi =
        std::min(1.0, 1.0 / (phi + std::sqrt(phi * phi - slenderness * slenderness)));
    return {slenderness, N * gamma_M1 / (chi * A * f_y), M * half * gamma_M1 / (I * f_y),
            N > 0.05 * critical};
  }
};

}  // namespace

void look_at_member(const Project& project, const std::vector<Run>& sampled, const Rules& rules,
                    Findings& found) {
  const std::vector<Segment>& segments = project.beam.segments;
  const auto factor = length_factor_of(project);
  if (!factor || !std::holds_alternative<recorded::Loads>(project.mechanism)) return;
  if (segments.size() != 1 || !(segments[0].from == segments[0].to)) return;
  const auto box = box_of(segments[0].from.outer);
  if (!box || segments[0].from.inner || !box->stiffeners.empty()) return;
  const BoxSizes s(*box);
  if (s.top != s.bottom || s.left != s.right) return;
  const bool welded = std::holds_alternative<Box>(segments[0].from.outer);
  const Plane plane = plane_of({segments[0].from, {}, {}, false, 1.0, 1.0}, false, false);
  const double strongest = std::max(rules.yield_strength(0, PlateKind::top_flange, s.top),
                                    rules.yield_strength(0, PlateKind::left_web, s.left));
  const Strut strut{1.0 / plane.of[0][0], strongest, welded ? 0.34 : 0.21,
                    *factor * project.beam.length().value()};
  const StrengthDemand& wanted = project.strength;
  constexpr int places = 40;
  for (const Run& run : sampled) {
    const double design = run.load_factor * wanted.required;
    for (const CutForceDiagram& diagram : run.diagrams) {
      double N = std::numeric_limits<double>::infinity(), M_y = 0.0, M_z = 0.0;
      for (int i = 0; i <= places; ++i) {
        const Side side = i == 0 ? Side::behind : Side::before;
        const CutForces cut = diagram.at({project.beam.length() * (1.0 * i / places), side});
        N = std::min(N, -design * cut.N.value());
        M_y = std::max(M_y, design * std::abs(cut.M_y.value()));
        M_z = std::max(M_z, design * std::abs(cut.M_z.value()));
      }
      if (N <= 0.0) continue;
      const Axis y = strut.axis(1.0 / plane.of[1][2], 0.5 * s.H, N, M_y, wanted.gamma_M1);
      const Axis z = strut.axis(-1.0 / plane.of[2][1], 0.5 * s.W, N, M_z, wanted.gamma_M1);
      const double about_y = y.bent(wanted.C_my), about_z = z.bent(wanted.C_mz);
      if (y.slender) found.note(Criterion::member, y.n + about_y + about_z, {}, "6.61");
      if (z.slender) found.note(Criterion::member, z.n + 0.8 * about_y + about_z, {}, "6.62");
    }
  }
}

}  // namespace oracle
