#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/program.hpp"

/// Case files with one mistake in them, and the program's answer to it.
namespace bad_input {

/// A case file with something wrong in it, and what the user must be told.
struct BrokenCase {
  std::string name;
  std::string text;
  std::ptrdiff_t line = 1;
  std::vector<std::string> said;  ///< what is wrong, and what to write
};

inline const std::string& rig() {
  static const std::string text =
      test::read_file(test::project_file("sections/sledge-rig/rig.toml"));
  return text;
}

inline std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

inline std::ptrdiff_t line_of(const std::string& part, const std::string& text) {
  INFO("looked for: " << part);
  REQUIRE(count_of(part, text) == 1);
  const auto at = static_cast<std::ptrdiff_t>(text.find(part));
  return 1 + std::count(text.begin(), text.begin() + at, '\n');
}

/// The shipped case with a part of it replaced. The problem stands in the line of `at`, or where
/// the replacement begins.
inline BrokenCase replaced(const std::string& name, const std::string& part,
                           const std::string& with, std::vector<std::string> said,
                           const std::string& at = {}) {
  INFO(name << ", replaced: " << part);
  REQUIRE(count_of(part, rig()) == 1);
  std::string text = rig();
  text.replace(text.find(part), part.size(), with);
  return {name, text, at.empty() ? line_of(part, rig()) : line_of(at, text), std::move(said)};
}

/// The shipped case with lines behind it. The problem stands in the line of `at`.
inline BrokenCase appended(const std::string& name, const std::string& lines, const std::string& at,
                           std::vector<std::string> said) {
  const std::string text = rig() + lines;
  return {name, text, line_of(at, text), std::move(said)};
}

/// Verifies the file as a user does: it is refused with all that must be said, and nothing is
/// written. Returns what was said.
inline std::string refused(const std::string& file, const std::vector<std::string>& said) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "report").string();
  const test::ProgramResult result = test::run_program({"verify", file, "--out", out});
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_FALSE(std::filesystem::exists(out));
  for (const std::string& part : said) {
    INFO("wanted: " << part);
    CHECK(result.err.find(part) != std::string::npos);
  }
  return result.err;
}

inline void check_refused(const std::vector<BrokenCase>& cases) {
  const test::TemporaryFolder folder;
  for (const BrokenCase& broken : cases) {
    INFO(broken.name);
    const std::string file = folder.write("broken.toml", broken.text);
    std::vector<std::string> said = broken.said;
    said.push_back(file + ":" + std::to_string(broken.line) + ":");
    said.push_back("hint: ");
    const std::string err = refused(file, said);
    // One mistake is one error, not a row of them.
    INFO(err);
    CHECK(count_of(": error: ", err) == 1);
  }
}

}  // namespace bad_input
