#include "latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/latex_writer.hpp"

namespace boxbeam::report {
namespace {

struct Sign {
  char32_t point;
  const char* code;
};

// clang-format off

/// Signs of ASCII that LaTeX takes for its own, or that its fonts join (-- ,, << >> ?` !`). A
/// bracket or a star at the start of a table's row would belong to the end of the row before.
constexpr std::array special{
    Sign{U'#', "\\#"}, Sign{U'$', "\\$"}, Sign{U'%', "\\%"}, Sign{U'&', "\\&"}, Sign{U'_', "\\_"},
    Sign{U'{', "\\{"}, Sign{U'}', "\\}"}, Sign{U'~', "\\textasciitilde{}"},
    Sign{U'^', "\\textasciicircum{}"}, Sign{U'\\', "\\textbackslash{}"},
    Sign{U'"', "\\textquotedbl{}"}, Sign{U'\'', "\\textquotesingle{}"},
    Sign{U'`', "\\textasciigrave{}"}, Sign{U'-', "-{}"}, Sign{U',', ",{}"}, Sign{U'<', "<{}"},
    Sign{U'>', ">{}"}, Sign{U'[', "{[}"}, Sign{U']', "{]}"}, Sign{U'*', "{*}"}};

/// Signs of text beyond the Latin letters.
constexpr std::array text_signs{
    Sign{U'\u00A0', "~"}, Sign{U'\u00AD', "\\-"}, Sign{U'\u2009', "\\,"}, Sign{U'\u200A', "\\,"},
    Sign{U'\u202F', "\\,"}, Sign{U'\u013F', "L\\textperiodcentered{}"},
    Sign{U'\u0140', "l\\textperiodcentered{}"}, Sign{U'Ș', "\\textcommabelow{S}"},
    Sign{U'ș', "\\textcommabelow{s}"}, Sign{U'Ț', "\\textcommabelow{T}"},
    Sign{U'ț', "\\textcommabelow{t}"},
    Sign{U'‐', "-{}"}, Sign{U'‑', "\\mbox{-}"}, Sign{U'–', "\\textendash{}"},
    Sign{U'—', "\\textemdash{}"}, Sign{U'‘', "\\textquoteleft{}"},
    Sign{U'’', "\\textquoteright{}"}, Sign{U'‚', "\\quotesinglbase{}"},
    Sign{U'“', "\\textquotedblleft{}"}, Sign{U'”', "\\textquotedblright{}"},
    Sign{U'„', "\\quotedblbase{}"}, Sign{U'†', "\\textdagger{}"}, Sign{U'‡', "\\textdaggerdbl{}"},
    Sign{U'•', "\\textbullet{}"},
    Sign{U'‰', "\\textperthousand{}"}, Sign{U'‹', "\\guilsinglleft{}"},
    Sign{U'›', "\\guilsinglright{}"}, Sign{U'€', "\\texteuro{}"}, Sign{U'№', "\\textnumero{}"},
    Sign{U'™', "\\texttrademark{}"}};

/// Signs of text whose glyphs are those of others: what is copied must be told.
constexpr std::array copied_signs{
    Sign{U'¹', "\\textonesuperior{}"}, Sign{U'²', "\\texttwosuperior{}"},
    Sign{U'³', "\\textthreesuperior{}"},
    Sign{U'…', "\\textellipsis{}"}, Sign{U'℃', "\\textdegree{}C"},
    Sign{U'⁰', "\\textsuperscript{0}"}, Sign{U'⁴', "\\textsuperscript{4}"},
    Sign{U'⁵', "\\textsuperscript{5}"}, Sign{U'⁶', "\\textsuperscript{6}"},
    Sign{U'⁷', "\\textsuperscript{7}"}, Sign{U'⁸', "\\textsuperscript{8}"},
    Sign{U'⁹', "\\textsuperscript{9}"}, Sign{U'⁺', "\\textsuperscript{+}"},
    Sign{U'⁻', "\\textsuperscript{\\textminus}"}, Sign{U'ⁿ', "\\textsuperscript{n}"},
    Sign{U'₀', "\\textsubscript{0}"}, Sign{U'₁', "\\textsubscript{1}"},
    Sign{U'₂', "\\textsubscript{2}"}, Sign{U'₃', "\\textsubscript{3}"},
    Sign{U'₄', "\\textsubscript{4}"}, Sign{U'₅', "\\textsubscript{5}"},
    Sign{U'₆', "\\textsubscript{6}"}, Sign{U'₇', "\\textsubscript{7}"},
    Sign{U'₈', "\\textsubscript{8}"}, Sign{U'₉', "\\textsubscript{9}"}};

/// Letters and signs that only the mathematics fonts have.
constexpr std::array mathematical_signs{
    Sign{U'Α', "\\mathrm{A}"}, Sign{U'Β', "\\mathrm{B}"}, Sign{U'Γ', "\\Gamma"},
    Sign{U'Δ', "\\Delta"}, Sign{U'Ε', "\\mathrm{E}"}, Sign{U'Ζ', "\\mathrm{Z}"},
    Sign{U'Η', "\\mathrm{H}"}, Sign{U'Θ', "\\Theta"}, Sign{U'Ι', "\\mathrm{I}"},
    Sign{U'Κ', "\\mathrm{K}"}, Sign{U'Λ', "\\Lambda"}, Sign{U'Μ', "\\mathrm{M}"},
    Sign{U'Ν', "\\mathrm{N}"}, Sign{U'Ξ', "\\Xi"}, Sign{U'Ο', "\\mathrm{O}"}, Sign{U'Π', "\\Pi"},
    Sign{U'Ρ', "\\mathrm{P}"}, Sign{U'Σ', "\\Sigma"}, Sign{U'Τ', "\\mathrm{T}"},
    Sign{U'Υ', "\\Upsilon"}, Sign{U'Φ', "\\Phi"}, Sign{U'Χ', "\\mathrm{X}"}, Sign{U'Ψ', "\\Psi"},
    Sign{U'Ω', "\\Omega"}, Sign{U'\u2126', "\\Omega"}, Sign{U'α', "\\alpha"}, Sign{U'β', "\\beta"},
    Sign{U'γ', "\\gamma"}, Sign{U'δ', "\\delta"}, Sign{U'ε', "\\varepsilon"}, Sign{U'ζ', "\\zeta"},
    Sign{U'η', "\\eta"}, Sign{U'θ', "\\theta"}, Sign{U'ι', "\\iota"}, Sign{U'κ', "\\kappa"},
    Sign{U'λ', "\\lambda"}, Sign{U'μ', "\\mu"}, Sign{U'ν', "\\nu"}, Sign{U'ξ', "\\xi"},
    Sign{U'ο', "o"}, Sign{U'π', "\\pi"}, Sign{U'ρ', "\\rho"}, Sign{U'ς', "\\varsigma"},
    Sign{U'σ', "\\sigma"}, Sign{U'τ', "\\tau"}, Sign{U'υ', "\\upsilon"}, Sign{U'φ', "\\varphi"},
    Sign{U'χ', "\\chi"}, Sign{U'ψ', "\\psi"}, Sign{U'ω', "\\omega"}, Sign{U'ϑ', "\\vartheta"},
    Sign{U'ϕ', "\\phi"}, Sign{U'ϵ', "\\epsilon"}, Sign{U'′', "{}'"}, Sign{U'″', "{}''"},
    Sign{U'←', "\\leftarrow"}, Sign{U'↑', "\\uparrow"}, Sign{U'→', "\\rightarrow"},
    Sign{U'↓', "\\downarrow"}, Sign{U'↔', "\\leftrightarrow"}, Sign{U'⇐', "\\Leftarrow"},
    Sign{U'⇒', "\\Rightarrow"}, Sign{U'⇔', "\\Leftrightarrow"}, Sign{U'∀', "\\forall"},
    Sign{U'∂', "\\partial"}, Sign{U'∃', "\\exists"}, Sign{U'∅', "\\emptyset"},
    Sign{U'∆', "\\Delta"}, Sign{U'∇', "\\nabla"}, Sign{U'∈', "\\in"}, Sign{U'∏', "\\prod"},
    Sign{U'∑', "\\sum"}, Sign{U'−', "-"}, Sign{U'∓', "\\mp"}, Sign{U'∕', "/"}, Sign{U'∗', "*"},
    Sign{U'∘', "\\circ"}, Sign{U'∙', "\\bullet"}, Sign{U'√', "\\surd"}, Sign{U'∝', "\\propto"},
    Sign{U'∞', "\\infty"}, Sign{U'∠', "\\angle"}, Sign{U'∥', "\\parallel"}, Sign{U'∧', "\\wedge"},
    Sign{U'∨', "\\vee"}, Sign{U'∩', "\\cap"}, Sign{U'∪', "\\cup"}, Sign{U'∫', "\\int"},
    Sign{U'∼', "\\sim"}, Sign{U'≃', "\\simeq"}, Sign{U'≅', "\\cong"}, Sign{U'≈', "\\approx"},
    Sign{U'≠', "\\neq"}, Sign{U'≡', "\\equiv"}, Sign{U'≤', "\\le"}, Sign{U'≥', "\\ge"},
    Sign{U'≪', "\\ll"}, Sign{U'≫', "\\gg"}, Sign{U'⊂', "\\subset"}, Sign{U'⊥', "\\perp"},
    Sign{U'⋅', "\\cdot"}, Sign{U'⌀', "\\oslash"}, Sign{U'⟂', "\\perp"}};

/// Widths of the signs of ASCII from space to tilde in Latin Modern Roman at 10 pt [0.001 em].
/// Source: ec-lmr10.tfm.
constexpr std::array<short, 95> ascii_widths{
    500, 278, 374, 833, 500, 833, 778, 278, 389, 389, 500, 778, 278, 333, 278, 500,
    500, 500, 500, 500, 500, 500, 500, 500, 500, 500, 278, 278, 778, 778, 778, 472,
    778, 750, 708, 722, 764, 681, 653, 785, 750, 361, 514, 778, 625, 917, 750, 778,
    681, 778, 736, 556, 722, 750, 750, 1028, 750, 750, 611, 278, 500, 278, 611, 750,
    278, 500, 556, 444, 556, 444, 306, 500, 556, 278, 306, 528, 278, 833, 556, 500,
    556, 528, 392, 394, 389, 556, 528, 722, 528, 528, 444, 500, 278, 500, 556};

// clang-format on

template <std::size_t n>
const char* find(const std::array<Sign, n>& signs, char32_t point) {
  const auto at = std::find_if(signs.begin(), signs.end(),
                               [point](const Sign& sign) { return sign.point == point; });
  return at == signs.end() ? nullptr : at->code;
}

bool is_space(char32_t point) {
  return point == U' ' || point == U'\t' || point == U'\n' || point == U'\r';
}

/// What encoding T1 of the fonts has of Latin-1 and Latin Extended-A.
bool is_latin(char32_t point) {
  constexpr std::array missing{U'Ħ', U'ħ', U'ĸ', U'Ŀ', U'ŀ', U'ŉ', U'Ŧ', U'ŧ', U'ſ'};
  return point > 0xA0 && point < 0x180 && point != 0xAD &&
         std::find(missing.begin(), missing.end(), point) == missing.end();
}

/// A code point of Latin-1 or Latin Extended-A in UTF-8.
std::string two_bytes(char32_t point) {
  return {static_cast<char>(0xC0U | (point >> 6U)), static_cast<char>(0x80U | (point & 0x3FU))};
}

struct Glyph {
  std::string code;
  double width = 0;  ///< [em]
};

/// A sign by glyphs of others, copied as what it is.
std::string copied_as(char32_t point, const std::string& code) {
  return fmt::format("\\as{{{:04X}}}{{{}}}", static_cast<unsigned>(point), code);
}

Glyph glyph_of(char32_t point) {
  if (is_space(point)) return {" ", 0.5};
  if (is_hidden(point)) {
    const std::string escape = escape_of(point);
    return {"\\textbackslash{}" + escape.substr(1), 0.6 * static_cast<double>(escape.size())};
  }
  if (point < 0x7F) {
    const char* code = find(special, point);
    return {code != nullptr ? std::string(code) : std::string(1, static_cast<char>(point)),
            ascii_widths[point - 0x20] / 1000.0};
  }
  if (const char* code = find(copied_signs, point)) return {copied_as(point, code), 0.8};
  if (const char* code = find(text_signs, point)) return {code, 0.8};
  if (is_latin(point)) return {two_bytes(point), 0.8};
  if (const char* code = find(mathematical_signs, point))
    return {copied_as(point, fmt::format("\\ensuremath{{{}}}", code)), 0.8};
  return {fmt::format("{{\\scriptsize U+{:04X}}}", static_cast<unsigned>(point)), 3.7};
}

/// The signs of a text, word by word; spaces stand between the words.
std::vector<std::u32string> words_of(const std::string& text) {
  std::vector<std::u32string> words(1);
  for (const char32_t point : code_points_of(text)) {
    if (is_space(point)) {
      words.emplace_back();
    } else {
      words.back() += point;
    }
  }
  return words;
}

bool is_punctuation(char32_t point) {
  constexpr std::u32string_view punctuation = U"/\\_-.,;:=+&?)]}|";
  return punctuation.find(point) != std::u32string_view::npos;
}

/// A hyphen that is meant as a minus: before a number or the name of an axis.
bool is_minus(const std::u32string& word, std::size_t i) {
  constexpr std::u32string_view before = U"([=/";
  constexpr std::u32string_view axes = U"xyz";
  if (word[i] != U'-' || i + 1 == word.size()) return false;
  if (i > 0 && before.find(word[i - 1]) == std::u32string_view::npos) return false;
  const bool number = word[i + 1] >= U'0' && word[i + 1] <= U'9';
  const bool axis = axes.find(word[i + 1]) != std::u32string_view::npos &&
                    (i + 2 == word.size() || is_punctuation(word[i + 2]));
  return number || axis;
}

double width_of(const std::u32string& word) {
  constexpr double minus = 0.778;
  double width = 0;
  for (std::size_t i = 0; i < word.size(); ++i)
    width += is_minus(word, i) ? minus : glyph_of(word[i]).width;
  return width;
}

/// Signs of an exponent at a hat, the hat among them: of a unit or of ten. Else 0.
std::size_t exponent_at(const std::u32string& word, std::size_t hat) {
  constexpr std::array bases{U"m", U"mm", U"cm", U"s", U"10"};
  if (word[hat] != U'^') return 0;
  const auto is_digit = [](char32_t c) { return c >= U'0' && c <= U'9'; };
  const auto is_letter = [](char32_t c) { return c >= U'a' && c <= U'z'; };
  std::size_t begin = hat;
  while (begin > 0 && (is_letter(word[begin - 1]) || is_digit(word[begin - 1]))) --begin;
  const std::u32string_view base(word.data() + begin, hat - begin);
  if (std::find(bases.begin(), bases.end(), base) == bases.end()) return 0;
  std::size_t end = hat + 1;
  if (end < word.size() && word[end] == U'-') ++end;
  const std::size_t digits = end;
  while (end < word.size() && is_digit(word[end])) ++end;
  return end > digits ? end - hat : 0;
}

/// An exponent set as one, and copied as it was written: "^-2".
std::string exponent(const std::u32string& signs) {
  std::string copied;
  std::string shown;
  for (const char32_t sign : signs) {
    copied += fmt::format("{:04X}", static_cast<unsigned>(sign));
    if (sign == U'-') shown += "\\textminus{}";
    if (sign != U'-' && sign != U'^') shown += static_cast<char>(sign);
  }
  return fmt::format("\\as{{{}}}{{\\textsuperscript{{{}}}}}", copied, shown);
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  return latex_breakable(text, std::numeric_limits<double>::infinity());
}

std::string latex_breakable(const std::string& text, double limit) {
  std::string out;
  bool first = true;
  for (const std::u32string& word : words_of(text)) {
    if (!first) out += ' ';
    first = false;
    const bool long_word = width_of(word) > limit;
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (const std::size_t signs = exponent_at(word, i)) {
        out += exponent(word.substr(i, signs));
        i += signs - 1;
        continue;
      }
      out += is_minus(word, i) ? copied_as(U'-', "\\textminus") : glyph_of(word[i]).code;
      if (long_word && i + 1 < word.size()) out += is_punctuation(word[i]) ? "\\brk{}" : "\\Brk{}";
    }
  }
  return out;
}

std::string latex_shortened(const std::string& text, double room) {
  if (latex_width(text) <= room) return latex_escaped(text);
  std::string out;
  double width = 1;
  for (const char32_t point : code_points_of(text)) {
    const Glyph glyph = glyph_of(point);
    width += glyph.width;
    if (width > room) break;
    out += glyph.code;
  }
  return out + "\\textellipsis{}";
}

double latex_width(const std::string& text) {
  constexpr double space = 0.5;
  double width = -space;
  for (const std::u32string& word : words_of(text)) width += space + width_of(word);
  return width;
}

double latex_widest_word(const std::string& text, double limit) {
  double widest = 0;
  for (const std::u32string& word : words_of(text)) widest = std::max(widest, width_of(word));
  return std::min(widest, limit);
}

std::string latex_typewriter(const std::string& text) {
  std::string out;
  for (const char32_t point : code_points_of(text)) {
    out += point == U' ' || point == U'\t' ? "~" : glyph_of(point).code;
    out += "\\brk{}";
  }
  return out;
}

std::string latex_pdf_string(const std::string& text) {
  std::string out = "\\B376\\B377";
  const auto unit = [&out](unsigned value) {
    out += fmt::format("\\B{:03o}\\B{:03o}", value >> 8U, value & 0xFFU);
  };
  for (const char32_t point : code_points_of(text)) {
    const auto value = static_cast<unsigned>(point);
    if (is_hidden(point)) {
      unit(' ');
    } else if (value < 0x10000) {
      unit(value);
    } else {
      unit(0xD800U + ((value - 0x10000U) >> 10U));
      unit(0xDC00U + ((value - 0x10000U) & 0x3FFU));
    }
  }
  return out;
}

}  // namespace boxbeam::report
