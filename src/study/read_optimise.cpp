#include "read_optimise.hpp"

#include <fmt/format.h>

#include "boxbeam/study/named_expression.hpp"

namespace boxbeam {

void read_optimise(TableReader& root, Study& study) {
  if (!root.has({"optimise", "what boxbeam optimise is to find"})) return;
  OptimiseDemand demand;
  TableReader table = root.table("optimise");
  const Key goals{"minimise", "one goal or two, of variables and results: \"beam.mass\""};
  if (!table.has(goals) || table.peek("minimise")->kind == Node::Kind::text)
    demand.minimise.push_back(table.text(goals));
  else
    demand.minimise = table.texts(goals, true);
  if (demand.minimise.size() > 2)
    table.problem("minimise", "more than two goals", "write one, or two for a front of both");
  for (const std::string& limit :
       table.texts({"subject_to", "\"checks\", and expressions that are not below zero"}, false)) {
    if (is_condition(limit))
      table.problem("subject_to", fmt::format("\"{}\" is 1 or 0, which is never below zero", limit),
                    "write what must not fall below zero: \"fatigue.safety_factor - 2\"");
    if (limit == "checks")
      demand.checks = true;
    else
      demand.subject_to.push_back(limit);
  }
  if (!table.is_there("subject_to")) demand.checks = !study.case_file.empty();
  if (demand.checks && study.case_file.empty())
    table.problem("subject_to", "there are no checks without a case",
                  "write case = \"...\" in [study], or expressions");
  constexpr int most = 1'000'000;
  const auto count = [&](const Key& key, std::size_t& value, int least) {
    const int written = table.whole_number(key, static_cast<int>(value));
    if (written < least || written > most)
      table.problem(key.name, fmt::format("\"{}\" is {}", key.name, written),
                    fmt::format("write {} to {}", least, most));
    else
      value = static_cast<std::size_t>(written);
  };
  count({"starts", "of searches, the first in the middle"}, demand.starts, 1);
  count({"designs", "at most, of all combinations of lists"}, demand.designs, 1);
  count({"points", "of the front of two goals"}, demand.points, 2);
  for (const Variable& variable : study.variables) {
    if (variable.is_of_table)
      table.problem("", fmt::format("variable \"{}\" goes with a table of designs", variable.name),
                    "an optimum chooses each by itself: write values, or grid with its ends");
    if (!variable.words.empty())
      table.problem("", fmt::format("variable \"{}\" is a list of words", variable.name),
                    "an optimum is of numbers: sweep tries words");
    if (variable.distribution && variable.distribution->kind != DistributionKind::uniform)
      table.problem("", fmt::format("variable \"{}\" scatters", variable.name),
                    "an optimum chooses: write values, or grid with its ends");
  }
  table.finish();
  study.optimise = std::move(demand);
}

}  // namespace boxbeam
