#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "boxbeam/project/detail_reader.hpp"
#include "boxbeam/project/sn_catalogue.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// The strength of a steel at a thickness, a problem where it has none.
Stress strength_at(TableReader& table, std::string_view key, const Material& material,
                   std::optional<Stress> (*strength_of)(const Material&, Length),
                   Length thickness) {
  if (material.steps.empty() || !table.problems().empty()) return {};
  if (const auto strength = strength_of(material, thickness)) return *strength;
  table.problem(
      key,
      fmt::format("{} has no strength for a thickness of {:.6g} mm", material.name,
                  thickness.value() * 1e3),
      fmt::format("its table ends at {:.6g} mm", material.steps.back().up_to.value() * 1e3));
  return {};
}

/// The steel under a key, or that of the beam where it is of one.
Material steel_of(TableReader& table, const Key& key, const Project& project) {
  if (table.has(key)) return named_steel(table, key);
  if (!project.part_materials.empty()) {
    table.problem(key.name, "the beam is of several materials: which of them this is, is not said",
                  fmt::format("write {} = \"{}\"", key.name, project.material.name));
  }
  return project.material;
}

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

/// Whether a joint in space turns about the pin in it, and whether it keeps an axis for it.
bool turns_about_pin(const spatial::Mechanism& mechanism, int joint) {
  const auto index = static_cast<std::size_t>(joint);
  // Where there is no joint that has been said already.
  if (index >= mechanism.joints.size() + mechanism.closing.size()) return true;
  if (index < mechanism.joints.size())
    return mechanism.joints[index].kind == spatial::JointKind::revolute;
  const spatial::ClosingKind kind = mechanism.closing[index - mechanism.joints.size()].kind;
  return kind == spatial::ClosingKind::revolute || kind == spatial::ClosingKind::cylindrical;
}

bool may_have_pin(const spatial::Mechanism& mechanism, int joint) {
  const auto index = static_cast<std::size_t>(joint);
  if (turns_about_pin(mechanism, joint)) return true;
  if (index < mechanism.joints.size()) return false;
  const spatial::ClosingKind kind = mechanism.closing[index - mechanism.joints.size()].kind;
  return kind == spatial::ClosingKind::spherical || kind == spatial::ClosingKind::distance;
}

/// The joint of a pin: in space behind those that carry bodies those that close loops.
int joint_of_pin(TableReader& table, const Project& project) {
  const Key key{"joint", "in which it is"};
  if (!project.in_space) return joint_of(table, key, planar_of(project));
  const spatial::Mechanism& mechanism = spatial_of(project);
  const std::string name = table.text(key);
  if (name.empty()) return 0;
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
  if (!may_have_pin(mechanism, joint))
    table.problem(key.name, fmt::format("joint \"{}\" does not turn about a pin", name),
                  "a pin is in a joint of kind \"revolute\", \"cylindrical\", \"spherical\" or "
                  "\"distance\"");
  return joint;
}

PinInput read_pin(TableReader table, const Project& project) {
  PinInput pin;
  pin.name = table.text({"name", "of the pin"});
  pin.joint = joint_of_pin(table, project);
  PinJoint& geometry = pin.geometry;
  geometry.diameter = si<Length>(table.positive({"diameter", "of the pin"}, wanted::length));
  geometry.hole = si<Length>(
      table.positive({"hole", "of its hole"}, wanted::length, geometry.diameter.value()));
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
  strength.gamma_M2 = table.number({"gamma_M2", "on shear"}, strength.gamma_M2);
  pin.replaceable = table.boolean({"replaceable",
                                   "to be taken out in service, whose limits it keeps as well, "
                                   "without load factors (3.13.2(3))"},
                                  false);
  pin.required = table.number({"required", "wanted safety factor"}, project.strength.required);
  for (TableReader& of : table.tables(
           {"lugs", "its plates, checked beside and before the hole and there in fatigue"})) {
    LugInput lug = read_lug(of, pin);
    if (project.in_space && !turns_about_pin(spatial_of(project), pin.joint))
      of.problem("plate",
                 "the joint of the pin keeps no axis, so that the way in which it pulls at its "
                 "plates is not known",
                 "of lugs the pin is in a joint of kind \"revolute\" or \"cylindrical\"");
    if (std::any_of(pin.lugs.begin(), pin.lugs.end(),
                    [&](const LugInput& other) { return other.inner == lug.inner; }))
      of.problem("plate", "this plate is there already", "write \"inner\" and \"outer\" once each");
    pin.lugs.push_back(std::move(lug));
  }
  table.finish();
  return pin;
}

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

RodInput read_rod(TableReader table, const Sections& sections, const Project& project,
                  std::optional<Eigen::Vector3d>& z) {
  RodInput rod;
  rod.name = table.text({"name", "of the rod"});
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
  if (!known && std::holds_alternative<RodLink>(rod.place) && !table.has(buckling))
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

}  // namespace

std::vector<std::optional<Eigen::Vector3d>> read_neighbours(TableReader& root,
                                                            const Sections& sections,
                                                            Project& project) {
  std::vector<std::optional<Eigen::Vector3d>> directions;
  const auto check_own_name = [](TableReader& table, const auto& others, const auto& item) {
    if (std::any_of(others.begin(), others.end(),
                    [&](const auto& other) { return other.name == item.name; })) {
      table.problem("name", fmt::format("\"{}\" is there already", item.name),
                    "give each a name of its own");
    }
  };
  for (TableReader& table : root.tables({"pins", "pins, checked for shear, bearing and bending"})) {
    PinInput pin = read_pin(table, project);
    check_own_name(table, project.pins, pin);
    project.pins.push_back(std::move(pin));
  }
  for (TableReader& table :
       root.tables({"rods", "rods between two points, checked in tension and compression"})) {
    RodInput rod = read_rod(table, sections, project, directions.emplace_back());
    check_own_name(table, project.rods, rod);
    project.rods.push_back(std::move(rod));
  }
  read_deflection_of(root, project);
  return directions;
}

}  // namespace boxbeam::readers
