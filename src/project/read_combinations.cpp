#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "frame_reader.hpp"

namespace boxbeam::readers {
namespace {

/// What EN 1990 says of a load case.
struct CaseRule {
  bool permanent = false;
  double psi_0 = 1.0, psi_1 = 1.0, psi_2 = 1.0;
};

/// Partial factors. Source: EN 1990:2002, table A1.2(B); recommended values.
struct PartialFactors {
  double gamma_G_sup = 1.35, gamma_G_inf = 1.0, gamma_Q = 1.5, xi = 0.85;
};

/// The factors that a load case may have in a kind of combination, one of them in each.
using Choices = std::vector<std::vector<double>>;

/// How many combinations a case may have: each is verified as a situation of its own.
constexpr std::size_t most_combinations = 2000;

std::string name_of(const std::string& rule, const std::vector<double>& factors,
                    const frame::Structure& structure) {
  std::string text;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (factors[k] == 0.0) continue;
    text +=
        fmt::format("{}{:.5g} {}", text.empty() ? "" : " + ", factors[k], structure.cases[k].name);
  }
  return fmt::format("{}: {}", rule, text.empty() ? "nothing" : text);
}

Situation situation_of(const std::string& name, const std::vector<double>& factors,
                       const frame::Structure& structure) {
  Situation situation;
  situation.name = name;
  frame::Structure loaded = structure;
  loaded.factors = factors;
  situation.changed = std::move(loaded);
  return situation;
}

/// All ways to take one factor of each load case, each once.
class Combinations {
 public:
  Combinations(TableReader& table, const frame::Structure& structure)
      : table_(&table), structure_(&structure) {}

  void add(const std::string& rule, const Choices& choices, bool strength, bool serviceability) {
    std::vector<double> factors;
    add(rule, choices, factors, strength, serviceability);
  }

  std::vector<Situation> take() {
    if (found_.size() > most_combinations) {
      table_->problem("rule",
                      fmt::format("that makes more than {} combinations", most_combinations),
                      "put loads that come together into one load case, or write the "
                      "combinations that matter as [[combinations.sets]]");
      return {};
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& rule, const Choices& choices, std::vector<double>& factors,
           bool strength, bool serviceability) {
    if (found_.size() > most_combinations) return;
    if (factors.size() < choices.size()) {
      for (const double factor : choices[factors.size()]) {
        factors.push_back(factor);
        add(rule, choices, factors, strength, serviceability);
        factors.pop_back();
      }
      return;
    }
    const bool known = std::any_of(known_.begin(), known_.end(), [&](const Known& other) {
      return other.strength == strength && other.factors == factors;
    });
    if (known) return;
    known_.push_back({strength, factors});
    Situation situation = situation_of(name_of(rule, factors, *structure_), factors, *structure_);
    if (!strength) situation.load_factor = 0.0;
    situation.serviceability = serviceability;
    found_.push_back(std::move(situation));
  }

  struct Known {
    bool strength;
    std::vector<double> factors;
  };

  TableReader* table_;
  const frame::Structure* structure_;
  std::vector<Known> known_;
  std::vector<Situation> found_;
};

/// [load_cases]: which are permanent, and with what variable ones combine.
std::vector<CaseRule> read_case_rules(TableReader& root, const frame::Structure& structure,
                                      bool all_wanted) {
  std::vector<CaseRule> rules(structure.cases.size());
  std::vector<bool> said(rules.size(), false);
  const std::size_t before = root.problems().size();
  const int weight = index_by_name(structure.cases, "weight");
  if (weight >= 0) {
    rules[static_cast<std::size_t>(weight)].permanent = true;
    said[static_cast<std::size_t>(weight)] = true;
  }
  for (auto& [name, table] :
       root.table({"load_cases", "how they combine, each by the name of its case"}, false)
           .named_tables()) {
    CaseRule rule;
    rule.permanent = table.kind({"kind", "of the actions in it"}, {"permanent", "variable"}) == 0;
    if (!rule.permanent) {
      rule.psi_0 = table.any_number({"psi_0", "of its combination value; EN 1990, table A1.1"});
      rule.psi_1 = table.any_number({"psi_1", "of its frequent value"}, rule.psi_0);
      rule.psi_2 = table.any_number({"psi_2", "of its quasi-permanent value"}, rule.psi_1);
      for (const auto& [key, psi] :
           {std::pair{"psi_0", rule.psi_0}, {"psi_1", rule.psi_1}, {"psi_2", rule.psi_2}}) {
        // One that is not there is as the one before it, which has been looked at.
        if (!table.has(key) || (psi >= 0.0 && psi <= 1.0)) continue;
        table.problem(key, fmt::format("{} is from 0 to 1", key), "see EN 1990, table A1.1");
      }
    }
    table.finish();
    const int index = index_by_name(structure.cases, name);
    if (index < 0) {
      table.problem("", fmt::format("no load is in a case \"{}\"", name),
                    unknown_hint(name, names_of(structure.cases)));
      continue;
    }
    rules[static_cast<std::size_t>(index)] = rule;
    said[static_cast<std::size_t>(index)] = true;
  }
  // One that is misspelt is said already.
  const bool named = root.problems().size() == before;
  for (std::size_t k = 0; all_wanted && named && k < rules.size(); ++k) {
    if (said[k]) continue;
    root.problem("combinations",
                 fmt::format("how load case \"{}\" combines is not said", structure.cases[k].name),
                 fmt::format("write [load_cases.{}] with kind = \"permanent\", or kind = "
                             "\"variable\" and psi_0",
                             structure.cases[k].name));
  }
  return rules;
}

/// One combination for each leading variable action, and with none; `leading` and `beside` of the
/// variable ones, `permanent` of the others. What is favourable is left out.
template <class Factor>
void add_with_leaders(Combinations& combinations, const std::string& rule,
                      const std::vector<CaseRule>& rules, const std::vector<double>& permanent,
                      const Factor& leading, const Factor& beside, bool strength) {
  for (std::size_t leader = 0; leader < rules.size(); ++leader) {
    if (rules[leader].permanent) continue;
    Choices choices;
    for (std::size_t k = 0; k < rules.size(); ++k) {
      if (rules[k].permanent)
        choices.push_back(permanent);
      else if (k == leader)
        choices.push_back({leading(rules[k])});
      else
        choices.push_back({beside(rules[k]), 0.0});
    }
    combinations.add(rule, choices, strength, !strength);
  }
  Choices alone;
  for (const CaseRule& of : rules)
    alone.push_back(of.permanent ? permanent : std::vector<double>{0.0});
  combinations.add(rule, alone, strength, !strength);
}

void add_strength(TableReader& table, const std::vector<CaseRule>& rules,
                  Combinations& combinations) {
  const std::size_t rule =
      table.choice({"rule", "of EN 1990, 6.4.3.2, for strength"}, {"6.10", "6.10a/b", "none"}, 0);
  PartialFactors of;
  of.gamma_G_sup =
      table.number({"gamma_G", "on permanent actions that are unfavourable"}, of.gamma_G_sup);
  of.gamma_G_inf = table.number({"gamma_G_inf", "on those that are favourable"}, of.gamma_G_inf);
  of.gamma_Q = table.number({"gamma_Q", "on variable actions"}, of.gamma_Q);
  if (rule == 1) of.xi = table.number({"xi", "on gamma_G in 6.10b"}, of.xi);
  using Factor = std::function<double(const CaseRule&)>;
  const Factor full = [&](const CaseRule&) { return of.gamma_Q; };
  const Factor combined = [&](const CaseRule& with) { return of.gamma_Q * with.psi_0; };
  if (rule == 0) {
    add_with_leaders(combinations, "6.10", rules, {of.gamma_G_sup, of.gamma_G_inf}, full, combined,
                     true);
  } else if (rule == 1) {
    Choices choices;
    for (const CaseRule& with : rules) {
      choices.push_back(with.permanent ? std::vector{of.gamma_G_sup, of.gamma_G_inf}
                                       : std::vector{combined(with), 0.0});
    }
    combinations.add("6.10a", choices, true, false);
    add_with_leaders(combinations, "6.10b", rules, {of.xi * of.gamma_G_sup, of.gamma_G_inf}, full,
                     combined, true);
  }
}

void add_serviceability(TableReader& table, const std::vector<CaseRule>& rules,
                        Combinations& combinations) {
  using Factor = std::function<double(const CaseRule&)>;
  const Factor one = [](const CaseRule&) { return 1.0; };
  const Factor psi_0 = [](const CaseRule& of) { return of.psi_0; };
  const Factor psi_1 = [](const CaseRule& of) { return of.psi_1; };
  const Factor psi_2 = [](const CaseRule& of) { return of.psi_2; };
  const std::size_t kind = table.choice(
      {"deflection", "by which combinations of EN 1990, 6.5.3, deflections are judged"},
      {"characteristic", "frequent", "quasi-permanent"}, 0);
  const Factor& leading = kind == 0 ? one : kind == 1 ? psi_1 : psi_2;
  const Factor& beside = kind == 0 ? psi_0 : psi_2;
  constexpr const char* words[] = {"characteristic", "frequent", "quasi-permanent"};
  add_with_leaders(combinations, words[kind], rules, {1.0}, leading, beside, false);
}

/// Sets written by the user: each load case with its factor, or the least and the largest.
void add_sets(TableReader& table, const frame::Structure& structure, Combinations& combinations) {
  for (TableReader& set : table.tables({"sets", "combinations of one's own"})) {
    const std::string name = set.text({"name", "of the set"});
    TableReader factors =
        set.table({"factors", "of each load case: one number, or the least and the largest"});
    factors.accept_all();
    Choices choices(structure.cases.size(), {0.0});
    for (const Node::Member& member : factors.members("a number, or two")) {
      const int index = index_by_name(structure.cases, member.key);
      if (index < 0) {
        factors.problem(member.key, fmt::format("there is no load case \"{}\"", member.key),
                        unknown_hint(member.key, names_of(structure.cases)));
        continue;
      }
      std::vector<double>& of = choices[static_cast<std::size_t>(index)];
      of.clear();
      bool numbers = true;
      const auto take = [&](const Node& node) {
        numbers = numbers && node.kind == Node::Kind::number;
        of.push_back(node.number);
      };
      if (member.value.kind == Node::Kind::array)
        for (const Node& item : member.value.items) take(item);
      else
        take(member.value);
      if (!numbers || of.empty() || of.size() > 2) {
        factors.problem(member.key, "a load case has one factor, or the least and the largest",
                        "write for example wind = 1.5, or wind = [0.0, 1.5]");
        of = {0.0};
      }
    }
    set.finish();
    combinations.add(name, choices, true, false);
  }
}

}  // namespace

std::vector<Situation> read_combinations(TableReader& root, const frame::Structure& structure) {
  const bool asked = root.has("combinations");
  if (!asked && !root.has("load_cases")) return {};
  const std::size_t before = root.problems().size();
  const std::vector<CaseRule> rules = read_case_rules(root, structure, asked);
  if (!asked) {
    if (root.problems().size() == before) {
      root.problem("load_cases", "nothing asks for combinations of these load cases",
                   "write [combinations] with rule = \"6.10\", or remove [load_cases]");
    }
    return {};
  }
  TableReader table = root.table({"combinations", "of the load cases, by EN 1990"});
  Combinations combinations(table, structure);
  add_strength(table, rules, combinations);
  if (root.is_there("deflection"))
    add_serviceability(table, rules, combinations);
  else
    static_cast<void>(table.has("deflection"));
  add_sets(table, structure, combinations);
  table.finish();
  if (root.problems().size() != before) return {};
  std::vector<Situation> found = combinations.take();
  if (found.empty() && !root.has("situations") && root.problems().size() == before) {
    table.problem("rule", "no combination and no situation is left to be verified",
                  "write rule = \"6.10\", [[combinations.sets]] or [[situations]]");
  }
  return found;
}

std::vector<double> read_case_factors(TableReader& table, const frame::Structure& structure) {
  std::vector<double> factors(structure.cases.size(), 0.0);
  TableReader loads =
      table.table({"loads", "how often each load case counts: { weight = 1.0, lift = 1.2 }"});
  loads.accept_all();
  for (const Node::Member& member : loads.members("how often it counts")) {
    const int index = index_by_name(structure.cases, member.key);
    if (index < 0) {
      loads.problem(member.key, fmt::format("there is no load case \"{}\"", member.key),
                    unknown_hint(member.key, names_of(structure.cases)));
      continue;
    }
    if (member.value.kind != Node::Kind::number) {
      loads.problem(member.key, "how often a load case counts is a number",
                    fmt::format("write {} = 1.0", member.key));
      continue;
    }
    factors[static_cast<std::size_t>(index)] = member.value.number;
  }
  return factors;
}

}  // namespace boxbeam::readers
