#pragma once

#include <Eigen/Core>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

/// What the report draws, as numbers: the report itself computes nothing.
namespace boxbeam {

/// Cut forces along the beam at one instant, two points at every jump.
struct CutForceLine {
  Time time;
  std::string why;  ///< "largest M", ...
  std::vector<Station> stations;
  std::vector<CutForces> values;
};

/// A joint's load on the beam at a critical instant.
struct BeamLoadRow {
  Time time;
  std::size_t situation = 0;  ///< index in the case
  std::string name;
  Length s;
  Eigen::Vector2d world = Eigen::Vector2d::Zero();  ///< force, world axes [N]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< beam axes [N]
  Moment couple;                                    ///< about y
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< where it acts, world [m]
};

/// The positions of all bodies' points at an instant, for the drawing.
struct PostureFigure {
  Time time;
  std::string why;
  struct Stroke {
    Eigen::Vector2d from, to;  ///< [m]
  };
  struct Line {
    std::vector<Eigen::Vector2d> points;  ///< of the body [m]
    std::vector<Stroke> strokes;          ///< the beam: its axis, with spurs to what stands off it
  };
  std::vector<Line> bodies;
  std::vector<Stroke> rods;              ///< rods without mass and driven lengths
  std::vector<Stroke> guides;            ///< of sliders: a point and its line's unit vector
  std::vector<Eigen::Vector2d> grounds;  ///< bearings on the ground
  std::vector<BeamLoadRow> loads;
};

/// The governing fatigue strength line and working point, for the S-N diagram.
struct SnFigure {
  std::string code, name;  ///< of the curve
  double reference = 0.0;  ///< its strength at 2e6 cycles [Pa]
  bool published_step = false;
  std::vector<double> cycles;
  std::vector<double> spectrum;            ///< strength [Pa] at these cycles
  std::vector<double> constant_amplitude;  ///< likewise
  double knee = 0.0, cut_off = 0.0;        ///< [Pa]
  /// Cycles in the wanted life and range [Pa], partial factors applied, per row of the spectrum.
  std::vector<std::pair<double, double>> working;
  double required = 1.0;
};

CutForceLine cut_force_line(const LoadHistory& loads, Time time, const std::string& why);

/// Smallest and largest N, V and M along the beam over the instants of all situations.
std::vector<CutForceLine> envelope_lines(const std::deque<SituationRun>& runs);

/// The joints' loads on the beam; `angle` is the beam's in the world [rad].
std::vector<BeamLoadRow> load_rows(const Project& project, const BeamLoads& loads, Time time,
                                   double angle);

PostureFigure posture_figure(const Project& project, const planar::Mechanism& mechanism,
                             const planar::State& state, const std::string& why);

/// Finds where loads act in a state: on the beam's axis, or at the body point of their name.
void place_loads(const Project& project, const planar::State& state,
                 std::vector<BeamLoadRow>& rows);

SnFigure sn_figure(const Project& project, const CheckResult& governing);

}  // namespace boxbeam
