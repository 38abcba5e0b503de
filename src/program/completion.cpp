#include "program/command_line.hpp"

#include <fmt/format.h>

namespace boxbeam::program {
namespace {

/// "toml" of "FILE.toml".
std::string extension_of(const Argument& argument) {
  const std::size_t dot = argument.value.find('.');
  return dot == std::string::npos ? "" : argument.value.substr(dot + 1);
}

bool is_file(const Argument& argument) { return argument.value.starts_with("FILE"); }

/// What bash does to complete a value.
std::string bash_action(const Argument& argument) {
  if (!argument.words.empty()) {
    return fmt::format("_boxbeam_words \"{}\"", fmt::join(argument.words, " "));
  }
  if (argument.value == "DIR") return "_boxbeam_folders";
  if (is_file(argument)) return fmt::format("_boxbeam_files \"{}\"", extension_of(argument));
  return ":";
}

std::string bash_of(const CommandLine& line) {
  std::vector<std::string> first;
  for (const Command& command : line.commands) first.push_back(command.name);
  for (const Argument& option : line.options) first.push_back(option.name);
  std::string with_value;
  std::string values;
  std::string options;
  std::string places;
  for (const Command& command : line.commands) {
    std::vector<std::string> names;
    for (const Argument& option : command.options) {
      names.push_back(option.name);
      if (option.value.empty()) continue;
      for (const std::string& name : {option.name, option.brief}) {
        if (name.empty()) continue;
        with_value += fmt::format("{}{}:{}", with_value.empty() ? "" : "|", command.name, name);
        values +=
            fmt::format("    {}:{}) {}; return ;;\n", command.name, name, bash_action(option));
      }
    }
    options +=
        fmt::format("      {}) _boxbeam_words \"{}\" ;;\n", command.name, fmt::join(names, " "));
    for (std::size_t i = 0; i < command.places.size(); ++i) {
      places += fmt::format("    {}:{}) {} ;;\n", command.name,
                            command.places[i].several ? "*" : fmt::format("{}", i),
                            bash_action(command.places[i]));
    }
  }
  return fmt::format(
      R"bash(# bash completion of boxbeam; written by: boxbeam completion bash
# For this shell: eval "$(boxbeam completion bash)"
_boxbeam_words() {{ COMPREPLY=($(compgen -W "$1" -- "$cur")); }}
_boxbeam_folders() {{
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}}
_boxbeam_files() {{
  compopt -o filenames 2>/dev/null
  if [ -n "$1" ]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X "!*.$1" -- "$cur")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
  fi
}}
_boxbeam() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} command= place=0 i word
  COMPREPLY=()
  # Of --option=value bash makes three words.
  if [ "$cur" = "=" ]; then
    cur=
  elif [ "$prev" = "=" ]; then
    prev=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${{COMP_WORDS[i]}}
    case $word in
      =) ;;
      -*)
        case $command:$word in
          {0})
            if [ "${{COMP_WORDS[i+1]}}" = "=" ]; then i=$((i + 2)); else i=$((i + 1)); fi ;;
        esac ;;
      *) if [ -z "$command" ]; then command=$word; else place=$((place + 1)); fi ;;
    esac
  done
  if [ -z "$command" ]; then
    _boxbeam_words "{1}"
    return
  fi
  case $command:$prev in
{2}  esac
  if [[ $cur == -* ]]; then
    case $command in
{3}    esac
    return
  fi
  case $command:$place in
{4}  esac
}}
complete -F _boxbeam boxbeam
)bash",
      with_value, fmt::join(first, " "), values, options, places);
}

/// Within single quotes, and within a specification of _arguments.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'') {
      safe += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
      safe += c;
    }
  }
  return safe;
}

std::string zsh_action(const Argument& argument) {
  if (!argument.words.empty()) return fmt::format("({})", fmt::join(argument.words, " "));
  if (argument.value == "DIR") return "_files -/";
  const std::string extension = extension_of(argument);
  if (!extension.empty()) return fmt::format("_files -g \"*.{}\"", extension);
  return is_file(argument) ? "_files" : " ";
}

std::string zsh_option(const Argument& option) {
  std::string text =
      fmt::format("'{}{}[{}]", option.several ? "*" : "", option.name, zsh_text(option.says));
  if (!option.value.empty()) {
    text += fmt::format(":{}:{}", zsh_text(option.value), zsh_action(option));
  }
  return text + "'";
}

std::string zsh_of(const CommandLine& line) {
  std::string commands;
  std::string cases;
  for (const Command& command : line.commands) {
    commands += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.says));
    std::string specification;
    for (const Argument& option : command.options) {
      specification += " \\\n          " + zsh_option(option);
    }
    for (std::size_t i = 0; i < command.places.size(); ++i) {
      const Argument& place = command.places[i];
      specification +=
          fmt::format(" \\\n          '{}:{}:{}'", place.several ? "*" : fmt::format("{}", i + 1),
                      place.name, zsh_action(place));
    }
    cases += fmt::format("        {})\n          _arguments{} ;;\n", command.name, specification);
  }
  std::string options;
  for (const Argument& option : line.options) options += " \\\n    " + zsh_option(option);
  return fmt::format(R"zsh(#compdef boxbeam
# zsh completion of boxbeam; written by: boxbeam completion zsh
_boxbeam() {{
  local state line
  local -a commands
  commands=(
{}  )
  _arguments -C{} \
    '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument)
      case $words[1] in
{}      esac ;;
  esac
}}
if [ "$funcstack[1]" = "_boxbeam" ]; then
  _boxbeam "$@"
else
  compdef _boxbeam boxbeam
fi
)zsh",
                     commands, options, cases);
}

}  // namespace

std::string completion_of(const CommandLine& line, const std::string& shell) {
  return shell == "zsh" ? zsh_of(line) : bash_of(line);
}

}  // namespace boxbeam::program
