#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "frame_reader.hpp"

namespace boxbeam::readers {

using Eigen::Vector3d;

Vector3d vector_of(TableReader& table, const Key& key, const WantedDimension& wanted, bool plane,
                   std::optional<Vector3d> fallback) {
  if (!plane) return table.triple(key, wanted, fallback);
  const std::optional<Eigen::Vector2d> flat =
      fallback ? std::optional(Eigen::Vector2d(fallback->head<2>())) : std::nullopt;
  const Eigen::Vector2d of = table.pair(key, wanted, flat);
  return {of.x(), of.y(), 0.0};
}

double length_of(const frame::Member& member) {
  return member.beam.segments.empty() ? 0.0 : member.beam.length().value();
}

void read_frame(TableReader& root, frame::Structure& structure) {
  TableReader table = root.table({"frame", "what all members have in common"}, false);
  structure.plane = !table.boolean({"space",
                                    "whether it is looked at in space, z upwards, or in "
                                    "the plane of x and y, y upwards"},
                                   false);
  constexpr double standard = 9.81;
  const Vector3d down =
      structure.plane ? Vector3d(0.0, -standard, 0.0) : Vector3d(0.0, 0.0, -standard);
  structure.gravity = vector_of(table, {"gravity", "acceleration of free fall"},
                                wanted::acceleration, structure.plane, down);
  table.finish();
}

namespace {

/// Where a member begins or ends: a place, or a point of a member before it.
Vector3d written_place(TableReader& table, const Key& key, const frame::Structure& structure,
                       std::optional<Vector3d> fallback) {
  if (table.is_list(key.name) || (!table.is_there(key.name) && fallback))
    return vector_of(table, key, wanted::length, structure.plane, fallback);
  const std::string reference = table.text(key);
  if (reference.empty()) return Vector3d::Zero();
  return in_world(structure, frame_point(table, key.name, reference, structure));
}

/// x along the member, z square to it nearest to what is wished.
Eigen::Matrix3d axes_along(const Vector3d& x, const Vector3d& wished_z) {
  Eigen::Matrix3d axes;
  axes.col(0) = x;
  axes.col(2) = (wished_z - x * x.dot(wished_z)).normalized();
  axes.col(1) = axes.col(2).cross(x);
  return axes;
}

void read_axes(TableReader& table, const frame::Structure& structure, frame::Member& member) {
  const double length = length_of(member);
  const bool to_its_end = length == 0.0 && !member.beam.segments.empty();
  Vector3d along = Vector3d::UnitX();
  if (to_its_end || table.has("to")) {
    along = written_place(table,
                          {"to",
                           "where its end lies; only its direction counts where the "
                           "segments say the length"},
                          structure, {}) -
            member.start;
    if (table.problems().empty() && !(along.norm() > 1e-9)) {
      table.problem("to", "the member has no length", "write another place than \"from\"");
      along = Vector3d::UnitX();
    }
    if (length > 0.0 && table.problems().empty() &&
        std::abs(along.norm() - length) > 1e-6 * length) {
      table.problem("to",
                    fmt::format("from \"from\" to \"to\" it is {:.6g} m, the segments are {:.6g} m "
                                "long together",
                                along.norm(), length),
                    "leave out \"to\" and write \"angle\" or \"axis\", or mend the lengths");
    }
  } else if (structure.plane) {
    const double angle =
        table.quantity({"angle", "of its axis, from the world's x"}, wanted::angle, 0.0);
    along = Vector3d(std::cos(angle), std::sin(angle), 0.0);
  } else {
    along = table.direction({"axis", "of the member, world axes"}, Vector3d::UnitX());
  }
  if (to_its_end) member.beam.segments.front().length = si<Length>(along.norm());
  along.normalize();
  if (structure.plane) {
    member.axes = axes_along(along, Vector3d(-along.y(), along.x(), 0.0));
    return;
  }
  const bool upright = std::abs(along.z()) > 1.0 - 1e-9;
  const Vector3d z = table.direction(
      {"z", "of its sections, world axes; as far upwards as it can be where not said"},
      upright ? Vector3d::UnitX() : Vector3d::UnitZ());
  if (table.problems().empty() && z.cross(along).norm() < 1e-9) {
    table.problem("z", "the section's z cannot lie along the axis",
                  "choose a direction square to the axis");
    return;
  }
  member.axes = axes_along(along, z);
}

void read_points(TableReader& table, bool plane, frame::Member& member) {
  const double length = length_of(member);
  member.points = {{"start", Vector3d::Zero()}, {"end", {length, 0.0, 0.0}}};
  TableReader points = table.table({"points", "of the member, by name"}, false);
  points.accept_all();
  for (const Node::Member& point : points.members(
           "along its axis from its start, then towards its z; in space along x, y and z")) {
    const std::string what = fmt::format("point \"{}\"", point.key);
    Vector3d p;
    if (plane) {
      const Eigen::Vector2d flat = points.pair_in(point.value, what, wanted::length);
      p = {flat.x(), 0.0, flat.y()};
    } else {
      p = points.triple_in(point.value, what, wanted::length);
    }
    if (length > 0.0 && (p.x() < -1e-9 * length || p.x() > length * (1.0 + 1e-9))) {
      points.problem(point.key,
                     fmt::format("the point is beyond the member, at s = {:.6g} m", p.x()),
                     fmt::format("s goes from 0 to {:.6g} m", length));
    }
    member.points.push_back({point.key, p});
  }
}

}  // namespace

void read_member_place(TableReader& table, const frame::Structure& structure,
                       frame::Member& member) {
  member.start =
      written_place(table, {"from", "where its start lies: a place, or a point \"member.point\""},
                    structure, Vector3d(Vector3d::Zero()));
  read_axes(table, structure, member);
  read_points(table, structure.plane, member);
  member.expansion = table.positive({"expansion", "of its material when it gets warm"},
                                    wanted::expansion, member.expansion);
}

void read_members(TableReader& root, const FrameDefaults& defaults, frame::Structure& structure) {
  const Project& project = *defaults.project;
  for (auto& [name, table] :
       root.table({"members", "beside the verified beam"}, false).named_tables()) {
    frame::Member member;
    member.name = name;
    member.youngs_modulus = table.positive({"youngs_modulus", "of the member"}, wanted::stress,
                                           project.model.youngs_modulus);
    member.shear_modulus = table.positive({"shear_modulus", "of the member"}, wanted::stress,
                                          project.model.shear_modulus);
    member.beam.density =
        si<Density>(table.positive({"density", "of its material; that of the beam where not said"},
                                   wanted::density, project.beam.density.value()));
    if (table.has("section")) {
      const Section section = named_section(
          table, {"section", "the same all along, from \"from\" to \"to\""}, *defaults.sections);
      member.beam.segments.push_back({"1", Length{}, Length{}, section, section});
    } else {
      Length start;
      for (TableReader& segment :
           table.tables({"segments", "from its start to its end, constant or tapered"}, true)) {
        member.beam.segments.push_back(
            read_segment(segment, member.beam.segments.size() + 1, start, *defaults.sections));
        start = member.beam.segments.back().end();
      }
    }
    if (index_by_name(structure.members, name) >= 0) {
      table.problem("", fmt::format("\"{}\" is the name of a verified beam", name),
                    "give the member another name");
    }
    read_member_place(table, structure, member);
    table.finish();
    structure.members.push_back(std::move(member));
  }
}

frame::Place frame_point(TableReader& table, std::string_view key, const std::string& reference,
                         const frame::Structure& structure) {
  const std::size_t dot = reference.rfind('.');
  const std::string member_name = reference.substr(0, dot == std::string::npos ? 0 : dot);
  const int index = index_by_name(structure.members, member_name);
  if (dot == std::string::npos || index < 0) {
    table.problem(key, fmt::format("\"{}\" is not a point of a member", reference),
                  dot == std::string::npos
                      ? "write \"member.point\", for example \"beam.end\""
                      : unknown_hint(member_name, names_of(structure.members)));
    return {};
  }
  const frame::Member& member = structure.members[static_cast<std::size_t>(index)];
  const std::string point_name = reference.substr(dot + 1);
  const int point = index_by_name(member.points, point_name);
  if (point < 0) {
    table.problem(key, fmt::format("member \"{}\" has no point \"{}\"", member.name, point_name),
                  unknown_hint(point_name, names_of(member.points)));
    return {};
  }
  return {index, member.points[static_cast<std::size_t>(point)].p};
}

int read_on(TableReader& table, const frame::Structure& structure) {
  const Key on{"on", "the member; the beam where not said, of several beams it is to be said"};
  if (!table.has(on)) {
    if (structure.beams > 1) {
      table.problem("", fmt::format("on which of the {} beams it is, is not said", structure.beams),
                    fmt::format("write for example on = \"{}\"", structure.members.front().name));
    }
    return 0;
  }
  const std::string name = table.text(on);
  const int member = index_by_name(structure.members, name);
  if (member < 0 && !name.empty()) {
    table.problem("on", fmt::format("there is no member \"{}\"", name),
                  unknown_hint(name, names_of(structure.members)));
  }
  return std::max(0, member);
}

frame::Place read_frame_place(TableReader& table, const frame::Structure& structure) {
  frame::Place place{0, Vector3d::Zero()};
  const Key at{"at", "a station, \"2 m\"; a place in the member's axes; or \"member.point\""};
  const Node* const written = table.peek("at");
  const bool named = written != nullptr && written->kind == Node::Kind::text &&
                     !written->text.empty() &&
                     std::isalpha(static_cast<unsigned char>(written->text.front())) != 0;
  if (named) return frame_point(table, "at", table.text(at), structure);
  place.member = read_on(table, structure);
  if (table.is_list("at")) {
    if (structure.plane) {
      const Eigen::Vector2d flat = table.pair(at, wanted::length);
      place.p = {flat.x(), 0.0, flat.y()};
    } else {
      place.p = table.triple(at, wanted::length);
    }
  } else {
    place.p.x() = table.quantity(at, wanted::length);
  }
  const frame::Member& member = structure.members[static_cast<std::size_t>(place.member)];
  if (!table.problems().empty()) return place;
  const double length = length_of(member);
  if (place.p.x() < -1e-9 * length || place.p.x() > length * (1.0 + 1e-9)) {
    table.problem("at",
                  fmt::format("s = {:.6g} m is beyond member \"{}\"", place.p.x(), member.name),
                  fmt::format("s goes from 0 to {:.6g} m", length));
  }
  place.p.x() = std::clamp(place.p.x(), 0.0, length);
  return place;
}

}  // namespace boxbeam::readers
