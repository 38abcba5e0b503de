// Closed-form dyads against closed forms of other shape (law of cosines, Heron), against the
// program, and where a mechanism is none.

#include "charts/dyads.hpp"

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "stability/benches.hpp"

namespace dyads_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

struct Both {
  planar::State state;
  InstantIn<long double> closed;
};

Both both_of(const planar::Mechanism& mechanism, double time) {
  planar::InstantSolver solver(mechanism);
  Both both;
  both.state = solver.solve_from_sketch(time, sketch_of(mechanism));
  const DyadPlan plan = plan_dyads(mechanism, both.state.q);
  REQUIRE(plan.failure == "");
  solve_dyads(plan, solver.equations().driver_states(), both.state.q, both.closed);
  return both;
}

void check_agreement(const Both& both) {
  const InstantIn<double> closed = both.closed.in<double>();
  CHECK((closed.q - both.state.q).lpNorm<Eigen::Infinity>() < 1e-13);
  CHECK((closed.v - both.state.v).lpNorm<Eigen::Infinity>() <
        1e-13 * both.state.v.lpNorm<Eigen::Infinity>());
  CHECK((closed.a - both.state.a).lpNorm<Eigen::Infinity>() <
        1e-13 * both.state.a.lpNorm<Eigen::Infinity>());
}

}  // namespace

TEST_CASE("a four-bar is a crank and a dyad of three pins (law of cosines)") {
  const test::FourBar bar;
  for (const int sign : {1, -1}) {
    for (const double phi : {0.3, 0.9, 1.3}) {
      const planar::Mechanism mechanism = test::four_bar(bar, RateDriver{phi, 2.0}, phi, sign);
      const Both both = both_of(mechanism, 0.0);
      const auto exact = test::posture_of(bar, static_cast<long double>(phi), sign);
      CHECK(std::abs(std::remainder(static_cast<double>(both.closed.q[8] - exact.rocker),
                                    2.0 * test::pi)) < 1e-17);
      CHECK(std::abs(static_cast<double>(both.closed.v[8] / 2.0L - exact.rocker_rate)) <
            1e-17 * std::abs(static_cast<double>(exact.rocker_rate)) + 1e-17);
      check_agreement(both);
    }
  }
}

TEST_CASE("a slider-crank is a crank and a dyad with a slider (Pythagoras)") {
  const double r = 0.4, l = 1.1, phi = 0.7, omega = 3.0;
  const Both both = both_of(test::slider_crank(r, l, RateDriver{phi, omega}, phi), 0.0);
  const auto x = [&](long double angle) {
    return r * std::cos(angle) + std::sqrt(l * l - r * r * std::sin(angle) * std::sin(angle));
  };
  CHECK(static_cast<double>(std::abs(both.closed.q[6] - x(phi))) < 1e-17);
  // d/dphi of both terms.
  const long double s = std::sin(static_cast<long double>(phi));
  const long double c = std::cos(static_cast<long double>(phi));
  const long double root = std::sqrt(l * l - r * r * s * s);
  const long double first = -r * s - r * r * s * c / root;
  CHECK(static_cast<double>(std::abs(both.closed.v[6] - omega * first)) < 1e-16);
  check_agreement(both);
  // The slider driven: its crank and rod are then a dyad of three pins.
  check_agreement(both_of(test::slider_crank(r, l, HarmonicDriver{1.2, 0.1, 2.0}, phi, true), 0.3));
}

TEST_CASE("driven lengths, slots of either body and couplings are dyads as well") {
  using planar::Attachment;
  using test::on;
  using test::on_ground;
  // A boom lifted by a cylinder; a lever coupled to it; a link whose slot runs over a pin of it.
  planar::Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81};
  mechanism.bodies = {test::rod("boom", {0.0, 0.0}, {1.6, 1.2}),
                      test::rod("lever", {-1.0, 0.0}, {-1.0, 1.0}),
                      test::rod("link", {3.0, 0.0}, {1.4, 1.4})};
  mechanism.joints = {
      {"O", planar::Pin{on(0, -1.0), on_ground(0.0, 0.0)}},
      {"lever pivot", planar::Pin{on(1, -0.5), on_ground(-1.0, 0.0)}},
      {"link pivot", planar::Pin{on(2, -std::hypot(1.6, 1.4) / 2.0), on_ground(3.0, 0.0)}},
      {"coupling", planar::AngleCoupling{on(1, 0.0), on(0, 0.0), 2.0, 0.3}},
      {"slot", planar::PinInSlot{on(0, 0.9), on(2, 0.0, 0.1), 0.05}},
      {"cylinder", planar::Driven{on(0, 0.4), planar::Coordinate::length,
                                  HarmonicDriver{1.1, 0.1, 2.0}, on_ground(1.0, -0.2)}}};
  check_agreement(both_of(mechanism, 0.4));
}

TEST_CASE("a platform on three rods has no dyad, and says which body") {
  const planar::Mechanism mechanism = test::platform_on_rods({}, RateDriver{0.4, 1.0});
  planar::InstantSolver solver(mechanism);
  const planar::State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
  CHECK(plan_dyads(mechanism, state.q).failure == "no dyad: platform");
}

}  // namespace dyads_test
