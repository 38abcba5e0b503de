#include "boxbeam/project/named_section.hpp"

#include <fmt/format.h>

#include <sstream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/standard_profiles.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "readers.hpp"

namespace boxbeam {
namespace {

constexpr const char* usage =
    "write \"RHS 200x100x8\", \"SHS 100x5\", \"CHS 168.3x8\", \"box 400x600 flange 50 web 50\" or "
    "FILE.toml:SECTION";

bool is_series(const std::string& word) { return word == "RHS" || word == "SHS" || word == "CHS"; }

/// Where a section of a file begins in "FILE.toml:NAME", npos where the word is none.
std::size_t file_colon(const std::string& word) {
  const std::size_t ending = word.find(".toml:");
  return ending == std::string::npos ? ending : ending + 5;
}

/// Words of one profile each.
std::vector<std::vector<std::string>> split(const std::vector<std::string>& words) {
  std::vector<std::vector<std::string>> profiles;
  for (const std::string& word : words) {
    // The path of a file may have spaces.
    std::istringstream parts(file_colon(word) == std::string::npos ? word : "");
    std::vector<std::string> pieces;
    for (std::string piece; parts >> piece;) pieces.push_back(piece);
    if (pieces.empty()) pieces.push_back(word);
    for (const std::string& piece : pieces) {
      const bool begins =
          is_series(piece) || piece == "box" || file_colon(piece) != std::string::npos;
      if (begins || profiles.empty()) profiles.emplace_back();
      profiles.back().push_back(piece);
    }
  }
  return profiles;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Length millimetres(const std::string& text, const std::string& of) {
  const auto parsed = parse_quantity(text + " mm");
  const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
  if (quantity == nullptr) {
    throw InputError(fmt::format("\"{}\" in \"{}\" is no length in mm", text, of), usage);
  }
  return si<Length>(quantity->value);
}

NamedSection box_of(const std::vector<std::string>& words) {
  const std::string name = joined(words);
  const std::size_t cross = words.size() > 1 ? words[1].find('x') : std::string::npos;
  if (words.size() != 6 || cross == std::string::npos || words[2] != "flange" ||
      words[4] != "web") {
    throw InputError(fmt::format("\"{}\" is no box", name),
                     "write for example \"box 400x600 flange 50 web 50\": width x height in mm");
  }
  const Section section{symmetric_box(millimetres(words[1].substr(0, cross), name),
                                      millimetres(words[1].substr(cross + 1), name),
                                      millimetres(words[3], name), millimetres(words[5], name)),
                        {}};
  if (const auto defect = defect_of(section)) {
    throw InputError(fmt::format("\"{}\": {}", name, *defect), "change its dimensions");
  }
  return {name, section, "", false};
}

NamedSection section_in_file(const std::string& word) {
  const std::size_t colon = file_colon(word);
  const std::string path = word.substr(0, colon);
  const std::string name = word.substr(colon + 1);
  const CaseDocument document = read_document(path, {});
  ProblemList problems(document);
  TableReader root(problems, document.root, "");
  const readers::Sections sections = readers::read_sections(root.table("sections"));
  problems.raise();
  const auto found = sections.find(name);
  if (found == sections.end()) {
    std::vector<std::string> known;
    for (const auto& [other, section] : sections) known.push_back(other);
    throw InputError(fmt::format("{} has no section \"{}\"", path, name),
                     readers::unknown_hint(name, known));
  }
  return {name, found->second, "", false};
}

}  // namespace

std::vector<NamedSection> sections_from_words(const std::vector<std::string>& words) {
  std::vector<NamedSection> sections;
  for (const std::vector<std::string>& profile : split(words)) {
    const std::string name = joined(profile);
    if (profile[0] == "box") {
      sections.push_back(box_of(profile));
    } else if (file_colon(profile[0]) != std::string::npos && profile.size() == 1) {
      sections.push_back(section_in_file(profile[0]));
    } else if (const auto standard = find_standard_profile(name)) {
      sections.push_back({name, {standard->profile, {}}, standard->source, standard->unconfirmed});
    } else {
      throw InputError(fmt::format("there is no profile \"{}\"", name),
                       is_series(profile[0]) ? standard_profile_hint(name) : usage);
    }
  }
  return sections;
}

}  // namespace boxbeam
