#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "blocks.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"

namespace boxbeam::report {
namespace {

using Eigen::Vector3d;
using frame::Structure;

/// "(0, -10)" in the plane, three components in space.
std::string components(const Vector3d& v, bool plane, double unit = 1.0) {
  const auto one = [&](double x) {
    return plain(std::abs(x) <= 1e-12 * v.norm() ? 0.0 : x / unit);
  };
  if (plane) return fmt::format("({}, {})", one(v.x()), one(v.y()));
  return fmt::format("({}, {}, {})", one(v.x()), one(v.y()), one(v.z()));
}

const frame::Member& member_at(const Structure& structure, int member) {
  return structure.members[static_cast<std::size_t>(member)];
}

/// "beam.lug", "beam at s = 1.5 m".
std::string place_text(const Structure& structure, const frame::Place& at) {
  if (at.member == frame::ground) return "the ground";
  const frame::Member& member = member_at(structure, at.member);
  const auto named = std::find_if(member.points.begin(), member.points.end(),
                                  [&](const auto& of) { return (of.p - at.p).norm() < 1e-9; });
  if (named != member.points.end()) return member.name + "." + named->name;
  std::string text = fmt::format("{} at s = {} m", member.name, plain(at.p.x()));
  if (at.p.y() != 0.0) text += fmt::format(", y = {} m", plain(at.p.y()));
  if (at.p.z() != 0.0) text += fmt::format(", z = {} m", plain(at.p.z()));
  return text;
}

std::string stretch_text(const Structure& structure, int member, double from, double to) {
  return fmt::format("{}, s = {} to {} m", member_at(structure, member).name, plain(from),
                     plain(to));
}

/// What an action is, in words.
struct ActionText {
  const Structure& structure;

  std::string operator()(const frame::OwnWeight&) const { return "the weight of all members"; }
  std::string operator()(const frame::PointAction& of) const {
    std::string text = "at " + place_text(structure, of.at);
    if (!of.force.isZero(0.0))
      text += fmt::format(", force {} kN", components(of.force, structure.plane, 1e3));
    if (of.moment.isZero(0.0)) return text;
    if (structure.plane) return text + fmt::format(", couple {} kN m", plain(of.moment.z() / 1e3));
    return text + fmt::format(", couple {} kN m", components(of.moment, false, 1e3));
  }
  std::string operator()(const frame::DrivenAction& of) const {
    return fmt::format("at {}, {} along {}, = {}", place_text(structure, of.at),
                       of.couple ? "couple" : "force", components(of.direction, structure.plane),
                       function_text(of.size, of.couple ? "N m" : "N"));
  }
  std::string operator()(const frame::LineAction& of) const {
    std::string text =
        fmt::format("on {}, {} kN/m", stretch_text(structure, of.member, of.from, of.to),
                    components(of.at_from, structure.plane, 1e3));
    if (of.at_to != of.at_from)
      text += fmt::format(" to {} kN/m", components(of.at_to, structure.plane, 1e3));
    return text;
  }
  std::string operator()(const frame::HeatAction& of) const {
    std::string text =
        fmt::format("{} warmer by {} K", member_at(structure, of.member).name, plain(of.mean));
    if (of.along_z != 0.0) text += fmt::format(", {} K/m towards +z", plain(of.along_z));
    if (of.along_y != 0.0) text += fmt::format(", {} K/m towards +y", plain(of.along_y));
    return text;
  }
  std::string operator()(const frame::Settlement& of) const {
    const frame::Joint& joint = structure.joints[static_cast<std::size_t>(of.joint)];
    std::string text =
        fmt::format("{} shifted by {} mm", joint.name, components(of.shift, structure.plane, 1e-3));
    if (!of.turn.isZero(0.0)) text += fmt::format(", turned by {} rad", components(of.turn, false));
    return text;
  }
  std::string operator()(const frame::Wheels& of) const {
    std::string text =
        fmt::format("{} wheels along {}, at {} m/s:", of.wheels.size(),
                    stretch_text(structure, of.member, of.from, of.to), plain(of.speed));
    for (const frame::Wheels::Wheel& wheel : of.wheels) {
      text += fmt::format(" {} kN", components(wheel.force, structure.plane, 1e3));
      if (wheel.behind != 0.0) text += fmt::format(" {} m behind", plain(wheel.behind));
    }
    return text;
  }
};

std::string holds_text(const frame::Joint& joint, bool plane) {
  constexpr std::array<const char*, 6> names{"1", "2", "3", "about 1", "about 2", "about 3"};
  std::string text;
  for (std::size_t k = 0; k < 6; ++k) {
    if (plane && k != 0 && k != 1 && k != 5) continue;
    const double stiffness = joint.stiffness[k];
    if (stiffness == 0.0) continue;
    if (!text.empty()) text += ", ";
    text += plane && k == 5 ? "turning" : names[k];
    if (!std::isinf(stiffness))
      text += fmt::format(" ({:.4g} {})", stiffness, k < 3 ? "N/m" : "N m/rad");
  }
  return text.empty() ? "nothing" : text;
}

Table members_table(const Structure& structure) {
  Table table = table_of("", {"member", "start [m]", "end [m]", "length [m]", "mass [kg]"});
  for (const frame::Member& member : structure.members) {
    const double length = member.beam.length().value();
    add_row(table,
            row_of(member.name, components(member.start, structure.plane),
                   components(member.start + length * member.axes.col(0), structure.plane),
                   text::significant(length, 5),
                   cell(text::Quantity::mass, mass_properties_of(member.beam).mass.value())));
  }
  return table;
}

Table joints_table(const Structure& structure) {
  Table table = table_of(
      "", {"support or joint", "holds", "against", "along and about its axes", "first axis"});
  for (const frame::Joint& joint : structure.joints) {
    add_row(table, row_of(joint.name, place_text(structure, joint.a),
                          place_text(structure, joint.b), holds_text(joint, structure.plane),
                          components(joint.axes.col(0), structure.plane)));
  }
  return table;
}

class FrameText : public FrontEndText {
 public:
  using FrontEndText::FrontEndText;

  std::string word() const override { return "frame"; }
  std::string heading() const override { return "Frame"; }

  std::string source_of_loads() const override {
    return "the frame at rest: reactions, loads and distributed weight";
  }

  std::string gravity() const override {
    const Structure& of = frame_of(*project_);
    return components(of.gravity, of.plane) + " m/s^2";
  }

  Entries entries() const override {
    const Structure& of = frame_of(*project_);
    Entries entries;
    for (const frame::LoadCase& in : of.cases) {
      for (const frame::Action& action : in.actions) {
        const std::string name =
            action.name == in.name ? in.name : fmt::format("{}, {}", in.name, action.name);
        entries.emplace_back("load", name + ": " + std::visit(ActionText{of}, action.kind));
      }
    }
    return entries;
  }

  void add_remarks(std::vector<std::string>& remarks) const override {
    const Structure& of = frame_of(*project_);
    add_left_out_weight(remarks);
    add_short_ways(remarks);
    const Situation& first = project_->situations.front();
    if (project_->situations.size() == 1 && first.name.empty()) {
      remarks.emplace_back(
          "the case names neither combinations nor situations: all load cases act together, each "
          "with the factor 1.0");
    }
    std::string others;
    std::size_t count = 0;
    for (std::size_t m = 0; m < of.members.size(); ++m) {
      const std::vector<std::string>& beams = project_->beam_names;
      if (static_cast<int>(m) == project_->beam_body ||
          std::find(beams.begin(), beams.end(), of.members[m].name) != beams.end())
        continue;
      others += (others.empty() ? "" : ", ") + of.members[m].name;
      ++count;
    }
    if (others.empty()) return;
    remarks.push_back(fmt::format(
        "of the frame the beam is verified; {} {} elastic and loaded, and nothing is checked in {}",
        others, count > 1 ? "are" : "is", count > 1 ? "them" : "it"));
  }
  using FrontEndText::add_remarks;

  /// Names the situations in which the frame has no weight of its own.
  void add_left_out_weight(std::vector<std::string>& remarks) const {
    std::vector<std::string> without;
    for (const Situation& situation : project_->situations) {
      if (!situation.runs()) continue;
      const Structure& of = frame_in(*project_, situation);
      for (std::size_t k = 0; k < of.cases.size(); ++k) {
        const std::vector<frame::Action>& actions = of.cases[k].actions;
        const bool weight = std::any_of(actions.begin(), actions.end(), [](const auto& action) {
          return std::holds_alternative<frame::OwnWeight>(action.kind);
        });
        if (weight && of.factors[k] == 0.0) without.push_back(situation.name);
      }
    }
    if (without.empty()) return;
    remarks.push_back(fmt::format(
        "the frame's own weight is left out of situation {}: no load case in its \"loads\" has it",
        fmt::join(without, ", ")));
  }

  /// Wheels that do not run over the whole member, as the case asks.
  void add_short_ways(std::vector<std::string>& remarks) const {
    const Structure& of = frame_of(*project_);
    for (const frame::LoadCase& in : of.cases) {
      for (const frame::Action& action : in.actions) {
        const auto* const wheels = std::get_if<frame::Wheels>(&action.kind);
        if (wheels == nullptr) continue;
        const frame::Member& member = member_at(of, wheels->member);
        const double length = member.beam.length().value();
        double least = length, most = 0.0;  // that every wheel reaches
        for (const frame::Wheels::Wheel& wheel : wheels->wheels) {
          most = std::max(most, wheels->from - wheel.behind);
          least = std::min(least, wheels->to - wheel.behind);
        }
        const double near = 1e-9 * length;
        if (most <= near && least >= length - near) continue;
        remarks.push_back(fmt::format(
            "wheels {}: as the case asks, not every wheel runs from 0 to {} m of {}; every one of "
            "them passes {} to {} m",
            action.name, plain(length), member.name, plain(most), plain(least)));
      }
    }
  }

  std::vector<Block> blocks(const Verification& verification) const override {
    const Structure& of = frame_of(*project_);
    const std::vector<std::size_t> shown =
        of.plane ? std::vector<std::size_t>{0, 1, 5} : std::vector<std::size_t>{0, 1, 2, 3, 4, 5};
    Table reactions = reactions_table(
        "What the supports do to the frame, least to largest of all situations; world axes", shown,
        verification.motions);
    if (of.plane) reactions.header.back() = "M [kN m]";
    return {members_table(of), joints_table(of), std::move(reactions)};
  }
};

}  // namespace

std::unique_ptr<const FrontEndText> text_for(const frame::Structure&, const Project& project) {
  return std::make_unique<FrameText>(project);
}

}  // namespace boxbeam::report
