// Mechanisms with more constraints than they need: rank and its gap, what repeats what, which
// reactions are determined and what they are; constraints that contradict each other are refused.

#include <algorithm>
#include <cmath>
#include <iostream>

#include "benches.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"

namespace rank_loss_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double rate = 3.0;  // of the crank [rad/s]
constexpr double gravity = 9.81;

/// Three parallel cranks and a load of 50 kg on an arm that is fixed to the coupler.
Mechanism bench_with_load(double start, double longer = 0.0) {
  Mechanism mechanism = test::parallel_cranks(3, RateDriver{start, rate}, start, false, longer);
  Body load;
  load.name = "load";
  load.mass = 50.0;
  load.inertia = 4.0;
  load.sketch.centre = mechanism.bodies[0].sketch.centre + Eigen::Vector2d(0.5, 0.7);
  mechanism.bodies.push_back(load);
  const int body = static_cast<int>(mechanism.bodies.size()) - 1;
  mechanism.joints.push_back({"arm", Rigid{test::on(body, 0.0), test::on(0, 0.5, 0.7), 0.0}});
  return mechanism;
}

std::vector<std::string> names_of(const Mechanism& mechanism, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints)
    names.push_back(mechanism.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

Reaction reaction_on(const Mechanism& mechanism, const State& state, const std::string& joint,
                     int on) {
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (reaction.joint == joint_index(mechanism, joint) && reaction.on == on) return reaction;
  }
  FAIL("no such reaction");
  return {};
}

/// The same with the middle crank 0.5 m out of line: it holds the coupler in flat positions, too.
Mechanism guided_bench(double start) {
  Mechanism mechanism = bench_with_load(start);
  std::get<Pin>(mechanism.joints[2].kind).b.p.y() += 0.5;
  std::get<Pin>(mechanism.joints[3].kind).b.p.y() += 0.5;
  mechanism.bodies[2].sketch.centre.y() += 0.5;
  return mechanism;
}

struct Turn {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;  ///< errors
  int reorderings = 0, change_points = 0;
};

/// A turn of parallel cranks against its circle. Throws as the solver does.
Turn turn_of(const Mechanism& mechanism, double start, int instants) {
  InstantSolver solver(mechanism);
  State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
  Turn turn;
  for (int i = 0; i <= instants; ++i) {
    if (i > 0) state = solver.solve_near(2.0 * test::pi / rate * i / instants, state);
    const double phi = start + rate * state.time;
    const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
    const Eigen::Vector2d n(-e.y(), e.x());
    turn.position = std::max({turn.position, std::abs(state.q[2]),
                              (state.q.head<2>() - e - Eigen::Vector2d(1.0, 0.0)).norm()});
    turn.velocity =
        std::max({turn.velocity, std::abs(state.v[2]), (state.v.head<2>() - rate * n).norm()});
    turn.acceleration = std::max(
        {turn.acceleration, std::abs(state.a[2]), (state.a.head<2>() + rate * rate * e).norm()});
  }
  turn.reorderings = solver.reorderings();
  turn.change_points = static_cast<int>(solver.change_points().size());
  return turn;
}

}  // namespace

TEST_CASE("a third parallel crank repeats an equation; what is determined is right") {
  const std::vector<std::string> cranks = {"ground 1", "tip 1",    "ground 2",
                                           "tip 2",    "ground 3", "tip 3"};
  int positions = 0;
  double smallest_gap = 1e300;
  double worst = 0.0;
  for (const double start : {0.3, 0.9, 1.4, 2.2, 3.6, 5.0, -0.8, 0.05}) {
    INFO("crank at " << start);
    const Mechanism mechanism = bench_with_load(start);
    InstantSolver solver(mechanism);
    const State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
    const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, state.q);
    CHECK(freedom.gruebler == 0);
    CHECK(freedom.by_rank == 1);
    CHECK(freedom.redundant == 1);
    CHECK(freedom.undriven == 0);
    CHECK(freedom.gap > 1e10);
    CHECK(names_of(mechanism, freedom.repeating) == cranks);
    CHECK(is_unique(freedom, joint_index(mechanism, "motor")));
    CHECK(is_unique(freedom, joint_index(mechanism, "arm")));
    for (const std::string& joint : cranks) {
      CHECK_FALSE(is_unique(freedom, joint_index(mechanism, joint)));
    }
    smallest_gap = std::min(smallest_gap, freedom.gap);

    // By hand: everything on the coupler goes round on a circle of 1 m at constant rate, so the arm
    // holds the load's weight and centripetal force; the motor lifts coupler and load, by a lever
    // of cos(phi), and the cranks by half of it. Inertia does no work.
    const double phi = start;
    const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
    const Eigen::Vector2d on_load = 50.0 * (Eigen::Vector2d(0.0, gravity) - rate * rate * e);
    const int load = body_index(mechanism, "load");
    const Reaction arm = reaction_on(mechanism, state, "arm", load);
    CHECK((arm.force - on_load).norm() < 1e-9 * on_load.norm());
    CHECK(std::abs(arm.moment) < 1e-8);
    const double moment = gravity * std::cos(phi) * (50.0 + 20.0 + 0.5 * 30.0);
    const Reaction motor = reaction_on(mechanism, state, "motor", 1);
    CHECK(motor.moment == Approx(moment).epsilon(1e-9));
    worst = std::max({worst, (arm.force - on_load).norm() / on_load.norm(),
                      std::abs(motor.moment / moment - 1.0)});
    ++positions;
  }
  std::cout << "stability: parallelogram with a third crank at " << positions
            << " positions: one redundancy found at all of them, rank known by a gap of at least "
            << smallest_gap << ", determined reactions within " << worst
            << " of the hand formula\n";
}

TEST_CASE("at right angles only the cranks' own direction is undetermined") {
  const Mechanism mechanism = bench_with_load(test::pi / 2.0);
  const State state = InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, state.q);
  // Rows: two per pin, x and y; the cranks stand along y.
  for (std::size_t row = 0; row < 12; ++row) {
    CHECK(static_cast<int>(freedom.unique[row]) == (row % 2 == 0 ? 1 : 0));
  }
  std::cout << "stability: the same with upright cranks: across the cranks all reactions are "
               "determined, along them none\n";
}

TEST_CASE("three cranks in line: flat positions are passed beside, or refused for their loads") {
  // In line all three leave the coupler free to turn where they are flat, to the first order: with
  // weight on it reactions grow there without bound.
  int turns = 0;
  double worst = 0.0;
  for (const int instants : {24, 36, 96, 97}) {
    INFO(instants << " instants");
    const Turn turn = turn_of(bench_with_load(0.3), 0.3, instants);
    CHECK(turn.position < 1e-11);
    CHECK(turn.change_points == 2);
    worst = std::max(worst, turn.position);
    ++turns;
  }
  CHECK_THROWS_AS(turn_of(bench_with_load(0.0), 0.0, 24), AnalysisError);
  std::cout << "stability: " << turns << " turns of three cranks in line: on the circle within "
            << worst << " m; loads in the flat position itself refused\n";
}

TEST_CASE("a redundant mechanism without dead points moves all round, as exactly as anywhere") {
  // Where two cranks are flat they alone determine nothing: other equations must take part there.
  Turn worst;
  int turns = 0, refused = 0;
  for (const int instants : {24, 36, 96, 97, 1000, 10007}) {
    for (const double start : {0.3, 0.0, 1.0, test::pi}) {
      INFO(instants << " instants from " << start);
      ++turns;
      try {
        const Turn turn = turn_of(guided_bench(start), start, instants);
        CHECK(turn.position < 1e-11);
        CHECK(turn.velocity < 1e-9);
        CHECK(turn.acceleration < 1e-8);
        CHECK(turn.change_points == 0);
        worst.position = std::max(worst.position, turn.position);
        worst.velocity = std::max(worst.velocity, turn.velocity);
        worst.acceleration = std::max(worst.acceleration, turn.acceleration);
        worst.reorderings += turn.reorderings;
        worst.change_points += turn.change_points;
      } catch (const AnalysisError& error) {
        ++refused;
        FAIL_CHECK(error.what());
      }
    }
  }
  std::cout << "stability: " << turns
            << " turns of three cranks out of line, 24 .. 10007 instants: " << refused
            << " refused, " << worst.change_points
            << " change points seen where there are none, positions within " << worst.position
            << " m, velocities " << worst.velocity << " m/s, accelerations " << worst.acceleration
            << " m/s^2 of the circle; " << worst.reorderings << " new orders of elimination\n";
}

TEST_CASE("a third crank 1 mm too long is refused with its gap (hand formula)") {
  double worst = 0.0;
  for (const double start : {0.3, 1.1, 2.4, -0.7}) {
    for (const double longer : {1e-3, -1e-3, 1e-5}) {
      INFO("crank at " << start << ", longer by " << longer);
      const Mechanism mechanism = bench_with_load(start, longer);
      try {
        InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
        FAIL_CHECK("must be refused");
      } catch (const AnalysisError& error) {
        // Self-stress of parallel cranks: 1, -2, 1, in both pins of each. The misfit is shared by
        // its squares: the middle pins are open by 2/(2 (1 + 4 + 1)) of it.
        const double gap = std::abs(longer) / 6.0;
        CHECK(error.failure().residual.value() == Approx(gap).epsilon(5e-3));
        const std::string& where = error.failure().where;
        CHECK((where == "joint ground 2" || where == "joint tip 2"));
        worst = std::max(worst, std::abs(error.failure().residual.value() / gap - 1.0));
      }
    }
  }
  std::cout << "stability: third crank 10 um .. 1 mm too long or short, 12 times: all refused, gap "
               "within "
            << worst << " of the hand formula\n";
}

TEST_CASE("a doubled joint changes nothing but its own reactions") {
  const test::FourBar bar;
  double worst = 0.0;
  for (const double phi : {0.4, 0.9, 1.3}) {
    for (std::size_t twice = 0; twice < 4; ++twice) {
      const Mechanism simple = test::four_bar(bar, RateDriver{phi, 2.0}, phi, 1);
      Mechanism doubled = simple;
      Joint copy = simple.joints[twice];
      copy.name += " again";
      doubled.joints.push_back(copy);
      INFO("crank at " << phi << ", joint " << simple.joints[twice].name << " doubled");
      const State a = InstantSolver(simple).solve_from_sketch(0.0, sketch_of(simple));
      const State b = InstantSolver(doubled).solve_from_sketch(0.0, sketch_of(doubled));
      CHECK((a.q - b.q).lpNorm<Eigen::Infinity>() < 1e-12);
      CHECK((a.v - b.v).lpNorm<Eigen::Infinity>() < 1e-11);
      CHECK((a.a - b.a).lpNorm<Eigen::Infinity>() < 1e-10);
      const DegreesOfFreedom freedom = degrees_of_freedom_of(doubled, b.q);
      CHECK(freedom.redundant == 2);
      CHECK(freedom.by_rank == 1);
      CHECK(freedom.undriven == 0);
      CHECK(freedom.repeating == std::vector<int>{static_cast<int>(twice), 5});
      const Eigen::VectorXd together =
          b.lambda.segment<2>(2 * static_cast<Eigen::Index>(twice)) + b.lambda.tail<2>();
      for (std::size_t joint = 0; joint < 5; ++joint) {
        const auto row = 2 * static_cast<Eigen::Index>(joint);
        const Eigen::Index rows = joint == 4 ? 1 : 2;
        const Eigen::VectorXd one = a.lambda.segment(row, rows);
        const Eigen::VectorXd two =
            joint == twice ? together : Eigen::VectorXd(b.lambda.segment(row, rows));
        CHECK((one - two).norm() < 1e-9 * a.lambda.norm());
        worst = std::max(worst, (one - two).norm() / a.lambda.norm());
        CHECK(is_unique(freedom, static_cast<int>(joint)) == (joint != twice));
      }
    }
  }
  std::cout
      << "stability: each pin of a four-bar doubled, 12 times: found, all other reactions and "
         "the sum of the pair unchanged within "
      << worst << "\n";
}

TEST_CASE("a second driver that says the same is redundant, one that says another is refused") {
  const test::FourBar bar;
  for (const double phi : {0.4, 0.9, 1.3}) {
    Mechanism mechanism = test::four_bar(bar, RateDriver{phi, 2.0}, phi, 1);
    mechanism.joints.push_back({"motor again", mechanism.joints.back().kind});
    const State state = InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
    const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, state.q);
    CHECK(freedom.redundant == 1);
    CHECK(freedom.drivers == 2);
    CHECK(freedom.repeating == std::vector<int>{4, 5});
    std::get<Driven>(mechanism.joints.back().kind).driver = RateDriver{phi + 1e-4, 2.0};
    try {
      InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism));
      FAIL_CHECK("must be refused");
    } catch (const AnalysisError& error) {
      CHECK(error.failure().residual.value() == Approx(0.5e-4).epsilon(1e-6));  // half each
    }
  }
  std::cout << "stability: a second driver of the same crank: redundant where it says the same, "
               "refused with half of its 1e-4 rad as the gap where it does not\n";
}

TEST_CASE("a second driver that says another rate is refused") {
  // The same angle at t = 0 but another rate: no motion, though this instant can be assembled.
  const test::FourBar bar;
  Mechanism mechanism = test::four_bar(bar, RateDriver{0.9, 2.0}, 0.9, 1);
  mechanism.joints.push_back({"motor again", mechanism.joints.back().kind});
  std::get<Driven>(mechanism.joints.back().kind).driver = RateDriver{0.9, 2.5};
  const auto is_refused = [](const auto& solve) {
    try {
      solve();
    } catch (const AnalysisError&) {
      return true;
    }
    return false;
  };
  const bool motion = is_refused([&] { solve_motion(mechanism, 24); });
  const bool instant =
      is_refused([&] { InstantSolver(mechanism).solve_from_sketch(0.0, sketch_of(mechanism)); });
  CHECK(motion);
  CHECK(instant);
  std::cout << "stability: a second driver with the same angle and another rate: motion "
            << (motion ? "refused" : "solved") << ", instant " << (instant ? "refused" : "solved")
            << "\n";
}

TEST_CASE("an aligned slider-crank with r = l: the rank falls, and is said") {
  // At phi = 90 deg the slider is at O and may stay there: crank and rod turn together.
  const Mechanism mechanism = test::slider_crank(1.0, 1.0, RateDriver{test::pi / 2.0, 1.0}, 1.0);
  Eigen::VectorXd q(9);
  q << 0.0, 0.5, test::pi / 2.0, 0.0, 0.5, -test::pi / 2.0, 0.0, 0.0, 0.0;
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, q);
  CHECK(freedom.undriven == 1);
  CHECK(freedom.redundant == 1);
  CHECK(freedom.by_rank == 2);
  CHECK(freedom.gap > 1e10);
  CHECK(freedom.condition == 0.0);
  CHECK(digits_left_at(freedom.condition) == 0.0);
  CHECK_THROWS_AS(InstantSolver(mechanism).solve_at(0.0, q), AnalysisError);
  std::cout << "stability: aligned slider-crank r = l: two freedoms, one driver; gap "
            << freedom.gap << "; its velocities are refused\n";
}

}  // namespace rank_loss_test
