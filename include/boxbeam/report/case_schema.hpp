#pragma once

#include <string>
#include <vector>

namespace boxbeam {

/// The documents of which there is a schema: "case", "results", "motion", "fatigue", "section",
/// "comparison".
std::vector<std::string> schema_names();

/// The JSON Schema (draft 2020-12) of a document. Throws InputError for another name.
std::string schema_of(const std::string& document);

}  // namespace boxbeam
