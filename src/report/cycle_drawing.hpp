#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/cycle_figure.hpp"
#include "drawing.hpp"

/// What a page shows of a cycle: drawings of the mechanism at each instant, and the paper on which
/// the cut forces along the beam are drawn. The page only takes one for the other.
namespace boxbeam::plot {

/// The mechanism seen from one side, over the cycle on one scale.
struct MovingView {
  std::string name;  ///< "" where there is one view only
  Drawing back;      ///< what stands still: a length to measure by, in space the axes
  std::vector<Drawing>
      frames;  ///< with the loads on the beam; its axis is the first line of "beam"
};

/// One view of a mechanism in the plane x-y, four of one in space.
std::vector<MovingView> moving_views_of(const CycleFigure& cycle);

/// Whether anything leaves the plane x-y.
bool is_in_space(const CycleFigure& cycle);

/// A quantity along the beam over the cycle: what its diagram must hold.
struct AlongBeam {
  std::string name;               ///< with its unit
  std::vector<double> low, high;  ///< at the stations, in the unit of its name
};

/// Diagrams below each other, without a curve in them yet.
struct DiagramPaper {
  Drawing back;           ///< axes, and between which values each quantity stays
  std::vector<double> x;  ///< of the stations [px]
  struct Scale {
    double zero;      ///< height of the value zero [px]
    double per_unit;  ///< [px]
  };
  std::vector<Scale> scales;
};

DiagramPaper diagram_paper(const std::vector<double>& stations,
                           const std::vector<AlongBeam>& quantities);

}  // namespace boxbeam::plot
