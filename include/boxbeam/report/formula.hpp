#pragma once

#include <string>

/// Formulas of a calculation sheet. They are written as an engineer types them, which is what the
/// text report prints; for HTML and PDF they are typeset from the same words:
///
///     N/A_eff + M_y z/I_y,eff        (-27.66 kN)/(87240 mm^2) + 300.0 mm x 2 MPa
///     sqrt(sigma^2 + 3 tau^2)        f_y/(gamma_M0 sigma_v)      d/dx(M S/I_y)/b
///
/// A slash divides the product before it by the product after it; a group in parentheses after a
/// slash is the whole denominator. "x" between spaces multiplies. Names have an index after "_";
/// Greek letters are written out; a number may be followed by its unit; words stand upright.
/// What is no formula (unbalanced parentheses, other signs) is typeset as the words that it is.
namespace boxbeam::report {

/// A formula for LaTeX's mathematics mode, without delimiters.
std::string latex_of_formula(const std::string& formula);

/// A formula as content of a MathML <math> element.
std::string mathml_of_formula(const std::string& formula);

}  // namespace boxbeam::report
