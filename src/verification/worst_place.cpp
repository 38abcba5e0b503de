#include "boxbeam/verification/worst_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam {
namespace {

constexpr std::array of_plates{Criterion::yield, Criterion::fatigue, Criterion::shear_fatigue,
                               Criterion::combined_fatigue, Criterion::stress_range};

constexpr CriterionSet set_of(std::span<const Criterion> asked) {
  CriterionSet set({});
  for (const Criterion criterion : asked) set.add(criterion);
  return set;
}

/// Of three influences at -1, 0 and 1, the one of the parabola through them at u.
StressInfluence between(const std::array<StressInfluence, 3>& of, double u) {
  const double a = 0.5 * u * (u - 1.0), b = (1.0 - u) * (1.0 + u), c = 0.5 * u * (u + 1.0);
  StressInfluence influence;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    influence.normal[k] = a * of[0].normal[k] + b * of[1].normal[k] + c * of[2].normal[k];
    influence.shear[k] = a * of[0].shear[k] + b * of[1].shear[k] + c * of[2].shear[k];
  }
  return influence;
}

/// The influences along a stretch. On a straight wall of a cell or a path the normal stress is
/// linear and the shear flow a parabola: three places tell all.
class AlongStretch {
 public:
  explicit AlongStretch(const StressPoint& point) : point_(&point) {
    const WallStretch& wall = point.stretch->wall;
    // Of the end alone one place is enough.
    straight_ = !point.stretch->only_end && !wall.round && !wall.solid &&
                point.stretch->field->flow->at.graph.walls[wall.wall].radius == 0.0;
    if (!straight_) return;
    for (std::size_t k = 0; k < 3; ++k) three_[k] = exact_at(0.5 * static_cast<double>(k));
  }

  bool straight() const { return straight_; }
  bool round() const { return point_->stretch->wall.round; }

  StressInfluence at(double part) const {
    return straight_ ? between(three_, 2.0 * part - 1.0) : exact_at(part);
  }

 private:
  StressInfluence exact_at(double part) const {
    return influence_in(*point_,
                        point_on_stretch(*point_->stretch->field, point_->stretch->wall, part));
  }

  const StressPoint* point_;
  bool straight_ = false;
  std::array<StressInfluence, 3> three_;
};

/// The local maxima of values on a grid, by their indices; of a ring the first and the last place
/// are one.
std::vector<std::size_t> local_maxima_of(const std::vector<double>& values, bool ring) {
  std::vector<std::size_t> maxima;
  const std::size_t last = values.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const double before = k > 0 ? values[k - 1] : (ring ? values[last - 1] : -1.0);
    const double behind = k < last ? values[k + 1] : (ring ? values[1] : -1.0);
    if (values[k] >= before && values[k] >= behind) maxima.push_back(k);
  }
  return maxima;
}

/// The top of the parabola through a place of a grid and its neighbours, as far as they are there.
double parabola_over(const std::vector<double>& values, std::size_t k) {
  if (k == 0 || k + 1 == values.size()) {
    if (values.size() < 3) return values[k];
    k = k == 0 ? 1 : k - 1;
  }
  const double slope = 0.5 * (values[k + 1] - values[k - 1]);
  const double bend = values[k + 1] - 2.0 * values[k] + values[k - 1];
  const double largest = std::max({values[k - 1], values[k], values[k + 1]});
  if (bend >= 0.0 || std::abs(slope) > -bend) return largest;
  return std::max(largest, values[k] - 0.5 * slope * slope / bend);
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

StressPoint at_worst_edge(const StationSamples& samples, const StressPoint& point,
                          Criterion criterion) {
  return std::move(at_worst_edges(samples, point, {&criterion, 1}).front());
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
  const auto judge = [&](double part) {
    return samples.judge(point, along.at(part), {criterion}).of(criterion);
  };
  const int steps = along.round() ? 36 : 12;
  const auto part_of = [&](std::size_t k) { return static_cast<double>(k) / steps; };
  std::vector<double> values;
  for (int k = 0; k <= steps; ++k) values.push_back(judge(part_of(static_cast<std::size_t>(k))));
  const auto largest = std::max_element(values.begin(), values.end());
  Extremum worst{part_of(static_cast<std::size_t>(largest - values.begin())), *largest};
  // Between two places of the grid of a round tube a fibre has at most 0.4 % more.
  const double at_least = 0.98 * worst.value;
  for (const std::size_t k : local_maxima_of(values, along.round())) {
    if (values[k] < at_least || worst.value == 0.0) continue;
    // Beside the end of a straight wall there may be a maximum; a ring goes on.
    const double low = k == 0 && !along.round() ? 0.0 : part_of(k) - 1.0 / steps;
    const double high = k + 1 == values.size() && !along.round() ? 1.0 : part_of(k) + 1.0 / steps;
    const Extremum found = find_maximum(judge, low, high);
    // What is not worse than round-off is not worth a place of its own.
    if (found.value > worst.value * (1.0 + 1e-9)) worst = found;
  }
  return moved_along(point, worst.at);
}

WallSearch::WallSearch(const StationSamples& samples, std::span<const StressPoint> points,
                       const Utilisations& named) {
  for (const Criterion criterion : of_plates)
    worst_[static_cast<std::size_t>(criterion)].utilisation = named.of(criterion);
  for (const StressPoint& point : points) {
    if (point.stretch) look_along(samples, point);
  }
}

void WallSearch::look_along(const StationSamples& samples, const StressPoint& point) {
  const AlongStretch along(point);
  std::vector<double> parts;
  // In the plane the flange of a section that mirrors itself is stressed evenly, and its shear
  // grows in proportion to the distance from its middle.
  if (point.stretch->only_end)
    parts = {1.0};
  else if (along.round())
    for (int k = 0; k <= 36; ++k) parts.push_back(k / 36.0);
  else
    for (int k = 0; k <= 4; ++k) parts.push_back(k / 4.0);
  std::vector<Utilisations> judged;
  for (const double part : parts)
    judged.push_back(samples.judge(point, along.at(part), set_of(of_plates)));
  std::vector<double> values;
  for (const Criterion criterion : of_plates) {
    WorstOnWall& worst = worst_[static_cast<std::size_t>(criterion)];
    const auto take = [&](double part, double utilisation) {
      // What is not worse than round-off is not worth a place of its own.
      if (utilisation > worst.utilisation * (1.0 + 1e-9)) worst = {utilisation, &point, part};
    };
    values.clear();
    for (const Utilisations& at : judged) values.push_back(at.of(criterion));
    for (std::size_t k = 0; k < parts.size(); ++k) take(parts[k], values[k]);
    if (parts.size() == 1 || *std::max_element(values.begin(), values.end()) == 0.0) continue;
    for (const std::size_t k : local_maxima_of(values, along.round())) {
      if (values[k] == 0.0 || 1.02 * parabola_over(values, k) < worst.utilisation) continue;
      const double step = parts[1] - parts[0];
      const double low = k == 0 && !along.round() ? 0.0 : parts[k] - step;
      const double high = k + 1 == parts.size() && !along.round() ? 1.0 : parts[k] + step;
      const Extremum found = find_maximum(
          [&](double part) {
            return samples.judge(point, along.at(part), {criterion}).of(criterion);
          },
          low, high, 10);
      take(found.at, found.value);
    }
  }
}

}  // namespace boxbeam
