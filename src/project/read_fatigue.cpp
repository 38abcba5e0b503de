#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "boxbeam/fatigue/hot_spot.hpp"
#include "boxbeam/project/attachment_welds.hpp"
#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/detail_reader.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "boxbeam/section/path_webs.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// The plates of the sections on a stretch, the thickest first, for size effects.
std::vector<Length> plates_on(const TaperedBeam& beam, Length from, Length to,
                              ProblemList& problems) {
  std::vector<Length> plates;
  if (!problems.empty()) return plates;
  for (const Segment& segment : beam.segments) {
    if (segment.end() < from || segment.start > to) continue;
    for (const Section* section : {&segment.from, &segment.to}) {
      const std::vector<Length> of = thicknesses_of(*section);
      plates.insert(plates.end(), of.begin(), of.end());
    }
  }
  std::sort(plates.begin(), plates.end(), std::greater<>());
  plates.erase(std::unique(plates.begin(), plates.end()), plates.end());
  return plates;
}

/// The partial factor as a number, or by table 3.1.
void read_gamma_Mf(TableReader& table, FatigueInput& input) {
  static_cast<void>(table.says_one_of({{{"assessment", "consequence"}}, {{"gamma_Mf"}}}));
  if (!table.has("assessment") && !table.has("consequence")) {
    input.demand.gamma_Mf = table.number({"gamma_Mf", "partial factor on the strength"});
    return;
  }
  const std::size_t method = table.choice({"assessment", "instead of gamma_Mf, table 3.1"},
                                          {"damage tolerant", "safe life"});
  const std::size_t consequence =
      table.choice({"consequence", "of failure, table 3.1"}, {"low", "high"});
  if (table.has("gamma_Mf")) {
    table.problem("gamma_Mf", "gamma_Mf follows from \"assessment\" and \"consequence\"",
                  "write either the number or these two");
  }
  input.demand.gamma_Mf = recommended_gamma_Mf(
      method == 0 ? AssessmentMethod::damage_tolerant : AssessmentMethod::safe_life,
      consequence == 0 ? Consequence::low : Consequence::high);
  input.gamma_Mf_source =
      fmt::format("{}, {} consequence (table 3.1, recommended)",
                  method == 0 ? "damage tolerant" : "safe life", consequence == 0 ? "low" : "high");
}

std::vector<std::string> read_codes(TableReader& table) {
  std::vector<std::string> codes;
  if (!table.has("codes")) return codes;
  const std::vector<std::string> known = families();
  for (const std::string& code :
       table.texts({"codes", "curves of other codes to be shown beside"}, true)) {
    if (std::find(known.begin(), known.end(), code) == known.end()) {
      table.problem("codes", fmt::format("there are no curves \"{}\"", code),
                    unknown_hint(code, known));
      continue;
    }
    codes.push_back(code);
  }
  return codes;
}

/// A detail for direct stress under a key, where it is there.
std::optional<Detail> read_direct_detail(TableReader& table, const Key& key, const char* hint) {
  if (!table.has(key)) return std::nullopt;
  TableReader given = table.table(key);
  Detail detail = read_detail(given);
  if (given.problems().empty() && detail.curve.kind == StressKind::shear) {
    given.problem("", fmt::format("\"{}\" wants a detail for direct stress", key.name), hint);
  }
  given.finish();
  return detail;
}

/// A detail for plates of boxes bent across in their corners under its key, or the least.
Detail read_corner_detail(TableReader& table) {
  const Key key{"corner", "of plates of boxes bent across by distortion, at the seams in corners"};
  if (auto given = read_direct_detail(table, key, "write category = 71, or a row of table 8.5"))
    return *std::move(given);
  Detail detail;
  detail.name = "seam in a corner bent across (36* as its root, 8.5/3, not confirmed)";
  detail.curve = en_1993_1_9_direct(36.0);
  detail.unconfirmed = true;
  return detail;
}

AttachmentDetails read_attachment_details(TableReader& table) {
  AttachmentDetails given;
  given.diaphragms = read_direct_detail(
      table,
      {"diaphragms",
       "of their welds; where not said row 8.4/8 with the legs of their throat, or as long as they "
       "are thick"},
      "write category = 80, or a row of table 8.4");
  given.flats = read_direct_detail(
      table, {"flats", "of the welds along stiffeners; where not said row 8.2/5, category 100"},
      "write category = 100, or a row of table 8.2");
  given.flat_ends = read_direct_detail(
      table,
      {"flat_ends", "of stiffeners within the beam; where not said row 8.4/1 by their length"},
      "write category = 56, or a row of table 8.4");
  return given;
}

/// A detail for shear stress under a key, or a category of it that is there by default.
Detail read_shear_detail(TableReader& table, const Key& key, double category, const char* name) {
  if (!table.has(key)) {
    Detail detail;
    detail.name = name;
    detail.curve = en_1993_1_9_shear(category);
    return detail;
  }
  TableReader given = table.table(key);
  Detail detail = read_detail(given);
  if (given.problems().empty() && detail.curve.kind != StressKind::shear) {
    given.problem("", fmt::format("\"{}\" wants a detail for shear stress", key.name),
                  "write kind = \"shear\" in it, with category = 100 or 80");
  }
  given.finish();
  return detail;
}

/// The structural stress at a toe over the nominal one, from stresses on the surface before it.
double read_hot_spot(TableReader table) {
  const auto stress = [&](const char* name, const char* meaning) {
    return si<Stress>(table.positive({name, meaning}, wanted::stress));
  };
  const SurfaceStress surface{stress("near", "on the surface 0.4 thicknesses before the toe"),
                              stress("far", "1.0 thicknesses before it")};
  const Stress nominal = stress("nominal", "of the section there, under the same load");
  const double factor = hot_spot_stress_of(surface) / nominal;
  if (table.problems().empty() && factor < 1.0) {
    table.problem(
        "near",
        fmt::format("the hot spot has {:.3g} times the nominal stress, less than it", factor),
        "write stresses of one load, the nominal one without the weld's effect");
  }
  table.finish();
  return factor;
}

/// The factor from the nominal stress to that of the detail, which some rows cannot do without.
double read_stress_factor(TableReader& table, const Detail& detail, bool said = false) {
  const double factor = table.number(
      {"stress_factor", "stress of the detail over the nominal one (k_f, hot spot, throat)"}, 1.0);
  const bool wanted = detail.where == StressPlace::hot_spot || detail.where == StressPlace::throat;
  if (wanted && !said && !table.has("stress_factor")) {
    table.problem(
        "",
        fmt::format("row {} is for {}, which is not the nominal stress of the section", detail.row,
                    detail.where == StressPlace::hot_spot ? "the structural stress at the hot spot"
                                                          : "the stress in the weld's throat"),
        "write stress_factor, its ratio to the nominal stress: stress_factor = 1.3");
  }
  return factor;
}

/// The same of a stretch, whose hot spot may have stresses on the surface instead.
double read_stress_factor_or_surface(TableReader& table, const Detail& detail) {
  const Key key{
      "hot_spot",
      "in place of stress_factor: stresses on the surface before the toe, extended to it"};
  const bool one = table.says_one_of({{{"stress_factor"}}, {{"hot_spot"}}, {}});
  if (!table.has(key)) return read_stress_factor(table, detail);
  if (!one) {
    table.problem("hot_spot", "stress_factor and hot_spot both say the stress of the detail",
                  "leave one of them out");
  } else if (table.problems().empty() && detail.where != StressPlace::hot_spot) {
    table.problem("hot_spot", "the detail is not judged by the stress at a hot spot",
                  "choose a row of table B.1, or write stress_factor");
  }
  static_cast<void>(read_stress_factor(table, detail, true));
  return read_hot_spot(table.table(key));
}

/// Refuses details of webs or seams where the beam has none: they would resist nothing.
void require_webs(TableReader& table, const BeamDetail& on_beam, const TaperedBeam& beam) {
  const bool of_webs = on_beam.on == DetailPlace::webs || on_beam.on == DetailPlace::seams;
  if (!of_webs || !table.problems().empty()) return;
  const bool at_a_place = on_beam.from == on_beam.to;
  for (const Segment& segment : beam.segments) {
    const Length from = std::max(segment.start, on_beam.from);
    const Length to = std::min(segment.end(), on_beam.to);
    const bool lies_there = at_a_place ? from <= to : from < to;
    if (!lies_there || has_webs(segment.from) || has_webs(segment.to)) continue;
    table.problem("on",
                  fmt::format("segment \"{}\" has no {}: boxes and rectangular tubes have, and of "
                              "paths walls along z between other walls",
                              segment.name, on_beam.on == DetailPlace::webs ? "webs" : "seams"),
                  "write on = \"section\", or let the stretch end where the webs do");
    return;
  }
}

BeamDetail read_beam_detail(TableReader table, const TaperedBeam& beam) {
  BeamDetail on_beam;
  on_beam.from = station_of(table, {"from", "start along the beam"}, beam);
  on_beam.to = station_of(table, {"to", "its end"}, beam);
  constexpr DetailPlace places[] = {DetailPlace::section, DetailPlace::fibres, DetailPlace::webs,
                                    DetailPlace::seams};
  on_beam.on = places[table.choice({"on", "where in the section it is"},
                                   {"section", "fibres", "webs", "seams"}, 0)];
  on_beam.detail = read_detail(table, plates_on(beam, on_beam.from, on_beam.to, table.problems()));
  if (!table.has("name")) {
    table.problem("name", "a detail of the beam wants a name", "write name = \"hub weld\"");
  }
  if (table.problems().empty() && on_beam.detail.curve.kind == StressKind::shear) {
    table.problem("kind", "details of stretches are for direct stress",
                  "write shear = { kind = \"shear\", category = 80 } in [fatigue]");
  }
  require_webs(table, on_beam, beam);
  on_beam.stress_factor = read_stress_factor_or_surface(table, on_beam.detail);
  on_beam.assumed = table.text({"assumed", "why it is taken so"}, "");
  if (on_beam.to < on_beam.from) {
    table.problem("to", "the stretch ends before it begins", "exchange \"from\" and \"to\"");
  }
  table.finish();
  return on_beam;
}

}  // namespace

FatigueInput read_fatigue(TableReader table, const TaperedBeam& beam) {
  FatigueInput input;
  input.beam.to = beam.segments.empty() ? Length{} : beam.length();
  input.beam.detail =
      read_detail(table, plates_on(beam, Length{}, input.beam.to, table.problems()));
  if (table.problems().empty() && input.beam.detail.curve.kind == StressKind::shear) {
    table.problem("kind", "the detail of the beam is for direct stress",
                  "write shear = { kind = \"shear\", category = 80 } beside it");
  }
  input.beam.stress_factor = read_stress_factor(table, input.beam.detail);
  input.beam.assumed = table.text({"assumed", "why it is taken so"}, "");
  input.published_step =
      table.choice({"curve", "the standard's, or the thesis' step for comparison"},
                   {"EN 1993-1-9", "published step"}, 0) == 1;
  if (input.published_step && table.problems().empty()) {
    input.beam.detail.curve = published_step(input.beam.detail.curve.reference.value() * 1e-6);
  }
  if (table.has("round_strength_to")) {
    input.round_strength_to = si<Stress>(table.positive(
        {"round_strength_to", "fatigue strengths are rounded to multiples of it, as published"},
        wanted::stress));
  }
  table.has("cycles");  // read with the situations
  input.demand.loading =
      table.choice({"loading", "constant amplitude knows a limit without damage"},
                   {"spectrum", "constant amplitude"}) == 0
          ? Loading::spectrum
          : Loading::constant_amplitude;
  input.demand.gamma_Ff = table.number({"gamma_Ff", "partial factor on the ranges"}, 1.0);
  read_gamma_Mf(table, input);
  input.required =
      table.number({"required", "wanted factor on the ranges, beside the partial factors"});
  input.shear = read_shear_detail(table, {"shear", "of plates under shear"}, 100.0,
                                  "plate under shear (8.1/6)");
  input.throat = read_shear_detail(table, {"throat", "of the throats of seams, shear along them"},
                                   80.0, "throat of a seam (8.5/8)");
  input.corner = read_corner_detail(table);
  input.codes = read_codes(table);
  for (TableReader& detail :
       table.tables({"details", "of stretches of the beam, where they are not as the rest"})) {
    input.details.push_back(read_beam_detail(detail, beam));
  }
  const AttachmentDetails given = read_attachment_details(table);
  if (table.problems().empty()) input.attachments = attachment_welds_of(beam, input.beam, given);
  table.finish();
  return input;
}

void check_net_sections(TableReader& root, const Project& project) {
  if (!root.problems().empty()) return;
  const FatigueInput& fatigue = project.fatigue;
  for (const BeamHole& at : project.holes) {
    if (!at.concentration || at.detail) continue;
    const auto counts_twice = [&](const BeamDetail& of) {
      return of.detail.where == StressPlace::net && at.s >= of.from && at.s <= of.to;
    };
    if (!counts_twice(fatigue.beam) &&
        std::none_of(fatigue.details.begin(), fatigue.details.end(), counts_twice)) {
      continue;
    }
    root.problem("fatigue",
                 fmt::format("a category for the net section contains the concentration at holes, "
                             "and that of hole \"{}\" would count twice",
                             at.hole.name),
                 "give the row to the hole itself, detail = { row = \"8.1/11\" }, without "
                 "\"concentration\"");
    return;
  }
}

}  // namespace boxbeam::readers
