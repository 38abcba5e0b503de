#include "boxbeam/report/optimum_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "design_plots.hpp"
#include "document_fields.hpp"
#include "drawn_files.hpp"
#include "study_tables.hpp"

namespace boxbeam {
namespace {

using Named = OptimumReport::Named;

std::string amount(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

const std::string& unit_of(const OptimumReport& of, const std::string& choice) {
  for (std::size_t i = 0; i < of.choices.size(); ++i)
    if (of.choices[i].name == choice) return of.units[i];
  static const std::string none;
  return none;
}

/// "8 to 20 mm" or "one of 6, 8 to 20 mm".
std::string range_of(const Choice& choice, const std::string& unit) {
  if (choice.values.empty())
    return fmt::format("{:.6g} to {}", choice.from, amount(choice.to, unit));
  if (choice.values.size() == 1) return "the study gives no other";
  return fmt::format("one of {}, {:.6g} to {}", choice.values.size(), choice.values.front(),
                     amount(choice.values.back(), unit));
}

std::string holds(const OptimumReport& of, const ActiveLimit& active) {
  if (active.kind == ActiveLimit::Kind::limit) return active.name;
  for (const Choice& choice : of.choices) {
    if (choice.name != active.name) continue;
    const bool least = active.kind == ActiveLimit::Kind::lower_bound;
    return fmt::format("{} at its {}", choice.name, least ? "least" : "most");
  }
  return active.name;
}

/// "1 % more use allowed: 12.3 kg less".
std::string worth(const OptimumReport& of, const ActiveLimit& active) {
  if (!active.price) return "the next smaller design does not keep it";
  const std::string& unit = of.goals.front().unit;
  if (active.kind != ActiveLimit::Kind::limit) {
    const std::string& own = unit_of(of, active.name);
    return fmt::format("{} {}: {} less", amount(1.0, own),
                       active.kind == ActiveLimit::Kind::lower_bound ? "lower" : "higher",
                       amount(*active.price, unit));
  }
  constexpr double percent = 0.01;
  const auto is_check = [&] {
    return std::any_of(criteria.begin(), criteria.end(),
                       [&](Criterion c) { return active.name == to_text(c); });
  };
  return is_check() ? fmt::format("1 % more use: {} less", amount(percent * *active.price, unit))
                    : fmt::format("1 lower: {} less", amount(*active.price, unit));
}

std::string effort(const Optimum& optimum) {
  std::string text = fmt::format("{} designs", optimum.evaluations);
  if (optimum.exhaustive)
    text += ", every combination of the lists";
  else
    text += fmt::format(", {} searches of which {} ended here", optimum.starts, optimum.agreeing);
  if (optimum.troubled > 0)
    text += fmt::format("; {} could not be judged, the first: {}", optimum.troubled,
                        optimum.first_trouble);
  return text;
}

std::string confirmation(const Optimum& optimum) {
  if (!optimum.confirmed) return "not confirmed: " + optimum.reason;
  if (optimum.imbalance)
    return fmt::format("slopes of the goal and of what holds it balance to {:.1g}",
                       std::max(*optimum.imbalance, 1e-12));
  return optimum.exhaustive ? "no other combination is better" : "no neighbour is better";
}

}  // namespace

layout::Table report::front_table(const OptimumReport& of) {
  std::vector<std::string> heads;
  for (const Named& goal : of.goals)
    heads.push_back(goal.unit.empty() ? goal.name : fmt::format("{} [{}]", goal.name, goal.unit));
  for (std::size_t i = 0; i < of.choices.size(); ++i)
    heads.push_back(of.units[i].empty() ? of.choices[i].name
                                        : fmt::format("{} [{}]", of.choices[i].name, of.units[i]));
  layout::Table table(heads);
  for (const FrontPoint& point : of.front) {
    std::vector<std::string> row;
    for (const double goal : point.goals) row.push_back(fmt::format("{:.6g}", goal));
    for (const double value : point.values) row.push_back(fmt::format("{:.6g}", value));
    table.row(row);
  }
  return table;
}

layout::Table report::chosen_table(const OptimumReport& of) {
  layout::Table chosen({"variable", "chosen", "of"});
  for (std::size_t i = 0; i < of.choices.size(); ++i)
    chosen.row({of.choices[i].name, amount(of.optimum.best->values[i], of.units[i]),
                range_of(of.choices[i], of.units[i])});
  for (const auto& [named, value] : of.following)
    chosen.row({named.name, amount(value, named.unit), "an expression"});
  return chosen;
}

layout::Table report::active_table(const OptimumReport& of) {
  layout::Table active({"what holds it", "what it is worth"});
  for (const ActiveLimit& one : of.optimum.active) active.row({holds(of, one), worth(of, one)});
  return active;
}

std::vector<std::pair<std::string, std::string>> report::optimum_facts(const OptimumReport& of) {
  std::vector<std::pair<std::string, std::string>> facts;
  const Optimum& optimum = of.optimum;
  if (!optimum.best) return {{"searched", effort(optimum)}, {"no design", optimum.reason}};
  facts.emplace_back("least", amount(optimum.best->goal, of.goals.front().unit));
  if (!of.verdict.empty())
    facts.emplace_back("verdict", of.governing.empty()
                                      ? of.verdict
                                      : fmt::format("{}, {} used {:.1f} %", of.verdict,
                                                    of.governing, 100.0 * of.utilisation));
  if (!of.not_judged.empty())
    facts.emplace_back("not judged", fmt::format("{}", fmt::join(of.not_judged, "; ")));
  facts.emplace_back("searched", effort(optimum));
  facts.emplace_back("check", confirmation(optimum));
  return facts;
}

report::MarkedText optimum_text(const OptimumReport& of) {
  const Optimum& optimum = of.optimum;
  std::string text = layout::heading(fmt::format("{}: least {}", of.study, of.goals.front().name));
  if (!optimum.best) {
    text += layout::entry("searched", effort(optimum)) + "\n";
    text += layout::paragraph("no design: " + optimum.reason);
    return text;
  }
  for (const auto& [name, says] : report::optimum_facts(of)) text += layout::entry(name, says);
  text += "\n" + report::chosen_table(of).text() + "\n";
  text += optimum.active.empty()
              ? layout::paragraph("Nothing holds it: the goal has its least between the bounds.")
              : report::active_table(of).text();
  if (!of.front.empty()) {
    text += "\n" + layout::paragraph(fmt::format("Front of {} and {}: neither can be less but for "
                                                 "more of the other.",
                                                 of.goals[0].name, of.goals[1].name));
    text += report::front_table(of).text();
  }
  return text;
}

namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

Numbers named_values(const OptimumReport& of, const std::vector<double>& values) {
  Numbers named;
  for (std::size_t i = 0; i < values.size(); ++i) named.emplace_back(of.choices[i].name, values[i]);
  return named;
}

/// Of all variables, those that follow from others too.
std::vector<Named> variables_of(const OptimumReport& of) {
  std::vector<Named> all;
  for (std::size_t i = 0; i < of.choices.size(); ++i)
    all.push_back({of.choices[i].name, of.units[i]});
  for (const auto& [named, value] : of.following) all.push_back(named);
  return all;
}

Numbers best_values(const OptimumReport& of) {
  if (!of.optimum.best) return {};
  Numbers variables = named_values(of, of.optimum.best->values);
  for (const auto& [named, value] : of.following) variables.emplace_back(named.name, value);
  return variables;
}

}  // namespace

void report::put_optimum(Fields& to, const OptimumReport& of) {
  const Optimum& optimum = of.optimum;
  to.constant("schema", "boxbeam.optimum/1");
  to.text({"study", "its file"}, of.study);
  to.texts({"goals", "what is to be least"}, [&] {
    std::vector<std::string> names;
    for (const Named& goal : of.goals) names.push_back(goal.name);
    return names;
  });
  to.named_numbers({"variables", "of the best design; empty where there is none"}, best_values(of));
  to.list({"units", "of the variables"}, "", variables_of(of),
          [](Fields& fields, const Named& one) {
            fields.text("variable", one.name);
            fields.text({"unit", "as the study has it; empty without"}, one.unit);
          });
  to.number_or_null({"objective", "the least of the first goal, SI; null where there is none"}, "1",
                    optimum.best ? std::optional(optimum.best->goal) : std::nullopt);
  to.boolean({"confirmed", "the conditions of an optimum hold, or no other design is better"},
             optimum.confirmed);
  to.text({"reason", "why there is none, or why it is not confirmed"}, optimum.reason);
  std::vector<std::string> active;
  Numbers prices;
  for (const ActiveLimit& one : optimum.active) {
    active.push_back(one.name);
    if (one.price) prices.emplace_back(one.name, *one.price);
  }
  to.texts({"active", "limits and bounds that hold it"}, active);
  to.named_numbers({"prices",
                    "by how much the objective falls for one unit more of each: a margin, "
                    "a check used by 1, a bound moved outwards in its unit"},
                   prices);
  to.text({"verdict", "of the case there; empty without a case"}, of.verdict);
  to.text({"governing", "id of the check that is used most"}, of.governing);
  to.number({"utilisation", "of it"}, "1", of.utilisation);
  to.texts({"not_judged", "what the case asks for there without an answer"}, of.not_judged);
  to.list({"front", "of two goals: neither can be less but for more of the other"}, "", of.front,
          [&](Fields& fields, const FrontPoint& point) {
            fields.named_numbers("variables", named_values(of, point.values));
            std::vector<std::size_t> places(point.goals.size());
            std::iota(places.begin(), places.end(), std::size_t{0});
            fields.list("goals", "", places, [&](Fields& one, std::size_t k) {
              const Named goal = k < of.goals.size() ? of.goals[k] : Named{};
              one.text("goal", goal.name);
              one.text({"unit", "SI; 1 without"}, goal.unit.empty() ? "1" : goal.unit);
              one.number_in("value", "", "unit", k < point.goals.size() ? point.goals[k] : 0.0);
            });
          });
  to.boolean({"exhaustive", "every combination of the lists was looked at"}, optimum.exhaustive);
  to.whole({"starts", "searches"}, optimum.starts);
  to.whole({"agreeing", "of them, that ended at the objective"}, optimum.agreeing);
  to.whole({"evaluations", "designs that were judged"}, optimum.evaluations);
  to.whole({"failed", "of them, that could not be"}, optimum.troubled);
}

std::string optimum_json(const OptimumReport& of) {
  return report::document_text([&](report::Fields fields) { report::put_optimum(fields, of); });
}

std::vector<std::string> draw_optimum(const OptimumReport& of, const std::string& folder) {
  std::vector<DrawnFigure> figures;
  const auto add = [&](const char* name, std::optional<plot::Drawing> drawing) {
    if (drawing) figures.push_back({name, [drawn = *std::move(drawing)] { return drawn; }});
  };
  add("front", plot::front(of));
  add("parallel", plot::parallel_axes(of.judged));
  return figures.empty() ? std::vector<std::string>() : draw_into(folder, "", figures);
}

std::vector<std::string> files_of_optimum() {
  return {"optimum.json", "optimum.html", "front.svg", "parallel.svg"};
}

}  // namespace boxbeam
