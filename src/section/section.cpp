#include "boxbeam/section/section.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace boxbeam {
namespace {

Length between(Length a, Length b, double fraction) { return a + (b - a) * fraction; }

SectionPlace between(const SectionPlace& a, const SectionPlace& b, double fraction) {
  return {between(a.y, b.y, fraction), between(a.z, b.z, fraction)};
}

std::vector<SectionPlace> between(const std::vector<SectionPlace>& a,
                                  const std::vector<SectionPlace>& b, double fraction) {
  std::vector<SectionPlace> places;
  for (std::size_t i = 0; i < a.size(); ++i) places.push_back(between(a[i], b[i], fraction));
  return places;
}

Profile between(const Box& a, const Box& b, double fraction) {
  const auto mix = [fraction](Length from, Length to) { return between(from, to, fraction); };
  Box box{mix(a.width, b.width),
          mix(a.height, b.height),
          mix(a.top_flange, b.top_flange),
          mix(a.bottom_flange, b.bottom_flange),
          mix(a.left_web, b.left_web),
          mix(a.right_web, b.right_web),
          {},
          mix(a.seam_throat, b.seam_throat)};
  for (std::size_t i = 0; i < a.stiffeners.size(); ++i) {
    const Stiffener& from = a.stiffeners[i];
    const Stiffener& to = b.stiffeners[i];
    box.stiffeners.push_back({from.plate, mix(from.place, to.place), mix(from.depth, to.depth),
                              mix(from.thickness, to.thickness)});
  }
  return box;
}

Profile between(const RectangularTube& a, const RectangularTube& b, double fraction) {
  return RectangularTube{between(a.width, b.width, fraction), between(a.height, b.height, fraction),
                         between(a.wall, b.wall, fraction),
                         between(a.outer_radius, b.outer_radius, fraction),
                         between(a.inner_radius, b.inner_radius, fraction)};
}

Profile between(const RoundTube& a, const RoundTube& b, double fraction) {
  return RoundTube{between(a.diameter, b.diameter, fraction), between(a.wall, b.wall, fraction)};
}

Profile between(const Plate& a, const Plate& b, double fraction) {
  return Plate{between(a.width, b.width, fraction), between(a.height, b.height, fraction)};
}

Profile between(const Polygon& a, const Polygon& b, double fraction) {
  Polygon polygon{between(a.outer, b.outer, fraction), {}};
  for (std::size_t i = 0; i < a.hollows.size(); ++i) {
    polygon.hollows.push_back(between(a.hollows[i], b.hollows[i], fraction));
  }
  return polygon;
}

Profile between(const ThinWalled& a, const ThinWalled& b, double fraction) {
  ThinWalled path{between(a.nodes, b.nodes, fraction), a.walls};
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    ThinWall& wall = path.walls[i];
    wall.thickness = between(wall.thickness, b.walls[i].thickness, fraction);
    wall.trim_from = between(wall.trim_from, b.walls[i].trim_from, fraction);
    wall.trim_to = between(wall.trim_to, b.walls[i].trim_to, fraction);
  }
  return path;
}

Profile between(const Profile& a, const Profile& b, double fraction) {
  return std::visit(
      [&](const auto& from) {
        return between(from, std::get<std::decay_t<decltype(from)>>(b), fraction);
      },
      a);
}

bool same_plates(const Box& a, const Box& b) {
  return std::equal(
      a.stiffeners.begin(), a.stiffeners.end(), b.stiffeners.begin(), b.stiffeners.end(),
      [](const Stiffener& one, const Stiffener& other) { return one.plate == other.plate; });
}

bool same_loops(const Polygon& a, const Polygon& b) {
  return a.outer.size() == b.outer.size() &&
         std::equal(a.hollows.begin(), a.hollows.end(), b.hollows.begin(), b.hollows.end(),
                    [](const auto& one, const auto& other) { return one.size() == other.size(); });
}

bool same_path(const ThinWalled& a, const ThinWalled& b) {
  return a.nodes.size() == b.nodes.size() &&
         std::equal(a.walls.begin(), a.walls.end(), b.walls.begin(), b.walls.end(),
                    [](const ThinWall& one, const ThinWall& other) {
                      return one.from == other.from && one.to == other.to;
                    });
}

bool same_kind(const Profile& a, const Profile& b) {
  if (a.index() != b.index()) return false;
  if (const auto* box = std::get_if<Box>(&a)) return same_plates(*box, std::get<Box>(b));
  if (const auto* polygon = std::get_if<Polygon>(&a))
    return same_loops(*polygon, std::get<Polygon>(b));
  if (const auto* path = std::get_if<ThinWalled>(&a)) {
    return same_path(*path, std::get<ThinWalled>(b));
  }
  // A sharp corner cannot grow round: its walls are cut elsewhere.
  if (const auto* tube = std::get_if<RectangularTube>(&a)) {
    const auto& other = std::get<RectangularTube>(b);
    return (tube->outer_radius == Length{}) == (other.outer_radius == Length{});
  }
  return true;
}

bool has_mirror_image(const Stiffener& bar, const std::vector<Stiffener>& bars) {
  Stiffener image = bar;
  if (bar.plate == BoxPlate::left_web)
    image.plate = BoxPlate::right_web;
  else if (bar.plate == BoxPlate::right_web)
    image.plate = BoxPlate::left_web;
  else
    image.place = -bar.place;
  return std::find(bars.begin(), bars.end(), image) != bars.end();
}

bool is_symmetric_about_z(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    return box->left_web == box->right_web &&
           std::all_of(box->stiffeners.begin(), box->stiffeners.end(), [&](const Stiffener& bar) {
             return has_mirror_image(bar, box->stiffeners);
           });
  }
  return !std::holds_alternative<Polygon>(profile) && !std::holds_alternative<ThinWalled>(profile);
}

void add_places(const std::vector<SectionPlace>& places, std::vector<Length>& lengths) {
  for (const SectionPlace& place : places) lengths.insert(lengths.end(), {place.y, place.z});
}

void add_dimensions(const Profile& profile, std::vector<Length>& lengths) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    lengths.insert(lengths.end(), {box->width, box->height, box->top_flange, box->bottom_flange,
                                   box->left_web, box->right_web, box->seam_throat});
    for (const Stiffener& bar : box->stiffeners)
      lengths.insert(lengths.end(), {bar.place, bar.depth, bar.thickness});
  } else if (const auto* rectangular = std::get_if<RectangularTube>(&profile)) {
    lengths.insert(lengths.end(), {rectangular->width, rectangular->height, rectangular->wall,
                                   rectangular->outer_radius, rectangular->inner_radius});
  } else if (const auto* round = std::get_if<RoundTube>(&profile)) {
    lengths.insert(lengths.end(), {round->diameter, round->wall});
  } else if (const auto* plate = std::get_if<Plate>(&profile)) {
    lengths.insert(lengths.end(), {plate->width, plate->height});
  } else if (const auto* polygon = std::get_if<Polygon>(&profile)) {
    add_places(polygon->outer, lengths);
    for (const auto& hollow : polygon->hollows) add_places(hollow, lengths);
  } else {
    const auto& path = std::get<ThinWalled>(profile);
    add_places(path.nodes, lengths);
    for (const ThinWall& wall : path.walls)
      lengths.insert(lengths.end(), {wall.thickness, wall.trim_from, wall.trim_to});
  }
}

void add_plates(const Profile& profile, std::vector<Length>& plates) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    plates.insert(plates.end(),
                  {box->top_flange, box->bottom_flange, box->left_web, box->right_web});
    for (const Stiffener& bar : box->stiffeners) plates.push_back(bar.thickness);
  } else if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    for (const ThinWall& wall : path->walls) plates.push_back(wall.thickness);
  } else {
    plates.push_back(wall_at(profile, Length{}));
  }
}

Extent around(Length width, Length height) {
  return {-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height};
}

Extent around(const std::vector<SectionPlace>& places) {
  Extent extent{places[0].y, places[0].y, places[0].z, places[0].z};
  for (const SectionPlace& place : places) {
    extent.y_low = std::min(extent.y_low, place.y);
    extent.y_high = std::max(extent.y_high, place.y);
    extent.z_low = std::min(extent.z_low, place.z);
    extent.z_high = std::max(extent.z_high, place.z);
  }
  return extent;
}

Extent extent_of(const ThinWalled& path) {
  std::vector<SectionPlace> corners;
  for (const ThinWall& wall : path.walls) {
    const SectionPlace& a = path.nodes[wall.from];
    const SectionPlace& b = path.nodes[wall.to];
    const Length way = hypot(b.y - a.y, b.z - a.z);
    const double y = (b.y - a.y) / way;
    const double z = (b.z - a.z) / way;
    const Length half = 0.5 * wall.thickness;
    for (const double side : {-1.0, 1.0}) {
      corners.push_back(
          {a.y + y * wall.trim_from - side * z * half, a.z + z * wall.trim_from + side * y * half});
      corners.push_back(
          {b.y - y * wall.trim_to - side * z * half, b.z - z * wall.trim_to + side * y * half});
    }
  }
  return around(corners);
}

}  // namespace

Box symmetric_box(Length width, Length height, Length flange, Length web) {
  return {width, height, flange, flange, web, web};
}

bool takes_holes(const Profile& profile) {
  return std::holds_alternative<Box>(profile) || std::holds_alternative<RectangularTube>(profile) ||
         std::holds_alternative<Plate>(profile);
}

const char* to_text(const Profile& profile) {
  constexpr std::array words{"box",   "rectangular tube", "round tube",
                             "plate", "polygon",          "thin-walled path"};
  static_assert(words.size() == std::variant_size_v<Profile>);
  return words[profile.index()];
}

Section interpolate(const Section& from, const Section& to, double fraction) {
  Section section{between(from.outer, to.outer, fraction), std::nullopt};
  if (from.inner) section.inner = between(*from.inner, *to.inner, fraction);
  return section;
}

bool same_kind(const Section& a, const Section& b) {
  if (!same_kind(a.outer, b.outer) || a.inner.has_value() != b.inner.has_value()) return false;
  return !a.inner || same_kind(*a.inner, *b.inner);
}

bool is_symmetric_about_z(const Section& section) {
  return is_symmetric_about_z(section.outer) &&
         (!section.inner || is_symmetric_about_z(*section.inner));
}

std::vector<Length> dimensions_of(const Section& section) {
  std::vector<Length> lengths;
  add_dimensions(section.outer, lengths);
  if (section.inner) add_dimensions(*section.inner, lengths);
  return lengths;
}

std::vector<Length> thicknesses_of(const Section& section) {
  std::vector<Length> plates;
  add_plates(section.outer, plates);
  if (section.inner) add_plates(*section.inner, plates);
  return plates;
}

Extent extent_of(const Profile& profile) {
  if (const auto* tube = std::get_if<RoundTube>(&profile)) {
    return around(tube->diameter, tube->diameter);
  }
  if (const auto* polygon = std::get_if<Polygon>(&profile)) return around(polygon->outer);
  if (const auto* path = std::get_if<ThinWalled>(&profile)) return extent_of(*path);
  if (const auto* box = std::get_if<Box>(&profile)) return around(box->width, box->height);
  if (const auto* plate = std::get_if<Plate>(&profile)) return around(plate->width, plate->height);
  const auto& tube = std::get<RectangularTube>(profile);
  return around(tube.width, tube.height);
}

Length height_of(const Profile& profile) {
  const Extent extent = extent_of(profile);
  return extent.z_high - extent.z_low;
}

Length clear_top_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) return 0.5 * box->height - box->top_flange;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    return 0.5 * tube->height - tube->wall;
  }
  if (const auto* tube = std::get_if<RoundTube>(&profile)) return 0.5 * tube->diameter - tube->wall;
  return extent_of(profile).z_high;
}

Length clear_bottom_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) return box->bottom_flange - 0.5 * box->height;
  if (std::holds_alternative<RectangularTube>(profile) ||
      std::holds_alternative<RoundTube>(profile)) {
    return -clear_top_of(profile);
  }
  return extent_of(profile).z_low;
}

Length wall_at(const Profile& profile, Length z) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    if (z > clear_top_of(profile)) return box->top_flange;
    if (z < clear_bottom_of(profile)) return box->bottom_flange;
    return std::max(box->left_web, box->right_web);
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) return tube->wall;
  if (const auto* tube = std::get_if<RoundTube>(&profile)) return tube->wall;
  if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    Length thickest;
    for (const ThinWall& wall : path->walls) thickest = std::max(thickest, wall.thickness);
    return thickest;
  }
  const Extent extent = extent_of(profile);
  return std::min(extent.y_high - extent.y_low, extent.z_high - extent.z_low);
}

Length wall_at(const Section& section, Length z) {
  return beside_inner(section, wall_at(section.outer, z), z);
}

Length beside_inner(const Section& section, Length wall, Length z) {
  if (!section.inner || abs(z) > 0.5 * height_of(*section.inner)) return wall;
  return std::max(wall, wall_at(*section.inner, z));
}

}  // namespace boxbeam
