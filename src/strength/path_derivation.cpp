#include <fmt/format.h>

#include <cmath>

#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "plate_formulas.hpp"
#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

/// Whether two plates of a section lose the same.
bool lose_the_same(const PathSection& path, const PathAlone& section, std::size_t a,
                   std::size_t b) {
  const PathPlate &one = path.plates[a], &other = path.plates[b];
  const PlateAlone &of = section.plates[a], &and_of = section.plates[b];
  const auto same = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
  return one.outstand() == other.outstand() && same(one.clear().value(), other.clear().value()) &&
         one.thickness == other.thickness && one.class_strength == other.class_strength &&
         same(of.psi, and_of.psi) && same(of.idle(), and_of.idle()) && of.lag == and_of.lag &&
         same(one.level.share, other.level.share);
}

/// rho of an internal plate, between plate and column where it is short.
Traced internal_rho(Derivation& steps, const PathPlate& plate, std::optional<Length> length,
                    const PlateAlone& of, const Traced& lambda, const Traced& psi) {
  const auto column = short_plate_of(plate.clear(), plate.thickness, of.width.k_sigma,
                                     plate.class_strength, length);
  if (!column && plate.level.share < 1.0) {
    const Traced lambda_red = plate::reduced_slenderness(steps, lambda, plate.level.share);
    return plate.level.annex_E
               ? plate::annex_E_reduction(steps, lambda, lambda_red, plate::internal_loss(psi))
               : plate::internal_reduction(steps, lambda_red, psi);
  }
  if (!column) return plate::internal_reduction(steps, lambda, psi);
  const Traced rho = steps.given("rho", internal_reduction(of.width.lambda_p, of.psi),
                                 {ValueKind::factor}, "4.4(2)");
  const Traced chi = steps.given("chi_c", column->chi_c, {ValueKind::factor},
                                 "as a column between supports across, 4.5.3");
  const Traced xi = steps.given("xi", column->xi, {ValueKind::number},
                                "k_sigma sigma_E/sigma_cr,c - 1, at least 0");
  return steps.define("rho_c", stiffened::interpolated(rho, chi, xi), "short: 4.4(6), 4.5.4");
}

/// rho of an outstand.
Traced outstand_rho(Derivation& steps, const PathPlate& plate, const Traced& lambda) {
  if (!(plate.level.share < 1.0)) return plate::outstand_reduction(steps, lambda);
  const Traced lambda_red = plate::reduced_slenderness(steps, lambda, plate.level.share);
  return plate.level.annex_E
             ? plate::annex_E_reduction(steps, lambda, lambda_red, plate::outstand_loss)
             : plate::outstand_reduction(steps, lambda_red);
}

/// The plates of a section that do not work whole, and what of them does not.
void derive_plates(Derivation& steps, const PathSection& path, const PathAlone& section,
                   const char* under) {
  std::vector<bool> said(path.plates.size(), false);
  for (std::size_t k = 0; k < path.plates.size(); ++k) {
    const PathPlate& plate = path.plates[k];
    const PlateAlone& of = section.plates[k];
    if (said[k] || !(of.idle() > 1e-9 * plate.clear().value())) continue;
    std::string names = plate.name;
    for (std::size_t other = k + 1; other < path.plates.size(); ++other) {
      if (!lose_the_same(path, section, k, other)) continue;
      said[other] = true;
      names += "; " + path.plates[other].name;
    }
    const Traced c = steps.given("c", plate.clear());
    steps.note([&] {
      return fmt::format("{} under {}, {}", names, under,
                         plate.outstand() ? "outstand" : "internal");
    });
    const auto lagging = [&] {
      return steps.given("beta^kappa", of.lag, {ValueKind::number}, "shear lag (3.3)");
    };
    if (!of.pressed || of.width.rho == 1.0) {
      steps.define("c_idle", (1.0 - lagging()) * c);
      continue;
    }
    const Traced t = steps.given("t", plate.thickness);
    const bool tip = plate.outstand() && (of.psi == 1.0 || of.more_at_high != plate.held_at_high());
    const char* const how = of.psi == 1.0       ? "evenly compressed"
                            : !plate.outstand() ? "of what is left, found step by step"
                            : tip ? "of what is left, compressed most at its free edge"
                                  : "of what is left, compressed most where it is held";
    const Traced psi = steps.given("psi", of.psi, {ValueKind::number}, how);
    const Traced epsilon = plate::epsilon(steps, steps.known("f_y", plate.class_strength));
    const Traced k_sigma = steps.given("k_sigma", of.width.k_sigma, {ValueKind::number},
                                       plate.outstand() ? "table 4.2" : "table 4.1");
    const Traced lambda = plate::slenderness(steps, c / t, epsilon, k_sigma);
    const Traced rho = plate.outstand() ? outstand_rho(steps, plate, lambda)
                                        : internal_rho(steps, plate, path.length, of, lambda, psi);
    const char* const where = plate.outstand() ? (tip ? "at its free edge" : "beside what works")
                              : of.psi < 0.0   ? "from 0.4 of what works of the compressed width on"
                                               : "from 2/(5 - psi) of what works on";
    const Traced buckled = of.psi < 0.0 ? (1.0 - rho) * c / (1.0 - psi) : (1.0 - rho) * c;
    if (of.lag < 1.0)
      steps.define("c_idle", c - lagging() * (c - buckled), where);
    else
      steps.define("c_idle", buckled, where);
  }
}

}  // namespace

Traced derive_path_stress(Derivation& steps, const EffectivePath& path, const CutForces& cut,
                          const PathUse& use) {
  const auto of_moment = [&](bool about_y) -> const PathAlone& {
    return path.alone(moment_alone(about_y, (about_y ? use.M_y : use.M_z).value() < 0.0));
  };
  if (cut.N.value() < 0.0)
    derive_plates(steps, path.path(), path.alone(ActingAlone::compression), "N alone");
  if (use.M_y.value() != 0.0) derive_plates(steps, path.path(), of_moment(true), "M_y alone");
  if (use.M_z.value() != 0.0) derive_plates(steps, path.path(), of_moment(false), "M_z alone");
  const PathPlace& place = path.places()[use.place];
  return derive_stress(
      steps, use, cut,
      [&] {
        return derive_modulus(steps, of_moment(true).sums, true, si<Length>(place.z), use.W_y,
                              "of the place");
      },
      [&] {
        return derive_modulus(steps, of_moment(false).sums, false, si<Length>(place.y), use.W_z,
                              "of the place");
      });
}

}  // namespace boxbeam
