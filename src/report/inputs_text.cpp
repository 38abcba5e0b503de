#include "inputs_text.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

/// An input as the user wrote it: millimetres without trailing zeros.
std::string plain_mm(Length x) { return fmt::format("{:.6g}", x.value() * 1e3); }

std::string profile_text(const Profile& profile) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    return fmt::format("box {} x {}, flanges {}, webs {}", plain_mm(box->width),
                       plain_mm(box->height), plain_mm(box->flange), plain_mm(box->web));
  }
  const auto& tube = std::get<RoundTube>(profile);
  return fmt::format("round {}, wall {}", plain_mm(tube.diameter), plain_mm(tube.wall));
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

std::string line(const std::string& name, const std::string& value) {
  return fmt::format("  {:<10}{}\n", name, value);
}

std::string hole_inputs(const Project& project) {
  std::string out;
  for (std::size_t i = 0; i < project.beam.holes.size(); ++i) {
    const BeamHole& at = project.beam.holes[i];
    const bool webs = at.hole.walls == HoleWalls::webs;
    out +=
        line("hole", fmt::format("{}: {} mm through both {} at s = {:.6g} m, {} {} mm, case \"{}\"",
                                 at.hole.name, plain_mm(at.hole.diameter),
                                 webs ? "webs" : "flanges", at.s.value(), webs ? "z =" : "y = +-",
                                 plain_mm(at.hole.position), to_text(project.hole_cases[i])));
  }
  return out;
}

std::string driver_inputs(const planar::Mechanism& mechanism) {
  constexpr const char* names[] = {"x", "y", "angle"};
  std::string out;
  for (const planar::Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<planar::Driven>(&joint.kind);
    if (driven == nullptr) continue;
    const char* unit = driven->coordinate == planar::Coordinate::angle ? "rad" : "m";
    const HarmonicDriver& law = driven->driver;
    out += line(
        "driver",
        fmt::format("{0}: {1}(t) = {2:.6g} {6} + {3:.6g} {6} sin({4:.6g} rad/s t + {5:.6g} rad)",
                    joint.name, names[static_cast<std::size_t>(driven->coordinate)], law.mean,
                    law.amplitude, law.omega, law.phase, unit));
  }
  return out;
}

}  // namespace

std::string inputs_text(const Project& project) {
  const FatigueInput& fatigue = project.fatigue;
  const Eigen::Vector2d& g = project.mechanism.gravity;
  std::string out = beam_inputs(project.beam) + "\n" + hole_inputs(project);
  out += line(
      "density",
      fmt::format("{:.6g} kg/m^3{}", project.beam.density.value(),
                  project.beam.rotary_inertia ? ", rotary inertia of the sections counted" : ""));
  out += line("gravity", fmt::format("({:.6g}, {:.6g}) m/s^2", g.x(), g.y()));
  out += driver_inputs(project.mechanism);
  out += line("steel", fmt::format("{} ({})", project.material.name, project.material.source));
  out += line("strength", fmt::format("gamma_M0 = {}, required factor {}",
                                      text::significant(project.strength.gamma_M0, 3),
                                      text::significant(project.strength.required, 3)));
  out += line(
      "fatigue",
      fmt::format("category {}, {} cycles, {}, gamma_Ff = {}, gamma_Mf = {}, required factor {}",
                  fatigue.category, text::cycles(fatigue.demand.periods),
                  fatigue.demand.loading == Loading::spectrum ? "spectrum" : "constant amplitude",
                  text::significant(fatigue.demand.gamma_Ff, 3),
                  text::significant(fatigue.demand.gamma_Mf, 3),
                  text::significant(fatigue.required, 3)));
  return out;
}

}  // namespace boxbeam
