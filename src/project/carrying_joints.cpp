#include "joint_parts.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace boxbeam::readers {
namespace {

using spatial::ClosingKind;
using spatial::JointKind;
using spatial::Mechanism;

/// Values of the movements of a joint, of turns by one key and of shifts by another where it has
/// several; zero where they are not said.
std::vector<double> read_values(TableReader& table, const std::vector<Movement>& movements,
                                const Key& of_one, const Key& of_shifts,
                                const WantedDimension& of_turn, const WantedDimension& of_shift) {
  const auto is_turn = [](const Movement& movement) { return is_angle(movement.kind); };
  std::vector<double> values(movements.size(), 0.0);
  if (movements.size() == 1) {
    if (movements[0].kind == JointKind::fixed) return values;
    values[0] = table.quantity(of_one, is_turn(movements[0]) ? of_turn : of_shift, 0.0);
    return values;
  }
  const auto read_list = [&](const Key& key, bool turns, const WantedDimension& dimension) {
    const auto count = static_cast<std::size_t>(
        std::count_if(movements.begin(), movements.end(),
                      [&](const Movement& m) { return is_turn(m) == turns; }));
    if (count == 0 || !table.has(key)) return;
    const std::vector<double> given = table.quantities(key, dimension);
    if (given.size() != count) {
      table.problem(key.name, fmt::format("\"{}\" wants {} values", key.name, count),
                    fmt::format("one for each of its {}", turns ? "turns" : "shifts"));
      return;
    }
    auto next = given.begin();
    for (std::size_t k = 0; k < movements.size(); ++k)
      if (is_turn(movements[k]) == turns) values[k] = *next++;
  };
  read_list(of_one, true, of_turn);
  read_list(of_shifts, false, of_shift);
  return values;
}

}  // namespace

std::vector<Movement> movements_of(std::size_t kind, const std::vector<Eigen::Vector3d>& axes) {
  const auto turn = [](const Eigen::Vector3d& axis) { return Movement{JointKind::revolute, axis}; };
  const auto shift = [](const Eigen::Vector3d& axis) {
    return Movement{JointKind::prismatic, axis};
  };
  std::vector<Movement> movements;
  if (kind == free_body) {
    for (int k = 0; k < 3; ++k) movements.push_back(shift(Eigen::Vector3d::Unit(k)));
    for (const Eigen::Vector3d& axis : axes) movements.push_back(turn(axis));
    return movements;
  }
  switch (static_cast<ClosingKind>(kind)) {
    case ClosingKind::fixed: return {{JointKind::fixed, Eigen::Vector3d::UnitZ()}};
    case ClosingKind::revolute: return {turn(axes[0])};
    case ClosingKind::prismatic: return {shift(axes[0])};
    case ClosingKind::cylindrical: return {turn(axes[0]), shift(axes[0])};
    case ClosingKind::universal:
    case ClosingKind::spherical: break;
    case ClosingKind::planar: {
      const Eigen::Vector3d u = axes[0].unitOrthogonal();
      return {shift(u), shift(axes[0].cross(u)), turn(axes[0])};
    }
    case ClosingKind::screw: return {{JointKind::screw, axes[0]}};
    case ClosingKind::slot:
    case ClosingKind::distance:
    case ClosingKind::gear:
    case ClosingKind::rack: return {};
  }
  for (const Eigen::Vector3d& axis : axes) movements.push_back(turn(axis));
  return movements;
}

void add_carrying(TableReader& table, const JointDraft& whole,
                  const std::vector<Movement>& movements, Mechanism& mechanism,
                  std::vector<JointDraft>& drafts) {
  const bool moves = movements.front().kind != JointKind::fixed;
  const bool forced =
      moves && table.choice({"moved_by",
                             "what moves it where no driver does; without loops drivers "
                             "alone, but where forces are said to"},
                            {"drivers and loops", "forces"}, 0) == 1;
  const std::vector<double> starts =
      read_values(table, movements,
                  {"start",
                   "near which it is sought at t = 0 where no driver moves it; where forces do, "
                   "its place at t = "
                   "0; of several turns one after the other"},
                  {"start_shift", "the same of its shifts"}, wanted::angle, wanted::length);
  const std::vector<double> rates = read_values(
      table, movements, {"start_rate", "at t = 0 where forces move it; of several turns as start"},
      {"start_shift_rate", "the same of its shifts"}, wanted::angular_velocity, wanted::velocity);
  if (!forced && std::any_of(rates.begin(), rates.end(), [](double rate) { return rate != 0.0; })) {
    table.problem("start_rate", "rates at the start are those of what forces move",
                  "write moved_by = \"forces\", or leave them out");
  }
  const std::string name = whole.joint.name;
  JointDraft draft = whole;
  for (std::size_t k = 0; k < movements.size(); ++k) {
    const bool last = k + 1 == movements.size();
    if (movements.size() > 1) draft.joint.name = fmt::format("{}.{}", name, k + 1);
    draft.joint.kind = movements[k].kind;
    // Written in the axes of the carried body where it stands at zero.
    draft.joint.axis = draft.joint.turn * movements[k].axis;
    draft.joint.start = starts[k];
    draft.joint.start_rate = rates[k];
    draft.joint.friction =
        movements[k].kind == JointKind::prismatic ? whole.joint.friction : Friction{};
    draft.joint.moved_by = forced ? spatial::MovedBy::forces : spatial::MovedBy::driver;
    draft.joint.point = last ? whole.joint.point : Eigen::Vector3d::Zero().eval();
    draft.carried = last ? whole.carried : static_cast<int>(mechanism.bodies.size());
    if (!last) mechanism.bodies.emplace_back().name = draft.joint.name;
    drafts.push_back(draft);
    draft.joint.parent = draft.carried;
    draft.joint.at.setZero();
    draft.joint.turn.setIdentity();
  }
}

}  // namespace boxbeam::readers
