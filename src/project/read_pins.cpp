#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "boxbeam/project/detail_reader.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "neighbour_readers.hpp"

namespace boxbeam::readers {
namespace {

/// What resists at the hole of a lug where the case does not say it: no line of it stands above
/// category E of AISC 360, table A-3.1 (base metal at the net section of eyebar heads and pin
/// plates: 56 MPa at 2e6 cycles, threshold 31 MPa, both recalled) of lugs with d_0/w up to 0.5.
Detail lug_detail() {
  Detail detail;
  detail.name = "hole of a lug under a pin (category 100 taken for K_t times the net section)";
  detail.curve = en_1993_1_9_direct(100.0);
  detail.unconfirmed = true;
  return detail;
}

/// The stress at the hole over that of the net section, given or K_t.
double read_lug_factor(TableReader& table, const PinJoint& pin, LugInput& lug) {
  const Key key{"stress_factor",
                "stress at the hole over that of the net section; K_t of a lug under a close pin "
                "where not said"};
  lug.own_factor = table.has_number(key);
  if (lug.own_factor) return table.number(key);
  if (!table.problems().empty()) return 1.0;
  const double x = lug.plate.hole / lug.plate.width;
  constexpr double most_play = 0.02;
  const char* const hint = "write stress_factor, of a calculation or a test";
  if (x > widest_hole) {
    table.problem(
        "width",
        fmt::format("the hole takes {:.3g} of the width: K_t is known up to {}", x, widest_hole),
        hint);
    return 1.0;
  }
  if (pin.hole > (1.0 + most_play) * pin.diameter)
    table.problem("", "the hole is more than 2 % wider than the pin: K_t is that of a close one",
                  hint);
  return lug_concentration(lug.plate);
}

LugInput read_lug(TableReader table, const PinInput& pin) {
  LugInput lug;
  lug.inner = table.choice({"plate", "which of the pin's it is"}, {"inner", "outer"}) == 0;
  lug.plate.thickness = lug.inner ? pin.geometry.inner_plate : pin.geometry.outer_plate;
  lug.yield_strength = lug.inner ? pin.strength.inner_yield : pin.strength.outer_yield;
  lug.plate.hole = pin.geometry.hole;
  lug.plate.width = si<Length>(
      table.positive({"width", "across the force, at the middle of the hole"}, wanted::length));
  const Key end{"end", "from the hole's edge to the end of the plate towards which it is pulled"};
  if (table.has_quantity(end, wanted::length))
    lug.plate.end = si<Length>(table.positive(end, wanted::length));
  if (table.problems().empty() &&
      (lug.plate.width <= 5.0 / 3.0 * lug.plate.hole ||
       (lug.plate.end && *lug.plate.end <= 2.0 / 3.0 * lug.plate.hole))) {
    table.problem("width", "there is so little beside or before the hole that it bears nothing",
                  "EN 1993-1-8, table 3.9: more than d_0/3 beside it, 2 d_0/3 before it");
  }
  const bool own = table.has("row") || table.has("facts") || table.has("category");
  lug.detail.detail = own ? read_detail(table, {lug.plate.thickness}) : lug_detail();
  if (table.problems().empty() && lug.detail.detail.curve.kind == StressKind::shear)
    table.problem("kind", "the detail of a lug is for direct stress", "write category = 100");
  lug.detail.stress_factor = read_lug_factor(table, pin.geometry, lug);
  lug.detail.assumed = table.text({"assumed", "why it is taken so"}, "");
  table.finish();
  return lug;
}

/// Whether the force of a joint in space is that of a pin, across its axis or anywhere.
bool may_have_pin(const spatial::Mechanism& mechanism, int joint) {
  using Kind = spatial::ClosingKind;
  const auto index = static_cast<std::size_t>(joint);
  if (index < mechanism.joints.size())
    return mechanism.joints[index].kind == spatial::JointKind::revolute;
  const Kind kind = mechanism.closing[index - mechanism.joints.size()].kind;
  return kind == Kind::revolute || kind == Kind::cylindrical || kind == Kind::spherical ||
         kind == Kind::distance;
}

/// Whether the force of a joint in the plane is all that it bears: a moment is not judged by a pin.
bool may_have_pin(const planar::Joint& joint) {
  return std::holds_alternative<planar::Pin>(joint.kind) ||
         std::holds_alternative<planar::PinInSlot>(joint.kind) || planar::is_rod(joint);
}

int joint_of_planar_pin(TableReader& table, const Key& key, const planar::Mechanism& mechanism) {
  const int joint = joint_of(table, key, mechanism);
  if (joint < 0) return joint;
  const planar::Joint& of = mechanism.joints[static_cast<std::size_t>(joint)];
  if (!may_have_pin(of))
    table.problem(key.name, fmt::format("\"{}\" does not turn about a pin", of.name),
                  "a pin is in a joint of kind \"pin\", \"pin in slot\" or \"distance\", or at the "
                  "end of a driven length");
  return joint;
}

/// The ball, as it is written, of which a joint is one of the turns; "" of other joints.
std::string ball_of(const spatial::Mechanism& mechanism, int joint) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (!spatial::carrier_of_ball(mechanism, static_cast<int>(i))) continue;
    int turn = static_cast<int>(i);
    for (int k = 0; k < 3; ++k) {
      const spatial::Joint& of = mechanism.joints[static_cast<std::size_t>(turn)];
      if (turn == joint) return of.name.substr(0, of.name.rfind('.'));
      turn = of.parent;
    }
  }
  return "";
}

/// The movement in which the pin of a carrying joint of several is, by its index: the last turn of
/// a ball, the turn of a cylindrical joint.
std::optional<int> movement_with_pin(const spatial::Mechanism& mechanism, const std::string& name) {
  std::vector<int> movements;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (mechanism.joints[i].name == fmt::format("{}.{}", name, movements.size() + 1))
      movements.push_back(static_cast<int>(i));
  }
  if (movements.empty()) return std::nullopt;
  if (spatial::carrier_of_ball(mechanism, movements.back())) return movements.back();
  const auto kind_of = [&](int joint) {
    return mechanism.joints[static_cast<std::size_t>(joint)].kind;
  };
  if (movements.size() == 2 && kind_of(movements[0]) == spatial::JointKind::revolute &&
      kind_of(movements[1]) == spatial::JointKind::prismatic)
    return movements[0];
  return std::nullopt;
}

/// The joint of a pin: in space behind those that carry bodies those that close loops.
int joint_of_pin(TableReader& table, const Project& project) {
  const Key key{"joint", "in which it is"};
  if (!project.in_space) return joint_of_planar_pin(table, key, planar_of(project));
  const spatial::Mechanism& mechanism = spatial_of(project);
  const std::string name = table.text(key);
  if (name.empty()) return 0;
  if (const auto movement = movement_with_pin(mechanism, name)) return *movement;
  std::vector<std::string> names;
  for (const spatial::Joint& joint : mechanism.joints) names.push_back(joint.name);
  for (const spatial::ClosingJoint& joint : mechanism.closing) names.push_back(joint.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    table.problem(key.name, fmt::format("there is no joint \"{}\"", name),
                  unknown_hint(name, names));
    return 0;
  }
  const int joint = static_cast<int>(found - names.begin());
  if (const std::string ball = ball_of(mechanism, joint); !ball.empty())
    table.problem(
        key.name,
        fmt::format("\"{}\" is one of the turns of a ball, which bears a force anywhere", name),
        fmt::format("write joint = \"{}\"", ball));
  else if (!may_have_pin(mechanism, joint))
    table.problem(key.name, fmt::format("joint \"{}\" does not turn about a pin", name),
                  "a pin is in a joint of kind \"revolute\", \"cylindrical\", \"spherical\" or "
                  "\"distance\"; a universal one \"cross\" has two, in \"cross.1\" and "
                  "\"cross.2\"");
  return joint;
}

}  // namespace

PinInput read_pin(TableReader table, const Project& project) {
  PinInput pin;
  pin.name = table.text({"name", "of the pin"});
  pin.joint = joint_of_pin(table, project);
  PinJoint& geometry = pin.geometry;
  geometry.diameter = si<Length>(table.positive({"diameter", "of the pin"}, wanted::length));
  const Key hole{"hole", "of its hole; as wide as the pin where not said"};
  geometry.hole = table.has_quantity(hole, wanted::length)
                      ? si<Length>(table.positive(hole, wanted::length))
                      : geometry.diameter;
  geometry.inner_plate = si<Length>(table.positive({"inner_plate", "thickness"}, wanted::length));
  geometry.outer_plate = si<Length>(table.positive({"outer_plate", "thickness"}, wanted::length));
  geometry.gap = si<Length>(table.not_negative({"gap", "between the plates"}, wanted::length, 0.0));
  if (geometry.hole < geometry.diameter) {
    table.problem("hole", "the pin does not fit its hole", "write its diameter or more");
  }
  PinStrength& strength = pin.strength;
  const Material steel =
      steel_of(table, {"steel", "of the pin; that of the beam where not said"}, project);
  const Material plates =
      steel_of(table, {"plate_steel", "of the plates; that of the beam where not said"}, project);
  strength.pin_yield = strength_at(table, "diameter", steel, yield_strength_of, geometry.diameter);
  strength.pin_tensile =
      strength_at(table, "diameter", steel, tensile_strength_of, geometry.diameter);
  strength.inner_yield =
      strength_at(table, "inner_plate", plates, yield_strength_of, geometry.inner_plate);
  strength.outer_yield =
      strength_at(table, "outer_plate", plates, yield_strength_of, geometry.outer_plate);
  strength.gamma_M0 =
      table.number({"gamma_M0", "on bearing and bending"}, project.strength.gamma_M0);
  strength.gamma_M2 = table.number({"gamma_M2", "on shear"}, project.strength.gamma_M2);
  pin.replaceable = table.boolean({"replaceable",
                                   "to be taken out in service, whose limits it keeps as well, "
                                   "without load factors (3.13.2(3))"},
                                  false);
  pin.required = table.number({"required", "wanted safety factor"}, project.strength.required);
  for (TableReader& of : table.tables(
           {"lugs", "its plates, checked beside and before the hole and there in fatigue"})) {
    LugInput lug = read_lug(of, pin);
    if (std::any_of(pin.lugs.begin(), pin.lugs.end(),
                    [&](const LugInput& other) { return other.inner == lug.inner; }))
      of.problem("plate", "this plate is there already", "write \"inner\" and \"outer\" once each");
    pin.lugs.push_back(std::move(lug));
  }
  table.finish();
  return pin;
}

}  // namespace boxbeam::readers
