#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "function_text.hpp"

namespace boxbeam::report {

/// Behind what a joint of the plane or in space is, how it gives way in elastic models.
template <class ElasticJoint>
std::string giving_way_text(const ElasticJoint& joint) {
  std::string text;
  const auto add = [&](double stiffness, double damping, const char* about, const char* unit,
                       const char* damping_unit) {
    if (std::isinf(stiffness)) return;
    text += fmt::format(", {}stiffness {} {}", about, plain(stiffness), unit);
    if (damping > 0.0) text += fmt::format(" with damping {} {}", plain(damping), damping_unit);
  };
  add(joint.stiffness, joint.damping, "", "N/m", "N s/m");
  add(joint.turning_stiffness, joint.turning_damping, "turning ", "N m/rad", "N m s/rad");
  return text + " in elastic models";
}

}  // namespace boxbeam::report
