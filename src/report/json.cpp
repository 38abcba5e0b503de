#include "boxbeam/report/json.hpp"

#include "beam_json.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "load_model_json.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

Json check_json(const CheckResult& result) {
  const Check& check = result.check;
  const auto stress = [&](Stress PointStress::*part) {
    return result.basis ? Json(finite((result.basis->stress_at_time.*part).value())) : Json();
  };
  // Member by member: a list of pairs would be built of arrays first, for every check.
  Json json = Json::object();
  json["id"] = check.id;
  json["criterion"] = to_text(check.criterion);
  json["point"] = check.point;
  json["station"] = check.on_beam ? Json(finite(check.station.s.value())) : Json();
  json["side"] = check.on_beam ? Json(to_text(check.station.side)) : Json();
  json["situation"] = check.situation;
  json["time"] = finite(check.time.value());
  json["acting"] = finite(check.acting.value());
  json["resisting"] = finite(check.resisting.value());
  json["safety_factor"] = finite(check.safety_factor);
  json["required"] = finite(check.required);
  json["utilisation"] = finite(check.utilisation());
  json["unit"] = check.acting.unit();
  json["source"] = check.source;
  json["normal_stress"] = stress(&PointStress::normal);
  json["shear_stress"] = stress(&PointStress::shear);
  return json;
}

Json governing_json(const Verification& verification) {
  Json governing = Json::object();
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue}) {
    const CheckResult* result = verification.governing(criterion);
    governing[to_text(criterion)] = result != nullptr ? check_json(*result) : Json();
  }
  return governing;
}

Json model_json(const ModelChoice& choice) {
  const auto described = [](const ElasticModel& model) {
    return Json{{"level", to_text(model.level)},
                {"modes", model.modes},
                {"parts", model.parts},
                {"axial", model.axial}};
  };
  Json weighed = Json::array();
  for (const ModelEstimate& of : choice.weighed) {
    Json& model = weighed.emplace_back(described(of.model));
    model["estimate"] = finite(of.error);
    model["found"] = of.found ? Json(finite(*of.found)) : Json();
    model["basis"] = of.basis;
  }
  Json frequencies = Json::array();
  for (const double frequency : choice.frequencies) frequencies.push_back(finite(frequency));
  Json harmonics = Json::array();
  for (const LoadHarmonic& harmonic : choice.harmonics) {
    harmonics.push_back(
        {{"frequency", finite(harmonic.frequency)}, {"share", finite(harmonic.share)}});
  }
  Json model = {{"chosen", to_text(choice.chosen.level)}, {"reason", choice.reason}};
  model["modes"] = choice.chosen.modes;
  model["parts"] = choice.chosen.parts;
  model["axial"] = choice.chosen.axial;
  model["tolerance"] = finite(choice.tolerance);
  model["frequencies"] = std::move(frequencies);
  model["harmonics"] = std::move(harmonics);
  model["weighed"] = std::move(weighed);
  return model;
}

Json codes_json(const Verification& verification) {
  Json codes = Json::array();
  for (const CodeResult& code : verification.codes) {
    const bool found = code.missing.empty();
    codes.push_back({{"code", code.code},
                     {"curve", found ? Json(code.curve) : Json()},
                     {"unconfirmed", code.unconfirmed},
                     {"safety_factor", found ? Json(finite(code.safety_factor)) : Json()},
                     {"required", finite(code.required)},
                     {"station", found ? Json(finite(code.station.s.value())) : Json()},
                     {"point", found ? Json(code.point) : Json()},
                     {"missing", code.missing}});
  }
  return codes;
}

/// The curve of the governing fatigue check, and what the check found on it.
Json sn_json(const Project& project, const Verification& verification) {
  if (!verification.sn) return {};
  const SnFigure& sn = *verification.sn;
  Json fatigue = {{"code", sn.code},
                  {"curve", sn.name},
                  {"reference", finite(sn.reference)},
                  {"knee", finite(sn.knee)},
                  {"cut_off", finite(sn.cut_off)},
                  {"cycles", finite(most_cycles_of(project))}};
  const CheckResult* const governing = verification.governing(Criterion::fatigue);
  const bool computed =
      governing != nullptr && governing->basis && !governing->basis->curves.empty();
  fatigue["strength"] =
      computed ? Json(finite(strength_at(governing->basis->curves.front(), most_cycles_of(project),
                                         project.fatigue.demand.loading)
                                 .value()))
               : Json();
  fatigue["constant_amplitude_factor"] =
      computed ? Json(finite(governing->basis->constant_amplitude_factor)) : Json();
  fatigue["damage"] = computed ? Json(finite(governing->basis->damage)) : Json();
  fatigue["equivalent_range"] =
      computed ? Json(finite(governing->basis->equivalent.value())) : Json();
  return fatigue;
}

Json search_json(const SearchSummary& search) {
  return {{"evaluations", search.evaluations},
          {"pieces", search.pieces},
          {"tolerance", finite(search.tolerance)}};
}

}  // namespace

std::string results_json(const Project& project, const Verification& verification) {
  Json instants = Json::array();
  for (const CriticalInstant& instant : verification.critical_instants) {
    instants.push_back({{"quantity", instant.quantity},
                        {"situation", project.situations[instant.situation].name},
                        {"station", finite(instant.station.s.value())},
                        {"side", to_text(instant.station.side)},
                        {"time", finite(instant.time.value())},
                        {"value", finite(instant.value)}});
  }
  Json checks = Json::array();
  for (const CheckResult& result : verification.checks) checks.push_back(check_json(result));
  Json not_judged = Json::array();
  for (const NotJudged& of : verification.not_judged) {
    not_judged.push_back({{"what", of.what}, {"reason", of.reason}});
  }
  const Json document = {{"schema", "boxbeam.results/1"},
                         {"case", project.name},
                         {"version", version},
                         {"input_sha256", project.sha256},
                         {"verdict", to_text(verification.verdict)},
                         {"model", model_json(verification.model)},
                         {"critical_instants", std::move(instants)},
                         {"beam", beam_json(project, verification)},
                         {"checks", std::move(checks)},
                         {"governing", governing_json(verification)},
                         {"codes", codes_json(verification)},
                         {"remarks", remarks_of(project, verification)},
                         {"mechanism", mechanism_json(project)},
                         {"freedom", freedom_json(verification)},
                         {"equivalent_mass", equivalent_mass_json(project, verification)},
                         {"newton_chain", newton_chain_json(verification)},
                         {"loads", loads_json(project, verification)},
                         {"sections", sections_json(project, verification)},
                         {"concentrations", concentrations_json(verification)},
                         {"sn", sn_json(project, verification)},
                         {"verdict_text", verdict_text_of(project, verification).whole()},
                         {"not_judged", std::move(not_judged)},
                         {"search", search_json(verification.search)}};
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
