#include "boxbeam/verification/load_history.hpp"

#include <algorithm>
#include <cassert>

#include "bracket_nodes.hpp"

namespace boxbeam {
namespace {

/// How far before and behind a break its two instants stand, by the time looked at: more than
/// rounding can take back, less than a load can change in.
constexpr double beside_break = 1e-12;

/// Brackets kept for other stations; beyond, they are solved anew.
constexpr std::size_t most_brackets = 8192;
/// Pieces of diagrams in all brackets that are kept: about two gigabytes.
constexpr std::size_t most_kept_pieces = 8'000'000;

/// Stretches of loads that are kept at instants: about a hundred megabytes.
constexpr std::size_t most_kept_stretches = 300'000;

/// Loads known at some ascending times, found anew at all others: what is asked of every instant is
/// asked by several.
class KeptLoads {
 public:
  KeptLoads(std::vector<double> times, std::vector<BeamLoads> loads, LoadsAt others)
      : times_(std::move(times)), loads_(std::move(loads)), others_(std::move(others)) {}

  BeamLoads operator()(Time time) const {
    const auto known = std::lower_bound(times_.begin(), times_.end(), time.value());
    if (known == times_.end() || *known != time.value()) return others_(time);
    return loads_[static_cast<std::size_t>(known - times_.begin())];
  }

 private:
  std::vector<double> times_;
  std::vector<BeamLoads> loads_;
  LoadsAt others_;
};

/// The two instants of a break, between which nothing is looked at.
struct Gap {
  Time before, behind;
};

}  // namespace

LoadHistory::LoadHistory(const LoadSpan& span, LoadsAt loads_at)
    : span_(span), loads_at_(std::move(loads_at)) {
  assert(span.instants >= 2);
  add_instants();
  std::vector<double> times;
  std::vector<BeamLoads> kept;
  std::size_t stretches = 0;
  for (Instant& instant : instants_) {
    BeamLoads loads = loads_at_(instant.time);
    instant.diagram = cut_forces_of(loads);
    look_at(instant.diagram);
    stretches += loads.lines.size() + loads.points.size();
    if (stretches > most_kept_stretches) continue;
    times.push_back(instant.time.value());
    kept.push_back(std::move(loads));
  }
  // The function is copied where it is handed on, what it keeps is not.
  loads_at_ = [known = std::make_shared<const KeptLoads>(std::move(times), std::move(kept),
                                                         std::move(loads_at_))](Time time) {
    return (*known)(time);
  };
}

LoadHistory::LoadHistory(recorded::ChannelLoads loads)
    : recorded_(Recorded{std::move(loads), {}, {}}) {
  const recorded::ChannelLoads& of = recorded_->of;
  const std::vector<double>& times = of.channels->times;
  span_ = {si<Time>(times.front()), si<Time>(times.back() - times.front()), times.size() - 1,
           false};
  loads_at_ = [of](Time time) { return recorded::loads_at(of, time.value()); };
  recorded_->constant = cut_forces_of(of.constant);
  for (const BeamLoads& unit : of.units) recorded_->units.push_back(cut_forces_of(unit));
  for (std::size_t i = 0; i < times.size(); ++i) look_at(diagram(i));
}

void LoadHistory::look_at(const CutForceDiagram& diagram) {
  for (const CutForcePiece& piece : diagram.pieces) {
    for (const Side side : {Side::before, Side::behind}) {
      const Length s = side == Side::behind ? piece.start : piece.end();
      const CutForces cut = diagram.at({s, side});
      largest_force_ = std::max(largest_force_, force_in(cut));
      largest_moment_ = std::max(largest_moment_, moment_in(cut));
    }
  }
}

CutForceDiagram LoadHistory::diagram(std::size_t instant) const {
  if (!recorded_) return instants_[instant].diagram;
  CutForceDiagram diagram = recorded_->constant;
  const std::vector<std::vector<double>>& values = recorded_->of.channels->values;
  for (std::size_t k = 0; k < values.size(); ++k)
    recorded::add(diagram, values[k][instant], recorded_->units[k]);
  return diagram;
}

CutForceDiagram LoadHistory::diagram_at(Time time) const {
  if (!recorded_) return cut_forces_of(loads_at_(time));
  CutForceDiagram diagram = recorded_->constant;
  const std::vector<double> values = recorded::values_at(*recorded_->of.channels, time.value());
  for (std::size_t k = 0; k < values.size(); ++k)
    recorded::add(diagram, values[k], recorded_->units[k]);
  return diagram;
}

std::vector<CutForces> LoadHistory::unit_cuts_at(const Station& station) const {
  std::vector<CutForces> cuts{recorded_->constant.at(station)};
  for (const CutForceDiagram& unit : recorded_->units) cuts.push_back(unit.at(station));
  return cuts;
}

std::vector<CutForces> LoadHistory::cuts_at(const Station& station) const {
  std::vector<CutForces> cuts;
  cuts.reserve(instants());
  if (!recorded_) {
    std::size_t piece = 0;
    for (const Instant& instant : instants_) cuts.push_back(instant.diagram.at(station, piece));
    return cuts;
  }
  cuts.assign(instants(), recorded_->constant.at(station));
  for (std::size_t k = 0; k < recorded_->units.size(); ++k) {
    const CutForces of_one = recorded_->units[k].at(station);
    const std::vector<double>& values = recorded_->of.channels->values[k];
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      cuts[i].N += values[i] * of_one.N;
      cuts[i].V_y += values[i] * of_one.V_y;
      cuts[i].V_z += values[i] * of_one.V_z;
      cuts[i].T += values[i] * of_one.T;
      cuts[i].M_y += values[i] * of_one.M_y;
      cuts[i].M_z += values[i] * of_one.M_z;
    }
  }
  return cuts;
}

Time LoadHistory::even_time(std::size_t k) const {
  // Rounded as the motion rounds it, so that the motion's own instants are met exactly.
  return span_.begin + span_.period * static_cast<double>(k) / static_cast<double>(span_.instants);
}

void LoadHistory::add_instants() {
  const Time aside = beside_break * (abs(span_.begin) + span_.period);
  const Time end = span_.begin + span_.period;
  const std::size_t even = span_.instants + (span_.closed ? 0 : 1);
  bool at_begin = !span_.closed;  // whether the loads break there
  std::vector<Gap> gaps;
  for (const Time& at : span_.breaks) {
    const bool at_end = abs(at - end) <= 2.0 * aside;
    if (abs(at - span_.begin) <= 2.0 * aside || (at_end && span_.closed)) at_begin = true;
    // Of an open history the end is as it is.
    if (at <= span_.begin + 2.0 * aside || at >= end - 2.0 * aside) continue;
    if (gaps.empty() || at - gaps.back().behind > 4.0 * aside)
      gaps.push_back({at - aside, at + aside});
  }

  std::size_t k = 0;
  const auto add_piece = [&](Time from, Time until, bool begins, bool with_end) {
    std::vector<Time> within;
    while (k < even && even_time(k) <= from + aside) ++k;
    for (; k < even && even_time(k) < until - aside; ++k) within.push_back(even_time(k));
    // Of a short piece some are added: an extremum within it must be seen.
    constexpr std::size_t fewest = 3;
    constexpr std::size_t most_filled = 2000;
    if (within.size() < fewest && gaps.size() < most_filled) {
      const std::size_t known = within.size();
      for (const double share : {0.25, 0.5, 0.75}) {
        const Time at = from + share * (until - from);
        const bool near_known =
            std::any_of(within.begin(), within.begin() + static_cast<std::ptrdiff_t>(known),
                        [&](Time other) { return abs(other - at) < 0.1 * (until - from); });
        if (!near_known) within.push_back(at);
      }
      std::sort(within.begin(), within.end());
    }
    instants_.push_back({from, {}, begins});
    for (const Time& time : within) instants_.push_back({time, {}, false});
    if (with_end) instants_.push_back({until, {}, false});
  };
  Time from = span_.begin;
  bool begins = at_begin;
  for (const Gap& gap : gaps) {
    add_piece(from, gap.before, begins, true);
    from = gap.behind;
    begins = true;
  }
  const bool breaks_at_end = span_.closed && at_begin;
  add_piece(from, breaks_at_end ? end - aside : end, begins, breaks_at_end || !span_.closed);

  for (std::size_t i = 0; i < even; ++i) {
    // The nearest instant: its own, or beside a break the one behind it.
    const auto behind =
        std::lower_bound(instants_.begin(), instants_.end(), even_time(i),
                         [](const Instant& instant, Time time) { return instant.time < time; });
    auto nearest = behind == instants_.end() ? behind - 1 : behind;
    if (nearest != instants_.begin() &&
        even_time(i) - (nearest - 1)->time < abs(nearest->time - even_time(i))) {
      --nearest;
    }
    even_.push_back(static_cast<std::size_t>(nearest - instants_.begin()));
  }
}

LoadHistory::Reach LoadHistory::reach_of(std::size_t instant) const {
  if (recorded_) return {time_of(instant), time_of(instant)};
  const std::size_t n = instants_.size();
  Reach reach{instants_[instant].time, instants_[instant].time};
  if (!instants_[instant].begins) {
    // The first of a history that repeats and does not break there.
    reach.from = instant > 0 ? instants_[instant - 1].time : instants_[n - 1].time - span_.period;
  }
  if (instant + 1 < n) {
    if (!instants_[instant + 1].begins) reach.to = instants_[instant + 1].time;
  } else if (span_.closed && !instants_.front().begins) {
    reach.to = instants_.front().time + span_.period;
  }
  return reach;
}

const LoadHistory::Bracket& LoadHistory::bracket(const Reach& reach) const {
  const std::pair key(reach.from.value(), reach.to.value());
  const auto found = brackets_.find(key);
  if (found != brackets_.end()) return found->second;
  const std::size_t pieces = instants_.front().diagram.pieces.size();
  const std::size_t most =
      std::min(most_brackets, most_kept_pieces / (nodes * std::max<std::size_t>(pieces, 1)) + 1);
  if (brackets_.size() >= most) brackets_.clear();
  Bracket bracket;
  for (std::size_t k = 0; k <= last_node; ++k) {
    const Time time = si<Time>(BracketPoints::between(key.first, key.second, k));
    Time within = time;
    if (span_.closed && time < span_.begin) within = time + span_.period;
    if (span_.closed && time >= span_.begin + span_.period) within = time - span_.period;
    const auto known =
        std::lower_bound(instants_.begin(), instants_.end(), within,
                         [](const Instant& instant, Time at) { return instant.time < at; });
    const bool is_instant = known != instants_.end() && known->time == within;
    bracket[k] = is_instant ? known->diagram : diagram_at(time);
  }
  return brackets_.emplace(key, std::move(bracket)).first->second;
}

}  // namespace boxbeam
