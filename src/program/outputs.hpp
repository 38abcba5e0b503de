#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"

/// What commands that write files share.
namespace boxbeam::program {

/// Does what may fail without the rest; whether it did not, else why not.
template <class Write>
bool attempt(std::vector<std::string>& troubles, const Write& write) {
  try {
    write();
    return true;
  } catch (const OutputError& error) {
    troubles.emplace_back(error.what());
    return false;
  }
}

/// The content of a figure in a folder, where it stands there.
std::optional<std::string> svg_in(const std::string& folder, const std::string& name);

/// Whether a result can be written to where the user wants it, before it is calculated. All throw
/// OutputError. A file stands in a folder that is there: none is made for it; "" and "-" are none.
void require_file(const std::string& path);
/// Likewise; but the folder of the report is made with the report.
void require_file_beside(const std::string& path, const std::string& folder);
/// A folder that is there and can be written to, or can be made.
void require_folder(const std::string& path);

}  // namespace boxbeam::program
