#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// A symbol's value in SI units; of whatever dimension.
double value_of_symbol(TableReader& table, const Node::Member& member) {
  if (member.value.kind == Node::Kind::number) return member.value.number;
  if (member.value.kind == Node::Kind::text) {
    const auto parsed = parse_quantity(member.value.text);
    if (const auto* quantity = std::get_if<ParsedQuantity>(&parsed)) return quantity->value;
    table.problem(member.key, fmt::format("\"{}\": {}", member.key, std::get<std::string>(parsed)),
                  "write a number, or a quantity with its unit: \"0.1 rad\"");
    return 0.0;
  }
  table.problem(member.key, fmt::format("\"{}\" is no value", member.key),
                "write a number, or a quantity with its unit: \"0.1 rad\"");
  return 0.0;
}

using Symbols = std::map<std::string, double>;

/// The value of one component; notes what is wrong with the formula.
double evaluated(TableReader& table, const std::string& formula, const Symbols& symbols) {
  try {
    mu::Parser parser;
    for (const auto& [name, value] : symbols) parser.DefineConst(name, value);
    parser.SetExpr(formula);
    const double value = parser.Eval();
    if (std::isfinite(value)) return value;
    table.problem("formula", fmt::format("\"{}\" has no finite value", formula),
                  "look for a division by zero");
  } catch (const mu::Parser::exception_type& error) {
    table.problem("formula", fmt::format("\"{}\": {}", formula, error.GetMsg()),
                  "write it with + - * / ^, sin, cos, sqrt and the names of [hand_symbols]");
  }
  return 0.0;
}

HandFormula read_one(TableReader& table, const Symbols& symbols,
                     const spatial::Mechanism& mechanism) {
  using Quantity = HandFormula::Quantity;
  HandFormula hand;
  hand.name = table.text({"name", "of the formula"});
  hand.note = table.text({"note", "for the report"}, "");
  hand.time = si<Time>(table.quantity({"time", "when it is compared"}, wanted::time, 0.0));
  hand.quantity = static_cast<Quantity>(table.choice(
      {"quantity", "what it gives"}, {"omega", "alpha", "position", "velocity", "acceleration"}));
  if (hand.quantity == Quantity::omega || hand.quantity == Quantity::alpha)
    hand.body = body_of(table, {"of", "the body"}, mechanism);
  else
    hand.point = attachment_of(table, {"of", "the point"}, mechanism);
  hand.formula = table.texts({"formula", "its three components, world axes"}, true);
  if (hand.formula.size() == 3) {
    for (int k = 0; k < 3; ++k) {
      hand.value[k] = evaluated(table, hand.formula[static_cast<std::size_t>(k)], symbols);
    }
  } else if (table.problems().empty()) {
    table.problem("formula", "a vector has three components",
                  "write formula = [\"...\", \"...\", \"...\"], world axes");
  }
  table.finish();
  return hand;
}

}  // namespace

std::vector<HandFormula> read_hand_formulas(TableReader& root,
                                            const spatial::Mechanism& mechanism) {
  Symbols symbols;
  TableReader table =
      root.table({"hand_symbols", "what stands in the formulas: numbers or quantities"}, false);
  table.accept_all();
  for (const Node::Member& member : table.members("a number, or a quantity with its unit")) {
    const bool plain = std::all_of(member.key.begin(), member.key.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_';
    });
    if (member.key.empty() || !plain || std::isdigit(static_cast<unsigned char>(member.key[0]))) {
      table.problem(member.key, fmt::format("\"{}\" cannot stand in a formula", member.key),
                    "letters, digits and \"_\", a letter first: w_g");
      continue;
    }
    symbols[member.key] = value_of_symbol(table, member);
  }
  std::vector<HandFormula> formulas;
  for (TableReader& one :
       root.tables({"hand_formulas", "formulas of your own, printed beside the results"})) {
    formulas.push_back(read_one(one, symbols, mechanism));
  }
  return formulas;
}

}  // namespace boxbeam::readers
