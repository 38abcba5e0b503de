// Vibration of the beam in motions in space that do not repeat, against the plane, the sum of modes
// by Duhamel's integral, an oscillator of one freedom, integration over time, the motion that
// repeats, and what must hold in every motion.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "boxbeam/verification/unseen_time.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/slender_beam.hpp"
#include "support/space_arm.hpp"
#include "support/swung_arm.hpp"

namespace elastic_start_in_space_test {

using namespace boxbeam;
using namespace test::space_arm;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double pi = std::numbers::pi, E = 210e9;

std::string lasting(const std::string& text, double seconds) {
  return text + fmt::format("[motion]\nduration = \"{:.15g} s\"\n", seconds);
}

std::string polynomial(const std::vector<double>& c) {
  std::string text;
  const char* const per[] = {"rad", "rad/s", "rad/s^2", "rad/s^3", "rad/s^4"};
  for (std::size_t i = 0; i < c.size(); ++i)
    text += fmt::format("{}\"{:.17g} {}\"", i == 0 ? "" : ", ", c[i], per[i]);
  return "kind = \"polynomial\"\ncoefficients = [" + text + "]\n";
}

/// Duhamel's integral of an oscillator from rest, omega^2 int a(t - u) (h + tau h') du, with
/// h(u) = e^(-zeta omega u) sin(omega' u)/omega', zeta = omega tau/2: what elasticity and viscosity
/// bear together of a(t); by Simpson's rule with 64 points to a period and ends where a begins and
/// ends. Source: Clough, Penzien, Dynamics of Structures (1993), chapter 6.
double borne(const std::function<double(double)>& a, double end, double t, double omega,
             double tau = 0.0) {
  const double zeta = 0.5 * omega * tau, own = omega * std::sqrt(1.0 - zeta * zeta);
  const double until = std::min(t, end);
  const int n = 2 * static_cast<int>(std::ceil(32.0 * own * until / (2.0 * pi) + 200.0));
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double at = until * i / n, u = t - at, sine = std::sin(own * u) / own;
    const double weight = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * a(at) * std::exp(-zeta * omega * u) *
           (sine + tau * (std::cos(own * u) - zeta * omega * sine));
  }
  return omega * omega * sum * until / n / 3.0;
}

}  // namespace

// The same beam as a chain of rigid finite elements of the plane and by its pieces in space, in
// starts and stops whose turning counts, with the free vibration behind them.
TEST_CASE("starts and stops of the plane written in space vibrate as the plane's",
          "[elastic_start]") {
  using namespace test::slender;
  const double T = 3.0, w = 0.12;
  struct Once {
    const char* name;
    Driver driver;
  };
  // There and half back between two rests; from a steady rate softly to rest; accelerations at
  // once, at rest and at the end.
  const std::vector<Once> all = {
      {"table", TableDriver{TableCurve({0.0, 0.4 * T, T}, {0.0, 0.2, 0.1}, Interpolation::cubic,
                                       Beyond::hold)}},
      {"stop", PolynomialDriver{{0.0, w, 0.0, -w / (T * T), 0.5 * w / (T * T * T)}}},
      {"at once", PolynomialDriver{{0.0, 0.0, 0.04}}},
      {"brake", PolynomialDriver{{0.0, w, -0.5 * w / T}}}};
  for (const Once& once : all) {
    test::slender::Beam plane = tapered_and_turned(once.driver, T);
    plane.solve(32);
    ElasticBody elastic = plane.elastic();
    elastic.parts = 384;
    const ElasticMotion vibrating(plane.rigid(), elastic, 2);
    const LoadsAt bent = bent_statically(plane.rigid(), elastic);
    Project project = parse_project(
        "arm.toml", lasting(slender({0.0, -1.0, 0.0}, stepping(0.1, T), 60, 50, 81.0), T));
    std::get<spatial::Mechanism>(project.mechanism).joints.front().driver = once.driver;
    const Moved of(std::move(project));
    // Two of them in the plane.
    const ElasticMotionInSpace coarse = of.by(4, 32, 32), fine = of.by(4, 64, 32);
    REQUIRE(vibrating.transient() != nullptr);
    REQUIRE(fine.transient() != nullptr);
    // In space at least as long: there is a slower mode across the plane.
    const double last = vibrating.transient()->times().back();
    CHECK(fine.transient()->times().back() > 0.999 * last);
    double largest = 0.0;  // at the root
    for (const double s : {0.0, 4.0, 9.0}) {
      const auto expected = [&](Time time) -> Cuts {
        return cuts_of(vibrating.loads_at(time), s) - cuts_of(bent(time), s);
      };
      const PlaneApart found(of, coarse, fine, s, 60, expected,
                             [&](int i) { return si<Time>(last * (i + 0.5) / 60.0 * 0.999); });
      INFO(once.name << ", s = " << s << ": " << found.apart / found.rigid << ", of what vibrates "
                     << found.apart / found.vibrating << ", which is "
                     << found.vibrating / found.rigid);
      largest = std::max(largest, found.rigid);
      CHECK(found.vibrating > 0.01 * found.rigid);
      CHECK(found.apart < 1e-6 * largest);
      CHECK(found.apart < 3e-6 * found.rigid);
      // In the plane of the others nothing moves it.
      CHECK(found.across < 1e-9 * found.rigid);
    }
  }
}

// Invariants: the scene turned as a whole, loads in balance at any time.
TEST_CASE("however a scene lies in the world its beam starts alike", "[elastic_start]") {
  const std::string once = stepping(0.9, 0.8);
  const Moved straight(arm(slewing("", once) + beside, steel)),
      turned(arm(slewing("turn = [[\"x\", \"70 deg\"], [\"z\", \"-130 deg\"], [\"y\", \"15 deg\"]]",
                         once) +
                     beside,
                 steel));
  const ElasticMotionInSpace one = straight.by(4, 8), other = turned.by(4, 8);
  REQUIRE(one.transient() != nullptr);
  const double last = one.transient()->times().back();
  CHECK(last > 0.8 + 2.9 / one.lowest_frequency());
  for (const double part : {0.05, 0.21, 0.4, 0.55, 0.83, 0.99}) {
    const Time time = si<Time>(part * last);
    CHECK(imbalance(one.loads_at(time), 4.0) < 1e-9);
    for (const double s : {0.0, 1.3, 3.1}) {
      const Cuts expected = cuts_of(one.loads_at(time), s),
                 rigid = cuts_of(straight.rigid().loads_at(time), s);
      check_alike(cuts_of(other.loads_at(time), s), expected, expected, 1e-7);
      CHECK((expected - rigid).norm() > 1e-3 * expected.norm());
    }
  }
}

// Euler and Bernoulli, in both planes of the beam at once: mode j of a cantilever whose root turns
// bears at its root, per angular acceleration, a part of the rigid moment rho A L^3/3,
//
//     3 (int x phi dx)^2/(L^3 int phi^2 dx) = 12/b_j^4,  cos b cosh b = -1,
//
// for int x phi = 2 L^2/b^2 of phi'''' = (b/L)^4 phi; the parts add up to one.
TEST_CASE("a beam on a hinge about any axis starts as its modes say", "[elastic_start]") {
  const double L = test::slender::L, small = 1e-4;
  const Vector3d axis(0.0, 0.6, 0.8);
  double sum = 0.0;
  std::vector<double> roots;
  for (int j = 1; j <= 40; ++j) {
    double b = j == 1 ? 1.875104 : (j - 0.5) * pi;
    for (int i = 0; i < 20; ++i) {  // by Newton, over cosh b
      const double f = std::cos(b) + 1.0 / std::cosh(b);
      b -= f / (-std::sin(b) - std::tanh(b) / std::cosh(b));
    }
    roots.push_back(b);
    sum += 12.0 / std::pow(b, 4);
  }
  REQUIRE(sum == Approx(1.0).epsilon(1e-5));
  for (const double periods : {0.6, 2.3}) {
    for (const double tau : {0.0, 0.004}) {
      const double end = periods / test::slender::first_frequency();
      const StepDriver step{0.0, small, 0.0, end};
      const std::string model = tau > 0.0 ? fmt::format("damping = \"{} s\"\n", tau) : "";
      const Moved of(slender(axis, stepping(small, end), 80, 100, 1e6) + model);
      const ElasticMotionInSpace elastic = of.by(8, 16);
      const SectionProperties section = properties_of(of.project.beam.segments.front().from);
      const double mass = 7850.0 * section.area.value(), rigid = mass * std::pow(L, 3) / 3.0;
      const auto a = [&](double t) { return driver_at(step, t).acceleration; };
      const double size = rigid * small * 5.77 / (end * end);  // 10/sqrt(3), the step's largest
      const auto expected = [&](double I, double t) {
        double moment = 0.0, parts = 0.0;
        for (std::size_t j = 0; j < 8; ++j) {
          const double omega = std::pow(roots[j] / L, 2) * std::sqrt(E * I / mass);
          const double part = 12.0 / std::pow(roots[j], 4);
          if (0.5 * omega * tau >= 1.0) break;
          parts += part;
          moment += part * borne(a, end, t, omega, tau);
        }
        return rigid * (moment + (1.0 - parts) * (t < end ? a(t) : 0.0));
      };
      double most = 0.0;
      for (const double part : {0.07, 0.3, 0.5, 0.81, 0.97, 1.2, 1.5}) {
        const double time = part * end;
        if (time > elastic.transient()->times().back()) continue;
        const Cuts found = cuts_of(elastic.loads_at(si<Time>(time)), 0.0),
                   stiff = cuts_of(of.rigid().loads_at(si<Time>(0.25 * end)), 0.0);
        INFO("periods " << periods << ", tau " << tau << ", part " << part);
        const double about_y = stiff[4] / (rigid * a(0.25 * end)),
                     about_z = stiff[5] / (rigid * a(0.25 * end));
        REQUIRE(std::abs(about_y) == Approx(0.6).epsilon(1e-4));
        REQUIRE(std::abs(about_z) == Approx(0.8).epsilon(1e-4));
        CHECK(found[4] ==
              Approx(about_y * expected(section.I_y.value(), time)).margin(1e-3 * size));
        CHECK(found[5] ==
              Approx(about_z * expected(section.I_z.value(), time)).margin(1e-3 * size));
        if (time > end) most = std::max(most, found.tail<3>().norm());
      }
      if (tau == 0.0) CHECK(most > 0.02 * size);
    }
  }
}

// A point mass beside the tip of an arm without mass whose base is lifted once: one freedom of
// flexibility L^3/(3 E I) + L/(G A_s) + e^2 L/(G I_T).
TEST_CASE("an eccentric mass that is lifted twists an arm as an oscillator", "[elastic_start]") {
  const double L = 4.0, e = 0.7, m = 150.0;
  const auto text = [&](double end) {
    return arm(on_rail(stepping(1e-3, end, "m")) +
                   with_load(m, fmt::format("centre = [\"0 m\", \"{} m\", \"0 m\"]\n", e)),
               light);
  };
  const Project project = parse_project("arm.toml", text(1.0));
  const double give = give_of(project.beam.segments.front().from, L, e);
  const double omega = 1.0 / std::sqrt(m * give), end = 1.3 * 2.0 * pi / omega;
  const StepDriver step{0.0, 1e-3, 0.0, end};
  const auto a = [&](double t) { return driver_at(step, t).acceleration; };
  const Moved of(text(end));
  const ElasticMotionInSpace elastic = of.by(3, 8);
  const Cuts rigid = cuts_of(of.rigid().loads_at(of.at(0.25)), 1.0) / a(0.25 * end);
  REQUIRE(std::abs(rigid[3]) > 0.1 * std::abs(rigid[4]));
  for (const double part : {0.1, 0.4, 0.7, 0.95, 1.1, 1.9}) {
    const double time = part * end;
    const Cuts found = cuts_of(elastic.loads_at(si<Time>(time)), 1.0);
    check_alike(found, rigid * borne(a, end, time, omega), rigid * a(0.25 * end), 2e-4);
  }
}

// A force on a point mass at the tip of an arm without mass, on a ground that stands: F (1 - cos).
TEST_CASE("a force that acts at once bends twice as far as one that comes slowly",
          "[elastic_start]") {
  const double L = 4.0, m = 150.0, F = 700.0;
  Project project = parse_project("arm.toml", lasting(arm(clamped + with_load(150.0) + R"(
[forces.push]
kind = "force"
point = "arm.tip"
direction = "z"
size = "1 N"
)",
                                                          light),
                                                      1.0));
  const double give = give_of(project.beam.segments.front().from, L);
  const double omega = 1.0 / std::sqrt(m * give), period = 2.0 * pi / omega;
  const double begin = 0.4 * period, end = 2.1 * period;
  auto& mechanism = std::get<spatial::Mechanism>(project.mechanism);
  mechanism.duration.length = end;
  mechanism.loads.front().size =
      TableDriver{TableCurve({0.0, begin, end}, {0.0, F, F}, Interpolation::step, Beyond::hold)};
  const Moved of(std::move(project));
  const ElasticMotionInSpace elastic = of.by(3, 8);
  CHECK(elastic.transient()->times().back() > 1.9 * end);
  for (const double time : {0.2 * period, 0.7 * period, 0.9 * period, 1.7 * period, 2.05 * period,
                            2.3 * period, 3.9 * period}) {
    const double moment = std::abs(cuts_of(elastic.loads_at(si<Time>(time)), 1.0)[4]);
    const double grown = time < begin ? 0.0 : 1.0 - std::cos(omega * (time - begin));
    CHECK(moment == Approx(F * (L - 1.0) * grown).margin(2e-4 * F * L));
  }
}

// By Runge and Kutta, an arm that turns far: Coriolis and centrifugal terms count.
TEST_CASE("a mass on an arm that is turned far once moves as integration over time says",
          "[elastic_start]") {
  const double turn = 1.4, end = 0.9;
  const SwungArm arm(stepping(turn, end), StepDriver{0.0, turn, 0.0, end});
  // With as much of the free vibration behind it.
  const double watched = 1.5 * end;
  const auto path = arm.mass.path(SwungMass::State::Zero(), 1.0, watched);
  double largest = 0.0, apart = 0.0, behind = 0.0;
  for (int i = 0; i <= 96; ++i) {
    const double time = watched * i / 96.0;
    if (time > arm.elastic.transient()->times().back()) break;
    const Vector3d expected = path[static_cast<std::size_t>(i * SwungMass::steps / 96)].head<3>(),
                   found = arm.tip * arm.elastic.transient()->at(time).eta;
    largest = std::max(largest, expected.norm());
    if (time > end) behind = std::max(behind, expected.norm());
    apart = std::max(apart, (expected - found).norm());
  }
  INFO(apart / largest << " of " << largest << " m, " << arm.elastic.lowest_frequency() << " Hz");
  REQUIRE(behind > 0.05 * largest);
  CHECK(apart < 2e-4 * largest);
}

// Damping takes away what the start excites, e^(-zeta omega t).
TEST_CASE("a start in space dies away to the vibration that repeats", "[elastic_start]") {
  const Vector3d axis(0.48, -0.6, 0.64);
  const double frequency = 1.5, period = 1.0 / frequency;
  const std::string damped = "[model]\ndamping = { ratio = 0.2, at = \"4 Hz\" }\n";
  const std::string text = arm(hinge(axis, 0.2, frequency) + beside, steel, damped);
  const Moved repeating(text), started(lasting(text, 6.37 * period));
  REQUIRE(repeating.rigid().closed());
  REQUIRE_FALSE(started.rigid().closed());
  const ElasticMotionInSpace periodic = repeating.by(4, 8), once = started.by(4, 8);
  // It does not come to rest, and nothing is looked at behind the end.
  CHECK(once.transient()->times().back() == Approx(6.37 * period));
  double size = 0.0, at_begin = 0.0;
  for (const double part : {0.1, 0.37, 0.5, 0.88})
    size = std::max(size, cuts_of(periodic.loads_at(repeating.at(part)), 0.0).tail<3>().norm());
  for (const double part : {0.1, 0.37, 0.5, 0.88}) {
    const Cuts expected = cuts_of(periodic.loads_at(repeating.at(part)), 0.0);
    const auto apart_in = [&](double turns) {
      const Cuts found = cuts_of(once.loads_at(si<Time>((turns + part) * period)), 0.0);
      return (found - expected).tail<3>().norm();
    };
    INFO("part " << part << ": " << apart_in(5.0) / size);
    CHECK(apart_in(5.0) < 1e-4 * size);
    at_begin = std::max(at_begin, apart_in(0.0));
  }
  CHECK(at_begin > 0.01 * size);
}

// Energy: the work of the drive until it stands is what vibrates then and what the material has
// taken,
//
//     integral of M q' dt = sum of eta_j'^2/2 + omega_j^2 eta_j^2/2 + tau omega_j^2 int eta_j'^2 dt
//
// for bodies stand again; and what vibrates loses what the material takes from there on. Turning so
// little leaves modes and equations as they are.
TEST_CASE("the work of the drive is what vibrates behind it and what is dissipated",
          "[elastic_start]") {
  const Vector3d axis(0.48, -0.6, 0.64);
  const double small = 1e-4, end = 0.13;
  const Moved of(arm(hinge(axis, stepping(small, end)) + beside, steel,
                     "[model]\ndamping = { ratio = 0.02, at = \"6 Hz\" }\n"));
  const ElasticMotionInSpace elastic = of.by(6, 8);
  const std::vector<frame::BeamMode> modes = of.modes(8, 6);
  const TransientResponse& response = *elastic.transient();
  const auto k = static_cast<Eigen::Index>(response.states().front().eta.size());
  REQUIRE(k == 6);
  VectorXd squares(k);
  for (Eigen::Index j = 0; j < k; ++j)
    squares[j] = std::pow(2.0 * pi * modes[static_cast<std::size_t>(j)].frequency, 2);
  const double tau = 0.02 / (pi * 6.0);
  const auto vibrating = [&](double time) {
    const ModalState at = response.at(time);
    return 0.5 * at.speed.squaredNorm() + 0.5 * squares.dot(at.eta.cwiseAbs2());
  };
  // By Simpson's rule, in so many steps that those of the response are fine.
  const auto integral = [](double from, double until, const std::function<double(double)>& f) {
    constexpr int n = 4000;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * f(from + (until - from) * i / n);
    return sum * (until - from) / n / 3.0;
  };
  const auto taken = [&](double time) {
    return tau * squares.dot(response.at(time).speed.cwiseAbs2());
  };
  const StepDriver step{0.0, small, 0.0, end};
  const double work = integral(0.0, end, [&](double time) {
    // The cut behind the root is what the drive does, reversed.
    const Cuts root = cuts_of(elastic.loads_at(si<Time>(time)), 0.0);
    return -root.tail<3>().dot(axis) * driver_at(step, time).rate;
  });
  const double left = vibrating(end), dissipated = integral(0.0, end, taken);
  REQUIRE(left > 0.0);
  REQUIRE(dissipated > 1e-3 * left);
  CHECK(work == Approx(left + dissipated).epsilon(2e-4));
  const double last = response.times().back();
  REQUIRE(last > end);
  CHECK(vibrating(end) - vibrating(last) == Approx(integral(end, last, taken)).epsilon(1e-4));
}

// Statics: W L/2 of an arm that is held, before its motion and behind it; with an acceleration at
// once the rigid one has alpha m L^2/3 more.
TEST_CASE("before and behind its motion a mechanism is held", "[elastic_start]") {
  const double alpha = 0.8, end = 0.5;
  const Moved of(
      lasting(arm(hinge({0, -1, 0}, polynomial({0.0, 0.8 * end, -0.4})), steel, "", 9.81), end));
  const MassProperties properties = mass_properties_of(of.project.beam);
  const double m = properties.mass.value(), L = 4.0;
  const double I = properties.tensor(1, 1) + m * 4.0;
  const auto root = [&](double time) {
    return std::abs(cuts_of(of.rigid().loads_at(si<Time>(time)), 0.0)[4]);
  };
  const double turned = 0.4 * end * end;
  CHECK(root(0.0) == Approx(m * 9.81 * 0.5 * L - I * alpha).epsilon(1e-6));
  CHECK(root(-1.0) == Approx(m * 9.81 * 0.5 * L).epsilon(1e-9));
  CHECK(root(end) == Approx(m * 9.81 * 0.5 * L * std::cos(turned) - I * alpha).epsilon(1e-6));
  CHECK(root(end + 1.0) == Approx(m * 9.81 * 0.5 * L * std::cos(turned)).epsilon(1e-9));
}

// Turning at constant speed under its weight it has turned before: what its weight does to it is a
// part r^2 of the static. From rest the speed of the deflection would be missing, which leaves a
// free vibration of r times it.
TEST_CASE("a motion in space that is under way begins without a free vibration",
          "[elastic_start]") {
  const std::string text = arm(hinge({0, -1, 0}, R"(kind = "constant rate"
start = "0.3 rad"
rate = "3 rad/s"
)") + beside,
                               steel, "", 9.81);
  const double period = 2.0 * pi / 3.0;
  const Moved all(text), part(lasting(text, 0.6 * period));
  REQUIRE(all.rigid().closed());
  const ElasticMotionInSpace periodic = all.by(3, 8), begun = part.by(3, 8);
  const double r = 1.0 / period / periodic.lowest_frequency();
  double size = 0.0, worst = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const Time time = si<Time>(0.6 * period * i / 60.0);
    const Cuts expected = cuts_of(periodic.loads_at(time), 0.0);
    size = std::max(size, expected.tail<3>().norm());
    worst = std::max(worst, (cuts_of(begun.loads_at(time), 0.0) - expected).tail<3>().norm());
  }
  INFO("r = " << r << ", apart by " << worst / size);
  REQUIRE(r < 0.15);
  CHECK(worst < 2.0 * r * r * size);
}

TEST_CASE("a start in space is estimated, climbed to and looked at with what follows",
          "[elastic_start]") {
  const std::string damped = "[model]\ndamping = { ratio = 0.02, at = \"6 Hz\" }\n";
  const auto choice_of = [&](double end) {
    return run_by_chosen_model(parse_project(
        "arm.toml", arm(hinge({0.48, -0.6, 0.64}, stepping(0.3, end)) + beside, steel, damped)));
  };
  const std::string text =
      arm(hinge({0.48, -0.6, 0.64}, stepping(0.3, 0.7)) + beside, steel, damped);
  const Project project = parse_project("arm.toml", text);
  const ModelledRuns fast = run_by_chosen_model(project);
  INFO(fast.model.reason);
  CHECK(fast.model.chosen.level == ModelLevel::modal);
  CHECK_THAT(fast.model.weighed.front().basis, Catch::Contains("over time"));
  CHECK(fast.model.harmonics.empty());
  CHECK(fast.runs.front().loads.period().value() > 0.7 + 1.4 / fast.model.frequencies.front());
  CHECK(length_of_motion(project, fast.runs.front()) == Approx(0.7));
  CHECK(unestimated_vibration_of(project, fast.model, fast.runs).empty());
  CHECK(unseen_time_of(project, fast.runs).empty());
  // What the slope of the acceleration leaves at the ends of a slow step: 2 10.4/(omega T).
  const ModelledRuns slow = choice_of(120.0);
  INFO(slow.model.reason);
  CHECK(slow.model.chosen.level == ModelLevel::rigid);
  CHECK(slow.runs.front().loads.period().value() == Approx(120.0));

  // Without damping it goes on.
  Project undamped =
      parse_project("arm.toml", arm(hinge({0.48, -0.6, 0.64}, stepping(0.3, 0.7)) + beside, steel));
  undamped.fatigue.asked = true;
  const ModelledRuns ringing = run_by_chosen_model(undamped);
  REQUIRE(ringing.model.chosen.level == ModelLevel::modal);
  const std::vector<NotJudged> behind =
      unestimated_vibration_of(undamped, ringing.model, ringing.runs);
  REQUIRE(behind.size() == 1);
  CHECK(behind.front().by == Criterion::fatigue);
  CHECK_THAT(behind.front().what, Catch::Contains("behind the motion"));

  // Under way at once, and demanded.
  Project begun = parse_project(
      "arm.toml",
      lasting(arm(hinge({0.48, -0.6, 0.64}, polynomial({0.0, 0.5, 0.4})) + beside, steel, damped),
              0.7));
  begun.model.demand = ModelDemand::flexible;
  const ModelledRuns demanded = run_by_chosen_model(begun);
  CHECK(demanded.model.chosen.level == ModelLevel::modal);
  const std::vector<NotJudged> said =
      unestimated_vibration_of(begun, demanded.model, demanded.runs);
  REQUIRE(said.size() == 1);
  CHECK_THAT(said.front().what, Catch::Contains("at the beginning"));
}

TEST_CASE("a cable that begins to act in every period leaves the beam without modes",
          "[elastic_start]") {
  const std::string stay = R"(
[forces.stay]
kind = "spring"
connect = ["ground", "arm.tip"]
at = ["3.9 m", "-0.8 m", "0 m"]
stiffness = "20 kN/m"
free_length = "1.2 m"
acts = "pulling"
)";
  const Moved of(arm(hinge({0, 0, 1}, swinging(0.3, 0.2)) + stay, steel));
  try {
    of.by(2, 8);
    FAIL("not refused");
  } catch (const AnalysisError& error) {
    CHECK_THAT(error.failure().what, Catch::Contains("begins or ends to act"));
  }
}

}  // namespace elastic_start_in_space_test
