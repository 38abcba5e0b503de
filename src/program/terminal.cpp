#include "program/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"

namespace boxbeam::program {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view{} : std::string_view(value);
}

std::string_view colour_of(report::Mark mark) {
  switch (mark) {
    case report::Mark::passes: return "\033[32m";
    case report::Mark::fails: return "\033[1;31m";
    case report::Mark::not_applicable: return "\033[33m";
    case report::Mark::none: break;
  }
  return "";
}

/// What a user's text could do to a terminal, as its code.
std::string harmless(std::string_view text) { return visible(text, "\n\t"); }

}  // namespace

void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw OutputError("standard output cannot be written");
  }
}

void put_text(const report::MarkedText& text) {
  if (!shows_colours()) return put(harmless(text.text));
  const std::string_view whole = text.text;
  std::string out;
  std::size_t done = 0;
  for (const report::MarkedText::Word& word : text.words) {
    out += harmless(whole.substr(done, word.begin - done));
    out += colour_of(word.mark);
    out += harmless(whole.substr(word.begin, word.end - word.begin));
    out += "\033[0m";
    done = word.end;
  }
  put(out + harmless(whole.substr(done)));
}

void put_result(const std::string& json_file, const std::string& json,
                const report::MarkedText& text) {
  if (json_file == "-") {
    put(json);
    return;
  }
  if (!json_file.empty()) write_file(json_file, json);
  put_text(text);
}

void put_error(const std::string& text) { std::cerr << "boxbeam: " << visible(text, "\n") << "\n"; }

std::size_t columns() {
  constexpr std::size_t usual = 110;
  constexpr std::size_t fewest = 60, most = 200;
  winsize size{};
  std::size_t found = 0;
  if (isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) {
    found = size.ws_col;
  }
  if (found == 0) {
    const std::string_view given = environment("COLUMNS");
    std::from_chars(given.data(), given.data() + given.size(), found);
  }
  return found == 0 ? usual : std::clamp(found, fewest, most);
}

bool shows_colours() {
  if (!environment("NO_COLOR").empty()) return false;
  if (const auto force = environment("CLICOLOR_FORCE"); !force.empty() && force != "0") return true;
  return environment("CLICOLOR") != "0" && environment("TERM") != "dumb" &&
         isatty(STDOUT_FILENO) == 1;
}

std::string shell_word(const std::string& word) {
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("._-/").find(static_cast<char>(c)) < 4;
  });
  if (plain && !word.empty()) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace boxbeam::program
