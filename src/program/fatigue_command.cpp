#include "program/commands.hpp"

#include <fmt/format.h>

#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/named_resistance.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/report/history_report.hpp"
#include "boxbeam/verification/history_fatigue.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

/// A quantity in words of the command line; nothing where the option is not there.
template <class Quantity>
std::optional<Quantity> quantity_of(const std::string& option, const std::string& text,
                                    const WantedDimension& wanted) {
  if (text.empty()) return std::nullopt;
  const auto parsed = parse_quantity(text);
  const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
  if (quantity == nullptr || !is_of(quantity->exponents, wanted) || !(quantity->value > 0.0)) {
    throw InputError(fmt::format("{} \"{}\" is not {} above zero", option, text, wanted.name),
                     fmt::format("write {} {}", option, wanted.example));
  }
  return si<Quantity>(quantity->value);
}

/// The yield strength as it is given, or that of a steel at the plate's thickness.
std::optional<Stress> yield_strength_by(const FatigueOptions& options,
                                        std::optional<Length> thickness) {
  if (options.steel.empty()) return quantity_of<Stress>("--yield", options.yield, wanted::stress);
  if (!options.yield.empty()) {
    throw InputError("--steel and --yield both say the yield strength", "leave one of them out");
  }
  const auto steel = find_steel(options.steel);
  if (!steel) {
    throw InputError(fmt::format("there is no steel \"{}\"", options.steel),
                     fmt::format("known are {}", fmt::join(steel_names(), ", ")));
  }
  if (!thickness) {
    throw InputError("the yield strength of a steel depends on the plate's thickness",
                     "add --thickness \"20 mm\", or write --yield \"355 MPa\"");
  }
  auto strength = yield_strength_of(*steel, *thickness);
  if (!strength) {
    throw InputError(fmt::format("{} has no yield strength for this thickness", options.steel),
                     "write --yield \"265 MPa\"");
  }
  return strength;
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
  const auto thickness = quantity_of<Length>("--thickness", options.thickness, wanted::length);
  demand.direct = resistance_named(options.detail, StressKind::direct, thickness);
  if (!options.shear_detail.empty()) {
    demand.shear = resistance_named(options.shear_detail, StressKind::shear, thickness);
  }
  demand.yield_strength = yield_strength_by(options, thickness);
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
