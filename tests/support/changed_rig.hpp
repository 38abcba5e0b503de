#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"

/// The shipped sledge rig's file with other lines in it, read as the program reads it.
namespace test {

/// Each part, which stands once in the file, replaced by another; `behind` added at the end.
inline std::string rig_text(const std::vector<std::pair<std::string, std::string>>& changes,
                            const std::string& behind = "") {
  std::string text = read_file(project_file("sections/sledge-rig/rig.toml"));
  for (const auto& [part, with] : changes) {
    INFO("replaced: " << part);
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(part, at + 1) == std::string::npos);
    text.replace(at, part.size(), with);
  }
  return text + behind;
}

inline boxbeam::Project changed_rig(const std::vector<std::pair<std::string, std::string>>& changes,
                                    const std::string& behind = "") {
  return boxbeam::parse_project("rig.toml", rig_text(changes, behind));
}

/// The only problem of a case; it stands in the line that contains `at` and has a hint.
inline void check_refused(const std::string& text, const std::string& at,
                          const std::string& message, const std::string& hint) {
  INFO("wanted: " << message << "; " << hint);
  try {
    boxbeam::parse_project("case.toml", text);
  } catch (const boxbeam::InputError& error) {
    INFO(error.what());
    REQUIRE(error.problems().size() == 1);
    const boxbeam::Problem& problem = error.problems().front();
    CHECK(problem.message.find(message) != std::string::npos);
    CHECK(problem.hint.find(hint) != std::string::npos);
    const std::size_t place = text.find(at);
    REQUIRE(place != std::string::npos);
    REQUIRE(text.find(at, place + 1) == std::string::npos);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
    CHECK(problem.line == 1 + std::count(text.begin(), end, '\n'));
    return;
  }
  FAIL("nothing was found wrong");
}

}  // namespace test
