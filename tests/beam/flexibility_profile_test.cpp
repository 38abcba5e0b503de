// Flexibilities of sections against hand formulas, and along tapered beams against the sections
// themselves.
#include "boxbeam/beam/flexibility_profile.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"
#include "support/property.hpp"

namespace flexibility_profile_test {

using namespace boxbeam;
using namespace cut_force;

namespace {

constexpr double E = 2.1e11, G = 8.1e10;

Length m(double x) { return si<Length>(x); }
Approx exactly(double value) { return Approx(value).epsilon(1e-12).margin(0.0); }

Section plate(double b, double h) { return {Plate{m(b), m(h)}, {}}; }

/// A part of an area: a rectangle with its sides along y and z.
struct Rectangle {
  double y, z, width, height;  ///< of its middle, its sides
};

/// Extension and turns per N, M_y, M_z from the stiffness, integral by integral:
///
///     N = E int e dA, M_y = E int e z dA, M_z = -E int e y dA,   e = eps + z kappa_y - y kappa_z
Eigen::Matrix3d bending_of(const std::vector<Rectangle>& parts) {
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (const Rectangle& of : parts) {
    const double A = of.width * of.height;
    const Eigen::Vector3d at(1.0, of.z, -of.y);
    stiffness += E * A * at * at.transpose();
    stiffness(1, 1) += E * A * of.height * of.height / 12.0;
    stiffness(2, 2) += E * A * of.width * of.width / 12.0;
  }
  return stiffness.inverse();
}

void check_bending(const Flexibility& of, const std::vector<Rectangle>& parts) {
  const Eigen::Matrix3d expected = bending_of(parts);
  const Index order[] = {N, M_y, M_z};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      INFO(i << ", " << j);
      const double size = std::sqrt(expected(i, i) * expected(j, j));
      CHECK(std::abs(of(order[i], order[j]) - expected(i, j)) < 1e-12 * size);
    }
  }
}

/// All that is not written here is zero.
void check_uncoupled(const Flexibility& of) {
  for (const Index force : {V_y, V_z, T}) {
    for (const Index bends : {N, M_y, M_z}) {
      CHECK(of(force, bends) == 0.0);
      CHECK(of(bends, force) == 0.0);
    }
  }
  CHECK(of(V_y, V_z) == 0.0);
}

TEST_CASE("a solid rectangle: 1/E A, 6/5 G A, 12/E b h^3", "[flexibility]") {
  constexpr double b = 0.06, h = 0.12;
  const Flexibility of = flexibility_of(plate(b, h), E, G);
  CHECK(of(N, N) == exactly(1.0 / (E * b * h)));
  CHECK(of(V_y, V_y) == exactly(1.2 / (G * b * h)));
  CHECK(of(V_z, V_z) == exactly(1.2 / (G * b * h)));
  CHECK(of(M_y, M_y) == exactly(12.0 / (E * b * h * h * h)));
  CHECK(of(M_z, M_z) == exactly(12.0 / (E * h * b * b * b)));
  // beta = 0.229 of h/b = 2. Source: Timoshenko, Goodier, Theory of Elasticity, table of article
  // 109.
  CHECK(1.0 / (G * of(T, T)) == Approx(0.229 * h * b * b * b).epsilon(2e-3));
  check_bending(of, {{0.0, 0.0, b, h}});
  check_uncoupled(of);
}

TEST_CASE("a box: its webs carry V_z, its flanges V_y, its hollow T", "[flexibility]") {
  constexpr double b = 0.4, h = 1.0, t_f = 0.004, t_w = 0.003;
  const Flexibility of = flexibility_of({symmetric_box(m(b), m(h), m(t_f), m(t_w)), {}}, E, G);
  CHECK(of(V_z, V_z) == exactly(1.0 / (G * 2.0 * t_w * h)));
  CHECK(of(V_y, V_y) == exactly(1.0 / (G * 2.0 * t_f * b)));
  check_bending(of, {{0.0, 0.0, b, h}, {0.0, 0.0, b - 2.0 * t_w, -(h - 2.0 * t_f)}});
  // Bredt: 4 A_m^2/sum(s/t), whose error is of the order of t/b.
  const double area = (b - t_w) * (h - t_f);
  const double around = 2.0 * ((b - t_w) / t_f + (h - t_f) / t_w);
  CHECK(1.0 / (G * of(T, T)) == Approx(4.0 * area * area / around).epsilon(5e-3));
  check_uncoupled(of);
}

TEST_CASE("in a box of unlike plates N bends", "[flexibility]") {
  constexpr double b = 0.3, h = 0.5, top = 0.03, bottom = 0.01, left = 0.012, right = 0.02;
  Box box = symmetric_box(m(b), m(h), m(top), m(left));
  box.bottom_flange = m(bottom);
  box.right_web = m(right);
  const Flexibility of = flexibility_of({box, {}}, E, G);
  // The webs stand between the flanges, left is +y.
  const double clear = h - top - bottom, middle = 0.5 * (bottom - top);
  check_bending(of, {{0.0, 0.5 * (h - top), b, top},
                     {0.0, -0.5 * (h - bottom), b, bottom},
                     {0.5 * (b - left), middle, left, clear},
                     {-0.5 * (b - right), middle, right, clear}});
  // Pulled in its axis, below the centroid, it lengthens more below; right of the centroid is -y.
  CHECK(of(M_y, N) < 0.0);
  CHECK(std::abs(of(M_y, M_z)) > 1e-4 * of(M_y, M_y));
  CHECK(of(V_z, V_z) - of(V_z, T) * of(V_z, T) / of(T, T) ==
        exactly(1.0 / (G * (left + right) * h)));
  CHECK(of(V_y, V_y) - of(V_y, T) * of(V_y, T) / of(T, T) ==
        exactly(1.0 / (G * (top + bottom) * b)));
}

TEST_CASE("pushed down in its web a channel twists: e = 3 b^2 t_f/(h t_w + 6 b t_f)",
          "[flexibility]") {
  // The web along z in y = 0, flanges towards +y; the shear centre is behind the web, y = -e.
  // Source: Megson, Aircraft Structures for Engineering Students, 17.2.1. On mid-lines; the walls'
  // own thickness shifts it a little.
  constexpr double b = 0.1, h = 0.2;
  for (const double t : {2e-3, 2e-4}) {
    const double t_f = 1.5 * t;
    ThinWalled path;
    path.nodes = {
        {m(b), m(-0.5 * h)}, {m(0.0), m(-0.5 * h)}, {m(0.0), m(0.5 * h)}, {m(b), m(0.5 * h)}};
    path.walls = {{0, 1, m(t_f)}, {1, 2, m(t)}, {2, 3, m(t_f)}};
    const Flexibility of = flexibility_of({path, {}}, E, G);
    const double e = 3.0 * b * b * t_f / (h * t + 6.0 * b * t_f);
    const double I_T = (2.0 * b * t_f * t_f * t_f + h * t * t * t) / 3.0;
    CHECK(of(T, T) == exactly(1.0 / (G * I_T)));
    CHECK(of(V_z, T) / of(T, T) == Approx(e).epsilon(2.0 * t / b));
    CHECK(std::abs(of(V_y, T)) < 1e-9 * of(V_z, T));
    const double twist = of(V_z, T) * of(V_z, T) / of(T, T);
    CHECK(of(V_z, V_z) == Approx(1.0 / (G * t * h) + twist).epsilon(1e-9));
    CHECK(of(V_y, V_y) == Approx(1.0 / (G * 2.0 * t_f * b)).epsilon(1e-9));
    CHECK(of == of.transpose());
  }
}

TEST_CASE("a polygon does not twist, as far as is known", "[flexibility]") {
  const Section triangle{Polygon{{{m(0), m(0)}, {m(0.1), m(0)}, {m(0), m(0.2)}}}, {}};
  CHECK(!twists(triangle));
  CHECK(flexibility_of(triangle, E, G).row(T).norm() == 0.0);
  CHECK(twists(plate(0.1, 0.2)));
}

/// Largest miss of the profile among many places, by the size of what each cut force does alone.
double miss_of(const Section& from, const Section& to) {
  TaperedBeam beam;
  beam.segments = {{"", m(0.0), m(0.7), plate(0.1, 0.1), plate(0.1, 0.1)},
                   {"", m(0.7), m(2.3), from, to}};
  const FlexibilityProfile profile(beam, E, G);
  REQUIRE(profile.borders().front() == 0.0);
  REQUIRE(profile.borders().back() == Approx(3.0).epsilon(1e-15));
  double worst = 0.0;
  for (std::size_t k = 1; k + 1 < profile.borders().size(); ++k) {
    const double low = profile.borders()[k], high = profile.borders()[k + 1];
    for (int i = 0; i <= 20; ++i) {
      const double s = low + (high - low) * (i + 0.0) / 20.0;
      const Flexibility exact = flexibility_of(interpolate(from, to, (s - 0.7) / 2.3), E, G);
      const Eigen::Array<double, 6, 1> size = exact.diagonal().array().sqrt();
      const Eigen::Matrix<double, 6, 1> unit = size.inverse().matrix();
      const Flexibility missed = unit.asDiagonal() * (profile.at(k, s) - exact) * unit.asDiagonal();
      worst = std::max(worst, missed.cwiseAbs().maxCoeff());
    }
  }
  return worst;
}

Section box(double b, double h, double t_f, double t_w) {
  return {symmetric_box(m(b), m(h), m(t_f), m(t_w)), {}};
}

TEST_CASE("along strong tapers the profile is the section's", "[flexibility]") {
  CHECK(miss_of(plate(0.1, 0.1), plate(0.1, 0.2)) < 1e-11);
  CHECK(miss_of(plate(0.2, 1.0), plate(0.2, 0.05)) < 1e-11);
  CHECK(miss_of(plate(0.3, 0.9), plate(0.03, 0.06)) < 1e-11);
  CHECK(miss_of(box(0.4, 1.0, 0.02, 0.02), box(0.4, 0.5, 0.02, 0.02)) < 1e-11);
  CHECK(miss_of(box(0.4, 1.2, 0.03, 0.012), box(0.25, 0.25, 0.03, 0.012)) < 1e-11);
  // Wedges: the thin end decides.
  CHECK(miss_of(plate(0.2, 1.0), plate(0.2, 0.01)) < 1e-11);
  CHECK(miss_of(plate(0.2, 1e-3), plate(0.2, 1.0)) < 3e-11);
  CHECK(miss_of(plate(0.2, 1.0), plate(0.2, 1e-3)) < 3e-11);
  const Section wide{RoundTube{m(0.6), m(0.02)}, {}}, thin{RoundTube{m(0.1), m(0.005)}, {}};
  CHECK(miss_of(wide, thin) < 1e-11);
}

TEST_CASE("flexibilities are symmetric and store no negative energy", "[flexibility]") {
  test::holds([] {
    const auto between = [](double low, double high) {
      return low + (high - low) * *rc::gen::resize(100, rc::gen::inRange(0, 1000)) / 999.0;
    };
    const double b = between(0.1, 0.5), h = between(0.1, 1.0);
    Section section = plate(b, h);
    const int kind = *rc::gen::inRange(0, 3);
    if (kind == 1) {
      Box of = symmetric_box(m(b), m(h), m(between(0.003, 0.03)), m(between(0.003, 0.03)));
      of.top_flange = m(between(0.003, 0.03));
      of.left_web = m(between(0.003, 0.03));
      section.outer = of;
    }
    if (kind == 2) {
      ThinWalled path;
      for (int i = 0; i < 4; ++i)
        path.nodes.push_back({m(i == 1 ? 0.0 : between(0.1, b)), m((i - 1) * h + 0.01)});
      for (std::size_t i = 0; i < 3; ++i) path.walls.push_back({i, i + 1, m(between(0.002, 0.01))});
      section.outer = path;
    }
    const Flexibility of = flexibility_of(section, E, G);
    const Eigen::Array<double, 6, 1> unit = of.diagonal().array().sqrt().inverse();
    const Flexibility scaled = unit.matrix().asDiagonal() * of * unit.matrix().asDiagonal();
    RC_ASSERT((scaled - scaled.transpose()).cwiseAbs().maxCoeff() < 1e-13);
    const Eigen::SelfAdjointEigenSolver<Flexibility> energies(scaled, Eigen::EigenvaluesOnly);
    RC_ASSERT(energies.eigenvalues()[0] > -1e-13);
  });
}

}  // namespace

}  // namespace flexibility_profile_test
