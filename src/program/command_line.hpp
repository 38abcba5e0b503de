#pragma once

#include <string>
#include <vector>

/// The command line as a value: what help, manual, completion and hints are written from, so that
/// they are always in step with what the program takes.
namespace boxbeam::program {

struct Argument {
  std::string name;   ///< "--out"; "CASE" where it goes by its place
  std::string brief;  ///< "-o"; "" where it has no short name
  std::string says;
  std::string value;               ///< "FILE", "DIR", "FILE.toml", "NUMBER"; "" of a flag
  std::vector<std::string> words;  ///< the only values that there are, where so
  bool required = false;
  bool several = false;
};

struct Command {
  std::string name;
  std::string says;
  std::vector<std::string> examples;  ///< "boxbeam verify rig.toml"
  std::vector<Argument> places;       ///< in their order
  std::vector<Argument> options;
};

struct CommandLine {
  std::string says;
  std::vector<Argument> options;
  std::vector<Command> commands;
};

/// nullptr where there is none.
const Command* command_named(const CommandLine& line, const std::string& name);

/// "CASE.toml", "[FILE]", "PROFILE...".
std::string placeholder(const Argument& place);

/// "boxbeam verify CASE.toml", with the options that must be given.
std::string usage_of(const Command& command);

/// What an option stands like: "--out DIR", "--level summary|governing|full".
std::string shape_of(const Argument& option);

/// The help of the program, or of one command.
std::string help_of(const CommandLine& line);
std::string help_of(const Command& command);

/// The manual page, for man(1): boxbeam manual | man -l -
std::string manual_of(const CommandLine& line);

/// The completion of the command line for a shell, "bash" or "zsh": commands, options, the values
/// that an option can have, and files of the kind that is wanted.
std::string completion_of(const CommandLine& line, const std::string& shell);

/// What to write instead of these words, of which the parser only says that they are wrong or
/// incomplete; "" where that is not known.
std::string hint_for(const CommandLine& line, const std::vector<std::string>& words,
                     bool incomplete);

}  // namespace boxbeam::program
