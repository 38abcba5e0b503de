#pragma once

#include <optional>
#include <string>

#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// What resists a stress history that stands by itself, as a command line names it.
struct NamedResistance {
  SnCurve curve;              ///< with the size effect where it is known
  std::string row;            ///< of the tables of EN 1993-1-9, "8.3/5"; "" where none was named
  double damage_limit = 1.0;  ///< the damage sum that its code allows for ranges of many sizes
  double size_factor = 1.0;   ///< in the curve
  std::string size_rule;      ///< "(25 mm/40 mm)^0.2 (table 8.3)"; "" where none applies
  std::string not_applied;    ///< what of the size is left out, and why; "" where nothing is
};

/// A category of EN 1993-1-9 ("100", "36*"), a row of its tables ("8.2/6"), or a curve of a code
/// ("DNV-RP-C203 air:D"). Of a row that has several lines the weakest counts that the plate's
/// thickness does not exclude; its size effect, or the thickness correction of the code, is taken
/// where the thickness is given. Throws InputError where there is no such resistance.
NamedResistance resistance_named(const std::string& text, StressKind kind,
                                 std::optional<Length> thickness);

}  // namespace boxbeam
