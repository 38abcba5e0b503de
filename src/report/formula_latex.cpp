#include <fmt/format.h>

#include <sstream>

#include "boxbeam/report/formula.hpp"
#include "boxbeam/report/formula_tree.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "formula_names.hpp"

namespace boxbeam::report {
namespace {

using Kind = FormulaNode::Kind;

/// Where a part stands: on the line, where it may break, or inside of something.
enum class Level { line, inside, exponent };

std::string latex_of(const FormulaNode& node, Level level);

/// Brackets as tall as what they hold. Those on the line are of a fixed size, for what stands
/// between \left and \right cannot break.
std::string bracketed(const std::string& inside, bool tall, Level level) {
  if (!tall) return "(" + inside + ")";
  return level == Level::line ? "\\Bigl(" + inside + "\\Bigr)" : "\\left(" + inside + "\\right)";
}

std::string upright(const std::string& word) { return "\\mathrm{" + word + "}"; }

std::string word_of(const std::string& word) {
  if (const auto greek = greek_letter_of(word)) return std::string(greek->latex);
  return word.size() == 1 ? word : upright(word);
}

std::string index_of(const std::string& index) {
  std::string out;
  for (const std::string& part : parts_of_index(index)) {
    if (!out.empty()) out += ",";
    out += word_of(part);
  }
  return out;
}

std::string name_of(const FormulaNode& node) {
  std::string out;
  if (node.text == "d_sigma") {
    out = "\\Delta\\sigma";
  } else if (node.text == "d_tau") {
    out = "\\Delta\\tau";
  } else if (const auto letter = differential_of(node.text); letter && node.index.empty()) {
    out = fmt::format("\\mathrm{{d}}{}", *letter);
  } else {
    out = word_of(node.text);
  }
  if (!node.index.empty()) out += "_{" + index_of(node.index) + "}";
  return out;
}

std::string number_of(const FormulaNode& node) {
  const NumberParts number = parts_of_number(node.text);
  std::string out = number.mantissa;
  if (!number.exponent.empty()) out += fmt::format("\\times 10^{{{}}}", number.exponent);
  for (const UnitPart& unit : parts_of_unit(node.index)) {
    if (unit.name == "deg") {
      out += "^{\\circ}";
      continue;
    }
    out += "\\," + (unit.name == "%" ? "\\%" : upright(unit.name));
    if (!unit.exponent.empty()) out += "^{" + unit.exponent + "}";
  }
  // In braces a number stays together with its power and unit.
  return out == node.text ? out : "{" + out + "}";
}

std::string joined(const std::vector<FormulaNode>& parts, const std::string& between, Level level) {
  std::string out;
  for (const FormulaNode& part : parts) {
    if (!out.empty()) out += between;
    out += latex_of(part, level);
  }
  return out;
}

std::string call_of(const FormulaNode& node, Level level) {
  const FormulaNode& first = node.parts.front();
  if (node.text == "sqrt") return "\\sqrt{" + joined(node.parts, ",", Level::inside) + "}";
  if (node.text == "abs") {
    return "\\left|" + joined(node.parts, ",", Level::inside) + "\\right|";
  }
  const std::string name = "\\" + node.text;
  const bool bare = node.parts.size() == 1 &&
                    (first.kind == Kind::name || first.kind == Kind::number ||
                     (first.kind == Kind::product && first.parts.size() <= 2 && !is_tall(first)));
  const bool angle = node.text == "sin" || node.text == "cos" || node.text == "tan";
  if (bare && angle) return name + " " + joined(node.parts, ",", level);
  return name + bracketed(joined(node.parts, ",\\, ", Level::inside), is_tall(node), level);
}

std::string fraction_of(const FormulaNode& node, Level level) {
  // A group that is the whole of one side needs its brackets no longer.
  const auto side = [](const FormulaNode& part, Level at) {
    return part.kind == Kind::group ? latex_of(part.parts.front(), at) : latex_of(part, at);
  };
  if (level == Level::exponent) {
    return latex_of(node.parts[0], level) + "/" + latex_of(node.parts[1], level);
  }
  return "\\frac{" + side(node.parts[0], Level::inside) + "}{" +
         side(node.parts[1], Level::inside) + "}";
}

std::string sum_of(const FormulaNode& node, Level level) {
  std::string out;
  for (const FormulaNode& part : node.parts) {
    const bool minus = part.kind == Kind::negative;
    const FormulaNode& term = minus ? part.parts.front() : part;
    if (minus)
      out += out.empty() ? "-" : " - ";
    else if (!out.empty())
      out += " + ";
    out += latex_of(term, level);
  }
  return out;
}

std::string power_of(const FormulaNode& node) {
  const FormulaNode& base = node.parts[0];
  const FormulaNode& exponent = node.parts[1];
  const std::string raised = exponent.kind == Kind::group
                                 ? latex_of(exponent.parts.front(), Level::exponent)
                                 : latex_of(exponent, Level::exponent);
  return "{" + latex_of(base, Level::inside) + "}^{" + raised + "}";
}

std::string relation_of(const FormulaNode& node, Level level) {
  const std::string sign = node.text == "<=" ? "\\le" : (node.text == ">=" ? "\\ge" : node.text);
  return latex_of(node.parts[0], level) + " " + sign + " " + latex_of(node.parts[1], level);
}

std::string latex_of(const FormulaNode& node, Level level) {
  switch (node.kind) {
    case Kind::number: return number_of(node);
    case Kind::name: return name_of(node);
    case Kind::product: return joined(node.parts, "\\,", level);
    case Kind::times: return joined(node.parts, " \\times ", level);
    case Kind::fraction: return fraction_of(node, level);
    case Kind::sum: return sum_of(node, level);
    case Kind::negative: return "-" + latex_of(node.parts.front(), level);
    case Kind::power: return power_of(node);
    case Kind::group: return bracketed(latex_of(node.parts.front(), level), is_tall(node), level);
    case Kind::call: return call_of(node, level);
    case Kind::derivative:
      return fmt::format("\\frac{{\\mathrm{{d}}}}{{{}}}",
                         name_of({Kind::name, node.text, "", {}})) +
             latex_of(node.parts.front(), Level::inside);
    case Kind::large: return "\\" + node.text + " " + latex_of(node.parts.front(), level);
    case Kind::relation: return relation_of(node, level);
  }
  return "";
}

/// Words as they are, which may break between them.
std::string words_of(const std::string& text) {
  std::istringstream words(text);
  std::string out, word;
  while (words >> word) {
    if (!out.empty()) out += "\\allowbreak\\ ";
    out += "\\mbox{" + latex_escaped(word) + "}";
  }
  return out;
}

}  // namespace

std::string latex_of_formula(const std::string& formula) {
  const auto tree = parse_formula(formula);
  return tree ? latex_of(*tree, Level::line) : words_of(formula);
}

}  // namespace boxbeam::report
