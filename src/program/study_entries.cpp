#include <memory>

#include "program/entries.hpp"
#include "program/optimise_command.hpp"
#include "program/reliability_command.hpp"
#include "program/solve_command.hpp"
#include "program/sweep_command.hpp"

namespace boxbeam::program {
namespace {

void add_netcdf(CLI::App& command, bool& netcdf) {
  command.add_flag("--netcdf", netcdf,
                   "write the rows as typed columns too, rows.nc: NetCDF-4, which is HDF5");
}

void add_threads(CLI::App& command, std::size_t& threads) {
  add_value(command, "--threads", threads, "NUMBER",
            "how many designs are verified at once (default: as many as the machine can)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4096}));
}

}  // namespace

Entry solve_entry(CLI::App& app) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App& command = *app.add_subcommand(
      "solve", "find the values of a key of the case that give a wanted result");
  add_verified_case(command, options->of_case);
  add_value(command, "--for", options->key, "KEY",
            "key of the case that is looked for: sections.A1.flange, drivers.drive.amplitude")
      ->required();
  add_value(command, "--such-that", options->such_that, "RESULT=VALUE",
            "what is wanted, a key of results.json and its value: \"fatigue.safety_factor = "
            "2\", \"beam.mass = 2 t\"; \"utilisation = 90 %\" is that of the check used most")
      ->required();
  add_value(command, "--between", options->between, "A B",
            "two values between which to look (default: a quarter of what the case says to "
            "four times as much)")
      ->expected(2);
  add_json(command, options->json, "values", "the text");
  return {&command,
          {"boxbeam solve rig.toml --for sections.A1.flange --such-that \"beam.mass = 2 t\""},
          [options] { return run_solve(*options); }};
}

Entry sweep_entry(CLI::App& app) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command = *app.add_subcommand("sweep", "verify all designs of a study");
  add_value(command, "STUDY", options->study, "FILE.toml", "what changes of which case")
      ->required();
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of rows.csv, study.json and study.html (default: reports/NAME of the study)");
  add_threads(command, options->threads);
  add_value(command, "--shard", options->shard, "I/N",
            "only this part of the designs: 2/8, the second of eight; boxbeam merge joins "
            "them");
  command.add_flag("--resume", options->resume, "go on with a study that was broken off");
  command.add_flag("--quiet,-q", options->quiet, "no progress");
  add_netcdf(command, options->netcdf);
  add_json(command, options->json, "summary", "the text");
  return {&command,
          {"boxbeam sweep study.toml", "boxbeam sweep study.toml --shard 2/8 --out part2"},
          [options] { return run_sweep(*options); }};
}

Entry optimise_entry(CLI::App& app) {
  const auto options = std::make_shared<OptimiseOptions>();
  CLI::App& command =
      *app.add_subcommand("optimise", "look for the design of a study with the least of a result");
  add_value(command, "STUDY", options->study, "FILE.toml",
            "what may be chosen, and what is to be least")
      ->required();
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of optimum.json, a page of all designs looked at and figures (default: "
            "none is written)");
  add_threads(command, options->threads);
  add_json(command, options->json, "result", "the text");
  return {&command, {"boxbeam optimise study.toml"}, [options] { return run_optimise(*options); }};
}

Entry merge_entry(CLI::App& app) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App& command = *app.add_subcommand("merge", "join the parts of a study");
  add_value(command, "DIR", options->folders, "DIR", "folders of boxbeam sweep --shard")
      ->required();
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of rows.csv, study.json and study.html (default: the first one)");
  add_netcdf(command, options->netcdf);
  add_json(command, options->json, "summary", "the text");
  return {&command, {"boxbeam merge part1 part2"}, [options] { return run_merge(*options); }};
}

Entry reliability_entry(CLI::App& app) {
  const auto options = std::make_shared<ReliabilityOptions>();
  CLI::App& command = *app.add_subcommand(
      "reliability", "find the probability that a case or a formula passes a limit state");
  add_value(command, "STUDY", options->study, "FILE.toml",
            "what scatters of which case, and where it fails")
      ->required();
  add_value(command, "--out,-o", options->out, "DIR",
            "folder of reliability.json, reliability.html and figures (default: reports/NAME "
            "of the study)");
  add_threads(command, options->threads);
  command.add_flag("--quiet,-q", options->quiet, "no progress");
  add_json(command, options->json, "result", "the text");
  return {&command, {"boxbeam reliability study.toml"}, [options] {
            return run_reliability(*options);
          }};
}

}  // namespace boxbeam::program
