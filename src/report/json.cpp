#include "boxbeam/report/json.hpp"

#include <algorithm>

#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/beam_properties.hpp"
#include "json_number.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

Json pair(const Envelope& envelope) {
  return Json::array({finite(envelope.smallest.value), finite(envelope.largest.value)});
}

Json check_json(const CheckResult& result) {
  const Check& check = result.check;
  const auto stress = [&](Stress PointStress::*part) {
    return result.basis ? Json(finite((result.basis->stress_at_time.*part).value())) : Json();
  };
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
          {"source", check.source},
          {"normal_stress", stress(&PointStress::normal)},
          {"shear_stress", stress(&PointStress::shear)}};
}

Json beam_json(const Verification& verification, const Project& project) {
  Json stations = Json::array();
  for (const StationEnvelope& station : verification.stations) {
    Json& at = stations.emplace_back(
        Json{{"s", finite(station.station.s.value())}, {"side", to_text(station.station.side)}});
    for (const auto& [which, name] : cut_forces_looked_at(project))
      at[name] = pair(station.of[which]);
  }
  Json parts = Json::array();
  for (const BeamPart& part : parts_of(project.beam)) {
    parts.push_back({{"from", part.from},
                     {"to", part.to},
                     {"mass", finite(part.mass.mass.value())},
                     {"centre_from_start", finite((part.mass.centre - part.start).value())},
                     {"centre_from_end", finite((part.end - part.mass.centre).value())},
                     {"inertia", finite(part.mass.inertia.value())}});
  }
  return {{"length", finite(project.beam.length().value())},
          {"mass", finite(verification.beam_mass.mass.value())},
          {"centre_of_mass", finite(verification.beam_mass.centre.value())},
          {"stations", std::move(stations)},
          {"inertia", finite(verification.beam_mass.inertia.value())},
          {"parts", std::move(parts)}};
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

Json section_json(const StationProperties& at) {
  const SectionProperties& gross = at.gross;
  Json lag;
  if (at.shear_lag) {
    lag = {{"b_0", finite(at.shear_lag->b_0.value())},
           {"L_e", finite(at.shear_lag->effective_length.value())},
           {"kappa", finite(at.shear_lag->kappa)},
           {"beta", finite(at.shear_lag->beta)}};
  }
  Json levels = Json::array();
  for (const LevelProperties& level : at.levels) {
    levels.push_back({{"name", level.name},
                      {"z", finite(level.z.value())},
                      {"first_moment", finite(level.first_moment.value())},
                      {"width", finite(level.width.value())}});
  }
  return {{"s", finite(at.station.s.value())},
          {"side", to_text(at.station.side)},
          {"height", finite((gross.z_top - gross.z_bottom).value())},
          {"width", finite((gross.y_left - gross.y_right).value())},
          {"area", finite(gross.area.value())},
          {"I_y", finite(gross.I_y.value())},
          {"I_z", finite(gross.I_z.value())},
          {"W_y", finite(gross.W_y.value())},
          {"W_z", finite(gross.W_z.value())},
          {"area_of_holes", finite((gross.area - at.net.area).value())},
          {"net",
           {{"area", finite(at.net.area.value())},
            {"I_y", finite(at.net.I_y.value())},
            {"W_y", finite(at.net.W_y.value())}}},
          {"weight_per_length", finite(at.weight.value())},
          {"shear_lag", std::move(lag)},
          {"levels", std::move(levels)}};
}

/// Masses that the loads rest on; nothing for elastic links, whose mass is spread along them.
Json mechanism_json(const Project& project) {
  if (is_flexible(project)) return {};
  Json gravity = Json::array();
  Json bodies = Json::object();
  if (in_space(project)) {
    for (const double g : spatial_of(project).gravity) gravity.push_back(finite(g));
    for (const spatial::Body& body : spatial_of(project).bodies) {
      bodies[body.name] = {{"mass", finite(body.mass)}, {"inertia", Json()}};
    }
  } else {
    for (const double g : planar_of(project).gravity) gravity.push_back(finite(g));
    for (const Body& body : planar_of(project).bodies) {
      bodies[body.name] = {{"mass", finite(body.mass)}, {"inertia", finite(body.inertia)}};
    }
  }
  return {{"gravity", std::move(gravity)}, {"bodies", std::move(bodies)}};
}

Json vector_json(const Eigen::Vector3d& v) {
  return Json::array({finite(v.x()), finite(v.y()), finite(v.z())});
}

Json loads_json(const Project& project, const Verification& verification) {
  Json loads = Json::array();
  for (const BeamLoadRow& row : verification.loads) {
    loads.push_back({{"by", row.name},
                     {"situation", project.situations[row.situation].name},
                     {"time", finite(row.time.value())},
                     {"s", finite(row.s.value())},
                     {"world", vector_json(row.world)},
                     {"force", vector_json(row.force)},
                     {"moment", vector_json(row.moment)}});
  }
  return loads;
}

/// The concentration at every hole by every formula that was used, each once.
Json concentrations_json(const Verification& verification) {
  Json list = Json::array();
  const auto add = [&](const std::string& hole, HoleCase by, double ratio, double factor) {
    Json entry = {{"hole", hole},
                  {"case", to_text(by)},
                  {"diameter_to_width", finite(ratio)},
                  {"factor", finite(factor)}};
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(std::move(entry));
  };
  for (const PublishedConcentration& of : verification.published_concentrations) {
    add(of.hole, HoleCase::published_exponential, of.diameter_to_width, of.factor);
  }
  for (const CheckResult& result : verification.checks) {
    if (!result.basis || !result.basis->point.concentration) continue;
    const EdgeConcentration& edge = *result.basis->point.concentration;
    add(edge.hole, edge.hole_case, edge.diameter_to_width, edge.factor);
  }
  return list;
}

/// The curve of the governing fatigue check, and what the check found on it.
Json fatigue_json(const Project& project, const Verification& verification) {
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

Json force_json(const Eigen::Vector2d& force) {
  return {{"fx", finite(force.x())}, {"fy", finite(force.y())}};
}

/// The Newton chain's loads and the rigorous ones beside them.
Json chain_json(const Verification& verification) {
  if (!verification.chain) return {};
  const ChainComparison& chain = *verification.chain;
  const bool both = !chain.rigorous_first.isZero() || !chain.rigorous_second.isZero();
  Json rigorous;
  if (both) {
    rigorous = {{"first", force_json(chain.rigorous_first)},
                {"second", force_json(chain.rigorous_second)}};
  }
  return {{"time", finite(chain.time.value())},
          {"first", force_json(chain.chain_first)},
          {"second", force_json(chain.chain_second)},
          {"sought_mass", finite(chain.chain_mass.value())},
          {"moment_gap", finite(chain.moment_gap.value())},
          {"rigorous", std::move(rigorous)}};
}

Json equivalent_mass_json(const Project& project, const Verification& verification) {
  if (!verification.equivalent_mass) return {};
  return {{"given", finite(verification.equivalent_mass->given)},
          {"per_mass", finite(verification.equivalent_mass->per_mass)},
          {"wanted", finite(project.equivalent_mass->wanted.value())},
          {"needed", finite(verification.equivalent_mass->needed)}};
}

/// Degrees of freedom by count and by rank; nothing for a chain in space and for elastic links.
Json freedom_json(const Verification& verification) {
  const auto& closure = verification.motions.front().closure;
  if (!closure) return {};
  return {{"gruebler", closure->freedom.gruebler}, {"by_rank", closure->freedom.by_rank}};
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
  Json sections = Json::array();
  for (const StationProperties& at : station_properties_of(project, verification)) {
    sections.push_back(section_json(at));
  }
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
                         {"remarks", remarks_of(project, verification)},
                         {"mechanism", mechanism_json(project)},
                         {"freedom", freedom_json(verification)},
                         {"equivalent_mass", equivalent_mass_json(project, verification)},
                         {"newton_chain", chain_json(verification)},
                         {"loads", loads_json(project, verification)},
                         {"sections", std::move(sections)},
                         {"concentrations", concentrations_json(verification)},
                         {"sn", fatigue_json(project, verification)}};
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
