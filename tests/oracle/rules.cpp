#include "rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace oracle {

using namespace boxbeam;

Rules::Rules(const Project& project) : project_(&project) {
  const BeamDetail& beam = project.fatigue.beam;
  along_flat_.detail.curve = en_1993_1_9_direct(100.0);
  thin_diaphragm_.detail.curve = en_1993_1_9_direct(80.0);
  thick_diaphragm_.detail.curve = en_1993_1_9_direct(71.0);
  const bool nominal =
      beam.detail.where == StressPlace::gross || beam.detail.where == StressPlace::net;
  for (BeamDetail* const of : {&along_flat_, &thin_diaphragm_, &thick_diaphragm_})
    if (nominal) of->stress_factor = std::max(1.0, beam.stress_factor);
}

Resisting Rules::detail_at(const Station& station, PlaceKind kind, double plate, bool at_flat) {
  const FatigueInput& fatigue = project_->fatigue;
  const double s = station.s.value();
  Resisting weakest;
  double least = 0.0, largest = 0.0;
  bool reduced = true;
  bool beside = true;  // no stretch goes on from here to the side looked at
  const auto look_at = [&](const BeamDetail& stretch) {
    reduced = reduced && stretch.detail.compression_reduced;
    largest = std::max(largest, stretch.stress_factor);
    const double strength = strength_at(stretch.detail, plate, 2e6) / stretch.stress_factor;
    if (weakest.detail != nullptr && strength >= least) return;
    weakest.detail = &stretch;
    least = strength;
  };
  for (const BeamDetail& stretch : fatigue.details) {
    const double from = stretch.from.value(), to = stretch.to.value();
    const bool meant = stretch.on == DetailPlace::section ||
                       (stretch.on == DetailPlace::fibres && kind == PlaceKind::fibre) ||
                       (stretch.on == DetailPlace::webs && kind == PlaceKind::web) ||
                       (stretch.on == DetailPlace::seams && kind == PlaceKind::seam);
    // A toe at the very end of a stretch sees the stress of either side.
    if (!meant || s < from || s > to) continue;
    look_at(stretch);
    const bool before = s > from || s == 0.0, behind = s < to;
    if (station.side == Side::before ? before : behind) beside = false;
  }
  if (beside) look_at(fatigue.beam);
  if (at_flat) look_at(along_flat_);
  for (const Diaphragm& of : project_->beam.diaphragms) {
    if (of.s != station.s) continue;
    const double t = of.thickness.value(), a = of.throat.value();
    const double between_toes = t + 2.0 * (a > 0.0 ? std::numbers::sqrt2 * a : t);
    look_at(between_toes > 50e-3 ? thick_diaphragm_ : thin_diaphragm_);
  }
  weakest.compression_reduced = reduced;
  weakest.range_factor = largest;
  return weakest;
}

const SnCurve& Rules::curve_of(const Detail& detail, double plate) {
  const bool butt = detail.size_effect == SizeEffect::butt;
  const std::pair key{&detail, butt ? plate : 0.0};
  const auto found = curves_.find(key);
  if (found != curves_.end()) return found->second;
  const double factor = butt ? std::pow(std::min(1.0, 0.025 / plate), 0.2) : detail.size_factor;
  return curves_.emplace(key, scaled(detail.curve, factor)).first->second;
}

double Rules::strength_at(const Detail& detail, double plate, double cycles) {
  const std::tuple key{&detail, plate, cycles};
  const auto found = strengths_.find(key);
  if (found != strengths_.end()) return found->second;
  const Loading loading = project_->fatigue.demand.loading;
  const double strength = boxbeam::strength_at(curve_of(detail, plate), cycles, loading).value();
  return strengths_.emplace(key, strength).first->second;
}

const Material& Rules::material_of(std::size_t segment, PlateKind wall) const {
  for (auto part = project_->part_materials.rbegin(); part != project_->part_materials.rend();
       ++part)
    if (part->segments[segment] && part->plates[static_cast<std::size_t>(wall)])
      return part->material;
  return project_->material;
}

double Rules::yield_strength(std::size_t segment, PlateKind wall, double plate) const {
  return yield_strength_of(material_of(segment, wall), si<Length>(plate))->value();
}

double Rules::yield_strength(std::size_t segment, const Place& place) const {
  const double own = yield_strength(segment, place.wall, place.plate);
  if (!place.beside || &material_of(segment, *place.beside) == &material_of(segment, place.wall))
    return own;
  return std::min(own, yield_strength(segment, *place.beside, place.beside_plate));
}

double Rules::weld_strength(std::size_t segment, const Place& throat) const {
  double least = std::numeric_limits<double>::infinity();
  for (const PlateKind wall : {throat.wall, throat.beside.value_or(throat.wall)}) {
    const Material& of = material_of(segment, wall);
    least =
        std::min(least, tensile_strength_of(of, si<Length>(throat.joined))->value() / of.beta_w);
  }
  return least;
}

double pin_utilisation(double force, const PinInput& pin, const StrengthDemand& factors) {
  const PinJoint& of = pin.geometry;
  const PinStrength& strength = pin.strength;
  const double d = of.diameter.value(), a = of.outer_plate.value(), b = of.inner_plate.value();
  const double f_yp = strength.pin_yield.value();
  const double shear =
      0.5 * force /
      (0.6 * std::numbers::pi / 4.0 * d * d * strength.pin_tensile.value() / factors.gamma_M2);
  const double moment = force / 8.0 * (b + 4.0 * of.gap.value() + 2.0 * a);
  const double bending =
      moment / (1.5 * std::numbers::pi / 32.0 * d * d * d * f_yp / factors.gamma_M0);
  const auto bearing = [&](double on, double t, Stress yield) {
    return on / (1.5 * t * d * std::min(f_yp, yield.value()) / factors.gamma_M0);
  };
  const double inner = bearing(force, b, strength.inner_yield);
  const double outer = bearing(0.5 * force, a, strength.outer_yield);
  return pin.required * std::max({shear, bending, inner, outer, std::hypot(shear, bending)});
}

double lug_utilisation(double force, const PinInput& pin, const LugInput& lug,
                       const StrengthDemand& factors) {
  const double t = lug.plate.thickness.value(), d_0 = lug.plate.hole.value();
  // Beside the hole c >= F gamma_M0/(2 t f_y) + d_0/3, before it a >= .. + 2 d_0/3.
  double left = 0.5 * (lug.plate.width.value() - d_0) - d_0 / 3.0;
  if (lug.plate.end) left = std::min(left, lug.plate.end->value() - 2.0 * d_0 / 3.0);
  const double on = lug.inner ? force : 0.5 * force;
  return pin.required * on * factors.gamma_M0 / (2.0 * t * lug.yield_strength.value() * left);
}

double lug_stress(double force, const LugInput& lug) {
  // No more of the width counts than K_t is known of.
  const double d_0 = lug.plate.hole.value(), w = std::min(lug.plate.width.value(), d_0 / 0.15);
  const double x = d_0 / w;
  const double K_t = lug.own_factor ? lug.detail.stress_factor
                                    : 12.882 - 52.714 * x + 89.762 * x * x - 51.667 * x * x * x;
  return K_t * (lug.inner ? force : 0.5 * force) / ((w - d_0) * lug.plate.thickness.value());
}

double rod_utilisation(double compression, const RodInput& rod, const StrengthDemand& factors) {
  const LocalSection section{rod.section, {}, {}, false, 1.0, 1.0};
  const Plane plane = plane_of(section, false, false);
  // Of a symmetric section sigma_N = 1/A, dsigma/dz of M_y = 1/I_y, dsigma/dy of M_z = -1/I_z.
  const double A = 1.0 / plane.of[0][0];
  const double I = std::min(1.0 / plane.of[1][2], -1.0 / plane.of[2][1]);
  const double f_y = rod.yield_strength.value(), L = rod.buckling_length.value();
  if (compression <= 0.0) {
    // 6.2.3: the gross section yields, or the net one breaks.
    const double net = rod.net_area ? rod.net_area->value() : A;
    const double resistance = std::min(A * f_y / factors.gamma_M0,
                                       0.9 * net * rod.tensile_strength.value() / factors.gamma_M2);
    return rod.required * -compression / resistance;
  }
  const double critical = std::numbers::pi * std::numbers::pi * 210e9 * I / (L * L);
  const double slenderness = std::sqrt(A * f_y / critical);
  constexpr double imperfection[] = {0.13, 0.21, 0.34, 0.49, 0.76};
  const double alpha = imperfection[static_cast<std::size_t>(rod.curve)];
  const double phi = 0.5 * (1.0 + alpha * (slenderness - 0.2) + slenderness * slenderness);
  const double chi = std::min(1.0, 1.0 / (phi + std::sqrt(phi * phi - slenderness * slenderness)));
  return rod.required * compression / (chi * A * f_y / factors.gamma_M1);
}

}  // namespace oracle
