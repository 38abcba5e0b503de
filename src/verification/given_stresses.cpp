#include "boxbeam/verification/given_stresses.hpp"

#include <cmath>
#include <utility>

#include "boxbeam/strength/yield.hpp"
#include "check_sources.hpp"
#include "details_at.hpp"

namespace boxbeam {
namespace {

Stress rounded(Stress stress, Stress step) {
  return si<Stress>(std::round(stress.value() / step.value()) * step.value());
}

}  // namespace

std::vector<CheckResult> check_given_stresses(const Project& project) {
  std::vector<CheckResult> results;
  for (const GivenStress& given : project.given_stresses) {
    const Station station{given.s, Side::both};
    const auto add = [&](Criterion criterion, Stress acting, Stress strength, Stress resisting,
                         double required, const std::string& source) {
      CheckResult result;
      result.given = GivenBasis{given, strength};
      Check& check = result.check;
      check.id = id_of(criterion, station, given.name);
      check.criterion = criterion;
      check.station = station;
      check.point = given.name;
      check.time = given.time;
      check.acting = acting;
      check.resisting = resisting;
      check.safety_factor = resisting / acting;
      check.required = required;
      check.source = source;
      results.push_back(std::move(result));
    };
    const Material& material =
        *first_to_yield(plates_around(project, given.s, given.thickness)).material;
    const Stress yield = yield_strength_of(material, given.thickness).value();
    add(Criterion::yield, given.peak, yield,
        yield_resistance(plainly, yield, project.strength.gamma_M0), project.strength.required,
        yield_source(material));
    if (!given.opposite || !project.fatigue.asked) continue;
    const FatigueInput& fatigue = project.fatigue;
    for (ResistingDetail& resisting :
         details_at(fatigue, station, {DetailPlace::fibres, false}, given.thickness)) {
      const SnCurve curve = curve_of(resisting.detail->detail);
      Stress strength = strength_at(curve, most_cycles_of(project), fatigue.demand.loading);
      if (fatigue.round_strength_to) strength = rounded(strength, *fatigue.round_strength_to);
      add(Criterion::fatigue, given.peak + *given.opposite, strength,
          strength / (fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf), fatigue.required,
          fatigue_source(fatigue, {curve}));
      results.back().given->resisting = std::move(resisting);
    }
  }
  return results;
}

}  // namespace boxbeam
