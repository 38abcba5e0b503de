// Compares the program with the oracle over many random cases; see scripts/oracle.sh.
//
//   boxbeam_oracle [--from NUMBER] [--cases COUNT] [--every STEP] [--density full|coarse]
//                  [--keep FOLDER] [--verbose]
//
// Exit code 0: they agree on all; 1: they do not; 2: wrong usage.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "comparison.hpp"

namespace {

namespace fs = std::filesystem;
using oracle::Outcome;

struct Arguments {
  std::uint64_t from = 1;
  std::uint64_t cases = 300;
  std::uint64_t every = 1;
  oracle::Density density = oracle::coarse;
  std::string keep;
  bool verbose = false;
};

[[noreturn]] void refuse(const std::string& why) {
  fmt::print(stderr,
             "{}\nusage: boxbeam_oracle [--from NUMBER] [--cases COUNT] [--every STEP] [--density "
             "full|coarse] [--keep FOLDER] [--verbose]\n",
             why);
  std::exit(2);
}

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--verbose") {
      arguments.verbose = true;
      continue;
    }
    if (i + 1 == argc) refuse(fmt::format("\"{}\" wants a value", key));
    const std::string value = argv[++i];
    const auto number = [&] {
      char* end = nullptr;
      const std::uint64_t of = std::strtoull(value.c_str(), &end, 10);
      if (value.empty() || *end != '\0') refuse(fmt::format("\"{}\" is no count", value));
      return of;
    };
    if (key == "--from")
      arguments.from = number();
    else if (key == "--cases")
      arguments.cases = number();
    else if (key == "--every")
      arguments.every = std::max<std::uint64_t>(1, number());
    else if (key == "--keep")
      arguments.keep = value;
    else if (key == "--density" && (value == "full" || value == "coarse"))
      arguments.density = value == "full" ? oracle::full : oracle::coarse;
    else
      refuse(fmt::format("\"{} {}\" is not known", key, value));
  }
  return arguments;
}

/// What a run adds up to.
struct Tally {
  std::map<Outcome::Kind, long> kinds;
  std::map<std::string, long> misses;
  std::map<std::string, double> most;  ///< excess
  long verdicts = 0, disagreeing = 0, evaluations = 0;
  std::array<long, oracle::faults.size()> shown{};
};

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = arguments_of(argc, argv);
  const fs::path scratch =
      fs::temp_directory_path() / fmt::format("boxbeam-oracle-{}", arguments.from);
  Tally tally;
  const auto begin = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < arguments.cases; ++i) {
    const std::uint64_t number = arguments.from + i * arguments.every;
    const oracle::RandomCase of = oracle::random_case(number);
    const Outcome outcome = oracle::examine(of, scratch.string(), arguments.density);
    ++tally.kinds[outcome.kind];
    tally.evaluations += outcome.findings.evaluations;
    const bool refused = outcome.kind == Outcome::Kind::refused;
    const bool agrees = !refused && outcome.comparison.agrees();
    if (!agrees) ++tally.disagreeing;
    if (refused) fmt::print("case {} is refused: {}\n", number, outcome.why);
    if (outcome.kind == Outcome::Kind::not_analysed && arguments.verbose)
      fmt::print("case {} is not analysed: {}\n", number, outcome.why);
    for (const oracle::Miss& miss : outcome.comparison.misses) {
      const std::string name = boxbeam::to_text(miss.criterion);
      ++tally.misses[name];
      if (miss.reported > 0.0) tally.most[name] = std::max(tally.most[name], miss.excess());
      fmt::print("case {}: {}\n", number, oracle::to_text(miss));
    }
    if (!outcome.comparison.verdict.empty()) {
      ++tally.verdicts;
      fmt::print("case {}: {}\n", number, outcome.comparison.verdict);
    }
    if (arguments.verbose && arguments.cases == 1) {
      for (const auto& [criterion, found] : outcome.findings.worst) {
        fmt::print("  {}: {:.5f} at s = {}, {}\n", boxbeam::to_text(criterion), found.utilisation,
                   boxbeam::to_text(found.station), found.place);
      }
    }
    for (std::size_t k = 0; k < tally.shown.size(); ++k) tally.shown[k] += outcome.shown[k] ? 1 : 0;
    if (arguments.verbose && outcome.comparison.most_above > 0.05) {
      fmt::print("case {}: {} is reported {:.1f} % above what the oracle finds\n", number,
                 outcome.comparison.above, 100.0 * outcome.comparison.most_above);
    }
    if ((!agrees || arguments.cases == 1) && !arguments.keep.empty()) of.write(arguments.keep);
    std::fflush(stdout);
  }
  fs::remove_all(scratch);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print(
      "cases {}, compared {}, not analysed {}, not covered {}, refused {}; disagreeing {}, "
      "verdicts "
      "that differ {}; {} evaluations; {:.1f} s\n",
      arguments.cases, tally.kinds[Outcome::Kind::compared],
      tally.kinds[Outcome::Kind::not_analysed], tally.kinds[Outcome::Kind::not_covered],
      tally.kinds[Outcome::Kind::refused], tally.disagreeing, tally.verdicts, tally.evaluations,
      seconds);
  for (const auto& [name, count] : tally.misses)
    fmt::print("  {}: {} misses, at most {:.3f} %\n", name, count, 100.0 * tally.most[name]);
  for (std::size_t k = 0; k < tally.shown.size(); ++k)
    fmt::print("  {} would show in {} cases\n", to_text(oracle::faults[k]), tally.shown[k]);
  return tally.disagreeing == 0 ? 0 : 1;
}
