#pragma once

#include <string>
#include <vector>

/// Formulas of a calculation sheet. They are written as an engineer types them, which is what the
/// text report prints; for HTML and PDF they are typeset from the same words:
///
///     N/A_eff + M_y z/I_y,eff        (-27.66 kN)/(87240 mm^2) + 300.0 mm x 2 MPa
///     sqrt(sigma^2 + 3 tau^2)        f_y/(gamma_M0 sigma_v)      d/dx(M S/I_y)/b
///     (K_g/3) (1 - 2 cos 2theta)     d_sigma_D (5e6/N)^(1/5)     sum n_i/N_i <= 1
///
/// What stands side by side is a product; "x" between spaces multiplies. A slash divides all that
/// is before it in its term by the product after it, which ends before a group in parentheses; a
/// group that follows the slash at once is the whole denominator. Names have an index after "_";
/// Greek letters are written out, "d_sigma" is the range of sigma; a number may be followed by its
/// unit; words stand upright. "sum" and "int" act on the rest of their term. What is no formula
/// (unbalanced parentheses, other signs) is typeset as the words that it is.
namespace boxbeam::report {

/// A formula for LaTeX's mathematics mode, without delimiters; lines may break at its outer signs.
std::string latex_of_formula(const std::string& formula);

/// A formula as content of a MathML <math> element.
std::string mathml_of_formula(const std::string& formula);

/// The same in pieces, each for a <math> element of its own, between which a line may break:
/// browsers do not break inside of one. Each but the first begins with its sign.
std::vector<std::string> mathml_pieces_of_formula(const std::string& formula);

}  // namespace boxbeam::report
