#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "attachment_places.hpp"
#include "blocks.hpp"
#include "boxbeam/project/detail_catalogue.hpp"
#include "front_end_text.hpp"
#include "profile_text.hpp"

namespace boxbeam::report {
namespace {

Table beam_table(const TaperedBeam& beam) {
  Table table = table_of("", {"segment", "s [m]", "width x height, plates [mm]", "inside [mm]"});
  const auto row = [&](const std::string& name, Length s, const Section& section) {
    add_row(table, row_of(name, cell(fmt::format("{:.6g}", s.value())), profile_text(section.outer),
                          section.inner ? profile_text(*section.inner) : std::string()));
  };
  for (const Segment& segment : beam.segments) {
    row(segment.name, segment.start, segment.from);
    row("", segment.end(), segment.to);
  }
  const bool inside =
      std::any_of(beam.segments.begin(), beam.segments.end(),
                  [](const Segment& segment) { return segment.from.inner || segment.to.inner; });
  if (inside) return table;
  table.header.pop_back();
  for (auto& cells : table.rows) cells.pop_back();
  return table;
}

void add_holes(const Project& project, Entries& entries) {
  for (const BeamHole& at : project.holes) {
    const bool webs = at.hole.walls == HoleWalls::webs;
    entries.emplace_back(
        "hole", fmt::format("{}: {} mm through both {} at s = {:.6g} m, {} {} mm, case \"{}\"",
                            at.hole.name, plain_mm(at.hole.diameter), webs ? "webs" : "flanges",
                            at.s.value(), webs ? "z =" : "y = +-", plain_mm(at.hole.position),
                            at.concentration ? to_text(*at.concentration) : "net section"));
  }
}

/// Those alike in one line.
void add_diaphragms(const Project& project, Entries& entries) {
  std::map<std::pair<double, double>, std::vector<std::string>> alike;
  for (const Diaphragm& of : project.beam.diaphragms)
    alike[{of.thickness.value(), of.opening.value()}].push_back(
        fmt::format("{:.6g}", of.s.value()));
  for (const auto& [sizes, places] : alike) {
    std::string text = fmt::format("{:.6g} mm", 1e3 * sizes.first);
    if (sizes.second > 0.0) text += fmt::format(", access hole {:.6g} mm wide", 1e3 * sizes.second);
    entries.emplace_back("diaphragms",
                         fmt::format("{} at s = {} m", text, fmt::join(places, ", ")));
  }
}

void add_introductions(const Project& project, Entries& entries) {
  for (const LoadIntroduction& of : project.beam.introductions) {
    std::string where = fmt::format("s = {:.6g}", of.from.value());
    if (of.to > of.from) where += fmt::format(" to {:.6g}", of.to.value());
    entries.emplace_back(
        "forces come in",
        fmt::format("{} m: {}", where,
                    of.stiff_length ? fmt::format("through a flange, over a stiff length of "
                                                  "{:.6g} mm",
                                                  1e3 * of.stiff_length->value())
                                    : std::string("into the webs over their depth")));
  }
}

std::string place_text(const BeamDetail& detail) {
  std::string where = fmt::format("s = {:.6g}", detail.from.value());
  if (detail.to > detail.from) where += fmt::format(" to {:.6g}", detail.to.value());
  where += " m";
  switch (detail.on) {
    case DetailPlace::section: return where;
    case DetailPlace::fibres: return where + ", fibres";
    case DetailPlace::webs: return where + ", webs";
    case DetailPlace::seams: return where + ", seams";
  }
  return where;
}

/// A detail, what it can be and what would raise it.
std::string detail_text(const BeamDetail& of, const std::string& where) {
  constexpr std::size_t most_raises = 2;
  const Detail& detail = of.detail;
  std::string out = fmt::format("{}: category {}", where, detail.curve.name);
  if (!detail.row.empty()) {
    out += fmt::format(", {} (EN 1993-1-9 table {}, row {})", detail.name,
                       detail.row.substr(0, detail.row.find('/')),
                       detail.row.substr(detail.row.find('/') + 1));
  } else if (detail.name != "category " + detail.curve.name) {
    out += ", " + detail.name;
  }
  if (detail.where == StressPlace::net) out += ", stress of the net section";
  if (detail.size_factor != 1.0) {
    out += fmt::format(", k_s = {}", text::significant(detail.size_factor));
  }
  if (of.stress_factor != 1.0) {
    out += fmt::format(", stress factor {}", text::significant(of.stress_factor, 4));
  }
  if (detail.compression_reduced) out += ", compression counts 60 %";
  if (!of.assumed.empty()) out += ", ASSUMED";
  if (detail.unconfirmed) out += ", UNCONFIRMED";
  // Without it the category does not hold: column "requirements" of the tables.
  if (!detail.candidates.empty() && !detail.candidates.front().workmanship.empty())
    out += "; its category asks for: " + detail.candidates.front().workmanship;
  for (std::size_t i = 0; i < std::min(most_raises, detail.raises.size()); ++i) {
    out += fmt::format("; raised by {}", to_text(detail.raises[i]));
  }
  return out;
}

/// How often a situation happens.
std::string count_text(const Project& project, const Situation& situation) {
  if (situation.cycles > 0.0) return text::cycles(situation.cycles) + " cycles";
  const auto index = static_cast<std::size_t>(&situation - project.situations.data());
  const bool part = std::any_of(
      project.situations.begin(), project.situations.end(), [&](const Situation& other) {
        return std::find(other.between.begin(), other.between.end(), index) != other.between.end();
      });
  if (part) return "as part of others";
  return situation.load_factor == 0.0 ? "deflection only" : "strength only";
}

/// ": 2e4 of the whole change, 1e5 of 80 %".
std::string spectrum_text(const Situation& situation) {
  if (situation.spectrum.empty()) return "";
  std::vector<std::string> levels;
  for (const SpectrumLevel& level : situation.spectrum) {
    levels.push_back(
        level.share == 1.0
            ? text::cycles(level.cycles) + " of the whole change"
            : fmt::format("{} of {:.4g} % of it", text::cycles(level.cycles), 100.0 * level.share));
  }
  return fmt::format(": {}", fmt::join(levels, ", "));
}

std::string situation_text(const Project& project, const Situation& situation) {
  if (situation.name.empty()) return text::cycles(situation.cycles);
  std::string out = situation.name + ": " + count_text(project, situation);
  if (!situation.between.empty()) {
    std::vector<std::string> names;
    for (const std::size_t i : situation.between) names.push_back(project.situations[i].name);
    out += situation.in_order ? fmt::format(", one after the other: {}", fmt::join(names, ", "))
                              : fmt::format(", changing between {}", fmt::join(names, " and "));
    return out + spectrum_text(situation);
  }
  if (situation.load_factor != 1.0 && situation.load_factor != 0.0) {
    out += fmt::format(", load factor {} on its stresses for strength",
                       text::significant(situation.load_factor, 3));
  }
  if (!situation.set.empty()) out += fmt::format("; {}", fmt::join(situation.set, "; "));
  return out;
}

void add_mechanism(const Project& project, Entries& entries) {
  const std::unique_ptr<const FrontEndText> text = front_end_text_of(project);
  entries.emplace_back("gravity", text->gravity());
  for (auto& entry : text->entries()) entries.push_back(std::move(entry));
}

void add_fatigue(const Project& project, Entries& entries) {
  const FatigueInput& fatigue = project.fatigue;
  entries.emplace_back(
      "fatigue",
      fmt::format("{}, gamma_Ff = {}, gamma_Mf = {}{}, required factor {}",
                  fatigue.demand.loading == Loading::spectrum ? "spectrum" : "constant amplitude",
                  text::factor(fatigue.demand.gamma_Ff), text::factor(fatigue.demand.gamma_Mf),
                  in_brackets(fatigue.gamma_Mf_source), text::factor(fatigue.required)));
  entries.emplace_back("detail", detail_text(fatigue.beam, "whole beam"));
  for (const BeamDetail& detail : fatigue.details) {
    entries.emplace_back("detail", detail_text(detail, place_text(detail)));
  }
  for (const AlikeWelds& of : alike_welds_of(fatigue))
    entries.emplace_back("detail", detail_text(*of.detail, of.where));
  for (const BeamHole& at : project.holes) {
    if (at.detail) entries.emplace_back("detail", detail_text(*at.detail, "hole " + at.hole.name));
  }
}

/// "S460 (EN 10025-3) of top flange, bottom flange in segments 2, 3".
std::string part_text(const Project& project, const PartMaterial& part) {
  std::vector<std::string> plates, segments;
  for (std::size_t kind = 0; kind < plate_kinds; ++kind) {
    if (part.plates[kind]) plates.push_back(plate_kind_names()[kind]);
  }
  for (std::size_t i = 0; i < part.segments.size(); ++i) {
    if (part.segments[i]) segments.push_back(project.beam.segments[i].name);
  }
  const bool whole = plates.size() == plate_kinds;
  const bool everywhere = segments.size() == part.segments.size();
  return fmt::format("{} ({}), {}{}", part.material.name, part.material.source,
                     whole ? "all plates" : fmt::format("{}", fmt::join(plates, ", ")),
                     everywhere ? ""
                                : fmt::format(" of segment{} {}", segments.size() > 1 ? "s" : "",
                                              fmt::join(segments, ", ")));
}

void add_demands(const Project& project, Entries& entries) {
  const FatigueInput& fatigue = project.fatigue;
  entries.emplace_back("steel",
                       fmt::format("{} ({})", project.material.name, project.material.source));
  for (const PartMaterial& part : project.part_materials)
    entries.emplace_back("steel", part_text(project, part));
  entries.emplace_back("strength", fmt::format("gamma_M0 = {}, required factor {}",
                                               text::factor(project.strength.gamma_M0),
                                               text::factor(project.strength.required)));
  if (fatigue.asked) {
    add_fatigue(project, entries);
  } else {
    entries.emplace_back("fatigue", "not asked for: strength only");
  }
  for (const Situation& situation : project.situations) {
    if (situation.name.empty() && !fatigue.asked) continue;
    entries.emplace_back(situation.name.empty() ? "cycles" : "situation",
                         situation_text(project, situation));
  }
}

}  // namespace

Chapter inputs_chapter(const Source& source) {
  if (source.level == ReportLevel::summary) return {"Inputs", {}};
  const Project& project = source.project;
  Entries beam, mechanism, demands;
  add_holes(project, beam);
  add_diaphragms(project, beam);
  add_introductions(project, beam);
  beam.emplace_back(
      "density",
      fmt::format("{:.6g} kg/m^3{}", project.beam.density.value(),
                  project.beam.rotary_inertia ? ", rotary inertia of the sections counted" : ""));
  add_mechanism(project, mechanism);
  for (const InputFile& table : project.tables) {
    mechanism.emplace_back("table", fmt::format("{}, sha256 {}", table.written, table.sha256));
  }
  add_demands(project, demands);
  return {"Inputs",
          {Subheading{"Beam"}, beam_table(project.beam), Facts{std::move(beam)},
           Subheading{front_end_text_of(project)->inputs_heading()}, Facts{std::move(mechanism)},
           Subheading{"Demands"}, Facts{std::move(demands)}}};
}

}  // namespace boxbeam::report
