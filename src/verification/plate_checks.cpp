#include "boxbeam/verification/plate_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/wall_stretches.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Up to this slope of its edges a plate counts as a rectangle. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double steepest = 10.0 * std::numbers::pi / 180.0;

/// Up to this part of a plate's width an opening does not count. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double widest_opening = 0.05;

/// The plates of both ends of the segment of a station, between which c/t has its largest value at
/// one of them: what is judged does not come and go within a segment.
std::vector<FourWalls> walls_of_segment(const Project& project, const Station& station) {
  const std::size_t index = segment_at(project.beam, station);
  const Segment& segment = project.beam.segments[index];
  std::vector<FourWalls> walls;
  for (const Section* section : {&segment.from, &segment.to}) {
    if (auto of = four_walls_of(section->outer, materials_of(project, index)))
      walls.push_back(std::move(*of));
  }
  return walls;
}

/// The plates of a station. Stiffeners of a plate that would do without them count as area alone.
std::optional<FourWalls> four_walls_at(const Project& project, const Station& station,
                                       const std::vector<FourWalls>& ends) {
  const Section section = judged_section_at(project, station);
  if (section.inner) return std::nullopt;
  auto walls =
      four_walls_of(section.outer, materials_of(project, segment_at(project.beam, station)));
  if (!walls) return std::nullopt;
  walls->length = supported_length_at(project, station);
  for (const BoxPlate plate : box_plates) {
    const bool slender = std::any_of(ends.begin(), ends.end(),
                                     [&](const FourWalls& of) { return may_buckle(of.of(plate)); });
    if (!slender) walls->of(plate).stiffeners.clear();
  }
  return walls;
}

/// The steepest edge of a segment's outline [rad].
double slope_of(const Segment& segment) {
  const Extent from = extent_of(segment.from.outer), to = extent_of(segment.to.outer);
  double most = 0.0;
  for (const Length& change : {to.y_low - from.y_low, to.y_high - from.y_high,
                               to.z_low - from.z_low, to.z_high - from.z_high})
    most = std::max(most, std::abs((change / segment.length).value()));
  return std::atan(most);
}

std::optional<BoxPlate> plate_of(WallPart part) {
  switch (part) {
    case WallPart::top_flange: return BoxPlate::top_flange;
    case WallPart::bottom_flange: return BoxPlate::bottom_flange;
    case WallPart::left_web: return BoxPlate::left_web;
    case WallPart::right_web: return BoxPlate::right_web;
    default: return std::nullopt;
  }
}

/// The stiffeners of a wall as far as they help it in shear: I_sl with 15 eps t of plate on both
/// sides, at most half of the subpanels. Source: EN 1993-1-5:2006, 5.3(3), figure 5.3.
ShearStiffeners shear_stiffeners_of(const BoxWall& wall) {
  ShearStiffeners of;
  const std::vector<FlatStiffener>& bars = wall.stiffeners;
  of.count = static_cast<int>(bars.size());
  const double t = wall.thickness.value();
  const Length most = 15.0 * epsilon_of(wall.class_strength) * wall.thickness;
  Length from = wall.low;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const FlatStiffener& bar = bars[k];
    const Length half = 0.5 * bar.thickness;
    const Length before = bar.place - half - from;
    const bool last = k + 1 == bars.size();
    const Length next = last ? wall.high : bars[k + 1].place - 0.5 * bars[k + 1].thickness;
    const Length behind = next - bar.place - half;
    of.widest_subpanel = std::max({of.widest_subpanel, before, behind}, std::less<>());
    const double plate =
        (std::min(0.5 * before, most) + bar.thickness + std::min(0.5 * behind, most)).value() * t;
    const double d = bar.depth.value(), A = d * bar.thickness.value(), apart = 0.5 * (t + d);
    of.inertia += si<SecondMoment>((A * d * d + plate * t * t) / 12.0 +
                                   plate * A / (plate + A) * apart * apart);
    from = bar.place + half;
  }
  return of;
}

/// A plate without what it carries of the shear flow.
ShearedPlate sheared_plate(double gamma_M1, const BoxWall& wall, BoxPlate plate, bool alike) {
  ShearedPlate of;
  of.plate = plate;
  of.name = alike && !is_flange(plate) ? "web" : to_text(plate);
  of.panel = {wall.clear(), wall.thickness, wall.yield_strength,
              {},           false,          shear_stiffeners_of(wall)};
  of.resists = shear_resistance_of(of.panel, gamma_M1);
  return of;
}

/// The part of the shear flow on a stretch of a plate.
ShearedPlate::Piece piece_of(const StressField& field, const WallStretch& stretch) {
  ShearedPlate::Piece piece;
  const Wall& wall = field.flow->at.graph.walls[stretch.wall];
  piece.width = (stretch.to - stretch.from) * length_of(wall);
  for (std::size_t i = 0; i < piece.per_cut_force.size(); ++i) {
    const SectionPoint point = point_on_stretch(field, stretch, 0.5 * static_cast<double>(i));
    piece.per_cut_force[i] = point.influence.shear;
    // The wall's own torsion turns round over its thickness.
    if (point.torsion) piece.per_cut_force[i][cut_force::T] -= point.torsion->face;
  }
  return piece;
}

/// The box below yield, where it settles and is used less.
std::optional<EffectiveBox> lower_box(const EffectiveBox& box, const CutForces& cut, WidthRule rule,
                                      double at_yield) {
  auto below = box.below_yield(cut, rule == WidthRule::annex_E);
  if (below && below->use(cut) > at_yield) below.reset();
  return below;
}

/// The uses of a station's plates under cut forces, with gamma_M0 and gamma_M1.
class PlateUses {
 public:
  PlateUses(const Project& project, const SlenderPlates& plates)
      : gamma_M0_(project.strength.gamma_M0),
        rule_(project.strength.effective_widths),
        plates_(&plates) {}

  double normal(const CutForces& cut) const { return gamma_M0_ * corner(cut).use; }
  static double shear(const ShearedPlate& plate, const CutForces& cut) {
    return plate.force_of(cut) / plate.resists.resistance;
  }
  WebInteraction together(const ShearedPlate& plate, const CutForces& cut) const {
    return interaction_of(plate, plates_->plastic, corner(cut), cut, gamma_M0_);
  }

 private:
  CornerUse corner(const CutForces& cut) const {
    const CornerUse at_yield = plates_->box.worst_corner(cut);
    if (rule_ == WidthRule::at_yield) return at_yield;
    const auto below = lower_box(plates_->box, cut, rule_, at_yield.use);
    return below ? below->worst_corner(cut) : at_yield;
  }

  double gamma_M0_;
  WidthRule rule_;
  const SlenderPlates* plates_;
};

/// Where a use is largest.
struct Worst {
  const SituationHistory* at;
  TurningPoint largest;  ///< without load factor
  double use = 0.0;      ///< with it
};

template <class Use>
Worst worst_of(const std::vector<SituationHistory>& histories, const Use& use) {
  Worst worst{&histories.front(), {}, 0.0};
  for (const SituationHistory& at : histories) {
    const TurningPoint in = at.history.largest(use);
    const double with_factor = at.situation->load_factor * in.value;
    if (with_factor > worst.use) worst = {&at, in, with_factor};
  }
  return worst;
}

/// Whether what acts leaves a plate that does not work whole.
bool buckles_under(const EffectiveBox& box, const CutForces& cut) {
  const auto buckles = [&](ActingAlone acting) {
    const SectionAlone& of = box.alone(acting);
    return std::any_of(of.walls.begin(), of.walls.end(),
                       [](const WallAlone& wall) { return wall.buckles(); });
  };
  using enum ActingAlone;
  const CornerUse worst = box.worst_corner(cut);
  return (cut.N.value() < 0.0 && buckles(compression)) ||
         (worst.M_y.value() != 0.0 &&
          buckles(worst.M_y.value() > 0.0 ? M_y_positive : M_y_negative)) ||
         (worst.M_z.value() != 0.0 &&
          buckles(worst.M_z.value() > 0.0 ? M_z_positive : M_z_negative));
}

/// A use this small is none, as stress is (`no_stress_at`).
constexpr double no_use = 1e-6;

}  // namespace

bool may_buckle(const BoxWall& wall) {
  return wall.clear() / wall.thickness >
         internal_part_limits(1.0, 1.0, epsilon_of(wall.class_strength)).class_3;
}

std::string stiffener_obstacle(const FourWalls& of) {
  for (const BoxPlate plate : box_plates) {
    const BoxWall& wall = of.of(plate);
    const auto twists = [&](const FlatStiffener& bar) {
      return !resists_torsional_buckling(bar, wall.class_strength);
    };
    const auto bar = std::find_if(wall.stiffeners.begin(), wall.stiffeners.end(), twists);
    if (bar != wall.stiffeners.end()) {
      return fmt::format("a stiffener of the {} twists: d/t = {:.3g}, above 13 eps (9.2.1(8))",
                         to_text(plate), (bar->depth / bar->thickness).value());
    }
    const StiffenedPlate as_plate = stiffened_plate_of(wall, {});
    if (!wall.stiffeners.empty() && may_buckle(wall) && !are_stiff_enough(as_plate)) {
      return fmt::format("the stiffeners of the {} are too weak, gamma = {:.3g} below 25",
                         to_text(plate), relative_stiffness(as_plate));
    }
  }
  return "";
}

std::optional<FourWalls> judged_walls_at(const Project& project, const Station& station) {
  return four_walls_at(project, station, walls_of_segment(project, station));
}

Force ShearedPlate::force_of(const CutForces& cut) const {
  double sum = 0.0, most = 0.0, most_of_pieces = 0.0;
  for (const Piece& piece : pieces) {
    std::array<double, 3> stress{};
    for (std::size_t i = 0; i < stress.size(); ++i) {
      for (std::size_t k = 0; k < cut_force::count; ++k) {
        const double acting = value_of(cut, static_cast<cut_force::Index>(k));
        // What is not known counts only where it acts.
        if (acting != 0.0) stress[i] += piece.per_cut_force[i][k] * acting;
      }
      most = std::max(most, std::abs(stress[i]));
    }
    // Simpson's rule is exact for a parabola.
    const double mean = (stress[0] + 4.0 * stress[1] + stress[2]) / 6.0;
    sum += piece.width * mean;
    most_of_pieces = std::max(most_of_pieces, std::abs(mean));
  }
  double mean = std::abs(sum);
  if (is_flange(plate)) mean = std::max(mean, 0.5 * most);
  if (is_flange(plate) && pieces.size() > 1) mean = std::max(mean, most_of_pieces);
  return si<Stress>(mean) * (panel.depth * panel.thickness);
}

std::shared_ptr<const EffectiveBox> box_under(const std::shared_ptr<const SlenderPlates>& plates,
                                              const CutForces& cut, WidthRule rule) {
  const EffectiveBox& box = plates->box;
  if (rule != WidthRule::at_yield) {
    if (auto below = lower_box(box, cut, rule, box.use(cut)))
      return std::make_shared<EffectiveBox>(std::move(*below));
  }
  return {plates, &box};
}

WebInteraction interaction_of(const ShearedPlate& plate, const PlasticBox& plastic,
                              const CornerUse& corner, const CutForces& cut, double gamma_M0) {
  const double eta_1 = gamma_M0 * corner.use;
  const double eta_3 = plate.force_of(cut) / plate.resists.resistance;
  if (!is_flange(plate.plate)) return plastic.web_under(cut, corner, gamma_M0, eta_1, eta_3);
  const double factor = interaction_factor(eta_1, eta_3);
  return {1.0 / factor, 0.0, factor, corner.M_y};
}

std::vector<ShearedPlate> sheared_plates_of(const Section& section, const FourWalls& walls,
                                            const Taper& taper, bool in_plane, double gamma_M1) {
  const StressField field = stress_field_of(section, {}, taper);
  const BoxWall& left = walls.of(BoxPlate::left_web);
  const BoxWall& right = walls.of(BoxPlate::right_web);
  const bool alike = in_plane && is_mirrored(field) &&
                     left.yield_strength == right.yield_strength &&
                     left.class_strength == right.class_strength;
  std::vector<ShearedPlate> plates;
  for (const WallStretch& stretch : wall_stretches_of(field)) {
    if (stretch.solid || stretch.round || !field.flow) continue;
    const auto plate = plate_of(field.flow->at.graph.walls[stretch.wall].part);
    if (!plate || (alike && *plate == BoxPlate::right_web)) continue;
    auto at = std::find_if(plates.begin(), plates.end(),
                           [&](const ShearedPlate& of) { return of.plate == *plate; });
    if (at == plates.end())
      at = plates.insert(at, sheared_plate(gamma_M1, walls.of(*plate), *plate, alike));
    at->pieces.push_back(piece_of(field, stretch));
  }
  for (ShearedPlate& plate : plates) {
    double width = 0.0;
    for (const ShearedPlate::Piece& piece : plate.pieces) width += piece.width;
    for (ShearedPlate::Piece& piece : plate.pieces) piece.width /= width;
  }
  return plates;
}

std::string plates_obstacle(const Project& project, const Station& station) {
  const Section section = judged_section_at(project, station);
  const std::size_t index = segment_at(project.beam, station);
  const Segment& segment = project.beam.segments[index];
  if (section.inner) return "a profile inside another shares its buckling";
  const auto walls = four_walls_of(section.outer, materials_of(project, index));
  if (!walls) return "only boxes and rectangular tubes are";
  for (const FourWalls& end : walls_of_segment(project, station))
    if (std::string why = stiffener_obstacle(end); !why.empty()) return why;
  if (const double slope = slope_of(segment); slope > steepest) {
    return fmt::format("its edges are inclined by {:.3g} deg, above 10 deg (2.3)",
                       slope * 180.0 / std::numbers::pi);
  }
  for (const BeamHole& at : project.holes) {
    if (at.s < segment.start || at.s > segment.end()) continue;
    Length width;  // of all holes of these plates in one section
    for (const BeamHole& other : project.holes) {
      if (other.s != at.s || other.hole.walls != at.hole.walls) continue;
      const bool pair =
          other.hole.walls == HoleWalls::flanges && other.hole.position.value() != 0.0;
      width += (pair ? 2.0 : 1.0) * other.hole.diameter;
    }
    for (const BoxPlate plate : box_plates) {
      const bool drilled = (at.hole.walls == HoleWalls::flanges) == is_flange(plate);
      if (drilled && width > widest_opening * walls->of(plate).clear())
        return fmt::format("hole \"{}\" is wider than 0.05 of its plate (2.3)", at.hole.name);
    }
  }
  return "";
}

bool may_buckle_with_stiffeners(const Project& project, const Station& station, BoxPlate plate) {
  const std::vector<FourWalls> ends = walls_of_segment(project, station);
  return std::any_of(ends.begin(), ends.end(), [&](const FourWalls& of) {
    return !of.of(plate).stiffeners.empty() && may_buckle(of.of(plate));
  });
}

std::shared_ptr<const SlenderPlates> slender_plates_at(const Project& project,
                                                       const std::vector<BendingZone>& zones,
                                                       const Station& station) {
  const std::vector<FourWalls> ends = walls_of_segment(project, station);
  const bool slender = std::any_of(ends.begin(), ends.end(), [](const FourWalls& of) {
    return std::any_of(of.walls.begin(), of.walls.end(), may_buckle);
  });
  if (!slender || !plates_obstacle(project, station).empty()) return nullptr;
  const std::optional<FourWalls> walls = four_walls_at(project, station, ends);
  if (!walls) return nullptr;
  const Section section = judged_section_at(project, station);
  const LagShares lag = lag_shares_at(zones, section, station);
  const EffectiveBox box(*walls, lag);
  auto plates = std::make_shared<SlenderPlates>(SlenderPlates{box, PlasticBox(box), lag, {}});
  plates->sheared = sheared_plates_of(section, *walls, taper_at(project.beam, station),
                                      !project.in_space, project.strength.gamma_M1);
  divide_into_panels(project, station, plates->sheared);
  for (ShearedPlate& plate : plates->sheared) {
    plate.may_buckle = std::any_of(ends.begin(), ends.end(), [&](const FourWalls& of) {
      return may_buckle_in_shear(of.of(plate.plate));
    });
  }
  return plates;
}

Utilisations plate_uses_of(const Project& project, const SlenderPlates& plates,
                           const StationSamples& samples) {
  const PlateUses uses(project, plates);
  const double required = project.strength.required;
  Utilisations found;
  const auto look = [&](Criterion criterion, const auto& use) {
    double& of = found.of(criterion);
    of = std::max(of, required * samples.largest_use(use));
  };
  look(Criterion::effective_section, [&](const CutForces& cut) { return uses.normal(cut); });
  for (const ShearedPlate& plate : plates.sheared) {
    if (plate.may_buckle) {
      look(Criterion::shear_buckling,
           [&](const CutForces& cut) { return PlateUses::shear(plate, cut); });
    }
    look(Criterion::interaction,
         [&](const CutForces& cut) { return uses.together(plate, cut).use; });
  }
  return found;
}

std::vector<CheckResult> check_plates(const Project& project, const Station& station,
                                      const std::shared_ptr<const SlenderPlates>& plates,
                                      const std::vector<SituationHistory>& histories) {
  const PlateUses uses(project, *plates);
  std::vector<CheckResult> results;
  const auto add = [&](Criterion criterion, const Worst& worst, const ShearedPlate* plate) {
    if (!(worst.use > no_use)) return;
    CheckResult result;
    PlateBasis& basis = result.plates.emplace();
    basis.plates = plates;
    basis.cut = worst.at->history.at(worst.largest.time);
    const WidthRule rule = project.strength.effective_widths;
    basis.box = box_under(plates, basis.cut, rule);
    basis.corner = basis.box->worst_corner(basis.cut);
    basis.load_factor = worst.at->situation->load_factor;
    basis.plate = plate;
    Check& check = result.check;
    check.criterion = criterion;
    check.station = station;
    check.point = plate != nullptr ? plate->name : to_text(basis.corner.corner.flange);
    if (plate == nullptr && project.in_space)
      check.point += fmt::format(" at {}", to_text(basis.corner.corner.web));
    check.id = id_of(criterion, station, check.point);
    check.situation = worst.at->situation->name;
    check.time = worst.largest.time;
    check.safety_factor = 1.0 / worst.use;
    check.required = project.strength.required;
    if (criterion == Criterion::effective_section) {
      check.resisting = Stress(basis.corner.yield_strength / project.strength.gamma_M0);
      check.acting = Stress(check.resisting.value() * worst.use * pascal);
      const bool below = basis.box.get() != &plates->box;
      check.source = fmt::format("EN 1993-1-5:2006, 4.6, equation 4.15 (effective widths, {})",
                                 !below                       ? "4.4"
                                 : rule == WidthRule::annex_E ? "annex E"
                                                              : "4.4(4)");
    } else if (criterion == Criterion::shear_buckling) {
      check.resisting = plate->resists.resistance;
      check.acting = Force(worst.use * plate->resists.resistance);
      check.source = "EN 1993-1-5:2006, 5.5, equation 5.10 (without the flanges' part)";
    } else {
      check.resisting = 1.0;
      check.acting = worst.use;
      check.source = uses.together(*plate, basis.cut).share > 0.0
                         ? "EN 1993-1-5:2006, 7.1(1), equation 7.1"
                         : "EN 1993-1-5:2006, 7.1(5), equation 7.1";
    }
    results.push_back(std::move(result));
  };
  const Worst section = worst_of(histories, [&](const CutForces& cut) { return uses.normal(cut); });
  add(Criterion::effective_section, section, nullptr);
  Worst together{&histories.front(), {}, 0.0};
  const ShearedPlate* in_plate = nullptr;
  double most_shear = 0.0;
  for (const ShearedPlate& plate : plates->sheared) {
    if (plate.may_buckle) {
      add(Criterion::shear_buckling,
          worst_of(histories, [&](const CutForces& cut) { return PlateUses::shear(plate, cut); }),
          &plate);
    }
    const Worst of =
        worst_of(histories, [&](const CutForces& cut) { return uses.together(plate, cut).use; });
    if (!(of.use > no_use)) continue;
    // Where shear is small all plates are alike: the one that has most of it is named.
    const double shear = PlateUses::shear(plate, of.at->history.at(of.largest.time));
    constexpr double same = 1e-9;
    const bool less = of.use < (1.0 - same) * together.use;
    const bool alike = !less && of.use <= (1.0 + same) * together.use;
    if (in_plate != nullptr && (less || (alike && shear <= most_shear))) continue;
    most_shear = shear;
    together = of;
    in_plate = &plate;
  }
  if (in_plate != nullptr) add(Criterion::interaction, together, in_plate);
  return results;
}

void leave_out_covered(const Project& project, std::vector<CheckResult>& checks) {
  const auto worst_by = [&](Criterion criterion) -> const CheckResult* {
    const CheckResult* most = nullptr;
    for (const CheckResult& of : checks) {
      if (of.check.criterion == criterion &&
          (most == nullptr || of.check.utilisation() > most->check.utilisation()))
        most = &of;
    }
    return most;
  };
  const auto use_by = [&](Criterion criterion) {
    const CheckResult* const most = worst_by(criterion);
    return most == nullptr ? 0.0 : most->check.utilisation();
  };
  const auto drop = [&](Criterion criterion, double others, const auto& says_more) {
    const CheckResult* const most = worst_by(criterion);
    constexpr double round_off = 1e-9;
    if (most == nullptr || most->check.utilisation() > (1.0 + round_off) * others ||
        says_more(*most->plates))
      return;
    std::erase_if(checks, [&](const CheckResult& of) { return of.check.criterion == criterion; });
  };
  const double yield = use_by(Criterion::yield);
  const double section = use_by(Criterion::effective_section);
  drop(Criterion::interaction, std::max({yield, section, use_by(Criterion::shear_buckling)}),
       [&](const PlateBasis& basis) {
         const double normal = PlateUses(project, *basis.plates).normal(basis.cut);
         const double shear = PlateUses::shear(*basis.plate, basis.cut);
         return 2.0 * shear > normal && !(basis.plate->may_buckle && normal <= no_use);
       });
  drop(Criterion::effective_section, yield,
       [](const PlateBasis& basis) { return buckles_under(*basis.box, basis.cut); });
}

}  // namespace boxbeam
