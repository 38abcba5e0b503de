// Effective sections of thin-walled paths: an I by hand, the same box as a path and as a box, and
// what must not change them.

#include "boxbeam/strength/effective_path.hpp"

#include <cmath>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "catch.hpp"
#include "support/paths.hpp"
#include "support/uniform.hpp"

namespace effective_path_test {

using namespace boxbeam;
using namespace paths;
using enum ActingAlone;

namespace {

const Material& steel() {
  static const Material s355 = *find_steel("S355");
  return s355;
}

PathSection section_of(const ThinWalled& path) { return *path_section_of(path, steel()); }

CutForces forces(double N, double M_y, double M_z = 0.0) {
  CutForces cut{};
  cut.N = si<Force>(N);
  cut.M_y = si<Moment>(M_y);
  cut.M_z = si<Moment>(M_z);
  return cut;
}

ThinWalled turned(ThinWalled path) {
  for (SectionPlace& at : path.nodes) at = {-at.z, at.y};
  return path;
}

/// Sums of strips of an upright or level plate, mm: by hand.
struct Strips {
  double A = 0.0, S = 0.0, I = 0.0;  ///< I about z = 0
  void level(double width, double t, double z) { add(width * t, z, width * t * t * t / 12.0); }
  void upright(double low, double high, double t) {
    add((high - low) * t, 0.5 * (low + high), t * std::pow(high - low, 3) / 12.0);
  }
  double centroid() const { return S / A; }
  double inertia() const { return I - A * centroid() * centroid(); }

 private:
  void add(double area, double z, double own) {
    A += area;
    S += area * z;
    I += own + area * z * z;
  }
};

const double eps = std::sqrt(235.0 / 355.0);

double outstand_rho(double c_over_t, double k) {
  const double lambda = c_over_t / (28.4 * eps * std::sqrt(k));
  return lambda <= 0.748 ? 1.0 : (lambda - 0.188) / (lambda * lambda);
}

}  // namespace

TEST_CASE("an I of slender flanges and web by hand, one pass: sagging, hogging, compression") {
  // S355, flanges 400 x 12, web 1200 x 6: c/t = 197/12 = 16.4 above 11.4, 200 above 100.9.
  const PathSection path = section_of(i_section(400.0, 12.0, 1200.0, 6.0));
  const double rho_f = outstand_rho(197.0 / 12.0, 0.43);
  CHECK(rho_f == Approx(0.7631).margin(5e-4));
  const double flange = 6.0 + 2.0 * rho_f * 197.0;  // of the compressed one
  // The web with the effective flange and all of itself: the axis sinks below mid-height.
  Strips with_web;
  with_web.level(flange, 12.0, 606.0);
  with_web.level(400.0, 12.0, -606.0);
  with_web.upright(-600.0, 600.0, 6.0);
  const double axis = with_web.centroid();
  const double psi = -(600.0 + axis) / (600.0 - axis);
  const double k = 7.81 - 6.29 * psi + 9.78 * psi * psi;
  const double lambda = 200.0 / (28.4 * eps * std::sqrt(k));
  const double rho_w = (lambda - 0.055 * (3.0 + psi)) / (lambda * lambda);
  const double pressed = 1200.0 / (1.0 - psi), works = rho_w * pressed;
  Strips left;
  left.level(flange, 12.0, 606.0);
  left.level(400.0, 12.0, -606.0);
  left.upright(600.0 - 0.4 * works, 600.0, 6.0);
  left.upright(-600.0, 600.0 - pressed + 0.6 * works, 6.0);
  // M_y < 0 compresses +z.
  const PathAlone of = path_alone(path, M_y_negative, false, 1);
  CHECK(of.sums.area * 1e6 == Approx(left.A).epsilon(1e-9));
  CHECK(of.sums.z / of.sums.area * 1e3 == Approx(left.centroid()).epsilon(1e-9));
  CHECK((of.sums.zz - of.sums.z * of.sums.z / of.sums.area) * 1e12 ==
        Approx(left.inertia()).epsilon(1e-9));
  // Sagging mirrors hogging, passes go on to less: what the axis sinks by takes from the web.
  const PathAlone other = path_alone(path, M_y_positive, false, 1);
  CHECK(other.sums.area == Approx(of.sums.area).epsilon(1e-12));
  CHECK(other.sums.z == Approx(-of.sums.z).epsilon(1e-9));
  const PathAlone whole = path_alone(path, M_y_negative);
  CHECK(whole.settled);
  CHECK(whole.sums.area < of.sums.area);
  const auto modulus = [](const PathAlone& at) {
    return 1.0 / std::abs(stress_per_moment(at.sums, M_y_negative, 0.0, 0.606));
  };
  // A sum of 120 000 strips of the web, step by step until its centroid stays: psi = -0.716105, z_c
  // = -99.258 mm, I = 3.63496e9 mm^4.
  CHECK(whole.plates.back().psi == Approx(-0.716105).margin(2e-5));
  CHECK(whole.sums.z / whole.sums.area * 1e3 == Approx(-99.258).epsilon(2e-5));
  CHECK((whole.sums.zz - whole.sums.z * whole.sums.z / whole.sums.area) * 1e12 ==
        Approx(3.63496e9).epsilon(2e-5));
  CHECK(modulus(whole) < modulus(of));
  CHECK(modulus(whole) > 0.97 * modulus(of));
  // N alone: k = 0.43 and 4.
  const double lambda_N = 200.0 / (28.4 * eps * 2.0);
  const double rho_N = (lambda_N - 0.22) / (lambda_N * lambda_N);
  CHECK(path_alone(path, compression).sums.area * 1e6 ==
        Approx(2.0 * flange * 12.0 + rho_N * 1200.0 * 6.0).epsilon(1e-9));
}

TEST_CASE(
    "an I bent about its weak axis: its flanges are outstands compressed at the tip or held "
    "there",
    "[plates]") {
  // M_z > 0 compresses +y: the outstands there most at their tips, psi = 3/200 of the axis at y =
  // 0; those at -y are stretched. By hand, one pass: flanges are the webs of M_z.
  const PathSection path = section_of(i_section(400.0, 10.0, 1200.0, 6.0));
  const PathAlone of = path_alone(path, M_z_positive, false, 1);
  const double psi = 3.0 / 200.0, k = 0.57 - 0.21 * psi + 0.07 * psi * psi;
  const double rho = outstand_rho(19.7, k);
  REQUIRE(rho < 1.0);
  CHECK((path.gross.area - of.sums.area) * 1e6 ==
        Approx(2.0 * (1.0 - rho) * 197.0 * 10.0).epsilon(1e-9));
  // Eccentric compression of an angle's leg at its corner: table 4.2, below.
  ThinWalled angle;
  const std::size_t heel = add_node(angle, mm_place(0.0, 0.0));
  add_wall(angle, heel, add_node(angle, mm_place(200.0, 0.0)), 8.0);
  add_wall(angle, heel, add_node(angle, mm_place(0.0, 200.0)), 8.0);
  const PathPlate leg = section_of(angle).plates.front();
  REQUIRE(leg.outstand());
  const bool held_high = leg.held_at_high();
  const auto alone = [&](double held, double tip) {
    return plate_alone(leg, leg.class_strength, {}, held_high ? tip : held, held_high ? held : tip);
  };
  // 196 mm: psi = 0.5 at the support: k = 0.578/0.84; psi = -0.5: 1.7 + 2.5 + 4.275 = 8.475.
  CHECK(alone(1.0, 0.5).idle() * 1e3 ==
        Approx((1.0 - outstand_rho(24.5, 0.578 / 0.84)) * 196.0).epsilon(1e-9));
  CHECK(alone(1.0, -0.5).idle() == Approx(0.0).margin(1e-12));  // lambda = 0.364
  // At the tip, psi = -0.5: k = 0.57 + 0.105 + 0.0175, of 2/3 of the width.
  const double rho_tip = outstand_rho(24.5, 0.6925);
  const PlateAlone tip = alone(-0.5, 1.0);
  CHECK(tip.idle() * 1e3 == Approx((1.0 - rho_tip) * 196.0 / 1.5).epsilon(1e-9));
  // It lies at the free edge.
  CHECK((held_high ? tip.idle_low - leg.low : leg.high - tip.idle_high) ==
        Approx(0.0).margin(1e-12));
}

TEST_CASE("a box as a path is the box of passes until nothing changes", "[plates]") {
  test::Uniform in(3);
  int judged = 0;
  for (int i = 0; i < 40; ++i) {
    const double b = in(300.0, 900.0), h = in(400.0, 1400.0);
    const double top = in(5.0, 15.0), bottom = in(5.0, 15.0), web = in(5.0, 12.0);
    Box box = symmetric_box(mm(b), mm(h), mm(top), mm(web));
    box.bottom_flange = mm(bottom);
    const FourWalls walls = *four_walls_of(box, steel());
    const EffectiveBox by_box(walls, {}, 100);
    const PathSection path = section_of(box_path(b, h, top, web, bottom));
    const EffectivePath by_path(path);
    REQUIRE(by_path.settled());
    for (const ActingAlone acting :
         {compression, M_y_positive, M_y_negative, M_z_positive, M_z_negative}) {
      CAPTURE(i, static_cast<int>(acting));
      const AreaSums &a = by_box.alone(acting).sums, &p = by_path.alone(acting).sums;
      CHECK(p.area == Approx(a.area).epsilon(1e-9));
      CHECK(p.z == Approx(a.z).epsilon(1e-8).margin(1e-12));
      CHECK(p.zz == Approx(a.zz).epsilon(1e-8));
      CHECK(p.yy == Approx(a.yy).epsilon(1e-8));
    }
    for (int n = 0; n < 10; ++n) {
      const CutForces cut = forces(in(-2e6, 1e6), in(-2e6, 2e6));
      CHECK(by_path.use(cut) == Approx(by_box.use(cut)).epsilon(1e-7));
      // Bent across the path's flanges end at the outer faces, beyond the corners.
      const CutForces both = forces(cut.N.value(), cut.M_y.value(), in(-5e5, 5e5));
      CHECK(by_path.use(both) >= by_box.use(both) * (1.0 - 1e-7));
      CHECK(by_path.use(both) <= by_box.use(both) * b / (b - web) * (1.0 + 1e-7));
      ++judged;
    }
  }
  CHECK(judged == 400);
}

TEST_CASE("a path turned by 90 degrees swaps y and z, walls split in two change nothing",
          "[plates]") {
  test::Uniform in(5);
  for (int i = 0; i < 30; ++i) {
    const ThinWalled path =
        i % 3 == 0   ? i_section(in(200.0, 600.0), in(6.0, 20.0), in(600.0, 1500.0), in(5.0, 10.0),
                                 in(6.0, 20.0), in(200.0, 600.0))
        : i % 3 == 1 ? channel(in(600.0, 1200.0), in(200.0, 300.0), in(5.0, 10.0), in(8.0, 12.0))
                     : box_path(in(300.0, 900.0), in(400.0, 1400.0), in(5.0, 15.0), in(5.0, 12.0));
    const EffectivePath of(section_of(path)), across(section_of(turned(path)));
    const std::size_t wall = static_cast<std::size_t>(i) % path.walls.size();
    const EffectivePath in_two(section_of(split(path, wall, in(0.1, 0.9))));
    REQUIRE(of.settled());
    for (int n = 0; n < 10; ++n) {
      const double N = in(-1e6, 1e6), M_y = in(-1e6, 1e6), M_z = in(-2e5, 2e5);
      const double use = of.use(forces(N, M_y, M_z));
      CHECK(across.use(forces(N, -M_z, M_y)) == Approx(use).epsilon(1e-8));
      CHECK(in_two.use(forces(N, M_y, M_z)) == Approx(use).epsilon(1e-8));
      CHECK(of.use(forces(2.0 * N, 2.0 * M_y, 2.0 * M_z)) == Approx(2.0 * use).epsilon(1e-12));
    }
  }
}

TEST_CASE("each settled section is the one by whose stress its plates were judged", "[plates]") {
  const PathSection path = section_of(i_section(500.0, 12.0, 1400.0, 6.0, 20.0, 300.0));
  for (const ActingAlone acting : {M_y_positive, M_y_negative, M_z_positive, M_z_negative}) {
    const PathAlone of = path_alone(path, acting);
    REQUIRE(of.settled);
    for (std::size_t k = 0; k < path.plates.size(); ++k) {
      const PathPlate& plate = path.plates[k];
      const double sense = is_positive(acting) ? -1.0 : 1.0;
      const auto at = [&](double along) {
        const Eigen::Vector2d place = plate.at(along);
        return sense * stress_per_moment(of.sums, acting, place.x(), place.y());
      };
      const double low = at(plate.low), high = at(plate.high), most = std::max(low, high);
      CHECK(of.plates[k].pressed == (most > 0.0));
      const double psi = std::min(low, high) / most;
      if (most > 0.0 && psi > -1.0) CHECK(of.plates[k].psi == Approx(psi).margin(1e-8));
    }
  }
}

TEST_CASE("thicker walls are used no more, and what is stout is the gross section", "[plates]") {
  test::Uniform in(9);
  for (int i = 0; i < 30; ++i) {
    const double b = in(200.0, 600.0), t_f = in(6.0, 12.0), h = in(600.0, 1500.0),
                 t_w = in(4.0, 8.0);
    const CutForces cut = forces(in(-5e5, 0.0), in(-1e6, 1e6));
    // The mid-lines stay where they are.
    const auto use = [&](double more) {
      return EffectivePath(section_of(i_section(b, t_f * more, h - t_f * (more - 1.0), t_w * more)))
          .use(cut);
    };
    double before = use(1.0);
    for (const double more : {1.05, 1.1, 1.2, 1.3}) {
      const double now = use(more);
      CHECK(now < before);
      before = now;
    }
  }
  const PathSection stout = section_of(i_section(200.0, 15.0, 200.0, 9.0));
  const EffectivePath of(stout);
  const double sigma = std::abs(stress_per_moment(stout.gross, M_y_positive, 0.0, 0.1075)) * 1e5;
  CHECK(of.use(forces(0.0, 1e5)) == Approx(sigma / 355e6).epsilon(1e-9));
}

TEST_CASE("a Z is used by the worse of bending about its axis alone and of unsymmetric bending",
          "[plates]") {
  ThinWalled zed = channel(400.0, 120.0, 5.0, 8.0);
  zed.nodes.back().y = -zed.nodes.back().y;
  const PathSection path = section_of(zed);
  const EffectivePath of(path);
  REQUIRE(of.settled());
  double coupled = 0.0, by_itself = 0.0;
  for (const SectionPlace& at : zed.nodes) {
    coupled = std::max(
        coupled,
        std::abs(normal_influence(path.gross, at.y.value(), at.z.value()).normal[cut_force::M_y]));
    by_itself =
        std::max(by_itself,
                 std::abs(stress_per_moment(path.gross, M_y_positive, at.y.value(), at.z.value())));
  }
  const double use = of.use(forces(0.0, 1e4));
  CHECK(use >= 1e4 * coupled / 355e6 * (1.0 - 1e-9));
  CHECK(use >= 1e4 * by_itself / 355e6 * (1.0 - 1e-9));
}

}  // namespace effective_path_test
