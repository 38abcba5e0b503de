#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/animation.hpp"
#include "boxbeam/verification/figures.hpp"
#include "boxbeam/verification/posture.hpp"

namespace boxbeam {

/// The mechanism and its beam at one instant of a cycle.
struct CycleFrame {
  Time time;
  PostureFigure posture;          ///< with the loads on the beam; the same bodies in every frame
  std::vector<CutForces> values;  ///< at the stations of the cycle
};

/// When and where the governing check is worst.
struct CriticalFrame {
  CycleFrame frame;
  Station station;
  std::string check;  ///< what is checked there
};

/// One cycle of a situation, evenly divided, for a drawing that moves.
struct CycleFigure {
  std::string situation;  ///< "" where the case has only one
  bool repeats = true;    ///< behind the last frame comes the first; else the motion ends there
  /// Along the beam, two at every jump; the same for all frames.
  std::vector<Station> stations;
  std::vector<CycleFrame> frames;
  std::vector<CutForces> smallest, largest;  ///< over all frames, at the stations
  /// How it moves in space over this time; nothing in the plane.
  std::optional<Animation> scene = {};
  std::optional<CriticalFrame> critical = {};  ///< of a scene, in the situation that governs
};

/// What drives the mechanism, over the cycle.
struct DriverLine {
  std::string name;    ///< of the driver, or of the load where elastic links are driven by it
  bool turns = false;  ///< coordinate in rad, force in N m; else m and N
  std::vector<double> times;                          ///< [s]
  std::vector<double> position, speed, acceleration;  ///< of the driven coordinate, SI
  std::vector<double> force;  ///< that the driver exerts along its coordinate [N] or [N m]
};

/// A cross-section of the beam with what is checked in it.
struct SectionFigure {
  struct Point {
    std::string name;
    double y = 0.0, z = 0.0;   ///< [m], as the section is drawn
    double stress = 0.0;       ///< normal stress at the instant [Pa], concentration included
    double utilisation = 0.0;  ///< the largest of its checks
    bool governs = false;
  };
  struct Hole {
    double y = 0.0, z = 0.0;           ///< centre [m]
    double width = 0.0, height = 0.0;  ///< of the strip it takes out of the section [m]
  };
  struct Weld {
    double y = 0.0, z = 0.0;  ///< [m]
    std::string name;
  };
  struct Level {
    double z = 0.0;                      ///< [m]
    double highest = 0.0, lowest = 0.0;  ///< nominal stress there over the history [Pa]
  };
  Station station;
  Time time;  ///< of the governing check
  std::string situation;
  std::vector<std::vector<std::pair<double, double>>> outlines;  ///< closed, (y, z) [m]; holes of
                                                                 ///< the outline run clockwise
  std::vector<Point> points;
  std::vector<Hole> holes;
  std::vector<Weld> welds;
  std::vector<Level> across;  ///< normal stress over the height, worst of the width
};

}  // namespace boxbeam
