// Contacts that stick and slide under forces, against closed forms (Coulomb's law piece by piece;
// den Hartog, Mechanical Vibrations (1956), section 8.2), work and energy, and the smoothed law.

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace sticking_motion_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double g = 9.81, pi = std::numbers::pi;

Friction dry(double mu, double standing = 0.0) { return {mu, 0.0, 0.0, 0.0, standing}; }

/// A block on a rail of the ground or of another block, along x turned by an angle.
int add_block(Mechanism& to, const char* name, double mass, const Friction& friction, double x,
              double v, int on = ground, double angle = 0.0) {
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  boxbeam::Body block;
  block.name = name;
  block.mass = mass;
  block.inertia = 0.1 * mass;
  block.sketch.centre = x * along;
  block.sketch.angle = angle;
  block.start_velocity << v * along, 0.0;
  to.bodies.push_back(block);
  const int index = static_cast<int>(to.bodies.size()) - 1;
  Slider rail;
  rail.point = {index, {0.0, 0.0}};
  rail.guide = {on, {0.0, 0.0}};
  rail.direction = on == ground ? angle : 0.0;
  rail.angle = rail.direction;
  rail.friction = friction;
  to.joints.push_back({std::string("rail of ") + name, rail});
  return index;
}

Mechanism level(double duration) {
  Mechanism of;
  of.gravity = {0.0, -g};
  of.duration.length = duration;
  return of;
}

Spring spring_between(const Attachment& a, const Attachment& b, double stiffness, double length) {
  Spring spring;
  spring.a = a;
  spring.b = b;
  spring.stiffness = stiffness;
  spring.free_length = length;
  return spring;
}

State begin(FreeSolver& solver, const Mechanism& of) {
  return solver.start(0.0, sketch_of(of), start_velocity_of(of));
}

std::string failure_of(const Mechanism& of, double until) {
  return test::refusal_of<AnalysisError>([&] {
    FreeSolver solver(of);
    solver.advance(until, begin(solver, of));
  });
}

}  // namespace

TEST_CASE("a block that slides on a level rail stops and stays") {
  // By hand: after v0/(mu g), v0^2/(2 mu g) further on.
  constexpr double mu = 0.3, v0 = 2.0, stop = v0 / (mu * g), way = v0 * v0 / (2.0 * mu * g);
  Mechanism of = level(2.0);
  add_block(of, "block", 5.0, dry(mu), 0.1, v0);
  FreeSolver solver(of);
  State state = begin(solver, of);
  state = solver.advance(0.5 * stop, state);
  CHECK(state.a[0] == Approx(-mu * g).epsilon(1e-13));
  CHECK(state.friction[0] == Approx(-mu * 5.0 * g).epsilon(1e-13));
  for (const double time : {1.0, 1.5, 2.0}) {
    state = solver.advance(time, state);
    CHECK(state.q[0] == Approx(0.1 + way).epsilon(1e-12));
    CHECK(std::abs(state.v[0]) < 1e-15);
    CHECK(std::abs(state.a[0]) < 1e-13);
    CHECK(std::abs(state.friction[0]) < 1e-11);
  }
  REQUIRE(solver.slip_changes().size() == 1);
  CHECK(solver.slip_changes()[0].time == Approx(stop).epsilon(1e-11));
  CHECK(solver.slip_changes()[0].from == Slip::ahead);
  CHECK(solver.slip_changes()[0].to == Slip::none);
}

TEST_CASE("a block that slides against a stop comes back as far as friction lets it") {
  // Work, piece by piece: to the stop, d into it, out of it and back until it stands.
  constexpr double mu = 0.3, v0 = 2.0, x0 = 0.1, at = 0.3, m = 5.0, k = 1e6, length = 0.2;
  Mechanism of = level(2.0);
  const int block = add_block(of, "block", m, dry(mu), x0, v0);
  Spring stop = spring_between({ground, {at + length, 0.0}}, {block, {0.0, 0.0}}, k, length);
  stop.acts = Acts::pushing;
  of.forces.push_back({"stop", stop});
  const double into = v0 * v0 - 2.0 * mu * g * (at - x0), F = mu * m * g;
  const double d = (std::sqrt(F * F + k * m * into) - F) / k;
  const double out_of = into - 4.0 * mu * g * d;
  FreeSolver solver(of);
  State state = begin(solver, of);
  for (const double time : {1.0, 2.0}) {
    state = solver.advance(time, state);
    CHECK(state.q[0] == Approx(at - out_of / (2.0 * mu * g)).epsilon(1e-8));
    CHECK(std::abs(state.v[0]) < 1e-14);
  }
  CHECK(solver.changes().size() == 2);
  REQUIRE(solver.slip_changes().size() == 2);
  CHECK(solver.slip_changes()[0].to == Slip::back);
  CHECK(solver.slip_changes()[1].to == Slip::none);
}

TEST_CASE("a block pushed up an incline stays above or comes down by its angle") {
  constexpr double mu = 0.4, v0 = 3.0, m = 2.0;
  for (const double angle : {0.3, 0.5}) {  // tan: 0.309, 0.546
    CAPTURE(angle);
    Mechanism of = level(2.0);
    add_block(of, "block", m, dry(mu), 0.0, v0, ground, angle);
    FreeSolver solver(of);
    const double up = g * (std::sin(angle) + mu * std::cos(angle));
    const double top = v0 / up, way = v0 * v0 / (2.0 * up);
    const State state = solver.advance(2.0, begin(solver, of));
    const double x = std::cos(angle) * state.q[0] + std::sin(angle) * state.q[1];
    REQUIRE(solver.slip_changes().size() == 1);
    CHECK(solver.slip_changes()[0].time == Approx(top).epsilon(1e-11));
    if (std::tan(angle) < mu) {
      CHECK(solver.slip_changes()[0].to == Slip::none);
      CHECK(x == Approx(way).epsilon(1e-11));
      CHECK(state.friction[0] == Approx(m * g * std::sin(angle)).epsilon(1e-12));
      // The rail carries the block alone: its reaction is the weight.
      const std::vector<Reaction> reactions = reactions_of(of, state);
      CHECK(reactions[0].force.x() == Approx(0.0).margin(1e-10));
      CHECK(reactions[0].force.y() == Approx(m * g).epsilon(1e-12));
    } else {
      const double down = g * (std::sin(angle) - mu * std::cos(angle));
      CHECK(solver.slip_changes()[0].to == Slip::back);
      CHECK(x == Approx(way - 0.5 * down * std::pow(2.0 - top, 2)).epsilon(1e-10));
      CHECK(state.friction[0] == Approx(mu * m * g * std::cos(angle)).epsilon(1e-12));
    }
  }
}

TEST_CASE("a block on a spring loses four mu N/k a swing and sticks where the spring is weaker") {
  // den Hartog: half swings of pi/omega, amplitudes x0 - 2 n mu N/k, until k |x| <= mu_s N.
  constexpr double m = 4.0, k = 900.0, mu = 0.2, x0 = 0.1, lost = 2.0 * mu * m * g / k;
  const double half = pi * std::sqrt(m / k);
  for (const double standing : {0.0, 0.4}) {
    CAPTURE(standing);
    Mechanism of = level(2.0);
    const int block = add_block(of, "block", m, dry(mu, standing), x0, 0.0);
    of.forces = {{"spring", spring_between({block, {0.0, 0.0}}, {ground, {-2.0, 0.0}}, k, 2.0)}};
    int swings = 0;
    double x = x0;
    while (std::abs(x) > std::max(mu, standing) * m * g / k) {
      x = -(x - std::copysign(lost, x));
      ++swings;
    }
    REQUIRE(swings == (standing > 0.0 ? 5 : 6));
    FreeSolver solver(of);
    State state = begin(solver, of);
    CHECK(state.slips[0] == Slip::back);
    double before = x0;
    for (int n = 1; n < swings; ++n) {
      state = solver.advance(n * half, state);
      before = -(before - std::copysign(lost, before));
      CHECK(state.q[0] == Approx(before).epsilon(1e-9));
    }
    state = solver.advance(2.0, state);
    CHECK(state.q[0] == Approx(x).epsilon(1e-9));
    CHECK(std::abs(state.v[0]) < 1e-15);
    CHECK(state.friction[0] == Approx(k * x).epsilon(1e-9));
    const std::vector<SlipChange>& changes = solver.slip_changes();
    REQUIRE(changes.size() == static_cast<std::size_t>(swings));
    for (int n = 1; n <= swings; ++n)
      CHECK(changes[static_cast<std::size_t>(n - 1)].time == Approx(n * half).epsilon(1e-10));
    CHECK(changes.back().to == Slip::none);
    CHECK(changes[0].to == Slip::ahead);
  }
}

TEST_CASE("a block drawn by a spring sticks and slips with the period of its closed form") {
  // s'' = mu N/m - omega^2 s of the stretch s in slip, from s = mu_s N/k, s' = V, until s' = V
  // again: omega t = 2 (pi - atan(A omega/V)), A = (mu_s - mu) N/k; then it sticks for 2 A/V.
  constexpr double m = 3.0, k = 1200.0, mu = 0.15, standing = 0.35, V = 0.05;
  Mechanism of = level(8.0);
  const int block = add_block(of, "block", m, dry(mu, standing), 0.0, 0.0);
  const int hand = add_block(of, "hand", 1.0, {}, 1.0, V);
  Driven pull;
  pull.point = {hand, {0.0, 0.0}};
  pull.driver = PolynomialDriver{{1.0, V}};
  of.joints.push_back({"pull", pull});
  of.forces = {{"spring", spring_between({block, {0.0, 0.0}}, {hand, {0.0, 0.0}}, k, 1.0)}};
  const double N = m * g, omega = std::sqrt(k / m), A = (standing - mu) * N / k;
  const double first = standing * N / (k * V);
  const double slips = 2.0 * (pi - std::atan(A * omega / V)) / omega, sticks = 2.0 * A / V;
  FreeSolver solver(of);
  State state = begin(solver, of);
  for (int i = 1; i <= 80; ++i) state = solver.advance(0.1 * i, state);
  const std::vector<SlipChange>& changes = solver.slip_changes();
  REQUIRE(changes.size() >= 6);
  double time = first;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    CHECK(changes[i].time == Approx(time).epsilon(1e-9));
    CHECK((changes[i].to == Slip::none) == (i % 2 == 1));
    time += i % 2 == 0 ? slips : sticks;
  }
}

TEST_CASE("of two blocks on each other each sticks or slides as its own friction asks") {
  constexpr double lower = 6.0, upper = 2.0, v0 = 1.5;
  SECTION("the lower one stays") {
    constexpr double mu = 0.3;  // between them; 0.3 x 2 < 0.2 x 8
    Mechanism of = level(1.0);
    const int base = add_block(of, "lower", lower, dry(0.2), 0.0, 0.0);
    add_block(of, "upper", upper, dry(mu), 0.0, v0, base);
    FreeSolver solver(of);
    State state = solver.advance(0.1, begin(solver, of));
    CHECK(state.friction[0] == Approx(-mu * upper * g).epsilon(1e-12));
    CHECK(std::abs(state.v[0]) < 1e-15);
    state = solver.advance(1.0, state);
    CHECK(state.q[3] == Approx(v0 * v0 / (2.0 * mu * g)).epsilon(1e-11));
    CHECK(std::abs(state.q[0]) < 1e-15);
  }
  SECTION("the lower one is drawn along, and both stop together") {
    constexpr double mu = 0.5, rail = 0.05;
    const double along = (mu * upper - rail * (lower + upper)) * g / lower;
    const double together = v0 / (mu * g + along), v = along * together;
    const double stop = together + v / (rail * g);
    Mechanism of = level(3.0);
    const int base = add_block(of, "lower", lower, dry(rail), 0.0, 0.0);
    add_block(of, "upper", upper, dry(mu), 0.0, v0, base);
    FreeSolver solver(of);
    State state = begin(solver, of);
    CHECK(state.slips == std::vector<Slip>{Slip::ahead, Slip::ahead});
    state = solver.advance(0.5 * (together + stop), state);
    CHECK(state.slips == std::vector<Slip>{Slip::ahead, Slip::none});
    CHECK(state.friction[1] == Approx(-upper * rail * g).epsilon(1e-10));
    CHECK(state.v[3] - state.v[0] == Approx(0.0).margin(1e-15));
    state = solver.advance(3.0, state);
    const double x = 0.5 * along * together * together + v * v / (2.0 * rail * g);
    CHECK(state.q[0] == Approx(x).epsilon(1e-10));
    CHECK(state.q[3] ==
          Approx(x + v0 * together - 0.5 * (mu * g + along) * together * together).epsilon(1e-10));
    REQUIRE(solver.slip_changes().size() == 2);
    CHECK(solver.slip_changes()[0].time == Approx(together).epsilon(1e-10));
    CHECK(solver.slip_changes()[1].time == Approx(stop).epsilon(1e-10));
  }
}

TEST_CASE("a harmonic push moves a block for the part of its period in which it exceeds friction") {
  // By hand: F sin(w t) = mu_s N begins it; m v = F (cos(w t1) - cos(w t))/w - mu N (t - t1) ends
  // it.
  constexpr double m = 2.0, mu = 0.3, F = 1.02 * 0.3 * 2.0 * g, w = 6.0;
  Mechanism of = level(1.2);
  const int block = add_block(of, "block", m, dry(mu), 0.0, 0.0);
  PointForce push;
  push.at = {block, {0.0, 0.0}};
  push.size = HarmonicDriver{0.0, F, w, 0.0};
  of.forces = {{"push", push}};
  const double N = m * g, start = std::asin(mu * N / F) / w;
  double low = pi / w - start, high = 2.0 * pi / w - start;
  const auto momentum = [&](double t) {
    return F * (std::cos(w * start) - std::cos(w * t)) / w - mu * N * (t - start);
  };
  while (high - low > 1e-15) (momentum(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  // Also where one look alone would hardly see it, for it slides for a twentieth of the period.
  FreeSolver solver(of);
  State state = solver.advance(0.9 * pi / w, begin(solver, of));
  REQUIRE(solver.slip_changes().size() == 2);
  CHECK(solver.slip_changes()[0].time == Approx(start).epsilon(1e-10));
  CHECK(solver.slip_changes()[1].time == Approx(low).epsilon(1e-8));
  const double t = low, t1 = start;
  const double way = F * std::cos(w * t1) * (t - t1) / w -
                     F * (std::sin(w * t) - std::sin(w * t1)) / (w * w) -
                     0.5 * mu * N * (t - t1) * (t - t1);
  CHECK(state.q[0] == Approx(way / m).epsilon(1e-8));
}

TEST_CASE("a bead in the slot of an arm that turns ever faster sticks until it is thrown out") {
  // Pressed by m alpha r and thrown by m omega^2 r, omega = alpha t: it slides from t =
  // (mu/alpha)^0.5 on, r'' = omega^2 r - mu (alpha r + 2 omega r'), which is integrated here by
  // Runge and Kutta.
  constexpr double mu = 0.4, alpha = 2.5, r0 = 0.6, end = 0.8;
  Mechanism of;
  of.duration.length = 1.0;
  boxbeam::Body arm, bead;
  arm.name = "arm";
  bead.name = "bead";
  arm.mass = bead.mass = 2.0;
  arm.inertia = bead.inertia = 0.3;
  bead.sketch.centre = {r0, 0.0};
  of.bodies = {arm, bead};
  PinInSlot slot;
  slot.point = {1, {0.0, 0.0}};
  slot.guide = {0, {0.0, 0.0}};
  slot.friction = dry(mu);
  Driven turn;
  turn.point = {0, {0.0, 0.0}};
  turn.coordinate = Coordinate::angle;
  turn.driver = PolynomialDriver{{0.0, 0.0, 0.5 * alpha}};
  of.joints = {
      {"hinge", Pin{{0, {0.0, 0.0}}, {ground, {0.0, 0.0}}}}, {"slot", slot}, {"turn", turn}};
  FreeSolver solver(of);
  State state = begin(solver, of);
  CHECK(state.slips == std::vector<Slip>{Slip::none});
  const double thrown = std::sqrt(mu / alpha);
  state = solver.advance(0.9 * thrown, state);
  CHECK(state.q.segment<2>(3).norm() == Approx(r0).epsilon(1e-12));
  const double omega = 0.9 * thrown * alpha;
  CHECK(state.friction[0] == Approx(-2.0 * omega * omega * r0).epsilon(1e-11));
  state = solver.advance(end, state);
  REQUIRE(solver.slip_changes().size() == 1);
  CHECK(solver.slip_changes()[0].time == Approx(thrown).epsilon(1e-10));
  CHECK(solver.slip_changes()[0].to == Slip::ahead);
  const auto rate = [&](double t, const Eigen::Vector2d& y) {
    const double w = alpha * t;
    return Eigen::Vector2d(y[1], w * w * y[0] - mu * (alpha * y[0] + 2.0 * w * y[1]));
  };
  Eigen::Vector2d y(r0, 0.0);
  constexpr int steps = 4000;
  const double h = (end - thrown) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = thrown + i * h;
    const Eigen::Vector2d k1 = rate(t, y), k2 = rate(t + h / 2, y + h / 2 * k1),
                          k3 = rate(t + h / 2, y + h / 2 * k2), k4 = rate(t + h, y + h * k3);
    y += h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  CHECK(state.q.segment<2>(3).norm() == Approx(y[0]).epsilon(1e-9));
}

namespace {

/// Three blocks that rub on each other and on the ground, tied by springs and pushed.
Mechanism random_scene(std::mt19937& random, double creep) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  Mechanism of = level(1.0);
  int on = ground;
  for (const char* name : {"low", "middle", "high"}) {
    const Friction friction{between(0.1, 0.4), between(0.0, 2.0), creep, 0.0};
    on = add_block(of, name, between(1.0, 4.0), friction, 0.0, between(-1.0, 1.0), on);
    of.forces.push_back(
        {name, spring_between({on, {0.0, 0.0}}, {ground, {-3.0, 0.0}}, between(20.0, 200.0), 3.0)});
  }
  PointForce push;
  push.at = {on, {0.0, 0.0}};
  push.size = HarmonicDriver{0.0, between(5.0, 30.0), between(4.0, 12.0), between(0.0, 6.0)};
  of.forces.push_back({"push", push});
  return of;
}

}  // namespace

TEST_CASE("friction takes the energy that is lost, whatever sticks on the way") {
  // Gauss's rule of eight points on parts of what lies between two changes.
  constexpr double x[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                          0.9602898564975363};
  constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                               0.1012285362903763};
  std::mt19937 random(7);
  for (int scene = 0; scene < 4; ++scene) {
    CAPTURE(scene);
    const Mechanism of = random_scene(random, 0.0);
    const auto energy = [&](const State& state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < of.bodies.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(3 * i);
        sum += 0.5 * of.bodies[i].mass * state.v.segment<2>(k).squaredNorm();
        const double stretch =
            std::get<Spring>(of.forces[i].kind).stiffness * state.q[k] * state.q[k];
        sum += 0.5 * stretch;
      }
      return sum;
    };
    const std::vector<FrictionContact> contacts = friction_contacts_of(of);
    // Of friction and of the push.
    const auto power = [&](const State& state) {
      double sum = 0.0;
      for (std::size_t j = 0; j < contacts.size(); ++j)
        sum += state.friction[static_cast<Eigen::Index>(j)] *
               sliding_velocity_of(contacts[j], state.q, state.v);
      const auto& push = std::get<PointForce>(of.forces.back().kind);
      return sum + driver_at(push.size, state.time).value * state.v[6];
    };
    FreeSolver first(of), solver(of);
    const State start = begin(first, of);
    const State end = first.advance(1.0, start);
    std::vector<double> borders{0.0};
    for (const SlipChange& change : first.slip_changes()) borders.push_back(change.time);
    borders.push_back(1.0);
    double work = 0.0;
    State state = start;
    for (std::size_t i = 1; i < borders.size(); ++i) {
      constexpr int parts = 4;
      for (int part = 0; part < parts; ++part) {
        const double half = 0.5 * (borders[i] - borders[i - 1]) / parts;
        const double middle = borders[i - 1] + (2 * part + 1) * half;
        for (int p = -4; p <= 4; ++p) {
          if (p == 0) continue;
          const auto node = static_cast<std::size_t>(std::abs(p) - 1);
          state = solver.advance(middle + (p < 0 ? -x[node] : x[node]) * half, state);
          work += weight[node] * half * power(state);
        }
      }
    }
    // Nodes of a half are not in the order of time: p from -4 to 4 is.
    CHECK(energy(end) - energy(start) == Approx(work).margin(1e-8 * (energy(start) + 1.0)));
  }
}

TEST_CASE("the smoothed law goes over into sticking with its creep velocity") {
  std::mt19937 random(11);
  for (int scene = 0; scene < 10; ++scene) {
    CAPTURE(scene);
    const std::mt19937 same = random;
    const auto end_of = [&](double creep) {
      random = same;
      const Mechanism of = random_scene(random, creep);
      FreeSolver solver(of);
      return solver.advance(1.0, begin(solver, of)).q;
    };
    const Eigen::VectorXd sticks = end_of(0.0);
    const double coarse = (end_of(2e-3) - sticks).lpNorm<Eigen::Infinity>();
    const double fine = (end_of(2e-4) - sticks).lpNorm<Eigen::Infinity>();
    // First order: a tenth.
    CHECK(coarse < 0.02);
    CHECK(fine < 0.2 * coarse);
  }
}

TEST_CASE("contacts that stick beside each other are refused, and each alone is not") {
  // A carriage on two rails that are one: how they share its friction is not known.
  Mechanism of = level(1.0);
  boxbeam::Body carriage;
  carriage.name = "carriage";
  carriage.mass = 3.0;
  carriage.inertia = 1.0;
  carriage.start_velocity = {1.0, 0.0, 0.0};
  of.bodies = {carriage};
  PinInSlot front, rear;
  front.point = {0, {0.5, 0.0}};
  rear.point = {0, {-0.5, 0.0}};
  front.friction = rear.friction = dry(0.2);
  of.joints = {{"front", front}, {"rear", rear}};
  CHECK_THAT(failure_of(of, 0.1), Catch::Equals(""));  // both slide
  CHECK_THAT(failure_of(of, 1.0),
             Catch::Contains("hold the same movement") && Catch::Contains("front, joint rear"));
  std::get<PinInSlot>(of.joints[1].kind).friction = {};
  CHECK_THAT(failure_of(of, 1.0), Catch::Equals(""));
}

TEST_CASE("instants of a motion stand closer to each other nowhere for contacts that stick") {
  // What jumps where a contact sticks is known: the block of den Hartog's needs few instants.
  Mechanism of = level(2.0);
  const int block = add_block(of, "block", 4.0, dry(0.2), 0.1, 0.0);
  of.forces = {{"spring", spring_between({block, {0.0, 0.0}}, {ground, {-2.0, 0.0}}, 900.0, 2.0)}};
  const Motion motion = solve_motion(of);
  CHECK(motion.slip_changes.size() == 6);
  CHECK(motion.states.size() <= 768);
  StateFinder finder(of, motion);
  CHECK(finder.at(1.9).friction[0] == Approx(900.0 * motion.end.q[0]).epsilon(1e-9));
}

}  // namespace sticking_motion_test
