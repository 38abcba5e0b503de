#include "inputs_text.hpp"

#include <fmt/format.h>

#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/report/format.hpp"
#include "chain_text.hpp"
#include "flexible_text.hpp"
#include "function_text.hpp"
#include "mechanism_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

/// An input as the user wrote it: millimetres without trailing zeros.
std::string plain_mm(Length x) { return fmt::format("{:.6g}", x.value() * 1e3); }

std::string text_of(const Box& box) {
  std::string out = fmt::format("box {} x {}", plain_mm(box.width), plain_mm(box.height));
  if (box.top_flange == box.bottom_flange)
    out += fmt::format(", flanges {}", plain_mm(box.top_flange));
  else
    out += fmt::format(", flanges {} (top), {}", plain_mm(box.top_flange),
                       plain_mm(box.bottom_flange));
  if (box.left_web == box.right_web)
    out += fmt::format(", webs {}", plain_mm(box.left_web));
  else
    out += fmt::format(", webs {} (left), {}", plain_mm(box.left_web), plain_mm(box.right_web));
  if (!box.stiffeners.empty()) out += fmt::format(", {} stiffeners", box.stiffeners.size());
  return out;
}

std::string text_of(const RectangularTube& tube) {
  std::string out = fmt::format("rectangular tube {} x {}, wall {}", plain_mm(tube.width),
                                plain_mm(tube.height), plain_mm(tube.wall));
  if (tube.outer_radius.value() > 0.0) {
    out += fmt::format(", radii {}/{}", plain_mm(tube.outer_radius), plain_mm(tube.inner_radius));
  }
  return out;
}

std::string text_of(const RoundTube& tube) {
  return fmt::format("round {}, wall {}", plain_mm(tube.diameter), plain_mm(tube.wall));
}

std::string text_of(const Plate& plate) {
  return fmt::format("plate {} x {}", plain_mm(plate.width), plain_mm(plate.height));
}

std::string text_of(const Polygon& polygon) {
  return fmt::format("polygon of {} corners, {} hollows", polygon.outer.size(),
                     polygon.hollows.size());
}

std::string text_of(const ThinWalled& path) {
  return fmt::format("{} thin walls between {} nodes", path.walls.size(), path.nodes.size());
}

std::string beam_inputs(const TaperedBeam& beam) {
  layout::Table table({"segment", "s [m]", "width x height, plates [mm]", "inside [mm]"});
  const auto row = [&](const std::string& name, Length s, const Section& section) {
    table.row({name, fmt::format("{:.6g}", s.value()), profile_text(section.outer),
               section.inner ? profile_text(*section.inner) : ""});
  };
  for (const Segment& segment : beam.segments) {
    row(segment.name, segment.start, segment.from);
    row("", segment.end(), segment.to);
  }
  return table.text();
}

std::string hole_inputs(const Project& project) {
  std::string out;
  for (std::size_t i = 0; i < project.beam.holes.size(); ++i) {
    const BeamHole& at = project.beam.holes[i];
    const bool webs = at.hole.walls == HoleWalls::webs;
    out += layout::entry(
        "hole", fmt::format("{}: {} mm through both {} at s = {:.6g} m, {} {} mm, case \"{}\"",
                            at.hole.name, plain_mm(at.hole.diameter), webs ? "webs" : "flanges",
                            at.s.value(), webs ? "z =" : "y = +-", plain_mm(at.hole.position),
                            project.hole_inputs[i].concentration
                                ? to_text(*project.hole_inputs[i].concentration)
                                : "net section"));
  }
  return out;
}

std::string place_text(const BeamDetail& detail) {
  std::string where = fmt::format("s = {:.6g}", detail.from.value());
  if (detail.to > detail.from) where += fmt::format(" to {:.6g}", detail.to.value());
  where += " m";
  switch (detail.on) {
    case DetailPlace::section: return where;
    case DetailPlace::fibres: return where + ", fibres";
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
  return part ? "as part of others" : "strength only";
}

std::string situation_text(const Project& project, const Situation& situation) {
  if (situation.name.empty()) return text::cycles(situation.cycles);
  std::string out = situation.name + ": " + count_text(project, situation);
  if (!situation.between.empty()) {
    std::vector<std::string> names;
    for (const std::size_t i : situation.between) names.push_back(project.situations[i].name);
    return out + (situation.in_order
                      ? fmt::format(", one after the other: {}", fmt::join(names, ", "))
                      : fmt::format(", changing between {}", fmt::join(names, " and ")));
  }
  if (situation.load_factor != 1.0) {
    out += fmt::format(", load factor {} on its stresses for strength",
                       text::significant(situation.load_factor, 3));
  }
  if (!situation.set.empty()) out += fmt::format("; {}", fmt::join(situation.set, "; "));
  return out;
}

std::string mechanism_inputs(const Project& project) {
  if (in_space(project)) {
    const spatial::Mechanism& mechanism = spatial_of(project);
    const Eigen::Vector3d& g = mechanism.gravity;
    return layout::entry("gravity", fmt::format("({}, {}, {}) m/s^2", plain(g.x()), plain(g.y()),
                                                plain(g.z()))) +
           chain_inputs(mechanism, project.placement);
  }
  const Eigen::Vector2d& g =
      is_flexible(project) ? flexible_of(project).gravity : planar_of(project).gravity;
  return layout::entry("gravity", fmt::format("({:.6g}, {:.6g}) m/s^2", g.x(), g.y())) +
         (is_flexible(project) ? flexible_inputs(flexible_of(project))
                               : mechanism_text(planar_of(project)));
}

}  // namespace

std::string profile_text(const Profile& profile) {
  return std::visit([](const auto& shape) { return text_of(shape); }, profile);
}

std::string inputs_text(const Project& project) {
  const FatigueInput& fatigue = project.fatigue;
  std::string out = beam_inputs(project.beam) + "\n" + hole_inputs(project);
  out += layout::entry(
      "density",
      fmt::format("{:.6g} kg/m^3{}", project.beam.density.value(),
                  project.beam.rotary_inertia ? ", rotary inertia of the sections counted" : ""));
  out += mechanism_inputs(project);
  for (const InputFile& table : project.tables) {
    out += layout::entry("table", fmt::format("{}, sha256 {}", table.written, table.sha256));
  }
  out += layout::entry("steel",
                       fmt::format("{} ({})", project.material.name, project.material.source));
  out += layout::entry("strength", fmt::format("gamma_M0 = {}, required factor {}",
                                               text::significant(project.strength.gamma_M0, 3),
                                               text::significant(project.strength.required, 3)));
  out += layout::entry(
      "fatigue",
      fmt::format(
          "{}, gamma_Ff = {}, gamma_Mf = {}{}, required factor {}",
          fatigue.demand.loading == Loading::spectrum ? "spectrum" : "constant amplitude",
          text::significant(fatigue.demand.gamma_Ff, 3),
          text::significant(fatigue.demand.gamma_Mf, 3),
          fatigue.gamma_Mf_source.empty() ? "" : fmt::format(" ({})", fatigue.gamma_Mf_source),
          text::significant(fatigue.required, 3)));
  out += layout::entry("detail", detail_text(fatigue.beam, "whole beam"));
  for (const BeamDetail& detail : fatigue.details) {
    out += layout::entry("detail", detail_text(detail, place_text(detail)));
  }
  for (std::size_t i = 0; i < project.hole_inputs.size(); ++i) {
    if (!project.hole_inputs[i].detail) continue;
    out += layout::entry("detail", detail_text(*project.hole_inputs[i].detail,
                                               "hole " + project.beam.holes[i].hole.name));
  }
  for (const Situation& situation : project.situations) {
    out += layout::entry(situation.name.empty() ? "cycles" : "situation",
                         situation_text(project, situation));
  }
  return out;
}

}  // namespace boxbeam
