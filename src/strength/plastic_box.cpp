#include "boxbeam/strength/plastic_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "plate_formulas.hpp"

namespace boxbeam {
namespace {

/// Of a force that yields what works of a flange between the outer faces of the webs.
Force yield_force(const FourWalls& box, const SectionAlone& section, BoxPlate flange) {
  const BoxWall& wall = box.of(flange);
  // What is in no clear width, by the thickness of the flanges.
  Area corners = si<Area>(box.gross.area);
  for (const BoxPlate plate : box_plates) {
    const BoxWall& of = box.of(plate);
    corners -= of.clear() * of.thickness;
    for (const FlatStiffener& bar : of.stiffeners) corners -= bar.depth * bar.thickness;
  }
  const Length both =
      box.of(BoxPlate::top_flange).thickness + box.of(BoxPlate::bottom_flange).thickness;
  const Area works = (wall.clear() - section.of(flange).idle) * wall.thickness +
                     corners * (wall.thickness / both).value();
  return works * wall.yield_strength;
}

/// What the webs bear, tension positive.
template <class Number>
auto force_of_webs(const Number& N, const Number& compressed, const Number& stretched) {
  return N + compressed - stretched;
}

template <class F, class L>
auto plastic_moment(const F& compressed, const L& a_c, const F& stretched, const L& a_t, const F& w,
                    const L& a_w, const F& webs, const L& depth) {
  return compressed * a_c + stretched * a_t + w * a_w +
         webs * depth / 4.0 * (1.0 - w / webs * (w / webs));
}

template <class F, class L>
auto flange_moment(const F& weaker, const F& stronger, const F& abs_N, const L& a_c, const L& a_t) {
  return weaker * (a_c + a_t) * (1.0 - abs_N / (weaker + stronger));
}

/// What of the stress or the web pulls yet where 7.1(1) holds all of it.
constexpr double fully = 0.2;

}  // namespace

PlasticBox::PlasticBox(const EffectiveBox& box) {
  const FourWalls& walls = box.box();
  using enum BoxPlate;
  using enum ActingAlone;
  centroid_ = si<Length>(walls.gross.z / walls.gross.area);
  area_ = si<Area>(walls.gross.area);
  inertia_ = si<SecondMoment>(walls.gross.zz - walls.gross.area * std::pow(centroid_.value(), 2));
  const BoxWall& web = walls.of(left_web);
  depth_ = web.clear();
  web_low_ = web.low - centroid_;
  web_high_ = web.high - centroid_;
  for (const BoxPlate of : {left_web, right_web})
    webs_ += walls.of(of).clear() * walls.of(of).thickness * walls.of(of).yield_strength;
  const Length top = walls.of(top_flange).middle - centroid_;
  const Length bottom = centroid_ - walls.of(bottom_flange).middle;
  const Length middle = 0.5 * (web_low_ + web_high_);
  // M_y > 0 stretches the top.
  const SectionAlone &up = box.alone(M_y_positive), &down = box.alone(M_y_negative);
  senses_ = {Sense{yield_force(walls, up, bottom_flange), yield_force(walls, up, top_flange),
                   bottom, top, middle},
             Sense{yield_force(walls, down, top_flange), yield_force(walls, down, bottom_flange),
                   top, bottom, -middle}};
}

std::optional<PlasticBox> PlasticBox::of_path(const EffectivePath& path) {
  using enum ActingAlone;
  const PathSection& section = path.path();
  const AreaSums& gross = section.gross;
  const double centroid = gross.z / gross.area, length = std::sqrt(gross.area);
  const auto same = [&](double a, double b) { return std::abs(a - b) < 1e-9 * length; };
  PlasticBox of;
  of.centroid_ = si<Length>(centroid);
  of.area_ = si<Area>(gross.area);
  of.inertia_ = si<SecondMoment>(gross.zz - gross.area * centroid * centroid);
  for (const PathPlate& plate : section.plates) {
    if (plate.outstand() || std::abs(plate.direction.x()) > 1e-9) continue;
    const double one = plate.at(plate.low).y(), other = plate.at(plate.high).y();
    const double low = std::min(one, other), high = std::max(one, other);
    const Length from = si<Length>(low - centroid), to = si<Length>(high - centroid);
    const bool first = of.webs_ == Force{};
    if (!first &&
        !(same(from.value(), of.web_low_.value()) && same(to.value(), of.web_high_.value())))
      return std::nullopt;
    of.web_low_ = from;
    of.web_high_ = to;
    of.depth_ = plate.clear();
    of.webs_ += plate.clear() * plate.thickness * plate.yield_strength;
  }
  if (of.webs_ == Force{}) return std::nullopt;
  // M_y > 0 stretches the top.
  for (const bool up : {true, false}) {
    Sense& sense = of.senses_[up ? 0 : 1];
    const PathAlone& alone = path.alone(up ? M_y_positive : M_y_negative);
    for (std::size_t k = 0; k < section.plates.size(); ++k) {
      const PathPlate& plate = section.plates[k];
      if (!plate.outstand() && std::abs(plate.direction.x()) <= 1e-9) continue;
      const Length z = si<Length>(plate.at(plate.low).y() - centroid);
      const bool top = z >= of.web_high_;
      if (std::abs(plate.direction.y()) > 1e-9 || (!top && z > of.web_low_)) return std::nullopt;
      const bool stretched = top == up;
      Length& arm = stretched ? sense.arm_stretched : sense.arm_compressed;
      if (arm != Length{} && !same(arm.value(), abs(z).value())) return std::nullopt;
      arm = abs(z);
      (stretched ? sense.stretched : sense.compressed) +=
          (plate.clear() - si<Length>(alone.plates[k].idle())) * plate.thickness *
          plate.yield_strength;
    }
    if (sense.stretched == Force{} || sense.compressed == Force{}) return std::nullopt;
    sense.arm_webs = (up ? 0.5 : -0.5) * (of.web_low_ + of.web_high_);
  }
  return of;
}

double PlasticBox::pulled_share(Force N, Moment M, double factor) const {
  const auto elastic = [&](Length z) { return N / area_ + M * z / inertia_; };
  const Stress most = std::max(elastic(web_low_), elastic(web_high_));
  const Stress least = std::min(elastic(web_low_), elastic(web_high_));
  const Sense& of = sense_of(M);
  const double w = force_of_webs(Force(factor * N), of.compressed, of.stretched) / webs_;
  const double by_elastic = least < Stress{} ? (most / -least).value() : fully;
  return std::clamp(std::min(by_elastic, 1.0 - std::abs(w)) / fully, 0.0, 1.0);
}

double PlasticBox::factor_of(Force N, Moment M, double eta_1, double eta_3) const {
  const Sense& of = sense_of(M);
  const auto holds = [&](double factor) {
    const Force w = force_of_webs(Force(factor * N), of.compressed, of.stretched);
    if (!(abs(w) < webs_)) return false;
    const Moment whole = plastic_moment(of.compressed, of.arm_compressed, of.stretched,
                                        of.arm_stretched, w, of.arm_webs, webs_, depth_);
    const Moment flanges =
        flange_moment(std::min(of.compressed, of.stretched), std::max(of.compressed, of.stretched),
                      Force(abs(factor * N)), of.arm_compressed, of.arm_stretched);
    const double m = abs(M) / whole;
    return factor <= interaction_factor(m, eta_3, 1.0 - flanges / whole);
  };
  double stands = interaction_factor(eta_1, eta_3), ends = 1.0 / std::max(eta_1, eta_3);
  if (holds(ends)) return ends;
  constexpr double close = 1e-12;
  while (ends - stands > close * ends) {
    const double middle = 0.5 * (stands + ends);
    (holds(middle) ? stands : ends) = middle;
  }
  return stands;
}

WebInteraction PlasticBox::web_under(const CutForces& cut, const SectionUse& corner,
                                     double gamma_M0, double eta_1, double eta_3) const {
  const double safe = interaction_factor(eta_1, eta_3);
  WebInteraction of{1.0 / safe, 0.0, safe, corner.M_y};
  // So little beside M_y is round-off.
  constexpr double none = 1e-6;
  if (std::abs(corner.M_z.value()) > none * std::abs(corner.M_y.value()) || eta_1 >= 2.0 * eta_3)
    return of;
  const Force N = gamma_M0 * cut.N;
  double share = 1.0;
  of.factor = std::numeric_limits<double>::infinity();
  const Moment about_gross = plate::shifted_moment(cut.M_y, cut.N, centroid_);
  for (const Moment& M : {about_gross, corner.M_y}) {
    share = std::min(share, pulled_share(N, Moment(gamma_M0 * M), safe));
    const double factor = factor_of(N, Moment(gamma_M0 * M), eta_1, eta_3);
    if (!(factor < of.factor)) continue;
    of.factor = factor;
    of.moment = M;
  }
  of.share = share;
  of.use = std::lerp(1.0 / safe, 1.0 / of.factor, share);
  return of;
}

Traced derive_web_interaction(Derivation& steps, const PlasticBox& box, const WebInteraction& of,
                              const CutForces& cut, double acting, const Traced& eta_1,
                              const Traced& eta_3) {
  if (!(of.share > 0.0)) {
    Traced factor = derive_interaction_factor(steps, eta_1, eta_3);
    steps.note([] { return "f eta_1 + (2 f eta_3 - 1)^2 = 1, 7.1(5)"; });
    return factor;
  }
  const PlasticBox::Sense& sense = box.sense_of(of.moment);
  const Traced F_c =
      steps.given("F_c", sense.compressed, "the compressed flange as far as it works");
  const Traced F_t = steps.given("F_t", sense.stretched, "the stretched one");
  const Traced a_c = steps.given("a_c", sense.arm_compressed, "arms from the gross centroid");
  const Traced a_t = steps.given("a_t", sense.arm_stretched);
  const Traced W = steps.given("W", box.webs_, "the webs, whole");
  const Traced h_w = steps.given("h_w", box.depth_);
  const Traced N = steps.given("N_f", Force(of.factor * acting * cut.N),
                               "N at the factor found, partial factors counted");
  const Traced w = steps.define("w", force_of_webs(N, F_c, F_t));
  const Traced a_w = steps.given("a_w", sense.arm_webs);
  const Traced M_N = steps.define("M_N", plastic_moment(F_c, a_c, F_t, a_t, w, a_w, W, h_w));
  const bool weaker = sense.compressed < sense.stretched;
  const Traced M_f =
      steps.define("M_f", flange_moment(weaker ? F_c : F_t, weaker ? F_t : F_c, abs(N), a_c, a_t));
  const Traced M = steps.given("M_E", Moment(acting * abs(of.moment)), "partial factors counted");
  const Traced m = steps.define("m", M / M_N);
  const Traced part = steps.define("p", 1.0 - M_f / M_N);
  const bool bends = m >= 2.0 * eta_3;
  const Traced both = bends ? Traced(1.0 / m) : plate::interaction_factor(m, eta_3, part);
  const Traced factor =
      steps.define("f", least_of({both, Traced(1.0 / eta_1), Traced(1.0 / eta_3)}));
  steps.note([] { return "f m + p (2 f eta_3 - 1)^2 = 1, 7.1(1); clause 4; clause 5"; });
  if (of.share >= 1.0) return steps.define("factor", factor);
  const Traced safe = steps.define("f_5", plate::interaction_factor(eta_1, eta_3));
  steps.note([] { return "7.1(5), to which it leads over where hardly any of the web pulls"; });
  const Traced share = steps.given("r", of.share, {ValueKind::share});
  return steps.define("factor", 1.0 / (share / factor + (1.0 - share) / safe));
}

}  // namespace boxbeam
