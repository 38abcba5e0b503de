#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"

namespace boxbeam {

/// What one joint or load does to the beam at a critical instant.
struct BeamLoadRow {
  Time time;
  std::size_t situation = 0;  ///< index in the case
  std::string name;           ///< of the joint or load; of what has none the beam's point there
  Length s;
  Eigen::Vector3d world = Eigen::Vector3d::Zero();   ///< force, world axes [N]
  Eigen::Vector3d couple = Eigen::Vector3d::Zero();  ///< the moment below, world axes [N m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< beam axes [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the axis point at s, beam axes [N m]
  Eigen::Vector3d place = Eigen::Vector3d::Zero();   ///< where it acts, as in the posture [m]
};

/// The places of all bodies' points at an instant, for the drawing; world axes. In the plane z is
/// zero. In space the origin is the joint that carries the beam's body, for the world's may be far
/// away, and only the bodies that the same body carries are shown, and what they carry.
struct PostureFigure {
  Time time;
  std::string why;        ///< "largest M", with the situation
  double weight = 0.0;    ///< how telling: see ShownInstant
  std::string situation;  ///< its name, "" where the case has only one
  struct Stroke {
    Eigen::Vector3d from, to;  ///< [m]
  };
  struct Line {
    bool beam = false;
    std::vector<Eigen::Vector3d> points;  ///< of the body [m]
    std::vector<Stroke> strokes;          ///< beam: its axis, with spurs to what stands off it;
                                          ///< in space also from a body's joint to its points
  };
  std::vector<Line> bodies;
  std::vector<Stroke> rods;              ///< rods without mass and driven lengths
  std::vector<Stroke> guides;            ///< of sliders, axes of joints: a point and a unit vector
  std::vector<Eigen::Vector3d> grounds;  ///< bearings on the ground
  std::vector<BeamLoadRow> loads;
  double magnified = 0.0;  ///< so many times displacements are drawn; zero: no elastic links
};

/// What the joints and loads do to the beam, without their places. `R_WS`: columns are the beam's
/// axes in the world.
std::vector<BeamLoadRow> load_rows(const BeamLoads& loads, Time time, const Eigen::Matrix3d& R_WS);

}  // namespace boxbeam
