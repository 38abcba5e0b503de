#pragma once

#include <string>

#include "boxbeam/core/units.hpp"

/// Engineering text of SI numbers; the only place where kN, MPa and mm are written.
namespace boxbeam::text {

/// Fixed-point text with so many significant digits, "31.66", "0.00120"; "0" for round-off of zero.
std::string significant(double value, int digits = 4);

std::string kN(double newtons);
std::string kNm(double newton_metres);
std::string MPa(double pascals);
std::string mm(double metres);
/// A value of an SI unit ("Pa", "N", "m", "1") in engineering units.
std::string amount(double value, const std::string& unit);
std::string seconds(double time);
std::string kilograms(double mass);
std::string percent(double fraction);
/// "1e+08" as "1e8".
std::string cycles(double count);

}  // namespace boxbeam::text
