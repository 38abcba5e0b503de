#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"

/// Keys of a case as the command line names them.
namespace boxbeam::program {

/// All keys whose values are numbers or quantities, in the order of the file.
std::vector<std::string> number_keys(const Node& root);

/// What to say of a key that a case has not: the nearest one whose value is a number, or "".
std::string nearest_number_key(const Node& root, const std::string& key);

}  // namespace boxbeam::program
