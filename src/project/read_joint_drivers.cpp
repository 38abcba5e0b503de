#include "joint_parts.hpp"

#include <fmt/format.h>

namespace boxbeam::readers {
namespace {

using spatial::ClosingJoint;
using spatial::ClosingKind;
using spatial::Joint;
using spatial::JointKind;
using spatial::Mechanism;

constexpr FunctionOf length{wanted::length, "m", "stroke", "the driver does not move", true};
constexpr FunctionOf angle{wanted::angle, "rad", "angle", "the driver does not move", true};

/// Reads the drivers into joints that carry and cylinders that close.
class JointDrivers {
 public:
  JointDrivers(TableReader& root, Mechanism& mechanism, TimeTables& tables)
      : root_(&root), mechanism_(&mechanism), tables_(&tables) {}

  void read() {
    for (auto& [name, table] :
         root_->table({"drivers", "functions of time, of joints that move"}, false)
             .named_tables()) {
      const std::size_t before = table.problems().size();
      const std::string joint_name = table.text(
          {"joint", "the joint, \"hinge\", or of one with several movements \"ball.1\""});
      if (table.problems().size() != before) continue;
      if (const int index = joint_index(*mechanism_, joint_name); index >= 0)
        read_into(name, table, mechanism_->joints[static_cast<std::size_t>(index)]);
      else if (const int closing = index_by_name(mechanism_->closing, joint_name); closing >= 0)
        read_into(name, table, mechanism_->closing[static_cast<std::size_t>(closing)]);
      else
        say_unknown(table, joint_name);
    }
  }

 private:
  void say_unknown(TableReader& table, const std::string& name) {
    std::vector<std::string> known = names_of(mechanism_->joints);
    for (const std::string& closing : names_of(mechanism_->closing)) known.push_back(closing);
    table.problem("joint", fmt::format("there is no joint \"{}\"", name),
                  unknown_hint(name, known));
  }

  /// Notes a second driver of a joint, and one of a joint that `cannot` move.
  bool may_drive(TableReader& table, const std::string& joint, const std::string& before,
                 const char* cannot) {
    if (cannot == nullptr && before.empty()) return true;
    table.problem(
        "joint",
        fmt::format("joint \"{}\" {}", joint, before.empty() ? cannot : "has a driver already"),
        "one driver for each revolute, prismatic or screw joint, or for the length of a distance");
    return false;
  }

  void read_into(const std::string& name, TableReader& table, Joint& joint) {
    const bool fixed = joint.kind == JointKind::fixed;
    if (!may_drive(table, joint.name, joint.driver_name,
                   fixed ? "is fixed and cannot move" : nullptr)) {
      return;
    }
    // Of several movements some may have drivers, and forces move the others.
    if (joint.moved_by == spatial::MovedBy::forces && joint.name.find('.') == std::string::npos) {
      table.problem("joint", fmt::format("forces move joint \"{}\"", joint.name),
                    "remove moved_by from the joint, or the driver");
      return;
    }
    const bool turns = is_angle(joint.kind);
    joint.moved_by = spatial::MovedBy::driver;
    if (std::optional<Driver> function = read_function(table, turns ? angle : length, *tables_)) {
      joint.driver = std::move(*function);
      joint.driver_name = name;
      table.finish();
    }
  }

  void read_into(const std::string& name, TableReader& table, ClosingJoint& joint) {
    const bool distance = joint.kind == ClosingKind::distance;
    if (!may_drive(table, joint.name, joint.driver_name,
                   distance ? nullptr : "closes a loop and follows it")) {
      return;
    }
    if (std::optional<Driver> function = read_function(table, length, *tables_)) {
      joint.length = std::move(*function);
      joint.driver_name = name;
      table.finish();
    }
  }

  TableReader* root_;
  Mechanism* mechanism_;
  TimeTables* tables_;
};

/// What no driver moves is left to the loops. Notes joints that stand still in a tree without
/// loops, and distances whose length is not said once.
void free_the_rest(TableReader& root, const std::vector<bool>& has_length, Mechanism& mechanism) {
  for (Joint& joint : mechanism.joints) {
    if (!is_driven(joint) || !joint.driver_name.empty()) continue;
    if (!mechanism.closing.empty()) {
      joint.moved_by = spatial::MovedBy::loops;
      continue;
    }
    root.table("joints").problem(
        joint.name.substr(0, joint.name.find('.')),
        fmt::format("nothing drives joint \"{}\"", joint.name),
        fmt::format("write [drivers.<name>] with joint = \"{}\"; where it stands still, kind = "
                    "\"hold\" with its value; moved_by = \"forces\" in the joint where these do",
                    joint.name));
  }
  for (std::size_t i = 0; i < mechanism.closing.size(); ++i) {
    const ClosingJoint& joint = mechanism.closing[i];
    const bool driven = !joint.driver_name.empty();
    if (joint.kind != ClosingKind::distance || has_length[i] != driven) continue;
    root.table("joints").problem(
        joint.name,
        fmt::format("the length of \"{}\" is {}", joint.name, driven ? "said twice" : "not known"),
        driven ? "a rod has a length, a cylinder a driver"
               : fmt::format("write length = \"2 m\", or [drivers.<name>] with joint = \"{}\"",
                             joint.name));
  }
}

}  // namespace

void read_joint_drivers(TableReader& root, const std::vector<bool>& has_length, TimeTables& tables,
                        Mechanism& mechanism) {
  JointDrivers(root, mechanism, tables).read();
  if (root.problems().empty()) free_the_rest(root, has_length, mechanism);
}

}  // namespace boxbeam::readers
