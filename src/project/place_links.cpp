#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "link_draft.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector2d;
using flexible::Link;

const BodyPoint* find_point(const Link& link, const std::string& name) {
  const int index = index_by_name(link.points, name);
  return index < 0 ? nullptr : &link.points[static_cast<std::size_t>(index)];
}

/// The link that a place refers to, nothing for the world or, with a problem, where there is none.
const LinkDraft* link_of(TableReader& table, const WrittenPlace& place,
                         const std::vector<LinkDraft>& drafts) {
  if (place.reference.empty()) return nullptr;
  const std::size_t dot = place.reference.rfind('.');
  const std::string name = place.reference.substr(0, dot);
  std::vector<std::string> names;
  for (const LinkDraft& draft : drafts) {
    if (draft.link.name == name && dot != std::string::npos) return &draft;
    names.push_back(draft.link.name);
  }
  if (dot == std::string::npos) {
    table.problem(place.key, fmt::format("\"{}\" is not a point of a link", place.reference),
                  "write \"link.point\", or [x, y] of the world");
  } else {
    table.problem(place.key, fmt::format("there is no link \"{}\"", name),
                  unknown_hint(name, names));
  }
  return nullptr;
}

/// Where a place of a link that is placed lies in the world.
Vector2d world_of(TableReader& table, const WrittenPlace& place, const LinkDraft* of) {
  if (of == nullptr) return place.world;
  const std::string name = place.reference.substr(place.reference.rfind('.') + 1);
  const BodyPoint* point = find_point(of->link, name);
  if (point == nullptr) {
    table.problem(place.key, fmt::format("link \"{}\" has no point \"{}\"", of->link.name, name),
                  unknown_hint(name, names_of(of->link.points)));
    return Vector2d::Constant(std::nan(""));
  }
  return of->link.origin + Eigen::Rotation2Dd(of->link.angle) * point->p;
}

/// Places a link whose references are placed.
void place(LinkDraft& draft, const LinkDraft* at, const LinkDraft* to) {
  Link& link = draft.link;
  const Placing& placing = draft.placing;
  draft.placed = true;
  const Vector2d here = world_of(draft.table, placing.at, at);
  if (placing.to) {
    const Vector2d along = world_of(draft.table, *placing.to, to) - here;
    const double length = along.norm();
    if (length == 0.0) {
      draft.table.problem("to", "the link has no length: both ends are at one place",
                          "name two places apart");
      return;
    }
    link.origin = here;
    link.angle = std::atan2(along.y(), along.x());
    if (draft.lump) return;
    if (draft.length && std::abs(*draft.length - length) > agreement * length) {
      draft.table.problem("to",
                          fmt::format("the link is {:.9g} m long, its ends lie {:.9g} m apart",
                                      *draft.length, length),
                          "change its length, or place it by \"origin\" and \"angle\"");
    }
    if (!draft.length) take_length(draft, length);
    return;
  }
  link.angle = placing.angle;
  link.origin = here;
  if (placing.own_point.empty()) return;
  const BodyPoint* own = find_point(link, placing.own_point);
  if (own == nullptr) {
    draft.table.problem(
        "place", fmt::format("link \"{}\" has no point \"{}\"", link.name, placing.own_point),
        unknown_hint(placing.own_point, names_of(link.points)));
    return;
  }
  link.origin -= Eigen::Rotation2Dd(link.angle) * own->p;
}

}  // namespace

void take_length(LinkDraft& draft, double length) {
  Link& link = draft.link;
  draft.length = length;
  link.length = length;
  for (BodyPoint& point : link.points) {
    const double s = point.p.x();
    if (!std::isfinite(length)) break;
    if (s < -agreement * length || s > (1.0 + agreement) * length) {
      draft.table.table("points").problem(
          point.name, fmt::format("point \"{}\" lies off the link, at s = {:.6g} m", point.name, s),
          fmt::format("s goes from 0 to {:.6g} m", length));
    }
    point.p.x() = std::clamp(s, 0.0, length);
  }
  for (const auto& [name, s] : {std::pair{"start", 0.0}, {"end", length}}) {
    if (find_point(link, name) == nullptr) {
      link.points.push_back({name, {s, 0.0}});
    } else {
      draft.table.table("points").problem(
          name, fmt::format("\"{}\" is the {} of the link by itself", name, name),
          "give the point another name");
    }
  }
}

void place_all(std::vector<LinkDraft>& drafts) {
  const std::size_t before = drafts.front().table.problems().size();
  for (bool more = true; more;) {
    more = false;
    for (LinkDraft& draft : drafts) {
      if (draft.placed) continue;
      const LinkDraft* at = link_of(draft.table, draft.placing.at, drafts);
      const LinkDraft* to =
          draft.placing.to ? link_of(draft.table, *draft.placing.to, drafts) : nullptr;
      if (draft.table.problems().size() != before) return;
      if ((at != nullptr && !at->placed) || (to != nullptr && !to->placed)) continue;
      place(draft, at, to);
      if (draft.table.problems().size() != before) return;
      more = true;
    }
  }
  for (LinkDraft& draft : drafts) {
    if (draft.placed) continue;
    draft.table.problem(
        draft.placing.at.key,
        fmt::format("link \"{}\" is placed by links that are placed by it", draft.link.name),
        "place one of them in the world: origin = [\"0 m\", \"0 m\"]");
    return;
  }
}

}  // namespace boxbeam::readers
