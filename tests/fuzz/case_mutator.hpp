#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"

/// Cases made of the shipped ones by changes that a hand could make, and by wilder ones.
namespace fuzz {

/// A case to begin from: its path, from which its tables are found, and its tree.
struct Origin {
  std::string path;
  boxbeam::Node tree;
  bool small = false;  ///< made for speed: it stands in a folder small/
};

/// The cases of the project and those that were kept since: *.toml of folders, the small ones
/// first.
std::vector<Origin> origins_in(const std::vector<std::string>& folders);

/// A changed case.
struct Mutant {
  std::string path;        ///< of its origin
  std::string text;        ///< TOML
  std::size_t origin = 0;  ///< index
};

/// The case of a number, always the same: one to six changes of one of the origins, parts of others
/// spliced in. Values, units, signs, numbers, words, deletions,
/// copies, and keys that the schema knows beside those that are there.
Mutant mutant_of(const std::vector<Origin>& origins, std::uint64_t number);

/// A tree as TOML.
std::string toml_of(const boxbeam::Node& tree);

}  // namespace fuzz
