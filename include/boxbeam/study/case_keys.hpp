#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"

/// Keys of a case as the command line and studies name them.
namespace boxbeam {

/// All keys whose values are numbers or quantities, in the order of the file.
std::vector<std::string> number_keys(const Node& root);

/// What to say of a key that a case has not: the nearest one whose value is a number, or "".
std::string nearest_number_key(const Node& root, const std::string& key);

/// What is wrong with a key, and what to write instead.
struct KeyTrouble {
  std::string what, hint;
};

/// Reads a case with settings "key=value", as --set has them; throws InputError.
using ReadWith = std::function<void(const std::vector<std::string>& set)>;

/// Whether designs can set a key of a case to values such as `first`, written as behind the "=" of
/// a setting: where the case has it, in its dimension; else where the case can be read with it, by
/// itself or with all that one of the designs sets. Nothing is wrong then.
std::optional<KeyTrouble> trouble_with_key(const CaseDocument& document, const std::string& key,
                                           const std::string& first,
                                           const std::vector<std::vector<std::string>>& designs,
                                           const ReadWith& read);

}  // namespace boxbeam
