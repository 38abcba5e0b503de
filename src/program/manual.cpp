#include "program/command_line.hpp"

#include <fmt/format.h>

#include "version.hpp"

namespace boxbeam::program {
namespace {

/// Text that the formatter takes as it stands.
std::string plain(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\') {
      safe += "\\e";
    } else if (c == '-') {
      safe += "\\-";
    } else if (c == '\'') {
      safe += "\\(aq";
    } else {
      safe += c;
    }
  }
  return safe.starts_with('.') ? "\\&" + safe : safe;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string entry(const std::string& term, const std::string& says) {
  return ".TP\n" + term + "\n" + plain(says) + "\n";
}

std::string term_of(const Argument& option) {
  std::string name =
      option.brief.empty() ? bold(option.name) : bold(option.brief) + ", " + bold(option.name);
  if (option.value.empty()) return name;
  if (option.words.empty()) return name + " " + italic(option.value);
  std::string words;
  for (const std::string& word : option.words) {
    words += (words.empty() ? "" : "|") + bold(word);
  }
  return name + " " + words;
}

std::string command_text(const Command& command) {
  std::string text = ".SS " + plain(usage_of(command)) + "\n" + plain(command.says) + ".\n";
  for (const Argument& place : command.places) {
    text += entry(italic(placeholder(place)), place.says);
  }
  for (const Argument& option : command.options) {
    if (option.name != "--help") text += entry(term_of(option), option.says);
  }
  return text;
}

}  // namespace

std::string manual_of(const CommandLine& line) {
  std::string text = fmt::format(".TH BOXBEAM 1 \"\" \"boxbeam {}\" \"User Commands\"\n", version);
  text +=
      ".SH NAME\n"
      "boxbeam \\- strength and fatigue verification of welded beams moved by a mechanism\n"
      ".SH SYNOPSIS\n"
      "\\fBboxbeam\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n"
      ".SH DESCRIPTION\n";
  text += plain(line.says) + "\n";
  text +=
      "A case file, TOML with units in its values, describes the mechanism, the beam and what is\n"
      "demanded of it. From it follow the motion, the loads on the beam, its cut forces, stresses\n"
      "and their ranges, and the checks; a report with the verdict comes out as text, HTML, PDF "
      "and\n"
      "JSON.\n"
      ".SH COMMANDS\n";
  for (const Command& command : line.commands) text += command_text(command);
  text += ".SH OPTIONS\n";
  for (const Argument& option : line.options) text += entry(term_of(option), option.says);
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, says] :
       {std::pair{"0", "All checks pass; the command did what it says."},
        {"1", "A check fails, or a gate says not applicable."},
        {"2", "Wrong usage or input; nothing was written."},
        {"3", "The analysis cannot be done; nothing was written."},
        {"4", "An output or an external tool failed; what could be written is written."}}) {
    text += entry(bold(code), says);
  }
  text += ".SH ENVIRONMENT\n";
  for (const auto& [name, says] :
       {std::pair{"NO_COLOR", "Where it is set and not empty, nothing is shown in colour."},
        {"CLICOLOR, CLICOLOR_FORCE",
         "CLICOLOR=0 likewise; CLICOLOR_FORCE=1 shows colours also where standard output is no "
         "terminal."},
        {"TERM", "On a dumb terminal there are neither colours nor progress."},
        {"SOURCE_DATE_EPOCH",
         "The date of reports, in seconds from 1970, so that the same case gives the same bytes."},
        {"PATH", "Where gnuplot (figures) and pdflatex (PDF) are looked for."}}) {
    text += entry(bold(name), says);
  }
  text += ".SH FILES\n";
  for (const auto& [name, says] :
       {std::pair{"report.txt, report.html, report.pdf",
                  "The report of a case, in reports/NAME or the folder of --out."},
        {"results.json", "The results, SI units; boxbeam schema results describes it."},
        {"*.svg, plots/*.gp",
         "Figures, and the scripts of those that are plotted: gnuplot plots/NAME.gp draws one "
         "again."}}) {
    text += entry(italic(name), says);
  }
  text += ".SH EXAMPLES\n.nf\n";
  for (const Command& command : line.commands) {
    for (const std::string& example : command.examples) text += plain(example) + "\n";
  }
  return text + ".fi\n.SH SEE ALSO\n\\fBgnuplot\\fR(1), \\fBpdflatex\\fR(1)\n";
}

}  // namespace boxbeam::program
