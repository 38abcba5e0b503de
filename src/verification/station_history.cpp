#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/turning_samples.hpp"
#include "bracket_nodes.hpp"

namespace boxbeam {
namespace {

/// Halvings of a bracket that one polynomial does not describe: a millionth is left of it.
constexpr int most_halvings = 20;

/// How many borders of pieces lie before a station, seen from its side: changes where a load slides
/// over it.
std::size_t borders_before(const CutForceDiagram& diagram, const Station& station) {
  const auto beyond = std::partition_point(
      diagram.pieces.begin(), diagram.pieces.end(), [&](const CutForcePiece& piece) {
        return piece.end() < station.s ||
               (piece.end() == station.s && station.side != Side::before);
      });
  return static_cast<std::size_t>(beyond - diagram.pieces.begin());
}

/// Where a border of pieces lies. A load that comes or goes leaves fewer of them: the last one.
Length border_of(const CutForceDiagram& diagram, std::size_t border) {
  return diagram.pieces[std::min(border, diagram.pieces.size() - 1)].end();
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

bool StationHistory::is_described(const Nodes& at) const {
  return defect_of(at, force_floor_, moment_floor_) <= 1.0;
}

StationHistory::Piece StationHistory::piece_between(double from, double to, bool keep) const {
  Piece piece{from, to, {}, false};
  if (keep) {
    const LoadHistory::Bracket& bracket = loads_->bracket({si<Time>(from), si<Time>(to)});
    for (std::size_t k = 0; k <= last_node; ++k) piece.at[k] = bracket[k].at(station_);
    return piece;
  }
  for (std::size_t k = 0; k <= last_node; ++k) {
    piece.at[k] = loads_->diagram_at(si<Time>(BracketPoints::between(from, to, k))).at(station_);
  }
  return piece;
}

void StationHistory::add_smooth(const Piece& piece, int halvings, bool keep,
                                std::vector<Piece>& pieces) const {
  const double defect = defect_of(piece.at, force_floor_, moment_floor_);
  if (defect <= 1.0) {
    pieces.push_back(piece);
    return;
  }
  if (halvings == 0) {
    pieces.push_back(piece);
    pieces.back().jump = true;
    return;
  }
  const double middle = 0.5 * (piece.from + piece.to);
  const Piece left = piece_between(piece.from, middle, keep);
  const Piece right = piece_between(middle, piece.to, keep);
  // A bend or a jump is in one of the halves, and a bend is half as large there; where both halves
  // are as rough as the whole, halving on would not end. What is small is the rounding of loads
  // that were solved for: the polynomial passes through its middle. Else only the nodes are known.
  constexpr double better = 1.5;
  constexpr double small = 100.0;
  const double least = std::min(defect_of(left.at, force_floor_, moment_floor_),
                                defect_of(right.at, force_floor_, moment_floor_));
  if (least > defect / better) {
    pieces.push_back(piece);
    pieces.back().jump = defect > small;
    return;
  }
  add_smooth(left, halvings - 1, keep, pieces);
  add_smooth(right, halvings - 1, keep, pieces);
}

void StationHistory::divide_at_passages(const LoadHistory::Reach& reach,
                                        std::vector<Piece>& pieces) const {
  const LoadHistory::Bracket& bracket = loads_->bracket(reach);
  const double begin = reach.from.value();
  const double end = reach.to.value();
  double from = begin;
  const auto add = [&](double to) {
    if (to > from) add_smooth(piece_between(from, to, false), most_halvings / 2, false, pieces);
  };
  for (std::size_t k = 1; k <= last_node; ++k) {
    const std::size_t before = borders_before(bracket[k - 1], station_);
    const std::size_t behind = borders_before(bracket[k], station_);
    if (behind == before) continue;
    double low = BracketPoints::between(begin, end, k - 1);
    double high = BracketPoints::between(begin, end, k);
    const std::size_t border = std::min(before, behind);
    double left = (border_of(bracket[k - 1], border) - station_.s).value();
    double beyond = (station_.s - border_of(bracket[k], border)).value();
    const auto look_at = [&](double time) {
      if (!(time > low && time < high)) return;
      const CutForceDiagram at = loads_->diagram_at(si<Time>(time));
      const double to_go = (border_of(at, border) - station_.s).value();
      const bool lies_before = borders_before(at, station_) == before;
      (lies_before ? low : high) = time;
      (lies_before ? left : beyond) = lies_before ? to_go : -to_go;
    };
    // At even speed it passes here, but for rounding; else as far again on from where this leads.
    constexpr int most = 12;
    for (int i = 0; i < most && left * beyond > 0.0; ++i) {
      const double speed = (left + beyond) / (high - low), passed = low + left / speed;
      const double aside = 1e-14 * std::max(std::abs(low), std::abs(high));
      look_at(passed - aside);
      look_at(passed + aside);
      if (high - low <= 4.0 * aside) break;
      if (high <= passed + aside)
        look_at(high - 2.0 * beyond / speed);
      else if (low >= passed - aside)
        look_at(low + 2.0 * left / speed);
    }
    // To the last time before and the first behind: the same from whichever instants it is found,
    // so that an extremum on one side of it is looked up there.
    for (double half = 0.5 * (low + high); half > low && half < high; half = 0.5 * (low + high))
      look_at(half);
    add(low);
    from = high;
  }
  add(end);
}

const std::vector<StationHistory::Passage>& StationHistory::passages() const {
  if (!passages_) passages_ = find_passages();
  return *passages_;
}

std::vector<StationHistory::Passage> StationHistory::find_passages() const {
  std::vector<Passage> found;
  if (loads_->is_recorded()) return found;  // their places never change
  const std::size_t n = loads_->instants();
  const auto borders_at = [&](std::size_t instant) {
    return borders_before(loads_->kept_diagram(instant), station_);
  };
  std::size_t to = borders_at(closed() ? n - 1 : 0);
  for (std::size_t i = closed() ? 0 : 1; i < n; ++i) {
    const std::size_t previous = i > 0 ? i - 1 : n - 1, from = to;
    to = borders_at(i);
    if (from == to || loads_->begins_piece(i)) continue;
    const Time begin = loads_->time_of(previous) - (i > 0 ? Time{} : loads_->period());
    const std::size_t first = found.size();
    for (std::size_t border = std::min(from, to); border < std::max(from, to); ++border) {
      if (auto passage = passage_of(border, {begin, loads_->time_of(i)}, from > to)) {
        passage->instant = i;
        found.push_back(*passage);
      }
    }
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
              [](const Passage& a, const Passage& b) { return a.time < b.time; });
  }
  return found;
}

std::optional<StationHistory::Passage> StationHistory::passage_of(std::size_t border,
                                                                  const LoadHistory::Reach& within,
                                                                  bool forwards) const {
  // How far the border still has to go, below zero when it has passed. Which border it is is told
  // by their order, which changes where a load slides over one that stays: there this has a kink,
  // and where that one is the station itself, a level.
  constexpr double least = 1e-300;
  const auto left_in = [&](const CutForceDiagram& diagram) {
    const std::size_t count = borders_before(diagram, station_);
    const bool passed = forwards ? count <= border : count > border;
    const Length to_go = border_of(diagram, border) - station_.s;
    const double left = std::max(std::abs(to_go.value()), least);
    return passed ? -left : left;
  };
  const LoadHistory::Bracket& bracket = loads_->bracket(within);
  std::array<double, LoadHistory::nodes> left{};
  std::transform(bracket.begin(), bracket.end(), left.begin(), left_in);
  std::size_t k = 1;
  while (k < last_node && left[k] > 0.0) ++k;
  if (left[k - 1] < 0.0 || left[k] > 0.0) return std::nullopt;

  const double begin = within.from.value(), end = within.to.value();
  const auto time_at = [&](double u) {
    return si<Time>(0.5 * (begin + end) + 0.5 * (end - begin) * u);
  };
  // On either side of the passage, this near; nearer, what stands beside a border counts as on it.
  constexpr double near = 1e-5;
  CutForceDiagram before, behind;
  const auto look_at = [&](double u) {
    CutForceDiagram at = loads_->diagram_at(time_at(u));
    const double value = left_in(at);
    (value > 0.0 ? before : behind) = std::move(at);
    return value;
  };
  double low = BracketPoints::point(k - 1), high = BracketPoints::point(k);
  constexpr int bisections = 32;
  for (int i = 0; i < bisections; ++i) {
    const double half = 0.5 * (low + high);
    (interpolate(left, half) > 0.0 ? low : high) = half;
  }
  double passed_at = low;
  if (!(look_at(low - near) > 0.0 && look_at(low + near) < 0.0)) {
    std::uintmax_t most = 100;
    const auto [from, to] = boost::math::tools::toms748_solve(
        look_at, BracketPoints::point(k - 1), BracketPoints::point(k), left[k - 1], left[k],
        [](double a, double b) { return b - a <= near; }, most);
    passed_at = 0.5 * (from + to);
    if (!(look_at(from - near) > 0.0 && look_at(to + near) < 0.0)) return std::nullopt;
  }
  return Passage{0, time_at(passed_at), before.at(station_), behind.at(station_)};
}

const std::vector<StationHistory::Piece>& StationHistory::pieces_of(std::size_t instant) const {
  const auto found = pieces_.find(instant);
  if (found != pieces_.end()) return found->second;
  std::vector<Piece> pieces;
  const LoadHistory::Reach reach = loads_->reach_of(instant);
  const LoadHistory::Bracket& bracket = loads_->bracket(reach);
  const bool passage =
      std::any_of(bracket.begin(), bracket.end(), [&](const CutForceDiagram& diagram) {
        return borders_before(diagram, station_) != borders_before(bracket[0], station_);
      });
  if (passage) {
    divide_at_passages(reach, pieces);
  } else if (reach.to > reach.from) {
    add_smooth(piece_between(reach.from.value(), reach.to.value(), true), most_halvings, true,
               pieces);
  }
  return pieces_.emplace(instant, std::move(pieces)).first->second;
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
  std::vector<double> values;
  std::vector<Looked> looked;
  const auto add = [&](const CutForces& cut, const Looked& at) {
    values.push_back(f(cut));
    looked.push_back(at);
  };
  const std::vector<Passage>& passed = passages();
  values.reserve(samples_.size() + 2 * passed.size());
  looked.reserve(samples_.size() + 2 * passed.size());
  auto passage = passed.begin();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    for (; passage != passed.end() && passage->instant == i; ++passage) {
      add(passage->before, {i, &*passage, false});
      add(passage->behind, {i, &*passage, true});
    }
    add(samples_[i], {i});
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double noise = noise_between(*low, *high);
  const auto refined = [&](std::size_t sample, bool maximum) {
    const Looked& of = looked[sample];
    return of.passage != nullptr ? refine(*of.passage, of.behind, maximum, f)
                                 : refine(of.instant, maximum, f, noise);
  };
  const TurningSamples found = turning_samples_of(values);
  if (found.turns.empty()) {
    return {{loads_->time_of(looked[found.highest].instant), values[found.highest], true}};
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
  std::vector<double> values(n);
  std::transform(samples_.begin(), samples_.end(), values.begin(), f);
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
