#pragma once

#include <string>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {

/// A tree as the text of a TOML file that reads back as the same tree: the values of a table first,
/// then its tables and lists of tables under headings of their own. Comments and the way in which
/// numbers were written are not kept; a date stands as text. Source: TOML 1.0.
std::string toml_text(const Node& root);

/// A text in quotes, and a key, in them where it needs them.
std::string toml_quoted(const std::string& text);
std::string toml_key(const std::string& key);

}  // namespace boxbeam
