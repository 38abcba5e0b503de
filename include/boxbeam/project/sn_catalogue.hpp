#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/fatigue/sn_curve.hpp"

/// The built-in fatigue strength curves (sections/catalogue/sn-curves.toml), read when one is first
/// asked for. A family is one code and one use: "EN 1993-1-9", "EN 1993-1-9 hot spot",
/// "DNV-RP-C203 air", "BS 7608", "IIW", "IIW constant amplitude".
namespace boxbeam {

/// The names of all families.
std::vector<std::string> families();

/// The names of a family's curves, the strongest first within each table of the code; empty where
/// there is no such family.
std::vector<std::string> names_of(std::string_view family, StressKind kind = StressKind::direct);

/// A curve by its name in its code ("100", "36*", "C2"). "36*", "45*" and "50*" are the curves of
/// EN 1993-1-9 7.1, note 3; without that note the detail has the category "36", "45" or "50".
std::optional<SnCurve> find_curve(std::string_view family, std::string_view name,
                                  StressKind kind = StressKind::direct);

/// The strongest curve of a family whose strength at 2e6 cycles is not above `strength`, for the
/// same detail under another code: EN 1993-1-9 100 is DNV-RP-C203 C2. Codes round differently: 0.5
/// % above counts as not above. Nothing where all are stronger.
std::optional<SnCurve> curve_of_same_strength(std::string_view family, StressKind kind,
                                              Stress strength);

/// How a code lowers its strengths for thick plates:
///
///     (reference/t)^exponent, 1 up to the reference thickness
///
struct ThicknessRule {
  Length reference;
  double exponent = 0.0;
  bool unconfirmed = false;
};

/// The rule of a family for one of its curves; nothing where the family has none (EN 1993-1-9,
/// whose rows have their own size effects). Where the exponent follows from the detail, `row` of EN
/// 1993-1-9 says what it is; of an unknown one ("") the largest exponent counts.
std::optional<ThicknessRule> thickness_rule_of(std::string_view family, const SnCurve& curve,
                                               std::string_view row);

/// Factor on the strengths of a plate.
double factor_of(const ThicknessRule& rule, Length thickness);

/// "(25 mm/40 mm)^0.25", "1 up to 25 mm".
std::string to_text(const ThicknessRule& rule, Length thickness);

/// The damage sum that a code allows for ranges of many sizes.
double damage_limit_of(std::string_view family);

}  // namespace boxbeam
