#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/formula.hpp"
#include "boxbeam/report/formula_tree.hpp"
#include "formula_names.hpp"

namespace boxbeam::report {
namespace {

using Kind = FormulaNode::Kind;

const char* const thin_space = "<mspace width=\"0.17em\"></mspace>";
const char* const minus_sign = "−";

std::string mathml_of(const FormulaNode& node);

std::string sign(const std::string& text) { return "<mo>" + text + "</mo>"; }
std::string row(const std::string& inside) { return "<mrow>" + inside + "</mrow>"; }
/// Brackets as tall as what they hold. What is inside has a row of its own, so that a minus at its
/// beginning is no difference.
std::string bracketed(const std::string& inside, bool tall) {
  const std::string begin = tall ? "<mo>" : "<mo stretchy=\"false\">";
  return begin + "(</mo>" + row(inside) + begin + ")</mo>";
}

/// A single letter slants by itself, a word stands upright.
std::string word_of(const std::string& word) {
  if (const auto greek = greek_letter_of(word)) return fmt::format("<mi>{}</mi>", greek->utf8);
  const bool digits =
      std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  const char* const element = digits ? "mn" : "mi";
  return fmt::format("<{0}>{1}</{0}>", element, word);
}

std::string index_of(const std::string& index) {
  std::string out;
  for (const std::string& part : parts_of_index(index)) {
    if (!out.empty()) out += sign(",");
    out += word_of(part);
  }
  return row(out);
}

std::string name_of(const FormulaNode& node) {
  std::string out;
  if (node.text == "d_sigma") {
    out = row("<mi mathvariant=\"normal\">Δ</mi><mi>σ</mi>");
  } else if (node.text == "d_tau") {
    out = row("<mi mathvariant=\"normal\">Δ</mi><mi>τ</mi>");
  } else if (const auto letter = differential_of(node.text); letter && node.index.empty()) {
    out = row(fmt::format("<mi mathvariant=\"normal\">d</mi><mi>{}</mi>", *letter));
  } else {
    out = word_of(node.text);
  }
  if (node.index.empty()) return out;
  return "<msub>" + out + index_of(node.index) + "</msub>";
}

std::string signed_number(const std::string& number) {
  if (!number.starts_with('-')) return "<mn>" + number + "</mn>";
  return row(sign(minus_sign) + "<mn>" + number.substr(1) + "</mn>");
}

std::string number_of(const FormulaNode& node) {
  const NumberParts number = parts_of_number(node.text);
  std::string out = "<mn>" + number.mantissa + "</mn>";
  if (!number.exponent.empty()) {
    out += sign("×") + "<msup><mn>10</mn>" + signed_number(number.exponent) + "</msup>";
  }
  for (const UnitPart& unit : parts_of_unit(node.index)) {
    if (unit.name == "deg") {
      out += "<mi mathvariant=\"normal\">°</mi>";
      continue;
    }
    const std::string name = "<mi mathvariant=\"normal\">" + unit.name + "</mi>";
    out += thin_space;
    out +=
        unit.exponent.empty() ? name : "<msup>" + name + signed_number(unit.exponent) + "</msup>";
  }
  return row(out);
}

std::string joined(const std::vector<FormulaNode>& parts, const std::string& between) {
  std::string out;
  for (const FormulaNode& part : parts) {
    if (!out.empty()) out += between;
    out += mathml_of(part);
  }
  return out;
}

std::string call_of(const FormulaNode& node) {
  if (node.text == "sqrt") return "<msqrt>" + joined(node.parts, sign(",")) + "</msqrt>";
  const std::string inside = joined(node.parts, sign(","));
  if (node.text == "abs") return row(sign("|") + inside + sign("|"));
  const Kind kind = node.parts.front().kind;
  const bool angle = node.text == "sin" || node.text == "cos" || node.text == "tan";
  const bool bare = angle && (kind == Kind::name || kind == Kind::number || kind == Kind::product);
  return row("<mi>" + node.text + "</mi>" +
             (bare ? thin_space + inside : bracketed(inside, is_tall(node))));
}

/// A group that is the whole of a place needs its brackets no longer.
std::string without_brackets(const FormulaNode& node) {
  return row(mathml_of(node.kind == Kind::group ? node.parts.front() : node));
}

std::string sum_of(const FormulaNode& node) {
  std::string out;
  for (const FormulaNode& part : node.parts) {
    const bool minus = part.kind == Kind::negative && !out.empty();
    if (minus)
      out += sign(minus_sign);
    else if (!out.empty())
      out += sign("+");
    out += mathml_of(minus ? part.parts.front() : part);
  }
  return out;
}

std::string exponent_of(const FormulaNode& node) {
  const FormulaNode& inner = node.kind == Kind::group ? node.parts.front() : node;
  if (inner.kind != Kind::fraction) return row(mathml_of(inner));
  return row(mathml_of(inner.parts[0]) + sign("/") + mathml_of(inner.parts[1]));
}

std::string relation_sign(const std::string& text) {
  if (text == "<=") return "≤";
  if (text == ">=") return "≥";
  if (text == "<") return "&lt;";
  return text == ">" ? "&gt;" : "=";
}

std::string mathml_of(const FormulaNode& node) {
  switch (node.kind) {
    case Kind::number: return number_of(node);
    case Kind::name: return name_of(node);
    case Kind::product: return joined(node.parts, thin_space);
    case Kind::times: return joined(node.parts, sign("×"));
    case Kind::fraction:
      return "<mfrac>" + without_brackets(node.parts[0]) + without_brackets(node.parts[1]) +
             "</mfrac>";
    case Kind::sum: return sum_of(node);
    case Kind::negative: return row(sign(minus_sign) + mathml_of(node.parts.front()));
    case Kind::power:
      return "<msup>" + row(mathml_of(node.parts[0])) + exponent_of(node.parts[1]) + "</msup>";
    case Kind::group: return row(bracketed(mathml_of(node.parts.front()), is_tall(node)));
    case Kind::call: return call_of(node);
    case Kind::derivative:
      return "<mfrac><mi mathvariant=\"normal\">d</mi>" +
             row(name_of({Kind::name, node.text, "", {}})) + "</mfrac>" +
             mathml_of(node.parts.front());
    case Kind::large: return sign(node.text == "sum" ? "∑" : "∫") + mathml_of(node.parts.front());
    case Kind::relation:
      return mathml_of(node.parts[0]) + sign(relation_sign(node.text)) + mathml_of(node.parts[1]);
  }
  return "";
}

/// A sign before a piece that stands alone: of a sum, though nothing is before it.
std::string outer_sign(const std::string& text) { return "<mo form=\"infix\">" + text + "</mo>"; }

void add_pieces(const FormulaNode& node, std::vector<std::string>& pieces) {
  if (node.kind == Kind::relation) {
    add_pieces(node.parts[0], pieces);
    std::vector<std::string> behind;
    add_pieces(node.parts[1], behind);
    behind.front() = outer_sign(relation_sign(node.text)) + behind.front();
    pieces.insert(pieces.end(), behind.begin(), behind.end());
    return;
  }
  if (node.kind != Kind::sum) {
    pieces.push_back(mathml_of(node));
    return;
  }
  for (const FormulaNode& part : node.parts) {
    const bool first = &part == &node.parts.front();
    const bool minus = part.kind == Kind::negative && !first;
    std::string piece = first ? "" : outer_sign(minus ? minus_sign : "+");
    pieces.push_back(piece + mathml_of(minus ? part.parts.front() : part));
  }
}

/// Words as they are.
std::string words_of(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return "<mtext>" + out + "</mtext>";
}

}  // namespace

std::string mathml_of_formula(const std::string& formula) {
  const auto tree = parse_formula(formula);
  return tree ? mathml_of(*tree) : words_of(formula);
}

std::vector<std::string> mathml_pieces_of_formula(const std::string& formula) {
  const auto tree = parse_formula(formula);
  if (!tree) return {words_of(formula)};
  std::vector<std::string> pieces;
  add_pieces(*tree, pieces);
  return pieces;
}

}  // namespace boxbeam::report
