#include "fuzz/case_promises.hpp"

#include <fmt/format.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/case_schema.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "boxbeam/verification/verify.hpp"

namespace fuzz {
namespace {

using namespace boxbeam;
using Json = nlohmann::json;

/// The keys that the schema of the results lets be null anywhere.
void collect_nullable(const Json& schema, const std::string& key, std::set<std::string>& names) {
  if (schema.is_object()) {
    const Json type = schema.value("type", Json());
    const bool null = type == "null" ||
                      (type.is_array() && std::count(type.begin(), type.end(), Json("null")) > 0);
    const Json values = schema.value("enum", Json());
    const bool among = values.is_array() && std::count(values.begin(), values.end(), Json()) > 0;
    if (null || among) names.insert(key);
    for (const auto& [name, part] : schema.items()) {
      const bool names_it = name == "properties" || name == "$defs";
      if (names_it && part.is_object()) {
        for (const auto& [member, of] : part.items()) collect_nullable(of, member, names);
      } else if (name != "properties") {
        collect_nullable(part, key, names);
      }
    }
  } else if (schema.is_array()) {
    for (const Json& part : schema) collect_nullable(part, key, names);
  }
}

const std::set<std::string>& nullable_names() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    collect_nullable(Json::parse(schema_of("results")), "", all);
    return all;
  }();
  return names;
}

/// The first thing in the results that is no number where one is promised, "" where none is. The
/// path to it is put together on the way back only: nearly always there is none to be named.
std::string trouble_in(const Json& node, const std::string& name) {
  if (node.is_null()) return nullable_names().count(name) == 1 ? "" : " is null";
  if (node.is_number_float()) {
    const double value = node.get<double>();
    if (!(std::abs(value) < 1e250)) return fmt::format(" is {}", value);
  }
  if (node.is_object()) {
    for (const auto& [key, member] : node.items()) {
      const std::string trouble = trouble_in(member, key);
      if (!trouble.empty()) return "." + key + trouble;
    }
  } else if (node.is_array()) {
    for (const Json& item : node) {
      const std::string trouble = trouble_in(item, item.is_null() ? "[]" : name);
      if (!trouble.empty()) return "[]" + trouble;
    }
  }
  return "";
}

std::string trouble_in_checks(const Verification& verification) {
  if (verification.checks.empty()) return "there is no check";
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (!(check.safety_factor > 0.0)) {
      return fmt::format("{}: the factor is {}", check.id, check.safety_factor);
    }
    if (!(check.utilisation() >= 0.0)) return check.id + ": the utilisation is none";
  }
  return "";
}

/// Words that numbers become which are none.
std::string trouble_in_text(const std::string& text, const std::string& input) {
  static const std::regex none(
      "(^|[^A-Za-z0-9_.])(-?nan|-?inf|[0-9.]+e\\+?2[5-9][0-9]|[0-9.]+e\\+?30[0-9])([^A-Za-z_0-9]|$"
      ")");
  std::smatch found;
  // Checksums are no numbers, whatever they look like.
  static const std::regex checksum("[0-9a-f]{64}");
  const std::string words = std::regex_replace(text, checksum, "");
  if (!std::regex_search(words, found, none)) return "";
  // A name or an assumption of the user's own stands in it as it was written.
  if (input.find(found[2].str()) != std::string::npos) return "";
  const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, found.position() - 60));
  return "the report says \"" + words.substr(from, 120) + "\"";
}

}  // namespace

Outcome outcome_of(const Mutant& mutant, bool with_report) {
  try {
    const Project project = parse_project(mutant.path, mutant.text);
    const Verification verification =
        verify(project, with_report ? Figures::with : Figures::without);
    std::string trouble = trouble_in_checks(verification);
    if (trouble.empty()) trouble = trouble_in(Json::parse(results_json(project, verification)), "");
    if (trouble.empty() && with_report) {
      trouble = trouble_in_text(
          report::text_of(report_of(project, verification, ReportLevel::governing)), mutant.text);
    }
    if (!trouble.empty()) return {Ending::broken, trouble};
    switch (verification.verdict) {
      case Verdict::pass: return {Ending::pass, ""};
      case Verdict::fail: return {Ending::fail, ""};
      case Verdict::not_applicable: return {Ending::not_applicable, ""};
    }
  } catch (const InputError& error) {
    const std::string words = error.what();
    return {words.empty() ? Ending::broken : Ending::refused, words};
  } catch (const AnalysisError& error) {
    const std::string words = error.what();
    return {words.empty() ? Ending::broken : Ending::impossible, words};
  } catch (const std::exception& error) {
    return {Ending::broken,
            fmt::format("an exception that has no cause to show: {}", error.what())};
  }
  return {Ending::broken, "no ending"};
}

}  // namespace fuzz
