#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/project/key_reference.hpp"
#include "boxbeam/report/case_schema.hpp"
#include "program/chart_command.hpp"
#include "program/command_line.hpp"
#include "program/commands.hpp"
#include "program/entries.hpp"
#include "program/exit_code.hpp"
#include "program/failures.hpp"
#include "program/terminal.hpp"
#include "report/text_layout.hpp"
#include "version.hpp"

/// The command line as CLI11 parses it; what the commands do stands in src/program.
namespace {

using namespace boxbeam;
using namespace boxbeam::program;

/// What is wrong with the value of --at, or nothing. Farther away the phase of the motion is lost
/// in the rounding of the period.
std::string instant_trouble(const std::string& text) {
  const std::optional<double> seconds = number_in(text);
  if (seconds && std::abs(*seconds) <= 1e9) return "";
  return "\"" + text + "\" is no instant; write seconds without unit, for example 1.071";
}

Entry verify_entry(CLI::App& app) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App& command = *app.add_subcommand("verify", "verify a case and write its report");
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of the report (default: reports/NAME of the case)");
  add_choice(
      command, "--level", options->level, {"summary", "governing", "full"},
      "how much the report says (default: governing, all that the governing checks rest on)");
  add_value(command, "--export", options->export_to, "DIR",
            "also write tables, a case of loads, beam.vtk and beam.inp (CalculiX) for other "
            "programs into this folder");
  command.add_flag(
      "--sensitivities", options->sensitivities,
      "also say by how much the governing factors change with every input of the case; "
      "verifies it four to six times for each");
  command.add_flag("--no-plots", options->no_plots, "draw no figures");
  command.add_flag("--no-html", options->no_html, "write no report.html");
  command.add_flag("--no-pdf", options->no_pdf, "write no report.pdf");
  command.add_flag("--watch", options->watch,
                   "verify again whenever the case or a table that it reads changes, and say what "
                   "changed; Ctrl-C ends it");
  add_json(command, options->json, "results", "the summary");
  command.add_flag("--quiet,-q", options->quiet, "print the verdict only, in one line");
  add_verified_case(command, options->of_case);
  return {&command,
          {"boxbeam verify rig.toml", "boxbeam verify rig.toml --set strength.required=2.5"},
          [options] { return run_verify(*options); }};
}

Entry explain_entry(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App& command =
      *app.add_subcommand("explain", "show how a check comes about, formula by formula");
  add_value(command, "CHECK", options->check, "ID",
            "id of the check as the report shows it; or its beginning (fatigue, fatigue/4.2) "
            "for the worst of these, governing for the worst of all, list for all ids")
      ->required();
  add_verified_case(command, options->of_case);
  return {&command,
          {"boxbeam explain fatigue rig.toml", "boxbeam explain list rig.toml"},
          [options] { return run_explain(*options); }};
}

Entry compare_entry(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *app.add_subcommand(
      "compare", "compare published or hand-calculated values with those of the program");
  add_verified_case(command, options->of_case);
  add_value(command, "PUBLISHED", options->published, "FILE.csv",
            "table: result, published, tolerance, reason, source")
      ->required();
  add_json(command, options->json, "comparison", "the text");
  add_value(command, "--html", options->html, "FILE", "also write it as HTML to this file");
  return {&command,
          {"boxbeam compare published.toml thesis.csv --dynamics newton-chain"},
          [options] { return run_compare(*options); }};
}

Entry schema_entry(CLI::App& app) {
  const auto document = std::make_shared<std::string>("case");
  CLI::App& command = *app.add_subcommand(
      "schema", "print the JSON Schema of a case or of what the program writes");
  add_choice(command, "DOCUMENT", *document, schema_names(), "of which one (default: case)");
  return {&command, {"boxbeam schema results"}, [document] {
            put(schema_of(*document));
            return all_pass;
          }};
}

Entry motion_entry(CLI::App& app) {
  const auto options = std::make_shared<MotionOptions>();
  CLI::App& command = *app.add_subcommand(
      "motion",
      "positions, velocities, accelerations and reactions of the mechanism alone; of elastic links "
      "frequencies, static and harmonic response");
  add_case(command, options->of_case);
  add_repeated(command, "--at", options->at,
               "instant in seconds; may be repeated (default: twelve instants of the period)",
               "TIME")
      ->check(instant_trouble);
  command.add_flag("--assemblies", options->assemblies,
                   "list all ways to assemble the mechanism at the first --at (default 0)");
  add_value(command, "--axes", options->axes, "BODY",
            "in space: give vectors in the axes of this body, and see the scene of --gltf "
            "from it (default: world)");
  add_value(command, "--gltf", options->gltf, "FILE",
            "also write the whole motion as an animated scene (glTF 2.0) to this file, which "
            "viewers show");
  add_value(command, "--csv", options->csv, "FILE",
            "also write the instants as comma-separated values to this file, a row each: "
            "bodies, coordinates of joints, reactions");
  add_json(command, options->json, "motion", "the tables");
  return {&command,
          {"boxbeam motion rig.toml --at 1.071", "boxbeam motion rig.toml --gltf rig.gltf"},
          [options] { return run_motion(*options); }};
}

Entry section_entry(CLI::App& app) {
  const auto options = std::make_shared<SectionOptions>();
  CLI::App& command =
      *app.add_subcommand("section", "properties of sections and slenderness of their plates");
  add_value(command, "PROFILE", options->profiles, "TEXT",
            "\"RHS 200x100x8\", \"SHS 100x5\", \"CHS 168.3x8\", \"box 400x600 flange 50 web "
            "50\" (width x height), or FILE.toml:SECTION")
      ->required();
  add_value(command, "--steel", options->steel, "NAME", "for the plates (default: S355)");
  add_value(command, "--forces", options->forces, "TEXT",
            "cut forces under which the plates of boxes, tubes and paths are judged, "
            "\"N = -600 kN, M_y = 1500 kN m\"; of N, V_y, V_z, T, M_y, M_z");
  add_json(command, options->json, "properties", "the text");
  return {&command,
          {"boxbeam section \"RHS 200x100x8\"",
           "boxbeam section \"box 600x1224 flange 12 web 8\" --forces \"M_y = 1500 kN m\""},
          [options] { return run_section(*options); }};
}

Entry fatigue_entry(CLI::App& app) {
  const auto options = std::make_shared<FatigueOptions>();
  CLI::App& command =
      *app.add_subcommand("fatigue", "cycles, damage and life of a stress history by itself");
  add_value(command, "HISTORY", options->history, "FILE.csv",
            "table of stresses (first line: \"sigma [MPa]\", also \"time [s]\" before and "
            "\"tau [MPa]\" behind), or - for standard input")
      ->required();
  add_value(command, "--detail", options->detail, "DETAIL",
            "what resists: a category (100), a row of the tables (8.2/6) or a curve of "
            "another code (\"DNV-RP-C203 air:D\")")
      ->required();
  add_value(command, "--shear-detail", options->shear_detail, "DETAIL",
            "likewise for the shear stress of a second column: 100 or 80");
  add_value(command, "--thickness", options->thickness, "LENGTH",
            "of the plate: for the size effect of the row or the code, the line of a row, and "
            "the yield strength of --steel");
  add_value(command, "--steel", options->steel, "STEEL",
            "the plate's steel, for the limit of a range, 1.5 f_y (EN 1993-1-9, 8(1))");
  add_value(command, "--yield", options->yield, "STRESS",
            "its yield strength instead: \"355 MPa\"");
  add_choice(command, "--count", options->count, {"astm", "4-point", "periodic"},
             "how cycles are counted (default: astm); periodic: one period of a repeating history");
  add_choice(command, "--residue", options->residue, {"half-cycles", "repeated", "discard"},
             "what becomes of open cycles of 4-point (default: half-cycles)");
  add_value(command, "--raw", options->raw, "UNIT",
            "the history is raw little-endian doubles in this unit: --raw MPa");
  add_value(command, "--repetitions", options->repetitions, "NUMBER",
            "of the history in the wanted life (default: 1)")
      ->check(range_trouble(1e-9, 1e15, "1e5"));
  const auto factor = [&](const char* name, double& value, const char* says) {
    add_value(command, name, value, "NUMBER", says)->check(range_trouble(0.01, 100.0, "1.35"));
  };
  factor("--gamma-Ff", options->gamma_Ff, "partial factor on the ranges (default: 1)");
  factor("--gamma-Mf", options->gamma_Mf, "partial factor on the curve (default: 1)");
  add_choice(command, "--loading", options->loading, {"spectrum", "constant"},
             "constant: no damage while all ranges are below the limit (default: spectrum)");
  command.add_flag("--stress-relieved", options->stress_relieved,
                   "not welded, or stress relieved: compression counts 60 % (EN 1993-1-9, 7.2.1)");
  add_json(command, options->json, "result", "the text");
  return {&command, {"boxbeam fatigue HISTORY.csv --detail 100"}, [options] {
            return run_fatigue(*options);
          }};
}

Entry chart_entry(CLI::App& app) {
  const auto options = std::make_shared<ChartOptions>();
  CLI::App& command = *app.add_subcommand(
      "chart", "chart accuracy against cost of the numerical methods, and map where they fail");
  std::vector<std::string> words{"all"};
  for (const std::string& topic : chart_topics()) words.push_back(topic);
  CLI::Option* const topic = command.add_option(
      "TOPIC", options->topics, "what to chart (default: all): " + CLI::detail::join(words, ", "));
  // Where there are no charts, that is what is to be said of any topic.
  if (words.size() > 1) topic->check(CLI::IsMember(words));
  CLI::Option* const of_case =
      add_value(command, "--case", options->of_case.file, "FILE.toml",
                "on this case (default: the sledge rig and the drill truck)");
  add_set(command, options->of_case)->needs(of_case);
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of the charts (default: reports/accuracy)");
  command.add_flag("--quick", options->quick, "fewer settings, shorter measurements");
  command.add_flag("--no-pdf", options->no_pdf, "write no chart.pdf");
  return {&command,
          {"boxbeam chart kinematics --quick", "boxbeam chart all --case my.toml --out charts"},
          [options] { return run_chart(*options); }};
}

/// The first word of init: a kind, or the file of a planar case.
CLI::Validator kind_or_file() {
  CLI::Validator kind = CLI::IsMember(case_kinds());
  const std::string words = kind.get_description();
  return {[kind](std::string& word) { return is_case_file(word) ? std::string() : kind(word); },
          words};
}

Entry init_entry(CLI::App& app) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App& command =
      *app.add_subcommand("init", "write a commented case that runs as it is, to begin from");
  command
      .add_option("KIND", options->kind,
                  "rigid bodies in a plane (default), rigid bodies in space, elastic links, a beam "
                  "or frame at "
                  "rest on supports, or given loads; may be left out before a FILE.toml")
      ->check(kind_or_file());
  add_value(command, "FILE", options->file, "FILE.toml",
            "where to, which must not be there yet (default: KIND.toml); - for standard "
            "output");
  CLI::Option* const urdf =
      add_value(command, "--from-urdf", options->urdf, "FILE.urdf",
                "begin a case in space with the bodies and joints of this robot (URDF)");
  add_value(command, "--from-mjcf", options->mjcf, "FILE.xml",
            "the same of a model of MuJoCo (MJCF), with the loops that it closes")
      ->excludes(urdf);
  add_value(command, "--beam", options->beam, "LINK",
            "the robot's link that is the beam (default: its heaviest but the root)");
  command.add_flag("--schema", options->schema,
                   "write the schema beside it, boxbeam-case.schema.json, by which editors of TOML "
                   "(Even Better TOML, taplo) complete and explain its keys");
  return {&command,
          {"boxbeam init planar my.toml", "boxbeam init static --schema",
           "boxbeam init --from-urdf arm.urdf my.toml"},
          [options] { return run_init(*options); }};
}

Entry validate_entry(CLI::App& app) {
  const auto options = std::make_shared<CaseOptions>();
  CLI::App& command =
      *app.add_subcommand("validate", "read a case; say what it is, or all that is wrong with it");
  add_verified_case(command, *options);
  return {&command, {"boxbeam validate my.toml"}, [options] { return run_validate(*options); }};
}

Entry completion_entry(CLI::App& app, const CommandLine& line) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("completion", "print the completion of the command line for a shell");
  add_choice(command, "SHELL", *shell, {"bash", "zsh"}, "which one")->required();
  return {&command, {"eval \"$(boxbeam completion bash)\""}, [shell, &line] {
            put(completion_of(line, *shell));
            return all_pass;
          }};
}

/// Of the commands that are there before it.
Entry help_entry(CLI::App& app, const CommandLine& line) {
  const auto name = std::make_shared<std::string>();
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  CLI::App& command = *app.add_subcommand("help", "print the help of a command, or this one");
  add_choice(command, "COMMAND", *name, names, "of which one (default: of the program)");
  return {&command, {"boxbeam help verify"}, [name, &line] {
            put(name->empty() ? help_of(line) : help_of(*command_named(line, *name)));
            return all_pass;
          }};
}

Entry manual_entry(CLI::App& app, const CommandLine& line) {
  CLI::App& command = *app.add_subcommand("manual", "print the manual page");
  return {&command, {"boxbeam manual | man -l -"}, [&line] {
            put(manual_of(line));
            return all_pass;
          }};
}

/// The words of "TEXT:{rigorous,newton-chain}".
std::vector<std::string> words_in(const std::string& type) {
  const std::size_t begin = type.find('{');
  if (begin == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, type.rfind('}') - begin - 1), ',');
}

Argument argument_of(const CLI::Option& option) {
  const std::string type = option.get_items_expected_max() > 0 ? option.get_type_name() : "";
  const std::vector<std::string>& brief = option.get_snames();
  return {option.get_positional() ? option.get_name(true) : "--" + option.get_lnames().front(),
          brief.empty() ? "" : "-" + brief.front(),
          option.get_description(),
          type.substr(0, type.find(':')),
          words_in(type),
          option.get_required(),
          option.get_items_expected_max() > 1};
}

/// The parser's tree as a value.
CommandLine line_of(const CLI::App& app, const std::vector<Entry>& entries) {
  CommandLine line{app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options()) line.options.push_back(argument_of(*option));
  for (const Entry& entry : entries) {
    Command command{entry.app->get_name(), entry.app->get_description(), entry.examples, {}, {}};
    for (const CLI::Option* option : entry.app->get_options()) {
      (option->get_positional() ? command.places : command.options).push_back(argument_of(*option));
    }
    line.commands.push_back(std::move(command));
  }
  return line;
}

int run(int argc, char** argv) {
  CLI::App app(
      "boxbeam verifies the strength and fatigue life of welded beams that a mechanism moves.");
  app.name("boxbeam");
  app.set_help_flag("--help,-h", "print this help");
  app.set_version_flag("--version,-V", std::string("boxbeam ") + version, "print the version");
  app.require_subcommand(1);
  CommandLine line;
  const std::vector<Entry> entries{init_entry(app),         validate_entry(app),
                                   verify_entry(app),       explain_entry(app),
                                   compare_entry(app),      motion_entry(app),
                                   section_entry(app),      fatigue_entry(app),
                                   solve_entry(app),        sweep_entry(app),
                                   merge_entry(app),        optimise_entry(app),
                                   reliability_entry(app),  chart_entry(app),
                                   schema_entry(app),       completion_entry(app, line),
                                   manual_entry(app, line), help_entry(app, line)};
  line = line_of(app, entries);
  const auto parsed = [&]() -> const Entry* {
    for (const Entry& entry : entries) {
      if (entry.app->parsed()) return &entry;
    }
    return nullptr;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const Entry* entry = parsed();
    put(entry ? help_of(*command_named(line, entry->app->get_name())) : help_of(line));
    return all_pass;
  } catch (const CLI::CallForVersion& version_asked) {
    put(std::string(version_asked.what()) + "\n");
    return all_pass;
  } catch (const CLI::ParseError& error) {
    put_error(error.what());
    const bool incomplete = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const std::string hint = hint_for(line, {argv + 1, argv + argc}, incomplete);
    if (!hint.empty()) std::cerr << "    hint: " << visible(hint, "\n") << "\n";
    std::cerr << "Run boxbeam --help for the commands and options.\n";
    return wrong_input;
  }
  return parsed()->run();
}

}  // namespace

int main(int argc, char** argv) {
  // A short run keeps its memory: given back and taken again it costs some 250 page faults.
  constexpr int kept = 64 << 20;
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_MMAP_THRESHOLD, kept);
  // A file that grows beyond its limit is an error of writing, not the end without a word.
  std::signal(SIGXFSZ, SIG_IGN);
  layout::set_width(columns());
  return exit_code_of([&] { return run(argc, argv); });
}
