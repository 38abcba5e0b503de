// Boxes of slender plates. Reference: a box of 660 x 1224 mm whose figures were computed by hand
// formulas and, independently, by sums over 2000 fibres; fibres of its own for random boxes here;
// and what must hold for every box.

#include "boxbeam/strength/effective_box.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"
#include "support/uniform.hpp"

namespace effective_box_test {

using namespace boxbeam;
using enum BoxPlate;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

AreaSums sums_of_rectangle(double y, double z, double width, double height) {
  AreaSums of;
  of.area = width * height;
  of.y = of.area * y;
  of.z = of.area * z;
  of.yy = of.area * (y * y + width * width / 12.0);
  of.zz = of.area * (z * z + height * height / 12.0);
  of.yz = of.area * y * z;
  return of;
}

AreaSums operator+(const AreaSums& a, const AreaSums& b) {
  return {a.area + b.area, a.y + b.y, a.z + b.z, a.yy + b.yy, a.zz + b.zz, a.yz + b.yz};
}

/// S355; webs 1200 x 8 mm at 600 mm, flanges 660 mm wide, the top one 10, the bottom one 14 mm.
FourWalls reference_box() {
  FourWalls box;
  box.gross =
      sums_of_rectangle(0.296 + 0.004, 0.0, 0.008, 1.2) + sums_of_rectangle(-0.3, 0.0, 0.008, 1.2) +
      sums_of_rectangle(0.0, 0.605, 0.660, 0.010) + sums_of_rectangle(0.0, -0.607, 0.660, 0.014);
  const Stress f_y = MPa(355.0);
  box.of(top_flange) = {mm(-296.0), mm(296.0), mm(605.0), mm(10.0), f_y, f_y};
  box.of(bottom_flange) = {mm(-296.0), mm(296.0), mm(-607.0), mm(14.0), f_y, f_y};
  box.of(left_web) = {mm(-600.0), mm(600.0), mm(300.0), mm(8.0), f_y, f_y};
  box.of(right_web) = {mm(-600.0), mm(600.0), mm(-300.0), mm(8.0), f_y, f_y};
  return box;
}

/// mm below the top of the reference box.
double below_top(const AreaSums& of) { return 1e3 * (0.610 - of.z / of.area); }

double inertia_y(const AreaSums& of) { return of.zz - of.z * of.z / of.area; }
double inertia_z(const AreaSums& of) { return of.yy - of.y * of.y / of.area; }

Box random_box(test::Uniform& in) {
  return {mm(in(200.0, 900.0)), mm(in(200.0, 1500.0)), mm(in(5.0, 30.0)),
          mm(in(5.0, 30.0)),    mm(in(4.0, 20.0)),     mm(in(4.0, 20.0))};
}

Material steel() {
  Material material;
  material.name = "S355";
  material.steps = {{mm(40.0), MPa(355.0), MPa(470.0)}};
  return material;
}

CutForces random_forces(test::Uniform& between) {
  const auto in = [&](double most) { return between(-most, most); };
  return {si<Force>(in(2e6)), si<Force>(0.0),      si<Force>(0.0),
          si<Moment>(0.0),    si<Moment>(in(1e6)), si<Moment>(in(5e5))};
}

/// rho by the formulas of EN 1993-1-5, 4.4, written once more.
double rho_of(double c_over_t, double psi) {
  const double k = psi > 0.0    ? 8.2 / (1.05 + psi)
                   : psi > -1.0 ? 7.81 - 6.29 * psi + 9.78 * psi * psi
                                : 5.98 * std::pow(1.0 - psi, 2);
  const double lambda = c_over_t / (28.4 * std::sqrt(235.0 / 355.0) * std::sqrt(k));
  if (lambda <= 0.5 + std::sqrt(0.085 - 0.055 * psi)) return 1.0;
  return (lambda - 0.055 * (3.0 + psi)) / (lambda * lambda);
}

/// Stress at the corners of a box under -M_y (top compressed), by fibres along the height: those
/// that work, twice, for flanges and then webs.
struct FibreBox {
  explicit FibreBox(const Box& box) : box_(box) {}

  /// Distance of the neutral axis and stress per moment at the mid-lines of the flanges.
  struct Found {
    double top = 0.0, bottom = 0.0;
  };
  Found found() const {
    const double h = box_.height.value(), b = box_.width.value();
    const double t_top = box_.top_flange.value(), t_bottom = box_.bottom_flange.value();
    const double left = box_.left_web.value(), right = box_.right_web.value();
    const double clear = b - left - right;
    const double works = rho_of(clear / t_top, 1.0);
    const double top_width = b - (1.0 - works) * clear;
    const double low = t_bottom - h / 2.0, high = h / 2.0 - t_top;
    const auto centroid_and_inertia = [&](double from_left, double to_left, double from_right,
                                          double to_right) {
      constexpr int fibres = 40'000;
      double area = 0.0, first = 0.0, second = 0.0;
      const double d = h / fibres;
      for (int i = 0; i < fibres; ++i) {
        const double z = -h / 2.0 + (i + 0.5) * d;
        double width = 0.0;
        if (z < low)
          width = b;
        else if (z > high)
          width = top_width;
        else
          width = (z > from_left && z < to_left ? 0.0 : left) +
                  (z > from_right && z < to_right ? 0.0 : right);
        area += width * d;
        first += width * d * z;
        second += width * d * z * z;
      }
      return std::pair{first / area, second - first * first / area};
    };
    const double axis = centroid_and_inertia(1.0, 1.0, 1.0, 1.0).first;
    const auto idle_of = [&](double t) -> std::pair<double, double> {
      const double at_high = high - axis, at_low = low - axis;
      if (at_high <= 0.0) return {1.0, 1.0};
      const double psi = std::max(-3.0, at_low / at_high);
      const double rho = rho_of((high - low) / t, psi);
      const double pressed = psi < 0.0 ? (high - low) / (1.0 - psi) : high - low;
      const double b_eff = rho * pressed;
      const double b_e1 = psi < 0.0 ? 0.4 * b_eff : 2.0 * b_eff / (5.0 - psi);
      return {high - b_e1 - (pressed - b_eff), high - b_e1};
    };
    const auto [from_left, to_left] = idle_of(left);
    const auto [from_right, to_right] = idle_of(right);
    const auto [centroid, inertia] = centroid_and_inertia(from_left, to_left, from_right, to_right);
    return {(h / 2.0 - t_top / 2.0 - centroid) / inertia,
            (centroid + h / 2.0 - t_bottom / 2.0) / inertia};
  }

 private:
  Box box_;
};

}  // namespace

TEST_CASE("reference box: the gross section, and what is left under N alone") {
  const FourWalls box = reference_box();
  CHECK(1e6 * box.gross.area == Approx(35040.0));
  CHECK(1e12 * inertia_y(box.gross) == Approx(8049.94e6).epsilon(1e-6));
  CHECK(below_top(box.gross) == Approx(656.11).epsilon(1e-5));
  const SectionAlone under_N = section_alone(box, ActingAlone::compression);
  CHECK(under_N.of(top_flange).width.rho == Approx(0.6466).margin(5e-5));
  CHECK(under_N.of(bottom_flange).width.rho == Approx(0.8301).margin(5e-5));
  CHECK(under_N.of(left_web).width.rho == Approx(0.2872).margin(5e-5));
  CHECK(1e6 * under_N.sums.area == Approx(17854.0).epsilon(5e-5));
  CHECK(below_top(under_N.sums) - below_top(box.gross) == Approx(67.42).epsilon(2e-4));
}

TEST_CASE("reference box under M_y: one pass by the standard, and converged") {
  const FourWalls box = reference_box();
  // The top compressed: M_y < 0.
  const SectionAlone once = section_alone(box, ActingAlone::M_y_negative);
  CHECK(once.passes == 1);
  const WallAlone& web = once.of(left_web);
  CHECK(web.psi == Approx(-0.7456).margin(5e-5));
  CHECK(web.width.k_sigma == Approx(17.936).margin(5e-4));
  CHECK(web.width.lambda_p == Approx(1.5328).margin(5e-5));
  CHECK(web.width.rho == Approx(0.5996).margin(5e-5));
  CHECK(1e3 * web.width.b_e1.value() == Approx(164.9).margin(0.05));
  CHECK(1e3 * web.width.b_e2.value() == Approx(247.3).margin(0.05));
  CHECK(below_top(once.sums) == Approx(756.85).epsilon(1e-5));
  CHECK(1e12 * inertia_y(once.sums) == Approx(6325.5e6).epsilon(1e-5));
  const auto top_modulus = [](const SectionAlone& of) {
    return 1e9 * inertia_y(of.sums) / (0.605 - of.sums.z / of.sums.area);
  };
  CHECK(top_modulus(once) == Approx(8413e3).epsilon(1e-4));
  const SectionAlone settled = section_alone(box, ActingAlone::M_y_negative, {}, 100);
  CHECK(settled.passes > 2);
  CHECK(settled.passes < 100);
  CHECK(settled.of(left_web).psi == Approx(-0.584).margin(5e-4));
  CHECK(top_modulus(settled) == Approx(8187e3).epsilon(1e-4));
}

TEST_CASE("reference box under M_z: flanges are the webs, and whole") {
  for (const ActingAlone acting : {ActingAlone::M_z_positive, ActingAlone::M_z_negative}) {
    const SectionAlone of = section_alone(reference_box(), acting);
    const BoxPlate pressed = acting == ActingAlone::M_z_positive ? left_web : right_web;
    CHECK(of.of(pressed).width.rho == Approx(0.2872).margin(5e-5));
    CHECK(of.of(top_flange).psi == Approx(-0.605).margin(5e-4));
    CHECK(of.of(top_flange).width.rho == 1.0);
    CHECK(1e12 * inertia_z(of.sums) == Approx(1537.75e6).epsilon(1e-5));
    const double y = pressed == left_web ? 0.3 : -0.3;
    const double modulus = inertia_z(of.sums) / std::abs(y - of.sums.y / of.sums.area);
    CHECK(1e9 * modulus == Approx(4125e3).epsilon(2e-4));
  }
}

TEST_CASE("reference box: what it bears, N with its eccentricity and M_y") {
  const EffectiveBox box(reference_box());
  // 355 MPa times A_eff, at the gross centroid: the shift of 67.42 mm adds compression on top.
  CutForces cut{};
  cut.N = si<Force>(-1e6);
  cut.M_y = cut.N * (si<Length>(0.610 - 0.65611));
  const CornerUse of = box.worst_corner(cut);
  CHECK(of.corner.flange == top_flange);
  CHECK(of.shifts.along_z);
  const double expected = (1e6 / 17854e-6 + 1e6 * 67.42e-3 / 8413e-6) / 355e6;
  CHECK(of.use == Approx(expected).epsilon(2e-4));
  CutForces bent{};
  bent.M_y = si<Moment>(-2987e3);
  CHECK(box.use(bent) == Approx(1.0).epsilon(5e-4));
  bent.M_y = si<Moment>(-1500e3);
  CHECK(box.use(bent) == Approx(0.50).margin(5e-3));
}

TEST_CASE("reference box under N, M_y and M_z together: the sum 4.15, term by term") {
  // N at the gross centroid, M_y pressing the top, M_z the left web; by hand N/A_eff + N e_N/W_y +
  // M_y/W_y + M_z/W_z with 17854 mm^2, 67.42 mm, 8413e3 mm^3 and 4125e3 mm^3. The section that is
  // left under M_z alone is lopsided, so that M_z bends it obliquely: I_y = 6 949e6 or more, I_yz =
  // -117.6e6 mm^4, by which W_z is 4010e3 mm^3 at the corner; the worse of both counts.
  const EffectiveBox box(reference_box());
  struct Point {
    double N, M_y, M_z;  // kN, kN m
    double plain, oblique;
  };
  for (const Point& of :
       {Point{1000.0, 1000.0, 300.0, 0.7200, 0.7259}, Point{2000.0, 800.0, 200.0, 0.7651, 0.7690},
        Point{500.0, 1500.0, 400.0, 0.8656, 0.8734}}) {
    CAPTURE(of.N, of.M_y, of.M_z);
    const auto sum = [&](double W_z) {
      const double stress = of.N * 1e3 / 17854e-6 +
                            (of.N * 1e3 * 67.42e-3 + of.M_y * 1e3) / 8413e-6 + of.M_z * 1e3 / W_z;
      return stress / 355e6;
    };
    CHECK(sum(4125e-6) == Approx(of.plain).margin(1e-4));
    CHECK(sum(4009.9e-6) == Approx(of.oblique).margin(1e-4));
    CutForces cut{};
    cut.N = si<Force>(-1e3 * of.N);
    cut.M_y = cut.N * si<Length>(0.610 - 0.65611) - si<Moment>(1e3 * of.M_y);
    cut.M_z = si<Moment>(1e3 * of.M_z);
    const CornerUse found = box.worst_corner(cut);
    CHECK(found.corner.flange == top_flange);
    CHECK(found.corner.web == left_web);
    CHECK(found.use >= of.plain * (1.0 - 2e-4));
    CHECK(found.use == Approx(of.oblique).margin(2e-4));
  }
  // A_eff f_y alone.
  CHECK(355e6 * box.alone(ActingAlone::compression).sums.area == Approx(6338e3).epsilon(1e-4));
}

TEST_CASE("where class 3 ends, at c = 42 eps t, a compressed plate has rho = 0.95 of 4.4(2)") {
  // lambda_p = 42/(28.4 x 2) = 0.7394, (0.7394 - 0.22)/0.7394^2 = 0.9500; whole it is to 38.2 eps
  // t.
  const double eps = std::sqrt(235.0 / 355.0), t = 10.0, c = 42.0 * eps * t;
  const auto box_of = [&](double clear) {
    const Box of{mm(clear + 40.0), mm(300.0), mm(t), mm(t), mm(20.0), mm(20.0)};
    return EffectiveBox(*four_walls_of(of, steel()));
  };
  const double rho = box_of(c).alone(ActingAlone::compression).of(top_flange).width.rho;
  CHECK(rho == Approx(0.9500).margin(5e-5));
  CHECK(box_of(38.2 * eps * t).alone(ActingAlone::compression).of(top_flange).width.rho ==
        Approx(1.0).margin(1e-3));
  // The stout webs are whole: what is lost is of the flanges.
  CutForces cut{};
  cut.N = si<Force>(-1e6);
  const double gross = 2.0 * (c + 40.0) * t + 2.0 * 280.0 * 20.0;
  CHECK(box_of(c).use(cut) * 355.0 * (gross - 2.0 * (1.0 - rho) * c * t) ==
        Approx(1e6).epsilon(1e-4));
}

TEST_CASE("what a shift of the centroid relieves is not counted") {
  const EffectiveBox box(reference_box());
  CutForces cut{};
  cut.N = si<Force>(-1e5);
  // The bottom compressed.
  cut.M_y = si<Moment>(1500e3);
  const CornerUse of = box.worst_corner(cut);
  const bool relieves = of.corner.flange == bottom_flange && of.stress.value() < 0.0;
  if (relieves) CHECK(!of.shifts.along_z);
  // The same force in tension works on the gross section, without shift.
  cut.N = -cut.N;
  CHECK(!box.worst_corner(cut).shifts.along_z);
  CHECK(box.worst_corner(cut).area.value() == Approx(35040e-6));
}

TEST_CASE("what A_eff in place of A relieves of a stretched corner is not counted") {
  // N = -1100 kN and M stretching the weak lower flange.
  const Box weak{mm(900.0), mm(1200.0), mm(12.0), mm(6.0), mm(12.0), mm(12.0)};
  const EffectiveBox box(*four_walls_of(weak, steel()));
  CutForces cut{};
  cut.N = si<Force>(-1.1e6);
  cut.M_y = si<Moment>(-3.28e6);
  const SectionAlone& bent = box.alone(ActingAlone::M_y_negative);
  const double centroid = bent.sums.z / bent.sums.area;
  const double stress = -3.28e6 * (-0.597 - centroid) / inertia_y(bent.sums);
  // At the gross centroid, relieved by the gross area at most.
  const double z = box.box().gross.z / box.box().gross.area;
  const double least = stress * (3.28e6 - 1.1e6 * z) / 3.28e6 - 1.1e6 / box.box().gross.area;
  CHECK(box.use(cut) * 355e6 >= least * (1.0 - 1e-9));
}

TEST_CASE("200 boxes at random under M_y: as a sum over fibres has it") {
  test::Uniform in(20);
  const Material material = steel();
  int slender = 0;
  for (int i = 0; i < 200; ++i) {
    const Box box = random_box(in);
    CAPTURE(i, box.width.value(), box.height.value());
    const EffectiveBox of(*four_walls_of(box, material));
    const FibreBox::Found fibres = FibreBox(box).found();
    const SectionAlone& alone = of.alone(ActingAlone::M_y_negative);
    const double centroid = alone.sums.z / alone.sums.area, inertia = inertia_y(alone.sums);
    const double top = 0.5 * (box.height - box.top_flange).value();
    const double bottom = 0.5 * (box.bottom_flange - box.height).value();
    // The branches of k_sigma miss each other by 0.2 % at psi = -1.
    CHECK((top - centroid) / inertia == Approx(fibres.top).epsilon(2e-3));
    CHECK((centroid - bottom) / inertia == Approx(fibres.bottom).epsilon(2e-3));
    slender += alone.sums.area < 0.999 * of.box().gross.area ? 1 : 0;
  }
  CHECK(slender > 80);
}

TEST_CASE("stout plates: the effective section is the gross one, the stress Navier's") {
  test::Uniform in(21);
  const Material material = steel();
  const Box box{mm(300.0), mm(400.0), mm(20.0), mm(25.0), mm(15.0), mm(18.0)};
  const EffectiveBox of(*four_walls_of(box, material));
  for (int i = 0; i < 50; ++i) {
    const CutForces cut = random_forces(in);
    double largest = 0.0;
    for (const double y : {0.5 * 0.3 - 0.0075, 0.009 - 0.15}) {
      for (const double z : {0.2 - 0.01, 0.0125 - 0.2}) {
        const StressInfluence at = normal_influence(sums_of(outline_of(Profile(box))), y, z);
        largest = std::max(largest, std::abs(stress_at(at, cut).normal.value()));
      }
    }
    CHECK(of.use(cut) == Approx(largest / 355e6).epsilon(0.02));
  }
}

TEST_CASE("use grows with the load in proportion, and never falls when a plate gets thinner") {
  test::Uniform in(22);
  const Material material = steel();
  for (int i = 0; i < 300; ++i) {
    Box box = random_box(in);
    const CutForces cut = random_forces(in);
    const EffectiveBox of(*four_walls_of(box, material));
    const double use = of.use(cut);
    CutForces half{};
    half.N = 0.5 * cut.N;
    half.M_y = 0.5 * cut.M_y;
    half.M_z = 0.5 * cut.M_z;
    CHECK(of.use(half) == Approx(0.5 * use).epsilon(1e-12));
    // All plates thinner by the same part: the section stays what it is in shape.
    for (Length* t : {&box.top_flange, &box.bottom_flange, &box.left_web, &box.right_web})
      *t = 0.95 * *t;
    CHECK(EffectiveBox(*four_walls_of(box, material)).use(cut) >= use);
  }
}

TEST_CASE("boxes mirrored left to right and top to bottom are used alike") {
  test::Uniform in(23);
  const Material material = steel();
  for (int i = 0; i < 100; ++i) {
    const Box box = random_box(in);
    const CutForces cut = random_forces(in);
    const double use = EffectiveBox(*four_walls_of(box, material)).use(cut);
    Box other = box;
    std::swap(other.left_web, other.right_web);
    CutForces turned = cut;
    turned.M_z = -cut.M_z;
    CHECK(EffectiveBox(*four_walls_of(other, material)).use(turned) == Approx(use).epsilon(1e-9));
    other = box;
    std::swap(other.top_flange, other.bottom_flange);
    turned = cut;
    turned.M_y = -cut.M_y;
    CHECK(EffectiveBox(*four_walls_of(other, material)).use(turned) == Approx(use).epsilon(1e-9));
  }
}

TEST_CASE("longer iteration ends, and in the same place from there") {
  test::Uniform in(24);
  const Material material = steel();
  for (int i = 0; i < 200; ++i) {
    const FourWalls walls = *four_walls_of(random_box(in), material);
    for (const ActingAlone acting : {ActingAlone::M_y_positive, ActingAlone::M_z_negative}) {
      const SectionAlone settled = section_alone(walls, acting, {}, 200);
      CHECK(settled.passes < 200);
      CHECK(section_alone(walls, acting, {}, 400).sums.area ==
            Approx(settled.sums.area).epsilon(1e-9));
    }
  }
}

TEST_CASE("what has not four plates has no walls") {
  const Material material = steel();
  CHECK(!four_walls_of(RoundTube{mm(500.0), mm(5.0)}, material));
  CHECK(!four_walls_of(Box{mm(300.0), mm(400.0), mm(50.0), mm(20.0), mm(8.0), mm(8.0)}, material));
  // Of rolled tubes b - 3 t counts, EN 1993-1-5, 4.4(2).
  const auto tube =
      four_walls_of(RectangularTube{mm(300.0), mm(300.0), mm(8.0), mm(20.0), mm(12.0)}, material);
  REQUIRE(tube);
  CHECK(tube->of(top_flange).clear().value() == Approx(0.276));
}

TEST_CASE("stiffened boxes: what is left is the outline less what does not work, part by part") {
  // N, M_y and M_z of a box with flats on all plates: areas and first moments as sums over small
  // squares of the strips and flats that stiffened_widths leaves, its own formulas tested apart.
  const Material material = steel();
  Box box{mm(1200.0), mm(1000.0), mm(8.0), mm(10.0), mm(6.0), mm(7.0)};
  for (const double y : {-300.0, 250.0}) {
    box.stiffeners.push_back({top_flange, mm(y), mm(90.0), mm(10.0)});
    box.stiffeners.push_back({bottom_flange, mm(y + 20.0), mm(80.0), mm(8.0)});
  }
  // One of each web is compressed whatever bends the box.
  for (const double z : {-250.0, 200.0}) {
    box.stiffeners.push_back({left_web, mm(z), mm(70.0), mm(8.0)});
    box.stiffeners.push_back({right_web, mm(z + 30.0), mm(70.0), mm(8.0)});
  }
  FourWalls walls = *four_walls_of(box, material);
  walls.length = mm(1500.0);
  for (int k = 0; k < 5; ++k) {
    const SectionAlone of = section_alone(walls, static_cast<ActingAlone>(k));
    Box left = box;
    left.stiffeners.clear();
    AreaSums sums = sums_of(outline_of(Profile(left)));
    int stiffened = 0;
    for (const BoxPlate plate : box_plates) {
      const BoxWall& wall = walls.of(plate);
      const WallAlone& alone = of.of(plate);
      const bool flange = is_flange(plate);
      const double inwards = wall.middle.value() > 0.0 ? -1.0 : 1.0;
      const auto add = [&](double along, double across, double width, double depth, double share) {
        AreaSums part = sums_of_rectangle(flange ? along : across, flange ? across : along,
                                          flange ? width : depth, flange ? depth : width);
        for (double* x : {&part.area, &part.y, &part.z, &part.yy, &part.zz, &part.yz}) *x *= share;
        sums = sums + part;
      };
      for (std::size_t i = 0; i < wall.stiffeners.size(); ++i) {
        const FlatStiffener& bar = wall.stiffeners[i];
        add(bar.place.value(),
            wall.middle.value() + inwards * 0.5 * (wall.thickness + bar.depth).value(),
            bar.thickness.value(), bar.depth.value(),
            alone.stiffened ? alone.stiffened->stiffeners[i] : 1.0);
      }
      if (!alone.stiffened) continue;
      ++stiffened;
      for (const WorkingStrip& strip : alone.stiffened->strips) {
        add(0.5 * (strip.low + strip.high).value(), wall.middle.value(),
            (strip.high - strip.low).value(), wall.thickness.value(), strip.works - 1.0);
      }
    }
    CAPTURE(k);
    CHECK(stiffened >= 3);
    CHECK(of.sums.area == Approx(sums.area).epsilon(1e-9));
    CHECK(of.sums.area < 0.9 * walls.gross.area);
    CHECK(of.sums.y == Approx(sums.y).margin(1e-9));
    CHECK(of.sums.z == Approx(sums.z).margin(1e-9));
    CHECK(of.sums.yy == Approx(sums.yy).epsilon(1e-9));
    CHECK(of.sums.zz == Approx(sums.zz).epsilon(1e-9));
    CHECK(of.sums.yz == Approx(sums.yz).margin(1e-9));
  }
}

TEST_CASE("stiffened boxes mirrored left to right and top to bottom are used alike") {
  test::Uniform in(24);
  const Material material = steel();
  for (int i = 0; i < 50; ++i) {
    Box box{mm(in(700.0, 1400.0)), mm(in(700.0, 1400.0)), mm(in(6.0, 12.0)),
            mm(in(6.0, 12.0)),     mm(in(5.0, 10.0)),     mm(in(5.0, 10.0))};
    for (const BoxPlate plate : box_plates)
      box.stiffeners.push_back({plate, mm(in(-250.0, 250.0)), mm(80.0), mm(8.0)});
    const CutForces cut = random_forces(in);
    const auto use_of = [&](const Box& of, const CutForces& forces) {
      FourWalls walls = *four_walls_of(of, material);
      walls.length = mm(1000.0 + 50.0 * i);
      return EffectiveBox(walls).use(forces);
    };
    const double use = use_of(box, cut);
    for (const bool sideways : {true, false}) {
      Box other = box;
      CutForces turned = cut;
      if (sideways) {
        std::swap(other.left_web, other.right_web);
        turned.M_z = -cut.M_z;
      } else {
        std::swap(other.top_flange, other.bottom_flange);
        turned.M_y = -cut.M_y;
      }
      for (Stiffener& bar : other.stiffeners) {
        if (is_flange(bar.plate) == sideways)
          bar.place = -bar.place;
        else
          bar.plate = sideways ? (bar.plate == left_web ? right_web : left_web)
                               : (bar.plate == top_flange ? bottom_flange : top_flange);
      }
      CHECK(use_of(other, turned) == Approx(use).epsilon(1e-9));
    }
  }
}

}  // namespace effective_box_test
