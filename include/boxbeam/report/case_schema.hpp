#pragma once

#include <string>
#include <vector>

namespace boxbeam {

/// The documents of which there is a schema: "case", "results", "motion", "fatigue", "section",
/// "comparison", "solution", "study"; and "keys", which is for people.
std::vector<std::string> schema_names();

/// The JSON Schema (draft 2020-12) of a document; of "keys" a reference in Markdown. Throws
/// InputError for another name.
std::string schema_of(const std::string& document);

}  // namespace boxbeam
