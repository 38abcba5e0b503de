#include "program/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "boxbeam/project/quantity_text.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

/// Longer lines are hard to read.
std::size_t width() { return std::min<std::size_t>(columns(), 100); }

/// Words in lines of at most width(), those behind the first after a margin.
std::string wrapped(const std::string& text, std::size_t margin) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = margin;
  for (std::string word; words >> word;) {
    const bool first = result.empty();
    if (!first && column + 1 + word.size() > width()) {
      result += "\n" + std::string(margin, ' ');
      column = margin;
    } else if (!first) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result + "\n";
}

/// Names at the left, what is said of them at the right.
std::string entries(const std::vector<std::pair<std::string, std::string>>& lines) {
  constexpr std::size_t widest = 26;
  std::size_t column = 0;
  for (const auto& [name, says] : lines) {
    if (name.size() <= widest) column = std::max(column, name.size());
  }
  const std::size_t margin = column + 4;
  std::string result;
  for (const auto& [name, says] : lines) {
    result += "  " + name;
    const bool fits = name.size() <= column;
    result += fits ? std::string(margin - 2 - name.size(), ' ') : "\n" + std::string(margin, ' ');
    result += wrapped(says, margin);
  }
  return result;
}

std::string entries_of(const std::vector<Argument>& options) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Argument& option : options) lines.emplace_back(shape_of(option), option.says);
  return entries(lines);
}

/// Whether a word is the value of an option before it: "charts" of "--out charts".
bool is_value(const Command& command, const std::string& before) {
  return std::any_of(command.options.begin(), command.options.end(), [&](const Argument& option) {
    return (option.name == before || option.brief == before) && !option.value.empty();
  });
}

/// Of a word in a place that takes certain words only.
std::string word_hint(const Command& command, const std::vector<std::string>& words) {
  for (const Argument& place : command.places) {
    const std::vector<std::string>& known = place.words;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string& word = words[i];
      if (known.empty() || word.starts_with("-") || word == command.name ||
          is_value(command, words[i - 1]) ||
          std::find(known.begin(), known.end(), word) != known.end())
        continue;
      const std::string near = nearest_word(word, known);
      if (!near.empty()) return fmt::format("did you mean {}?", near);
    }
  }
  return "";
}

/// The nearest of some options to one of the words that is none of them.
std::string option_hint(const std::vector<Argument>& options,
                        const std::vector<std::string>& words) {
  std::vector<std::string> known;
  std::vector<std::string> brief;
  for (const Argument& option : options) {
    known.push_back(option.name);
    if (!option.brief.empty()) brief.push_back(option.brief);
  }
  for (const std::string& given : words) {
    const std::string word = given.substr(0, given.find('='));
    if (word.size() < 2 || word[0] != '-') continue;
    const bool is_brief = word[1] != '-';
    const std::vector<std::string>& among = is_brief ? brief : known;
    if (std::find(among.begin(), among.end(), word) != among.end()) continue;
    const std::string near = nearest_word(word, among);
    // Of one letter nothing is near but the same, small or capital.
    const bool meant =
        !is_brief || (near.size() == word.size() && std::tolower(near[1]) == std::tolower(word[1]));
    if (!near.empty() && meant) return fmt::format("did you mean {}?", near);
  }
  return "";
}

}  // namespace

const Command* command_named(const CommandLine& line, const std::string& name) {
  const auto found = std::find_if(line.commands.begin(), line.commands.end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == line.commands.end() ? nullptr : &*found;
}

std::string placeholder(const Argument& place) {
  const std::size_t dot = place.value.find('.');
  std::string text = place.name;
  // Many words stand in what is said of it.
  constexpr std::size_t most = 4;
  if (!place.words.empty() && place.words.size() <= most)
    text = fmt::format("{}", fmt::join(place.words, "|"));
  if (dot != std::string::npos) text += place.value.substr(dot);
  if (place.several) text += "...";
  return place.required ? text : fmt::format("[{}]", text);
}

std::string usage_of(const Command& command) {
  std::string text = "boxbeam " + command.name;
  for (const Argument& place : command.places) text += " " + placeholder(place);
  for (const Argument& option : command.options) {
    if (option.required) text += " " + shape_of(option);
  }
  return text;
}

std::string shape_of(const Argument& option) {
  std::string name =
      option.brief.empty() ? option.name : fmt::format("{}, {}", option.brief, option.name);
  if (option.value.empty()) return name;
  if (option.words.empty()) return name + " " + option.value;
  return fmt::format("{} {}", name, fmt::join(option.words, "|"));
}

std::string help_of(const Command& command) {
  std::string text = "Usage: " + usage_of(command) + " [OPTIONS]\n\n" + wrapped(command.says, 0);
  std::vector<std::pair<std::string, std::string>> places;
  for (const Argument& place : command.places) places.emplace_back(placeholder(place), place.says);
  if (!places.empty()) text += "\n" + entries(places);
  text += "\nOptions:\n" + entries_of(command.options);
  if (command.examples.empty()) return text;
  text += command.examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
  for (const std::string& example : command.examples) text += "  " + example + "\n";
  return text;
}

std::string help_of(const CommandLine& line) {
  std::string text = "Usage: boxbeam COMMAND ...\n\n" + wrapped(line.says, 0) + "\nCommands:\n";
  std::vector<std::pair<std::string, std::string>> commands;
  for (const Command& command : line.commands) commands.emplace_back(command.name, command.says);
  text += entries(commands) + "\nOptions:\n" + entries_of(line.options);
  text +=
      "\nExit codes:\n"
      "  0  all checks pass; the command did what it says\n"
      "  1  a check fails, or a gate says not applicable\n"
      "  2  wrong usage or input; nothing was written\n"
      "  3  the analysis cannot be done; nothing was written\n"
      "  4  an output or an external tool failed; what could be written is written\n"
      "\nFirst steps:\n"
      "  boxbeam init planar my.toml     a commented case that runs as it is\n"
      "  boxbeam verify my.toml          its verdict and report\n"
      "  boxbeam verify --help           what else verify can do\n";
  return text;
}

std::string hint_for(const CommandLine& line, const std::vector<std::string>& words,
                     bool incomplete) {
  std::vector<std::string> names;
  for (const Command& command : line.commands) names.push_back(command.name);
  const auto first = std::find_if(words.begin(), words.end(),
                                  [](const std::string& word) { return !word.starts_with('-'); });
  std::string all = fmt::format("write boxbeam verify CASE.toml, or one of the commands {}",
                                fmt::join(names, ", "));
  if (first == words.end()) {
    const std::string hint = option_hint(line.options, words);
    return hint.empty() ? all : hint;
  }
  if (const Command* command = command_named(line, *first)) {
    if (!incomplete) {
      const std::string hint = option_hint(command->options, words);
      return hint.empty() ? word_hint(*command, words) : hint;
    }
    const std::string example =
        command->examples.empty() ? "" : ", for example " + command->examples.front();
    return "write " + usage_of(*command) + example;
  }
  const std::string near = nearest_word(*first, names);
  return near.empty() ? all : fmt::format("did you mean \"boxbeam {}\"?", near);
}

}  // namespace boxbeam::program
