#include "program/entries.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>
#include <utility>

namespace boxbeam::program {

std::optional<double> number_in(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

namespace {

/// What is wrong with the value of --tolerance, or nothing.
std::string tolerance_trouble(const std::string& text) {
  const std::optional<double> fraction = number_in(text);
  if (fraction && *fraction >= 1e-9 && *fraction < 1.0) return "";
  return "\"" + text + "\" is no tolerance; write a fraction, for example 0.01 for 1 %";
}

}  // namespace

std::function<std::string(const std::string&)> range_trouble(double low, double high,
                                                             const char* example) {
  return [=](const std::string& text) -> std::string {
    const std::optional<double> number = number_in(text);
    if (number && *number >= low && *number <= high) return "";
    return fmt::format("\"{}\" is no number from {:g} to {:g}; write for example {}", text, low,
                       high, example);
  };
}

void add_json(CLI::App& command, std::string& file, const char* what, const char* instead) {
  add_value(command, "--json", file, "FILE",
            std::string("also write the ") + what +
                " as JSON to this file; - for standard output instead of " + instead);
}

CLI::Option* add_choice(CLI::App& command, const char* name, std::string& word,
                        std::vector<std::string> words, const char* says) {
  return command.add_option(name, word, says)->check(CLI::IsMember(std::move(words)));
}

CLI::Option* add_set(CLI::App& command, CaseOptions& options) {
  return add_repeated(
      command, "--set", options.set,
      "override a key of the case, --set bodies.sledge.mass=\"20 t\"; may be repeated",
      "KEY=VALUE");
}

void add_case(CLI::App& command, CaseOptions& options) {
  add_value(command, "CASE", options.file, "FILE.toml", "case file")->required();
  add_set(command, options);
}

void add_verified_case(CLI::App& command, CaseOptions& options) {
  add_case(command, options);
  add_value(command, "--beam", options.beam, "NAME",
            "one of several beams (default: verify all, else the first)");
  add_choice(command, "--dynamics", options.dynamics, {"rigorous", "newton-chain"},
             "where the loads on the beam come from (default: as the case says)");
  add_choice(command, "--model", options.model, {"auto", "rigid", "flexible"},
             "auto: the cheapest sufficient one (default: as the case says, else auto)");
  add_value(command, "--tolerance", options.tolerance, "FRACTION",
            "of --model auto, on the governing stress: 0.01 for 1 % (default: as the case "
            "says, else 0.01)")
      ->check(tolerance_trouble);
}

}  // namespace boxbeam::program
