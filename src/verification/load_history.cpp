#include "boxbeam/verification/load_history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace boxbeam {
namespace {

constexpr std::size_t last_node = LoadHistory::nodes - 1;

/// Chebyshev point of the second kind, ascending in [-1, 1]. Every value between instants asks for
/// all of them: their cosines are taken once.
double node(std::size_t k) {
  static const auto nodes = [] {
    std::array<double, LoadHistory::nodes> of;
    for (std::size_t i = 0; i < of.size(); ++i)
      of[i] = -std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(last_node));
    return of;
  }();
  return nodes[k];
}

/// Value at u of the polynomial through the nodes. Barycentric formula; weights of Chebyshev points
/// alternate in sign and are halved at the ends. Source: Berrut and Trefethen, SIAM Review 46
/// (2004).
CutForces interpolate(const std::array<CutForces, LoadHistory::nodes>& values, double u) {
  double sum = 0.0;
  CutForces result{};
  for (std::size_t k = 0; k <= last_node; ++k) {
    const double distance = u - node(k);
    if (distance == 0.0) return values[k];
    double weight = (k % 2 == 0 ? 1.0 : -1.0) / distance;
    if (k == 0 || k == last_node) weight *= 0.5;
    sum += weight;
    result.N += weight * values[k].N;
    result.V_y += weight * values[k].V_y;
    result.V_z += weight * values[k].V_z;
    result.T += weight * values[k].T;
    result.M_y += weight * values[k].M_y;
    result.M_z += weight * values[k].M_z;
  }
  const double scale = 1.0 / sum;
  return {result.N * scale, result.V_y * scale, result.V_z * scale,
          result.T * scale, result.M_y * scale, result.M_z * scale};
}

/// How many borders of pieces lie before a station, seen from its side: changes where a load slides
/// over it.
std::size_t borders_before(const CutForceDiagram& diagram, const Station& station) {
  return static_cast<std::size_t>(
      std::count_if(diagram.pieces.begin(), diagram.pieces.end(), [&](const CutForcePiece& piece) {
        return piece.end() < station.s ||
               (piece.end() == station.s && station.side != Side::before);
      }));
}

}  // namespace

LoadHistory::LoadHistory(const LoadSpan& span, LoadsAt loads_at)
    : span_(span), loads_at_(std::move(loads_at)) {
  assert(span.instants >= 4);
  diagrams_.resize(span.instants + (span.closed ? 0 : 1));
  for (std::size_t i = 0; i < diagrams_.size(); ++i) diagrams_[i] = diagram_at(time_of(i));
}

Time LoadHistory::time_of(std::size_t instant) const {
  // Rounded as the motion rounds it, so that the motion's own instants are met exactly.
  return span_.begin +
         span_.period * static_cast<double>(instant) / static_cast<double>(span_.instants);
}

std::size_t LoadHistory::middle_near(std::size_t instant) const {
  return span_.closed ? instant : std::clamp<std::size_t>(instant, 1, diagrams_.size() - 2);
}

const LoadHistory::Bracket& LoadHistory::bracket(std::size_t middle) const {
  const auto found = brackets_.find(middle);
  if (found != brackets_.end()) return found->second;
  Bracket bracket;
  const std::size_t n = diagrams_.size();
  for (std::size_t k = 0; k <= last_node; ++k) {
    if (k == 0)
      bracket[k] = diagrams_[(middle + n - 1) % n];
    else if (k == last_node)
      bracket[k] = diagrams_[(middle + 1) % n];
    else if (2 * k == last_node)
      bracket[k] = diagrams_[middle];
    else
      bracket[k] = diagram_at(time_of(middle) + node(k) * step());
  }
  return brackets_.emplace(middle, std::move(bracket)).first->second;
}

StationHistory::StationHistory(const LoadHistory& loads, const Station& station)
    : loads_(&loads), station_(station) {
  samples_.reserve(loads.instants());
  for (std::size_t i = 0; i < loads.instants(); ++i)
    samples_.push_back(loads.diagram(i).at(station));
}

std::vector<TurningPoint> StationHistory::turning_points(const CutForceFunction& f) const {
  const std::size_t n = samples_.size();
  std::vector<double> values(n);
  std::transform(samples_.begin(), samples_.end(), values.begin(), f);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double scale = std::max(std::abs(*low), std::abs(*high));
  const double noise = 1e-9 * scale;
  const auto highest = static_cast<std::size_t>(high - values.begin());
  std::vector<TurningPoint> turns;
  if (!(*high - *low > noise)) return {{loads_->time_of(highest), values[highest], true}};

  // From the highest sample once round; a turn counts when the history has come back from it by
  // more than the noise.
  std::vector<std::pair<std::size_t, bool>> brackets{{highest, true}};
  std::size_t candidate = highest;
  bool falling = true;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (highest + k) % n;
    const double towards = falling ? values[candidate] - values[i] : values[i] - values[candidate];
    if (towards > 0.0) {
      candidate = i;
    } else if (towards < -noise) {
      brackets.emplace_back(candidate, !falling);
      falling = !falling;
      candidate = i;
    }
  }
  std::sort(brackets.begin(), brackets.end());
  brackets.erase(std::unique(brackets.begin(), brackets.end()), brackets.end());

  turns.reserve(brackets.size());
  for (const auto& [middle, maximum] : brackets) turns.push_back(refine(middle, maximum, f));
  std::sort(turns.begin(), turns.end(),
            [](const TurningPoint& a, const TurningPoint& b) { return a.time < b.time; });
  return turns;
}

Extremum StationHistory::extremum_at_passage(std::size_t middle, const Nodes& nodes, double sign,
                                             const CutForceFunction& f) const {
  Extremum best{node(0), sign * f(nodes[0])};
  const auto consider = [&](double u, double value) {
    if (value > best.value) best = {u, value};
  };
  const LoadHistory::Bracket& bracket = loads_->bracket(middle);
  const auto diagram_at = [&](double u) {
    return loads_->diagram_at(loads_->time_of(middle) + u * loads_->step());
  };
  for (std::size_t k = 1; k <= last_node; ++k) {
    consider(node(k), sign * f(nodes[k]));
    const std::size_t before = borders_before(bracket[k - 1], station_);
    if (borders_before(bracket[k], station_) == before) continue;
    double low = node(k - 1);
    double high = node(k);
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
      const double half = 0.5 * (low + high);
      (borders_before(diagram_at(half), station_) == before ? low : high) = half;
    }
    for (const double u : {low, high}) consider(u, sign * f(diagram_at(u).at(station_)));
  }
  return best;
}

TurningPoint StationHistory::refine(std::size_t instant, bool maximum,
                                    const CutForceFunction& f) const {
  const std::size_t middle = loads_->middle_near(instant);
  const Nodes at_nodes = nodes_of(middle);
  const double sign = maximum ? 1.0 : -1.0;
  const LoadHistory::Bracket& bracket = loads_->bracket(middle);
  const bool passage =
      std::any_of(bracket.begin(), bracket.end(), [&](const CutForceDiagram& diagram) {
        return borders_before(diagram, station_) != borders_before(bracket[0], station_);
      });
  Extremum found =
      passage
          ? extremum_at_passage(middle, at_nodes, sign, f)
          : find_maximum([&](double u) { return sign * f(interpolate(at_nodes, u)); }, -1.0, 1.0);
  // The instant itself may be as high: at the very end of an open history, at a corner, or where
  // nothing changes.
  const double at_instant = sign * f(samples_[instant]);
  if (at_instant >= found.value) {
    const double u = instant == middle ? 0.0 : (instant < middle ? -1.0 : 1.0);
    found = {u, at_instant};
  }
  // The search ends within 2^-22 of the bracket: so near an instant, it is the instant.
  const double offset = std::abs(found.at) < 1e-6 ? 0.0 : found.at;
  Time time = loads_->time_of(middle) + offset * loads_->step();
  if (loads_->closed()) {
    if (time < loads_->begin()) time += loads_->period();
    if (time >= loads_->begin() + loads_->period()) time -= loads_->period();
  }
  return {time, sign * found.value, maximum};
}

CutForces StationHistory::at(Time time) const {
  const double position = (time - loads_->begin()) / loads_->step();
  const double nearest = std::round(position);
  const std::size_t instant = static_cast<std::size_t>(nearest) % samples_.size();
  if (position == nearest) return samples_[instant];
  const std::size_t middle = loads_->middle_near(instant);
  return interpolate(nodes_of(middle), position - nearest + static_cast<double>(instant) -
                                           static_cast<double>(middle));
}

StationHistory::Nodes StationHistory::nodes_of(std::size_t middle) const {
  const LoadHistory::Bracket& bracket = loads_->bracket(middle);
  Nodes nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = bracket[k].at(station_);
  return nodes;
}

TurningPoint StationHistory::largest(const CutForceFunction& f) const {
  const std::size_t n = samples_.size();
  std::vector<double> values(n);
  std::transform(samples_.begin(), samples_.end(), values.begin(), f);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto highest = static_cast<std::size_t>(high - values.begin());
  TurningPoint best{loads_->time_of(highest), values[highest], true};
  // Peaks a little lower at the instants may be higher between them.
  const double enough = *high - 0.05 * (*high - *low);
  for (std::size_t i = 0; i < n; ++i) {
    const bool peak = values[i] >= values[(i + n - 1) % n] && values[i] > values[(i + 1) % n];
    if (!peak || values[i] < enough) continue;
    const TurningPoint found = refine(i, true, f);
    if (found.value > best.value) best = found;
  }
  return best;
}

}  // namespace boxbeam
