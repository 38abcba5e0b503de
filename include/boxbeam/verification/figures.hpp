#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

/// What the report draws, as numbers: the report itself computes nothing.
namespace boxbeam {

/// Cut forces along the beam at one instant, two points at every jump.
struct CutForceLine {
  Time time;
  std::string why;  ///< "largest M", in a case of several situations with its name
  std::vector<Station> stations;
  std::vector<CutForces> values;
};

/// The cut forces of one station over the time of every situation that runs.
struct LoadsOverTime {
  struct Line {
    std::size_t situation = 0;  ///< index in the case
    std::vector<Time> times;
    std::vector<CutForces> values;
  };
  Station station;
  std::vector<Line> lines;
};

/// The governing fatigue strength line and working point, for the S-N diagram.
struct SnFigure {
  /// A curve that resists at other places of the beam.
  struct Other {
    std::string name;
    double reference = 0.0;
    std::vector<double> spectrum;
  };
  std::string code, name;  ///< of the curve
  double reference = 0.0;  ///< its strength at 2e6 cycles [Pa]
  bool published_step = false;
  std::vector<double> cycles;
  std::vector<double> spectrum;            ///< strength [Pa] at these cycles
  std::vector<double> constant_amplitude;  ///< likewise
  double knee = 0.0, cut_off = 0.0;        ///< [Pa]
  std::vector<Other> others;               ///< each once, the strongest first
  /// Cycles in the wanted life and range [Pa], partial factors applied, per row of the spectrum.
  std::vector<std::pair<double, double>> working;
  double required = 1.0;
};

CutForceLine cut_force_line(const SituationRun& run, Time time, const std::string& why);

/// Smallest and largest N, V and M along the beam over the instants of all situations.
std::vector<CutForceLine> envelope_lines(const std::deque<SituationRun>& runs);

LoadsOverTime loads_over_time(const Project& project, const std::deque<SituationRun>& runs,
                              const Station& station);

SnFigure sn_figure(const Project& project, const CheckResult& governing,
                   const std::vector<CheckResult>& checks);

}  // namespace boxbeam
