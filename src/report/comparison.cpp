#include "boxbeam/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/result_book.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "document_fields.hpp"

namespace boxbeam {

namespace {

constexpr double latest_time = 1e9;  // as of --at

/// An instant that keys name, as they write it.
struct NamedInstant {
  std::string text;
  double time = 0.0;
};

/// "1.071" of "motion[1.071].bodies.4.x".
std::optional<std::string_view> instant_in(std::string_view key) {
  constexpr std::string_view motion = "motion[";
  const std::size_t end = key.find(']');
  if (!key.starts_with(motion) || end == std::string_view::npos) return std::nullopt;
  return key.substr(motion.size(), end - motion.size());
}

std::optional<double> time_of(std::string_view text) {
  double time = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return std::abs(time) <= latest_time ? std::optional(time) : std::nullopt;
}

/// The motion at the instants that keys name, under these names.
std::vector<ResultValue> motion_values(const MotionAt& motion,
                                       const std::vector<NamedInstant>& instants) {
  std::vector<double> times;
  for (const NamedInstant& instant : instants) times.push_back(instant.time);
  const AnyMotionResult at_times = motion(times);
  std::vector<ResultValue> values =
      report::values_of("motion.", [&](report::Fields& to) { report::put_motion(to, at_times); });
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const std::string state = fmt::format("motion.states[{}]", i);
    for (ResultValue& value : values) {
      if (!value.key.starts_with(state)) continue;
      value.key.replace(0, state.size(), fmt::format("motion[{}]", instants[i].text));
    }
  }
  return values;
}

Problem problem_of(const PublishedValues& published, const PublishedValue& row, int column,
                   std::string message, std::string hint) {
  return {published.path, row.line, column, row.source_line, std::move(message), std::move(hint)};
}

/// The instants that the keys name, each once; what is wrong with them goes to the problems.
std::vector<NamedInstant> instants_in(const Project& project, const PublishedValues& published,
                                      std::vector<Problem>& problems) {
  const std::string obstacle = front_end_of(project)->obstacle_to_instants();
  std::vector<NamedInstant> instants;
  for (const PublishedValue& row : published.rows) {
    const auto text = instant_in(row.key);
    if (!text) continue;
    if (!obstacle.empty()) {
      problems.push_back(
          problem_of(published, row, row.key_column, obstacle,
                     "write motion.static. or motion.harmonic., then joints or points"));
      continue;
    }
    const auto time = time_of(*text);
    if (!time) {
      problems.push_back(problem_of(published, row, row.key_column,
                                    fmt::format("\"{}\" is no instant", *text),
                                    "write seconds without unit, for example motion[1.071]"));
      continue;
    }
    const auto same = [&](const NamedInstant& other) { return other.text == *text; };
    if (std::none_of(instants.begin(), instants.end(), same)) {
      instants.push_back({std::string(*text), *time});
    }
  }
  return instants;
}

DimensionExponents dimension_of(const std::string& unit) {
  if (unit == "1") return {};
  return std::get<ParsedQuantity>(parse_quantity("1 " + unit)).exponents;
}

ComparedValue compared(const PublishedValue& published, const ResultValue& ours) {
  constexpr double round_off = 1e-9;
  ComparedValue row;
  row.published = published;
  row.key = ours.key;
  row.unit = ours.unit;
  row.ours = ours.value;
  row.difference = ours.value - published.value.value;
  const double size = std::abs(published.value.value);
  row.tolerance = published.tolerance.value * (published.tolerance.relative ? size : 1.0);
  const bool within =
      std::abs(row.difference) <= row.tolerance + round_off * std::max(size, std::abs(row.ours));
  row.agreement = within                     ? Agreement::agrees
                  : published.reason.empty() ? Agreement::differs
                                             : Agreement::explained;
  return row;
}

}  // namespace

const char* to_text(Agreement agreement) {
  switch (agreement) {
    case Agreement::agrees: return "agrees";
    case Agreement::explained: return "differs, explained";
    case Agreement::differs: return "differs";
  }
  return "";
}

std::size_t Comparison::count(Agreement agreement) const {
  const auto same = [&](const ComparedValue& row) { return row.agreement == agreement; };
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), same));
}

Comparison compare(const Project& project, const Verification& verification,
                   const PublishedValues& published, const MotionAt& motion) {
  std::vector<Problem> problems;
  const std::vector<NamedInstant> instants = instants_in(project, published, problems);
  if (!problems.empty()) throw InputError(std::move(problems));
  ResultBook book = results_of(project, verification);
  const bool moves = std::any_of(published.rows.begin(), published.rows.end(),
                                 [](const auto& row) { return row.key.starts_with("motion"); });
  if (moves) book.add(motion_values(motion, instants));

  Comparison comparison;
  comparison.path = published.path;
  for (const PublishedValue& row : published.rows) {
    const ResultValue* const ours = book.find(row.key);
    if (ours == nullptr) {
      // Each hint looks through all results; who has very many wrong names has one mistake.
      constexpr std::size_t most_hints = 20;
      problems.push_back(problem_of(
          published, row, row.key_column, fmt::format("there is no result \"{}\"", row.key),
          problems.size() < most_hints ? book.hint_for(row.key)
                                       : "as those before: keys are paths into the JSON results"));
    } else if (dimension_of(ours->unit) != row.value.exponents) {
      problems.push_back(problem_of(
          published, row, row.value_column,
          fmt::format("{} is {}, but \"{}\" is {}", ours->key, name_of(dimension_of(ours->unit)),
                      row.written, name_of(row.value.exponents)),
          ours->unit == "1"
              ? "write it without unit"
              : fmt::format("write it with a unit of that kind, such as {}", ours->unit)));
    } else {
      comparison.rows.push_back(compared(row, *ours));
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return comparison;
}

}  // namespace boxbeam
