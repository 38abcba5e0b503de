#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "boxbeam/section/section_properties.hpp"
#include "neighbour_readers.hpp"

namespace boxbeam::readers {
namespace {

/// Whether something takes hold of the body of an end there.
bool is_held(const planar::Mechanism& mechanism, const planar::Attachment& end, double near) {
  const auto here = [&](const planar::Attachment& at) {
    return at.body == end.body && (at.p - end.p).norm() < near;
  };
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [&](const planar::Joint& joint) {
                       const auto [a, b] = planar::ends_of(joint);
                       return here(a) || here(b);
                     });
}

bool is_held(const spatial::Mechanism& mechanism, const spatial::Attachment& end, double near) {
  const auto here = [&](int body, const Eigen::Vector3d& p) {
    return body == end.body && (p - end.p).norm() < near;
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    if (here(static_cast<int>(i), joint.point) || here(joint.parent, joint.at)) return true;
  }
  const auto holds = [&](const auto& of) {
    return here(of.a.body, of.a.p) || here(of.b.body, of.b.p);
  };
  return std::any_of(mechanism.closing.begin(), mechanism.closing.end(),
                     [&](const spatial::ClosingJoint& joint) {
                       return !spatial::has_teeth(joint.kind) && holds(joint);
                     }) ||
         std::any_of(mechanism.springs.begin(), mechanism.springs.end(), holds);
}

/// Whether joints hold a rod at both its points, and no situation changes its body.
template <class Mechanism, class Ends>
void check_rod_ends(TableReader& table, const Ends& rod, const Mechanism& mechanism,
                    const Project& project) {
  const double near = 1e-9 * (rod.to.p - rod.from.p).norm();
  for (const auto& [key, end] : {std::pair{"from", rod.from}, {"to", rod.to}}) {
    if (is_held(mechanism, end, near)) continue;
    table.problem(key, "no joint holds the rod at this point, and nothing presses it there",
                  "write the points at which joints hold it");
  }
  const std::string& body = mechanism.bodies[static_cast<std::size_t>(rod.from.body)].name;
  for (const Situation& situation : project.situations) {
    for (const std::string& change : situation.set) {
      if (!change.starts_with("bodies." + body + ".")) continue;
      table.problem("from",
                    fmt::format("situation \"{}\" changes the body of the rod", situation.name),
                    "leave the rod's body as it is, or take the rod out of the checks");
    }
  }
}

/// The two ends of a rod that is a body, and how far apart they are.
template <class Ends, class Mechanism>
Ends read_rod_ends(TableReader& table, const Mechanism& mechanism, RodInput& rod) {
  Ends ends;
  ends.from = attachment_of(table, {"from", "its end, \"body.point\""}, mechanism);
  ends.to = attachment_of(table, {"to", "its other end, of the same body"}, mechanism);
  rod.length = si<Length>((ends.to.p - ends.from.p).norm());
  if (table.problems().empty() &&
      (ends.from.body != ends.to.body || ends.from.body < 0 || !(rod.length > Length{})))
    table.problem("to", "a rod goes from one point of a body to another one of the same body",
                  "write two of its points");
  return ends;
}

Key link_key() {
  return {
      "link",
      "in place of \"from\" and \"to\": the joint of kind \"distance\", in the plane the driven "
      "length, or the spring that it is"};
}

/// What may be a rod without mass, by name; its length is known where it does not change.
struct NamedLink {
  std::string name;
  RodLink link;
  std::optional<double> length;  ///< [m]
};

std::vector<NamedLink> links_in(const planar::Mechanism& mechanism) {
  std::vector<NamedLink> links;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const planar::Joint& joint = mechanism.joints[i];
    if (!planar::is_rod(joint)) continue;
    const auto* const distance = std::get_if<planar::Distance>(&joint.kind);
    links.push_back({joint.name,
                     {false, i},
                     distance != nullptr ? std::optional(distance->length) : std::nullopt});
  }
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    if (std::holds_alternative<planar::Spring>(mechanism.forces[i].kind))
      links.push_back({mechanism.forces[i].name, {true, i}, {}});
  }
  return links;
}

std::vector<NamedLink> links_in(const spatial::Mechanism& mechanism) {
  std::vector<NamedLink> links;
  for (std::size_t i = 0; i < mechanism.closing.size(); ++i) {
    const spatial::ClosingJoint& joint = mechanism.closing[i];
    if (joint.kind != spatial::ClosingKind::distance) continue;
    links.push_back({joint.name, {false, i}, {}});
    if (joint.driver_name.empty()) links.back().length = driver_at(joint.length, 0.0).value;
  }
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i)
    links.push_back({mechanism.springs[i].name, {true, i}, {}});
  return links;
}

RodLink read_link(TableReader& table, const std::vector<NamedLink>& links, RodInput& rod) {
  const std::string name = table.text(link_key());
  std::vector<std::string> names;
  for (const NamedLink& link : links) {
    if (link.name == name) {
      rod.length = si<Length>(link.length.value_or(0.0));
      return link.link;
    }
    names.push_back(link.name);
  }
  if (!name.empty())
    table.problem(
        link_key().name,
        fmt::format("no joint of kind \"distance\", driven length or spring is \"{}\"", name),
        unknown_hint(name, names));
  return {};
}

template <class Ends, class Mechanism>
void read_place(TableReader& table, const Mechanism& mechanism, RodInput& rod) {
  const bool one = table.says_one_of({{{"from", "to"}}, {{"link"}}});
  const bool linked = table.has(link_key());
  if (linked && !one)
    table.problem(link_key().name,
                  "a rod is a link or lies between two points of a body, and not both",
                  "remove \"link\", or \"from\" and \"to\"");
  if (linked)
    rod.place = read_link(table, links_in(mechanism), rod);
  else
    rod.place = read_rod_ends<Ends>(table, mechanism, rod);
}

/// The thickest wall of a section, whose strength is the lowest.
Length thickest_wall_of(const Section& section) {
  Length thickest;
  const auto look = [&](const Profile& profile) {
    const Length half = 0.5 * height_of(profile);
    thickest = std::max(
        {thickest, wall_at(profile, Length{}), wall_at(profile, half), wall_at(profile, -half)});
  };
  look(section.outer);
  if (section.inner) look(*section.inner);
  return thickest;
}

/// Of a rod that is a body in space, where its section's z points in that body, if it is said.
std::optional<Eigen::Vector3d> read_direction(TableReader& table, const RodInput& rod) {
  const auto* const ends = std::get_if<SpatialRod>(&rod.place);
  const Key key{"z",
                "of its section in its body, in space, for how it bends; needed where the section "
                "is not alike about both axes"};
  if (ends == nullptr || !table.has(key)) return std::nullopt;
  const Eigen::Vector3d z = table.direction(key);
  const Eigen::Vector3d line = ends->to.p - ends->from.p;
  constexpr double hardly_across = 0.01;
  if (line.norm() > 0.0 && z.cross(line).norm() < hardly_across * line.norm())
    table.problem("z", "the section's z stands across the rod",
                  "choose a direction across the line from \"from\" to \"to\", in the axes of "
                  "its body");
  return z;
}

}  // namespace

RodInput read_rod(TableReader table, const Sections& sections, const Project& project,
                  std::optional<Eigen::Vector3d>& z) {
  RodInput rod;
  rod.name = table.text({"name", "of the rod"});
  const std::size_t before_place = table.problems().size();
  if (project.in_space)
    read_place<SpatialRod>(table, spatial_of(project), rod);
  else
    read_place<PlanarRod>(table, planar_of(project), rod);
  z = read_direction(table, rod);
  const std::size_t before = table.problems().size();
  rod.section = named_section(table, {"section", "of the rod"}, sections);
  const Key buckling{"buckling_length",
                     "against flexural buckling; their distance where not said and it does not "
                     "change"};
  const bool known = rod.length > Length{};
  const bool placed = table.problems().size() == before_place;
  if (!known && placed && std::holds_alternative<RodLink>(rod.place) && !table.has(buckling))
    table.problem(buckling.name, "the length of the rod changes as it moves",
                  "write buckling_length, its largest");
  rod.buckling_length =
      si<Length>(table.positive(buckling, wanted::length, known ? rod.length.value() : 1.0));
  if (!known) rod.length = rod.buckling_length;
  constexpr std::array curves{BucklingCurve::a0, BucklingCurve::a, BucklingCurve::b,
                              BucklingCurve::c, BucklingCurve::d};
  rod.curve =
      curves[table.choice({"curve", "of EN 1993-1-1, table 6.1"}, {"a0", "a", "b", "c", "d"})];
  rod.gamma_M0 = table.number({"gamma_M0", "on yielding"}, project.strength.gamma_M0);
  rod.gamma_M1 = table.number({"gamma_M1", "on buckling"}, project.strength.gamma_M1);
  rod.gamma_M2 = table.number({"gamma_M2", "on the net section"}, project.strength.gamma_M2);
  rod.required = table.number({"required", "wanted safety factor"}, project.strength.required);
  if (table.has("net_area"))
    rod.net_area = si<Area>(table.positive(
        {"net_area",
         "least area between its ends, holes for fasteners taken out; the whole where it has none"},
        wanted::area));
  const Material steel =
      steel_of(table, {"steel", "of the rod; that of the beam where not said"}, project);
  if (table.problems().size() == before && table.problems().empty()) {
    const Length wall = thickest_wall_of(rod.section);
    if (const auto* const ends = std::get_if<PlanarRod>(&rod.place))
      check_rod_ends(table, *ends, planar_of(project), project);
    if (const auto* const ends = std::get_if<SpatialRod>(&rod.place))
      check_rod_ends(table, *ends, spatial_of(project), project);
    rod.yield_strength = strength_at(table, "section", steel, yield_strength_of, wall);
    rod.tensile_strength = strength_at(table, "section", steel, tensile_strength_of, wall);
    const Area whole = properties_of(rod.section).area;
    if (rod.net_area && *rod.net_area > whole * (1.0 + 1e-12)) {
      table.problem("net_area",
                    fmt::format("the net area is larger than the whole section, {:.6g} mm^2",
                                whole.value() * 1e6),
                    "write the section's area less the holes for fasteners");
    }
  }
  table.finish();
  return rod;
}

}  // namespace boxbeam::readers
