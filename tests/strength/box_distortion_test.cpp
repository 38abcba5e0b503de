// Distortion of boxes: closed forms of a beam on an elastic foundation, the frame of the cell by
// Castigliano's theorem, a tapered beam by finite differences, and what holds of any beam.

#include "boxbeam/strength/box_distortion.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "catch.hpp"

namespace box_distortion_test {

using namespace boxbeam;

namespace {

constexpr double E = 210e9, nu = 0.3, rigid = std::numeric_limits<double>::infinity();
constexpr std::array corners{CellCorner::top_left, CellCorner::bottom_left,
                             CellCorner::bottom_right, CellCorner::top_right};

BoxCell cell_of(double b, double h, std::array<double, 4> thickness) {
  BoxCell cell{si<Length>(b), si<Length>(h), {}};
  for (std::size_t i = 0; i < 4; ++i) cell.thickness[i] = si<Length>(thickness[i]);
  return cell;
}

BoxCell equal_cell(double b, double h, double flange, double web) {
  return cell_of(b, h, {flange, flange, web, web});
}

double plate_stiffness(double t) { return E * t * t * t / (12.0 * (1.0 - nu * nu)); }

CellDistortion distortion_of(const BoxCell& cell) { return cell_distortion_of(cell, E, nu); }

/// A beam of one cell with nodes at some places.
DistortedBeam uniform(const BoxCell& of, const std::vector<double>& places, double part = 0.0625) {
  return distorted_beam(
      places, [&](double) { return of; }, E, nu, part);
}

/// The same whose plates do not shear, as in the closed forms of bending.
DistortedBeam shearless(const BoxCell& of, const std::vector<double>& places) {
  DistortedBeam beam = uniform(of, places);
  for (auto& at : beam.shear_stiffness) at.fill(1e9 * at[0]);
  return beam;
}

/// One load at a place.
Distortion under(const DistortedBeam& beam, double s, double d) {
  std::vector<double> loads(beam.nodes.size(), 0.0);
  loads[beam.nearest(s)] = d;
  return DistortionSolver(beam).solve(loads);
}

/// A box that tapers from one end to the other, 8 m long.
constexpr double taper_length = 8.0;
BoxCell tapered_cell(double s) {
  const double x = s / taper_length;
  return cell_of(std::lerp(0.6, 0.4, x), std::lerp(1.2, 0.5, x), {0.012, 0.014, 0.008, 0.010});
}

CellDistortion tapered_at(double s) { return distortion_of(tapered_cell(s)); }

DistortedBeam tapered(const std::vector<double>& places, double part = 0.0625) {
  return distorted_beam(places, tapered_cell, E, nu, part);
}

const BoxCell plates = equal_cell(0.6, 1.2, 0.012, 0.008);
const CellDistortion cell = distortion_of(plates);
const double lambda = cell.decay, k = cell.frame_stiffness, EI = 0.25 * E * cell.warping_inertia;

}  // namespace

TEST_CASE("a cell of equal webs and equal flanges has the stiffness of the closed form",
          "[distortion]") {
  const double b = 0.6, h = 1.212, tf = 0.012, tw = 0.008;
  const CellDistortion of = distortion_of(equal_cell(b, h, tf, tw));
  // Points of inflection in the middle of the plates: gamma = m (h/(6 D_w) + b/(6 D_f)), k = 4 m.
  const double m = 6.0 / (h / plate_stiffness(tw) + b / plate_stiffness(tf));
  CHECK(of.frame_stiffness == Approx(4.0 * m).epsilon(1e-12));
  CHECK(of.warping_inertia == Approx(b * b * h * h * (b * tf + h * tw) / 24.0).epsilon(1e-12));
  CHECK(of.decay == Approx(std::pow(4.0 * m / (E * of.warping_inertia), 0.25)).epsilon(1e-12));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(of.corner_moments[i] == Approx(m).epsilon(1e-12));
    CHECK(of.warping[i] == Approx((i % 2 == 0 ? 0.25 : -0.25) * b * h).epsilon(1e-12));
  }
}

// A couple of 100 kN on the webs, d = 100 kN b/2, of an infinite beam by hand elsewhere: 1/lambda
// 4631 mm, 33.9 MPa along the beam, 810 N mm/mm in the corners, 76 MPa of it in the webs; of 1000 x
// 1000 x 10 1/lambda 5248 mm and 39.4 MPa. Halfway between diaphragms 2 m apart that do not give
// the first has P L/8, 7.3 MPa.
TEST_CASE("the figures of two cells under a couple on their webs", "[distortion][regression]") {
  const auto along = [](const CellDistortion& of, double b, double h) {
    return 2.0 * 0.25 * b * h / of.warping_inertia * (50e3 * b) / (4.0 * of.decay);
  };
  const CellDistortion deep = distortion_of(equal_cell(0.6, 1.212, 0.012, 0.008));
  CHECK(1.0 / deep.decay == Approx(4.631).epsilon(2e-4));
  CHECK(along(deep, 0.6, 1.212) == Approx(33.9e6).epsilon(2e-3));
  const double between = 4.0 * deep.decay * 2.0 / 8.0;  // L/8 for 1/(4 lambda)
  CHECK(between * along(deep, 0.6, 1.212) == Approx(7.3e6).epsilon(5e-3));
  const double corner = deep.corner_moments[0] * 30e3 * deep.decay / (2.0 * deep.frame_stiffness);
  CHECK(corner == Approx(810.0).epsilon(1e-3));
  CHECK(6.0 * corner / (0.008 * 0.008) == Approx(76e6).epsilon(3e-3));
  const CellDistortion square = distortion_of(equal_cell(1.0, 1.0, 0.01, 0.01));
  CHECK(1.0 / square.decay == Approx(5.248).epsilon(2e-4));
  CHECK(along(square, 1.0, 1.0) == Approx(39.4e6).epsilon(2e-3));
}

TEST_CASE("a cell of equal webs and equal flanges shears as by its flow in closed form",
          "[distortion]") {
  // Of M_D' = 1 the stress of a corner grows by s = 2 (b h/4)/I_w per length. Around the cell the
  // flow falls along a web by t_w h s (x - x^2) and rises as much along a flange, from q at the
  // corners, by which the torques of webs and flanges are opposite: q = s (h t_w - b t_f)/12.
  for (const double tf : {0.012, 0.03}) {
    const double b = 0.6, h = 1.2, tw = 0.008, G = E / (2.0 * (1.0 + nu));
    const CellDistortion of = distortion_of(equal_cell(b, h, tf, tw));
    const double s = 0.5 * b * h / of.warping_inertia;
    const double q = s * (h * tw - b * tf) / 12.0, web = -tw * h * s, flange = tf * b * s;
    // d = (T_w - T_f)/2 = T_w of the flow is the M_D' it belongs to.
    CHECK(b * h * (q + web / 6.0) == Approx(-1.0));
    const double energy = 2.0 * h / (G * tw) * (q * q + q * web / 3.0 + web * web / 30.0) +
                          2.0 * b / (G * tf) * (q * q + q * flange / 3.0 + flange * flange / 30.0);
    CHECK(of.shear_stiffness == Approx(1.0 / energy).epsilon(1e-10));
  }
}

TEST_CASE("a cell of unlike plates is the frame of least complementary energy", "[distortion]") {
  // Castigliano: of all corner moments whose sum is d = 1 (webs racked by gamma do the work) the
  // true ones make the sum of L/(6 D) (m_i^2 + m_j^2 - m_i m_j) least; its derivative is gamma.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(0.3, 1.5), wall(0.005, 0.03);
  for (int n = 0; n < 50; ++n) {
    const double b = size(random), h = size(random);
    const std::array t{wall(random), wall(random), wall(random), wall(random)};
    const CellDistortion of = distortion_of(cell_of(b, h, t));
    // Corners: top left, bottom left, bottom right, top right. Plates between them: left web,
    // bottom flange, right web, top flange.
    const std::array per{h / plate_stiffness(t[2]), b / plate_stiffness(t[1]),
                         h / plate_stiffness(t[3]), b / plate_stiffness(t[0])};
    Eigen::Matrix<double, 5, 5> system = Eigen::Matrix<double, 5, 5>::Zero();
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      const double f = per[static_cast<std::size_t>(i)] / 6.0;
      system(i, i) += 2.0 * f;
      system(j, j) += 2.0 * f;
      system(i, j) -= f;
      system(j, i) -= f;
      system(i, 4) = -1.0;
      system(4, i) = 1.0;
    }
    const Eigen::Matrix<double, 5, 1> found =
        system.fullPivLu().solve(Eigen::Matrix<double, 5, 1>::Unit(4));
    const double gamma = found[4];
    CHECK(of.frame_stiffness == Approx(1.0 / gamma).epsilon(1e-9));
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(of.corner_moments[i] == Approx(found[static_cast<int>(i)] / gamma).epsilon(1e-9));
  }
}

TEST_CASE("warping of unlike plates is no extension and no bending", "[distortion]") {
  const double b = 0.7, h = 0.9;
  const std::array t{0.02, 0.012, 0.006, 0.015};  // top, bottom, left, right
  const CellDistortion of = distortion_of(cell_of(b, h, t));
  // By a sum over many fibres of each plate.
  const std::array<std::array<double, 2>, 4> at{
      {{0.5 * b, 0.5 * h}, {0.5 * b, -0.5 * h}, {-0.5 * b, -0.5 * h}, {-0.5 * b, 0.5 * h}}};
  const std::array walls{t[2], t[1], t[3], t[0]};
  double area = 0.0, by_1 = 0.0, by_y = 0.0, by_z = 0.0, squared = 0.0;
  constexpr int fibres = 2000;
  for (std::size_t p = 0; p < 4; ++p) {
    const std::size_t q = (p + 1) % 4;
    const double length = p % 2 == 0 ? h : b;
    for (int i = 0; i < fibres; ++i) {
      const double x = (i + 0.5) / fibres, dA = length * walls[p] / fibres;
      const double w = std::lerp(of.warping[p], of.warping[q], x);
      area += dA;
      by_1 += w * dA;
      by_y += w * std::lerp(at[p][0], at[q][0], x) * dA;
      by_z += w * std::lerp(at[p][1], at[q][1], x) * dA;
      squared += w * w * dA;
    }
  }
  const double scale = area * b * h;
  CHECK(std::abs(by_1) < 1e-6 * scale);
  CHECK(std::abs(by_y) < 1e-6 * scale * b);
  CHECK(std::abs(by_z) < 1e-6 * scale * h);
  CHECK(squared == Approx(of.warping_inertia).epsilon(1e-5));
  // The mixed second difference of y z, by which the plates bend in their planes.
  CHECK(of.warping[0] - of.warping[1] + of.warping[2] - of.warping[3] == Approx(b * h));
}

TEST_CASE("a long beam distorts as the infinite one on an elastic foundation", "[distortion]") {
  // Hetenyi, Beams on Elastic Foundation (1946), chapter II.
  const double d = 30e3, far = 12.0 / lambda;
  const DistortedBeam beam = shearless(plates, {0.0, far, 2.0 * far});
  const Distortion of = under(beam, far, d);
  double worst_angle = 0.0, worst_moment = 0.0;
  for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
    const double x = lambda * std::abs(beam.nodes[i] - far), decayed = std::exp(-x);
    const double angle = d * lambda / (2.0 * k) * decayed * (std::cos(x) + std::sin(x));
    const double moment = d / (4.0 * lambda) * decayed * (std::cos(x) - std::sin(x));
    worst_angle = std::max(worst_angle, std::abs(of.angle[i] - angle));
    worst_moment = std::max(worst_moment, std::abs(of.moment[i] - moment));
  }
  CHECK(worst_angle < 1e-4 * d * lambda / (2.0 * k));
  CHECK(worst_moment < 1e-4 * d / (4.0 * lambda));
}

TEST_CASE("shear makes the infinite beam softer by the closed form", "[distortion]") {
  // By Fourier's transform of (M'' - k/S M)'' + k/(E I) M = -d'', with a = k/(2 S) and
  // c = sqrt(k/(E I)): M = d/(2 sqrt(2 (a + c))), gamma = d/(2 k) (2 a + c)/sqrt(2 (a + c)).
  const double d = 1e4, far = 14.0 / lambda, c = std::sqrt(k / EI);
  for (const double softer : {1.0, 20.0}) {
    DistortedBeam beam = uniform(plates, {0.0, far, 2.0 * far});
    for (auto& at : beam.shear_stiffness) at.fill(at[0] / softer);
    const double a = 0.5 * k * softer / cell.shear_stiffness;
    const Distortion of = under(beam, far, d);
    const auto at = beam.nearest(far);
    CHECK(of.moment[at] == Approx(d / (2.0 * std::sqrt(2.0 * (a + c)))).epsilon(2e-4));
    CHECK(of.angle[at] ==
          Approx(d / (2.0 * k) * (2.0 * a + c) / std::sqrt(2.0 * (a + c))).epsilon(2e-4));
  }
}

TEST_CASE("a load at a free end distorts four times as much", "[distortion]") {
  // Hetenyi: gamma = 2 d lambda/k; M = -d/lambda e^-x sin x, largest at x = pi/4.
  const double d = 1e4, at = 0.25 * std::numbers::pi / lambda;
  const DistortedBeam beam = shearless(plates, {0.0, at, 12.0 / lambda});
  const Distortion of = under(beam, 0.0, d);
  CHECK(of.angle.front() == Approx(2.0 * d * lambda / k).epsilon(1e-4));
  CHECK(of.moment[beam.nearest(at)] ==
        Approx(-d / lambda * std::exp(-0.25 * std::numbers::pi) * std::numbers::sqrt2 / 2.0)
            .epsilon(1e-4));
  CHECK(std::abs(of.moment.front()) < 1e-9 * d / lambda);
}

TEST_CASE("between near rigid diaphragms plates bend as beams between supports", "[distortion]") {
  const double d = 1e4, span = 0.05 / lambda;
  DistortedBeam beam = shearless(plates, {0.0, 0.5 * span, span});
  beam.diaphragms.front() = beam.diaphragms.back() = rigid;
  const auto middle = beam.nearest(0.5 * span);
  const Distortion simple = under(beam, 0.5 * span, d);
  CHECK(simple.moment[middle] == Approx(0.25 * d * span).epsilon(1e-5));
  CHECK(simple.held.front() == Approx(0.5 * d).epsilon(1e-5));
  CHECK(simple.angle[middle] == Approx(d * span * span * span / (48.0 * EI)).epsilon(1e-5));
  beam.start_held = beam.end_held = true;
  const Distortion held = under(beam, 0.5 * span, d);
  CHECK(held.moment[middle] == Approx(0.125 * d * span).epsilon(1e-5));
  CHECK(held.moment.front() == Approx(-0.125 * d * span).epsilon(1e-5));
  CHECK(held.angle[middle] == Approx(d * span * span * span / (192.0 * EI)).epsilon(1e-5));
}

TEST_CASE("an elastic diaphragm shares a load with the beam by their stiffness", "[distortion]") {
  // The infinite beam resists a place with 2 k/lambda.
  const double d = 1e4, far = 12.0 / lambda, K = 3.0 * k / lambda;
  DistortedBeam beam = shearless(plates, {0.0, far, 2.0 * far});
  const auto at = beam.nearest(far);
  beam.diaphragms[at] = K;
  const Distortion of = under(beam, far, d);
  CHECK(of.angle[at] == Approx(d / (K + 2.0 * k / lambda)).epsilon(1e-4));
  CHECK(of.held[at] == Approx(0.6 * d).epsilon(1e-4));
  CHECK(of.moment[at] == Approx(0.4 * d / (4.0 * lambda)).epsilon(2e-4));
}

TEST_CASE("an even load racks the cell evenly and does not warp it", "[distortion]") {
  const DistortedBeam beam = uniform(plates, {0.0, 5.0});
  const std::size_t elements = beam.nodes.size() - 1;
  const Distortion of = DistortionSolver(beam).solve(
      std::vector<double>(elements + 1, 0.0),
      std::vector<DistortedBeam::AtGauss>(elements, {700.0, 700.0, 700.0, 700.0}));
  for (std::size_t i = 0; i <= elements; ++i) {
    CHECK(of.angle[i] == Approx(700.0 / k).epsilon(1e-9));
    CHECK(std::abs(of.moment[i]) < 1e-9 * 700.0 / (lambda * lambda));
  }
}

TEST_CASE("a tapered box distorts as by finite differences", "[distortion]") {
  // The least of 1/2 (k gamma^2 + E I_w/4 ((A theta)'/A)^2 + S (gamma' - theta)^2) - d gamma,
  // A = b h: gamma at the ends of n steps, zero at both ends of the beam, theta in their middles.
  // A torque acts all along, too: d = T/2 (h'/h - b'/b) per length.
  const double d = 2e4, torque = 3e4, load_at = 3.0;
  constexpr Eigen::Index n = 800;
  const double step = taper_length / n;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n + 1, 2 * n + 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n + 1);
  const auto area = [](double s) {
    return tapered_cell(s).width.value() * tapered_cell(s).height.value();
  };
  const auto add = [&](double stiffness, const std::vector<std::pair<Eigen::Index, double>>& of) {
    for (const auto& [i, a] : of)
      for (const auto& [j, b] : of) system(i, j) += step * stiffness * a * b;
  };
  for (Eigen::Index i = 1; i < n; ++i) {
    const double s = static_cast<double>(i) * step;
    const BoxCell at = tapered_cell(s);
    const CellDistortion of = distortion_of(at);
    const double A = area(s) * step;
    add(of.frame_stiffness, {{i, 1.0}});
    add(0.25 * E * of.warping_inertia,
        {{n + i, -area(s - 0.5 * step) / A}, {n + i + 1, area(s + 0.5 * step) / A}});
    const double b_slope = -0.2 / taper_length, h_slope = -0.7 / taper_length;
    load[i] = step * 0.5 * torque * (h_slope / at.height.value() - b_slope / at.width.value());
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = (static_cast<double>(i) + 0.5) * step;
    add(tapered_at(s).shear_stiffness, {{i, -1.0 / step}, {i + 1, 1.0 / step}, {n + i + 1, -1.0}});
  }
  load[std::lround(load_at / step)] += d;
  system(0, 0) = system(n, n) = 1e30;
  const Eigen::VectorXd found = system.ldlt().solve(load);
  const auto moment_at = [&](double s) {
    const Eigen::Index i = std::lround(s / step);
    return -0.25 * E * tapered_at(s).warping_inertia / (area(s) * step) *
           (area(s + 0.5 * step) * found[n + i + 1] - area(s - 0.5 * step) * found[n + i]);
  };

  DistortedBeam beam = tapered({0.0, 1.0, load_at, 5.0, taper_length});
  beam.diaphragms.front() = beam.diaphragms.back() = rigid;
  std::vector<double> loads(beam.nodes.size(), 0.0);
  loads[beam.nearest(load_at)] = d;
  std::vector<DistortedBeam::AtGauss> lines = beam.of_torque;
  for (auto& at : lines)
    for (double& line : at) line *= torque;
  const Distortion of = DistortionSolver(beam).solve(loads, lines);
  for (const double s : {1.0, load_at, 5.0}) {
    CHECK(of.angle[beam.nearest(s)] == Approx(found[std::lround(s / step)]).epsilon(5e-4));
    CHECK(of.moment[beam.nearest(s)] ==
          Approx(moment_at(s)).margin(1e-3 * std::abs(moment_at(load_at))));
  }
}

TEST_CASE("what distorts a beam is in balance with its cell and its diaphragms", "[distortion]") {
  DistortedBeam beam = tapered({0.0, 1.5, 2.5, 6.0, taper_length}, 0.01);
  const std::size_t stiff = beam.nearest(1.5), soft = beam.nearest(6.0);
  beam.diaphragms[stiff] = rigid;
  beam.diaphragms[soft] = 2e6;
  beam.end_held = true;
  const Distortion of = under(beam, 2.5, 1e4);
  double by_cell = 0.0;  // k gamma by the rule of trapezia
  for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e) {
    const double from = beam.nodes[e], to = beam.nodes[e + 1];
    by_cell += 0.5 * (to - from) *
               (tapered_at(from).frame_stiffness * of.angle[e] +
                tapered_at(to).frame_stiffness * of.angle[e + 1]);
  }
  const double held = std::accumulate(of.held.begin(), of.held.end(), 0.0);
  CHECK(by_cell + held == Approx(1e4).epsilon(1e-4));
  CHECK(of.held[soft] == Approx(2e6 * of.angle[soft]));
  CHECK(std::abs(of.held[stiff]) > 1e3);
  CHECK(of.angle[stiff] == 0.0);
  CHECK(of.angle.back() == 0.0);
}

TEST_CASE("distortion is reciprocal, linear, and mirrors with the beam", "[distortion]") {
  const std::vector<double> places{0.0, 1.0, 2.5, 6.0, taper_length};
  DistortedBeam beam = tapered(places);
  beam.diaphragms[beam.nearest(2.5)] = 5e5;
  const double at_6 = under(beam, 1.0, 1.0).angle[beam.nearest(6.0)];
  CHECK(under(beam, 6.0, 1.0).angle[beam.nearest(1.0)] == Approx(at_6).epsilon(1e-9));

  const DistortionSolver solver(beam);
  std::vector<double> both(beam.nodes.size(), 0.0);
  both[beam.nearest(1.0)] = 2.0;
  both[beam.nearest(6.0)] = -3.0;
  const Distortion together = solver.solve(both), one = under(beam, 1.0, 1.0),
                   other = under(beam, 6.0, 1.0);
  DistortedBeam turned = distorted_beam(
      {0.0, 2.0, 5.5, 7.0, taper_length}, [](double s) { return tapered_cell(taper_length - s); },
      E, nu);
  turned.diaphragms[turned.nearest(5.5)] = 5e5;
  const Distortion mirrored = under(turned, 7.0, 1.0);
  const double angles = one.angle[beam.nearest(1.0)], moments = one.moment[beam.nearest(1.0)];
  REQUIRE(turned.nodes.size() == beam.nodes.size());
  for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
    CHECK(together.angle[i] ==
          Approx(2.0 * one.angle[i] - 3.0 * other.angle[i]).margin(1e-9 * angles));
    CHECK(together.moment[i] ==
          Approx(2.0 * one.moment[i] - 3.0 * other.moment[i]).margin(1e-9 * moments));
    const std::size_t there = beam.nodes.size() - 1 - i;
    CHECK(mirrored.angle[there] == Approx(one.angle[i]).margin(1e-9 * angles));
    CHECK(mirrored.moment[there] == Approx(one.moment[i]).margin(1e-9 * moments));
  }
}

TEST_CASE("finer elements converge by the second order, without shear by the fourth",
          "[distortion]") {
  enum class Kind { shearless, uniform, tapered };
  const auto error = [](Kind kind, double part) {
    const auto moment = [&](double of) {
      const std::vector<double> places{0.0, 3.0, taper_length};
      DistortedBeam beam =
          kind == Kind::tapered ? tapered(places, of) : uniform(plates, places, of);
      if (kind == Kind::shearless)
        for (auto& at : beam.shear_stiffness) at.fill(1e6 * at[0]);
      return under(beam, 3.0, 1.0).moment[beam.nearest(3.0)];
    };
    return std::abs(moment(part) / moment(0.01) - 1.0);
  };
  CHECK(error(Kind::shearless, 0.5) / error(Kind::shearless, 0.25) > 12.0);
  for (const Kind kind : {Kind::uniform, Kind::tapered}) {
    CHECK(error(kind, 0.125) / error(kind, 0.0625) > 3.0);
    CHECK(error(kind, 0.0625) < 2e-4);
  }
}

TEST_CASE("stresses of distortion are those of the corners", "[distortion]") {
  // M_D of the infinite beam, and m = gamma k/4 of equal plates: 6 m/t^2 in the web.
  const double P = 100e3, b = 0.6, h = 1.212;
  const BoxCell box = equal_cell(b, h, 0.012, 0.008);
  const CellDistortion of = distortion_of(box);
  const double far = 12.0 / of.decay;
  const DistortedBeam beam = shearless(box, {0.0, far, 2.0 * far});
  // Forces P up in the left web and down in the right one: T_w = P b, d = P b/2.
  const Distortion under_P = under(beam, far, 0.5 * P * b);
  const auto at = beam.nearest(far);
  const double I_D = h * h * (b * 0.012 + h * 0.008) / 12.0, per_web = P / (4.0 * of.decay);
  const double k_web = 8.0 * of.frame_stiffness / (b * b);  // of a web's deflection b gamma/4
  const double v = P * of.decay / (2.0 * k_web);
  for (const CellCorner corner : corners) {
    const bool pressed = corner == CellCorner::top_left || corner == CellCorner::bottom_right;
    // The left web bends downwards at its ends, as a beam under a force upwards.
    CHECK(under_P.warping_stress(at, of, corner) ==
          Approx((pressed ? 1.0 : -1.0) * per_web * h / (2.0 * I_D)).epsilon(1e-4));
    CHECK(under_P.frame_stress(at, of, box, corner) ==
          Approx(6.0 * (4.0 * v / b * of.frame_stiffness / 4.0) / (0.008 * 0.008)).epsilon(1e-4));
  }
}

TEST_CASE("a box of 600 x 1212 under two web forces of 100 kN", "[distortion][regression]") {
  // No published figures; those of a hand calculation of the same formulas, to its digits.
  const BoxCell box = equal_cell(0.6, 1.212, 0.012, 0.008);
  const CellDistortion of = distortion_of(box);
  CHECK(1.0 / of.decay == Approx(4.631).epsilon(2e-3));
  const double far = 12.0 / of.decay;
  const DistortedBeam beam = shearless(box, {0.0, far, 2.0 * far});
  const Distortion found = under(beam, far, 30e3);
  const auto at = beam.nearest(far);
  CHECK(found.warping_stress(at, of, CellCorner::top_left) == Approx(33.9e6).epsilon(5e-3));
  CHECK(found.frame_stress(at, of, box, CellCorner::top_left) == Approx(76e6).epsilon(5e-3));
  CHECK(1.0 / distortion_of(equal_cell(1.0, 1.0, 0.01, 0.01)).decay == Approx(5.248).epsilon(2e-3));
}

TEST_CASE("cells are the mid-lines of boxes and tubes", "[distortion]") {
  const Box box{si<Length>(0.66),  si<Length>(1.224), si<Length>(0.010),
                si<Length>(0.014), si<Length>(0.008), si<Length>(0.012)};
  const auto of_box = box_cell_of(box);
  REQUIRE(of_box);
  CHECK(of_box->width.value() == Approx(0.65));
  CHECK(of_box->height.value() == Approx(1.212));
  CHECK(of_box->thickness[static_cast<std::size_t>(BoxPlate::right_web)].value() == 0.012);
  const auto of_tube =
      box_cell_of(RectangularTube{si<Length>(0.2), si<Length>(0.3), si<Length>(0.008)});
  REQUIRE(of_tube);
  CHECK(of_tube->height.value() == Approx(0.292));
  CHECK_FALSE(box_cell_of(RoundTube{si<Length>(0.2), si<Length>(0.01)}));
  CHECK_FALSE(box_cell_of(Plate{si<Length>(0.02), si<Length>(0.1)}));
}

TEST_CASE("a diaphragm is a plate in shear, with an opening the frame around it", "[distortion]") {
  const BoxCell of = equal_cell(0.6, 1.2, 0.012, 0.008);
  const double t = 0.01, G = E / (2.0 * (1.0 + nu));
  const auto stiffness = [&](double opening) {
    return diaphragm_stiffness(of, si<Length>(t), si<Length>(opening), E, nu);
  };
  CHECK(stiffness(0.0) == Approx(G * t * 0.6 * 1.2));
  CHECK(stiffness(0.6) == 0.0);
  double before = stiffness(0.0);
  for (const double opening : {0.05, 0.2, 0.4, 0.5, 0.58}) {
    const double with_it = stiffness(opening);
    CHECK(with_it < before);
    before = with_it;
  }
  // Narrow strips bend as bars from corner to corner: k of a cell of such plates.
  const double c = 0.01, bar = E * t * c * c * c / 12.0;
  const BoxCell square = equal_cell(1.0, 1.0, 0.012, 0.008);
  CHECK(diaphragm_stiffness(square, si<Length>(t), si<Length>(1.0 - 2.0 * c), E, nu) ==
        Approx(24.0 / (2.0 * (1.0 - c) / bar)).epsilon(1e-3));
}

TEST_CASE("the shear flow of distortion balances its edges and turns webs against flanges",
          "[distortion]") {
  // Of any four thicknesses: no force, no torque, (T_w - T_f)/2 = Q; along each plate the flow
  // changes as the stress along it asks, q' = -t sigma', sigma' = 2 omega/I_w of Q = 1.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> size(0.2, 1.5), wall(0.005, 0.03);
  for (int trial = 0; trial < 50; ++trial) {
    const double b = size(random), h = size(random);
    const BoxCell cell = cell_of(b, h, {wall(random), wall(random), wall(random), wall(random)});
    const CellDistortion of = distortion_of(cell);
    double torque_webs = 0.0, torque_flanges = 0.0;
    std::array<double, 4> force{};
    double largest = 0.0;
    for (std::size_t plate = 0; plate < 4; ++plate) {
      const bool web = plate % 2 == 0;
      const double L = web ? h : b;
      const auto flow = [&](double part) { return distortion_at(cell, of, {plate, part}).flow; };
      // Simpson's rule is exact for a parabola.
      force[plate] = L / 6.0 * (flow(0.0) + 4.0 * flow(0.5) + flow(1.0));
      (web ? torque_webs : torque_flanges) += force[plate] * 0.5 * (web ? b : h);
      largest = std::max(largest, std::abs(force[plate]));
      CHECK(distortion_at(cell, of, {(plate + 1) % 4, 0.0}).flow ==
            Approx(flow(1.0)).margin(1e-9 / (b * h)));
      const DistortionInfluence at = distortion_at(cell, of, {plate, 0.25});
      const double slope = (flow(0.26) - flow(0.24)) / (0.02 * L);
      CHECK(slope == Approx(-at.thickness.value() * at.along).epsilon(1e-6));
    }
    CHECK(force[0] == Approx(force[2]).margin(1e-9 * largest));
    CHECK(force[1] == Approx(force[3]).margin(1e-9 * largest));
    CHECK(torque_webs == Approx(-torque_flanges));
    CHECK(std::abs(torque_webs - torque_flanges) / 2.0 == Approx(1.0));
  }
}

TEST_CASE("places of a box lie on its plates and in its corners", "[distortion]") {
  const Box box{si<Length>(0.66),  si<Length>(1.224), si<Length>(0.010),
                si<Length>(0.014), si<Length>(0.008), si<Length>(0.012)};
  const auto at = [&](double y, double z) {
    return places_in_cell(box, si<Length>(y), si<Length>(z));
  };
  CHECK(at(0.0, 0.0).empty());
  REQUIRE(at(0.33, 0.602 - 0.006 - 0.303).size() == 1);
  // From the middle of the top flange down the left web: 1212 mm between the flanges' middles.
  CHECK(at(0.33, 0.612 - 0.005 - 0.303).front().plate == 0);
  CHECK(at(0.33, 0.612 - 0.005 - 0.303).front().part == Approx(0.25));
  CHECK(at(-0.33, -0.612 + 0.007 + 0.303).front().plate == 2);
  CHECK(at(-0.33, -0.612 + 0.007 + 0.303).front().part == Approx(0.25));
  CHECK(at(0.33 - 0.004 - 0.1625, -0.612).front().plate == 1);
  CHECK(at(0.33 - 0.004 - 0.1625, -0.612).front().part == Approx(0.25));
  CHECK(at(-0.33 + 0.006 + 0.1625, 0.612).front().plate == 3);
  CHECK(at(-0.33 + 0.006 + 0.1625, 0.612).front().part == Approx(0.25));
  for (const double y : {0.33, -0.33}) {
    for (const double z : {0.612, -0.612}) {
      const std::vector<CellPlace> corner = at(y, z);
      REQUIRE(corner.size() == 2);
      CHECK(corner[0].part == 0.0);
      CHECK(corner[1].part == 1.0);
      const auto i = static_cast<std::size_t>(
          y > 0.0 ? (z > 0.0 ? CellCorner::top_left : CellCorner::bottom_left)
                  : (z > 0.0 ? CellCorner::top_right : CellCorner::bottom_right));
      CHECK(corner[0].plate == i);
      CHECK((corner[1].plate + 1) % 4 == i);
    }
  }
  const RectangularTube tube{si<Length>(0.2), si<Length>(0.2), si<Length>(0.005), si<Length>(0.03),
                             si<Length>(0.025)};
  CHECK(places_in_cell(tube, si<Length>(0.0975), si<Length>(0.08)).size() == 2);
  CHECK(places_in_cell(tube, si<Length>(0.0975), si<Length>(0.06)).size() == 1);
  CHECK(places_in_cell(RoundTube{si<Length>(0.2), si<Length>(0.01)}, si<Length>(0.1), {}).empty());
}

TEST_CASE("a plate is bent across most in its corners", "[distortion]") {
  const BoxCell box = equal_cell(0.6, 1.2, 0.012, 0.008);
  const CellDistortion of = distortion_of(box);
  // Racked alike at both ends, the middle of a plate is not bent.
  const double corner = of.frame_stiffness / 4.0;
  for (std::size_t plate = 0; plate < 4; ++plate) {
    const double t = plate % 2 == 0 ? 0.008 : 0.012;
    const DistortionInfluence end = distortion_at(box, of, {plate, 0.0});
    CHECK(end.moment == Approx(corner));
    CHECK(end.across == Approx(6.0 * corner / (t * t)));
    CHECK(distortion_at(box, of, {plate, 0.25}).moment == Approx(0.5 * corner));
    CHECK(distortion_at(box, of, {plate, 0.5}).moment == Approx(0.0).margin(1e-9 * corner));
    const DistortionInfluence throat = end.in_throat(si<Length>(0.004));
    CHECK(throat.across == Approx(6.0 * corner / (0.004 * 0.004)));
    CHECK(throat.shear == Approx(end.flow / 0.004));
    CHECK(throat.along == 0.0);
  }
}

}  // namespace box_distortion_test
