#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/named_section.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/history_report.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "boxbeam/report/plots.hpp"
#include "boxbeam/report/section_text.hpp"
#include "boxbeam/report/text_report.hpp"
#include "boxbeam/verification/chain_motion_result.hpp"
#include "boxbeam/verification/flexible_motion_result.hpp"
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
  std::string model;  ///< "": as the case says
  std::optional<double> tolerance;
  bool no_plots = false;
};

struct MotionOptions {
  std::string case_file;
  std::vector<double> at;
  bool assemblies = false;
  std::string axes;
  std::string json;
  std::vector<std::string> set;
};

struct FatigueOptions {
  std::string history;
  std::string detail;
  std::string shear_detail;
  std::string count = "astm";
  std::string residue = "half-cycles";
  std::string raw;
  std::string loading = "spectrum";
  double repetitions = 1.0;
  double gamma_Ff = 1.0;
  double gamma_Mf = 1.0;
  bool stress_relieved = false;
  std::string json;
};

struct SectionOptions {
  std::vector<std::string> profiles;
  std::string steel = "S355";
  std::string json;
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

/// Takes over which model is asked for.
void take_model(const VerifyOptions& options, Project& project) {
  if (options.tolerance) project.model.tolerance = *options.tolerance;
  if (options.model.empty()) return;
  project.model.demand = options.model == "auto"    ? ModelDemand::automatic
                         : options.model == "rigid" ? ModelDemand::rigid
                                                    : ModelDemand::flexible;
  if (project.model.demand != ModelDemand::flexible) return;
  if (in_space(project)) {
    throw InputError("the bodies of a mechanism in space are rigid; there is no flexible model",
                     "use --model auto or --model rigid");
  }
  if (project.dynamics == Dynamics::newton_chain) {
    throw InputError("the published Newton chain is one of rigid bodies",
                     "use --model auto or --model rigid, or --dynamics rigorous");
  }
}

int run_verify(const VerifyOptions& options) {
  Project project = read_project(options.case_file, options.set, dynamics_of(options.dynamics));
  take_model(options, project);
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

/// The result of a command as JSON or as text, to where the user wants it.
void put_result(const std::string& json_file, const std::string& json, const std::string& text) {
  if (json_file == "-") {
    put(json);
    return;
  }
  if (!json_file.empty()) write_file(json_file, json);
  put(text);
}

int run_assemblies(const Project& project, const MotionOptions& options) {
  if (in_space(project)) {
    throw InputError("a mechanism in space is a chain, which has one assembly only",
                     "leave out --assemblies");
  }
  const double time = options.at.empty() ? 0.0 : options.at.front();
  const std::vector<AssemblyResult> assemblies = assemblies_of(project, time);
  put_result(options.json, assemblies_json(assemblies, time),
             assemblies_text(project, assemblies, time));
  return all_pass;
}

int run_flexible_motion(const Project& project, const MotionOptions& options) {
  if (!options.at.empty()) {
    throw InputError("elastic links vibrate about one posture: there are no instants to choose",
                     "leave out --at");
  }
  if (options.assemblies) {
    throw InputError("elastic links are placed by the case, which is their only assembly",
                     "leave out --assemblies");
  }
  if (!options.axes.empty()) {
    throw InputError("the motion of elastic links is given in world axes only", "leave out --axes");
  }
  const FlexibleMotionResult motion = flexible_motion_of(project);
  put_result(options.json, motion_json(motion), motion_text(project, motion));
  return all_pass;
}

int run_motion(const MotionOptions& options) {
  // The mechanism alone: where the beam's loads come from does not matter, so that a case made for
  // the chain can be moved as well.
  const Project project = read_project(options.case_file, options.set);
  if (is_flexible(project)) return run_flexible_motion(project, options);
  if (options.assemblies) return run_assemblies(project, options);
  if (in_space(project)) {
    const std::string axes = options.axes.empty() ? "world" : options.axes;
    const ChainMotionResult motion = chain_motion_of(project, options.at, axes);
    put_result(options.json, motion_json(motion), motion_text(project, motion));
    return all_pass;
  }
  if (!options.axes.empty()) {
    throw InputError("the motion of a planar case is given in world axes only", "leave out --axes");
  }
  const MotionResult motion = motion_of(project, options.at);
  put_result(options.json, motion_json(motion), motion_text(project, motion));
  return all_pass;
}

int run_section(const SectionOptions& options) {
  const auto steel = find_steel(options.steel);
  if (!steel) {
    throw InputError(fmt::format("there is no steel \"{}\"", options.steel),
                     fmt::format("known are {}", fmt::join(steel_names(), ", ")));
  }
  std::vector<SectionSummary> summaries;
  std::string text;
  for (const NamedSection& section : sections_from_words(options.profiles)) {
    summaries.push_back(summary_of(section, *steel));
    if (!text.empty()) text += "\n";
    text += section_text(summaries.back());
  }
  if (!options.json.empty() && options.json != "-") {
    write_file(options.json, section_json(summaries));
  }
  put(options.json == "-" ? section_json(summaries) : text);
  return all_pass;
}

/// A curve as the command line names it: a category of EN 1993-1-9 ("100", "36*"), a row of its
/// tables ("8.2/6"), or a curve of a code ("DNV-RP-C203 air:D").
SnCurve curve_named(const std::string& text, StressKind kind) {
  const std::size_t colon = text.rfind(':');
  const std::string family = colon == std::string::npos ? "EN 1993-1-9" : text.substr(0, colon);
  const std::string name = colon == std::string::npos ? text : text.substr(colon + 1);
  if (colon == std::string::npos && text.find('/') != std::string::npos) {
    std::vector<std::string> ids;
    const DetailRow* weakest = nullptr;
    for (const DetailRow& row : detail_rows()) {
      ids.push_back(row.id);
      if (row.id != text || row.kind != kind) continue;
      if (weakest == nullptr || row.category < weakest->category) weakest = &row;
    }
    if (weakest != nullptr) return curve_of(*weakest);
    const std::string near = nearest_word(text, ids);
    throw InputError(
        fmt::format("there is no row \"{}\" for this stress in the tables", text),
        near.empty() ? "write table and row, 8.2/6" : fmt::format("did you mean {}?", near));
  }
  const std::vector<std::string> all = families();
  if (std::find(all.begin(), all.end(), family) == all.end()) {
    throw InputError(fmt::format("there are no curves \"{}\"", family),
                     fmt::format("one of {}", fmt::join(all, ", ")));
  }
  if (auto curve = find_curve(family, name, kind)) return *curve;
  const std::vector<std::string> names = names_of(family, kind);
  throw InputError(
      fmt::format("{} has no {} curve \"{}\"", family,
                  kind == StressKind::direct ? "direct" : "shear", name),
      names.empty() ? "take another code" : fmt::format("one of {}", fmt::join(names, ", ")));
}

/// A bar on standard error that grows while a history is read; nothing where that is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown) : shown_(shown && isatty(STDERR_FILENO) == 1) {}
  ~ProgressBar() {
    if (drawn_) std::cerr << "\r\033[K" << std::flush;
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void at(std::uint64_t samples) {
    constexpr std::uint64_t step = 5'000'000;
    if (!shown_ || samples < next_) return;
    next_ = samples + step;
    drawn_ = true;
    std::cerr << fmt::format("\r{:.0f} million samples", static_cast<double>(samples) * 1e-6)
              << std::flush;
  }

 private:
  bool shown_ = false;
  bool drawn_ = false;
  std::uint64_t next_ = 0;
};

int run_fatigue(const FatigueOptions& options) {
  HistoryDemand demand;
  demand.source.path = options.history;
  if (!options.raw.empty()) demand.source.binary_unit = options.raw;
  demand.rule.counting = options.count == "astm"      ? Counting::astm
                         : options.count == "4-point" ? Counting::four_point
                                                      : Counting::periodic;
  demand.rule.residue = options.residue == "half-cycles" ? Residue::half_cycles
                        : options.residue == "repeated"  ? Residue::repeated
                                                         : Residue::discard;
  demand.direct = curve_named(options.detail, StressKind::direct);
  if (!options.shear_detail.empty()) {
    demand.shear = curve_named(options.shear_detail, StressKind::shear);
  }
  demand.demand = {options.loading == "spectrum" ? Loading::spectrum : Loading::constant_amplitude,
                   options.gamma_Ff, options.gamma_Mf};
  demand.compression_reduced = options.stress_relieved;
  demand.repetitions = options.repetitions;
  HistoryFatigue fatigue;
  {
    ProgressBar bar(options.json != "-");
    fatigue = fatigue_of_history(demand, [&](std::uint64_t samples) { bar.at(samples); });
  }
  if (options.json == "-") {
    put(history_json(demand, fatigue));
  } else {
    if (!options.json.empty()) write_file(options.json, history_json(demand, fatigue));
    put(history_text(demand, fatigue));
  }
  return fatigue.passes() ? all_pass : check_fails;
}

/// What is wrong with the value of --tolerance, or nothing.
std::string tolerance_trouble(const std::string& text) {
  double fraction = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), fraction);
  const bool number = error == std::errc{} && end == text.data() + text.size();
  if (number && fraction >= 1e-9 && fraction < 1.0) return "";
  return fmt::format("\"{}\" is no tolerance; write a fraction, for example 0.01 for 1 %", text);
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

/// What a command wants behind it, in messages.
std::string usage_of(const std::string& command) {
  if (command == "fatigue") return "write boxbeam fatigue HISTORY.csv --detail 100";
  if (command == "section") return "write boxbeam section \"RHS 200x100x8\"";
  return fmt::format("write boxbeam {} CASE.toml", command);
}

/// The hint for a mistyped or missing command, case or option, which the parser does not give.
std::string usage_hint(int argc, char** argv, const CLI::App& app) {
  const std::vector<std::string> names{"verify", "motion", "section", "fatigue"};
  std::string commands =
      "write boxbeam verify CASE.toml, boxbeam motion CASE.toml, boxbeam section PROFILE or "
      "boxbeam "
      "fatigue HISTORY.csv";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with('-')) continue;
    if (std::find(names.begin(), names.end(), word) != names.end()) {
      const CLI::App& command = *app.get_subcommand(word);
      const auto wanted = command.get_options(
          [](const CLI::Option* option) { return option->get_required() && option->empty(); });
      return wanted.empty() ? option_hint(argc, argv, command) : usage_of(word);
    }
    const std::string near = nearest_word(word, names);
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
      ->add_option("--model", verify_options.model,
                   "auto: the cheapest sufficient one; rigid; flexible (default: as the case says, "
                   "else auto)")
      ->check(CLI::IsMember({"auto", "rigid", "flexible"}));
  verify_command
      ->add_option("--tolerance", verify_options.tolerance,
                   "of --model auto: on the governing stress, 0.01 for 1 % (default: as the case "
                   "says, else 0.01)")
      ->check(tolerance_trouble);
  verify_command->add_flag("--no-plots", verify_options.no_plots, "write no plots");

  MotionOptions motion_options;
  CLI::App* motion_command = app.add_subcommand(
      "motion",
      "positions, velocities, accelerations and reactions of the mechanism alone; of elastic links "
      "frequencies, static and harmonic response");
  motion_command->add_option("CASE", motion_options.case_file, "case file (.toml)")->required();
  motion_command
      ->add_option("--at", motion_options.at,
                   "instant in seconds; may be repeated (default: twelve instants of the period)")
      ->check(instant_trouble)
      ->allow_extra_args(false);
  motion_command->add_flag("--assemblies", motion_options.assemblies,
                           "list all ways to assemble the mechanism at the first --at (default 0)");
  motion_command->add_option("--axes", motion_options.axes,
                             "in space: give vectors in the axes of this body (default: world)");
  motion_command->add_option(
      "--json", motion_options.json,
      "write the motion to this file; - for standard output instead of the tables");
  motion_command->add_option("--set", motion_options.set, "override a key; may be repeated")
      ->allow_extra_args(false);

  SectionOptions section_options;
  CLI::App* section_command =
      app.add_subcommand("section", "properties of sections and slenderness of their plates");
  section_command
      ->add_option("PROFILE", section_options.profiles,
                   "\"RHS 200x100x8\", \"SHS 100x5\", \"CHS 168.3x8\",\n"
                   "\"box 400x600 flange 50 web 50\" (width x height), or FILE.toml:SECTION")
      ->required();
  section_command->add_option("--steel", section_options.steel, "for the plates (default: S355)");
  section_command->add_option("--json", section_options.json,
                              "write the properties to this file; - for standard output");

  FatigueOptions fatigue_options;
  CLI::App* fatigue_command =
      app.add_subcommand("fatigue", "cycles, damage and life of a stress history by itself");
  fatigue_command
      ->add_option("HISTORY", fatigue_options.history,
                   "table of stresses (first line: \"sigma [MPa]\", also \"time [s]\" before and "
                   "\"tau [MPa]\" behind), or - for standard input")
      ->required();
  fatigue_command
      ->add_option("--detail", fatigue_options.detail,
                   "what resists: a category (100), a row of the tables (8.2/6) or a curve of "
                   "another code (\"DNV-RP-C203 air:D\")")
      ->required();
  fatigue_command->add_option("--shear-detail", fatigue_options.shear_detail,
                              "likewise for the shear stress of a second column: 100 or 80");
  fatigue_command
      ->add_option("--count", fatigue_options.count,
                   "astm (default), 4-point, or periodic: one period of a repeating history")
      ->check(CLI::IsMember({"astm", "4-point", "periodic"}));
  fatigue_command
      ->add_option("--residue", fatigue_options.residue,
                   "with 4-point: half-cycles (default), repeated or discard")
      ->check(CLI::IsMember({"half-cycles", "repeated", "discard"}));
  fatigue_command->add_option("--raw", fatigue_options.raw,
                              "the history is raw little-endian doubles in this unit: --raw MPa");
  fatigue_command
      ->add_option("--repetitions", fatigue_options.repetitions,
                   "of the history in the wanted life (default 1)")
      ->check(CLI::PositiveNumber);
  fatigue_command->add_option("--gamma-Ff", fatigue_options.gamma_Ff, "on the ranges (default 1)")
      ->check(CLI::PositiveNumber);
  fatigue_command->add_option("--gamma-Mf", fatigue_options.gamma_Mf, "on the curve (default 1)")
      ->check(CLI::PositiveNumber);
  fatigue_command
      ->add_option("--loading", fatigue_options.loading,
                   "spectrum (default) or constant: no damage while all ranges are below the limit")
      ->check(CLI::IsMember({"spectrum", "constant"}));
  fatigue_command->add_flag("--stress-relieved", fatigue_options.stress_relieved,
                            "not welded, or stress relieved: compression counts 60 % (7.2.1)");
  fatigue_command->add_option(
      "--json", fatigue_options.json,
      "write the result to this file; - for standard output instead of the text");

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
  if (section_command->parsed()) return run_section(section_options);
  if (fatigue_command->parsed()) return run_fatigue(fatigue_options);
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
