#include "boxbeam/verification/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"

namespace boxbeam {
namespace {

/// Below this part of its largest stress a plate's compression has no class.
constexpr double negligible = 0.01;

/// A plate of a box or tube between its neighbours, seen as a web: what bends it in its plane.
struct Web {
  std::string name;
  SectionPlace low, high;  ///< ends of its clear width, on its mid-line
  Length thickness;
  PlateKind kind = PlateKind::wall;
  bool flange = false;

  Length depth() const { return flange ? high.y - low.y : high.z - low.z; }
};

Web upright(const std::string& name, double y, Length low, Length high, Length thickness,
            PlateKind kind) {
  return {name, {si<Length>(y), low}, {si<Length>(y), high}, thickness, kind};
}

/// One web where both are stressed alike, which they are in a section that mirrors itself.
std::vector<Web> webs_of(const Profile& profile, bool alike) {
  const Length low = clear_bottom_of(profile);
  const Length high = clear_top_of(profile);
  if (const auto* box = std::get_if<Box>(&profile)) {
    const double left = (0.5 * box->width - 0.5 * box->left_web).value();
    const double right = (0.5 * box->right_web - 0.5 * box->width).value();
    if (alike) return {upright("web", left, low, high, box->left_web, PlateKind::left_web)};
    return {upright("left web", left, low, high, box->left_web, PlateKind::left_web),
            upright("right web", right, low, high, box->right_web, PlateKind::right_web)};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double left = 0.5 * (tube->width - tube->wall).value();
    if (alike) return {upright("web", left, low, high, tube->wall, PlateKind::wall)};
    return {upright("left web", left, low, high, tube->wall, PlateKind::wall),
            upright("right web", -left, low, high, tube->wall, PlateKind::wall)};
  }
  return {};
}

/// Whether the webs of a section are stressed alike in the plane and are of one material.
bool webs_are_alike(const Section& section, const PlateMaterials& materials) {
  return is_symmetric_about_z(section) &&
         &materials.of(PlateKind::left_web) == &materials.of(PlateKind::right_web);
}

/// All four plates: under M_z and N the webs are stressed unlike, and the flanges are the webs of
/// V_y.
std::vector<Web> plates_of(const Profile& profile) {
  Box box;
  const bool built = std::holds_alternative<Box>(profile);
  const auto kind = [&](PlateKind of) { return built ? of : PlateKind::wall; };
  if (built)
    box = std::get<Box>(profile);
  else if (const auto* tube = std::get_if<RectangularTube>(&profile))
    box = symmetric_box(tube->width, tube->height, tube->wall, tube->wall);
  else
    return {};
  const Length low = clear_bottom_of(profile), high = clear_top_of(profile);
  const Length left = 0.5 * box.width - box.left_web, right = box.right_web - 0.5 * box.width;
  const Length top = 0.5 * (box.height - box.top_flange);
  const Length bottom = 0.5 * (box.bottom_flange - box.height);
  const double left_middle = 0.5 * (box.width - box.left_web).value();
  const double right_middle = 0.5 * (box.right_web - box.width).value();
  return {
      upright("left web", left_middle, low, high, box.left_web, kind(PlateKind::left_web)),
      upright("right web", right_middle, low, high, box.right_web, kind(PlateKind::right_web)),
      {"top flange", {right, top}, {left, top}, box.top_flange, kind(PlateKind::top_flange), true},
      {"bottom flange",
       {right, bottom},
       {left, bottom},
       box.bottom_flange,
       kind(PlateKind::bottom_flange),
       true}};
}

/// The stress over a web that comes nearest to its limit of class 3.
struct WorstStress {
  double psi = -1.0;
  double most = 0.0;   ///< compression [Pa], with load factor and required safety factor
  double limit = 0.0;  ///< of c/t; 0 where nothing is compressed
};

/// Compression at the ends of a web at an instant [Pa].
struct EndStress {
  double low = 0.0, high = 0.0;
  double most() const { return std::max(low, high); }
};

/// Where between two instants the stress distribution may be the most even one that has a class:
/// the larger compression reaches `least`, or both are equal. Between instants stresses count as
/// linear, so that psi runs one way between these places.
std::array<EndStress, 4> between(const EndStress& a, const EndStress& b, double least) {
  std::array<EndStress, 4> places{b, b, b, b};
  const auto place = [&](std::size_t k, double from, double to) {
    if (from * to >= 0.0) return;
    const double part = from / (from - to);
    places[k] = {a.low + part * (b.low - a.low), a.high + part * (b.high - a.high)};
  };
  place(1, a.low - least, b.low - least);
  place(2, a.high - least, b.high - least);
  place(3, a.low - a.high, b.low - b.high);
  return places;
}

/// The limit of class 3 as it is for a part that is not stressed up to its yield strength: epsilon
/// grows by sqrt((f_y/gamma_M0)/sigma_com,Ed), EN 1993-1-1, 5.5.2(9); but not where members are
/// verified for buckling, 5.5.2(10).
class Class3Limit {
 public:
  Class3Limit(const StrengthDemand& demand, Stress yield, bool member_buckles)
      : per_stress_(demand.gamma_M0 / yield.value()),
        epsilon_(epsilon_of(yield)),
        member_buckles_(member_buckles) {}

  double epsilon() const { return epsilon_; }
  double at(double psi, double design_stress) const {
    const double used = member_buckles_ ? 1.0 : std::min(1.0, per_stress_ * design_stress);
    return internal_part_limits(1.0, psi, epsilon_).class_3 / std::sqrt(used);
  }

 private:
  double per_stress_, epsilon_;
  bool member_buckles_;
};

WorstStress worst_over(const std::vector<SituationHistory>& histories,
                       const StressInfluence& at_low, const StressInfluence& at_high,
                       double required, const Class3Limit& limit) {
  const auto stress_in = [&](const CutForces& cut) {
    return EndStress{-stress_at(at_low, cut).normal.value(),
                     -stress_at(at_high, cut).normal.value()};
  };
  double largest = 0.0;
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      const EndStress stress = stress_in(cut);
      largest = std::max({largest, std::abs(stress.low), std::abs(stress.high)});
    }
  }
  const double least = negligible * largest;
  WorstStress worst;
  for (const SituationHistory& at : histories) {
    const double factor = required * at.situation->load_factor;
    const auto take = [&](const EndStress& stress) {
      constexpr double rounding = 1e-9;
      const double most = stress.most();
      if (most < (1.0 - rounding) * least || most <= 0.0) return;
      const double psi = std::min(stress.low, stress.high) / most;
      const double here = limit.at(psi, factor * most);
      if (worst.limit == 0.0 || here < worst.limit) worst = {psi, factor * most, here};
    };
    const std::vector<CutForces>& samples = at.history.samples();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const EndStress here = stress_in(samples[i]);
      if (at.history.begins_piece(i) || (i == 0 && !at.history.closed())) {
        take(here);
        continue;
      }
      const EndStress before = stress_in(i > 0 ? samples[i - 1] : samples.back());
      for (const EndStress& stress : between(before, here, least)) take(stress);
    }
  }
  return worst;
}

std::string class_4_text(double ratio, double limit, const std::string& effective) {
  return fmt::format(
      "c/t = {:.3g} is above {:.3g}, class 4 (EN 1993-1-1, table 5.2): it may buckle "
      "before it yields, and the stress of the full section is not valid{}",
      ratio, limit, effective);
}

/// The longest edge of a polygon over the mean thickness of its material, 2 A/perimeter: c/t of a
/// strip and of the walls of a hollow square.
double wall_ratio_of(const Polygon& polygon, Area area) {
  double longest = 0.0, perimeter = 0.0;
  const auto walk = [&](const std::vector<SectionPlace>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const SectionPlace &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const double edge = std::hypot((b.y - a.y).value(), (b.z - a.z).value());
      longest = std::max(longest, edge);
      perimeter += edge;
    }
  };
  walk(polygon.outer);
  for (const std::vector<SectionPlace>& hollow : polygon.hollows) walk(hollow);
  return longest * perimeter / (2.0 * area.value());
}

}  // namespace

PlateGates::PlateGates(const Project& project, const std::vector<BendingZone>& zones,
                       const ModelChoice& model)
    : project_(&project), zones_(&zones) {
  const SecondOrderEstimate& of = model.second_order;
  member_buckles_ =
      of.in_plane.part > no_buckling_below || (of.across && of.across->part > no_buckling_below);
}

void PlateGates::add(const std::string& kind, Gate gate, double excess) {
  const std::string key = kind + "/" + gate.segment + "/" + gate.plate;
  const auto found = worst_.find(key);
  if (found != worst_.end() && found->second.second >= excess) return;
  if (found == worst_.end()) order_.push_back(key);
  worst_[key] = {std::move(gate), excess};
}

std::vector<Gate> PlateGates::gates() const {
  std::vector<Gate> gates;
  for (const std::string& key : order_) gates.push_back(worst_.at(key).first);
  return gates;
}

void PlateGates::look_at_class(const std::string& segment, const Profile& profile,
                               const PlateMaterials& materials, bool alike, const AreaSums& sums,
                               const std::vector<SituationHistory>& histories,
                               const std::string& obstacle, bool judged) {
  const Project& project = *project_;
  const std::vector<Web> webs = project.in_space ? plates_of(profile) : webs_of(profile, alike);
  const std::string why_not = obstacle.empty() ? "" : "; its buckling is not judged: " + obstacle;
  for (const SlenderPlate& plate : slender_plates_of(profile, materials)) {
    if (!judged) {
      add("class", {segment, plate.plate, class_4_text(plate.ratio, plate.limit, why_not), true},
          plate.ratio / plate.limit);
    }
  }
  if (const auto* const polygon = std::get_if<Polygon>(&profile)) {
    // What its plates are nobody knows: where all of it is one as slender as class 4.
    const double ratio = wall_ratio_of(*polygon, properties_of({profile, {}}).area);
    constexpr double limit = 42.0;
    if (ratio > limit)
      add("class",
          {segment, "polygon",
           fmt::format("its longest edge is {:.3g} times as long as it is thick in the mean, above "
                       "{:.3g}: plates of it may buckle, which is not judged of polygons: write it "
                       "as kind = \"box\" or \"thin-walled\"",
                       ratio, limit),
           true},
          ratio / limit);
  }
  for (const Web& web : webs) {
    const auto yield = yield_strength_of(materials.of(web.kind), web.thickness);
    if (!yield) continue;
    const Class3Limit class_3(project.strength,
                              *class_yield_of(profile, materials, web.kind, web.thickness),
                              member_buckles_);
    const auto at = [&](const SectionPlace& end) {
      return normal_influence(sums, end.y.value(), end.z.value());
    };
    const double ratio = web.depth() / web.thickness;
    // A flange counts as evenly compressed, on the safe side, see slender_plates_of.
    const WorstStress worst = web.flange ? WorstStress{}
                                         : worst_over(histories, at(web.low), at(web.high),
                                                      project.strength.required, class_3);
    const auto effective =
        worst.limit > 0.0 ? internal_effective_width(web.depth(), web.thickness,
                                                     std::max(-3.0, worst.psi), class_3.epsilon())
                          : std::nullopt;
    if (worst.limit > 0.0 && ratio > worst.limit && !judged) {
      const std::string stress = fmt::format(
          "; under {:.3g} MPa, psi = {:.2f}{}", worst.most * 1e-6, worst.psi,
          member_buckles_ ? "; the member is verified for buckling (5.5.2(10))" : " (5.5.2(9))");
      const std::string widths =
          effective ? fmt::format(
                          ", rho = {:.3g} of its compressed width is effective at yield "
                          "(EN 1993-1-5, 4.4)",
                          effective->rho)
                    : "";
      add("class",
          {segment, web.name,
           class_4_text(ratio, worst.limit, fmt::format("{}{}{}", stress, widths, why_not)), true},
          ratio / worst.limit);
    }
    const ShearBucklingNeed need =
        shear_buckling_need(web.depth(), web.thickness, *yield, shear_hardening_factor(*yield));
    if (need.check_needed() && !judged) {
      add("shear buckling",
          {segment, web.name,
           fmt::format("h_w/t_w = {:.3g} is above 72 eps/eta = {:.3g}: the {} may buckle in "
                       "shear, and its resistance is that of EN 1993-1-5, clause 5 (5.1(2)){}",
                       need.ratio, need.limit, web.flange ? "flange" : "web", why_not),
           true},
          need.ratio / need.limit);
    }
  }
}

/// Says the worst of a segment, not its station, so that segments of which the same is true stand
/// together.
void PlateGates::look_at_shear_lag(const std::string& segment, const std::string& plate,
                                   const std::optional<ShearLag>& lag) {
  if (!lag) return;
  add("shear lag",
      {segment, plate,
       fmt::format("b_0 = {:.4g} mm is above L_e/50, L_e = {:.3g} m between zero moments: "
                   "shear lag counts; with kappa = {:.3g} a part of the width works, beta = "
                   "{:.3g} of it at the worst station, and the normal stresses are those of "
                   "the section so reduced (EN 1993-1-5, 3.1 and 3.2.1)",
                   lag->b_0.value() * 1e3, lag->effective_length.value(), lag->kappa, lag->beta),
       false},
      -lag->beta);
}

/// Of a path the flanges are any plates that lie along the axis of bending, within 45 degrees. Its
/// effective section counts shear lag, the stresses of the whole one do not.
void PlateGates::look_at_path_lag(const std::string& segment, const Station& station,
                                  const PathSection& section, bool counts) {
  for (const PathPlate& plate : section.plates) {
    const bool along_y = std::abs(plate.direction.x()) > std::abs(plate.direction.y());
    const auto lag = plate_lag_at(*zones_, station, along_y ? BendingAxis::y : BendingAxis::z,
                                  lagging_width_of(section, plate), plate.thickness);
    if (!lag) continue;
    const bool blocks = !counts || project_->fatigue.asked;
    add("shear lag",
        {segment, plate.name,
         fmt::format("b_0 = {:.4g} mm is above L_e/50, L_e = {:.3g} m between zero moments: shear "
                     "lag counts; with kappa = {:.3g} a part of the width works, {}{}",
                     lag->b_0.value() * 1e3, lag->effective_length.value(), lag->kappa,
                     counts ? fmt::format("beta^kappa = {:.3g} of it in the effective section at "
                                          "the worst station (EN 1993-1-5, 3.3)",
                                          ultimate_share_of(*lag))
                            : fmt::format("beta = {:.3g} (EN 1993-1-5, 3.2), which the stresses of "
                                          "walls that are not slender do not count",
                                          lag->beta),
                     counts && blocks
                         ? fmt::format("; the stresses by which fatigue is judged are those of "
                                       "the whole section, without beta = {:.3g} (3.2)",
                                       lag->beta)
                         : std::string()),
         blocks},
        -lag->beta);
  }
}

void PlateGates::look_at(const std::vector<CheckResult>& checks) {
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield || check.safety_factor >= 1.0) continue;
    add("yield",
        {"", "",
         fmt::format("at s = {} m, {} the stress is above the yield strength: there the beam "
                     "is not elastic, and its fatigue factors mean nothing",
                     to_text(check.station), check.point),
         true},
        1.0 / check.safety_factor);
  }
}

double class_3_use_at(const Project& project, const Station& station,
                      const std::vector<SituationHistory>& histories) {
  const Section section = judged_section_at(project, station);
  const bool alike =
      webs_are_alike(section, materials_of(project, segment_at(project.beam, station)));
  std::optional<AreaSums> sums;
  double largest = 0.0;
  const std::size_t segment = segment_at(project.beam, station);
  const PlateMaterials outer = materials_of(project, segment);
  const PlateMaterials inner(outer.of(PlateKind::inner));
  const auto look_at = [&](const Profile& profile, const PlateMaterials& materials) {
    for (const Web& web : project.in_space ? plates_of(profile) : webs_of(profile, alike)) {
      const auto yield = class_yield_of(profile, materials, web.kind, web.thickness);
      if (web.flange || !yield) continue;
      const double ratio = web.depth() / web.thickness;
      if (ratio <= internal_part_limits(1.0, 1.0, epsilon_of(*yield)).class_3) continue;
      if (!sums) sums = sums_of(outline_of(section, {}));
      const auto at = [&](const SectionPlace& end) {
        return normal_influence(*sums, end.y.value(), end.z.value());
      };
      const WorstStress worst =
          worst_over(histories, at(web.low), at(web.high), project.strength.required,
                     Class3Limit(project.strength, *yield, false));
      if (worst.limit > 0.0) largest = std::max(largest, ratio / worst.limit);
    }
  };
  look_at(section.outer, outer);
  if (section.inner) look_at(*section.inner, inner);
  return largest;
}

void PlateGates::look_at(const Station& station, const std::vector<SituationHistory>& histories) {
  const Section section = judged_section_at(*project_, station);
  const TaperedBeam& beam = project_->beam;
  const std::size_t index = segment_at(beam, station);
  const std::string& segment = beam.segments[index].name;
  const PlateMaterials materials = materials_of(*project_, index);
  const AreaSums sums = sums_of(outline_of(section, {}));
  const bool alike = webs_are_alike(section, materials);
  const std::string obstacle = plates_obstacle(*project_, station);
  const auto judged = slender_plates_at(*project_, *zones_, station);
  const auto path = slender_path_at(*project_, *zones_, station);
  look_at_class(segment, section.outer, materials, alike, sums, histories, obstacle,
                judged != nullptr || path != nullptr);
  if (section.inner) {
    look_at_class(segment, *section.inner, materials.of(PlateKind::inner), alike, sums, histories,
                  obstacle, false);
  }
  if (judged != nullptr) look_at_slender(segment, *judged, sums, histories);
  if (path != nullptr) {
    look_at_slender(segment, *path, histories);
    look_at_path_lag(segment, station, path->section.path(), true);
  } else if (const auto stout = judged_path_at(*project_, *zones_, station)) {
    look_at_path_lag(segment, station, *stout, false);
  }
  for (const BoxPlate plate : {BoxPlate::top_flange, BoxPlate::bottom_flange}) {
    // Webs are looked at without their stiffeners above, under the stress that is there.
    if (judged != nullptr || !may_buckle_with_stiffeners(*project_, station, plate)) continue;
    add("stiffened",
        {segment, to_text(plate),
         fmt::format(
             "its stiffeners may buckle with it (EN 1993-1-5, 4.5), which is not judged: {}",
             obstacle),
         true},
        1.0);
  }
  const ShearLags lags = shear_lags_at(*zones_, section, station);
  look_at_shear_lag(segment, "flange", lags.flanges);
  look_at_shear_lag(segment, "web as flange of M_z", lags.webs);
}

}  // namespace boxbeam
