#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "program/case_options.hpp"

/// Commands as CLI11 parses them.
namespace boxbeam::program {

/// A command: what parses it, how it is called, and what it does.
struct Entry {
  CLI::App* app;
  std::vector<std::string> examples;
  std::function<int()> run;
};

/// A number as text, whole and without unit.
std::optional<double> number_in(const std::string& text);

/// What is wrong with a number on the command line that lies between two others, or nothing. The
/// text "nan" is a number to a parser, and beyond no limit.
std::function<std::string(const std::string&)> range_trouble(double low, double high,
                                                             const char* example);

/// An option or a word of which the help says what type its value has.
template <class Value>
CLI::Option* add_value(CLI::App& command, const char* name, Value& value, const char* type,
                       const std::string& says) {
  return command.add_option(name, value, says)->type_name(type);
}

/// Options of which one value belongs to one mention.
template <class Value>
CLI::Option* add_repeated(CLI::App& command, const char* name, std::vector<Value>& values,
                          const char* says, const char* type) {
  return add_value(command, name, values, type, says)->allow_extra_args(false);
}

void add_json(CLI::App& command, std::string& file, const char* what, const char* instead);
CLI::Option* add_choice(CLI::App& command, const char* name, std::string& word,
                        std::vector<std::string> words, const char* says);
CLI::Option* add_set(CLI::App& command, CaseOptions& options);

/// The case and what may be changed of it.
void add_case(CLI::App& command, CaseOptions& options);
/// Likewise, of what is verified.
void add_verified_case(CLI::App& command, CaseOptions& options);

// Those of studies.
Entry solve_entry(CLI::App& app);
Entry optimise_entry(CLI::App& app);
Entry sweep_entry(CLI::App& app);
Entry merge_entry(CLI::App& app);
Entry reliability_entry(CLI::App& app);

}  // namespace boxbeam::program
