#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/turning_samples.hpp"
#include "bracket_nodes.hpp"
#include "linear_stress.hpp"

namespace boxbeam {
namespace {

/// At all samples.
void add_values(const CutForceFunction& f, const std::vector<CutForces>& samples,
                std::vector<double>& values) {
  const auto add = [&](const auto& of) {
    std::transform(samples.begin(), samples.end(), std::back_inserter(values), of);
  };
  if (const auto* const linear = f.target<LinearStress>())
    add(*linear);
  else
    add(std::cref(f));
}

}  // namespace

StationHistory::StationHistory(const LoadHistory& loads, const Station& station)
    : loads_(&loads), station_(station) {
  samples_ = loads.cuts_at(station);
  double force = 0.0, moment = 0.0;
  for (const CutForces& cut : samples_) {
    force = std::max(force, force_in(cut));
    moment = std::max(moment, moment_in(cut));
  }
  // What is small beside the loads of the whole beam is the rounding of their sums.
  constexpr double round_off = 1e-4;
  force_floor_ = std::max(force, round_off * loads.largest_force());
  moment_floor_ = std::max(moment, round_off * loads.largest_moment());
}

void StationHistory::look_in(const Piece& piece, double own, double sign, const CutForceFunction& f,
                             Extremum& best) const {
  std::array<double, LoadHistory::nodes> values{};
  for (std::size_t k = 0; k <= last_node; ++k) values[k] = sign * f(piece.at[k]);
  const auto k =
      static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  if (values[k] > best.value) best = {BracketPoints::between(piece.from, piece.to, k), values[k]};
  if (piece.jump) return;
  const Extremum found = find_maximum([&](double u) { return sign * f(interpolate(piece.at, u)); },
                                      BracketPoints::point(k > 0 ? k - 1 : 0),
                                      BracketPoints::point(std::min(k + 1, last_node)));
  if (found.value <= best.value) return;
  const double middle = 0.5 * (piece.from + piece.to);
  best = {std::clamp(middle + 0.5 * (piece.to - piece.from) * found.at, piece.from, piece.to),
          found.value};
  // The search ends within 2^-22 of the bracket: so near an instant, it is the instant.
  if (std::abs(best.at - own) < 1e-6 * (piece.to - piece.from)) best.at = own;
}

Extremum StationHistory::extremum_near(std::size_t instant, double sign,
                                       const CutForceFunction& f) const {
  const double own = loads_->time_of(instant).value();
  Extremum best{own, sign * f(samples_[instant])};
  for (const Piece& piece : pieces_of(instant)) look_in(piece, own, sign, f, best);
  return best;
}

TurningPoint StationHistory::refine(const Passage& passage, bool behind, bool maximum,
                                    const CutForceFunction& f) const {
  const double sign = maximum ? 1.0 : -1.0, at = passage.time.value();
  const std::size_t i = passage.instant;
  const double low =
      (i > 0 ? loads_->time_of(i - 1) : loads_->time_of(samples_.size() - 1) - period()).value();
  const double from = behind ? at : low, to = behind ? loads_->time_of(i).value() : at;
  // The pieces end at the last time before it and at the first behind it: what is evaluated there
  // is on the side meant, which at the passage's own time nobody knows.
  Extremum best{at, -std::numeric_limits<double>::infinity()};
  for (const Piece& piece : pieces_of(i)) {
    const bool lies_behind = 0.5 * (piece.from + piece.to) > at;
    if (lies_behind != behind || piece.to <= from || piece.from >= to) continue;
    look_in(piece, behind ? to : from, sign, f, best);
  }
  if (!std::isfinite(best.value)) best.value = sign * f(behind ? passage.behind : passage.before);
  return turning_point_of(best, maximum);
}

TurningPoint StationHistory::turning_point_of(const Extremum& found, bool maximum) const {
  Time time = si<Time>(found.at);
  if (loads_->closed()) {
    if (time < loads_->begin()) time += loads_->period();
    if (time >= loads_->begin() + loads_->period()) time -= loads_->period();
  }
  return {time, (maximum ? 1.0 : -1.0) * found.value, maximum};
}

TurningPoint StationHistory::refine(std::size_t instant, bool maximum, const CutForceFunction& f,
                                    double noise) const {
  if (loads_->is_recorded()) return {time_of(instant), f(samples_[instant]), maximum};
  const double sign = maximum ? 1.0 : -1.0;
  Extremum found = extremum_near(instant, sign, f);
  // Where the loads bend and do not jump, the two instants of a break are one, and the extremum may
  // lie on either side of it.
  const std::size_t n = samples_.size();
  const double own = f(samples_[instant]);
  const auto look_at = [&](std::size_t other) {
    if (std::abs(f(samples_[other]) - own) > noise) return;
    const Extremum across = extremum_near(other, sign, f);
    if (across.value > found.value) found = across;
  };
  if (loads_->begins_piece(instant) && (instant > 0 || loads_->closed())) {
    look_at((instant + n - 1) % n);
  }
  const bool last = instant + 1 == n;
  if ((!last || loads_->closed()) && loads_->begins_piece((instant + 1) % n)) {
    look_at((instant + 1) % n);
  }
  return turning_point_of(found, maximum);
}

std::vector<TurningPoint> StationHistory::turning_points(const CutForceFunction& f) const {
  /// An instant, or a side of a passage before it.
  struct Looked {
    std::size_t instant = 0;
    const Passage* passage = nullptr;
    bool behind = false;
  };
  const std::vector<Passage>& passed = passages();
  std::vector<double> values;
  values.reserve(samples_.size() + 2 * passed.size());
  std::vector<Looked> looked;  // of a station without passages the instants
  if (passed.empty()) {
    add_values(f, samples_, values);
  } else {
    looked.reserve(values.capacity());
    const auto add = [&](const CutForces& cut, const Looked& at) {
      values.push_back(f(cut));
      looked.push_back(at);
    };
    auto passage = passed.begin();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      for (; passage != passed.end() && passage->instant == i; ++passage) {
        add(passage->before, {i, &*passage, false});
        add(passage->behind, {i, &*passage, true});
      }
      add(samples_[i], {i});
    }
  }
  const auto looked_at = [&](std::size_t sample) {
    return looked.empty() ? Looked{sample} : looked[sample];
  };
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double noise = noise_between(*low, *high);
  const auto refined = [&](std::size_t sample, bool maximum) {
    const Looked of = looked_at(sample);
    return of.passage != nullptr ? refine(*of.passage, of.behind, maximum, f)
                                 : refine(of.instant, maximum, f, noise);
  };
  const TurningSamples found = turning_samples_of(values);
  if (found.turns.empty()) {
    return {{loads_->time_of(looked_at(found.highest).instant), values[found.highest], true}};
  }

  std::vector<TurningPoint> turns;
  turns.reserve(found.turns.size());
  for (const auto& [sample, maximum] : found.turns) turns.push_back(refined(sample, maximum));
  std::sort(turns.begin(), turns.end(),
            [](const TurningPoint& a, const TurningPoint& b) { return a.time < b.time; });
  return turns;
}

CutForces StationHistory::at(Time time) const {
  const auto& instants = *loads_;
  Time within = time;
  if (closed()) {
    within -= period() * std::floor((time - instants.begin()) / period());
  }
  // The nearest instant; of two of a break, the one on whose side the time is.
  std::size_t low = 0;
  std::size_t high = samples_.size();
  while (high - low > 1) {
    const std::size_t half = (low + high) / 2;
    (instants.time_of(half) <= within ? low : high) = half;
  }
  const auto is_in = [&](std::size_t instant) {
    const LoadHistory::Reach reach = instants.reach_of(instant);
    return within >= reach.from && within <= reach.to;
  };
  std::size_t instant = low;
  if (instants.time_of(low) != within && low + 1 < samples_.size()) {
    const bool nearer = instants.time_of(low + 1) - within < within - instants.time_of(low);
    if ((nearer && is_in(low + 1)) || !is_in(low)) instant = low + 1;
  }
  if (instants.time_of(instant) == within) return samples_[instant];
  if (instants.is_recorded()) return instants.diagram_at(within).at(station_);
  const double at = within.value();
  const std::vector<Piece>& pieces = pieces_of(instant);
  for (const Piece& piece : pieces) {
    if (at > piece.to) continue;
    if (at <= piece.from) return piece.at.front();
    if (piece.jump) {
      std::size_t nearest = 0;
      for (std::size_t k = 1; k <= last_node; ++k) {
        const double here = std::abs(BracketPoints::between(piece.from, piece.to, k) - at);
        if (here < std::abs(BracketPoints::between(piece.from, piece.to, nearest) - at))
          nearest = k;
      }
      return piece.at[nearest];
    }
    return interpolate(piece.at, (2.0 * at - piece.from - piece.to) / (piece.to - piece.from));
  }
  return pieces.empty() ? samples_[instant] : pieces.back().at.back();
}

TurningPoint StationHistory::largest(const CutForceFunction& f) const {
  const std::size_t n = samples_.size();
  std::vector<double> values;
  values.reserve(n);
  add_values(f, samples_, values);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto highest = static_cast<std::size_t>(high - values.begin());
  const double noise = noise_between(*low, *high);
  TurningPoint best{loads_->time_of(highest), values[highest], true};
  // Peaks a little lower at the instants may be higher between them.
  const double enough = *high - 0.05 * (*high - *low);
  constexpr double outside = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? values[i - 1] : (closed() ? values[n - 1] : outside);
    const double behind = i + 1 < n ? values[i + 1] : (closed() ? values[0] : outside);
    if (!(values[i] >= before && values[i] > behind) || values[i] < enough) continue;
    const TurningPoint found = refine(i, true, f, noise);
    if (found.value > best.value) best = found;
  }
  for (const Passage& passage : passages()) {
    for (const bool behind : {false, true}) {
      if (f(behind ? passage.behind : passage.before) < enough) continue;
      const TurningPoint found = refine(passage, behind, true, f);
      if (found.value > best.value) best = found;
    }
  }
  return best;
}

}  // namespace boxbeam
