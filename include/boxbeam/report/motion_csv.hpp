#pragma once

#include <string>

#include "boxbeam/verification/any_motion_result.hpp"

namespace boxbeam {

/// The instants of a motion as comma-separated values, a row each, all digits kept: the time, where
/// every body is, how it stands (in the plane its angle, in space a unit quaternion w, x, y, z from
/// its axes to those of the result, w never negative), the coordinate of every joint that has one,
/// in space only, and what joints do to the bodies that they name. Every column says its unit. A
/// reaction that rigid bodies do not determine is an empty cell. Throws InputError for elastic
/// links, which have no instants. Source: RFC 4180.
std::string motion_csv(const AnyMotionResult& motion);

}  // namespace boxbeam
