#include "boxbeam/verification/worst_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "along_stretch.hpp"
#include "boxbeam/core/angle.hpp"
#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam {
namespace {

constexpr CriterionSet set_of(std::span<const Criterion> asked) {
  CriterionSet set({});
  for (const Criterion criterion : asked) set.add(criterion);
  return set;
}

/// Once round a hole in equal steps: what its edge has at any angle. Stresses there are waves of at
/// most three periods in a turn (hole_edges_of), places of one, so that their sums over the list
/// give them exactly.
class AroundEdge {
 public:
  /// Places of the list in a turn.
  static constexpr std::size_t places = 120;

  explicit AroundEdge(std::vector<HoleEdge>::const_iterator turn) : first_(*turn) {
    static const Weights weights = weights_in_a_turn();
    for (std::size_t k = 0; k < places; ++k) {
      const HoleEdge& edge = turn[static_cast<long>(k)];
      for (std::size_t n = 0; n < periods; ++n) {
        add(waves_[n].cosine, edge, weights[k][n].cosine);
        add(waves_[n].sine, edge, weights[k][n].sine);
      }
    }
  }

  static double angle_of(std::size_t place) {
    return full_turn * static_cast<double>(place) / static_cast<double>(places);
  }

  HoleEdge at(double angle) const {
    Values sum{};
    for (std::size_t n = 0; n < periods; ++n) {
      const double c = std::cos(static_cast<double>(n) * angle);
      const double s = std::sin(static_cast<double>(n) * angle);
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += c * waves_[n].cosine[i] + s * waves_[n].sine[i];
    }
    HoleEdge edge = first_;
    std::copy_n(sum.begin(), cut_force::count, edge.influence.normal.begin());
    edge.y = si<Length>(sum[cut_force::count]);
    edge.z = si<Length>(sum[cut_force::count + 1]);
    constexpr double turn = full_turn;
    edge.angle = angle - turn * std::floor(angle / turn);
    return edge;
  }

 private:
  static constexpr std::size_t periods = 4;
  using Values = std::array<double, cut_force::count + 2>;  ///< stress per cut force, y and z
  struct Wave {
    Values cosine{}, sine{};
  };
  struct Weight {
    double cosine = 0.0, sine = 0.0;
  };
  using Weights = std::array<std::array<Weight, periods>, places>;

  static Weights weights_in_a_turn() {
    Weights of;
    for (std::size_t k = 0; k < places; ++k) {
      const double angle = angle_of(k);
      for (std::size_t n = 0; n < periods; ++n) {
        const double weight = (n == 0 ? 1.0 : 2.0) / static_cast<double>(places);
        of[k][n] = {weight * std::cos(static_cast<double>(n) * angle),
                    weight * std::sin(static_cast<double>(n) * angle)};
      }
    }
    return of;
  }

  static void add(Values& sum, const HoleEdge& edge, double weight) {
    for (std::size_t i = 0; i < cut_force::count; ++i) sum[i] += weight * edge.influence.normal[i];
    sum[cut_force::count] += weight * edge.y.value();
    sum[cut_force::count + 1] += weight * edge.z.value();
  }

  HoleEdge first_;
  std::array<Wave, periods> waves_;
};

/// A place on an edge, and how far a criterion is used up there.
struct WorstEdge {
  double utilisation = -1.0;
  HoleEdge edge;

  void take(const HoleEdge& at, double use) {
    if (use <= utilisation) return;
    utilisation = use;
    edge = at;
  }
};

/// The worst places on the edge of a hole by several criteria, which share what is judged by all.
class EdgeSearch {
 public:
  EdgeSearch(const StationSamples& samples, const StressPoint& point, CriterionSet by)
      : samples_(&samples), point_(&point) {
    if (point.edges.size() % AroundEdge::places != 0) {
      for (const HoleEdge& edge : point.edges)
        listed_.push_back(samples.judge(point, edge.influence, by));
      return;
    }
    // Once round the hole; a second turn is for shear as if the beam did not taper.
    for (auto first = point.edges.begin(); first != point.edges.end();
         first += AroundEdge::places) {
      Turn& turn = turns_.emplace_back();
      turn.first = first;
      for (std::size_t k = 0; k < AroundEdge::places; k += step)
        turn.uses.push_back(samples.judge(point, first[static_cast<long>(k)].influence, by));
    }
  }

  HoleEdge worst(Criterion by) {
    WorstEdge worst;
    for (std::size_t k = 0; k < listed_.size(); ++k)
      worst.take(point_->edges[k], listed_[k].of(by));
    for (Turn& turn : turns_) look_round(turn, by, worst);
    return worst.edge;
  }

 private:
  /// Every 12 degrees: waves of three periods in a turn have at most 6 % more between two of them.
  static constexpr std::size_t step = 4;

  struct Turn {
    std::vector<HoleEdge>::const_iterator first;
    std::vector<Utilisations> uses;
    std::optional<AroundEdge> around;
  };

  void look_round(Turn& turn, Criterion by, WorstEdge& worst) const {
    std::vector<double> values;
    for (const Utilisations& use : turn.uses) values.push_back(use.of(by));
    values.push_back(values.front());
    const double largest = *std::max_element(values.begin(), values.end());
    if (!(largest > 0.0)) {
      worst.take(*turn.first, largest);
      return;
    }
    if (!turn.around) turn.around.emplace(turn.first);
    const AroundEdge& around = *turn.around;
    const double width = AroundEdge::angle_of(step);
    for (const std::size_t k : local_maxima_of(values, true)) {
      if (k + 1 == values.size() || values[k] < 0.9 * largest) continue;
      const double middle = AroundEdge::angle_of(k * step);
      const Extremum found = find_maximum(
          [&](double angle) {
            return samples_->judge(*point_, around.at(angle).influence, {by}).of(by);
          },
          middle - width, middle + width, 16);
      worst.take(turn.first[static_cast<long>(k * step)], values[k]);
      worst.take(around.at(found.at), found.value);
    }
  }

  const StationSamples* samples_;
  const StressPoint* point_;
  std::vector<Utilisations> listed_;  ///< of an edge of which not every place is known
  std::vector<Turn> turns_;
};

}  // namespace

StressPoint moved_along(const StressPoint& point, double part) {
  StressPoint moved = point;
  moved.stretch.reset();
  const SectionPoint place = point_on_stretch(*point.stretch->field, point.stretch->wall, part);
  moved.y = place.y;
  moved.z = place.z;
  moved.prismatic = place.prismatic;
  moved.torsion = place.torsion;
  moved.influence = influence_in(point, place);
  return moved;
}

std::vector<StressPoint> at_worst_edges(const StationSamples& samples, const StressPoint& point,
                                        std::span<const Criterion> asked) {
  StressPoint whole = point;
  whole.edges.clear();
  std::vector<StressPoint> moved(asked.size(), whole);
  if (point.edges.empty()) return moved;
  // Without a detail no range is judged: the largest stress decides.
  const CriterionSet by = point.detail != nullptr ? set_of(asked) : CriterionSet{Criterion::yield};
  EdgeSearch search(samples, point, by);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const HoleEdge edge = search.worst(by.has(asked[i]) ? asked[i] : Criterion::yield);
    moved[i].y = edge.y;
    moved[i].z = edge.z;
    moved[i].influence = edge.influence;
    EdgeBasis& basis = moved[i].concentration->edge;
    basis.angle = edge.angle;
    basis.y = edge.y;
    basis.z = edge.z;
    basis.around = edge.around;
  }
  return moved;
}

StationPoints station_points_of(const StationSamples& samples, std::vector<StressPoint> points) {
  StationPoints of{std::move(points), {}};
  for (StressPoint& point : of.points) {
    std::vector<StressPoint>& worst = of.on_edges.emplace_back();
    if (point.edges.empty()) continue;
    worst = at_worst_edges(samples, point, stress_criteria);
    point.edges.clear();
  }
  return of;
}

StressPoint at_worst_on_stretch(const StationSamples& samples, const StressPoint& point,
                                Criterion criterion) {
  const AlongStretch along(point);
  const bool round = point.stretch->wall.round;
  const auto judge = [&](double part) {
    return samples.judge(point, along.at(point, part), {criterion}).of(criterion);
  };
  const int steps = round ? 36 : 12;
  const auto part_of = [&](std::size_t k) { return static_cast<double>(k) / steps; };
  std::vector<double> values;
  for (int k = 0; k <= steps; ++k) values.push_back(judge(part_of(static_cast<std::size_t>(k))));
  const auto largest = std::max_element(values.begin(), values.end());
  Extremum worst{part_of(static_cast<std::size_t>(largest - values.begin())), *largest};
  // Between two places of the grid of a round tube a fibre has at most 0.4 % more.
  const double at_least = 0.98 * worst.value;
  for (const std::size_t k : local_maxima_of(values, round)) {
    if (values[k] < at_least || worst.value == 0.0) continue;
    // Beside the end of a straight wall there may be a maximum; a ring goes on.
    const double low = k == 0 && !round ? 0.0 : part_of(k) - 1.0 / steps;
    const double high = k + 1 == values.size() && !round ? 1.0 : part_of(k) + 1.0 / steps;
    const Extremum found = find_maximum(judge, low, high);
    // What is not worse than round-off is not worth a place of its own.
    if (found.value > worst.value * (1.0 + 1e-9)) worst = found;
  }
  return moved_along(point, worst.at);
}

}  // namespace boxbeam
