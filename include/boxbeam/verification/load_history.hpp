#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/core/units.hpp"
#include "boxbeam/mechanism/recorded/channel_loads.hpp"
#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam {

class WholeLife;

/// The loads on the beam at any time of a period, whatever gives them.
using LoadsAt = std::function<BeamLoads(Time)>;

/// The time over which loads are looked at.
struct LoadSpan {
  Time begin;
  Time period;
  std::size_t instants = 0;  ///< equal steps of it
  bool closed = true;        ///< it repeats; else its end is an instant of its own
  /// Times in it at which the loads may jump or bend, ascending: points of tables, ends of smooth
  /// steps.
  std::vector<Time> breaks = {};
};

/// The cut forces over one period: at the ends of equal steps and on both sides of every break, and
/// between neighbours of these at Chebyshev points where an extremum is looked for.
///
/// Of recorded loads: at their instants, between which they are linear, so that every extremum of
/// what is linear or convex in them stands at one. Nothing is solved or kept for each instant.
class LoadHistory {
 public:
  /// Nodes of one bracket, Chebyshev points of the second kind.
  static constexpr std::size_t nodes = 9;
  using Bracket = std::array<CutForceDiagram, nodes>;

  LoadHistory(const LoadSpan& span, LoadsAt loads_at);
  explicit LoadHistory(recorded::ChannelLoads loads);

  const LoadSpan& span() const { return span_; }
  bool is_recorded() const { return recorded_.has_value(); }
  Time period() const { return span_.period; }
  Time begin() const { return span_.begin; }
  bool closed() const { return span_.closed; }

  /// All instants that are looked at, ascending. Between two with a break they are not evenly
  /// spaced, and two stand at every break, one just before it, one just behind.
  std::size_t instants() const {
    return recorded_ ? recorded_->of.channels->times.size() : instants_.size();
  }
  Time time_of(std::size_t instant) const {
    return recorded_ ? si<Time>(recorded_->of.channels->times[instant]) : instants_[instant].time;
  }
  CutForceDiagram diagram(std::size_t instant) const;
  /// The same of a motion, whose diagrams are kept; not of recorded loads.
  const CutForceDiagram& kept_diagram(std::size_t instant) const {
    return instants_[instant].diagram;
  }

  /// Recorded loads only: their channels, and those of a long record behind them.
  const recorded::ChannelLoads& recorded_loads() const { return recorded_->of; }
  std::shared_ptr<const recorded::Channels> recorded_channels() const {
    return recorded_->of.channels;
  }
  /// Instants of the files, of which a long record has only some here.
  std::size_t recorded_instants() const {
    const recorded::Channels& of = *recorded_->of.channels;
    return of.record ? of.record->instants() : of.times.size();
  }
  /// The cut forces of a station that do not change, then those of each channel for a value of one.
  std::vector<CutForces> unit_cuts_at(const Station& station) const;

  /// What counts the cycles of long records of this case; nothing where every instant is here.
  const std::shared_ptr<WholeLife>& whole() const { return whole_; }
  void count_by(std::shared_ptr<WholeLife> whole) { whole_ = std::move(whole); }

  /// The cut forces of a station at all instants.
  std::vector<CutForces> cuts_at(const Station& station) const;

  /// Those at the ends of equal steps (for Fourier series, and to compare two histories), of an
  /// open history with its end; where a break is, the one behind it.
  std::size_t even_instants() const { return even_.size(); }
  const CutForceDiagram& even_diagram(std::size_t k) const { return instants_[even_[k]].diagram; }

  /// Whether loads may jump or bend between an instant and the one before it; at the begin of an
  /// open history they do.
  bool begins_piece(std::size_t instant) const { return recorded_ || instants_[instant].begins; }

  /// From the instant before to the one behind, as far as nothing jumps or bends: what an extremum
  /// near an instant lies in. Of a history that repeats it may reach beyond its begin or end.
  struct Reach {
    Time from, to;
  };
  Reach reach_of(std::size_t instant) const;

  /// Diagrams at the Chebyshev points between two times; solved when first asked for.
  const Bracket& bracket(const Reach& reach) const;

  /// Exact diagram at a time, solved anew.
  CutForceDiagram diagram_at(Time time) const;
  BeamLoads loads_at(Time time) const { return loads_at_(time); }

  /// Largest force and moment anywhere at the instants, below a part of which all is round-off.
  double largest_force() const { return largest_force_; }
  double largest_moment() const { return largest_moment_; }

 private:
  struct Instant {
    Time time;
    CutForceDiagram diagram;
    bool begins = false;
  };
  struct Recorded {
    recorded::ChannelLoads of;
    CutForceDiagram constant;
    std::vector<CutForceDiagram> units;
  };
  Time even_time(std::size_t k) const;
  void add_instants();
  void look_at(const CutForceDiagram& diagram);

  LoadSpan span_;
  LoadsAt loads_at_;
  std::optional<Recorded> recorded_;
  std::shared_ptr<WholeLife> whole_;
  std::vector<Instant> instants_;
  std::vector<std::size_t> even_;
  double largest_force_ = 0.0, largest_moment_ = 0.0;
  mutable std::map<std::pair<double, double>, Bracket> brackets_;
};

/// A scalar of the cut forces: one of them, or a stress they cause.
using CutForceFunction = std::function<double(const CutForces&)>;

/// A maximum or minimum over time.
struct TurningPoint {
  Time time;
  double value = 0.0;
  bool maximum = true;
};

/// The cut forces of one station over the period.
class StationHistory {
 public:
  StationHistory(const LoadHistory& loads, const Station& station);

  const Station& station() const { return station_; }
  const LoadHistory& loads() const { return *loads_; }
  Time period() const { return loads_->period(); }
  bool closed() const { return loads_->closed(); }
  Time time_of(std::size_t instant) const { return loads_->time_of(instant); }
  const std::vector<CutForces>& samples() const { return samples_; }

  /// A load slides over the station between an instant and the one before it: the cut forces just
  /// before that and just behind.
  struct Passage {
    std::size_t instant;
    Time time;
    CutForces before, behind;
  };
  /// In order of time. A load that passes twice between two instants is not seen.
  const std::vector<Passage>& passages() const;

  /// Whether the loads may jump or bend between an instant and the one before it.
  bool begins_piece(std::size_t instant) const { return loads_->begins_piece(instant); }

  /// The turning points of `f` in order of time. Each is bracketed by instants between which
  /// nothing is known to jump or bend and found by Brent's method on the cut forces interpolated
  /// through the Chebyshev points of the bracket (degree 8: for a smooth motion the interpolation
  /// is at round-off). A load that slides over the station divides a bracket, and what is on either
  /// side of that is looked at like instants; one that the
  /// polynomial does not describe, for what happens in it is known to nobody before, is halved
  /// until it does. Waves smaller than 1e-9 of the whole are round-off and left out; a constant has
  /// one turning point.
  std::vector<TurningPoint> turning_points(const CutForceFunction& f) const;

  /// The largest value of `f` over the period, found the same way.
  TurningPoint largest(const CutForceFunction& f) const;

  /// Cut forces at any time of the period, interpolated like the turning points.
  CutForces at(Time time) const;

 private:
  using Nodes = std::array<CutForces, LoadHistory::nodes>;
  /// Cut forces between two times as one polynomial; of a `jump`, narrower than matters or beyond
  /// description, only what they are at the nodes.
  struct Piece {
    double from = 0.0, to = 0.0;  ///< [s]
    Nodes at;
    bool jump = false;
  };
  const std::vector<Piece>& pieces_of(std::size_t instant) const;
  std::optional<Passage> passage_of(std::size_t border, const LoadHistory::Reach& within,
                                    bool forwards) const;
  void divide_at_passages(const LoadHistory::Reach& reach, std::vector<Piece>& pieces) const;
  void add_smooth(const Piece& piece, int halvings, bool keep, std::vector<Piece>& pieces) const;
  Piece piece_between(double from, double to, bool keep) const;
  std::vector<Passage> find_passages() const;
  /// The larger one of what is known and what is in a piece; `own`: the time of an instant.
  void look_in(const Piece& piece, double own, double sign, const CutForceFunction& f,
               Extremum& best) const;
  Extremum extremum_near(std::size_t instant, double sign, const CutForceFunction& f) const;
  /// On one side of a passage, up to the instant there.
  TurningPoint refine(const Passage& passage, bool behind, bool maximum,
                      const CutForceFunction& f) const;
  TurningPoint turning_point_of(const Extremum& found, bool maximum) const;
  TurningPoint refine(std::size_t instant, bool maximum, const CutForceFunction& f,
                      double noise) const;

  const LoadHistory* loads_;
  Station station_;
  std::vector<CutForces> samples_;
  double force_floor_ = 0.0, moment_floor_ = 0.0;  ///< of what the polynomials leave out
  mutable std::map<std::size_t, std::vector<Piece>> pieces_;
  mutable std::optional<std::vector<Passage>> passages_;
};

}  // namespace boxbeam
