#include "boxbeam/section/section_properties.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace boxbeam {
namespace {

/// A symmetric section's round-off is no eccentricity.
double without_round_off(double value, double scale) {
  return std::abs(value) < 1e-14 * scale ? 0.0 : value;
}

SectionProperties properties_of(const AreaSums& sums, const Extent& extent) {
  const double width = (extent.y_high - extent.y_low).value();
  const double height = (extent.z_high - extent.z_low).value();
  const double y = without_round_off(sums.y / sums.area, width);
  const double z = without_round_off(sums.z / sums.area, height);
  const double I_y = sums.zz - sums.area * z * z;
  const double I_z = sums.yy - sums.area * y * y;
  const double I_yz = without_round_off(sums.yz - sums.area * y * z, std::max(I_y, I_z));
  const double mean = 0.5 * (I_y + I_z);
  const double radius = std::hypot(0.5 * (I_y - I_z), I_yz);
  SectionProperties result;
  result.area = si<Area>(sums.area);
  result.centroid_y = si<Length>(y);
  result.centroid_z = si<Length>(z);
  result.I_y = si<SecondMoment>(I_y);
  result.I_z = si<SecondMoment>(I_z);
  result.I_yz = si<SecondMoment>(I_yz);
  result.I_1 = si<SecondMoment>(mean + radius);
  result.I_2 = si<SecondMoment>(mean - radius);
  result.principal_angle =
      I_yz == 0.0 && I_y >= I_z ? 0.0 : 0.5 * std::atan2(-2.0 * I_yz, I_y - I_z);
  result.y_left = extent.y_high;
  result.y_right = extent.y_low;
  result.z_top = extent.z_high;
  result.z_bottom = extent.z_low;
  const auto farther = [](Length high, Length low, double centroid) {
    return std::max(high.value() - centroid, centroid - low.value());
  };
  result.W_y = si<SectionModulus>(I_y / farther(extent.z_high, extent.z_low, z));
  result.W_z = si<SectionModulus>(I_z / farther(extent.y_high, extent.y_low, y));
  return result;
}

/// The clear space inside a box or tube, between webs and between flanges.
struct Inside {
  double right, left, bottom, top;
};

/// A strip along a plate, between two places across the section.
struct Strip {
  double low = 0.0, high = 0.0;

  bool empty() const { return low >= high; }
};

/// The middle of a plate that is left out where only a part of it counts.
Strip idle_strip(double low, double high, double part) {
  const double middle = 0.5 * (low + high);
  const double half = 0.5 * (1.0 - part) * (high - low);
  return {middle - half, middle + half};
}

/// The strips of flanges and webs that are left out.
struct IdleStrips {
  Strip flanges, webs;
};

/// The profile with what of its stiffeners stands beside the strips.
Profile without_idle_stiffeners(Profile profile, const IdleStrips& idle) {
  auto* box = std::get_if<Box>(&profile);
  if (box == nullptr) return profile;
  std::vector<Stiffener> left;
  for (const Stiffener& bar : box->stiffeners) {
    const bool on_flange =
        bar.plate == BoxPlate::top_flange || bar.plate == BoxPlate::bottom_flange;
    const Strip& strip = on_flange ? idle.flanges : idle.webs;
    const double low = (bar.place - 0.5 * bar.thickness).value();
    const double high = (bar.place + 0.5 * bar.thickness).value();
    const auto keep = [&](double from, double to) {
      if (from >= to) return;
      Stiffener part = bar;
      part.place = si<Length>(0.5 * (from + to));
      part.thickness = si<Length>(to - from);
      left.push_back(part);
    };
    if (strip.empty() || strip.low >= high || strip.high <= low) {
      left.push_back(bar);
      continue;
    }
    keep(low, strip.low);
    keep(strip.high, high);
  }
  box->stiffeners = std::move(left);
  return profile;
}

/// The pieces of an idle strip that no hole of its walls has taken already.
std::vector<std::pair<double, double>> pieces_of(const Strip& strip, HoleWalls walls,
                                                 const std::vector<Hole>& holes) {
  std::vector<std::pair<double, double>> pieces;
  if (!strip.empty()) pieces.emplace_back(strip.low, strip.high);
  const auto take_out = [&](double middle, double half) {
    std::vector<std::pair<double, double>> left;
    for (const auto& [low, high] : pieces) {
      if (std::min(high, middle - half) > low)
        left.emplace_back(low, std::min(high, middle - half));
      if (std::max(low, middle + half) < high)
        left.emplace_back(std::max(low, middle + half), high);
    }
    pieces = std::move(left);
  };
  for (const Hole& hole : holes) {
    if (hole.walls != walls) continue;
    take_out(hole.position.value(), 0.5 * hole.diameter.value());
    if (walls == HoleWalls::flanges) take_out(-hole.position.value(), 0.5 * hole.diameter.value());
  }
  return pieces;
}

std::optional<Inside> inside_of(const Profile& profile) {
  const double bottom = clear_bottom_of(profile).value(), top = clear_top_of(profile).value();
  if (const auto* box = std::get_if<Box>(&profile)) {
    return Inside{(box->right_web - 0.5 * box->width).value(),
                  (0.5 * box->width - box->left_web).value(), bottom, top};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double left = (0.5 * tube->width - tube->wall).value();
    return Inside{-left, left, bottom, top};
  }
  return std::nullopt;
}

}  // namespace

SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes) {
  return properties_of(sums_of(outline_of(section, holes)), extent_of(section.outer));
}

SectionProperties properties_of(const Section& section) { return properties_of(section, {}); }

SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes,
                                double flange_part, double web_part) {
  assert(flange_part > 0.0 && flange_part <= 1.0);
  assert(web_part > 0.0 && web_part <= 1.0);
  const auto inside = inside_of(section.outer);
  if (!inside) return properties_of(section, holes);
  const IdleStrips idle{idle_strip(inside->right, inside->left, flange_part),
                        idle_strip(inside->bottom, inside->top, web_part)};
  Outline outline =
      outline_of(Section{without_idle_stiffeners(section.outer, idle), section.inner}, holes);
  const Extent extent = extent_of(section.outer);
  const auto take_out = [&](double y_low, double y_high, double z_low, double z_high) {
    add_rectangle(outline, y_low, y_high, z_low, z_high, -1.0);
  };
  for (const auto& [low, high] : pieces_of(idle.flanges, HoleWalls::flanges, holes)) {
    take_out(low, high, inside->top, extent.z_high.value());
    take_out(low, high, extent.z_low.value(), inside->bottom);
  }
  for (const auto& [low, high] : pieces_of(idle.webs, HoleWalls::webs, holes)) {
    take_out(inside->left, extent.y_high.value(), low, high);
    take_out(extent.y_low.value(), inside->right, low, high);
  }
  return properties_of(sums_of(outline), extent);
}

AreaSums sums_of(const SectionProperties& of) {
  const double A = of.area.value();
  const double y = of.centroid_y.value();
  const double z = of.centroid_z.value();
  return {A,
          A * y,
          A * z,
          of.I_z.value() + A * y * y,
          of.I_y.value() + A * z * z,
          of.I_yz.value() + A * y * z};
}

SectionModulus first_moment_beyond(const Section& section, const std::vector<Hole>& holes, Length z,
                                   Length centroid_z) {
  const AreaSums beyond = sums_beyond(outline_of(section, holes), z.value());
  return si<SectionModulus>(beyond.z - centroid_z.value() * beyond.area);
}

Length width_at(const Section& section, const std::vector<Hole>& holes, Length z) {
  return si<Length>(width_at(outline_of(section, holes), z.value()));
}

}  // namespace boxbeam
