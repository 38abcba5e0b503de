#include "boxbeam/report/json.hpp"

#include <algorithm>
#include <utility>

#include "boxbeam/numerics/nine_digits.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "document_fields.hpp"
#include "json_parts.hpp"
#include "version.hpp"

namespace boxbeam::report {
namespace {

/// A check, of several beams with the one that it is of.
struct CheckOfBeam {
  CheckOfBeam() = default;
  CheckOfBeam(const CheckResult& of, std::string name) : result(&of), beam(std::move(name)) {}

  static const CheckResult& none() {
    static const CheckResult check{};
    return check;
  }
  const CheckResult* result = &none();
  std::string beam;
};

/// All checks of all beams, worst first; what is used alike as its beam has it, on every computer.
std::vector<CheckOfBeam> checks_of(const std::vector<VerifiedBeam>& beams) {
  std::vector<CheckOfBeam> all;
  for (const VerifiedBeam& beam : beams) {
    for (const CheckResult& result : beam.verification.checks)
      all.emplace_back(result, beam.project.beam_name);
  }
  std::stable_sort(all.begin(), all.end(), [](const CheckOfBeam& a, const CheckOfBeam& b) {
    return nine_digits(a.result->check.utilisation()) > nine_digits(b.result->check.utilisation());
  });
  return all;
}

void put_check(Fields& to, const CheckResult& result) {
  const Check& check = result.check;
  const auto stress = [&](const auto& part_of) {
    return result.basis ? std::optional(part_of(result.basis->stress_at_time).value())
                        : std::nullopt;
  };
  to.text({"id", "criterion, station with its side and point: \"yield/4.2-/fibre+z\""}, check.id);
  to.text("criterion", to_text(check.criterion));
  to.text("point", check.point);
  to.number_or_null({"station", "s along the beam; null for a neighbour of the beam"}, "m",
                    check.on_beam ? std::optional(check.station.s.value()) : std::nullopt);
  to.word_or_null(
      "side",
      check.on_beam ? std::optional<std::string_view>(to_text(check.station.side)) : std::nullopt,
      sides);
  to.text({"situation", "\"\" where the case has only one"}, check.situation);
  to.number("time", "s", check.time.value());
  to.number_in("acting", check.acting.unit(), "unit", check.acting.value());
  to.number_in("resisting", check.resisting.unit(), "unit", check.resisting.value());
  to.number({"safety_factor",
             "the largest factor on the whole load history for which the criterion still holds"},
            "1", check.safety_factor);
  to.number("required", "1", check.required);
  to.number({"utilisation", "required over safety factor"}, "1",
            [&] { return check.utilisation(); });
  to.text({"unit", "of acting and resisting"}, check.acting.unit());
  to.text({"source", "standard and clause"}, check.source);
  to.number_or_null({"normal_stress", "nominal, at the check's time; null where it was given"},
                    "Pa", stress([](const PointStress& of) { return of.normal; }));
  to.number_or_null({"shear_stress", "likewise"}, "Pa",
                    stress([](const PointStress& of) { return of.shear; }));
  to.number_or_null(
      {"sufficient_throat",
       "of a weld: the least throat, 3 mm or more, with which its throat and its root "
       "pass all checks; of a seam those of this place; null where none does"},
      "m",
      result.sufficient_throat ? std::optional(result.sufficient_throat->value()) : std::nullopt);
}

void put_level(Fields& to, const ElasticModel& model) {
  to.whole("modes", model.modes, "1");
  to.whole("parts", model.parts, "1");
  to.boolean("axial", model.axial);
}

void put_model(Fields& to, const ModelChoice& choice) {
  to.word("chosen", to_text(choice.chosen.level), {"rigid", "quasi-static", "modal", "flexible"});
  to.text("reason", choice.reason);
  put_level(to, choice.chosen);
  to.number("tolerance", "1", choice.tolerance);
  to.numbers({"frequencies", "natural, lowest first"}, "Hz", choice.frequencies);
  to.list({"harmonics", "with which the loads vibrate"}, "", choice.harmonics,
          [](Fields& of, const LoadHarmonic& harmonic) {
            of.number("frequency", "Hz", harmonic.frequency);
            of.number("share", "1", harmonic.share);
          });
  to.list({"weighed", "models and their estimated errors"}, "", choice.weighed,
          [](Fields& of, const ModelEstimate& estimate) {
            of.text("level", to_text(estimate.model.level));
            put_level(of, estimate.model);
            of.number("estimate", "1", estimate.error);
            of.number_or_null("found", "1", estimate.found);
            of.text("basis", estimate.basis);
          });
}

void put_code(Fields& to, const CodeResult& code) {
  const bool found = code.missing.empty();
  const auto number = [&](double value) { return found ? std::optional(value) : std::nullopt; };
  to.text("code", code.code);
  to.text_or_null("curve", found ? std::optional(code.curve) : std::nullopt);
  to.boolean("unconfirmed", code.unconfirmed);
  to.number_or_null("safety_factor", "1", number(code.safety_factor));
  to.number("required", "1", code.required);
  to.number_or_null("station", "m", number(code.station.s.value()));
  to.text_or_null("point", found ? std::optional(code.point) : std::nullopt);
  to.number_or_null({"thickness", "of the plate at the place"}, "m",
                    number(code.thickness.value()));
  to.number_or_null({"size_factor", "on the curve's strengths, by the code's own rule"}, "1",
                    number(code.size_factor));
  to.number({"damage_limit", "of the damage sum"}, "1", code.damage_limit);
  to.text({"missing", "why there is no factor"}, code.missing);
}

void put_remedy(Fields& to, const Remedy& remedy) {
  to.word({"what", "is changed"}, to_text(remedy.what),
          {"detail category", "flange thickness", "web thickness", "wall thickness", "steel",
           "weld throat", "stiffeners", "diaphragm spacing", "diaphragm thickness"});
  to.text(
      {"name", "\"category 112\", \"58 mm flanges\", \"S460N\", \"6.5 mm throat of weld foot\""},
      remedy.name);
  to.number_in(
      {"value",
       "category, thickness (the largest that is changed), throat, yield strength, spacing"},
      unit_of(remedy.what), "unit", remedy.value);
  to.text("unit", unit_of(remedy.what));
  to.number({"utilisation", "the largest of the whole case with it"}, "1", remedy.utilisation);
  to.texts({"set",
            "keys of the case that make the change, as --set takes them; of plates and "
            "what holds them"},
           remedy.set);
}

/// The curve of the governing fatigue check, and what the check found on it.
void put_sn(Fields& to, const Project& project, const Verification& verification) {
  const CheckResult* const governing =
      to.is_describing() ? nullptr : verification.governing(Criterion::fatigue);
  const CheckBasis* const basis =
      governing != nullptr && governing->basis && !governing->basis->curves.empty()
          ? &*governing->basis
          : nullptr;
  const auto found = [&](const auto& value_of) {
    return basis != nullptr ? std::optional<double>(value_of(*basis)) : std::nullopt;
  };
  to.object_or_null(
      {"sn", "curve of the governing fatigue check, and what was found on it"},
      verification.pictures.sn, [&](Fields& of, const SnFigure& sn) {
        of.text("code", sn.code);
        of.text("curve", sn.name);
        of.number({"reference", "at 2e6 cycles; the thesis' step puts it at 5e6"}, "Pa",
                  sn.reference);
        of.number("knee", "Pa", sn.knee);
        of.number({"cut_off", "0 where the curve has none"}, "Pa", sn.cut_off);
        of.number({"cycles", "wanted"}, "1", [&] { return most_cycles_of(project); });
        of.number_or_null({"strength", "at these cycles; null where the stress was given"}, "Pa",
                          found([&](const CheckBasis& at) {
                            return strength_at(at.curves.front(), most_cycles_of(project),
                                               project.fatigue.demand.loading)
                                .value();
                          }));
        of.number_or_null({"constant_amplitude_factor", "EN 1993-1-9, 7.1(2)"}, "1",
                          found([](const CheckBasis& at) { return at.constant_amplitude_factor; }));
        of.number_or_null("damage", "1", found([](const CheckBasis& at) { return at.damage; }));
        of.number_or_null({"equivalent_range", "of 2e6 cycles, with this damage"}, "Pa",
                          found([](const CheckBasis& at) { return at.equivalent.value(); }));
      });
}

/// The unit of what is critical, by its name.
const Json& units_of_quantities() {
  static const Json units{{"N", "N"},     {"V", "N"},     {"V_y", "N"},
                          {"V_z", "N"},   {"T", "N m"},   {"M", "N m"},
                          {"M_y", "N m"}, {"M_z", "N m"}, {"stress", "Pa"}};
  return units;
}

void put_instant(Fields& to, const Project& project, const CriticalInstant& instant) {
  to.text({"quantity", "cut force, or stress"}, instant.quantity());
  to.text("situation", situation_name(project, instant.situation));
  to.number("station", "m", instant.station.s.value());
  to.word("side", to_text(instant.station.side), sides);
  to.number("time", "s", instant.time.value());
  const Json& units = units_of_quantities();
  to.number_in("value", units.value(instant.quantity(), "1"), "quantity", instant.value, units);
}

/// Slender plates, where there are some.
void put_plates(Fields& to, const Verification& verification) {
  if (!to.is_describing() && verification.routes.empty()) return;
  to.optional().object(
      {"plates", "slender ones, by which route of EN 1993-1-5 they are judged; absent without"},
      [&](Fields& of) {
        of.list(
            "segments", "{segment}", verification.routes,
            [](Fields& segment, const SegmentRoute& route) {
              segment.text("segment", route.segment);
              segment.word("route", to_text(route.route), {"effective widths", "reduced stresses"});
              segment.text({"reason", "of a route that the case does not ask for"}, route.reason);
            });
        of.list({"beside",
                 "the worst check of each criterion of the other route, no part of the verdict, "
                 "without forces that come into webs"},
                "{id}", verification.beside, put_check);
      });
}

/// What is found of one of several beams.
void put_beam_of_several(Fields& to, const VerifiedBeam& beam) {
  const Verification& of = beam.verification;
  to.text("name", beam.project.beam_name);
  to.word("verdict", to_text(of.verdict), {"pass", "fail", "not applicable"});
  to.text("verdict_text", [&] { return verdict_text_of(beam.project, of).whole(); });
  to.object("model", [&](Fields& model) { put_model(model, of.model); });
  if (to.is_describing()) {
    const Project project;
    put_beam(to, project, of);
  } else {
    put_beam(to, beam.project, of);
  }
  put_plates(to, of);
  to.object("governing", [&](Fields& governing) {
    for (const Criterion criterion : {Criterion::yield, Criterion::fatigue})
      governing.object_or_null(to_text(criterion),
                               to.is_describing() ? nullptr : of.governing(criterion), put_check);
  });
  to.texts("remarks", [&] {
    std::vector<std::string> texts;
    for (const Remark& remark : remarks_of(beam.project, of)) texts.push_back(remark.whole());
    return texts;
  });
}

}  // namespace

void put_governing(Fields& to, const Verification& verification) {
  if (verification.checks.empty()) return;
  to.number("utilisation", "1", [&] { return verification.checks.front().check.utilisation(); });
  to.object("governing", [&](Fields& of) {
    for (const Criterion criterion : criteria) {
      std::string name = to_text(criterion);
      std::replace(name.begin(), name.end(), ' ', '_');
      const CheckResult* const worst = verification.governing(criterion);
      if (worst != nullptr) of.object(name, [&](Fields& check) { put_check(check, *worst); });
    }
  });
}

void put_results(Fields& to, const Project& project, const Verification& verification,
                 const std::vector<VerifiedBeam>* beams, const Sensitivities* sensitivities) {
  to.constant("schema", "boxbeam.results/1");
  to.text("case", project.name);
  to.text({"version", "of the program"}, version);
  to.text({"input_sha256", "of the case, its overrides and its tables"}, project.sha256);
  to.word("verdict", to_text(verification.verdict), {"pass", "fail", "not applicable"});
  to.object("model", [&](Fields& of) { put_model(of, verification.model); });
  to.list("critical_instants", "{quantity}@{time}", verification.critical_instants,
          [&](Fields& of, const CriticalInstant& instant) { put_instant(of, project, instant); });
  to.object({"beam", "of several the one that decides"},
            [&](Fields& of) { put_beam(of, project, verification); });
  const auto checks = [&] {
    if (beams != nullptr) return checks_of(*beams);
    std::vector<CheckOfBeam> all;
    for (const CheckResult& result : verification.checks) all.emplace_back(result, "");
    return all;
  };
  to.list({"checks", "worst utilisation first"}, "{id}", checks,
          [&](Fields& of, const CheckOfBeam& check) {
            put_check(of, *check.result);
            if (!of.is_describing() && beams == nullptr) return;
            of.optional().text({"beam", "of which it is, where there are several"}, check.beam);
          });
  to.object("governing", [&](Fields& of) {
    for (const Criterion criterion : {Criterion::yield, Criterion::fatigue})
      of.object_or_null(to_text(criterion), verification.governing(criterion), put_check);
  });
  to.list({"codes", "the governing fatigue check by other codes"}, "{code}", verification.codes,
          put_code);
  to.texts("remarks", [&] {
    std::vector<std::string> texts;
    for (const Remark& remark : remarks_of(project, verification)) texts.push_back(remark.whole());
    return texts;
  });
  put_mechanism(to, project);
  put_freedom(to, verification);
  put_equivalent_mass(to, project, verification);
  put_newton_chain(to, verification);
  put_loads(to, project, verification);
  put_sections(to, project, verification);
  put_concentrations(to, verification);
  put_sn(to, project, verification);
  put_plates(to, verification);
  to.text({"verdict_text",
           "the verdict with what it leaves out and why it is not applicable: \"PASS for strength; "
           "fatigue: no stress range\""},
          [&] { return verdict_text_of(project, verification).whole(); });
  to.list({"not_judged", "what the case asks for and no check judges"}, "{what}",
          verification.not_judged, [](Fields& of, const NotJudged& what) {
            of.text({"what", "fatigue, deflection, a pin or a rod"}, what.what);
            of.text("reason", what.reason);
          });
  to.object({"search", "how the governing places along the beam were searched"}, [&](Fields& of) {
    const SearchSummary& search = verification.search;
    of.whole({"evaluations", "stations at which every criterion was judged"}, search.evaluations);
    of.whole({"pieces", "of the beam between places where something jumps or kinks"},
             search.pieces);
    of.number({"tolerance",
               "by how much a criterion's largest utilisation may exceed the one found, relative"},
              "1", search.tolerance);
  });
  to.list({"remedies",
           "where the case fails: single changes with each of which it passes, found by verifying "
           "again"},
          "{what}", verification.remedies.found, put_remedy);
  if (to.is_describing())
    put_sensitivities(to, {});
  else if (sensitivities != nullptr)
    put_sensitivities(to, *sensitivities);
  if (!to.is_describing() && beams == nullptr) return;
  static const std::vector<VerifiedBeam> none;
  to.optional().list(
      {"beams",
       "each of several, in the order of the case; all else here is of the one that decides"},
      "{name}", beams != nullptr ? *beams : none,
      [](Fields& of, const VerifiedBeam& beam) { put_beam_of_several(of, beam); });
}

}  // namespace boxbeam::report

namespace boxbeam {

std::string results_json(const Project& project, const Verification& verification) {
  return report::document_text(
      [&](report::Fields fields) { report::put_results(fields, project, verification); });
}

std::string results_json(const std::vector<VerifiedBeam>& beams,
                         const Sensitivities* sensitivities) {
  const VerifiedBeam& worst = worst_of(beams);
  return report::document_text([&](report::Fields fields) {
    report::put_results(fields, worst.project, worst.verification,
                        beams.size() > 1 ? &beams : nullptr, sensitivities);
  });
}

}  // namespace boxbeam
