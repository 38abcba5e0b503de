#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "read_elasticity.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Mechanism;

/// A point and the line that it stays on.
struct Guided {
  Attachment point, guide;
  double direction = 0.0;
};

/// The point of a guide: on the ground ("through"), or on a body ("guide").
Attachment read_guide(TableReader& table, const char* what, const Mechanism& mechanism) {
  if (!table.says_one_of({{{"through"}}, {{"guide"}}})) {
    table.problem("", fmt::format("{} wants either \"through\" or \"guide\"", what),
                  "through = [x, y] for a line on the ground, guide = \"body.point\" for one on "
                  "a body, which moves with it");
    return {};
  }
  if (table.has("through"))
    return {planar::ground,
            table.pair({"through", "a line on the ground goes through it"}, wanted::length)};
  if (table.text("guide") == "ground") {
    table.problem("guide", "a line on the ground is given by a point that it goes through",
                  "write through = [x, y] instead");
    return {};
  }
  return attachment_of(
      table, {"guide", "the line moves with this body: one of its points, \"body.point\""},
      mechanism);
}

Guided read_guided(TableReader& table, const char* what, const Mechanism& mechanism) {
  Guided guided;
  guided.point =
      place_of(table, {"point", "what slides, \"body.point\", or \"ground\""}, mechanism);
  const std::size_t before = table.problems().size();
  guided.guide = read_guide(table, what, mechanism);
  guided.direction = table.quantity({"direction", "of the line"}, wanted::angle);
  const bool point_known = guided.point.body >= 0 || table.text("point") == "ground";
  if (table.problems().size() == before && point_known && guided.point.body == guided.guide.body) {
    table.problem("point",
                  fmt::format("{} connects two different bodies, or a body and the ground", what),
                  "the line is on another body than the point: write guide = \"body.point\", or "
                  "through = [x, y] for the ground");
  }
  return guided;
}

planar::Slider read_slider(TableReader& table, const Mechanism& mechanism) {
  const Guided guided = read_guided(table, "a slider", mechanism);
  const double angle = table.quantity({"angle", "of the body to the line"}, wanted::angle, 0.0);
  return {guided.point, guided.guide, guided.direction, angle, read_friction(table)};
}

planar::PinInSlot read_pin_in_slot(TableReader& table, const Mechanism& mechanism) {
  const Guided guided = read_guided(table, "a pin in a slot", mechanism);
  return {guided.point, guided.guide, guided.direction, read_friction(table)};
}

planar::Pin read_pin(TableReader& table, const Mechanism& mechanism) {
  const auto [a, b] = ends_in(
      table, {{"connect", "two points, \"body.point\", or \"ground\" for one of them"}, "a pin"},
      mechanism);
  return {a, b};
}

planar::Rigid read_rigid(TableReader& table, const Mechanism& mechanism) {
  const auto [a, b] = ends_in(
      table,
      {{"connect", "two points, \"body.point\", or \"ground\" for one of them"}, "a rigid joint"},
      mechanism);
  return {a, b, table.quantity({"angle", "between the bodies"}, wanted::angle, 0.0)};
}

planar::Distance read_distance(TableReader& table, const Mechanism& mechanism) {
  const auto [a, b] = ends_in(
      table,
      {{"connect", "two points, \"body.point\", or \"ground\" for one of them"}, "a distance"},
      mechanism);
  return {a, b, table.positive({"length", "between them"}, wanted::length)};
}

planar::AngleCoupling read_coupling(TableReader& table, const Mechanism& mechanism) {
  const auto [a, b] =
      ends_in(table,
              {{"points", "the two bodies, \"body.point\", or \"ground\" for one of them"},
               "a coupling",
               false},
              mechanism);
  const double ratio =
      table.any_number({"ratio", "turn of the second over that of the first"}, 1.0);
  if (ratio == 0.0) {
    table.problem("ratio", "\"ratio\" must not be zero",
                  "write for example ratio = -0.5; to fix an angle use a slider or a rigid joint");
  }
  return {a, b, ratio, table.quantity({"offset", "of the second"}, wanted::angle, 0.0)};
}

planar::Gear read_gear(TableReader& table, const Mechanism& mechanism) {
  planar::Gear gear;
  std::tie(gear.a, gear.b) =
      ends_in(table,
              {{"connect", "centres of the wheels, \"body.point\", or \"ground\" for one of them"},
               "a gear"},
              mechanism);
  gear.offset =
      table.quantity({"offset", "of the contact, along the pitch circle"}, wanted::length, 0.0);
  const std::size_t before = table.problems().size();
  const std::vector<double> radii = table.quantities(
      {"radii", "of the wheels in their order; an annulus is negative"}, wanted::length);
  if (table.problems().size() != before) return gear;
  if (radii.size() != 2) {
    table.problem("radii", "a gear has two radii, in the order of the wheels",
                  "write radii = [\"0.1 m\", \"0.3 m\"], an annulus below zero");
    return gear;
  }
  gear.radius_a = radii[0];
  gear.radius_b = radii[1];
  if (std::abs(radii[0]) < 1e-20 || std::abs(radii[1]) < 1e-20) {
    table.problem("radii", "a wheel's radius must not be zero",
                  "write radii = [\"0.1 m\", \"0.3 m\"], an annulus below zero");
  } else if (std::abs(radii[0] + radii[1]) < 1e-12 * std::abs(radii[0])) {
    table.problem("radii", "wheel and annulus of one size do not roll on each other",
                  "the radii's sum is the distance of the centres, and not zero");
  }
  return gear;
}

planar::Rack read_rack(TableReader& table, const Mechanism& mechanism) {
  planar::Rack rack;
  const std::size_t before = table.problems().size();
  rack.pinion = place_of(table, {"pinion", "centre of the pinion"}, mechanism);
  rack.rack = place_of(table, {"rack", "a point of the rack"}, mechanism);
  if (table.problems().size() == before && rack.pinion.body == rack.rack.body) {
    table.problem("rack", "a rack connects two different bodies, or a body and the ground",
                  "write pinion = \"wheel.C\" and rack = \"other_body.point\", or rack = "
                  "\"ground\" with its point in \"at\"");
  }
  rack.direction = table.quantity({"direction", "of the rack"}, wanted::angle);
  rack.radius =
      table.not_zero({"radius", "of the pinion; negative on the other side"}, wanted::length);
  rack.offset = table.quantity({"offset", "along the rack"}, wanted::length, 0.0);
  return rack;
}

planar::JointKind read_kind(TableReader& table, std::size_t kind, const Mechanism& mechanism) {
  switch (kind) {
    case 0: return read_pin(table, mechanism);
    case 1: return read_slider(table, mechanism);
    case 2: return read_pin_in_slot(table, mechanism);
    case 3: return read_rigid(table, mechanism);
    case 4: return read_distance(table, mechanism);
    case 5: return read_coupling(table, mechanism);
    case 6: return read_gear(table, mechanism);
    default: return read_rack(table, mechanism);
  }
}

std::optional<planar::PinWithClearance> read_loose(TableReader& table, const planar::Pin& pin) {
  const Key start_of{"start_offset",
                     "of a pin with clearance: where the second point begins, from the first in "
                     "the axes of its body; in the middle where not said"};
  const std::optional<ClearanceOf> of = read_clearance(table);
  if (!of) {
    if (table.is_there("start_offset") && table.has_misplaced("start_offset"))
      table.problem("start_offset", "a pin that fits begins where it is",
                    "write clearance = \"0.2 mm\" as well, or remove it");
    return std::nullopt;
  }
  planar::PinWithClearance loose{pin.a, pin.b, of->clearance, of->stiffness, of->impact};
  loose.start = table.pair(start_of, wanted::length, Eigen::Vector2d::Zero().eval());
  if (loose.start.norm() > 1.01 * loose.clearance) {
    table.problem("start_offset", "the pin begins outside of its bearing",
                  "its distance from the middle is at most the clearance");
  }
  for (const char* key : {"stiffness", "damping"}) {
    if (table.is_there(key) && table.has_misplaced(key))
      table.problem(key, fmt::format("\"{}\" is of a pin that fits, in elastic models", key),
                    "write contact_stiffness and restitution of a pin with clearance");
  }
  return loose;
}

struct WhereItGives {
  CanGiveWay operator()(const planar::Pin&) const { return {true, false}; }
  CanGiveWay operator()(const planar::Slider&) const { return {true, true}; }
  CanGiveWay operator()(const planar::PinInSlot&) const { return {true, false}; }
  CanGiveWay operator()(const planar::Rigid&) const { return {true, true}; }
  CanGiveWay operator()(const planar::Distance&) const { return {true, false}; }
  CanGiveWay operator()(const planar::AngleCoupling&) const { return {}; }
  CanGiveWay operator()(const planar::Gear&) const { return {}; }
  CanGiveWay operator()(const planar::Rack&) const { return {}; }
  CanGiveWay operator()(const planar::Driven&) const { return {}; }
};

planar::ElasticJoint elasticity_of(TableReader& table, const CanGiveWay& gives_way) {
  const GivesWay of = read_elasticity(table, gives_way);
  return {0, of.stiffness, of.damping, of.turning_stiffness, of.turning_damping};
}

}  // namespace

Friction read_friction(TableReader& joint) {
  Friction friction;
  if (!joint.has("friction")) return friction;
  TableReader table = joint.table({"friction", "dry and viscous friction"});
  friction.coulomb = table.any_number({"coefficient", "Coulomb's"}, friction.coulomb);
  if (friction.coulomb < 0.0 || friction.coulomb > 2.0) {
    table.problem("coefficient", "\"coefficient\" is a coefficient of friction, from 0 to 2",
                  "write for example coefficient = 0.1");
  }
  friction.viscous =
      table.not_negative({"viscous", "force per velocity"}, wanted::damping, friction.viscous);
  const Key standing{"static_coefficient",
                     "of a contact that sticks, which one without a creep does where forces move "
                     "it; by default the coefficient"};
  const Key creep{"creep",
                  "below it friction is smoothed; by default at most 2 % of the largest velocity "
                  "that drivers give it, and where forces move it nothing is: it sticks"};
  friction.standing = table.any_number(standing, friction.standing);
  if (table.has("static_coefficient")) {
    if (friction.standing < friction.coulomb || friction.standing > 3.0 ||
        friction.coulomb == 0.0) {
      table.problem("static_coefficient",
                    "\"static_coefficient\" is at least the coefficient of what slides, which is "
                    "above zero, and at most 3",
                    "write for example coefficient = 0.1, static_coefficient = 0.15");
    }
  }
  friction.creep = table.positive(creep, wanted::velocity, friction.creep);
  friction.guide = table.not_negative(
      {"guide_length", "between the two contacts of a slider that carries a moment"},
      wanted::length, friction.guide);
  table.finish();
  return friction;
}

void read_joints(TableReader& root, MechanismDraft& draft) {
  Mechanism& mechanism = draft.mechanism;
  TableReader joints = root.table({"joints", "what connects the bodies"});
  for (auto& [name, table] : joints.named_tables()) {
    planar::Joint joint{name, planar::Pin{}};
    const std::size_t before = table.problems().size();
    const std::size_t kind = table.kind(
        {"kind", "of joint"},
        {"pin", "slider", "pin in slot", "rigid", "distance", "angle coupling", "gear", "rack"});
    // Where the kind is not known, neither is what the other keys mean.
    if (table.problems().size() == before) {
      joint.kind = read_kind(table, kind, mechanism);
      if (const auto* const pin = std::get_if<planar::Pin>(&joint.kind)) {
        if (const auto loose = read_loose(table, *pin)) {
          mechanism.forces.push_back({name, *loose});
          table.finish();
          continue;
        }
      }
      const planar::ElasticJoint elastic =
          elasticity_of(table, std::visit(WhereItGives{}, joint.kind));
      if (elastic != planar::ElasticJoint{}) {
        draft.elastic.push_back(elastic);
        draft.elastic.back().joint = static_cast<int>(mechanism.joints.size());
      }
      table.finish();
    }
    mechanism.joints.push_back(std::move(joint));
  }
}

}  // namespace boxbeam::readers
