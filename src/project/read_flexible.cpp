#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector2d;
using flexible::Attachment;
using flexible::Joint;
using flexible::Mechanism;

/// How far the two parts of a joint may be apart in the unstressed posture, of the mechanism's
/// size.
constexpr double assembly_tolerance = 1e-6;
/// The word for an infinite stiffness.
constexpr const char* rigid = "rigid";

/// A point "link.point", a problem and the ground where there is none.
Attachment point_of_link(TableReader& table, std::string_view key, const std::string& reference,
                         const Mechanism& mechanism) {
  const std::size_t dot = reference.rfind('.');
  if (dot == std::string::npos) {
    table.problem(key, fmt::format("\"{}\" is not a point of a link", reference),
                  "write \"link.point\", for example \"boom.end\"");
    return {};
  }
  const std::string link_name = reference.substr(0, dot);
  const std::string point_name = reference.substr(dot + 1);
  const int index = index_by_name(mechanism.links, link_name);
  if (index < 0) {
    table.problem(key, fmt::format("there is no link \"{}\"", link_name),
                  unknown_hint(link_name, names_of(mechanism.links)));
    return {};
  }
  const flexible::Link& link = mechanism.links[static_cast<std::size_t>(index)];
  const int point = index_by_name(link.points, point_name);
  if (point < 0) {
    table.problem(key, fmt::format("link \"{}\" has no point \"{}\"", link_name, point_name),
                  unknown_hint(point_name, names_of(link.points)));
    return {};
  }
  return {index, link.points[static_cast<std::size_t>(point)].p};
}

/// The two places that a joint connects; that of the ground is "at", or where the other one is.
void read_connection(TableReader& table, const Mechanism& mechanism, Joint& joint) {
  const char* hint = "write connect = [\"boom.end\", \"arm.start\"], or \"ground\" for one of them";
  const std::size_t before = table.problems().size();
  const std::vector<std::string> references =
      table.texts({"connect", "two points, \"link.point\", or \"ground\" for one of them"}, true);
  const bool at = table.has("at");
  if (table.problems().size() != before) return;
  if (references.size() != 2 || (references[0] == "ground" && references[1] == "ground")) {
    table.problem("connect", "a joint connects two points", hint);
    return;
  }
  Attachment* ends[] = {&joint.a, &joint.b};
  for (std::size_t i = 0; i < 2; ++i) {
    if (references[i] != "ground") {
      *ends[i] = point_of_link(table, "connect", references[i], mechanism);
    }
  }
  if (table.problems().size() != before) return;
  for (std::size_t i = 0; i < 2; ++i) {
    if (references[i] != "ground") continue;
    ends[i]->p =
        at ? table.pair({"at", "the place on the ground; where the other point is if not said"},
                        wanted::length)
           : in_world(mechanism, *ends[1 - i]);
    return;
  }
  if (at) {
    table.problem("at", "\"at\" is the joint's place on the ground, which it does not touch",
                  "remove it");
  }
  if (joint.a.link == joint.b.link) {
    table.problem("connect", "a joint connects two different links, or a link and the ground",
                  hint);
  }
}

/// Stiffness and damping about the joint.
void read_turning(TableReader& table, Joint& joint) {
  joint.stiffness[2] = table.per_direction({"turning_stiffness", "about the joint"}, 1,
                                           wanted::torsional_stiffness, rigid, 0.0)[0];
  joint.damping[2] = table.per_direction({"turning_damping", "about the joint"}, 1,
                                         wanted::torsional_damping, {}, 0.0)[0];
}

void read_revolute(TableReader& table, bool general, Joint& joint) {
  joint.angle = table.quantity({"angle", "of its directions"}, wanted::angle, 0.0);
  const auto stiffness = table.per_direction(
      {"stiffness", "in both directions, or each; \"rigid\""}, 2, wanted::stiffness, rigid);
  const auto damping = table.per_direction({"damping", "likewise"}, 2, wanted::damping, {}, 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    joint.stiffness[i] = stiffness[i];
    joint.damping[i] = damping[i];
  }
  read_turning(table, joint);
  if (!general && (stiffness[0] == 0.0 || stiffness[1] == 0.0)) {
    table.problem("stiffness", "a revolute joint holds its point in both directions",
                  "write a stiffness above zero, or kind = \"general\"");
  }
}

/// Along the axis of the first link, or at an angle in the world where that is the ground.
void read_sliding(TableReader& table, const Mechanism& mechanism, Joint& joint) {
  if (joint.a.link == flexible::ground) {
    joint.angle =
        table.quantity({"angle", "of its axis, where the first part is the ground"}, wanted::angle);
  } else {
    joint.angle = mechanism.links[static_cast<std::size_t>(joint.a.link)].angle;
  }
  joint.stiffness[0] =
      table.per_direction({"along", "along its axis"}, 1, wanted::stiffness, rigid, 0.0)[0];
  joint.stiffness[1] =
      table.per_direction({"normal", "across its axis"}, 1, wanted::stiffness, rigid)[0];
  joint.damping[0] =
      table.per_direction({"along_damping", "along its axis"}, 1, wanted::damping, {}, 0.0)[0];
  joint.damping[1] =
      table.per_direction({"normal_damping", "across its axis"}, 1, wanted::damping, {}, 0.0)[0];
  read_turning(table, joint);
  if (joint.stiffness[1] == 0.0) {
    table.problem("normal", "a sliding contact holds across its axis",
                  fmt::format("write for example {}", wanted::stiffness.example));
  }
}

/// The largest distance between two of the places that the mechanism speaks of.
double size_of(const Mechanism& mechanism) {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
  const auto take = [&](const Attachment& at) {
    const Vector2d p = in_world(mechanism, at);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const flexible::Link& link = mechanism.links[i];
    take({static_cast<int>(i), {link.length, 0.0}});
    take({static_cast<int>(i), Vector2d::Zero()});
    for (const BodyPoint& point : link.points) take({static_cast<int>(i), point.p});
  }
  return (high - low).norm();
}

/// Notes a joint whose parts do not meet in the posture that the case writes: how it would be
/// strained to close it is not known.
/// The contact of a sliding joint is where the first link's part is: there it acts on both.
void meet_at_first(TableReader& table, const Mechanism& mechanism, Joint& joint) {
  const Vector2d place = in_world(mechanism, joint.a);
  if (joint.b.link == flexible::ground) {
    joint.b.p = place;
    return;
  }
  const flexible::Link& link = mechanism.links[static_cast<std::size_t>(joint.b.link)];
  joint.b.p = Eigen::Rotation2Dd(-link.angle) * (place - link.origin);
  const double s = joint.b.p.x();
  const double slack = assembly_tolerance * size_of(mechanism);
  if (link.kind == flexible::LinkKind::rigid || (s >= -slack && s <= link.length + slack)) return;
  table.problem("connect",
                fmt::format("the first part of the contact stands off link \"{}\", at s = {:.6g} m",
                            link.name, s),
                fmt::format("s goes from 0 to {:.6g} m", link.length));
}

void check_gap(TableReader& table, std::size_t kind, const Mechanism& mechanism,
               const Joint& joint) {
  if (!table.problems().empty()) return;
  const Vector2d gap = in_world(mechanism, joint.b) - in_world(mechanism, joint.a);
  const Vector2d along(std::cos(joint.angle), std::sin(joint.angle));
  const double apart = kind != 1 ? gap.norm() : std::abs(along.x() * gap.y() - along.y() * gap.x());
  if (apart <= assembly_tolerance * size_of(mechanism)) return;
  table.problem(
      "connect",
      fmt::format("the two parts of the joint are {:.4g} mm apart in the unstressed "
                  "posture{}",
                  apart * 1e3, kind != 1 ? "" : ", across its axis"),
      "move a link or a point so that they meet: a force that acts at two places is in no "
      "balance");
}

void read_elastic_joints(TableReader& root, Mechanism& mechanism) {
  for (auto& [name, table] : root.table({"joints", "elastic joints"}).named_tables()) {
    Joint joint;
    joint.name = name;
    const std::size_t before = table.problems().size();
    const std::size_t kind = table.kind({"kind", "of joint"}, {"revolute", "sliding", "general"});
    if (table.problems().size() != before) continue;
    read_connection(table, mechanism, joint);
    if (table.problems().size() != before) {
      table.accept_all();
    } else if (kind == 1) {
      read_sliding(table, mechanism, joint);
    } else {
      read_revolute(table, kind == 2, joint);
    }
    table.finish();
    check_gap(table, kind, mechanism, joint);
    if (kind == 1 && table.problems().empty()) meet_at_first(table, mechanism, joint);
    const bool holds = std::any_of(joint.stiffness.begin(), joint.stiffness.end(),
                                   [](double stiffness) { return stiffness != 0.0; });
    if (!holds && table.problems().size() == before) {
      table.problem("stiffness", "the joint holds nothing",
                    fmt::format("write for example {}", wanted::stiffness.example));
    }
    mechanism.joints.push_back(std::move(joint));
  }
}

void read_elastic_loads(TableReader& root, Mechanism& mechanism) {
  for (auto& [name, table] :
       root.table({"loads", "forces that stand still and forces that vibrate"}, false)
           .named_tables()) {
    flexible::Load load;
    load.name = name;
    const std::string on = table.text({"on", "where it acts, \"link.point\""});
    if (!on.empty()) load.at = point_of_link(table, "on", on, mechanism);
    load.constant.head<2>() = table.pair({"force", "constant"}, wanted::force, Vector2d::Zero());
    load.constant.z() = table.quantity({"moment", "constant"}, wanted::moment, 0.0);
    load.amplitude.head<2>() =
        table.pair({"amplitude_force", "that vibrates"}, wanted::force, Vector2d::Zero());
    load.amplitude.z() = table.quantity({"amplitude_moment", "that vibrates"}, wanted::moment, 0.0);
    load.phase = table.quantity({"phase", "of the vibration"}, wanted::angle, 0.0);
    if (index_by_name(mechanism.joints, name) >= 0) {
      table.problem("", fmt::format("\"{}\" is already the name of a joint", name),
                    "give the load another name");
    }
    table.finish();
    mechanism.loads.push_back(std::move(load));
  }
}

/// [motion], how fast the harmonic loads change.
void read_frequency(TableReader& root, Mechanism& mechanism) {
  if (root.has("motion")) {
    TableReader motion = root.table({"motion", "how fast the loads vibrate"});
    mechanism.frequency = motion.positive({"frequency", "of the amplitudes"}, wanted::frequency);
    motion.finish();
    return;
  }
  for (const flexible::Load& load : mechanism.loads) {
    if (load.amplitude.isZero(0.0)) continue;
    root.problem("loads",
                 fmt::format("load \"{}\" has an amplitude, but nothing says how fast it changes",
                             load.name),
                 "write [motion] with frequency = \"25 Hz\"");
    return;
  }
}

}  // namespace

Mechanism read_flexible(TableReader& root, const LinkDefaults& defaults) {
  Mechanism mechanism;
  TableReader general = root.table({"mechanism", "general"});
  mechanism.gravity = general.pair({"gravity", "acceleration of free fall"}, wanted::acceleration);
  general.finish();
  const std::size_t before = root.problems().size();
  mechanism.links = read_links(root, defaults);
  mechanism.element = defaults.form.element;
  mechanism.nodes_at_joints = defaults.form.nodes_at_joints;
  if (root.problems().size() != before) {  // where links are is not known
    for (const char* key : {"joints", "loads", "motion"}) {
      if (root.has(key)) root.table(key).accept_all();
    }
    return mechanism;
  }
  read_elastic_joints(root, mechanism);
  read_elastic_loads(root, mechanism);
  read_frequency(root, mechanism);
  return mechanism;
}

}  // namespace boxbeam::readers
