#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/project/limits.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "link_draft.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector2d;
using flexible::Link;
using flexible::LinkKind;
using flexible::LinkStretch;

WrittenPlace read_written_place(TableReader& table, const Key& key) {
  WrittenPlace place{key.name, "", Vector2d::Zero()};
  if (table.is_list(key.name))
    place.world = table.pair(key, wanted::length);
  else
    place.reference = table.text(key);
  return place;
}

Placing read_placing(TableReader& table) {
  Placing placing;
  if (!table.says_one_of({{{"origin"}}, {{"place"}}, {{"from", "to"}}})) {
    for (const char* key : {"angle", "to"}) static_cast<void>(table.has(key));
    table.problem("",
                  fmt::format("[{}] wants one of \"origin\", \"place\" and \"from\"", table.name()),
                  "origin = [\"0 m\", \"0 m\"] or \"link.point\" with \"angle\"; place = { point = "
                  "\"its own\", at = \"link.point\" } with \"angle\"; or \"from\" and \"to\"");
    return placing;
  }
  if (table.has("from")) {
    placing.at =
        read_written_place(table, {"from", "where its start lies: a place, or \"link.point\""});
    placing.to = read_written_place(table, {"to", "where its end lies"});
    return placing;
  }
  placing.angle = table.quantity({"angle", "of its axis"}, wanted::angle, 0.0);
  if (table.has("origin")) {
    placing.at =
        read_written_place(table, {"origin", "where its start lies: a place, or \"link.point\""});
    return placing;
  }
  TableReader own = table.table({"place", "by a point of its own"});
  placing.own_point = own.text({"point", "the link's point"});
  placing.at = read_written_place(own, {"at", "where that lies: a place, or \"link.point\""});
  placing.at.key = "place";
  own.finish();
  return placing;
}

void read_link_points(TableReader& table, Link& link) {
  TableReader points = table.table({"points", "along its axis and to its left, by name"}, false);
  points.accept_all();
  for (const Node::Member& member :
       points.members("s along the axis, and the distance to its left")) {
    link.points.push_back(
        {member.key,
         points.pair_in(member.value, fmt::format("point \"{}\"", member.key), wanted::length)});
  }
}

/// The stiffness of a link that is given as such, the same over its length.
void read_stiffness(LinkDraft& draft) {
  TableReader& table = draft.table;
  const LinkKind kind = draft.link.kind;
  const bool bends = kind == LinkKind::bending || kind == LinkKind::full;
  const auto value = [&](const Key& key, const WantedDimension& wanted, bool required) {
    return table.positive(key, wanted, required ? std::nullopt : std::optional(1.0));
  };
  // A bending link tells its EA as well: whether that may be left out is to be weighed.
  draft.stiffness.EA.c[0] =
      value({"EA", "axial stiffness"}, wanted::force, kind != LinkKind::rigid);
  draft.stiffness.GA.c[0] = value({"GA", "shear stiffness"}, wanted::force, bends);
  draft.stiffness.EI.c[0] = value({"EI", "bending stiffness"}, wanted::bending_stiffness, bends);
  draft.stiffness.mass.c[0] =
      table.not_negative({"mass_per_length", "of the link"}, wanted::line_mass);
}

/// Two sections between which a link tapers, or one.
void read_ends(TableReader& table, const Sections& sections, Segment& segment) {
  if (table.has("section")) {
    segment.from = segment.to = named_section(table, {"section", "constant section"}, sections);
    return;
  }
  const std::vector<std::string> names =
      table.texts({"sections", "a taper between two sections"}, true);
  if (names.size() != 2) {
    table.problem("sections", "a taper goes from one section to another",
                  "write sections = [\"A1\", \"A2\"], or one \"section\"");
    return;
  }
  segment.from = section_called(table, "sections", names[0], sections);
  segment.to = section_called(table, "sections", names[1], sections);
  const bool both_known = !defect_of(segment.from) && !defect_of(segment.to);
  if (both_known && !same_kind(segment.from, segment.to)) {
    table.problem("sections", "a link tapers between two sections of the same kind",
                  "write its \"segments\", split where the kind of section changes");
  }
}

void read_section_profile(LinkDraft& draft, const LinkDefaults& defaults) {
  TableReader& table = draft.table;
  TaperedBeam& profile = draft.profile;
  profile.density =
      table.has("density")
          ? si<Density>(table.positive(
                {"density", "of its material; that of the beam where not said"}, wanted::density))
          : defaults.beam->density;
  profile.rotary_inertia =
      table.boolean({"rotary_inertia", "the sections' own rotary inertia counts"}, false);
  draft.youngs_modulus = table.positive({"youngs_modulus", "of the link"}, wanted::stress,
                                        defaults.model->youngs_modulus);
  draft.shear_modulus = table.positive({"shear_modulus", "of the link"}, wanted::stress,
                                       defaults.model->shear_modulus);
  draft.extra_mass = table.not_negative({"extra_mass", "beside its own"}, wanted::line_mass, 0.0);
  if (!table.has("segments")) {
    profile.segments.emplace_back().name = "1";
    read_ends(table, *defaults.sections, profile.segments.front());
    return;
  }
  Length start;
  for (TableReader& segment : table.tables({"segments", "constant or tapered"}, true)) {
    profile.segments.push_back(
        read_segment(segment, profile.segments.size() + 1, start, *defaults.sections));
    start = profile.segments.back().end();
  }
  if (profile.segments.empty()) {
    table.problem("segments", "the link has no segment",
                  fmt::format("write at least one [[{}.segments]]", table.name()));
    return;
  }
  draft.length = start.value();
}

/// The beam that a link is, nullptr where it is none.
const TaperedBeam* beam_of(const std::string& link, const LinkDefaults& defaults) {
  if (link == defaults.beam_link) return defaults.beam;
  for (const auto& [name, beam] : defaults.other_beams) {
    if (name == link) return &beam;
  }
  return nullptr;
}

/// What a link is along its length, by one of the ways to write it.
void read_profile(LinkDraft& draft, const LinkDefaults& defaults) {
  TableReader& table = draft.table;
  const auto ways_in = [&](std::initializer_list<const char*> keys) {
    return std::count_if(keys.begin(), keys.end(), [&](const char* key) { return table.has(key); });
  };
  if (const TaperedBeam* const beam = beam_of(draft.link.name, defaults)) {
    for (const char* key : {"section", "sections", "segments", "EA", "GA", "EI", "mass_per_length",
                            "extra_mass", "density", "youngs_modulus", "shear_modulus",
                            "rotary_inertia", "mass", "inertia", "centre"}) {
      if (!table.has_misplaced(key)) continue;
      table.problem(key,
                    fmt::format("mass and stiffness of the beam come from the sections of [beam]; "
                                "\"{}\" has no place here",
                                key),
                    "remove this line");
      table.accept_all();
    }
    draft.profile = *beam;
    draft.youngs_modulus = defaults.model->youngs_modulus;
    draft.shear_modulus = defaults.model->shear_modulus;
    const bool none = draft.profile.segments.empty();
    draft.length = none ? std::nan("") : draft.profile.length().value();
    return;
  }
  const auto by_stiffness = ways_in({"EA", "GA", "EI", "mass_per_length"});
  const auto ways = ways_in({"section", "sections", "segments"}) + (by_stiffness > 0 ? 1 : 0);
  if (draft.link.kind == LinkKind::rigid && ways == 0) {
    draft.lump = true;
    draft.link.rigid.mass = table.not_negative({"mass", "of a rigid link"}, wanted::mass);
    draft.link.rigid.inertia =
        table.not_negative({"inertia", "of a rigid link, about its centre"}, wanted::inertia, 0.0);
    draft.link.rigid.centre =
        table.pair({"centre", "of a rigid link"}, wanted::length, Vector2d::Zero());
    if (draft.link.rigid.mass == 0.0 && draft.link.rigid.inertia > 0.0) {
      table.problem("inertia", "a link with inertia has a mass", "write \"mass\" above zero");
    }
    return;
  }
  if (ways != 1) {
    table.accept_all();
    table.problem(
        "",
        fmt::format("[{}] wants one of \"section\", \"sections\", \"segments\" and "
                    "\"EA\"",
                    table.name()),
        "section = \"A1\" for a constant one, sections = [\"A1\", \"A2\"] for a taper, or "
        "EA, GA, EI and mass_per_length");
    return;
  }
  if (by_stiffness > 0)
    read_stiffness(draft);
  else
    read_section_profile(draft, defaults);
}

/// The length as written, which must be that of the segments where there are some.
void read_length(LinkDraft& draft) {
  TableReader& table = draft.table;
  if (draft.lump) return;
  if (!table.has("length")) {
    if (!draft.length && !draft.placing.to && table.problems().empty()) {
      table.problem("", fmt::format("[{}] has no \"length\"", table.name()),
                    "write length = \"4.2 m\"");
    }
    return;
  }
  const double length = table.positive({"length", "of the link"}, wanted::length);
  if (draft.length && std::abs(*draft.length - length) > agreement * length) {
    table.problem("length",
                  fmt::format("the segments of the link are {:.6g} m long", *draft.length),
                  "write that length, or leave it out");
  }
  if (!draft.length) draft.length = length;
}

LinkDraft read_draft(const std::string& name, const TableReader& table,
                     const LinkDefaults& defaults) {
  LinkDraft draft{table};
  TableReader& reader = draft.table;
  Link& link = draft.link;
  link.name = name;
  const std::size_t before = reader.problems().size();
  if (name == "ground" || name == "world" || name.empty()) {
    reader.problem("",
                   name.empty() ? std::string("a link has a name")
                                : fmt::format("\"{}\" is the world and no link", name),
                   "give the link another name");
  }
  constexpr LinkKind kinds[] = {LinkKind::rigid, LinkKind::bending, LinkKind::axial,
                                LinkKind::full};
  const std::size_t before_kind = reader.problems().size();
  link.kind = kinds[reader.kind({"kind", "what deforms"}, {"rigid", "bending", "axial", "full"})];
  if (reader.problems().size() != before_kind) {  // what its other keys mean is not known
    reader.accept_all();
    return draft;
  }
  read_link_points(reader, link);
  draft.placing = read_placing(reader);
  read_profile(draft, defaults);
  read_length(draft);
  link.parts = reader.whole_number({"parts", "rigid elements of a link"}, link.parts);
  if (link.parts < 1 || link.parts > limits::most_parts) {
    reader.problem("parts", fmt::format("a link has 1 to {} parts", limits::most_parts),
                   "write for example parts = 16");
  }
  link.retardation = read_retardation(reader, defaults.model->retardation);
  if (reader.problems().size() == before && draft.length) take_length(draft, *draft.length);
  reader.finish();
  return draft;
}

/// Stiffness and mass along a link whose length is known.
void lay_out(LinkDraft& draft) {
  Link& link = draft.link;
  if (draft.lump) return;
  if (draft.profile.segments.empty()) {
    draft.stiffness.length = link.length;
    link.stretches = {draft.stiffness};
  } else {
    if (draft.profile.segments.size() == 1) {
      draft.profile.segments.front().length = si<Length>(link.length);
    }
    link.stretches = link_stretches_of(draft.profile, draft.youngs_modulus, draft.shear_modulus);
    for (LinkStretch& stretch : link.stretches) stretch.mass.c[0] += draft.extra_mass;
  }
  if (link.kind != LinkKind::rigid) return;
  link.kind = LinkKind::full;  // as whose mass it is summed up
  link.rigid = flexible::rigid_mass_of(link);
  link.kind = LinkKind::rigid;
  link.stretches.clear();
}

}  // namespace

std::vector<Link> read_links(TableReader& root, const LinkDefaults& defaults) {
  std::vector<LinkDraft> drafts;
  const std::size_t before = root.problems().size();
  for (auto& [name, table] : root.table({"links", "elastic or rigid links"}).named_tables()) {
    drafts.push_back(read_draft(name, table, defaults));
  }
  if (root.problems().size() == before && drafts.empty()) {
    root.problem("links", "the mechanism has no link", "write at least one [links.<name>]");
  }
  int parts = 0;
  for (const LinkDraft& draft : drafts) parts += draft.link.parts;
  if (root.problems().size() == before && parts > limits::most_parts_of_all) {
    root.problem("links", fmt::format("the links have {} parts in all", parts),
                 fmt::format("at most {} are possible; 16 a link leave below a thousandth of the "
                             "first frequencies",
                             limits::most_parts_of_all));
  }
  if (root.problems().size() == before && !drafts.empty()) place_all(drafts);
  std::vector<Link> links;
  for (LinkDraft& draft : drafts) {
    if (root.problems().empty()) lay_out(draft);
    links.push_back(std::move(draft.link));
  }
  return links;
}

}  // namespace boxbeam::readers
