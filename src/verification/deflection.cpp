#include "boxbeam/verification/deflection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/shear_area.hpp"

namespace boxbeam {
namespace {

constexpr int places = 48;
constexpr int pieces_per_segment = 16;
/// Gauss-Legendre nodes and weights on [-1, 1].
constexpr std::array<std::array<double, 2>, 5> gauss{{{-0.9061798459386640, 0.2369268850561891},
                                                      {-0.5384693101056831, 0.4786286704993665},
                                                      {0.0, 0.5688888888888889},
                                                      {0.5384693101056831, 0.4786286704993665},
                                                      {0.9061798459386640, 0.2369268850561891}}};

/// Cut forces of a beam on supports at a and b under a unit force along +z at p.
struct UnitCut {
  double M, V;
};

UnitCut unit_cut(double s, double p, double a, double b) {
  // Reactions along +z from balance; N, V and M as in CutForceDiagram: V = -(sum of what acts on
  // [0, s]), dM/ds = V.
  const double at_b = -(p - a) / (b - a);
  const double at_a = -1.0 - at_b;
  UnitCut cut{0.0, 0.0};
  for (const auto& [force, at] : {std::pair{1.0, p}, {at_a, a}, {at_b, b}}) {
    if (s < at) continue;
    cut.V -= force;
    cut.M -= force * (s - at);
  }
  return cut;
}

}  // namespace

DeflectionModel deflection_model_of(const Project& project) {
  const TaperedBeam& beam = project.beam;
  const DeflectionInput& input = *project.deflection;
  DeflectionModel model;
  const double length = beam.length().value();
  const double a = input.from.value();
  const double b = input.to.value();
  for (int j = 0; j <= places; ++j) {
    const double s = length * j / places;
    if (s != a && s != b) model.influences.push_back({si<Length>(s), {}, {}, {}});
  }
  // Where the unit forces and supports stand their cut forces bend or jump: no quadrature across.
  std::vector<double> borders{a, b};
  for (const DeflectionInfluence& influence : model.influences)
    borders.push_back(influence.at.value());
  for (const Segment& segment : beam.segments) {
    for (int k = 0; k <= pieces_per_segment; ++k) {
      borders.push_back(segment.start.value() + segment.length.value() * k / pieces_per_segment);
    }
  }
  std::sort(borders.begin(), borders.end());
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double half = 0.5 * (borders[i + 1] - borders[i]);
    if (half < 1e-12 * length) continue;
    for (const auto& [u, weight] : gauss) {
      const double s = borders[i] + half * (1.0 + u);
      const Section section = section_at(beam, {si<Length>(s)});
      const Eigen::RowVector3d curvature =
          normal_stress_plane(sums_of(outline_of(section, {}))).row(2) /
          input.youngs_modulus.value();
      const double GA = input.shear_modulus.value() * shear_area_of(section).value();
      model.nodes.push_back(si<Length>(s));
      for (DeflectionInfluence& influence : model.influences) {
        const UnitCut unit = unit_cut(s, influence.at.value(), a, b);
        influence.weight_N.push_back(half * weight * unit.M * curvature[0]);
        influence.weight_M.push_back(half * weight * unit.M * curvature[1]);
        influence.weight_V.push_back(half * weight * unit.V / GA);
      }
    }
  }
  return model;
}

std::vector<double> deflections_of(const DeflectionModel& model, const CutForceDiagram& diagram) {
  std::vector<double> deflections(model.influences.size(), 0.0);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const CutForces cut = diagram.at({model.nodes[i]});
    for (std::size_t j = 0; j < deflections.size(); ++j) {
      const DeflectionInfluence& influence = model.influences[j];
      deflections[j] += influence.weight_N[i] * cut.N.value() +
                        influence.weight_M[i] * cut.M_y.value() +
                        influence.weight_V[i] * cut.V_z.value();
    }
  }
  return deflections;
}

std::optional<Check> check_deflection(const Project& project,
                                      const std::deque<SituationRun>& runs) {
  const DeflectionModel model = deflection_model_of(project);
  Extreme worst;
  std::size_t place = 0;
  double largest = -1.0;
  const auto largest_of = [&](const CutForceDiagram& diagram) {
    const std::vector<double> deflections = deflections_of(model, diagram);
    const auto most =
        std::max_element(deflections.begin(), deflections.end(),
                         [](double x, double y) { return std::abs(x) < std::abs(y); });
    return std::pair{std::abs(*most), static_cast<std::size_t>(most - deflections.begin())};
  };
  for (const SituationRun& run : runs) {
    const LoadHistory& loads = run.loads;
    std::size_t peak = 0;
    double peak_value = -1.0;
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      const double value = largest_of(loads.diagram(i)).first;
      if (value <= peak_value) continue;
      peak_value = value;
      peak = i;
    }
    const LoadHistory::Reach reach = loads.reach_of(peak);
    const Extremum found = find_maximum(
        [&](double time) { return largest_of(loads.diagram_at(si<Time>(time))).first; },
        reach.from.value(), reach.to.value());
    const bool between = found.value > peak_value;
    double time = between ? found.at : loads.time_of(peak).value();
    const double value = std::max(found.value, peak_value) * run.situation->load_factor;
    if (value <= largest) continue;
    largest = value;
    place = largest_of(loads.diagram_at(si<Time>(time))).second;
    if (loads.closed() && time < loads.begin().value()) time += loads.period().value();
    worst = {si<Time>(time), value, index_of(project, *run.situation)};
  }
  if (worst.value == 0.0) return std::nullopt;
  Check check;
  check.criterion = Criterion::deflection;
  check.station = {model.influences[place].at, Side::both};
  check.point = "axis";
  check.id = fmt::format("deflection/{}/axis", to_text(check.station));
  check.situation = project.situations[worst.situation].name;
  check.time = worst.time;
  check.acting = si<Length>(worst.value);
  check.resisting = project.deflection->limit;
  check.safety_factor = check.resisting / check.acting;
  check.required = 1.0;
  check.source = fmt::format(
      "the case's limit; virtual work, measured from the line s = {} to {} m",
      to_text(Station{project.deflection->from}), to_text(Station{project.deflection->to}));
  return check;
}

}  // namespace boxbeam
