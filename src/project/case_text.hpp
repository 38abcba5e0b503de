#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {

/// The bytes of a case file. Throws InputError where it cannot be read.
std::string read_case_text(const std::string& path);

/// Applies overrides to the document of a text that has none yet, and finds its hash.
void apply_overrides(CaseDocument& document, const std::string& text,
                     const std::vector<std::string>& overrides);

}  // namespace boxbeam
