#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blocks.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"

namespace boxbeam::report {
namespace {

using flexible::Mechanism;

const char* kind_text(flexible::LinkKind kind) {
  switch (kind) {
    case flexible::LinkKind::rigid: return "rigid";
    case flexible::LinkKind::bending: return "bending";
    case flexible::LinkKind::axial: return "axial";
    case flexible::LinkKind::full: return "full";
  }
  return "";
}

const char* element_text(flexible::Element element) {
  switch (element) {
    case flexible::Element::classical: return "classical rigid finite elements";
    case flexible::Element::corrected: return "corrected rigid finite elements";
    case flexible::Element::exact: return "continuous links between nodes (exact form)";
  }
  return "";
}

std::string angle_text(double angle) {
  return text::significant(angle * 180.0 / std::numbers::pi, 5);
}

/// "boom at (1.5, -0.15) m".
std::string place_text(const Mechanism& mechanism, const flexible::Attachment& at) {
  if (at.link == flexible::ground) return "the ground";
  const flexible::Link& link = mechanism.links[static_cast<std::size_t>(at.link)];
  const auto named = std::find_if(link.points.begin(), link.points.end(), [&](const auto& point) {
    return (point.p - at.p).norm() < 1e-9;
  });
  if (named != link.points.end()) return link.name + "." + named->name;
  return fmt::format("{} at ({}, {}) m", link.name, plain(at.p.x()), plain(at.p.y()));
}

std::string stiffness_text(double stiffness) {
  if (stiffness == 0.0) return "-";
  if (std::isinf(stiffness)) return "rigid";
  return fmt::format("{:.4g}", stiffness);
}

Table links_table(const Mechanism& mechanism) {
  Table table = table_of("", {"link", "kind", "origin [m]", "angle [deg]", "length [m]", "parts",
                              "mass [kg]", "EA [N]", "GA [N]", "EI [N m^2]"});
  for (const flexible::Link& link : mechanism.links) {
    const bool rigid = link.kind == flexible::LinkKind::rigid;
    const bool bends =
        link.kind == flexible::LinkKind::bending || link.kind == flexible::LinkKind::full;
    // Of a tapered link at its start.
    const auto at_start = [&](const auto& of, bool counts) {
      return counts ? fmt::format("{:.4g}", of.c[0]) : std::string("rigid");
    };
    std::vector<Cell> row =
        row_of(link.name, kind_text(link.kind),
               fmt::format("({}, {})", plain(link.origin.x()), plain(link.origin.y())),
               angle_text(link.angle),
               link.length > 0.0 ? text::significant(link.length, 5) : std::string("-"),
               rigid ? std::string("-") : fmt::format("{}", link.parts),
               cell(text::Quantity::mass, flexible::rigid_mass_of(link).mass));
    if (rigid) {
      row.insert(row.end(), 3, cell("rigid"));
    } else {
      const flexible::LinkStretch& first = link.stretches.front();
      row.push_back(cell(at_start(first.EA, link.kind != flexible::LinkKind::bending)));
      row.push_back(cell(at_start(first.GA, bends)));
      row.push_back(cell(at_start(first.EI, bends)));
    }
    add_row(table, std::move(row));
  }
  return table;
}

Table joints_table(const Mechanism& mechanism) {
  Table table = table_of("", {"joint", "connects", "with", "first axis [deg]", "along [N/m]",
                              "across [N/m]", "turning [N m/rad]"});
  for (const flexible::Joint& joint : mechanism.joints) {
    add_row(table,
            row_of(joint.name, place_text(mechanism, joint.a), place_text(mechanism, joint.b),
                   angle_text(joint.angle), stiffness_text(joint.stiffness[0]),
                   stiffness_text(joint.stiffness[1]), stiffness_text(joint.stiffness[2])));
  }
  return table;
}

std::string load_text(const Mechanism& mechanism, const flexible::Load& load) {
  const auto triple = [](const Eigen::Vector3d& v) {
    return fmt::format("force ({}, {}) N, couple {} N m", plain(v.x()), plain(v.y()), plain(v.z()));
  };
  std::string out = fmt::format("{}: on {}, constant {}", load.name, place_text(mechanism, load.at),
                                triple(load.constant));
  if (load.amplitude.isZero(0.0)) return out;
  out += fmt::format("; with sin(2 pi {} Hz t{}) {}", plain(mechanism.frequency),
                     load.phase == 0.0 ? "" : fmt::format(" + {} rad", plain(load.phase)),
                     triple(load.amplitude));
  return out;
}

/// "round-off" beside a value, or its size.
std::string error_text(double error, double size) {
  return error <= 1e-9 * size ? "round-off" : fmt::format("{:.1e}", error);
}

/// What every joint does, static and vibrating.
Table joint_forces_table(const FlexibleMotionResult& motion) {
  double size = 0.0;
  for (const JointVibration& joint : motion.joints) {
    size = std::max({size, joint.force.magnitude, joint.force.largest});
  }
  const bool vibrates = motion.frequency > 0.0;
  Table table =
      table_of(fmt::format("What a joint does to the link that is named; world axes{}",
                           vibrates ? "; largest: length of the vibrating force" : ""),
               {"joint", "on", "static F_x [kN]", "F_y [kN]", "length [kN]", "stated error [N]"});
  if (vibrates) {
    table.header.push_back(fmt::format("at {} Hz, largest [kN]", plain(motion.frequency)));
    table.header.emplace_back("stated error [N]");
  }
  const auto kN = [&](double newtons) {
    return cell(text::Quantity::force, newtons, 1e-12 * size);
  };
  for (const JointVibration& joint : motion.joints) {
    const Vibration<3>& force = joint.force;
    std::vector<Cell> row =
        row_of(joint.name, joint.on, kN(force.constant.x()), kN(force.constant.y()),
               kN(force.magnitude), error_text(force.constant_error.error, size));
    if (vibrates) {
      row.push_back(kN(force.largest));
      row.push_back(cell(error_text(force.amplitude_error.error, size)));
    }
    add_row(table, std::move(row));
  }
  return table;
}

Entries entries_of(const Mechanism& mechanism) {
  Entries entries;
  entries.emplace_back("division",
                       fmt::format("{}, {}", element_text(mechanism.element),
                                   mechanism.nodes_at_joints ? "nodes at joints and loads"
                                                             : "parts of a link all equal"));
  for (const flexible::Load& load : mechanism.loads) {
    entries.emplace_back("load", load_text(mechanism, load));
  }
  return entries;
}

std::vector<Block> blocks_of(const Mechanism& mechanism, const ElasticModel& model) {
  std::string taken;
  if (model.level == ModelLevel::rigid) taken += ", elastic links as rigid ones";
  if (model.parts > 0)
    taken += fmt::format(", at least {} parts of every elastic link", model.parts);
  if (model.axial) taken += ", bending links elastic along their axes as well";
  std::vector<Block> blocks{links_table(mechanism), joints_table(mechanism)};
  if (!taken.empty()) {
    blocks.emplace_back(Paragraph{fmt::format(
        "Links and joints as the case gives them. The model takes: {}.", taken.substr(2))});
  }
  return blocks;
}

class FlexibleText : public FrontEndText {
 public:
  using FrontEndText::FrontEndText;

  std::string gravity() const override {
    const Eigen::Vector2d& g = flexible_of(*project_).gravity;
    return fmt::format("({:.6g}, {:.6g}) m/s^2", g.x(), g.y());
  }

  Entries entries() const override { return entries_of(flexible_of(*project_)); }

  std::vector<Block> blocks(const Verification& verification) const override {
    return blocks_of(flexible_of(*project_), verification.model.chosen);
  }
};

}  // namespace

std::unique_ptr<const FrontEndText> text_for(const flexible::Mechanism&, const Project& project) {
  return std::make_unique<FlexibleText>(project);
}

std::vector<Block> vibration_blocks(const Source& source) {
  const FlexibleMotionResult& motion = source.verification.pictures.elastic->motion;
  const bool exact = flexible_of(source.project).element == flexible::Element::exact;
  std::vector<Block> blocks;
  blocks.emplace_back(Subheading{"Natural frequencies and joint forces"});
  blocks.emplace_back(Paragraph{fmt::format(
      "By all of {} {} with {} generalised coordinates, as many parts of every "
      "link as the case says or the chosen model has, whichever is more. The loads on the beam "
      "and all checks come from the chosen model itself: {}. Stated errors are those of the "
      "division of the links, with a margin; they say nothing of the data.",
      motion.elements, exact ? "nodes of continuous links" : "rigid finite elements",
      motion.degrees_of_freedom, describe(source.verification.model.chosen))});
  Table frequencies = table_of("", {"mode", "frequency [Hz]", "stated error [Hz]"});
  for (std::size_t i = 0; i < motion.frequencies.size(); ++i) {
    const NaturalFrequency& of = motion.frequencies[i];
    add_row(frequencies, row_of(fmt::format("{}", i + 1), cell(fmt::format("{:.5g}", of.frequency)),
                                error_text(of.error.error, of.frequency)));
  }
  blocks.emplace_back(std::move(frequencies));
  blocks.emplace_back(joint_forces_table(motion));
  return blocks;
}

}  // namespace boxbeam::report
