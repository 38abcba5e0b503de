#include "program/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

constexpr std::string_view red = "\033[1;31m", green = "\033[32m", yellow = "\033[33m",
                           plain = "\033[0m";

struct Word {
  std::string_view text;
  std::string_view colour;
};

/// With the sign behind them, so that no longer word is meant.
constexpr std::array words{
    Word{"FAIL ", red},
    Word{"FAIL;", red},
    Word{"FAILS ", red},
    Word{"PASS ", green},
    Word{"PASS;", green},
    Word{"passes ", green},
    Word{"NOT APPLICABLE ", yellow},
    Word{"NOT APPLICABLE:", yellow},
    Word{"NOT APPLICABLE;", yellow},
};

/// The end of "165 % !" in a line, 0 where its first words are not that.
std::size_t end_of_marked_utilisation(std::string_view line, std::size_t begin) {
  const std::size_t end = line.find_first_not_of("0123456789.e+", begin);
  if (end == begin || end == std::string_view::npos) return 0;
  return line.substr(end).starts_with(" % !") ? end + 4 : 0;
}

std::string coloured_line(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos) return std::string(line);
  const auto with = [&](std::string_view colour, std::size_t end) {
    return fmt::format("{}{}{}{}{}", line.substr(0, begin), colour, line.substr(begin, end - begin),
                       plain, line.substr(end));
  };
  for (const Word& word : words) {
    if (line.substr(begin).starts_with(word.text)) {
      return with(word.colour, begin + word.text.size() - 1);
    }
  }
  // The last word of a calculation sheet's result.
  for (const Word& word : {Word{": FAILS", red}, Word{": passes", green}}) {
    if (!line.ends_with(word.text)) continue;
    const std::size_t from = line.size() - word.text.size() + 2;
    return fmt::format("{}{}{}{}", line.substr(0, from), word.colour, line.substr(from), plain);
  }
  const std::size_t end = end_of_marked_utilisation(line, begin);
  return end > 0 ? with(red, end) : std::string(line);
}

}  // namespace

void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw OutputError("standard output cannot be written");
  }
}

void put_text(const std::string& text) { put(coloured(visible(text, "\n\t"))); }

void put_result(const std::string& json_file, const std::string& json, const std::string& text) {
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

std::string coloured(const std::string& text) {
  if (!shows_colours()) return text;
  std::string result;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    result += coloured_line(rest.substr(0, end));
    if (end < rest.size()) result += '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return result;
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
