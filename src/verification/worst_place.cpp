#include "boxbeam/verification/worst_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/span.hpp"

namespace boxbeam {
namespace {

/// The normal stress on a hole's edge over the instants of each situation that runs, by index.
std::vector<Span> spans_at(const Project& project, const std::vector<SituationHistory>& histories,
                           const HoleEdge& edge) {
  std::vector<Span> spans(project.situations.size());
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      spans[index_of(project, *at.situation)].add(stress_at(edge.influence, cut).normal.value());
    }
  }
  return spans;
}

double largest_stress_of(const Project& project, const std::vector<Span>& spans) {
  double largest = 0.0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.between.empty())
      largest = std::max(largest, situation.load_factor * spans[i].largest());
  }
  return largest;
}

/// One cycle in each situation, and in each change between some.
std::vector<Cycle> cycles_of(const Project& project, const std::vector<Span>& spans, bool reduced) {
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.cycles == 0.0) continue;
    Span span = spans[i];
    for (const std::size_t other : situation.between) {
      span.add(spans[other].low);
      span.add(spans[other].high);
    }
    cycles.push_back(
        {si<Stress>(span.range()), si<Stress>(0.5 * (span.high + span.low)), situation.cycles});
  }
  if (reduced) cycles = compression_reduced(std::move(cycles));
  return cycles;
}

/// How badly these cycles use up a detail: the reciprocal of the factor that the cycles of the life
/// leave.
double fatigue_severity_of(const Project& project, const std::vector<Span>& spans,
                           const Detail& detail, bool reduced) {
  return 1.0 / largest_factor(cycles_of(project, spans, reduced), curve_of(detail),
                              project.fatigue.demand);
}

double largest_range_of(const std::vector<Cycle>& cycles) {
  double largest = 0.0;
  for (const Cycle& cycle : cycles) largest = std::max(largest, cycle.range.value());
  return largest;
}

/// The stresses of a place that a criterion looks at, over the instants of each situation that
/// runs, by index.
struct PlaceSpans {
  std::vector<Span> direct;  ///< as the detail counts it
  std::vector<Span> shear;
  double equivalent = 0.0;  ///< largest, load factors applied
};

/// The largest value near the instants: of the parabola through each peak and its neighbours.
/// Without it the largest sample would change from place to place, and what varies smoothly along a
/// wall would have many small maxima.
double peak_of(const std::vector<double>& values, bool closed) {
  const std::size_t n = values.size();
  double largest = values.front();
  for (std::size_t i = 0; i < n; ++i) {
    largest = std::max(largest, values[i]);
    if (!closed && (i == 0 || i + 1 == n)) continue;
    const double rise = values[i] - values[(i + n - 1) % n];
    const double fall = values[i] - values[(i + 1) % n];
    if (rise < 0.0 || fall < 0.0 || rise + fall == 0.0) continue;
    const double step = rise - fall;
    largest = std::max(largest, values[i] + step * step / (8.0 * (rise + fall)));
  }
  return largest;
}

Span span_of(std::vector<double> values, bool closed) {
  Span span;
  span.high = peak_of(values, closed);
  for (double& value : values) value = -value;
  span.low = -peak_of(values, closed);
  return span;
}

PlaceSpans place_spans_at(const Project& project, const StressPoint& point,
                          const std::vector<SituationHistory>& histories,
                          const StressInfluence& influence, Criterion criterion) {
  const bool yield = criterion == Criterion::yield;
  const bool normal = !yield && criterion != Criterion::shear_fatigue;
  const bool along = !yield && criterion != Criterion::fatigue;
  const double factor = point.detail != nullptr ? point.detail->stress_factor : 1.0;
  PlaceSpans spans{std::vector<Span>(project.situations.size()),
                   std::vector<Span>(project.situations.size()), 0.0};
  for (const SituationHistory& at : histories) {
    std::vector<double> direct, shear, equivalent;
    for (const CutForces& cut : at.history.samples()) {
      const PointStress stress = stress_at(influence, cut);
      if (normal) direct.push_back(factor * stress.normal.value());
      if (along) shear.push_back(stress.shear.value());
      if (yield) equivalent.push_back(stress.von_mises().value());
    }
    const bool closed = at.history.closed();
    const std::size_t i = index_of(project, *at.situation);
    if (normal) spans.direct[i] = span_of(std::move(direct), closed);
    if (along) spans.shear[i] = span_of(std::move(shear), closed);
    if (!yield) continue;
    spans.equivalent =
        std::max(spans.equivalent, at.situation->load_factor * peak_of(equivalent, closed));
  }
  return spans;
}

/// How near a place comes to the limit of a criterion; larger is worse.
double severity_of(const Project& project, const StressPoint& point, const PlaceSpans& spans,
                   Criterion criterion) {
  if (criterion == Criterion::yield) return spans.equivalent;
  std::vector<FatigueChannel> channels;
  double range = 0.0;
  if (point.detail != nullptr && criterion != Criterion::shear_fatigue) {
    auto cycles = cycles_of(project, spans.direct, point.compression_reduced);
    range = largest_range_of(cycles);
    if (range > 0.0) channels.push_back({std::move(cycles), curve_of(point.detail->detail)});
  }
  if (point.shear_detail != nullptr && criterion != Criterion::fatigue) {
    auto cycles = cycles_of(project, spans.shear, false);
    const double shear = largest_range_of(cycles);
    range = std::max(range, std::numbers::sqrt3 * shear);
    if (shear > 0.0) channels.push_back({std::move(cycles), curve_of(*point.shear_detail)});
  }
  if (criterion == Criterion::stress_range) return range;
  return channels.empty() ? 0.0 : 1.0 / largest_factor(channels, project.fatigue.demand);
}

}  // namespace

StressPoint at_worst_edge(const Project& project, const StressPoint& point,
                          const std::vector<SituationHistory>& histories, Criterion criterion) {
  StressPoint moved = point;
  moved.edges.clear();
  double worst = -1.0;
  for (const HoleEdge& edge : point.edges) {
    const std::vector<Span> spans = spans_at(project, histories, edge);
    const double value =
        criterion == Criterion::fatigue && point.detail != nullptr
            ? fatigue_severity_of(project, spans, point.detail->detail, point.compression_reduced)
            : largest_stress_of(project, spans);
    if (value <= worst) continue;
    worst = value;
    moved.y = edge.y;
    moved.z = edge.z;
    moved.influence = edge.influence;
    moved.concentration->angle = edge.angle;
  }
  return moved;
}

StressPoint at_worst_on_stretch(const Project& project, const StressPoint& point,
                                const std::vector<SituationHistory>& histories,
                                Criterion criterion) {
  const StressField& field = *point.stretch->field;
  const WallStretch& wall = point.stretch->wall;
  const auto severity = [&](double part) {
    const StressInfluence influence = influence_in(point, point_on_stretch(field, wall, part));
    return severity_of(project, point,
                       place_spans_at(project, point, histories, influence, criterion), criterion);
  };
  // Between two places of the grid of a round tube a fibre has at most 0.4 % more.
  constexpr double enough = 0.98;
  const int steps = wall.round ? 36 : 12;
  const auto part_of = [&](int k) { return static_cast<double>(k) / steps; };
  std::vector<double> values;
  for (int k = 0; k <= steps; ++k) values.push_back(severity(part_of(k)));
  const auto largest = std::max_element(values.begin(), values.end());
  Extremum worst{part_of(static_cast<int>(largest - values.begin())), *largest};
  const double at_least = enough * worst.value;
  // The first and the last place of a round tube are neighbours; beside the end of a straight wall
  // there may be a maximum.
  for (int k = 0; k <= steps; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const bool first = k == 0, last = k == steps;
    const double before =
        first ? (wall.round ? values[values.size() - 2] : -1.0) : values[index - 1];
    const double behind = last ? (wall.round ? values[1] : -1.0) : values[index + 1];
    if (values[index] < at_least || values[index] < before || values[index] < behind) continue;
    const double low = first && !wall.round ? 0.0 : part_of(k - 1);
    const double high = last && !wall.round ? 1.0 : part_of(k + 1);
    const Extremum found = find_maximum(severity, low, high);
    if (found.value > worst.value) worst = found;
  }
  StressPoint moved = point;
  moved.stretch.reset();
  const SectionPoint place = point_on_stretch(field, wall, worst.at);
  moved.y = place.y;
  moved.z = place.z;
  moved.prismatic = place.prismatic;
  moved.torsion = place.torsion;
  moved.influence = influence_in(point, place);
  return moved;
}

}  // namespace boxbeam
