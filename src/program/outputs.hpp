#pragma once

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"

/// What commands that write a folder of results share.
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
inline std::optional<std::string> svg_in(const std::string& folder, const std::string& name) {
  std::ifstream file(folder + "/" + name + ".svg", std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace boxbeam::program
