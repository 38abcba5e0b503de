#include "boxbeam/verification/member_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Moments across the plane, of the straight beam, grow as a bow does.
double bent_by(const SecondOrderEstimate& estimate) {
  if (!(estimate.bending_across > 0.0)) return estimate.bending;
  const double part = estimate.across ? estimate.across->part : 0.0;
  return estimate.bending + estimate.bending_across / std::max(1e-6, 1.0 - part);
}

CheckResult check_of(const Project& project, double use, const std::string& point,
                     std::size_t situation, Time when, MemberBasis basis) {
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::member;
  check.on_beam = false;
  check.point = point;
  check.id = fmt::format("member-buckling/{}", basis.turns_over ? "sideways" : point);
  std::replace(check.id.begin(), check.id.end(), ' ', '-');
  check.situation = project.situations[situation].name;
  check.time = when;
  // Under the design loads, in which the safety factor that is asked for is.
  check.acting = use / demanded_of(project);
  check.resisting = 1.0;
  check.safety_factor = demanded_of(project) / use;
  check.required = project.strength.required;
  check.source =
      fmt::format("EN 1993-1-1:2005, {}, curve {}", basis.turns_over ? "6.3.4" : "6.3.1 and 6.3.3",
                  basis.curve == BucklingCurve::d ? "d" : "c");
  result.member = std::move(basis);
  return result;
}

/// What slender plates and shear lag take from a member, the most of some stations of each segment:
/// A/A_eff and W/W_eff, by which N/(A f_y) and M/(W f_y) grow, and how much of the latter, about y
/// and about z, the shift of N's centroid makes of the former.
struct MemberLoss {
  double area = 1.0, modulus = 1.0, shift_y = 0.0, shift_z = 0.0;
};

void add_loss(const Project& project, const std::vector<BendingZone>& zones, const Station& station,
              MemberLoss& loss) {
  const auto path = slender_path_at(project, zones, station);
  if (!path) return;
  const EffectivePath& of = path->section;
  const AreaSums& gross = of.path().gross;
  const Extent extent = extent_of(judged_section_at(project, station).outer);
  const double area = of.alone(ActingAlone::compression).sums.area;
  loss.area = std::max(loss.area, gross.area / area);
  for (const bool about_y : {true, false}) {
    const double first = about_y ? gross.z : gross.y, second = about_y ? gross.zz : gross.yy;
    const Length depth = about_y ? extent.z_high - extent.z_low : extent.y_high - extent.y_low;
    // M/W of the whole section is half the difference of its fibres.
    const double whole = (second - first * first / gross.area) / (0.5 * depth.value());
    const double left = of.least_modulus(about_y).value();
    loss.modulus = std::max(loss.modulus, whole / left);
    const Length e = about_y ? of.centroid().shift_z : of.centroid().shift_y;
    double& shift = about_y ? loss.shift_y : loss.shift_z;
    shift = std::max(shift, area * std::abs(e.value()) / left);
  }
}

double least_modulus_of(const EffectiveBox& box, bool about_y) {
  double least = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    CutForces cut;
    (about_y ? cut.M_y : cut.M_z) = si<Moment>(sign);
    const CornerUse worst = box.worst_corner(cut);
    least = std::min(least, std::abs((about_y ? worst.W_y : worst.W_z).value()));
  }
  return least;
}

/// What shear lag alone takes from the moduli of a box whose plates do not buckle.
void add_lag_loss(const Project& project, const std::vector<BendingZone>& zones,
                  const Station& station, MemberLoss& loss) {
  if (zones.empty()) return;
  const LagShares lag = lag_shares_at(zones, judged_section_at(project, station), station);
  if (lag.flanges == 1.0 && lag.webs == 1.0) return;
  const auto walls = judged_walls_at(project, station);
  if (!walls) return;
  const EffectiveBox whole(*walls), left(*walls, lag);
  for (const bool about_y : {true, false})
    loss.modulus =
        std::max(loss.modulus, least_modulus_of(whole, about_y) / least_modulus_of(left, about_y));
}

/// The same of a box.
void add_box_loss(const Project& project, const std::vector<BendingZone>& zones,
                  const Station& station, MemberLoss& loss) {
  const auto plates = slender_plates_at(project, zones, station);
  if (!plates) {
    add_lag_loss(project, zones, station, loss);
    return;
  }
  const EffectiveBox& of = plates->box;
  const double area = of.alone(ActingAlone::compression).sums.area;
  loss.area = std::max(loss.area, of.box().gross.area / area);
  const SectionProperties whole = properties_of(judged_section_at(project, station));
  for (const bool about_y : {true, false}) {
    const double left = least_modulus_of(of, about_y);
    loss.modulus = std::max(loss.modulus, (about_y ? whole.W_y : whole.W_z).value() / left);
    double& shift = about_y ? loss.shift_y : loss.shift_z;
    shift =
        std::max(shift, area * std::abs((about_y ? of.shift_z() : of.shift_y()).value()) / left);
  }
}

MemberLoss loss_of(const Project& project, const std::vector<BendingZone>& zones) {
  constexpr int inside = 8;
  MemberLoss loss;
  const auto look_at = [&](const Station& station) {
    add_loss(project, zones, station, loss);
    add_box_loss(project, zones, station, loss);
  };
  // Of shear lag the widths that work change at the ends of zones and in them.
  for (const BendingZone& zone : zones) {
    look_at({zone.from, Side::behind});
    look_at({zone.to, Side::before});
    look_at({0.5 * (zone.from + zone.to)});
  }
  for (const Segment& segment : project.beam.segments) {
    look_at({segment.start, Side::behind});
    look_at({segment.end(), Side::before});
    for (int i = 1; i < inside && segment.from != segment.to; ++i)
      look_at({segment.start + segment.length * (static_cast<double>(i) / inside)});
  }
  return loss;
}

/// Of welded profiles, whose own fabrication stresses count: curve c, of open ones with walls above
/// 40 mm curve d. Source: EN 1993-1-1:2005, table 6.2.
BucklingCurve bending_curve_of(const TaperedBeam& beam) {
  const auto has_thick_walls = [](const Section& section) {
    const auto* const path = std::get_if<ThinWalled>(&section.outer);
    return path != nullptr &&
           std::any_of(path->walls.begin(), path->walls.end(),
                       [](const ThinWall& wall) { return wall.thickness > si<Length>(40e-3); });
  };
  const auto is_thick = [&](const Segment& segment) {
    return has_thick_walls(segment.from) || has_thick_walls(segment.to);
  };
  return std::any_of(beam.segments.begin(), beam.segments.end(), is_thick) ? BucklingCurve::d
                                                                           : BucklingCurve::c;
}

/// About which axes a beam is the stronger one somewhere along it.
struct StrongerAxes {
  bool y = false, z = false;
};

StrongerAxes stronger_axes_of(const TaperedBeam& beam) {
  constexpr int steps = 8;
  constexpr double alike = 1.0 + 1e-9;
  StrongerAxes of;
  for (const Segment& segment : beam.segments) {
    for (int i = 0; i <= steps; ++i) {
      const SectionProperties at =
          properties_of(interpolate(segment.from, segment.to, static_cast<double>(i) / steps));
      (at.I_z > alike * at.I_y ? of.z : of.y) = true;
    }
  }
  return of;
}

/// N/N_cr of bending about the weaker axis, in which a beam that turns over bends. Of one that lies
/// along z as well, for what a whole in space bends in is taken for it.
double sideways_part(const SecondOrderEstimate& estimate, const StrongerAxes& stronger) {
  const double across = estimate.across ? estimate.across->part : 0.0;
  return stronger.z ? std::max(across, estimate.in_plane.part) : across;
}

}  // namespace

std::vector<CheckResult> check_member(const Project& project, const std::vector<BendingZone>& zones,
                                      const SecondOrderEstimate& estimate) {
  const std::optional<BucklingLoad>& twisting = estimate.twisting;
  std::vector<CheckResult> checks;
  const double gamma_M1 = project.strength.gamma_M1;
  const auto counts = [](const auto& of, double least) { return of && of->part > least; };
  const bool looked_at = estimate.in_plane.part > no_buckling_below ||
                         counts(estimate.across, no_buckling_below) || twisting ||
                         counts(estimate.lateral, no_turning_over_below);
  if (!looked_at) return checks;
  const MemberLoss loss = loss_of(project, zones);
  MemberLoad load{loss.area * estimate.compressed};
  const double of_y = loss.shift_y * load.compressed, of_z = loss.shift_z * load.compressed;
  load.bent = loss.modulus * bent_by(estimate) + of_y + of_z;
  MemberLoad::Straight& straight = load.straight;
  straight.m_y = loss.modulus * estimate.straight + of_y;
  straight.m_z = loss.modulus * estimate.bending_across + of_z;
  straight.turning = estimate.lateral ? estimate.lateral->part : 0.0;
  straight.twists = std::any_of(
      project.beam.segments.begin(), project.beam.segments.end(),
      [](const Segment& of) { return std::holds_alternative<ThinWalled>(of.from.outer); });
  straight.C_my = project.strength.C_my;
  straight.C_mz = project.strength.C_mz;
  const BucklingCurve curve = bending_curve_of(project.beam);
  const double in_plane = estimate.in_plane.part;
  const double across = estimate.across ? estimate.across->part : 0.0;
  const StrongerAxes stronger = stronger_axes_of(project.beam);
  // Where along a beam now the one and now the other axis is the stronger, the worse of both.
  const auto bends = [&](const BucklingLoad& of, const char* how, std::optional<bool> about_z) {
    load.critical = of.part;
    double most = -1.0;
    MemberLoad worst;
    for (const bool lies : {false, true}) {
      // What twists bends about both axes, by whichever a section is the stronger one.
      if (lies ? !stronger.z : about_z && !stronger.y) continue;
      straight.lies = lies;
      straight.about_z = about_z.value_or(!lies);
      straight.other = straight.about_z ? in_plane : across;
      const double use = flexural_use(load, curve, gamma_M1);
      if (use <= most) continue;
      most = use;
      worst = load;
    }
    checks.push_back(
        check_of(project, most, how, of.situation, of.when, {false, curve, of.held, worst}));
  };
  const auto counted = [](double part) { return part > no_buckling_below && part < 1.0; };
  if (counted(in_plane))
    bends(estimate.in_plane, project.in_space ? "along z" : "in the plane of motion", false);
  if (counted(across))
    bends(*estimate.across, project.in_space ? "along y" : "across the plane of motion", true);
  if (twisting) bends(*twisting, "by twisting", std::nullopt);
  if (const auto& of = estimate.lateral; of && of->part > no_turning_over_below && of->part < 1.0) {
    const double sideways = sideways_part(estimate, stronger);
    load.critical = of->part + (twisting ? std::max(sideways, twisting->part) : sideways);
    const double use = lateral_use(load, BucklingCurve::d, gamma_M1);
    const bool given = std::holds_alternative<recorded::Loads>(project.mechanism);
    if (!(use > 0.0) && given)
      throw AnalysisError(
          {"forces across the beam but no moment anywhere: the given cut forces "
           "contradict each other; give M_y and M_z that belong to V_z and V_y",
           "beam"});
    // Without a moment anywhere nothing turns over.
    if (use > 0.0)
      checks.push_back(check_of(project, use, "sideways and turning over", of->situation, of->when,
                                {true, BucklingCurve::d, of->held, load}));
  }
  return checks;
}

}  // namespace boxbeam
