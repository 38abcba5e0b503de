#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/core/units.hpp"
#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam {

/// The loads on the beam at any time of a period, whatever gives them.
using LoadsAt = std::function<BeamLoads(Time)>;

/// The time over which loads are looked at.
struct LoadSpan {
  Time begin;
  Time period;
  std::size_t instants = 0;  ///< equal steps of it
  bool closed = true;        ///< it repeats; else its end is an instant of its own
};

/// The cut forces over one period: at equally spaced instants, and between three neighbours of
/// them at Chebyshev points where an extremum is looked for.
class LoadHistory {
 public:
  /// Nodes of one bracket, Chebyshev points of the second kind over two steps; three of them are
  /// the instants themselves.
  static constexpr std::size_t nodes = 9;
  using Bracket = std::array<CutForceDiagram, nodes>;

  LoadHistory(const LoadSpan& span, LoadsAt loads_at);

  Time period() const { return span_.period; }
  Time begin() const { return span_.begin; }
  bool closed() const { return span_.closed; }
  Time step() const { return span_.period / static_cast<double>(span_.instants); }
  std::size_t instants() const { return diagrams_.size(); }
  Time time_of(std::size_t instant) const;
  const CutForceDiagram& diagram(std::size_t instant) const { return diagrams_[instant]; }

  /// The instant itself, or where an open history ends its neighbour, so that it has two
  /// neighbours.
  std::size_t middle_near(std::size_t instant) const;

  /// Diagrams from the instant before `middle` to the one behind it; solved when first asked for.
  const Bracket& bracket(std::size_t middle) const;

  /// Exact diagram at a time, solved anew.
  CutForceDiagram diagram_at(Time time) const { return cut_forces_of(loads_at_(time)); }
  BeamLoads loads_at(Time time) const { return loads_at_(time); }

 private:
  LoadSpan span_;
  LoadsAt loads_at_;
  std::vector<CutForceDiagram> diagrams_;
  mutable std::map<std::size_t, Bracket> brackets_;
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
  Time period() const { return loads_->period(); }
  bool closed() const { return loads_->closed(); }
  Time time_of(std::size_t instant) const { return loads_->time_of(instant); }
  const std::vector<CutForces>& samples() const { return samples_; }

  /// The turning points of `f` in order of time. Each is bracketed by three instants and found by
  /// Brent's method on the cut forces interpolated through the Chebyshev points of the bracket
  /// (degree 8: for a smooth motion the interpolation is at round-off). Waves smaller than 1e-9 of
  /// the whole are round-off and left out; a constant has one turning point. A load that slides
  /// over the station in a bracket divides it.
  std::vector<TurningPoint> turning_points(const CutForceFunction& f) const;

  /// The largest value of `f` over the period, found the same way.
  TurningPoint largest(const CutForceFunction& f) const;

  /// Cut forces at any time of the period, interpolated like the turning points.
  CutForces at(Time time) const;

 private:
  using Nodes = std::array<CutForces, LoadHistory::nodes>;
  Nodes nodes_of(std::size_t middle) const;
  TurningPoint refine(std::size_t instant, bool maximum, const CutForceFunction& f) const;
  /// The same where a load slides over the station in the bracket: cut forces jump or bend there,
  /// and the extremum is at a node or just before or behind the passage.
  Extremum extremum_at_passage(std::size_t middle, const Nodes& nodes, double sign,
                               const CutForceFunction& f) const;

  const LoadHistory* loads_;
  Station station_;
  std::vector<CutForces> samples_;
};

}  // namespace boxbeam
