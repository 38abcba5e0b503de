#include "boxbeam/section/section_properties.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxbeam {
namespace {

/// Sums over a section, SI; about the mid-height until the centroid is known.
struct Sums {
  double area = 0.0;
  double moment = 0.0;  ///< integral of z dA
  double I_y = 0.0;
  double I_z = 0.0;

  void add(const Sums& other, double sign) {
    area += sign * other.area;
    moment += sign * other.moment;
    I_y += sign * other.I_y;
    I_z += sign * other.I_z;
  }
};

Sums rectangle(double width, double height, double y = 0.0, double z = 0.0) {
  const double area = width * height;
  return {area, area * z, area * (height * height / 12.0 + z * z),
          area * (width * width / 12.0 + y * y)};
}

Sums disc(double diameter) {
  const double squared = diameter * diameter;
  const double second = std::numbers::pi * squared * squared / 64.0;
  return {0.25 * std::numbers::pi * squared, 0.0, second, second};
}

Sums sums_of(const Profile& profile) {
  Sums sums;
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    sums.add(rectangle(box->width.value(), box->height.value()), 1.0);
    sums.add(
        rectangle((box->width - 2.0 * box->web).value(), (box->height - 2.0 * box->flange).value()),
        -1.0);
  } else {
    const auto& tube = std::get<RoundTube>(profile);
    sums.add(disc(tube.diameter.value()), 1.0);
    sums.add(disc((tube.diameter - 2.0 * tube.wall).value()), -1.0);
  }
  return sums;
}

/// The strips a hole takes out of the section through its centre.
/// Precondition: the outer profile is a hollow rectangle and the hole lies within its wall.
Sums strips_of(const Hole& hole, const HollowRectangle& box) {
  const double d = hole.diameter.value();
  Sums sums;
  if (hole.walls == HoleWalls::webs) {
    const double t = box.web.value();
    const double y = 0.5 * (box.width.value() - t);
    for (double side : {-1.0, 1.0}) sums.add(rectangle(t, d, side * y, hole.position.value()), 1.0);
    return sums;
  }
  const double t = box.flange.value();
  const double z = 0.5 * (box.height.value() - t);
  const double y = hole.position.value();
  for (double side : {-1.0, 1.0}) {
    sums.add(rectangle(d, t, y, side * z), 1.0);
    if (y != 0.0) sums.add(rectangle(d, t, -y, side * z), 1.0);
  }
  return sums;
}

/// Half the chord of a circle at level z.
double half_chord(double diameter, double z) {
  return std::sqrt(std::max(0.0, 0.25 * diameter * diameter - z * z));
}

/// Area and first moment about mid-height of the part of a shape beyond a level.
struct Beyond {
  double area = 0.0;
  double moment = 0.0;
};

Beyond rectangle_beyond(double width, double low, double high, double z) {
  if (z >= high) return {};
  const double from = std::max(low, z);
  return {width * (high - from), 0.5 * width * (high * high - from * from)};
}

Beyond disc_beyond(double diameter, double z) {
  const double radius = 0.5 * diameter;
  if (z >= radius) return {};
  if (z <= -radius) return {std::numbers::pi * radius * radius, 0.0};
  const double chord = half_chord(diameter, z);
  return {radius * radius * std::acos(z / radius) - z * chord, 2.0 / 3.0 * chord * chord * chord};
}

Beyond difference(const Beyond& a, const Beyond& b) {
  return {a.area - b.area, a.moment - b.moment};
}

Beyond beyond(const Profile& profile, double z) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    const double half = 0.5 * box->height.value();
    const double clear = half_clear_height(profile).value();
    return difference(rectangle_beyond(box->width.value(), -half, half, z),
                      rectangle_beyond((box->width - 2.0 * box->web).value(), -clear, clear, z));
  }
  const auto& tube = std::get<RoundTube>(profile);
  return difference(disc_beyond(tube.diameter.value(), z),
                    disc_beyond((tube.diameter - 2.0 * tube.wall).value(), z));
}

double width_of(const Profile& profile, double z) {
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    if (std::abs(z) > 0.5 * box->height.value()) return 0.0;
    return std::abs(z) > half_clear_height(profile).value() ? box->width.value()
                                                            : 2.0 * box->web.value();
  }
  const auto& tube = std::get<RoundTube>(profile);
  return 2.0 * (half_chord(tube.diameter.value(), z) -
                half_chord((tube.diameter - 2.0 * tube.wall).value(), z));
}

}  // namespace

SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes) {
  Sums sums = sums_of(section.outer);
  if (section.inner) sums.add(sums_of(*section.inner), 1.0);
  for (const Hole& hole : holes) {
    sums.add(strips_of(hole, std::get<HollowRectangle>(section.outer)), -1.0);
  }
  const double centroid = sums.moment / sums.area;
  const double I_y = sums.I_y - sums.area * centroid * centroid;
  const double half = 0.5 * height_of(section.outer).value();
  const double half_width = std::holds_alternative<HollowRectangle>(section.outer)
                                ? 0.5 * std::get<HollowRectangle>(section.outer).width.value()
                                : half;
  SectionProperties result;
  result.area = si<Area>(sums.area);
  result.centroid_z = si<Length>(centroid);
  result.I_y = si<SecondMoment>(I_y);
  result.I_z = si<SecondMoment>(sums.I_z);
  result.z_top = si<Length>(half);
  result.z_bottom = si<Length>(-half);
  result.W_y = si<SectionModulus>(I_y / (half + std::abs(centroid)));
  result.W_z = si<SectionModulus>(sums.I_z / half_width);
  return result;
}

SectionProperties properties_of(const Section& section) { return properties_of(section, {}); }

SectionModulus first_moment_beyond(const Section& section, const std::vector<Hole>& holes, Length z,
                                   Length centroid_z) {
  Beyond total = beyond(section.outer, z.value());
  if (section.inner) {
    const Beyond inner = beyond(*section.inner, z.value());
    total = {total.area + inner.area, total.moment + inner.moment};
  }
  for (const Hole& hole : holes) {
    const auto& box = std::get<HollowRectangle>(section.outer);
    const double d = hole.diameter.value();
    if (hole.walls == HoleWalls::webs) {
      const double level = hole.position.value();
      total = difference(total, rectangle_beyond(2.0 * box.web.value(), level - 0.5 * d,
                                                 level + 0.5 * d, z.value()));
    } else {
      const double half = 0.5 * box.height.value();
      const double strip = hole.position.value() == 0.0 ? d : 2.0 * d;
      const double t = box.flange.value();
      total = difference(total, rectangle_beyond(strip, half - t, half, z.value()));
      total = difference(total, rectangle_beyond(strip, -half, -half + t, z.value()));
    }
  }
  return si<SectionModulus>(total.moment - centroid_z.value() * total.area);
}

Length width_at(const Section& section, const std::vector<Hole>& holes, Length z) {
  double width = width_of(section.outer, z.value());
  if (section.inner) width += width_of(*section.inner, z.value());
  for (const Hole& hole : holes) {
    const auto& box = std::get<HollowRectangle>(section.outer);
    const bool in_flange = abs(z) > half_clear_height(section.outer);
    if (hole.walls == HoleWalls::webs) {
      // A level on the edge of the hole has material beside it.
      if (!in_flange && abs(z - hole.position) < 0.5 * hole.diameter)
        width -= 2.0 * box.web.value();
    } else if (in_flange) {
      width -= (hole.position.value() == 0.0 ? 1.0 : 2.0) * hole.diameter.value();
    }
  }
  return si<Length>(std::max(0.0, width));
}

}  // namespace boxbeam
