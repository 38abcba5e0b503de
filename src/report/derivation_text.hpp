#pragma once

#include "boxbeam/core/derivation.hpp"
#include "sheet_numbers.hpp"

/// Prints derivations in the notation of formula.hpp: each step with its symbols, with its values
/// and with its result.
///
///     F_v,Rd = 0.6 A f_up/gamma_M2 = 0.6 x 1963.5 mm^2 x 800.0 MPa/1.25 = 754.0 kN
///
/// Symbols stand side by side, values with an "x" between them. A term has one slash; what is
/// divided by several values has them in parentheses behind it. Equal factors that follow each
/// other are a power. A negative value is in parentheses behind a sign and in a product, one with a
/// unit under an exponent. A sum of stresses shows its terms with as many decimals as the sum
/// needs.
namespace boxbeam::report {

/// A value with its unit as a sheet shows it.
std::string value_text(double value, const Shown& shown);

/// An expression in its symbols.
std::string symbols_of(const Traced& expression);
/// An expression with the values of its symbols.
std::string values_of(const Traced& expression);

Steps steps_of(const Derivation& derivation);

}  // namespace boxbeam::report
