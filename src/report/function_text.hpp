#pragma once

#include <string>

#include "boxbeam/mechanism/common/driver.hpp"

namespace boxbeam {

/// Six digits, without "-0".
std::string plain(double value);

std::string degrees(double angle);

/// A function of time as a formula, or in words; SI.
std::string function_text(const Driver& driver, const char* unit);

}  // namespace boxbeam
