// Bending and shear of webs by 7.1(1): a published pair of values, hand values of the reference
// box, plastic moments by fibres, and what must hold for every box.

#include "boxbeam/strength/plastic_box.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/strength/shear_buckling.hpp"
#include "catch.hpp"
#include "support/uniform.hpp"

namespace plastic_box_test {

using namespace boxbeam;
using enum BoxPlate;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

/// A box whose flanges may stand out beyond its webs, mm and MPa.
struct Plates {
  double apart = 600.0, width = 660.0, depth = 1200.0;
  double top = 10.0, bottom = 14.0, web = 8.0;
  double f_flange = 355.0, f_web = 355.0;
};

void add(AreaSums& of, double z, double width, double height) {
  of.area += width * height;
  of.z += width * height * z;
  of.yy += height * std::pow(width, 3) / 12.0;
  of.zz += width * height * (z * z + height * height / 12.0);
}

FourWalls walls_of(const Plates& of) {
  FourWalls box;
  const double half = 0.5 * of.depth;
  add(box.gross, 0.0, 2e-3 * of.web, 1e-3 * of.depth);
  box.gross.yy = box.gross.area * std::pow(0.5e-3 * of.apart, 2);
  add(box.gross, 1e-3 * (half + 0.5 * of.top), 1e-3 * of.width, 1e-3 * of.top);
  add(box.gross, -1e-3 * (half + 0.5 * of.bottom), 1e-3 * of.width, 1e-3 * of.bottom);
  const double clear = 0.5 * (of.apart - of.web);
  const Stress flange = MPa(of.f_flange), web = MPa(of.f_web);
  box.of(top_flange) = {mm(-clear), mm(clear), mm(half + 0.5 * of.top), mm(of.top), flange, flange};
  box.of(bottom_flange) = {mm(-clear),    mm(clear), mm(-half - 0.5 * of.bottom),
                           mm(of.bottom), flange,    flange};
  box.of(left_web) = {mm(-half), mm(half), mm(0.5 * of.apart), mm(of.web), web, flange};
  box.of(right_web) = {mm(-half), mm(half), mm(-0.5 * of.apart), mm(of.web), web, flange};
  return box;
}

CutForces forces(double N, double M_y, double M_z = 0.0) {
  CutForces cut;
  cut.N = si<Force>(N);
  cut.M_y = si<Moment>(M_y);
  cut.M_z = si<Moment>(M_z);
  return cut;
}

/// The factor by 7.1(1), eta_1 chosen between what 7.1(5) and what clause 4 allow at factor one.
double factor_by_plastic(const FourWalls& walls, double N, double M, double eta_3) {
  const EffectiveBox box(walls);
  CornerUse corner = box.worst_corner(forces(N, M));
  corner.M_y = si<Moment>(M - N * walls.gross.z / walls.gross.area);
  const double eta_1 = 0.5 * (1.0 + 4.0 * eta_3 * (1.0 - eta_3));
  return PlasticBox(box).web_under(forces(N, M), corner, 1.0, eta_1, eta_3).factor;
}

/// The moment about the gross centroid at which 7.1(1) ends.
double moment_at_limit(double M_f, double M_N, double eta_3) {
  return M_N - (M_N - M_f) * std::pow(2.0 * eta_3 - 1.0, 2);
}

Plates random_plates(test::Uniform& in) {
  Plates of;
  of.apart = of.width = in(300.0, 900.0);
  of.width += of.web;
  of.depth = in(500.0, 1500.0);
  of.top = in(6.0, 20.0);
  of.bottom = in(6.0, 20.0);
  of.web = in(5.0, 12.0);
  of.f_web = in(235.0, 355.0);
  return of;
}

/// Largest moment about the gross centroid with N there, by fibres that yield: of the compressed
/// flange what `EffectiveBox` leaves, all of the rest.
double moment_by_fibres(const Plates& of, const FourWalls& walls, double N, bool positive) {
  const EffectiveBox box(walls);
  const SectionAlone& section =
      box.alone(positive ? ActingAlone::M_y_positive : ActingAlone::M_y_negative);
  struct Fibre {
    double z, force;
  };
  std::vector<Fibre> fibres;
  const double sign = positive ? 1.0 : -1.0;
  const double centroid = walls.gross.z / walls.gross.area;
  for (const BoxPlate flange : {top_flange, bottom_flange}) {
    const double idle = 1e3 * section.of(flange).idle.value();
    const double t = flange == top_flange ? of.top : of.bottom;
    fibres.push_back(
        {sign * (walls.of(flange).middle.value() - centroid), (of.width - idle) * t * of.f_flange});
  }
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    fibres.push_back({sign * (1e-3 * of.depth * ((i + 0.5) / count - 0.5) - centroid),
                      2.0 * of.web * of.depth / count * of.f_web});
  }
  std::sort(fibres.begin(), fibres.end(), [](auto& a, auto& b) { return a.z < b.z; });
  // All stretched; from the lowest on they are compressed until N is reached.
  double sum = 0.0, moment = 0.0;
  for (const Fibre& fibre : fibres) {
    sum += fibre.force;
    moment += fibre.force * fibre.z;
  }
  for (const Fibre& fibre : fibres) {
    if (sum <= N) break;
    const double turned = std::min(1.0, (sum - N) / (2.0 * fibre.force));
    sum -= 2.0 * turned * fibre.force;
    moment -= 2.0 * turned * fibre.force * fibre.z;
  }
  return moment;
}

}  // namespace

TEST_CASE("7.1(1): M_f and M_pl of the reference box by hand", "[plastic_box]") {
  // eps = 0.8136; top flange 59.2/(28.4 eps 2) = 1.281, rho = 0.6466: (592 0.6466 + 68) 10 355 =
  // 1600 kN, the bottom one 660 14 355 = 3280 kN: M_f = 1600 1.212.
  const double lambda = 59.2 / (28.4 * std::sqrt(235.0 / 355.0) * 2.0);
  const double rho = (lambda - 0.22) / (lambda * lambda);
  CHECK(rho == Approx(0.6466).margin(1e-4));
  const double top = (592.0 * rho + 68.0) * 10.0 * 355.0, bottom = 660.0 * 14.0 * 355.0;
  const double webs = 2.0 * 1200.0 * 8.0 * 355.0, w = top - bottom;
  const double M_f = top * 1.212;
  // About the middle of the webs, without N: 4880 kN m.
  const double M_pl = top * 0.605 + bottom * 0.607 + webs * 1.2 / 4.0 * (1.0 - w * w / webs / webs);
  CHECK(M_f == Approx(1939e3).epsilon(1e-3));
  CHECK(M_pl == Approx(4880e3).epsilon(1e-3));
  const FourWalls box = walls_of({});
  // Sagging compresses the top: M_y < 0.
  for (const double eta_3 : {0.55, 0.7, 0.9, 0.99}) {
    CAPTURE(eta_3);
    CHECK(factor_by_plastic(box, 0.0, -moment_at_limit(M_f, M_pl, eta_3), eta_3) ==
          Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("plastic moments with N are those of fibres that yield", "[plastic_box]") {
  test::Uniform in(17);
  for (int i = 0; i < 60; ++i) {
    const Plates of = random_plates(in);
    const FourWalls walls = walls_of(of);
    const bool positive = i % 2 == 0;
    const SectionAlone& section =
        EffectiveBox(walls).alone(positive ? ActingAlone::M_y_positive : ActingAlone::M_y_negative);
    const auto flange = [&](BoxPlate plate, double t) {
      return (of.width - 1e3 * section.of(plate).idle.value()) * t * of.f_flange;
    };
    const double top = flange(top_flange, of.top), bottom = flange(bottom_flange, of.bottom);
    const double webs = 2.0 * of.depth * of.web * of.f_web;
    // The neutral axis in the webs: their force N + F_c - F_t.
    const double N = in(-0.9, 0.9) * webs - (positive ? bottom - top : top - bottom);
    if (std::abs(N) > 0.8 * (top + bottom)) continue;
    const double lever = (walls.of(top_flange).middle - walls.of(bottom_flange).middle).value();
    const double M_f = std::min(top, bottom) * lever * (1.0 - std::abs(N) / (top + bottom));
    const double M_N = moment_by_fibres(of, walls, N, positive);
    const double eta_3 = in(0.6, 0.95);
    CAPTURE(i, N, M_N, M_f, eta_3);
    REQUIRE(M_f < M_N);
    const double about_axis = (positive ? 1.0 : -1.0) * moment_at_limit(M_f, M_N, eta_3) +
                              N * walls.gross.z / walls.gross.area;
    CHECK(factor_by_plastic(walls, N, about_axis, eta_3) == Approx(1.0).epsilon(5e-4));
  }
}

TEST_CASE("bending and shear of webs: what holds for every box", "[plastic_box]") {
  test::Uniform in(23);
  int milder = 0;
  for (int i = 0; i < 500; ++i) {
    const FourWalls walls = walls_of(random_plates(in));
    const EffectiveBox box(walls);
    const PlasticBox plastic(box);
    const CutForces cut = forces(in(-2e6, 2e6), in(-2e6, 2e6));
    const CornerUse corner = box.worst_corner(cut);
    const double gamma = in(1.0, 1.1), eta_1 = gamma * corner.use, eta_3 = in(0.0, 2.0) * eta_1;
    CAPTURE(i, cut.N.value(), cut.M_y.value(), eta_1, eta_3);
    const double use = plastic.web_under(cut, corner, gamma, eta_1, eta_3).use;
    const double safe = 1.0 / interaction_factor(eta_1, eta_3);
    CHECK(use <= safe * (1.0 + 1e-9));
    CHECK(use >= std::max(eta_1, std::min(eta_3, safe)) * (1.0 - 1e-9));
    if (use < 0.98 * safe) ++milder;
    // As many times the loads, as many times the use.
    const double times = in(0.2, 5.0);
    const CutForces more = forces(times * cut.N.value(), times * cut.M_y.value());
    CHECK(
        plastic.web_under(more, box.worst_corner(more), gamma, times * eta_1, times * eta_3).use ==
        Approx(times * use).epsilon(1e-8));
    // Half of the resistance to shear at the limit of clause 4 is where shear begins to count.
    CHECK(plastic.web_under(cut, corner, gamma, eta_1, 0.5001 * eta_1).use ==
          Approx(eta_1).epsilon(1e-4));
    // Bending across: 7.1(5).
    CutForces across = cut;
    across.M_z = si<Moment>(1e3);
    const CornerUse of_both = box.worst_corner(across);
    CHECK(plastic.web_under(across, of_both, gamma, eta_1, eta_3).use ==
          Approx(safe).epsilon(1e-12));
  }
  CHECK(milder > 50);
}

TEST_CASE("a web that is compressed all over is judged by 7.1(5), and nothing jumps on the way",
          "[plastic_box]") {
  const FourWalls walls = walls_of({});
  const EffectiveBox box(walls);
  const PlasticBox plastic(box);
  double before = 0.0;
  bool all_over = false;
  for (int i = 0; i <= 4000; ++i) {
    const CutForces cut = forces(-1e3 * i, 8e5);
    const CornerUse corner = box.worst_corner(cut);
    const double eta_3 = 0.9;
    const WebInteraction of = plastic.web_under(cut, corner, 1.0, corner.use, eta_3);
    if (i > 0) CHECK(std::abs(of.use - before) < 2e-3);
    before = of.use;
    const double lowest = -0.6 - walls.gross.z / walls.gross.area;
    const double inertia = walls.gross.zz - walls.gross.z * walls.gross.z / walls.gross.area;
    // The upper end of the web, which M alone stretches.
    const double pulled = cut.N.value() / walls.gross.area + 8e5 / inertia * (lowest + 1.2);
    if (pulled >= 0.0) continue;
    all_over = true;
    CHECK(of.share == 0.0);
    CHECK(of.use == Approx(1.0 / interaction_factor(corner.use, eta_3)).epsilon(1e-12));
  }
  CHECK(all_over);
}

}  // namespace plastic_box_test
