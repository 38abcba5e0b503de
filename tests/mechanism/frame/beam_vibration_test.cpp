// Free vibrations of a beam among rigid bodies, against closed forms of bars and beams.

#include "boxbeam/mechanism/frame/beam_vibration.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"

namespace beam_vibration_test {

using namespace boxbeam;
using Eigen::Vector3d;

namespace {

constexpr double E = 2.1e11, G = 8.1e10, rho = 7850.0, L = 6.0, pi = std::numbers::pi;
constexpr double rigid_in_shear = 1e15;

Section box_of(double width, double height, double plate) {
  return {symmetric_box(width * metre, height * metre, plate * metre, plate * metre), {}};
}

TaperedBeam even(const Section& section) {
  TaperedBeam beam;
  beam.density = si<Density>(rho);
  beam.segments = {{"", Length{}, si<Length>(L), section, section}};
  return beam;
}

const Section box = box_of(0.12, 0.2, 0.006);

frame::Tie tie(int a, int b, const Vector3d& at, Eigen::Index way) {
  frame::Tie of;
  const frame::Vector6 per = frame::Vector6::Unit(way);
  of.ends = {{{a, at}, -per}, {{b, at}, per}};
  return of;
}

void hold(std::vector<frame::Tie>& ties, int a, int b, const Vector3d& at, Eigen::Index ways) {
  for (Eigen::Index way = 0; way < ways; ++way) ties.push_back(tie(a, b, at, way));
}

std::vector<frame::Tie> clamped() {
  std::vector<frame::Tie> ties;
  hold(ties, frame::ground, 0, Vector3d::Zero(), 6);
  return ties;
}

/// N along the beam, nothing else.
CutForceDiagram pulled(double N) {
  CutForcePiece piece;
  piece.length = si<Length>(L);
  piece.N.c[0] = N;
  return {{piece}};
}

/// Of one beam among bodies.
std::vector<frame::BeamMode> modes_of(const frame::VibratingBeam& beam,
                                      const std::vector<frame::RigidMass>& bodies,
                                      const std::vector<frame::Tie>& ties,
                                      const CutForceDiagram& rigid, std::size_t count) {
  return frame::modes_of({{{&beam, rigid}}, bodies, ties}, count);
}

/// Those of a kind of energy, in order [1/s].
std::vector<double> of_kind(const std::vector<frame::BeamMode>& modes, std::size_t kind) {
  std::vector<double> omegas;
  for (const frame::BeamMode& mode : modes)
    if (mode.energy[kind] > 0.5) omegas.push_back(2.0 * pi * mode.frequency);
  return omegas;
}

double root_of(const std::function<double(double)>& f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == (f(low) > 0.0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Of a cantilever by Euler and Bernoulli with a rigid mass m of rotary inertia J at its tip,
///
///     w = a (cos bx - cosh bx) + c (sin bx - sinh bx),  E I w'' = J omega^2 w',
///     E I w''' = -m omega^2 w,  omega^2 = E I b^4/(rho A)
///
/// zero where the determinant is.
double with_tip(double bL, double mass_ratio, double inertia_ratio) {
  const double c = std::cos(bL), s = std::sin(bL), C = std::cosh(bL), S = std::sinh(bL);
  // m/(rho A L), J/(rho A L^3).
  const double m = mass_ratio * bL, J = inertia_ratio * bL * bL * bL;
  Eigen::Matrix2d system;
  system << (-c - C) - J * (-s - S), (-s - S) - J * (c - C), (s - S) + m * (c - C),
      (-c - C) + m * (s - S);
  return system.determinant();
}

double first_with_tip(double mass_ratio, double inertia_ratio) {
  // Below the first of the bare cantilever nothing but the first is.
  return root_of([&](double bL) { return with_tip(bL, mass_ratio, inertia_ratio); }, 0.05, 1.8752);
}

}  // namespace

TEST_CASE("a cantilever vibrates in both planes, in torsion and along itself as closed forms say",
          "[frame][vibration]") {
  const SectionProperties of = properties_of(box);
  const double A = of.area.value(), I_y = of.I_y.value(), I_z = of.I_z.value();
  const double I_T = torsion_properties_of(box).I_T->value();
  const TaperedBeam beam = even(box);
  constexpr int parts = 24;
  // Torsion and stretching of elements of linear shape: high by (k h)^2/24.
  const auto high = [](double wave) { return 1.0 + wave * wave / (24.0 * parts * parts); };
  const frame::VibratingBeam slender(beam, E, rigid_in_shear, {}, parts);
  const auto modes = modes_of(slender, {}, clamped(), {}, 12);
  const double roots[] = {1.8751040687119612, 4.6940911329741746, 7.8547574382376126};
  const auto about_y = of_kind(modes, 1), about_z = of_kind(modes, 2), along = of_kind(modes, 0);
  REQUIRE(about_y.size() >= 3);
  REQUIRE(about_z.size() >= 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const double error = std::pow(roots[k] / parts, 4) / 1000.0 + 1e-7;
    CHECK(about_y[k] ==
          Approx(std::pow(roots[k] / L, 2) * std::sqrt(E * I_y / (rho * A))).epsilon(error));
    CHECK(about_z[k] ==
          Approx(std::pow(roots[k] / L, 2) * std::sqrt(E * I_z / (rho * A))).epsilon(error));
  }
  REQUIRE(!along.empty());
  CHECK(along[0] == Approx(high(pi / 2) * pi / 2 / L * std::sqrt(E / rho)).epsilon(1e-6));

  // Rotary inertia about the axis counts though the beam does not ask for it.
  const frame::VibratingBeam twisted(beam, E, G, {}, parts);
  const auto torsion = of_kind(modes_of(twisted, {}, clamped(), {}, 30), 3);
  REQUIRE(torsion.size() >= 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double wave = (2.0 * static_cast<double>(k) + 1.0) * pi / 2.0;
    CHECK(torsion[k] ==
          Approx(high(wave) * wave / L * std::sqrt(G * I_T / (rho * (I_y + I_z)))).epsilon(2e-5));
  }
}

TEST_CASE("a mass at the tip of a cantilever slows it as the closed form says",
          "[frame][vibration]") {
  const SectionProperties of = properties_of(box);
  const double A = of.area.value(), I_y = of.I_y.value(), bar = rho * A * L;
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, rigid_in_shear, {}, 12);
  for (const auto& [m, J] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {3.0, 0.0}, {1.0, 0.2}, {0.1, 2.0}}) {
    frame::RigidMass tip{m * bar, {L, 0.0, 0.0}, J * bar * L * L * Eigen::Matrix3d::Identity()};
    std::vector<frame::Tie> ties = clamped();
    hold(ties, 0, 1, {L, 0.0, 0.0}, 6);
    const auto found = of_kind(modes_of(vibrating, {tip}, ties, {}, 6), 1);
    REQUIRE(!found.empty());
    INFO("m " << m << ", J " << J);
    CHECK(found[0] == Approx(std::pow(first_with_tip(m, J) / L, 2) * std::sqrt(E * I_y / (rho * A)))
                          .epsilon(2e-6));
  }
}

// sin k = 0: omega^2 = (n pi/L)^4 E I/(rho A) + (n pi/L)^2 N/(rho A). Source: Timoshenko, Young,
// Weaver, Vibration Problems in Engineering (1974), section 5.12.
TEST_CASE("between two balls a beam has n half waves, faster where it is pulled",
          "[frame][vibration]") {
  const SectionProperties of = properties_of(box);
  const double A = of.area.value();
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, rigid_in_shear, {}, 24);
  std::vector<frame::Tie> ties;
  hold(ties, frame::ground, 0, Vector3d::Zero(), 3);
  ties.push_back(tie(frame::ground, 0, Vector3d::Zero(), 3));  // it would spin
  ties.push_back(tie(frame::ground, 0, {L, 0.0, 0.0}, 1));
  ties.push_back(tie(frame::ground, 0, {L, 0.0, 0.0}, 2));
  const double N_cr = pi * pi * E * of.I_z.value() / (L * L);
  for (const double part : {0.0, 0.7, -0.7}) {
    const auto modes = modes_of(vibrating, {}, ties, pulled(part * N_cr), 6);
    const auto about_z = of_kind(modes, 2);
    REQUIRE(about_z.size() >= 2);
    for (std::size_t n = 1; n <= 2; ++n) {
      const double k = static_cast<double>(n) * pi / L;
      const double square = (E * of.I_z.value() * std::pow(k, 4) + part * N_cr * k * k) / (rho * A);
      CHECK(about_z[n - 1] == Approx(std::sqrt(square)).epsilon(5e-6));
    }
  }
  // Beyond N_cr it does not stand.
  CHECK_THROWS_AS(modes_of(vibrating, {}, ties, pulled(-1.01 * N_cr), 6), AnalysisError);
  ties.erase(ties.begin() + 3);
  CHECK_THROWS_AS(modes_of(vibrating, {}, ties, {}, 6), AnalysisError);
}

// Between rollers Timoshenko's beam has sin waves, k = n pi/L:
//
//     rho A rho I w^4 - (rho A G A_s + k^2 (rho A E I + rho I G A_s)) w^2 + k^4 E I G A_s = 0
//
// w the lower root. Source: Timoshenko, Philosophical Magazine 41 (1921).
TEST_CASE("shear and rotary inertia slow a stout beam as Timoshenko's solution says",
          "[frame][vibration]") {
  const Section stout = box_of(0.4, 0.6, 0.02);
  const SectionProperties of = properties_of(stout);
  TaperedBeam beam = even(stout);
  beam.rotary_inertia = true;
  const frame::VibratingBeam vibrating(beam, E, G, {}, 32);
  std::vector<frame::Tie> ties;
  hold(ties, frame::ground, 0, Vector3d::Zero(), 4);
  ties.push_back(tie(frame::ground, 0, {L, 0.0, 0.0}, 1));
  ties.push_back(tie(frame::ground, 0, {L, 0.0, 0.0}, 2));
  const auto about_y = of_kind(modes_of(vibrating, {}, ties, {}, 6), 1);
  REQUIRE(!about_y.empty());
  const double a = rho * of.area.value(), i = rho * of.I_y.value(), EI = E * of.I_y.value(),
               GA = G * shear_areas_of(stout).z.value(), k = pi / L;
  const double p = a * GA + k * k * (a * EI + i * GA), q = std::pow(k, 4) * EI * GA;
  const double square = (p - std::sqrt(p * p - 4.0 * a * i * q)) / (2.0 * a * i);
  // The part of shear in its energy, a twentieth, times (k h)^2/24.
  CHECK(about_y[0] == Approx(std::sqrt(square)).epsilon(3e-5));
}

// Invariants: a mode is in balance with what holds it, and a free end cuts nothing.
TEST_CASE("the cut forces of a mode are those of its inertia", "[frame][vibration]") {
  const SectionProperties of = properties_of(box);
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, rigid_in_shear, {}, 16);
  for (const frame::BeamMode& mode : modes_of(vibrating, {}, clamped(), {}, 2)) {
    const CutForceDiagram& cut = mode.cut;
    const CutForces root = cut.at({Length{}, Side::behind}),
                    tip = cut.at({si<Length>(L), Side::before});
    const double moment = std::max(std::abs(root.M_y.value()), std::abs(root.M_z.value()));
    CHECK(std::abs(tip.M_y.value()) + std::abs(tip.M_z.value()) < 1e-8 * moment);
    CHECK(std::abs(tip.V_y.value()) + std::abs(tip.V_z.value()) < 1e-8 * moment);
    // By hand: E I w''(0) over omega^2 sqrt(rho A L) of the mode of mass one, whose tip moves by
    // 2/sqrt(rho A L): w''(0) = b^2 w(L) of the first mode.
    const double I = mode.energy[1] > 0.5 ? of.I_y.value() : of.I_z.value();
    const double b = 1.8751040687119612 / L;
    CHECK(moment ==
          Approx(E * I * b * b * 2.0 / std::sqrt(rho * of.area.value() * L)).epsilon(1e-5));
    // The work of the mode's own cut forces on its strains is twice its elastic energy, omega^2.
    double work = 0.0;
    Eigen::Index at = 0;
    for (const Station& station : vibrating.stations()) {
      const CutForces here = cut.at(station);
      for (const double value : {here.N.value(), here.V_y.value(), here.V_z.value(), here.T.value(),
                                 here.M_y.value(), here.M_z.value()})
        work += mode.work[at++] * value;
    }
    CHECK(work == Approx(std::pow(2.0 * pi * mode.frequency, 2)).epsilon(1e-6));
  }
}

TEST_CASE("bodies without number that are held stay out of a beam's vibration",
          "[frame][vibration]") {
  // A cantilever on the last of a row of bodies that are fixed to each other and to the ground is
  // one on the ground, whether its ties are few or many, and whichever of them repeat others.
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, G, {}, 8);
  const CutForceDiagram still = pulled(2e5);
  const auto expected = modes_of(vibrating, {}, clamped(), still, 5);
  for (const int count : {1, 30, 60, 400}) {
    for (const int times : {1, 2}) {
      INFO(count << " bodies held " << times << " times");
      std::vector<frame::RigidMass> bodies;
      std::vector<frame::Tie> ties;
      for (int b = 1; b <= count; ++b) {
        frame::RigidMass body;
        body.mass = 3.0 + b % 5;
        body.centre = {-0.2 * (count - b) - 0.1, 0.05 * (b % 3), -0.02 * (b % 7)};
        body.inertia = Vector3d(0.1, 0.2, 0.3).asDiagonal();
        bodies.push_back(body);
        for (int k = 0; k < times; ++k)
          hold(ties, b == 1 ? frame::ground : b - 1, b,
               {-0.2 * (count - b) - 0.2, 0.3 * k, 0.1 * k}, 6);
      }
      hold(ties, count, 0, Vector3d::Zero(), 6);
      const auto modes = modes_of(vibrating, bodies, ties, still, 5);
      REQUIRE(modes.size() == expected.size());
      for (std::size_t k = 0; k < modes.size(); ++k) {
        CHECK(modes[k].frequency == Approx(expected[k].frequency).epsilon(1e-8));
        CHECK(modes[k].own_mass == Approx(1.0).epsilon(1e-8));
        // What its end holds, by the one tie that does.
        const auto held = [&](const frame::BeamMode& mode) {
          frame::Vector6 sum = frame::Vector6::Zero();
          for (const PointLoad& load : mode.loads.points) {
            sum.head<3>() += load.force;
            sum.tail<3>() += load.moment;
          }
          return sum;
        };
        const frame::Vector6 one = held(modes[k]), other = held(expected[k]);
        CHECK(std::min((one - other).norm(), (one + other).norm()) < 1e-6 * other.norm());
      }
    }
  }
}

TEST_CASE("a hundred bodies on a beam's end count as their sum", "[frame][vibration]") {
  // Fixed to the free end in a row; whole, they are one body there. Kinetic energy of both is the
  // same in every motion.
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, G, {}, 8);
  const auto modes_with = [&](const std::vector<frame::RigidMass>& bodies, bool in_a_row) {
    std::vector<frame::Tie> ties = clamped();
    for (int b = 1; b <= static_cast<int>(bodies.size()); ++b)
      hold(ties, in_a_row && b > 1 ? b - 1 : 0, b, {L, 0.01 * b, 0.0}, 6);
    return modes_of(vibrating, bodies, ties, {}, 4);
  };
  std::vector<frame::RigidMass> bodies;
  frame::RigidMass sum;
  for (int b = 0; b < 100; ++b) {
    frame::RigidMass body;
    body.mass = 0.5 + 0.01 * b;
    body.centre = {L, 0.002 * b, -0.1 + 0.003 * b};
    body.inertia = Vector3d(0.01, 0.02, 0.015).asDiagonal();
    bodies.push_back(body);
    sum.mass += body.mass;
    sum.centre += body.mass * body.centre;
  }
  sum.centre /= sum.mass;
  for (const frame::RigidMass& body : bodies) {
    const Vector3d r = body.centre - sum.centre;  // Steiner
    sum.inertia += body.inertia +
                   body.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  const auto expected = modes_with({sum}, false), modes = modes_with(bodies, true);
  REQUIRE(modes.size() == expected.size());
  for (std::size_t k = 0; k < modes.size(); ++k) {
    CHECK(modes[k].frequency == Approx(expected[k].frequency).epsilon(1e-9));
    CHECK(modes[k].own_mass == Approx(expected[k].own_mass).epsilon(1e-7));
  }
}

// Independent computation: every posture eliminated by itself.
TEST_CASE("the order of ties that is kept from one posture to the next changes no mode",
          "[frame][vibration]") {
  // Bodies in a row on the free end of a beam, turned from posture to posture. Two rods hold the
  // last one: where both lie along z one repeats the other, elsewhere they hold it along y as well.
  const TaperedBeam beam = even(box);
  const frame::VibratingBeam vibrating(beam, E, G, {}, 8);
  const auto posture = [&](double turned, double apart, int count) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(turned, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
    frame::VibratingScene scene{{{&vibrating, {}}}, {}, clamped()};
    for (int b = 1; b <= count; ++b) {
      frame::RigidMass body;
      body.mass = 0.5 + 0.01 * b;
      body.centre = Vector3d(L, 0.0, 0.0) + R * Vector3d(0.01 * b, 0.002 * b, -0.1 + 0.003 * b);
      body.inertia = R * Vector3d(0.01, 0.02, 0.015).asDiagonal() * R.transpose();
      scene.bodies.push_back(body);
      std::vector<frame::Tie> ties;
      hold(ties, b - 1, b, Vector3d(L, 0.0, 0.0) + R * Vector3d(0.01 * b, 0.0, 0.0), 6);
      for (frame::Tie& of : ties) {
        for (frame::Tie::End& end : of.ends) {
          end.per.head<3>() = R * end.per.head<3>().eval();
          end.per.tail<3>() = R * end.per.tail<3>().eval();
        }
        scene.ties.push_back(of);
      }
    }
    for (const double angle : {0.0, apart}) {
      frame::Tie rod = tie(frame::ground, count, scene.bodies.back().centre, 2);
      for (frame::Tie::End& end : rod.ends) {
        const double sign = end.per[2];
        end.per.head<3>() = sign * Vector3d(0.0, std::sin(angle), std::cos(angle));
      }
      scene.ties.push_back(rod);
    }
    return scene;
  };
  frame::KeptTies last;
  double held_once = 0.0, held_twice = 0.0;
  for (const auto& [turned, apart] : {std::pair{0.0, 0.0},
                                      {0.3, 0.0},
                                      {0.6, 0.4},
                                      {0.9, 0.5},
                                      {1.2, 0.0},
                                      {0.0, 0.0},
                                      {2.5, 0.2}}) {
    CAPTURE(turned, apart);
    const frame::VibratingScene scene = posture(turned, apart, 60);
    const auto kept = frame::modes_of(frame::FactoredScene(scene, last), 5),
               anew = frame::modes_of(scene, 5);
    REQUIRE(kept.size() == anew.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
      CHECK(kept[k].frequency == Approx(anew[k].frequency).epsilon(1e-9));
      CHECK(kept[k].own_mass == Approx(anew[k].own_mass).epsilon(1e-7));
    }
    (apart == 0.0 ? held_once : held_twice) = kept.front().frequency;
    // Each mode satisfies each tie.
    for (const frame::BeamMode& mode : kept) {
      for (const frame::Tie& of : scene.ties) {
        double gap = 0.0;
        for (const frame::Tie::End& end : of.ends) {
          if (end.at.member <= 0) continue;
          const auto at = static_cast<Eigen::Index>(
              6 * (vibrating.nodes().size() + static_cast<std::size_t>(end.at.member) - 1));
          const Vector3d arm =
              end.at.p - scene.bodies[static_cast<std::size_t>(end.at.member) - 1].centre;
          const Vector3d turn = mode.motion.segment<3>(at + 3);
          gap += end.per.head<3>().dot(mode.motion.segment<3>(at) + turn.cross(arm)) +
                 end.per.tail<3>().dot(turn);
        }
        if (of.ends[0].at.member == 0 || of.ends[1].at.member == 0) continue;
        CHECK(std::abs(gap) < 1e-8 * mode.motion.cwiseAbs().maxCoeff());
      }
    }
  }
  CHECK(held_twice > 1.05 * held_once);
}

}  // namespace beam_vibration_test
