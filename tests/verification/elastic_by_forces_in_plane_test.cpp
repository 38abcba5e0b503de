// Vibration of an arm of the plane that forces move, and under cables that come and go, against
// ordinary finite elements, the same mechanism in space and what must hold in every motion.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/apart.hpp"
#include "support/hub_and_arm.hpp"
#include "support/space_elements.hpp"

namespace elastic_by_forces_in_plane_test {

using namespace boxbeam;
using namespace test::apart;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double g = 9.81;

/// A case of the plane whose rigid bodies have moved.
struct MovedInPlane {
  explicit MovedInPlane(const std::string& text)
      : project(parse_project("arm.toml", text)), runs(run_situations(project)) {}

  const LoadHistory& rigid() const { return runs.front().loads; }
  const planar::Motion& motion() const { return planar_motion_of(runs.front()); }
  ElasticMotion by(std::size_t modes, int parts) const {
    return {{&planar_in(project, *runs.front().situation), &motion(), &project.beam,
             [this](Time time) { return rigid().loads_at(time); }},
            elastic_body_of(project, parts),
            modes};
  }

  Project project;
  std::deque<SituationRun> runs;
};

/// What holds a place of the arm up from a height on: a stop or a spring under it, a cable above.
struct Support {
  double s = 0.0;          ///< along the arm [m]
  double stiffness = 0.0;  ///< [N/m]
  double height = 0.0;     ///< [m]
  bool both_ways = false, from_above = false;
  double damping = 0.0;  ///< [N s/m]
};

/// An arm of 4 m, a box, clamped to a hub that moves up and down, with a load beside its tip.
struct Arm {
  double hub = 300.0, load = 30.0, inertia = 1.0;  ///< [kg, kg m^2]
  Vector2d centre{0.1, -0.2};
  double start = 0.0, rate = 0.0;  ///< of the hub [m, m/s]
  std::vector<Support> supports = {};
  std::string driver = "", more = "";
  double duration = 1.0;  ///< [s]
  /// A motion of the hub that repeats, in the place of forces [m, Hz].
  struct Shaken {
    double amplitude = 0.0, frequency = 0.0;
  };
  std::optional<Shaken> shaken = {};

  std::string beam() const {
    return R"(
[sections.arm]
kind = "box"
width = "120 mm"
height = "160 mm"
flange = "8 mm"
web = "6 mm"
[[beam.segments]]
length = "4 m"
section = "arm"
[material]
steel = "S355"
[strength]
required = 1.0
)" + more;
  }
  /// `moved`: which coordinate of the hub a driver moves.
  std::string motion(const std::string& moved) const {
    if (shaken)
      return fmt::format(
          "[drivers.shaking]\n{}\nkind = \"harmonic\"\nmean = \"0 m\"\namplitude = \"{:.15g} "
          "m\"\nfrequency = \"{:.15g} Hz\"\n",
          moved, shaken->amplitude, shaken->frequency);
    return driver.empty() ? fmt::format("[motion]\nduration = \"{:.15g} s\"\n", duration) : driver;
  }
  /// `place`: of a point by its way along and its height.
  template <class Place>
  std::string forces(const Place& place) const {
    std::string text;
    int number = 0;
    for (const Support& of : supports) {
      constexpr double rod = 2.0;
      ++number;
      const std::string at = of.s == 0.0 ? "hub.o" : fmt::format("arm.at{}", number);
      text +=
          fmt::format(R"([forces.support{}]
kind = "spring"
connect = ["ground", "{}"]
at = {}
stiffness = "{:.15g} N/m"
free_length = "{:.15g} m"
damping = "{:.15g} N s/m"
acts = "{}"
)",
                      number, at, place(of.s, of.from_above ? of.height + rod : of.height - rod),
                      of.stiffness, rod, of.damping,
                      of.both_ways    ? "both ways"
                      : of.from_above ? "pulling"
                                      : "pushing");
    }
    return text;
  }
  /// What supports take hold of, behind other points.
  template <class Place>
  std::string held_points(const Place& place) const {
    std::string text;
    int number = 0;
    for (const Support& of : supports)
      text += fmt::format(", at{} = {}", ++number, place(of.s, 0.0));
    return text;
  }

  MovedInPlane in_plane() const {
    const auto place = [](double along, double up) {
      return fmt::format("[\"{:.15g} m\", \"{:.15g} m\"]", along, up);
    };
    const auto sketch = [&](double along) {
      return fmt::format(
          "{{ at = {}, angle = \"0 deg\", velocity = [\"0 m/s\", \"{:.15g} m/s\"] }}",
          place(along, start), rate);
    };
    return MovedInPlane(fmt::format(R"([case]
name = "arm"
kind = "planar"
[mechanism]
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[bodies.hub]
mass = "{:.15g} kg"
inertia = "1 kg m^2"
points = {{ o = ["0 m", "0 m"] }}
sketch = {}
[bodies.arm]
points = {{ heel = {}, tip = {}{} }}
sketch = {}
[bodies.load]
mass = "{:.15g} kg"
inertia = "{:.15g} kg m^2"
centre = {}
points = {{ c = ["0 m", "0 m"] }}
sketch = {}
[joints.fall]
kind = "slider"
point = "hub.o"
through = ["0 m", "0 m"]
direction = "90 deg"
[joints.root]
kind = "rigid"
connect = ["hub.o", "arm.heel"]
[joints.tip]
kind = "rigid"
connect = ["arm.tip", "load.c"]
)",
                                    hub, sketch(0.0), place(0.0, 0.0), place(4.0, 0.0),
                                    held_points(place), sketch(0.0), load, inertia,
                                    place(centre.x(), centre.y()), sketch(4.0)) +
                        forces(place) + motion("point = \"hub.o\"\ncoordinate = \"y\"") +
                        "[beam]\nbody = \"arm\"\ndensity = \"7850 kg/m^3\"\n" + beam());
  }

  test::space_arm::Moved in_space() const {
    const auto place = [](double along, double up) {
      return fmt::format("[\"{:.15g} m\", \"0 m\", \"{:.15g} m\"]", along, up);
    };
    const test::hub_and_arm::HubAndArm of{
        hub, load, {centre.x(), 0.0, centre.y()}, {1.0, inertia, 1.5}, start, rate};
    return test::space_arm::Moved(of.text(forces(place) + motion("joint = \"fall\""),
                                          shaken.has_value(), held_points(place), more));
  }
};

/// The same by sixty ordinary elements, of which the heel moves up and down alone: 25 of its modes
/// without supports, by Runge and Kutta, the others as they follow statically. Of a hub that is
/// driven they are of the arm on it.
///
///     q'' + w^2 q = -(g + z_0'') by mass + sum of support max(0, k (h - y) - c y'), y < h
class ArmElements {
 public:
  using Lift = std::function<double(double time, int rate)>;

  ArmElements(const TaperedBeam& beam, const Arm& of, Lift driven = {})
      : of_(of),
        driven_(std::move(driven)),
        whole_(
            test::space_elements::assembled(beam, of.load, {of.centre.x(), 0.0, of.centre.y()},
                                            Eigen::Vector3d(1.0, of.inertia, 1.5).asDiagonal())) {
    whole_.M(2, 2) += of.hub;
    h_ = beam.length().value() / 60.0;
    element_ = test::space_elements::element(section_at(beam, {si<Length>(0.5 * h_)}), h_,
                                             beam.density.value());
    // Along, up and turning.
    for (Index i = 0; i < whole_.M.rows(); ++i)
      if (i % 2 == 0 && i != 0 && i != 4 && !(driven_ && i == 2)) free_.push_back(i);
    up_ = VectorXd::Zero(whole_.M.rows());
    for (Index i = 2; i < up_.size(); i += 6) up_[i] = 1.0;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(whole_.K(free_, free_),
                                                                    whole_.M(free_, free_));
    squares_ = solver.eigenvalues().cwiseMax(0.0);
    shapes_ = MatrixXd::Zero(up_.size(), squares_.size());
    for (std::size_t i = 0; i < free_.size(); ++i)
      shapes_.row(free_[i]) = solver.eigenvectors().row(static_cast<Index>(i));
    by_mass_ = shapes_.transpose() * whole_.M * up_;
  }

  /// At equal steps the moment at a node [N m], the heights of all supports' places [m].
  struct Instant {
    double time = 0.0, moment = 0.0;
    VectorXd heights;
  };
  std::vector<Instant> moved(double length, Index node, Index steps, Index every) const {
    const double h = length / static_cast<double>(steps);
    const auto count_of = static_cast<Index>(of_.supports.size());
    MatrixXd places(count_of, squares_.size());
    for (Index k = 0; k < count_of; ++k) {
      const auto at =
          static_cast<Index>(std::lround(of_.supports[static_cast<std::size_t>(k)].s / h_));
      places.row(k) = shapes_.row(6 * at + 2);
    }
    const auto lift = [&](double t, int rate) { return driven_ ? driven_(t, rate) : 0.0; };
    const auto forces_at = [&](double t, const VectorXd& q, const VectorXd& v,
                               Index modes) -> VectorXd {
      VectorXd sum = -(g + lift(t, 2)) * by_mass_.head(modes);
      for (Index k = 0; k < count_of; ++k) {
        const Support& of = of_.supports[static_cast<std::size_t>(k)];
        const double below = of.height - lift(t, 0) - places.row(k).head(count).dot(q);
        const double sinking = -lift(t, 1) - places.row(k).head(count).dot(v);
        double force = of.stiffness * below + of.damping * sinking;
        if (!of.both_ways) force = below > 0.0 ? std::max(0.0, force) : 0.0;
        sum += force * places.row(k).head(modes).transpose();
      }
      return sum;
    };
    const auto acceleration_at = [&](double t, const VectorXd& q, const VectorXd& v) -> VectorXd {
      return forces_at(t, q, v, count) - squares_.head(count).cwiseProduct(q);
    };
    const Index others = squares_.size() - count;
    VectorXd q = VectorXd::Zero(count), speed = q;
    if (driven_) {
      // At rest under its weight.
      q = -g * by_mass_.head(count).cwiseQuotient(squares_.head(count));
    } else {
      q = of_.start * by_mass_.head(count);
      speed = of_.rate * by_mass_.head(count);
    }
    std::vector<Instant> instants;
    for (Index i = 0; i <= steps; ++i) {
      const double t = h * static_cast<double>(i);
      const VectorXd a = acceleration_at(t, q, speed);
      if (i % every == 0) {
        const VectorXd follows = forces_at(t, q, speed, squares_.size())
                                     .tail(others)
                                     .cwiseQuotient(squares_.tail(others)),
                       y = shapes_.leftCols(count) * q + shapes_.rightCols(others) * follows,
                       moving = shapes_.leftCols(count) * a + lift(t, 2) * up_;
        instants.push_back({t, moment_at(node, y, moving),
                            places.leftCols(count) * q + lift(t, 0) * VectorXd::Ones(count_of)});
      }
      const VectorXd v_b = speed + 0.5 * h * a,
                     b = acceleration_at(t + 0.5 * h, q + 0.5 * h * speed, v_b),
                     v_c = speed + 0.5 * h * b,
                     c = acceleration_at(t + 0.5 * h, q + 0.5 * h * v_b, v_c), v_d = speed + h * c,
                     d = acceleration_at(t + h, q + h * v_c, v_d);
      q += h / 6.0 * (speed + 2.0 * v_b + 2.0 * v_c + v_d);
      speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return instants;
  }
  double station(Index node) const { return static_cast<double>(node) * h_; }

 private:
  static constexpr Index count = 25;

  double moment_at(Index node, const VectorXd& y, const VectorXd& acceleration) const {
    const VectorXd ends = y.segment<12>(6 * node);
    const VectorXd moving = (acceleration + g * up_).segment<12>(6 * node);
    return -(element_.K * ends + element_.M * moving)[4];
  }

  Arm of_;
  Lift driven_;
  test::space_elements::Assembled whole_;
  test::space_elements::Element element_;
  double h_ = 0.0;
  std::vector<Index> free_;
  VectorXd up_, squares_, by_mass_;
  MatrixXd shapes_;
};

constexpr Index node = 15;

/// Of modes in the plane from those in space, at a place of the arm. `size`: of what acts [N].
Apart apart_from_space(const Arm& arm, double s = 1.0, double size = 1e3) {
  const MovedInPlane plane = arm.in_plane();
  const test::space_arm::Moved space = arm.in_space();
  REQUIRE(plane.rigid().closed() == arm.shaken.has_value());
  const ElasticMotion elastic = plane.by(5, 24);
  // Those out of the plane and of torsion as well, which nothing moves.
  const ElasticMotionInSpace expected = space.by(12, 24);
  const double duration = arm.shaken ? 1.0 / arm.shaken->frequency : arm.duration;
  Apart apart;
  for (int i = 0; i <= 300; ++i) {
    const Time time = si<Time>(duration * i / 300.0);
    const BeamLoads loads = elastic.loads_at(time);
    CHECK(unbalanced(loads, 4.0, size) < 1e-9);
    apart.add(bending(expected.loads_at(time), s), bending(loads, s),
              bending(plane.rigid().loads_at(time), s));
  }
  return apart;
}

}  // namespace

TEST_CASE("an arm that bounces on a spring or a stop of the plane vibrates as in space",
          "[elastic_by_forces_in_plane]") {
  Arm bouncing;
  bouncing.supports = {{0.0, 2e5, 0.0, true}};
  bouncing.start = 0.03;
  bouncing.rate = -0.4;
  Arm stopped;
  stopped.supports = {{0.0, 2.1e5, 0.0}};
  stopped.start = 0.05;
  stopped.duration = 0.5;
  for (const Arm& arm : {bouncing, stopped}) {
    const Apart apart = apart_from_space(arm);
    INFO("largest " << apart.largest << ", apart " << apart.found << ", of rigid bodies "
                    << apart.rigid);
    CHECK(apart.found < 1e-3 * apart.largest);
    CHECK(apart.rigid > 0.1 * apart.largest);
  }
}

// Below the hub dampers bear in series with the arm, elsewhere beside it. Without a spring the arm
// falls: then of a damper's force what is free bears its part. In space they are held against
// elements (elastic_by_forces_test).
TEST_CASE("dampers beside an arm of the plane act where they are, as in space",
          "[elastic_by_forces_in_plane]") {
  const Support at_hub{0.0, 2e5, 0.0, true, false, 4e3}, at_tip{4.0, 1.0, 0.0, true, false, 1.5e3},
      stiff_at_tip{4.0, 4e5, 0.0, true, false, 3e3}, between{1.6, 1.0, 0.0, true, false, 2e3};
  for (const std::vector<Support>& supports :
       {std::vector{at_hub}, {at_tip}, {stiff_at_tip}, {at_hub, at_tip}, {between, at_tip}}) {
    for (const bool shaken : {false, true}) {
      Arm arm;
      arm.supports = supports;
      arm.rate = shaken ? 0.0 : -0.5;
      arm.duration = 0.8;
      if (shaken) arm.shaken = {0.01, 5.0};
      const double s = shaken ? 3.0 : 1.0;
      // The weight of hub, arm and load.
      const Apart apart = apart_from_space(arm, s, 4.4e3);
      INFO("first at " << supports.front().s << " of " << supports.size() << ", shaken " << shaken
                       << ", s " << s << ": largest " << apart.largest << ", apart " << apart.found
                       << ", of rigid bodies " << apart.rigid);
      CHECK(apart.found < 5e-3 * apart.largest);
      CHECK(apart.rigid > 5.0 * apart.found);
    }
  }
}

// Elements know when vibration itself touches what is there: a second order of how far it is
// elsewhere by how far it is pressed.
TEST_CASE("an arm that falls onto a stop or into a cable of the plane does what elements do",
          "[elastic_by_forces_in_plane]") {
  Arm stopped;
  stopped.hub = 3000.0;
  stopped.supports = {{0.0, 2.1e6, 0.0}};
  stopped.start = 0.05;
  stopped.duration = 0.5;
  Arm caught;
  caught.supports = {{1.6, 4e4, 0.0, false, true}};
  caught.start = 0.05;
  caught.duration = 0.7;
  // Damped, it lets go while its place still comes up. When it is touched again, which vibration
  // makes earlier or later, its force is there at once.
  Arm damped = stopped;
  damped.supports.front().damping = 3e4;
  damped.duration = 0.28;
  for (const Arm& arm : {stopped, caught, damped}) {
    const MovedInPlane moved = arm.in_plane();
    REQUIRE_FALSE(moved.motion().changes.empty());
    const ElasticMotion elastic = moved.by(5, 16);
    const ArmElements elements(moved.project.beam, arm);
    bool lets_go = false;
    planar::StatesAround states(planar_of(moved.project), moved.motion());
    Apart apart;
    double pressed = 0.0, elsewhere = 0.0;
    for (const auto& [time, moment, heights] : elements.moved(arm.duration, node, 70000, 175)) {
      const BeamLoads loads = elastic.loads_at(si<Time>(time));
      CHECK(unbalanced(loads, 4.0, 1e3) < 1e-9);
      apart.add(moment, bending(loads, elements.station(node)),
                bending(moved.rigid().loads_at(si<Time>(time)), elements.station(node)));
      const planar::State state = states.at(time);
      const double z = state.q[1];
      lets_go = lets_go || (z < 0.0 && !planar::spring_in(planar_of(moved.project), state, 0));
      pressed = std::max(pressed, arm.supports.front().height - z);
      elsewhere = std::max(elsewhere, std::abs(heights[0] - z));
    }
    CHECK(lets_go == (arm.supports.front().damping > 0.0));
    const double second_order = std::pow(elsewhere / pressed, 2);
    INFO("largest " << apart.largest << ", apart " << apart.found << ", of rigid bodies "
                    << apart.rigid << ", second order " << second_order);
    CHECK(apart.found < (5e-3 + 3.0 * second_order) * apart.largest);
    CHECK(apart.rigid > 0.1 * apart.largest);
  }
}

// The hub is let down once, from rest to rest; half-way a cable takes hold of the arm at 2 m.
TEST_CASE("a driven arm that a cable begins to hold does what elements do",
          "[elastic_by_forces_in_plane]") {
  Arm lowered;
  lowered.driver = R"([drivers.lowering]
point = "hub.o"
coordinate = "y"
kind = "smooth step"
from = "0.3 m"
to = "0 m"
end = "0.6 s"
)";
  lowered.start = 0.3;
  lowered.supports = {{2.0, 4e4, 0.15, false, true}};
  const MovedInPlane moved = lowered.in_plane();
  REQUIRE_FALSE(moved.motion().closed);
  REQUIRE(moved.motion().changes.size() == 1);
  const ElasticMotion elastic = moved.by(5, 16);
  REQUIRE(elastic.transient());
  const StepDriver step{0.3, 0.0, 0.0, 0.6};
  const ArmElements elements(moved.project.beam, lowered, [&](double t, int rate) {
    const DriverState at = driver_at(step, std::min(t, 0.6));
    if (rate == 0) return at.value;
    if (t >= 0.6) return 0.0;
    return rate == 1 ? at.rate : at.acceleration;
  });
  const double watched = elastic.transient()->times().back();
  CHECK(watched > 0.65);
  Apart apart;
  for (const auto& [time, moment, heights] : elements.moved(watched, node, 80000, 200)) {
    const BeamLoads loads = elastic.loads_at(si<Time>(time));
    CHECK(unbalanced(loads, 4.0, 1e3) < 1e-9);
    apart.add(moment, bending(loads, elements.station(node)),
              bending(moved.rigid().loads_at(si<Time>(time)), elements.station(node)));
  }
  INFO("largest " << apart.largest << ", apart " << apart.found << ", of rigid bodies "
                  << apart.rigid);
  CHECK(apart.found < 5e-3 * apart.largest);
  CHECK(apart.rigid > 0.05 * apart.largest);
}

TEST_CASE("cases of the plane that forces move are verified with modes of their beam",
          "[elastic_by_forces_in_plane]") {
  Arm arm;
  arm.hub = 3000.0;
  arm.supports = {{0.0, 2.1e6, 0.0}};
  arm.start = 0.05;
  arm.duration = 0.3;
  arm.more = "[model]\ndamping = { ratio = 0.02, at = \"8 Hz\" }\n";
  const Project project = arm.in_plane().project;
  const ModelChoice choice = choose_model(project);
  INFO(choice.reason);
  CHECK(choice.chosen.level == ModelLevel::modal);
  REQUIRE(choice.weighed.back().found);
  CHECK(*choice.weighed.back().found < choice.tolerance);
  CHECK(choice.weighed.front().error > 0.1);
}

}  // namespace elastic_by_forces_in_plane_test
