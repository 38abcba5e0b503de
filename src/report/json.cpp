#include "boxbeam/report/json.hpp"

#include "boxbeam/report/remarks.hpp"
#include "json_number.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

Json pair(const Envelope& envelope) {
  return Json::array({finite(envelope.smallest.value), finite(envelope.largest.value)});
}

Json check_json(const Check& check) {
  return {{"id", check.id},
          {"criterion", to_text(check.criterion)},
          {"point", check.point},
          {"station", check.on_beam ? Json(finite(check.station.s.value())) : Json()},
          {"side", check.on_beam ? Json(to_text(check.station.side)) : Json()},
          {"situation", check.situation},
          {"time", finite(check.time.value())},
          {"acting", finite(check.acting.value())},
          {"resisting", finite(check.resisting.value())},
          {"safety_factor", finite(check.safety_factor)},
          {"required", finite(check.required)},
          {"utilisation", finite(check.utilisation())},
          {"unit", check.acting.unit()},
          {"source", check.source}};
}

Json beam_json(const Verification& verification, const Project& project) {
  Json stations = Json::array();
  for (const StationEnvelope& station : verification.stations) {
    Json& at = stations.emplace_back(
        Json{{"s", finite(station.station.s.value())}, {"side", to_text(station.station.side)}});
    for (const auto& [which, name] : cut_forces_looked_at(project))
      at[name] = pair(station.of[which]);
  }
  return {{"length", finite(project.beam.length().value())},
          {"mass", finite(verification.beam_mass.mass.value())},
          {"centre_of_mass", finite(verification.beam_mass.centre.value())},
          {"stations", std::move(stations)}};
}

Json governing_json(const Verification& verification) {
  Json governing = Json::object();
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue}) {
    const CheckResult* result = verification.governing(criterion);
    governing[to_text(criterion)] = result != nullptr ? check_json(result->check) : Json();
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
  for (const CheckResult& result : verification.checks) checks.push_back(check_json(result.check));
  const Json document = {{"schema", "boxbeam.results/1"},
                         {"case", project.name},
                         {"version", version},
                         {"input_sha256", project.sha256},
                         {"verdict", to_text(verification.verdict)},
                         {"model", model_json(verification.model)},
                         {"critical_instants", std::move(instants)},
                         {"beam", beam_json(verification, project)},
                         {"checks", std::move(checks)},
                         {"governing", governing_json(verification)},
                         {"codes", codes_json(verification)},
                         {"remarks", remarks_of(project, verification)}};
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
