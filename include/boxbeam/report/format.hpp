#pragma once

#include <string>

#include "boxbeam/core/units.hpp"

/// Engineering text of SI numbers; the only place where kN, MPa and mm are written, and where is
/// decided how many digits a quantity has.
namespace boxbeam::text {

/// What is rounded, and shown in which unit.
///
///     quantity                          unit     shown with
///     force, moment, stress, length     kN, kN m, MPa, mm   4 significant digits
///     station: place along the beam     m                   4 significant digits
///     factor: safety, partial, K_t      -                   3 significant digits
///     utilisation                       %                   3, more where 100 % would hide a side
///     time                              s                   4 decimals
///     area                              10^3 mm^2           5 significant digits
///     second moment, section modulus    10^6 mm^4, 10^3 mm^3   5 significant digits
///     mass, inertia                     kg, kg m^2          5 significant digits
///     frequency                         Hz                  4 significant digits
///     ratio: any number without unit    -                   4 significant digits
enum class Quantity {
  force,
  moment,
  stress,
  length,
  station,
  factor,
  utilisation,
  time,
  area,
  second_moment,
  section_modulus,
  mass,
  inertia,
  frequency,
  ratio,
};

/// The number of an SI value in the quantity's unit, without the unit: "31.66".
std::string rounded(Quantity quantity, double value);

/// "kN"; "" for numbers.
const char* unit_of(Quantity quantity);

/// "31.66 kN".
std::string with_unit(Quantity quantity, double value);

/// Fixed-point text with so many significant digits, "31.66", "0.00120"; "0" for round-off of zero.
std::string significant(double value, int digits = 4);

std::string kN(double newtons);
std::string kNm(double newton_metres);
std::string MPa(double pascals);
std::string mm(double metres);
/// A value of an SI unit ("Pa", "N", "m", "1") in engineering units.
std::string amount(double value, const std::string& unit);
std::string factor(double value);
std::string seconds(double time);
/// Whole kilograms, of a mechanism's bodies.
std::string kilograms(double mass);
/// A utilisation: "165 %"; never "100 %" for what is above.
std::string percent(double fraction);
/// "1e+08" as "1e8".
std::string cycles(double count);

}  // namespace boxbeam::text
