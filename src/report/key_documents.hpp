#pragma once

#include <string>

namespace boxbeam::report {

/// The JSON Schema (2020-12) of a case, written from what its reader asks for.
std::string schema_of_case();

/// Every key of a case with its value, its default and its meaning, as Markdown.
std::string key_reference_text();

}  // namespace boxbeam::report
