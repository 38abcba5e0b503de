#include "boxbeam/section/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

Length between(Length a, Length b, double fraction) { return a + (b - a) * fraction; }

Profile between(const Profile& a, const Profile& b, double fraction) {
  if (const auto* box = std::get_if<HollowRectangle>(&a)) {
    const auto& to = std::get<HollowRectangle>(b);
    return HollowRectangle{
        between(box->width, to.width, fraction), between(box->height, to.height, fraction),
        between(box->flange, to.flange, fraction), between(box->web, to.web, fraction)};
  }
  const auto& tube = std::get<RoundTube>(a);
  const auto& to = std::get<RoundTube>(b);
  return RoundTube{between(tube.diameter, to.diameter, fraction),
                   between(tube.wall, to.wall, fraction)};
}

std::string mm(Length x) { return fmt::format("{:.6g} mm", x.value() * 1e3); }

std::optional<std::string> defect_of(const Profile& profile) {
  const Length zero;
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    if (box->width <= zero || box->height <= zero) return "width and height must be above zero";
    if (box->flange <= zero || box->web <= zero) return "every plate thickness must be above zero";
    if (2.0 * box->flange >= box->height) {
      return fmt::format("two flanges of {} leave no clear height in {}", mm(box->flange),
                         mm(box->height));
    }
    if (2.0 * box->web >= box->width) {
      return fmt::format("two webs of {} leave no clear width in {}", mm(box->web), mm(box->width));
    }
    return std::nullopt;
  }
  const auto& tube = std::get<RoundTube>(profile);
  if (tube.diameter <= zero || tube.wall <= zero) return "diameter and wall must be above zero";
  if (2.0 * tube.wall >= tube.diameter) {
    return fmt::format("a wall of {} leaves no hollow in a diameter of {}", mm(tube.wall),
                       mm(tube.diameter));
  }
  return std::nullopt;
}

struct Extent {
  Length y, z;
};

Extent outside_of(const Profile& profile) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) return {box->width, box->height};
  const auto& tube = std::get<RoundTube>(profile);
  return {tube.diameter, tube.diameter};
}

std::optional<std::string> misfit_of(const Profile& outer, const Profile& inner) {
  // A profile that fits exactly must not be refused for the round-off of two subtractions.
  const Length slack = 1e-12 * metre;
  const Extent needs = outside_of(inner);
  if (const auto* box = std::get_if<HollowRectangle>(&outer)) {
    const Length clear_width = box->width - 2.0 * box->web;
    const Length clear_height = box->height - 2.0 * box->flange;
    if (needs.y <= clear_width + slack && needs.z <= clear_height + slack) return std::nullopt;
    return fmt::format(
        "the inner profile, {} x {}, does not fit the clear {} x {} of the outer one", mm(needs.y),
        mm(needs.z), mm(clear_width), mm(clear_height));
  }
  const auto& tube = std::get<RoundTube>(outer);
  const Length clear = tube.diameter - 2.0 * tube.wall;
  const bool round = std::holds_alternative<RoundTube>(inner);
  const double reach = round ? needs.y.value() : std::hypot(needs.y.value(), needs.z.value());
  if (reach <= (clear + slack).value()) return std::nullopt;
  return fmt::format("the inner profile needs {} and does not fit the clear diameter {}",
                     mm(si<Length>(reach)), mm(clear));
}

}  // namespace

Section interpolate(const Section& from, const Section& to, double fraction) {
  Section section{between(from.outer, to.outer, fraction), std::nullopt};
  if (from.inner) section.inner = between(*from.inner, *to.inner, fraction);
  return section;
}

bool same_kind(const Section& a, const Section& b) {
  if (a.outer.index() != b.outer.index() || a.inner.has_value() != b.inner.has_value())
    return false;
  return !a.inner || a.inner->index() == b.inner->index();
}

std::optional<std::string> defect_of(const Section& section) {
  if (auto defect = defect_of(section.outer)) return defect;
  if (!section.inner) return std::nullopt;
  if (auto defect = defect_of(*section.inner)) return "inner profile: " + *defect;
  return misfit_of(section.outer, *section.inner);
}

Length height_of(const Profile& profile) { return outside_of(profile).z; }

Length half_clear_height(const Profile& profile) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    return 0.5 * box->height - box->flange;
  }
  const auto& tube = std::get<RoundTube>(profile);
  return 0.5 * tube.diameter - tube.wall;
}

Length wall_at(const Profile& profile, Length z) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    return abs(z) > half_clear_height(profile) ? box->flange : box->web;
  }
  return std::get<RoundTube>(profile).wall;
}

}  // namespace boxbeam
