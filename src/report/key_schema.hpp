#pragma once

#include <string>

namespace boxbeam::report {

/// The JSON Schema (2020-12) of a case, written from what its reader asks for.
std::string schema_of_case();

}  // namespace boxbeam::report
