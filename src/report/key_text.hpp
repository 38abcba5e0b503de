#pragma once

#include <string>

namespace boxbeam::report {

/// Every key of a case with its value, its default and its meaning, as Markdown.
std::string key_reference_text();

}  // namespace boxbeam::report
