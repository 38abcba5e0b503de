#include "program/fatigue_command.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "boxbeam/report/history_report.hpp"
#include "boxbeam/verification/history_fatigue.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

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

}  // namespace

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
  require_file(options.json);
  HistoryFatigue fatigue;
  {
    SampleCount count(options.json != "-");
    fatigue = fatigue_of_history(demand, [&](std::uint64_t samples) { count.at(samples); });
  }
  put_result(options.json, history_json(demand, fatigue), history_text(demand, fatigue));
  return fatigue.passes() ? all_pass : check_fails;
}

}  // namespace boxbeam::program
