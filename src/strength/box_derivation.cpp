#include <fmt/format.h>

#include "boxbeam/strength/effective_box.hpp"
#include "plate_formulas.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

/// "both webs" where these are alike.
std::string name_of(BoxPlate plate, bool both) {
  if (!both) return to_text(plate);
  return is_flange(plate) ? "both flanges" : "both webs";
}

bool alike(const FourWalls& box, const SectionAlone& section, BoxPlate a, BoxPlate b) {
  const BoxWall& wall = box.of(a);
  const BoxWall& other = box.of(b);
  return wall.stiffeners.empty() && other.stiffeners.empty() && wall.clear() == other.clear() &&
         wall.thickness == other.thickness && wall.class_strength == other.class_strength &&
         section.of(a).idle == section.of(b).idle && section.of(a).psi == section.of(b).psi;
}

/// rho of a bare plate, between plate and column where it is short.
Traced reduction_of(Derivation& steps, const BoxWall& wall, std::optional<Length> length,
                    const EffectiveWidth& width, const Traced& lambda, const Traced& psi) {
  const auto column =
      short_plate_of(wall.clear(), wall.thickness, width.k_sigma, wall.class_strength, length);
  const bool slender = internal_reduction(width.lambda_p, psi.value()) < 1.0;
  if (!column && wall.level.share < 1.0) {
    const Traced lambda_red = plate::reduced_slenderness(steps, lambda, wall.level.share);
    return wall.level.annex_E
               ? plate::annex_E_reduction(steps, lambda, lambda_red, plate::internal_loss(psi))
               : plate::internal_reduction(steps, lambda_red, psi);
  }
  if (!column) return plate::internal_reduction(steps, lambda, psi);
  const Traced rho = slender ? plate::internal_reduction(steps, lambda, psi)
                             : steps.given("rho", 1.0, {ValueKind::factor}, "4.4(2)");
  const Traced sigma_cr_c = stiffened::euler_stress(
      steps, "sigma_cr,c", steps.known("E", stiffened::youngs_modulus),
      steps.known("t", wall.thickness), steps.given("a", *length, "between supports across"));
  const Traced lambda_c =
      steps.define("lambda_c", sqrt(steps.known("f_y", wall.class_strength) / sigma_cr_c));
  const Traced chi = stiffened::column_reduction(steps, lambda_c, Traced(0.21));
  const Traced xi = steps.given("xi", column->xi, {ValueKind::number},
                                "k_sigma sigma_E/sigma_cr,c - 1, at least 0");
  return steps.define("rho_c", stiffened::interpolated(rho, chi, xi), "short: 4.4(6), 4.5.4");
}

/// The plates of a section that do not work whole, and what of them does not.
void derive_walls(Derivation& steps, const FourWalls& box, const SectionAlone& section,
                  const char* under) {
  for (std::size_t k = 0; k < box_plates.size(); ++k) {
    const BoxPlate plate = box_plates[k];
    const WallAlone& of = section.of(plate);
    const BoxWall& wall = box.of(plate);
    if (!(of.idle > 1e-9 * wall.clear())) continue;
    const bool first = k % 2 == 0;
    const bool both = alike(box, section, plate, box_plates[first ? k + 1 : k - 1]);
    if (both && !first) continue;
    const Traced c = steps.given("c", wall.clear());
    steps.note([&] { return fmt::format("{} under {}", name_of(plate, both), under); });
    if (of.stiffened) {
      derive_stiffened(steps, stiffened_plate_of(wall, box.length), *of.stiffened);
      steps.note([] {
        return "of what is compressed, stiffeners too, but for the effective parts of the "
               "subpanels "
               "at the edges of the plate, 4.5.1";
      });
      Length left;
      for (const WorkingStrip& strip : of.stiffened->strips)
        left += strip.works * (strip.high - strip.low);
      const double lag = (wall.clear() - of.idle) / left;
      if (lag < 1.0 - 1e-9) {
        steps.given("beta^kappa", lag, {ValueKind::number}, "shear lag (3.3), of all that is left");
      }
      continue;
    }
    const Traced t = steps.given("t", wall.thickness);
    const bool buckles = of.buckles();
    Traced works = 1.0;
    if (buckles) {
      const Traced psi = steps.given("psi", of.psi, {ValueKind::number});
      const Traced epsilon = plate::epsilon(steps, steps.known("f_y", wall.class_strength));
      const Traced k_sigma = steps.given("k_sigma", of.width.k_sigma, {ValueKind::number});
      const Traced lambda = plate::slenderness(steps, c / t, epsilon, k_sigma);
      works = reduction_of(steps, wall, box.length, of.width, lambda, psi);
      if (of.psi < 0.0) {
        steps.define("c_idle", (1.0 - works) * c / (1.0 - psi),
                     "from 0.4 of what works of the compressed width on (table 4.1)");
        continue;
      }
      if (of.psi < 1.0) {
        steps.define("c_idle", (1.0 - works) * c, "from 2/(5 - psi) of what works on (table 4.1)");
        continue;
      }
    }
    const double share = (buckles ? of.width.rho : 1.0) * wall.clear().value();
    const double lag = (wall.clear() - of.idle).value() / share;
    if (lag < 1.0 - 1e-9) {
      const Traced beta = steps.given("beta^kappa", lag, {ValueKind::number}, "shear lag (3.3)");
      works = buckles ? Traced(works * beta) : beta;
    }
    steps.define("c_idle", (1.0 - works) * c,
                 wall.stiffeners.empty() ? "in the middle" : "all over, stiffeners in proportion");
  }
}

}  // namespace

Traced derive_corner_stress(Derivation& steps, const EffectiveBox& box, const CutForces& cut,
                            const CornerUse& corner) {
  const auto of_moment = [&](bool about_y) -> const SectionAlone& {
    return box.alone(moment_alone(about_y, (about_y ? corner.M_y : corner.M_z).value() < 0.0));
  };
  if (cut.N.value() < 0.0)
    derive_walls(steps, box.box(), box.alone(ActingAlone::compression), "N alone");
  if (corner.M_y.value() != 0.0) derive_walls(steps, box.box(), of_moment(true), "M_y alone");
  if (corner.M_z.value() != 0.0) derive_walls(steps, box.box(), of_moment(false), "M_z alone");
  const BoxCorner& place = corner.corner;
  return derive_stress(
      steps, corner, cut,
      [&] {
        return derive_modulus(steps, of_moment(true).sums, true, box.box().of(place.flange).middle,
                              corner.W_y, "mid-line of the flange");
      },
      [&] {
        return derive_modulus(steps, of_moment(false).sums, false, box.box().of(place.web).middle,
                              corner.W_z, "mid-line of the web");
      });
}

}  // namespace boxbeam
