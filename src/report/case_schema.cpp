#include "boxbeam/report/case_schema.hpp"

#include <fmt/format.h>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "document_fields.hpp"
#include "key_documents.hpp"

namespace boxbeam {
namespace {

constexpr const char* units =
    "SI units: m, kg, s, N, Pa, rad, Hz. \"x-unit\" is the unit of a number; \"x-key\" names the "
    "entries of a list and \"x-names\" the numbers of one, as the keys of `boxbeam compare` do.";

Json head(const char* document, const char* title) {
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"$id", fmt::format("urn:boxbeam:schema:{}:1", document)},
          {"title", title},
          {"description", units}};
}

/// The schema of what `put` says.
template <class Put>
Json described(Json schema, const Put& put) {
  report::Fields to = report::Fields::describing(schema);
  put(to);
  return schema;
}

template <class Motion>
Json motion_of_kind() {
  return described(Json::object(), [](report::Fields& to) { report::put_motion(to, Motion{}); });
}

Json schema_of_results() {
  return described(head("results", "Results of a verification (boxbeam verify --json)"),
                   [](report::Fields& to) { report::put_results(to, {}, {}); });
}

Json schema_of_motion() {
  Json schema = head("motion", "Motion of a mechanism (boxbeam motion --json)");
  schema["oneOf"] = {motion_of_kind<MotionResult>(), motion_of_kind<ChainMotionResult>(),
                     motion_of_kind<FlexibleMotionResult>()};
  return schema;
}

Json schema_of_fatigue() {
  return described(head("fatigue", "Fatigue of a stress history (boxbeam fatigue --json)"),
                   [](report::Fields& to) { report::put_history(to, {}, {}); });
}

Json schema_of_section() {
  Json schema = head("section", "Properties of sections (boxbeam section --json)");
  const Json one =
      described(Json::object(), [](report::Fields& to) { report::put_section_summary(to, {}); });
  schema["oneOf"] = {one,
                     {{"type", "array"}, {"items", one}, {"description", "of several sections"}}};
  return schema;
}

Json schema_of_comparison() {
  return described(
      head("comparison", "Published values beside the program's (boxbeam compare --json)"),
      [](report::Fields& to) { report::put_comparison(to, {}, {}); });
}

Json schema_of_solution() {
  return described(head("solution", "Values that give a wanted result (boxbeam solve --json)"),
                   [](report::Fields& to) { report::put_solution(to, {}); });
}

Json schema_of_optimum() {
  return described(head("optimum", "The best design of a study (boxbeam optimise --json)"),
                   [](report::Fields& to) { report::put_optimum(to, {}); });
}

Json schema_of_study() {
  return described(head("study", "Designs of a study (boxbeam sweep --json)"),
                   [](report::Fields& to) { report::put_study(to, {}); });
}

Json schema_of_reliability() {
  return described(head("reliability", "Probability of failure (boxbeam reliability --json)"),
                   [](report::Fields& to) { report::put_reliability(to, {}); });
}

struct Schema {
  const char* document;
  Json (*schema)();
};

constexpr Schema schemas[] = {
    {"results", schema_of_results},        {"motion", schema_of_motion},
    {"fatigue", schema_of_fatigue},        {"section", schema_of_section},
    {"comparison", schema_of_comparison},  {"solution", schema_of_solution},
    {"optimum", schema_of_optimum},        {"study", schema_of_study},
    {"reliability", schema_of_reliability}};

}  // namespace

std::vector<std::string> schema_names() {
  std::vector<std::string> names{"case"};
  for (const Schema& schema : schemas) names.emplace_back(schema.document);
  names.emplace_back("keys");
  return names;
}

std::string schema_of(const std::string& document) {
  if (document == "case") return report::schema_of_case();
  if (document == "keys") return report::key_reference_text();
  for (const Schema& schema : schemas) {
    if (document == schema.document) return schema.schema().dump(1) + "\n";
  }
  const std::string near = nearest_word(document, schema_names());
  throw InputError(fmt::format("there is no schema \"{}\"", document),
                   near.empty() ? fmt::format("one of {}", fmt::join(schema_names(), ", "))
                                : fmt::format("did you mean {}?", near));
}

}  // namespace boxbeam
