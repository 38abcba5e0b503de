#include "boxbeam/verification/deflection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/peak_over_time.hpp"
#include "second_order_growth.hpp"

namespace boxbeam {
namespace {

constexpr int pieces_per_segment = 16;
constexpr std::size_t nodes = FlexibilityPiece::nodes;
/// Gauss-Legendre nodes and weights on [-1, 1].
constexpr std::array<std::array<double, 2>, nodes> gauss{
    {{-0.9061798459386640, 0.2369268850561891},
     {-0.5384693101056831, 0.4786286704993665},
     {0.0, 0.5688888888888889},
     {0.5384693101056831, 0.4786286704993665},
     {0.9061798459386640, 0.2369268850561891}}};

/// Bends and shears of a piece at any place of it, by the polynomial through its nodes.
struct Flexibility {
  double curvature_N = 0.0, curvature_M = 0.0, shear = 0.0;
};

Flexibility flexibility_at(const FlexibilityPiece& piece, double s) {
  const double u = 2.0 * (s - piece.start.value()) / piece.length.value() - 1.0;
  Flexibility at;
  for (std::size_t i = 0; i < nodes; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < nodes; ++j) {
      if (j != i) weight *= (u - gauss[j][0]) / (gauss[i][0] - gauss[j][0]);
    }
    at.curvature_N += weight * piece.curvature_N[i];
    at.curvature_M += weight * piece.curvature_M[i];
    at.shear += weight * piece.shear[i];
  }
  return at;
}

/// Integrates the bent axis along the beam, from no deflection and no turn at its start.
class Integration {
 public:
  Integration(const DeflectionModel& model, const CutForceDiagram& diagram, const BeamShift& shift)
      : model_(&model), diagram_(&diagram), shift_(shift) {}

  void run() {
    for (const FlexibilityPiece& piece : model_->pieces) {
      const std::vector<double> borders = borders_in(piece);
      for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        add(piece, borders[i], borders[i + 1]);
      }
    }
  }

  /// The places of a line less those of another one, w_0 + slope (s - a).
  DeflectedLine measured() const {
    double a = 0.0, w_0 = 0.0, slope = 0.0;
    if (const auto* chord = std::get_if<Chord>(&model_->against)) {
      a = chord->from.value();
      w_0 = line_.at(chord->from).value();
      slope = (line_.at(chord->to).value() - w_0) / (chord->to - chord->from).value();
    } else if (const auto* tangent = std::get_if<Tangent>(&model_->against)) {
      a = tangent->at.value();
      w_0 = line_.at(tangent->at).value();
      slope = rotation_at(a);
    } else {  // the start of the line has moved and turned itself
      w_0 = -shift_.w;
      slope = -shift_.slope;
    }
    DeflectedLine line = line_;
    for (DeflectedLine::Stretch& stretch : line.stretches) {
      stretch.w_from -= si<Length>(w_0 + slope * (stretch.from.value() - a));
      stretch.w_to -= si<Length>(w_0 + slope * (stretch.to.value() - a));
      stretch.slope_from -= slope;
      stretch.slope_to -= slope;
    }
    return line;
  }

 private:
  /// The ends of a piece and where, within it, cut forces jump or the line is measured from.
  std::vector<double> borders_in(const FlexibilityPiece& piece) const {
    const double start = piece.start.value(), end = (piece.start + piece.length).value();
    std::vector<double> borders{start, end};
    const auto add = [&](Length at) {
      if (at.value() > start && at.value() < end) borders.push_back(at.value());
    };
    for (const CutForcePiece& cut : diagram_->pieces) add(cut.start);
    if (const auto* chord = std::get_if<Chord>(&model_->against)) {
      add(chord->from);
      add(chord->to);
    } else if (const auto* tangent = std::get_if<Tangent>(&model_->against)) {
      add(tangent->at);
    }
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    return borders;
  }

  void add(const FlexibilityPiece& piece, double from, double to) {
    const double half = 0.5 * (to - from);
    double turn = 0.0, lag = 0.0, sheared = 0.0;  // int kappa, int (to - s) kappa, int gamma
    for (const auto& [u, weight] : gauss) {
      const double s = from + half * (1.0 + u);
      const CutForces cut = diagram_->at({si<Length>(s)});
      const Flexibility of = flexibility_at(piece, s);
      const double kappa =
          of.curvature_N * cut.N.value() + of.curvature_M * cut.M_y.value() + shift_.curvature;
      turn += half * weight * kappa;
      lag += half * weight * (to - s) * kappa;
      sheared += half * weight * of.shear * cut.V_z.value();
    }
    const auto slope_at = [&](double s, Side side, double theta) {
      const CutForces cut = diagram_->at({si<Length>(s), side});
      return theta + flexibility_at(piece, s).shear * cut.V_z.value();
    };
    DeflectedLine::Stretch stretch{si<Length>(from), si<Length>(to), si<Length>(w_), {}, 0.0, 0.0};
    rotations_.push_back(theta_);
    stretch.slope_from = slope_at(from, Side::behind, theta_);
    w_ += theta_ * (to - from) - lag + sheared;
    theta_ -= turn;
    stretch.w_to = si<Length>(w_);
    stretch.slope_to = slope_at(to, Side::before, theta_);
    line_.stretches.push_back(stretch);
  }

  /// The rotation of the section at a place where a stretch begins, or at the end of the beam.
  double rotation_at(double s) const {
    for (std::size_t i = 0; i < rotations_.size(); ++i) {
      if (line_.stretches[i].from.value() >= s) return rotations_[i];
    }
    return theta_;
  }

  const DeflectionModel* model_;
  const CutForceDiagram* diagram_;
  BeamShift shift_;
  double w_ = 0.0, theta_ = 0.0;
  DeflectedLine line_;
  std::vector<double> rotations_;  ///< at the beginnings of the stretches
};

/// w = c[0] + c[1] u + c[2] u^2 + c[3] u^3 over a stretch, u from 0 to 1.
std::array<double, 4> cubic_of(const DeflectedLine::Stretch& stretch) {
  const double h = (stretch.to - stretch.from).value();
  const double rise = (stretch.w_to - stretch.w_from).value();
  const double a = h * stretch.slope_from, b = h * stretch.slope_to;
  return {stretch.w_from.value(), a, 3.0 * rise - 2.0 * a - b, a + b - 2.0 * rise};
}

double value_of(const std::array<double, 4>& c, double u) {
  return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
}

}  // namespace

Length DeflectedLine::at(Length s) const {
  const auto stretch = std::find_if(stretches.begin(), stretches.end() - 1,
                                    [&](const Stretch& of) { return s <= of.to; });
  const double u = (s - stretch->from) / (stretch->to - stretch->from);
  return si<Length>(value_of(cubic_of(*stretch), u));
}

LargestDeflection largest_of(const DeflectedLine& line) {
  LargestDeflection largest;
  for (const DeflectedLine::Stretch& stretch : line.stretches) {
    const std::array<double, 4> c = cubic_of(stretch);
    const auto look = [&](double u) {
      if (!(u >= 0.0 && u <= 1.0)) return;  // a straight stretch has no such place, which is NaN
      const double size = std::abs(value_of(c, u));
      if (size <= largest.size.value()) return;
      largest = {stretch.from + u * (stretch.to - stretch.from), si<Length>(size)};
    };
    look(0.0);
    look(1.0);
    // c_1 + 2 c_2 u + 3 c_3 u^2 = 0, without cancellation.
    const double root = std::sqrt(std::max(0.0, c[2] * c[2] - 3.0 * c[1] * c[3]));
    const double q = -(c[2] + std::copysign(root, c[2]));
    look(q / (3.0 * c[3]));
    look(c[1] / q);
  }
  return largest;
}

DeflectionModel deflection_model_of(const Project& project) {
  const DeflectionInput& input = *project.deflection;
  DeflectionModel model;
  model.against = input.against;
  for (const Segment& segment : project.beam.segments) {
    for (int k = 0; k < pieces_per_segment; ++k) {
      FlexibilityPiece& piece = model.pieces.emplace_back();
      // So that the last piece ends where the segment does.
      const auto border = [&](int i) {
        return i == pieces_per_segment
                   ? segment.end()
                   : segment.start + segment.length * (static_cast<double>(i) / pieces_per_segment);
      };
      piece.start = border(k);
      piece.length = border(k + 1) - piece.start;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Length s = piece.start + 0.5 * (1.0 + gauss[i][0]) * piece.length;
        const Section section = section_at(project.beam, {s});
        const Eigen::RowVector3d curvature =
            normal_stress_plane(sums_of(outline_of(section, {}))).row(2) /
            input.youngs_modulus.value();
        piece.curvature_N[i] = curvature[0];
        piece.curvature_M[i] = curvature[1];
        piece.shear[i] = 1.0 / (input.shear_modulus * shear_areas_of(section).z).value();
      }
    }
  }
  return model;
}

DeflectedLine deflected_line_of(const DeflectionModel& model, const CutForceDiagram& diagram,
                                const BeamShift& shift) {
  Integration integration(model, diagram, shift);
  integration.run();
  return integration.measured();
}

std::string to_text(const MeasuredFrom& against) {
  if (std::holds_alternative<UnloadedAxis>(against)) return "unloaded axis";
  if (const auto* chord = std::get_if<Chord>(&against)) {
    return fmt::format("chord {} to {} m", to_text(Station{chord->from}),
                       to_text(Station{chord->to}));
  }
  return fmt::format("tangent at {} m", to_text(Station{std::get<Tangent>(against).at}));
}

namespace {

/// What second order makes of a deflection, w_0 by the cut forces: w = w_0/(1 - n), of one that
/// holds the second order of the loads times one w_0 (1 - n/factor)/(1 - n), n = N/N_cr under the
/// largest compression in the situation times `factor`. One for frames and elastic links, which
/// `second_order_gates_of` looks at, and where the beam buckles, which stops the verdict.
/// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 1.6.
double grown_by_second_order(const Project& project, const SituationRun& run, double factor,
                             bool counted) {
  if (std::holds_alternative<frame::Structure>(project.mechanism) ||
      std::holds_alternative<flexible::Mechanism>(project.mechanism) || (counted && factor == 1.0))
    return 1.0;
  const double once = pressed_part_in(project, run), n = factor * once;
  if (n >= 1.0) return 1.0;
  return (counted ? 1.0 - once : 1.0) / (1.0 - n);
}

std::string deflection_source(const DeflectionInput& input, const Situation& situation,
                              double grown) {
  std::string text = fmt::format("the case's limit; measured from {}", input.measured_from);
  if (input.load_factor && situation.load_factor != 1.0)
    text += fmt::format("; times the load factor {:.4g}, as the case asks", situation.load_factor);
  constexpr double worth_saying = 5e-4;
  if (grown > 1.0 + worth_saying)
    text += fmt::format("; times {:.4g} by second order, 1/(1 - N/N_cr)", grown);
  return text;
}

}  // namespace

std::optional<CheckResult> check_deflection(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            bool second_order_counted) {
  if (!project.deflection) return std::nullopt;
  const DeflectionInput& input = *project.deflection;
  const DeflectionModel model = deflection_model_of(project);
  const auto largest_in = [&](const SituationRun& run, const CutForceDiagram& diagram, Time time) {
    return largest_of(deflected_line_of(model, diagram, run.motion->beam_shift(time)));
  };
  Extreme worst;
  DeflectionBasis basis;
  double worst_grown = 1.0;
  Length place;
  for (const SituationRun& run : runs) {
    if (!run.situation->serviceability) continue;
    const LoadHistory& loads = run.loads;
    const double factor = input.load_factor ? run.situation->load_factor : 1.0;
    std::vector<double> values;
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      values.push_back(largest_in(run, loads.diagram(i), loads.time_of(i)).size.value());
    }
    const double begin = loads.begin().value(), end = (loads.begin() + loads.period()).value();
    const auto diagram_at = [&](double time) {
      return loads.diagram_at(si<Time>(loads.closed() ? time : std::clamp(time, begin, end)));
    };
    const Extremum peak = peak_over_time(values, sampled_time_of(loads), [&](double time) {
      return largest_in(run, diagram_at(time), si<Time>(time)).size.value();
    });
    const double grown = grown_by_second_order(project, run, factor, second_order_counted);
    const double alone = grown * peak.value;
    if (factor * alone <= worst.value) continue;
    worst = {si<Time>(peak.at), factor * alone, index_of(project, *run.situation)};
    basis = {si<Length>(alone), factor};
    worst_grown = grown;
    place = largest_in(run, diagram_at(peak.at), si<Time>(peak.at)).at;
  }
  if (worst.value == 0.0) return std::nullopt;
  const Situation& situation = project.situations[worst.situation];
  CheckResult result;
  result.deflection = basis;
  Check& check = result.check;
  check.criterion = Criterion::deflection;
  check.station = {place, Side::both};
  check.point = "from " + to_text(input.against);
  check.id = fmt::format("deflection/{}/axis", to_text(check.station));
  check.situation = situation.name;
  check.time = worst.time;
  check.acting = si<Length>(worst.value);
  check.resisting = input.limit;
  check.safety_factor = check.resisting / check.acting;
  check.required = 1.0;
  check.source = deflection_source(input, situation, worst_grown);
  return result;
}

}  // namespace boxbeam
