#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/text_report.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verify.hpp"
#include "version.hpp"

namespace {

using namespace boxbeam;

enum ExitCode {
  all_pass = 0,
  check_fails = 1,
  wrong_input = 2,
  not_possible = 3,
  output_failed = 4
};

struct VerifyOptions {
  std::string case_file;
  std::string out;
  std::string json;
  std::vector<std::string> set;
  std::string dynamics;
  std::string model = "auto";
  bool no_plots = false;
};

struct MotionOptions {
  std::string case_file;
  std::vector<double> at;
  bool assemblies = false;
  std::string json;
  std::vector<std::string> set;
};

void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw OutputError("standard output cannot be written");
  }
}

std::optional<Dynamics> dynamics_of(const std::string& word) {
  if (word.empty()) return std::nullopt;
  return word == "rigorous" ? Dynamics::rigorous : Dynamics::newton_chain;
}

/// Writes every output that can be written; returns what could not be, as text.
std::string write_reports(const Project& project, const Verification& verification,
                          const std::string& folder, bool plots,
                          std::vector<std::string>& written) {
  remove_figures(folder);
  write_file(folder + "/report.txt", text_report(project, verification));
  write_file(folder + "/results.json", results_json(project, verification));
  written = {"report.txt", "results.json"};
  if (!plots) return "";
  try {
    for (std::string& name : draw_figures(project, verification, folder))
      written.push_back(std::move(name));
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

int run_verify(const VerifyOptions& options) {
  if (options.model == "flexible") {
    throw InputError("a planar case is verified with rigid bodies; it has no flexible model",
                     "use --model auto or --model rigid");
  }
  const Project project =
      read_project(options.case_file, options.set, dynamics_of(options.dynamics));
  const Verification verification = verify(project);

  const std::string folder = options.out.empty() ? "reports/" + project.name : options.out;
  std::vector<std::string> written;
  const std::string trouble =
      write_reports(project, verification, folder, !options.no_plots, written);
  if (!options.json.empty() && options.json != "-") {
    write_file(options.json, results_json(project, verification));
    written.push_back(options.json);
  }
  if (options.json == "-") {
    put(results_json(project, verification));
  } else {
    put(summary(project, verification) +
        fmt::format("\nWritten to {}: {}\n", folder, fmt::join(written, ", ")));
  }
  if (!trouble.empty()) {
    std::cerr << "boxbeam: " << trouble << "\n";
    return output_failed;
  }
  return verification.verdict == Verdict::pass ? all_pass : check_fails;
}

int run_assemblies(const Project& project, const MotionOptions& options) {
  const double time = options.at.empty() ? 0.0 : options.at.front();
  const std::vector<AssemblyResult> assemblies = assemblies_of(project, time);
  if (options.json == "-") {
    put(assemblies_json(assemblies, time));
    return all_pass;
  }
  if (!options.json.empty()) write_file(options.json, assemblies_json(assemblies, time));
  put(assemblies_text(project, assemblies, time));
  return all_pass;
}

int run_motion(const MotionOptions& options) {
  // The mechanism alone: where the beam's loads come from does not matter, so that a case made for
  // the chain can be moved as well.
  const Project project = read_project(options.case_file, options.set);
  if (options.assemblies) return run_assemblies(project, options);
  const MotionResult motion = motion_of(project, options.at);
  if (options.json == "-") {
    put(motion_json(motion));
    return all_pass;
  }
  if (!options.json.empty()) write_file(options.json, motion_json(motion));
  put(motion_text(project, motion));
  return all_pass;
}

/// What is wrong with the value of --at, or nothing. Farther away the phase of the motion is lost
/// in the rounding of the period.
std::string instant_trouble(const std::string& text) {
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool number = error == std::errc{} && end == text.data() + text.size();
  if (number && std::abs(seconds) <= 1e9) return "";
  return fmt::format("\"{}\" is no instant; write seconds without unit, for example 1.071", text);
}

/// The hint for a mistyped option of a command, "" where none is near.
std::string option_hint(int argc, char** argv, const CLI::App& command) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
  }
  for (int i = 1; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (!word.starts_with("--") || std::find(known.begin(), known.end(), word) != known.end()) {
      continue;
    }
    const std::string near = nearest_word(word, known);
    if (!near.empty()) return fmt::format("did you mean {}?", near);
  }
  return "";
}

/// The hint for a mistyped or missing command, case or option, which the parser does not give.
std::string usage_hint(int argc, char** argv, const CLI::App& app) {
  std::string commands = "write boxbeam verify CASE.toml or boxbeam motion CASE.toml";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with('-')) continue;
    if (word == "verify" || word == "motion") {
      const CLI::App& command = *app.get_subcommand(word);
      if (command["CASE"]->empty()) return fmt::format("write boxbeam {} CASE.toml", word);
      return option_hint(argc, argv, command);
    }
    const std::string near = nearest_word(word, {"verify", "motion"});
    return near.empty() ? commands : fmt::format("did you mean \"boxbeam {}\"?", near);
  }
  return commands;
}

int run(int argc, char** argv) {
  CLI::App app(
      "boxbeam verifies the strength and fatigue life of welded beams that a mechanism moves.\n"
      "Exit codes: 0 all checks pass, 1 a check fails, 2 wrong usage or input,\n"
      "3 the analysis cannot be done, 4 an output or external tool failed.");
  app.name("boxbeam");
  app.set_version_flag("--version", fmt::format("boxbeam {}", version));
  app.require_subcommand(1);

  VerifyOptions verify_options;
  CLI::App* verify_command = app.add_subcommand("verify", "verify a case and write its report");
  verify_command->add_option("CASE", verify_options.case_file, "case file (.toml)")->required();
  verify_command->add_option("--out", verify_options.out,
                             "folder of the report (default: reports/<name of the case>)");
  verify_command->add_option(
      "--json", verify_options.json,
      "also write the results to this file; - for standard output instead of the summary");
  verify_command
      ->add_option("--set", verify_options.set,
                   "override a key: --set bodies.sledge.mass=\"20 t\"; may be repeated")
      ->allow_extra_args(false);
  verify_command
      ->add_option("--dynamics", verify_options.dynamics, "where the loads on the beam come from")
      ->check(CLI::IsMember({"rigorous", "newton-chain"}));
  verify_command
      ->add_option("--model", verify_options.model, "auto, rigid or flexible (default: auto)")
      ->check(CLI::IsMember({"auto", "rigid", "flexible"}));
  verify_command->add_flag("--no-plots", verify_options.no_plots, "write no plots");

  MotionOptions motion_options;
  CLI::App* motion_command = app.add_subcommand(
      "motion", "positions, velocities, accelerations and reactions of the mechanism alone");
  motion_command->add_option("CASE", motion_options.case_file, "case file (.toml)")->required();
  motion_command
      ->add_option("--at", motion_options.at,
                   "instant in seconds; may be repeated (default: twelve instants of the period)")
      ->check(instant_trouble)
      ->allow_extra_args(false);
  motion_command->add_flag("--assemblies", motion_options.assemblies,
                           "list all ways to assemble the mechanism at the first --at (default 0)");
  motion_command->add_option(
      "--json", motion_options.json,
      "write the motion to this file; - for standard output instead of the tables");
  motion_command->add_option("--set", motion_options.set, "override a key; may be repeated")
      ->allow_extra_args(false);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);
      if (!std::cout.flush()) throw OutputError("standard output cannot be written");
      return all_pass;
    }
    std::cerr << "boxbeam: " << error.what() << "\n";
    const std::string hint = usage_hint(argc, argv, app);
    if (!hint.empty()) std::cerr << "    hint: " << hint << "\n";
    std::cerr << "Run boxbeam --help for the commands and options.\n";
    return wrong_input;
  }
  return verify_command->parsed() ? run_verify(verify_options) : run_motion(motion_options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << error.what();
    if (error.problems().size() > 1)
      std::cerr << error.problems().size() << " errors; nothing was written\n";
    return wrong_input;
  } catch (const AnalysisError& error) {
    std::cerr << "boxbeam: the analysis cannot be done\n  " << error.what() << "\n";
    return not_possible;
  } catch (const OutputError& error) {
    std::cerr << "boxbeam: " << error.what() << "\n";
    return output_failed;
  }
}
