#include "boxbeam/report/case_schema.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "key_schema.hpp"
#include "key_text.hpp"
#include "schema_data.hpp"

namespace boxbeam {
namespace {

struct Schema {
  const char* document;
  const char* text;
};

constexpr Schema schemas[] = {{"results", schema_data::results},
                              {"motion", schema_data::motion},
                              {"fatigue", schema_data::fatigue},
                              {"section", schema_data::section},
                              {"comparison", schema_data::comparison}};

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
    if (document == schema.document) return schema.text;
  }
  const std::string near = nearest_word(document, schema_names());
  throw InputError(fmt::format("there is no schema \"{}\"", document),
                   near.empty() ? fmt::format("one of {}", fmt::join(schema_names(), ", "))
                                : fmt::format("did you mean {}?", near));
}

}  // namespace boxbeam
