#pragma once

#include <string>

#include "boxbeam/verification/stress_points.hpp"

/// Lines of a calculation sheet: what is computed, then how.
namespace boxbeam {

/// "symbol = text", further lines "= text" and lines that go on without "=".
std::string line(const std::string& symbol, const std::string& text);
std::string more(const std::string& text);
std::string after(const std::string& text);

/// A number behind a plus sign or a factor: negative ones in brackets.
std::string term(const std::string& number);

/// The normal stress of a point under given cut forces, written out; in space with all six.
std::string normal_stress_lines(const std::string& symbol, const StressPoint& point,
                                const CutForces& cut, bool in_space);

/// The shear stress likewise.
std::string shear_stress_lines(const std::string& symbol, const StressPoint& point,
                               const CutForces& cut, bool in_space);

}  // namespace boxbeam
