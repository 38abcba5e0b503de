#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Joint;
using planar::Mechanism;

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

/// A reference "body.point".
Attachment attachment_in(TableReader& table, std::string_view key, const std::string& reference,
                         const Mechanism& mechanism) {
  Attachment attachment;
  const std::size_t dot = reference.rfind('.');
  if (dot == std::string::npos) {
    table.problem(key, fmt::format("\"{}\" is not a point of a body", reference),
                  "write \"body.point\", for example \"beam.B\"");
    return attachment;
  }
  const std::string body_name = reference.substr(0, dot);
  const std::string point_name = reference.substr(dot + 1);
  attachment.body = body_index(mechanism, body_name);
  if (attachment.body < 0) {
    table.problem(key, fmt::format("there is no body \"{}\"", body_name),
                  unknown_hint(body_name, names_of(mechanism.bodies)));
    return attachment;
  }
  const Body& body = mechanism.bodies[static_cast<std::size_t>(attachment.body)];
  const auto point = std::find_if(body.points.begin(), body.points.end(),
                                  [&](const BodyPoint& p) { return p.name == point_name; });
  if (point == body.points.end()) {
    table.problem(key, fmt::format("body \"{}\" has no point \"{}\"", body_name, point_name),
                  unknown_hint(point_name, names_of(body.points)));
    return attachment;
  }
  attachment.p = point->p;
  return attachment;
}

Attachment attachment_of(TableReader& table, std::string_view key, const Mechanism& mechanism) {
  const std::string reference = table.text(key);
  if (reference.empty()) return {};
  return attachment_in(table, key, reference, mechanism);
}

std::vector<Attachment> attachments_of(TableReader& table, std::string_view key, std::size_t count,
                                       const Mechanism& mechanism) {
  std::vector<Attachment> attachments;
  const std::vector<std::string> references = table.texts(key, true);
  if (references.size() != count && table.has(key)) {
    table.problem(key, fmt::format("\"{}\" wants {} points", key, count),
                  "each as \"body.point\", for example \"beam.B\"");
  }
  for (const std::string& reference : references) {
    attachments.push_back(attachment_in(table, key, reference, mechanism));
  }
  attachments.resize(count);
  return attachments;
}

planar::Pin read_pin(TableReader& table, const Mechanism& mechanism) {
  planar::Pin pin;
  const std::vector<std::string> ends = table.texts("connect", true);
  if (ends.size() != 2) {
    if (table.has("connect")) {
      table.problem("connect", "a pin connects two points",
                    "write connect = [\"beam.B\", \"rod.B\"], or \"ground\" for one of them");
    }
    return pin;
  }
  int grounds = 0;
  Attachment* sides[] = {&pin.a, &pin.b};
  for (std::size_t i = 0; i < 2; ++i) {
    if (ends[i] == "ground") {
      ++grounds;
      sides[i]->p = table.pair("at", wanted::length);
    } else {
      *sides[i] = attachment_in(table, "connect", ends[i], mechanism);
    }
  }
  if (grounds == 2 || (grounds == 0 && pin.a.body == pin.b.body && pin.a.body >= 0)) {
    table.problem("connect", "a pin connects two different bodies, or a body and the ground",
                  "write connect = [\"beam.B\", \"rod.B\"], or \"ground\" for one of them");
  }
  return pin;
}

planar::Slider read_slider(TableReader& table, const Mechanism& mechanism) {
  planar::Slider slider;
  slider.point = attachment_of(table, "point", mechanism);
  slider.through = table.pair("through", wanted::length);
  slider.direction = table.quantity("direction", wanted::angle);
  slider.angle = table.quantity("angle", wanted::angle, 0.0);
  return slider;
}

planar::AngleCoupling read_coupling(TableReader& table, const Mechanism& mechanism) {
  const std::vector<Attachment> points = attachments_of(table, "points", 2, mechanism);
  if (points[0].body == points[1].body && points[0].body >= 0) {
    table.problem("points", "a coupling connects two different bodies",
                  "write points = [\"body.point\", \"other_body.point\"]");
  }
  return {points[0], points[1], table.number("ratio", 1.0),
          table.quantity("offset", wanted::angle, 0.0)};
}

planar::Driven read_driver(TableReader& table, const Mechanism& mechanism) {
  planar::Driven driven;
  table.choice("kind", {"harmonic"});
  constexpr planar::Coordinate coordinates[] = {planar::Coordinate::x, planar::Coordinate::y,
                                                planar::Coordinate::angle};
  driven.coordinate = coordinates[table.choice("coordinate", {"x", "y", "angle"})];
  const bool angle = driven.coordinate == planar::Coordinate::angle;
  driven.point = attachment_of(table, "point", mechanism);
  const WantedDimension& dimension = angle ? wanted::angle : wanted::length;
  driven.driver.mean = table.quantity("mean", dimension);
  driven.driver.amplitude = table.quantity("amplitude", dimension);
  driven.driver.phase = table.quantity("phase", wanted::angle, 0.0);
  if (table.has("angular_frequency")) {
    driven.driver.omega = table.positive("angular_frequency", wanted::angular_frequency);
  } else {
    driven.driver.omega = 2.0 * std::numbers::pi * table.positive("frequency", wanted::frequency);
  }
  if (driven.driver.amplitude == 0.0) {
    table.problem("amplitude", "the driver does not move", "give an amplitude other than zero");
  }
  return driven;
}

Body read_body(const std::string& name, TableReader& table, bool is_beam, Eigen::Vector2d& centre) {
  Body body;
  body.name = name;
  if (name == "ground") {
    table.problem("", "\"ground\" is the world and no body", "give the body another name");
  }
  if (is_beam) {
    for (const char* key : {"mass", "inertia", "uniform_rod", "centre"}) {
      const bool there = std::any_of(table.members().begin(), table.members().end(),
                                     [&](const Node::Member& m) { return m.key == key; });
      if (!there || !table.has(key)) continue;
      table.problem(key,
                    fmt::format("the mass properties of the beam come from its sections; \"{}\" "
                                "has no place here",
                                key),
                    "remove this line");
    }
  } else {
    body.mass = table.not_negative("mass", wanted::mass);
    centre = table.pair("centre", wanted::length, Eigen::Vector2d::Zero());
    if (table.has("uniform_rod")) {
      const double length = table.positive("uniform_rod", wanted::length);
      body.inertia = body.mass * length * length / 12.0;
    } else {
      body.inertia = table.not_negative("inertia", wanted::inertia, 0.0);
    }
  }
  TableReader points = table.table("points");
  points.accept_all();
  for (const Node::Member& member : points.members()) {
    body.points.push_back(
        {member.key,
         points.pair_in(member.value, fmt::format("point \"{}\"", member.key), wanted::length)});
  }
  TableReader sketch = table.table("sketch");
  body.sketch.centre = sketch.pair("at", wanted::length);
  body.sketch.angle = sketch.quantity("angle", wanted::angle, 0.0);
  sketch.finish();
  table.finish();
  return body;
}

Joint read_joint(const std::string& name, TableReader& table, const Mechanism& mechanism) {
  Joint joint{name, planar::Pin{}};
  const std::size_t before = table.problems().size();
  const std::size_t kind = table.choice("kind", {"pin", "slider", "angle coupling"});
  if (table.problems().size() != before) return joint;  // what its other keys mean is not known
  switch (kind) {
    case 0: joint.kind = read_pin(table, mechanism); break;
    case 1: joint.kind = read_slider(table, mechanism); break;
    default: joint.kind = read_coupling(table, mechanism); break;
  }
  table.finish();
  return joint;
}

planar::Loop read_loop(const std::string& name, TableReader& table, const Mechanism& mechanism) {
  planar::Loop loop{name, planar::TurnSign{}, 1};
  if (table.has("turn") == table.has("along")) {
    table.texts("turn", false);
    table.texts("along", false);
    table.problem("", fmt::format("loop \"{}\" wants either \"turn\" or \"along\"", name),
                  "turn = [three points] for their sense of turn, along = [two points] with a "
                  "direction for the sense of a vector");
  } else if (table.has("turn")) {
    const auto points = attachments_of(table, "turn", 3, mechanism);
    loop.measure = planar::TurnSign{points[0], points[1], points[2]};
  } else {
    const auto points = attachments_of(table, "along", 2, mechanism);
    loop.measure =
        planar::AlongSign{points[0], points[1], table.quantity("direction", wanted::angle)};
  }
  loop.sign = table.choice("sign", {"+", "-"}) == 0 ? 1 : -1;
  table.finish();
  return loop;
}

void check_frequencies(TableReader& drivers, const Mechanism& mechanism) {
  double first = 0.0;
  for (const Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<planar::Driven>(&joint.kind);
    if (driven == nullptr) continue;
    if (first == 0.0) first = driven->driver.omega;
    if (std::abs(driven->driver.omega - first) > 1e-12 * first) {
      drivers.problem(joint.name, "all drivers must have one frequency, so that the motion repeats",
                      "write the frequency of the first driver");
    }
  }
}

void check_count(TableReader& root, const Mechanism& mechanism) {
  const auto coordinates = mechanism.coordinates();
  const auto equations = mechanism.equations();
  if (coordinates == equations) return;
  const auto difference = std::abs(coordinates - equations);
  root.problem(
      "joints",
      fmt::format(
          "{} bodies have {} coordinates, joints and drivers give {} equations: the motion is {}",
          mechanism.bodies.size(), coordinates, equations,
          equations < coordinates ? "not determined" : "determined more than once"),
      equations < coordinates
          ? fmt::format("{} more {} wanted: a joint or a driver is missing", difference,
                        difference == 1 ? "equation is" : "equations are")
          : fmt::format("take away {} {}: a joint or a driver is too much", difference,
                        difference == 1 ? "equation" : "equations"));
}

/// Calls `move` with every attachment of the mechanism.
template <class Move>
void for_each_attachment(Mechanism& mechanism, const Move& move) {
  for (Joint& joint : mechanism.joints) {
    if (auto* pin = std::get_if<planar::Pin>(&joint.kind)) {
      move(pin->a);
      move(pin->b);
    } else if (auto* slider = std::get_if<planar::Slider>(&joint.kind)) {
      move(slider->point);
    } else if (auto* coupling = std::get_if<planar::AngleCoupling>(&joint.kind)) {
      move(coupling->a);
      move(coupling->b);
    } else if (auto* driven = std::get_if<planar::Driven>(&joint.kind)) {
      move(driven->point);
    }
  }
  for (planar::Loop& loop : mechanism.loops) {
    if (auto* turn = std::get_if<planar::TurnSign>(&loop.measure)) {
      move(turn->from);
      move(turn->via);
      move(turn->to);
    } else {
      auto& along = std::get<planar::AlongSign>(loop.measure);
      move(along.from);
      move(along.to);
    }
  }
}

}  // namespace

std::string unknown_hint(std::string_view name, const std::vector<std::string>& known) {
  const std::string near = nearest_word(name, known);
  return near.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                      : fmt::format("did you mean \"{}\"?", near);
}

int body_of(TableReader& table, std::string_view key, const Mechanism& mechanism) {
  const std::string name = table.text(key);
  if (name.empty()) return -1;
  const int index = body_index(mechanism, name);
  if (index < 0) {
    table.problem(key, fmt::format("there is no body \"{}\"", name),
                  unknown_hint(name, names_of(mechanism.bodies)));
  }
  return index;
}

int joint_of(TableReader& table, std::string_view key, const Mechanism& mechanism) {
  const std::string name = table.text(key);
  if (name.empty()) return -1;
  const int index = joint_index(mechanism, name);
  if (index < 0) {
    table.problem(key, fmt::format("there is no joint \"{}\"", name),
                  unknown_hint(name, names_of(mechanism.joints)));
  }
  return index;
}

MechanismDraft read_mechanism(TableReader& root, const std::string& beam_body) {
  MechanismDraft draft;
  Mechanism& mechanism = draft.mechanism;
  TableReader general = root.table("mechanism");
  mechanism.gravity = general.pair("gravity", wanted::acceleration);
  general.finish();

  TableReader bodies = root.table("bodies");
  const bool beam_known = root.has("beam") && (beam_body.empty() || bodies.has(beam_body));
  for (auto& [name, table] : bodies.named_tables()) {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    // Where [beam] is missing or misspells its body, the body without a mass is meant.
    const bool is_beam = name == beam_body || (!beam_known && !table.has("mass"));
    mechanism.bodies.push_back(read_body(name, table, is_beam, centre));
    draft.centres.push_back(centre);
  }
  TableReader joints = root.table("joints");
  for (auto& [name, table] : joints.named_tables()) {
    mechanism.joints.push_back(read_joint(name, table, mechanism));
  }
  TableReader drivers = root.table("drivers");
  for (auto& [name, table] : drivers.named_tables()) {
    if (joint_index(mechanism, name) >= 0) {
      table.problem("", fmt::format("\"{}\" is already the name of a joint", name),
                    "give the driver another name");
    }
    Joint driver{name, read_driver(table, mechanism)};
    table.finish();
    mechanism.joints.push_back(std::move(driver));
  }
  if (root.has("drivers") && drivers.members().empty()) {
    root.problem("drivers", "nothing drives the mechanism", "write at least one [drivers.<name>]");
  }
  TableReader loops = root.table("loops", false);
  for (auto& [name, table] : loops.named_tables()) {
    mechanism.loops.push_back(read_loop(name, table, mechanism));
  }
  if (root.problems().empty()) {
    check_frequencies(drivers, mechanism);
    check_count(root, mechanism);
  }
  return draft;
}

Mechanism place_at_centres(MechanismDraft draft, const TaperedBeam& beam, int beam_body) {
  Mechanism& mechanism = draft.mechanism;
  if (beam_body != planar::ground) {
    const auto index = static_cast<std::size_t>(beam_body);
    const MassProperties properties = mass_properties_of(beam);
    mechanism.bodies[index].mass = properties.mass.value();
    mechanism.bodies[index].inertia = properties.inertia.value();
    draft.centres[index] = {properties.centre.value(), 0.0};
  }
  for_each_attachment(mechanism, [&](Attachment& attachment) {
    if (attachment.body != planar::ground) {
      attachment.p -= draft.centres[static_cast<std::size_t>(attachment.body)];
    }
  });
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    Body& body = mechanism.bodies[i];
    for (BodyPoint& point : body.points) point.p -= draft.centres[i];
    body.sketch.centre += Eigen::Rotation2Dd(body.sketch.angle) * draft.centres[i];
  }
  return std::move(mechanism);
}

}  // namespace boxbeam::readers
