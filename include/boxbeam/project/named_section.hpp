#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A section and what it is called.
struct NamedSection {
  std::string name;
  Section section;
  std::string source;        ///< of its dimensions, where it is a standard profile
  bool unconfirmed = false;  ///< whether that source is recalled
};

/// Sections from the words of a command line, one behind the other:
///
///     RHS 200x100x8   SHS 100x5   CHS 168.3x8       standard profiles, height x width x wall in mm
///     box 400x600 flange 50 web 50                  welded box, width x height in mm
///     FILE.toml:NAME                                a section of a case file
///
/// Each may be one word with spaces or several. Throws InputError.
std::vector<NamedSection> sections_from_words(const std::vector<std::string>& words);

}  // namespace boxbeam
