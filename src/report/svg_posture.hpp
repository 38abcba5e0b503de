#pragma once

#include <Eigen/Core>
#include <string>

#include "boxbeam/verification/cycle_figure.hpp"

/// The mechanism of a cycle as a drawing that stands still. assets/cycle.js draws the same, moved.
namespace boxbeam::report::html {

/// Whether anything leaves the plane x-y.
bool is_in_space(const CycleFigure& cycle);

/// What goes to the right and up of a drawing, by rows: the plane x-y, or an oblique view of the
/// space whose z is upright.
Eigen::Matrix<double, 2, 3> view_of(bool in_space);

/// One frame as <svg>, on the scale on which the whole cycle fits; loads as arrows that end where
/// they act, with their sizes.
std::string posture_svg(const CycleFigure& cycle, std::size_t frame, const std::string& label);

}  // namespace boxbeam::report::html
