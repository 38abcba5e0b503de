#include "beam_holds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

/// Stretches of a beam that bends in a plane.
std::vector<flexible::LinkStretch> stretches_in(const Project& project, Plane plane) {
  const double E = project.model.youngs_modulus;
  std::vector<flexible::LinkStretch> stretches =
      link_stretches_of(project.beam, E, project.model.shear_modulus);
  if (plane == Plane::z) return stretches;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Segment& segment = project.beam.segments[i];
    const double length = segment.length.value();
    stretches[i].EI = interpolate<4>(
        [&](double x) {
          const SectionProperties of =
              properties_of(interpolate(segment.from, segment.to, x / length));
          const double I_yz = of.I_yz.value();
          return E * (of.I_z.value() - I_yz * I_yz / of.I_y.value());
        },
        length);
    // Shear across a box bends its flanges as it does its webs: of little effect, and left out.
    for (double& c : stretches[i].GA.c) c = 0.0;
    stretches[i].GA.c[0] = 1e6 * stretches[i].EA(0.5 * length);
  }
  return stretches;
}

/// The two outermost of some places, or one clamp where they are too near each other to hold.
std::vector<Hold> outermost(const std::vector<double>& places, double length) {
  if (places.empty()) return {{0.0, true}};
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  constexpr double near = 0.02;
  if (*high - *low < near * length) return {{*low, true}};
  return {{*low, false}, {*high, false}};
}

/// "0 m, 2 m and 4 m"
std::string places_text(const std::vector<double>& at) {
  std::string text;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (i > 0) text += i + 1 == at.size() ? " and " : ", ";
    // Without what is below a tenth of a millimetre, and the sign of a zero.
    text += fmt::format("{:.3g} m", 1e-4 * std::round(1e4 * at[i]) + 0.0);
  }
  return text;
}

std::string words_of(const std::vector<Hold>& holds) {
  std::vector<double> clamps, pins;
  for (const Hold& hold : holds) (hold.clamped ? clamps : pins).push_back(hold.s);
  if (clamps.empty()) return "pinned at s = " + places_text(pins);
  const std::string clamped = "clamped at s = " + places_text(clamps);
  if (!pins.empty()) return clamped + ", pinned at s = " + places_text(pins);
  return clamps.size() == 1 ? clamped + " and free elsewhere" : clamped;
}

HeldAt<std::vector<Hold>> said_in(const Project& project, bool Restraint::*way) {
  HeldAt<std::vector<Hold>> held;
  for (const Restraint& restraint : project.restraints)
    if (restraint.*way) held.at.push_back({restraint.s.value(), restraint.clamped});
  held.said = !held.at.empty();
  held.words = words_of(held.at) + ", as the case says";
  return held;
}

}  // namespace

BeamHolds holds_of(const Project& project, const std::vector<double>& supports) {
  const std::vector<Hold> carried = outermost(supports, project.beam.length().value());
  const auto along = [&](bool Restraint::*way) {
    HeldAt<std::vector<Hold>> said = said_in(project, way);
    return said.said ? said : HeldAt<std::vector<Hold>>{carried, words_of(carried), false};
  };
  BeamHolds holds{along(&Restraint::along_z), along(&Restraint::along_y), {}};
  HeldAt<std::vector<double>>& turning = holds.turning;
  for (const Restraint& restraint : project.restraints)
    if (restraint.turning) turning.at.push_back(restraint.s.value());
  turning.said = !turning.at.empty();
  if (turning.said) {
    turning.words =
        fmt::format("held against turning at s = {}, as the case says", places_text(turning.at));
  } else {
    for (const Hold& hold : carried) turning.at.push_back(hold.s);
    turning.words = words_of(carried) + " sideways and against turning";
  }
  return holds;
}

flexible::Mechanism beam_alone(const Project& project, Plane plane,
                               const std::vector<Hold>& holds) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  constexpr std::size_t parts_of_span = 16;
  flexible::Mechanism mechanism;
  flexible::Link& link = mechanism.links.emplace_back();
  link.name = "beam";
  link.length = project.beam.length().value();
  link.stretches = stretches_in(project, plane);
  for (flexible::LinkStretch& of : link.stretches) {  // nothing moves: no mass counts
    of.mass = {};
    of.rotary = {};
  }
  // As many spans as there are between the holds at least, each may buckle by itself.
  link.parts = static_cast<int>(parts_of_span * std::max<std::size_t>(1, holds.size() - 1));
  for (const Hold& hold : holds) {
    flexible::Joint& joint = mechanism.joints.emplace_back();
    joint.name = "support";
    joint.a = {0, {hold.s, 0.0}};
    joint.b = {flexible::ground, {hold.s, 0.0}};
    const bool first = mechanism.joints.size() == 1;
    joint.stiffness = {first ? rigid : 0.0, rigid, hold.clamped ? rigid : 0.0};
  }
  return mechanism;
}

}  // namespace boxbeam
