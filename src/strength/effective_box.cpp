#include "boxbeam/strength/effective_box.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/outline.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "effective_parts.hpp"

namespace boxbeam {
namespace {

/// Takes a share of a rectangle out, by its ends along and across the plate it belongs to.
void take_out(AreaSums& sums, bool flange, double from, double to, double low, double high,
              double share) {
  if (!(to > from) || !(share > 0.0)) return;
  const double area = share * (to - from) * (high - low);
  const double along = 0.5 * (from + to), across = 0.5 * (low + high);
  const auto second = [](double start, double end) {
    return (std::pow(end, 3) - std::pow(start, 3)) / 3.0;
  };
  const double second_along = share * (high - low) * second(from, to);
  const double second_across = share * (to - from) * second(low, high);
  sums.area -= area;
  sums.y -= area * (flange ? along : across);
  sums.z -= area * (flange ? across : along);
  sums.yy -= flange ? second_along : second_across;
  sums.zz -= flange ? second_across : second_along;
  sums.yz -= area * along * across;
}

/// Takes a strip out of a plate, from one place of its width to another.
void take_out(AreaSums& sums, const BoxWall& wall, bool flange, double from, double to,
              double share = 1.0) {
  const double half = 0.5 * wall.thickness.value(), across = wall.middle.value();
  take_out(sums, flange, from, to, across - half, across + half, share);
}

/// Takes a share of a stiffener out, which stands on the inner face of its plate.
void take_out(AreaSums& sums, const BoxWall& wall, bool flange, const FlatStiffener& bar,
              double share) {
  const double from = (bar.place - 0.5 * bar.thickness).value();
  const double to = (bar.place + 0.5 * bar.thickness).value();
  const double inwards = wall.middle.value() > 0.0 ? -1.0 : 1.0;
  const double foot = wall.middle.value() + inwards * 0.5 * wall.thickness.value();
  const double tip = foot + inwards * bar.depth.value();
  take_out(sums, flange, from, to, std::min(foot, tip), std::max(foot, tip), share);
}

/// Takes out what does not work of a plate with stiffeners, or what shear lag leaves idle of one in
/// tension, all over.
void take_out(AreaSums& sums, const BoxWall& wall, bool flange, double lag, WallAlone& of) {
  of.idle = {};
  const auto strip = [&](Length low, Length high, double works) {
    of.idle += (1.0 - works) * (high - low);
    take_out(sums, wall, flange, low.value(), high.value(), 1.0 - works);
  };
  if (of.stiffened) {
    for (const WorkingStrip& at : of.stiffened->strips) strip(at.low, at.high, lag * at.works);
  } else {
    strip(wall.low, wall.high, lag);
  }
  for (std::size_t k = 0; k < wall.stiffeners.size(); ++k) {
    const double works = of.stiffened ? of.stiffened->stiffeners[k] : 1.0;
    take_out(sums, wall, flange, wall.stiffeners[k], 1.0 - lag * works);
  }
}

EffectiveWidth bare_width_of(const BoxWall& wall, double psi, std::optional<Length> length) {
  return *panel_effective_width(wall.clear(), wall.thickness, psi, wall.class_strength, length,
                                wall.level);
}

/// A plate whose compression is even, or, in tension, what shear lag leaves of it: a strip in its
/// middle is idle.
void judge_even(const FourWalls& box, BoxPlate plate, bool pressed, double lag, WallAlone& of,
                AreaSums& sums) {
  const BoxWall& wall = box.of(plate);
  const bool flange = is_flange(plate);
  of.psi = 1.0;
  of.pressed = pressed;
  if (!wall.stiffeners.empty()) {
    if (pressed) of.stiffened = stiffened_widths(stiffened_plate_of(wall, box.length), 1.0, 1.0);
    take_out(sums, wall, flange, lag, of);
    return;
  }
  double share = lag;
  if (pressed) {
    of.width = bare_width_of(wall, 1.0, box.length);
    share *= of.width.rho;
  }
  of.idle = (1.0 - share) * wall.clear();
  const double middle = 0.5 * (wall.low + wall.high).value();
  take_out(sums, wall, flange, middle - 0.5 * of.idle.value(), middle + 0.5 * of.idle.value());
}

/// A plate that is bent in its plane, by the stress at its ends, tension positive.
void judge_bent(const FourWalls& box, BoxPlate plate, double at_low, double at_high, WallAlone& of,
                AreaSums& sums) {
  const BoxWall& wall = box.of(plate);
  const bool flange = is_flange(plate);
  const double most = std::max(-at_low, -at_high);
  of.pressed = most > 0.0;
  of.idle = {};
  of.stiffened.reset();
  if (!of.pressed) return;
  constexpr double least = -3.0;
  of.psi = std::max(least, std::min(-at_low, -at_high) / most);
  if (!wall.stiffeners.empty())
    of.stiffened = stiffened_widths(stiffened_plate_of(wall, box.length), -at_low, -at_high);
  if (of.stiffened) {
    take_out(sums, wall, flange, 1.0, of);
    return;
  }
  of.width = bare_width_of(wall, of.psi, box.length);
  const Length pressed = wall.clear() / std::max(1.0, 1.0 - of.psi);
  of.idle = pressed - of.width.b_eff;
  // From the edge of the larger compression on.
  const double b_e1 = of.width.b_e1.value(), idle = of.idle.value();
  if (-at_low >= -at_high) {
    const double from = wall.low.value() + b_e1;
    take_out(sums, wall, flange, from, from + idle);
  } else {
    const double to = wall.high.value() - b_e1;
    take_out(sums, wall, flange, to - idle, to);
  }
}

SectionAlone compressed_alone(const FourWalls& box) {
  SectionAlone section;
  section.sums = box.gross;
  for (std::size_t k = 0; k < box_plates.size(); ++k)
    judge_even(box, box_plates[k], true, 1.0, section.walls[k], section.sums);
  return section;
}

BoxWall wall_of(Length low, Length high, Length middle, Length thickness) {
  return {low, high, middle, thickness, {}, {}, {}};
}

PlateKind kind_of(BoxPlate plate, bool built) {
  if (!built) return PlateKind::wall;
  switch (plate) {
    case BoxPlate::top_flange: return PlateKind::top_flange;
    case BoxPlate::bottom_flange: return PlateKind::bottom_flange;
    case BoxPlate::left_web: return PlateKind::left_web;
    case BoxPlate::right_web: return PlateKind::right_web;
  }
  return PlateKind::wall;
}

}  // namespace

const char* to_text(BoxPlate plate) {
  switch (plate) {
    case BoxPlate::top_flange: return "top flange";
    case BoxPlate::bottom_flange: return "bottom flange";
    case BoxPlate::left_web: return "left web";
    case BoxPlate::right_web: return "right web";
  }
  return "";
}

bool is_flange(BoxPlate plate) {
  return plate == BoxPlate::top_flange || plate == BoxPlate::bottom_flange;
}

PlateEnds::PlateEnds(const FourWalls& box, BoxPlate plate, const AreaSums& section) {
  const BoxWall& wall = box.of(plate);
  const auto at = [&](const Length& end) {
    return is_flange(plate) ? normal_influence(section, end.value(), wall.middle.value())
                            : normal_influence(section, wall.middle.value(), end.value());
  };
  low_ = at(wall.low);
  high_ = at(wall.high);
}

std::array<Stress, 2> PlateEnds::compression_under(const CutForces& cut) const {
  return {-stress_at(low_, cut).normal, -stress_at(high_, cut).normal};
}

PlateStress PlateEnds::under(const CutForces& cut) const {
  const auto [low, high] = compression_under(cut);
  const Stress most = std::max(low, high), least = std::min(low, high);
  constexpr double lowest = -3.0;
  PlateStress of{std::max(Stress{}, most), std::max(Stress{}, Stress(-least))};
  of.more_at_high = high > low;
  if (most > Stress{}) of.psi = std::max(lowest, (least / most).value());
  return of;
}

std::optional<FourWalls> four_walls_of(const Profile& profile, const PlateMaterials& materials) {
  const auto* const built = std::get_if<Box>(&profile);
  const auto* const tube = std::get_if<RectangularTube>(&profile);
  if (built == nullptr && tube == nullptr) return std::nullopt;
  const Box box =
      built != nullptr ? *built : symmetric_box(tube->width, tube->height, tube->wall, tube->wall);
  const Length half_width = 0.5 * box.width, half_height = 0.5 * box.height;
  // Of a rolled tube b - 3 t, EN 1993-1-5, 4.4(2), as its class.
  const Length corner =
      tube != nullptr ? std::min(1.5 * tube->wall, tube->wall + tube->inner_radius) : Length{};
  const auto inside = [&](Length plate) { return tube != nullptr ? corner : plate; };
  FourWalls walls;
  walls.gross = sums_of(outline_of(profile));
  const Length left = half_width - inside(box.left_web);
  const Length right = inside(box.right_web) - half_width;
  const Length top = half_height - inside(box.top_flange);
  const Length bottom = inside(box.bottom_flange) - half_height;
  using enum BoxPlate;
  walls.of(top_flange) = wall_of(right, left, half_height - 0.5 * box.top_flange, box.top_flange);
  walls.of(bottom_flange) =
      wall_of(right, left, 0.5 * box.bottom_flange - half_height, box.bottom_flange);
  walls.of(left_web) = wall_of(bottom, top, half_width - 0.5 * box.left_web, box.left_web);
  walls.of(right_web) = wall_of(bottom, top, 0.5 * box.right_web - half_width, box.right_web);
  for (const BoxPlate plate : box_plates) {
    BoxWall& wall = walls.of(plate);
    const PlateKind kind = kind_of(plate, built != nullptr);
    const auto yield = yield_strength_of(materials.of(kind), wall.thickness);
    const auto of_class = class_yield_of(profile, materials, kind, wall.thickness);
    if (!yield || !of_class) return std::nullopt;
    wall.yield_strength = *yield;
    wall.class_strength = *of_class;
  }
  for (const Stiffener& bar : box.stiffeners) {
    BoxWall& wall = walls.of(bar.plate);
    const auto yield = yield_strength_of(materials.of(PlateKind::stiffener), bar.thickness);
    if (!yield) return std::nullopt;
    // No stiffener is stressed more than the worst corner of the box.
    wall.yield_strength = std::min(wall.yield_strength, *yield);
    wall.stiffeners.push_back({bar.place, bar.depth, bar.thickness});
  }
  for (BoxWall& wall : walls.walls) {
    std::sort(wall.stiffeners.begin(), wall.stiffeners.end(),
              [](const FlatStiffener& a, const FlatStiffener& b) { return a.place < b.place; });
  }
  return walls;
}

StiffenedPlate stiffened_plate_of(const BoxWall& wall, std::optional<Length> length) {
  return {wall.low, wall.high, wall.thickness, wall.class_strength, wall.stiffeners, length};
}

SectionAlone section_alone(const FourWalls& box, ActingAlone acting, const LagShares& lag,
                           int most_passes) {
  if (acting == ActingAlone::compression) return compressed_alone(box);
  using enum BoxPlate;
  const bool about_y = is_about_y(acting), positive = is_positive(acting);
  // M_y > 0 stretches +z, M_z > 0 compresses +y.
  const BoxPlate far = about_y ? top_flange : left_web;
  const BoxPlate near = about_y ? bottom_flange : right_web;
  const BoxPlate pressed = about_y == positive ? near : far;
  const BoxPlate stretched = pressed == near ? far : near;
  const double share = about_y ? lag.flanges : lag.webs;
  const auto index = [](BoxPlate plate) { return static_cast<std::size_t>(plate); };

  SectionAlone section;
  AreaSums flanges = box.gross;
  judge_even(box, pressed, true, share, section.walls[index(pressed)], flanges);
  judge_even(box, stretched, false, share, section.walls[index(stretched)], flanges);
  const std::array bent =
      about_y ? std::array{left_web, right_web} : std::array{top_flange, bottom_flange};
  const double moment = positive ? 1.0 : -1.0;
  AreaSums known = flanges;
  for (section.passes = 0; section.passes < most_passes;) {
    ++section.passes;
    const std::array<WallAlone, 4> before = section.walls;
    section.sums = flanges;
    for (const BoxPlate plate : bent) {
      const BoxWall& wall = box.of(plate);
      const auto stress_at = [&](Length end) {
        const double y = (about_y ? wall.middle : end).value();
        const double z = (about_y ? end : wall.middle).value();
        return moment * stress_per_moment(known, acting, y, z);
      };
      judge_bent(box, plate, stress_at(wall.low), stress_at(wall.high), section.walls[index(plate)],
                 section.sums);
    }
    constexpr double close = 1e-10;
    const bool settled = std::all_of(bent.begin(), bent.end(), [&](BoxPlate plate) {
      return std::abs(section.walls[index(plate)].psi - before[index(plate)].psi) < close;
    });
    if (section.passes > 1 && settled) break;
    known = section.sums;
  }
  return section;
}

EffectiveBox::EffectiveBox(const FourWalls& box, const LagShares& lag, int most_passes)
    : box_(box), lag_(lag), most_passes_(most_passes) {
  for (std::size_t k = 0; k < sections_.size(); ++k)
    sections_[k] = section_alone(box, static_cast<ActingAlone>(k), lag, most_passes);
  const Length width = box.of(BoxPlate::left_web).middle - box.of(BoxPlate::right_web).middle;
  centroid_ = effective_centroid_of(box.gross, sections_.front().sums, 1e-12 * width.value());
  least_strength_ = box.walls.front().yield_strength;
  for (const BoxWall& wall : box.walls)
    least_strength_ = std::min(least_strength_, wall.yield_strength);
  std::size_t at = 0;
  for (const BoxPlate flange : {BoxPlate::top_flange, BoxPlate::bottom_flange}) {
    for (const BoxPlate web : {BoxPlate::left_web, BoxPlate::right_web}) {
      Corner& corner = corners_[at++];
      corner.of = {flange, web};
      const double y = box.of(web).middle.value(), z = box.of(flange).middle.value();
      using enum ActingAlone;
      const auto modulus = [&](ActingAlone acting) {
        return 1.0 / most_per_moment(alone(acting).sums, acting, y, z);
      };
      corner.areas = {box.gross.area, sections_.front().sums.area};
      corner.W_y = {modulus(M_y_positive), modulus(M_y_negative)};
      corner.W_z = {modulus(M_z_positive), modulus(M_z_negative)};
      corner.flange_strength = box.of(flange).yield_strength;
      corner.least_strength = std::min(box.of(flange).yield_strength, box.of(web).yield_strength);
    }
  }
}

CornerUse EffectiveBox::use_of(const Corner& corner, const CutForces& cut,
                               const Shifts& shifts) const {
  CornerUse of{stress_at(corner, centroid_, cut, shifts), corner.of};
  of.yield_strength = is_compressed(of, cut.N) ? least_strength_
                      : is_bent_about_z(of)    ? corner.least_strength
                                               : corner.flange_strength;
  of.use = std::abs(of.stress.value()) / of.yield_strength.value();
  return of;
}

template <class Look>
void EffectiveBox::look_at_corners(const CutForces& cut, const Look& look) const {
  for (const Corner& corner : corners_) {
    look_at_shifts(centroid_, cut,
                   [&](const Shifts& shifts) { look(use_of(corner, cut, shifts)); });
  }
}

CornerUse EffectiveBox::worst_corner(const CutForces& cut) const {
  CornerUse worst;
  worst.use = -1.0;
  look_at_corners(cut, [&](const CornerUse& of) {
    if (of.use > worst.use) worst = of;
  });
  return worst;
}

std::array<double, 4> EffectiveBox::compressed_shares(const CutForces& cut) const {
  std::array<double, 4> most{};
  look_at_corners(cut, [&](const CornerUse& of) {
    for (const BoxPlate plate : {of.corner.flange, of.corner.web}) {
      double& share = most[static_cast<std::size_t>(plate)];
      share = std::max(share, -(of.stress / box_.of(plate).class_strength).value());
    }
  });
  return where_it_yields(most, use(cut));
}

std::optional<EffectiveBox> EffectiveBox::below_yield(const CutForces& cut, bool annex_E) const {
  EffectiveBox of = *this;
  for (int i = 0; i < most_level_steps; ++i) {
    FourWalls walls = of.box_;
    if (settled_at(of.compressed_shares(cut), annex_E, walls.walls)) return of;
    of = EffectiveBox(walls, lag_, most_passes_);
  }
  return std::nullopt;
}

double EffectiveBox::use(const CutForces& cut) const { return worst_corner(cut).use; }

}  // namespace boxbeam
