#include "boxbeam/report/formula.hpp"

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "boxbeam/report/formula_tree.hpp"
#include "catch.hpp"
#include "support/formula_value.hpp"

namespace formula_test {

using boxbeam::report::latex_of_formula;
using boxbeam::report::mathml_of_formula;
using boxbeam::report::parse_formula;

// Expected texts follow from the rules in formula.hpp, and from how LaTeX and MathML write them.

namespace {

/// Whether braces close in order; "\{" is a sign.
bool braces_balance(const std::string& latex) {
  int depth = 0;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '\\') {
      ++i;
      continue;
    }
    if (latex[i] == '{') ++depth;
    if (latex[i] == '}' && --depth < 0) return false;
  }
  return depth == 0;
}

/// Whether every tag is closed by its own, and nothing else looks like one.
bool tags_balance(const std::string& mathml) {
  std::vector<std::string> open;
  for (std::size_t at = mathml.find('<'); at != std::string::npos; at = mathml.find('<', at + 1)) {
    const std::size_t end = mathml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = mathml.substr(at + 1, end - at - 1);
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

double number(const std::string& formula) {
  const auto value = test::value_of(formula);
  REQUIRE(value);
  return 0.5 * (value->low + value->high);
}

}  // namespace

TEST_CASE("A slash divides the product before it by the product after it", "[report][formula]") {
  CHECK(latex_of_formula("M z/I_y") == "\\frac{M\\,z}{I_{y}}");
  CHECK(latex_of_formula("V S/(I_y b)") == "\\frac{V\\,S}{I_{y}\\,b}");
  CHECK(latex_of_formula("f_y/(gamma_M0 sigma_v)") ==
        "\\frac{f_{y}}{\\gamma_{\\mathrm{M0}}\\,\\sigma_{v}}");
  CHECK(latex_of_formula("N/A_eff + M_y z/I_y,eff - M_z y/I_z,eff") ==
        "\\frac{N}{A_{\\mathrm{eff}}} + \\frac{M_{y}\\,z}{I_{y,\\mathrm{eff}}} - "
        "\\frac{M_{z}\\,y}{I_{z,\\mathrm{eff}}}");
  CHECK(latex_of_formula("(M - N z_c) e_z/I_y") == "\\frac{(M - N\\,z_{c})\\,e_{z}}{I_{y}}");
  // What follows a group in the denominator multiplies the fraction, and so does "x".
  CHECK(number("6/(2) 3") == Approx(9.0));
  CHECK(number("(6/2) (1 + 2)") == Approx(9.0));
  CHECK(number("6/2 (1 + 2)") == Approx(9.0));
  CHECK(number("6/2 x 3") == Approx(9.0));
  CHECK(number("6/(2 x 3)") == Approx(1.0));
  CHECK(number("12/3/2") == Approx(2.0));
  CHECK(number("2 x 12/3 + 1") == Approx(9.0));
}

TEST_CASE("Substituted values are typeset with upright units and powers of ten",
          "[report][formula]") {
  CHECK(latex_of_formula("-27.66 kN/87240 mm^2 + (-215.6 kN m) x 300.0 mm/3.86572e+09 mm^4") ==
        "-\\frac{{27.66\\,\\mathrm{kN}}}{{87240\\,\\mathrm{mm}^{2}}} + "
        "\\frac{(-{215.6\\,\\mathrm{kN}\\,\\mathrm{m}}) \\times {300.0\\,\\mathrm{mm}}}"
        "{{3.86572\\times 10^{9}\\,\\mathrm{mm}^{4}}}");
  CHECK(latex_of_formula("8.031e-5 mm^-2") == "{8.031\\times 10^{-5}\\,\\mathrm{mm}^{-2}}");
  CHECK(latex_of_formula("90 deg") == "{90^{\\circ}}");
  CHECK(latex_of_formula("165 %") == "{165\\,\\%}");
  CHECK(mathml_of_formula("3.5e9 mm^4") ==
        "<mrow><mn>3.5</mn><mo>×</mo><msup><mn>10</mn><mn>9</mn></msup>"
        "<mspace width=\"0.17em\"></mspace><msup><mi mathvariant=\"normal\">mm</mi><mn>4</mn>"
        "</msup></mrow>");
  // -27.66 kN/87240 mm^2 + (-215.6 kN m)(300 mm)/(3.86572e9 mm^4) = -17.05 MPa
  CHECK(number("-27.66 kN/87240 mm^2 + (-215.6 kN m) x 300.0 mm/3.86572e+09 mm^4") ==
        Approx(-17.05e6).epsilon(1e-3));
}

TEST_CASE("Names, Greek letters, indices and ranges", "[report][formula]") {
  CHECK(latex_of_formula("sigma_max") == "\\sigma_{\\mathrm{max}}");
  CHECK(latex_of_formula("d_sigma") == "\\Delta\\sigma");
  CHECK(latex_of_formula("d_sigma_E,2") == "\\Delta\\sigma_{E,2}");
  CHECK(latex_of_formula("d_tau_L") == "\\Delta\\tau_{L}");
  CHECK(latex_of_formula("N_b,Rd") == "N_{b,\\mathrm{Rd}}");
  CHECK(latex_of_formula("factor") == "\\mathrm{factor}");
  CHECK(latex_of_formula("kappa") == "\\kappa");
  CHECK(mathml_of_formula("sigma_v") == "<msub><mi>σ</mi><mrow><mi>v</mi></mrow></msub>");
  CHECK(mathml_of_formula("d_sigma") == "<mrow><mi mathvariant=\"normal\">Δ</mi><mi>σ</mi></mrow>");
}

TEST_CASE("Roots, powers, functions, derivatives, sums and integrals", "[report][formula]") {
  CHECK(latex_of_formula("sqrt(sigma^2 + 3 tau^2)") == "\\sqrt{{\\sigma}^{2} + 3\\,{\\tau}^{2}}");
  CHECK(latex_of_formula("d_sigma_D (5e6/N)^(1/5)") ==
        "\\Delta\\sigma_{D}\\,{\\left(\\frac{{5\\times 10^{6}}}{N}\\right)}^{1/5}");
  CHECK(latex_of_formula("r^-2") == "{r}^{-2}");
  CHECK(latex_of_formula("1 - 2 cos 2theta") == "1 - 2\\,\\cos 2\\,\\theta");
  CHECK(latex_of_formula("d/dx(M S/I_y)/b") ==
        "\\frac{\\frac{\\mathrm{d}}{\\mathrm{d}x}\\left(\\frac{M\\,S}{I_{y}}\\right)}{b}");
  CHECK(latex_of_formula("sum n_i/N_i <= 1") == "\\sum \\frac{n_{i}}{N_{i}} \\le 1");
  CHECK(latex_of_formula("int m M/(E I_y) ds") == "\\int \\frac{m\\,M}{E\\,I_{y}}\\,\\mathrm{d}s");
  CHECK(latex_of_formula("limit/abs(tau_par)") ==
        "\\frac{\\mathrm{limit}}{\\left|\\tau_{\\mathrm{par}}\\right|}");
  CHECK(number("sqrt((3)^2 + 4^2)") == Approx(5.0));
  CHECK(number("2 x (1/4)^(1/2)") == Approx(1.0));
  CHECK(number("1/max(2, 3, 4)") == Approx(0.25));
  CHECK(number("4 x sin(30 deg)") == Approx(2.0));
}

TEST_CASE("A long sum may break in LaTeX at its outer signs", "[report][formula]") {
  // Outside of braces, where \left and \right would hold it together.
  const std::string latex = latex_of_formula("(K_g/3) (1 - 2 cos 2theta) + a b/c - d_0 x e");
  CHECK(latex.find("\\left") == std::string::npos);
  int depth = 0;
  int breaks = 0;
  for (const char c : latex) {
    if (c == '{') ++depth;
    if (c == '}') --depth;
    if (depth == 0 && (c == '+' || c == '-')) ++breaks;
  }
  CHECK(breaks == 3);
}

TEST_CASE("What is no formula stands as the words that it is", "[report][formula]") {
  for (const char* words :
       {"",      "(",   "a)",   "a +",         "/b",    "a_",         "x^",      "M z/",
        "sqrt(", "cos", "a = ", "50 % & more", "{a}",   "\\input{x}", "a_b_c",   "d/dx",
        "ø",     "σ",   "1..2", "a,b",         "min()", "\"quoted\"", "<script>"}) {
    INFO(words);
    CHECK_FALSE(parse_formula(words));
    CHECK(braces_balance(latex_of_formula(words)));
    CHECK(tags_balance(mathml_of_formula(words)));
  }
  CHECK(mathml_of_formula("<b> & \"c\"") == "<mtext>&lt;b&gt; &amp; &quot;c&quot;</mtext>");
  CHECK(latex_of_formula("50 % & more").find("\\%") != std::string::npos);
  CHECK(latex_of_formula("\\input{x}").find("\\input") == std::string::npos);
}

TEST_CASE("Deep nesting and great length are no formula, and end", "[report][formula]") {
  for (const char* repeated : {"(", "sqrt(", "cos ", "int ", "-", "a^", "d/dx("}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += repeated;
    CHECK_FALSE(parse_formula(text + "1"));
    text.resize(3000);
    CHECK_FALSE(parse_formula(text + "("));
  }
  CHECK(parse_formula("((((1))))"));
}

TEST_CASE("Any words are set with braces and tags that close", "[report][formula][property]") {
  // Signs that formulas consist of, so that many are formulas or nearly so, and any bytes.
  const auto from_signs = rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("abdsxMN019._,^/+-*=<>()[]{}\\%&$#~ \"'e")));
  const auto from_words = rc::gen::map(
      rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
          "M",     "z",     "/",     " ",    "(",   ")", "I_y",     "sqrt(",   "2",
          "3.5e9", " mm^4", " x ",   " + ",  " - ", "^", "sigma_v", "d_sigma", "cos ",
          "theta", "sum ",  "d/dx(", " <= ", ",",   "<", "&",       "%"})),
      [](const std::vector<std::string>& words) {
        std::string text;
        for (const std::string& word : words) text += word;
        return text;
      });
  const auto holds = [](const std::string& text) {
    RC_ASSERT(braces_balance(latex_of_formula(text)));
    RC_ASSERT(tags_balance(mathml_of_formula(text)));
  };
  CHECK(rc::check("signs of formulas", [&] { holds(*from_signs); }));
  CHECK(rc::check("words of formulas", [&] { holds(*from_words); }));
  CHECK(rc::check("any bytes", [&] { holds(*rc::gen::arbitrary<std::string>()); }));
}

TEST_CASE("A long formula comes in pieces for browsers", "[report][formula]") {
  using boxbeam::report::mathml_pieces_of_formula;
  CHECK(mathml_pieces_of_formula("M z/I_y").size() == 1);
  CHECK(mathml_pieces_of_formula("(a + b) c").size() == 1);
  const auto pieces = mathml_pieces_of_formula("-a + b/c - d_0");
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0] == "<mrow><mo>−</mo><mi>a</mi></mrow>");
  CHECK(pieces[1].starts_with("<mo form=\"infix\">+</mo>"));
  CHECK(pieces[2].starts_with("<mo form=\"infix\">−</mo>"));
  CHECK(mathml_pieces_of_formula("a + b <= c + d").size() == 4);
  CHECK(mathml_pieces_of_formula("no formula!") ==
        std::vector<std::string>{"<mtext>no formula!</mtext>"});
}

}  // namespace formula_test
