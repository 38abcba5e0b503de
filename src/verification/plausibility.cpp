#include "boxbeam/verification/plausibility.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// Above these nothing is meant.
constexpr double odd_factor = 1e6;
constexpr double odd_stress = 1e12;             // [Pa]
constexpr double odd_density[2] = {200, 3e4};   // [kg/m^3] wood, osmium and a little more
constexpr double odd_modulus[2] = {1e8, 2e12};  // [Pa] rubber, diamond and a little more

[[noreturn]] void refuse(const std::string& what, const std::string& where) {
  throw AnalysisError({fmt::format("{} is no number that can be shown: the values of the case are "
                                   "too large, too small or too far apart for the arithmetic",
                                   what),
                       where});
}

/// Numbers that round to nothing or to everything are as good as none.
bool is_number(double value) { return std::abs(value) < 1e200; }

void require_numbers(const Check& check) {
  const auto require = [&](const char* what, double value) {
    if (!is_number(value)) refuse(what, "check " + check.id);
  };
  require("what acts", check.acting.value());
  require("what resists", check.resisting.value());
  require("the factor", check.safety_factor);
  require("the instant", check.time.value());
  if (!(check.safety_factor > 0.0)) refuse("the factor", "check " + check.id);
  require("the utilisation", check.utilisation());
}

void require_numbers(const CheckBasis& basis, const std::string& id) {
  for (const double value :
       {basis.stress_at_time.normal.value(), basis.stress_at_time.shear.value(), basis.damage,
        basis.equivalent.value(), basis.constant_amplitude_factor, basis.highest.value,
        basis.lowest.value}) {
    if (!is_number(value)) refuse("what the check rests on", "check " + id);
  }
}

}  // namespace

void require_numbers(const std::vector<StationEnvelope>& stations,
                     const std::vector<CheckResult>& checks, const ModelChoice& model) {
  for (const StationEnvelope& station : stations) {
    for (const Envelope& envelope : station.of) {
      if (is_number(envelope.smallest.value) && is_number(envelope.largest.value)) continue;
      refuse("a cut force", fmt::format("station {}", to_text(station.station)));
    }
  }
  for (const CheckResult& result : checks) {
    require_numbers(result.check);
    if (result.basis) require_numbers(*result.basis, result.check.id);
  }
  for (const ModelEstimate& weighed : model.weighed) {
    if (!is_number(weighed.error) || (weighed.found && !is_number(*weighed.found)))
      refuse("the error of a model", "beam");
  }
}

void require_numbers(const std::optional<ChainComparison>& chain) {
  if (!chain) return;
  if (!is_number(chain->chain_mass.value())) refuse("the mass that the chain yields", "beam");
  if (!is_number(chain->moment_gap.value())) refuse("the couple left over by the chain", "beam");
}

void require_moderate_work(std::size_t instants, std::size_t places) {
  // Some ten seconds.
  constexpr double most = 1e6;
  if (static_cast<double>(instants) * static_cast<double>(places) <= most) return;
  throw AnalysisError(
      {fmt::format(
           "this is too much work: the situations have {} instants in all, and the beam {} places; "
           "their product can be {:g} at most. Give a shorter [motion] duration, frequencies with "
           "a "
           "short common period, fewer situations or fewer segments",
           instants, places, most),
       "beam"});
}

namespace {

/// Factors below one, with which less is asked than without any.
void add_small_factors(const Project& project, std::vector<std::string>& odd) {
  const auto look = [&](const std::string& table, const char* key, double value) {
    if (value >= 1.0) return;
    odd.push_back(fmt::format(
        "odd: {} = {:.3g} of {} is below 1: less is asked for than without it", key, value, table));
  };
  const StrengthDemand& strength = project.strength;
  look("[strength]", "gamma_M0", strength.gamma_M0);
  look("[strength]", "gamma_M1", strength.gamma_M1);
  look("[strength]", "gamma_M2", strength.gamma_M2);
  look("[strength]", "required", strength.required);
  if (project.fatigue.asked) {
    look("[fatigue]", "gamma_Ff", project.fatigue.demand.gamma_Ff);
    look("[fatigue]", "gamma_Mf", project.fatigue.demand.gamma_Mf);
    look("[fatigue]", "required", project.fatigue.required);
  }
  // Those that are as [strength] has them have been said.
  const auto look_beside = [&](const std::string& of, const char* key, double value,
                               double in_strength) {
    if (value != in_strength) look(of, key, value);
  };
  for (const PinInput& pin : project.pins) {
    look_beside("pin " + pin.name, "gamma_M0", pin.strength.gamma_M0, strength.gamma_M0);
    look_beside("pin " + pin.name, "gamma_M2", pin.strength.gamma_M2, strength.gamma_M2);
    look_beside("pin " + pin.name, "required", pin.required, strength.required);
    constexpr double loose = 1.2;
    const double play = pin.geometry.hole / pin.geometry.diameter;
    if (play > loose)
      odd.push_back(fmt::format("odd: the hole of pin {} is {:.3g} times as wide as the pin",
                                pin.name, play));
  }
  for (const RodInput& rod : project.rods) {
    look_beside("rod " + rod.name, "gamma_M0", rod.gamma_M0, strength.gamma_M0);
    look_beside("rod " + rod.name, "gamma_M1", rod.gamma_M1, strength.gamma_M1);
    look_beside("rod " + rod.name, "gamma_M2", rod.gamma_M2, strength.gamma_M2);
    look_beside("rod " + rod.name, "required", rod.required, strength.required);
  }
  for (const WeldInput& weld : project.welds)
    look_beside("weld " + weld.name, "required", weld.required, strength.required);
}

}  // namespace

std::vector<std::string> odd_things(const Project& project, const Verification& verification) {
  std::vector<std::string> odd;
  const Check* highest = nullptr;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.acting.unit() != "Pa" || check.acting.value() <= odd_stress) continue;
    if (highest == nullptr || check.acting.value() > highest->acting.value()) highest = &check;
  }
  if (highest != nullptr) {
    odd.push_back(fmt::format(
        "odd: {} has {:.3g} Pa, more than any solid bears; look for a unit or a power of ten",
        highest->id, highest->acting.value()));
  }
  const Check& worst = verification.checks.front().check;
  if (worst.safety_factor > odd_factor) {
    odd.push_back(fmt::format(
        "odd: the governing factor is {:.3g}: next to nothing loads the beam; look for a unit or a "
        "power of ten",
        worst.safety_factor));
  }
  const auto outside = [&](const char* what, double value, const double(&usual)[2],
                           const char* unit) {
    if (value >= usual[0] && value <= usual[1]) return;
    odd.push_back(fmt::format("odd: {} is {:.3g} {}; materials have {:g} to {:g}", what, value,
                              unit, usual[0], usual[1]));
  };
  outside("the density of the beam", project.beam.density.value(), odd_density, "kg/m^3");
  outside("Young's modulus of the beam", project.model.youngs_modulus, odd_modulus, "Pa");
  add_small_factors(project, odd);
  return odd;
}

}  // namespace boxbeam
