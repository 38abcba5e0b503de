#pragma once

#include <optional>
#include <string>

#include "boxbeam/mechanism/common/contact.hpp"
#include "boxbeam/mechanism/common/driver.hpp"
#include "boxbeam/mechanism/common/friction.hpp"

namespace boxbeam {

/// Six digits, without "-0".
std::string plain(double value);

std::string degrees(double angle);

/// A function of time as a formula, or in words; SI.
std::string function_text(const Driver& driver, const char* unit);

/// "friction coefficient 0.1 above a creep of 0.01 m/s, guide 0.2 m long, viscous friction 3 N
/// s/m";
/// "" where nothing rubs.
std::string friction_text(const Friction& law);

/// ", only pushing, a free impact ends with 0.8 of its velocity"; "" of what acts both ways.
std::string acting_text(Acts acts, const std::optional<Impact>& impact);

}  // namespace boxbeam
