// The drill truck against an independent model of Timoshenko finite elements (tests/support), whose
// data stand here once more. Source of the mechanism: Wojnarowski, Wojciech, Płosa, Płoski,
// Mechanika 85 (1987); it prints no numbers.

#include <array>

#include "boxbeam/verification/flexible_motion_result.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/timoshenko_frame.hpp"

namespace drill_truck_test {

using namespace boxbeam;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double E = 2.1e11, G = 8.1e10, density = 7850.0;
constexpr double pi = std::numbers::pi;
constexpr double slope = 25.0 * pi / 180.0;  // of boom and telescope
const Vector2d gravity(0.0, -9.81);

/// A box: height x width x plate.
test::FrameMember box(double height, double width, double t, double extra_mass) {
  const double inner_height = height - 2.0 * t, inner_width = width - 2.0 * t;
  const double area = height * width - inner_height * inner_width;
  test::FrameMember member;
  member.EA = E * area;
  member.GA = G * 2.0 * t * height;
  member.EI = E * (width * std::pow(height, 3) - inner_width * std::pow(inner_height, 3)) / 12.0;
  member.mass = density * area + extra_mass;
  return member;
}

Vector2d along(const test::FrameMember& of, double s, double offset) {
  return of.origin + Eigen::Rotation2Dd(of.angle) * Vector2d(s, offset);
}

test::FrameMember strut(const Vector2d& from, const Vector2d& to, double mass) {
  test::FrameMember member;
  member.kind = test::FrameKind::axial;
  member.origin = from;
  member.angle = std::atan2(to.y() - from.y(), to.x() - from.x());
  member.length = (to - from).norm();
  member.EA = 1.2e8;
  member.GA = member.EI = 1.0;  // rigid in bending, whatever it is
  member.mass = mass;
  return member;
}

/// The truck with booms of one kind.
test::TimoshenkoFrame truck(test::FrameKind kind, int elements) {
  test::FrameMember boom = box(0.300, 0.220, 0.010, 0.0);
  boom.origin = {0.9, 1.7};
  boom.angle = slope;
  boom.length = 4.2;
  boom.places = {1.5, 2.6};
  test::FrameMember telescope = box(0.260, 0.180, 0.010, 0.0);
  telescope.origin = along(boom, 2.6, 0.0);
  telescope.angle = slope;
  telescope.length = 4.0;
  telescope.places = {1.6, 2.8};
  test::FrameMember feed = box(0.240, 0.160, 0.008, 60.0);
  feed.origin = along(telescope, 4.0, 0.0) - Vector2d(1.5, 0.0);
  feed.length = 5.0;
  feed.places = {1.5, 2.7};
  for (test::FrameMember* member : {&boom, &telescope, &feed}) member->kind = kind;
  const test::FrameMember lift = strut({1.5, 1.0}, along(boom, 1.5, -0.15), 40.0);
  const test::FrameMember tilt = strut(along(telescope, 2.8, -0.25), along(feed, 2.7, -0.2), 25.0);

  test::TimoshenkoFrame frame(elements);
  const int chassis_ = frame.add_body({0.0, 0.0}, 9000.0, 18000.0, {0.0, 1.0});
  const int boom_ = frame.add_member(boom);
  const int telescope_ = frame.add_member(telescope);
  const int lift_ = frame.add_member(lift);
  const int feed_ = frame.add_member(feed);
  const int tilt_ = frame.add_member(tilt);
  const auto chassis = [&](double x, double y) { return test::FramePlace{chassis_, x, y}; };
  constexpr double c = 3e8;
  frame.add_joint("front_axle", chassis(-1.6, 0.5), {}, 0.0, 5e6, 4e6);
  frame.add_joint("rear_axle", chassis(1.4, 0.5), {}, 0.0, 0.0, 4e6);
  frame.add_joint("w1", chassis(0.9, 1.7), {boom_, 0.0, 0.0}, 0.0, c, c);
  frame.add_joint("w2", chassis(1.5, 1.0), {lift_, 0.0, 0.0}, 0.0, c, c);
  frame.add_joint("w5", {lift_, lift.length, 0.0}, {boom_, 1.5, -0.15}, 0.0, c, c);
  frame.add_joint("w8", {telescope_, 4.0, 0.0}, {feed_, 1.5, 0.0}, 0.0, c, c);
  frame.add_joint("w6", {telescope_, 2.8, -0.25}, {tilt_, 0.0, 0.0}, 0.0, c, c);
  frame.add_joint("w7", {tilt_, tilt.length, 0.0}, {feed_, 2.7, -0.2}, 0.0, c, c);
  frame.add_joint("P2", {boom_, 2.6, 0.0}, {telescope_, 0.0, 0.0}, slope, 1e8, 2e8);
  frame.add_joint("P1", {boom_, 4.2, 0.0}, {telescope_, 1.6, 0.0}, slope, 0.0, 2e8);
  frame.add_load({feed_, 5.0, 0.0}, {-12000.0, -3000.0, 0.0}, {4000.0, 1500.0, 500.0});
  return frame;
}

constexpr std::array joints{"front_axle", "rear_axle", "w1", "w2", "w5",
                            "w6",         "w7",        "w8", "P1", "P2"};
/// Joints on whose second link, the boom, the program gives the force.
bool turned(const std::string& joint) { return joint == "w1" || joint == "w5"; }

Project shipped(const std::string& kind, std::vector<std::string> further = {}) {
  for (const char* link : {"boom", "telescope", "feed"}) {
    further.push_back("links." + std::string(link) + ".kind=" + kind);
  }
  return read_project(test::project_file("sections/drill-truck/truck.toml"), further);
}

const JointVibration& joint_of(const FlexibleMotionResult& motion, const std::string& name) {
  const auto found = std::find_if(motion.joints.begin(), motion.joints.end(),
                                  [&](const JointVibration& joint) { return joint.name == name; });
  REQUIRE(found != motion.joints.end());
  return *found;
}

const std::array kinds{std::pair{"bending", test::FrameKind::bending},
                       std::pair{"full", test::FrameKind::full}};

}  // namespace

TEST_CASE("the comparison model itself: analytic frequencies, and static by hand", "[flexible]") {
  // A pinned beam on rigid supports nearly, EI = mu = L = 1, without shear: (n pi)^2/(2 pi).
  test::FrameMember member;
  member.EA = 1e6;
  member.EI = member.mass = member.length = 1.0;
  member.GA = 1e9;
  test::TimoshenkoFrame frame(16);
  const int beam = frame.add_member(member);
  frame.add_joint("start", {beam, 0.0, 0.0}, {}, 0.0, 1e9, 1e9);
  frame.add_joint("end", {beam, 1.0, 0.0}, {}, 0.0, 0.0, 1e9);
  frame.add_load({beam, 0.25, 0.0}, {0.0, -4.0, 0.0}, {0.0, 0.0, 0.0});
  const auto frequencies = frame.frequencies(3);
  for (int n = 1; n <= 3; ++n) {
    CHECK(frequencies[static_cast<std::size_t>(n - 1)] == Approx(n * n * pi / 2.0).epsilon(1e-4));
  }
  const auto statics = frame.statics({0.0, -10.0});
  CHECK(statics.of("start").y() == Approx(5.0 + 3.0).epsilon(1e-6));
  CHECK(statics.of("end").y() == Approx(5.0 + 1.0).epsilon(1e-6));
}

TEST_CASE("drill truck: static reactions as in the independent model", "[flexible]") {
  for (const auto& [name, kind] : kinds) {
    INFO(name);
    const auto statics = truck(kind, 8).statics(gravity);
    const FlexibleMotionResult motion = flexible_motion_of(shipped(name));
    double size = 0.0;
    for (const char* joint : joints) size = std::max(size, statics.of(joint).norm());
    for (const char* joint : joints) {
      INFO(joint);
      const Vector2d force = joint_of(motion, joint).force.constant.head<2>();
      const Vector2d expected = (turned(joint) ? -1.0 : 1.0) * statics.of(joint);
      CHECK((force - expected).norm() < 1e-6 * size);
    }
    // By hand: the axles carry all weight and the drill's constant force.
    const double lift = std::hypot(0.9 + 1.5 * std::cos(slope) + 0.15 * std::sin(slope) - 1.5,
                                   1.7 + 1.5 * std::sin(slope) - 0.15 * std::cos(slope) - 1.0);
    const double tilt = std::hypot(1.2 + 1.2 * std::cos(slope) - 0.25 * std::sin(slope),
                                   -0.2 + 1.2 * std::sin(slope) + 0.25 * std::cos(slope));
    const double area_boom = 0.3 * 0.22 - 0.28 * 0.2;
    const double area_telescope = 0.26 * 0.18 - 0.24 * 0.16;
    const double area_feed = 0.24 * 0.16 - 0.224 * 0.144;
    const double mass = 9000.0 + density * (4.2 * area_boom + 4.0 * area_telescope) +
                        5.0 * (density * area_feed + 60.0) + 40.0 * lift + 25.0 * tilt;
    const Vector3d front = joint_of(motion, "front_axle").force.constant;
    const Vector3d rear = joint_of(motion, "rear_axle").force.constant;
    CHECK(front.x() + rear.x() == Approx(12000.0).epsilon(1e-10));
    CHECK(front.y() + rear.y() == Approx(9.81 * mass + 3000.0).epsilon(1e-10));
  }
}

TEST_CASE("drill truck: where a sliding contact is does not change what the ground carries",
          "[flexible]") {
  // The named point of the telescope stands anywhere along it: the contact is at the boom's end.
  const auto with = [](const std::string& place) {
    return flexible_motion_of(
        shipped("bending", {"links.telescope.points.sleeve=[\"" + place + "\", \"0 m\"]"}));
  };
  const FlexibleMotionResult there = with("1.6 m"), elsewhere = with("0.4 m");
  for (const char* axle : {"front_axle", "rear_axle"}) {
    const Vector3d force = joint_of(there, axle).force.constant;
    CHECK((joint_of(elsewhere, axle).force.constant - force).norm() < 1e-9 * force.norm());
  }
}

TEST_CASE("drill truck: frequencies and 25 Hz amplitudes are as near as the program says",
          "[flexible]") {
  for (const auto& [name, kind] : kinds) {
    INFO(name);
    const test::TimoshenkoFrame coarse = truck(kind, 16), fine = truck(kind, 32);
    const FlexibleMotionResult motion = flexible_motion_of(shipped(name));
    const auto frequencies = fine.frequencies(8), before = coarse.frequencies(8);
    REQUIRE(motion.frequencies.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
      const NaturalFrequency& of = motion.frequencies[i];
      INFO("frequency " << i + 1 << ": " << of.frequency << " stated " << of.error.error
                        << ", expected " << frequencies[i] << ", there " << before[i]);
      const double own = std::abs(frequencies[i] - before[i]);
      CHECK(own < 1e-4 * frequencies[i]);
      CHECK(std::abs(of.frequency - frequencies[i]) <= of.error.error + own);
      CHECK(of.error.error < 0.02 * of.frequency);  // and it says something
    }
    const auto amplitudes = fine.harmonic(25.0), amplitudes_before = coarse.harmonic(25.0);
    for (const char* joint : joints) {
      const JointVibration& of = joint_of(motion, joint);
      const Vector2d expected = (turned(joint) ? -1.0 : 1.0) * amplitudes.of(joint);
      const double own = (amplitudes.of(joint) - amplitudes_before.of(joint)).norm();
      INFO(joint << ": " << of.force.largest << " stated " << of.force.amplitude_error.error
                 << ", expected " << expected.norm() << ", there " << own);
      CHECK(own < 1e-3 * expected.norm());
      CHECK(of.force.amplitude.imag().norm() == 0.0);
      const Vector2d force = of.force.amplitude.head<2>().real();
      CHECK((force - expected).norm() <= of.force.amplitude_error.error + own);
      CHECK(std::abs(of.force.largest - expected.norm()) <= of.force.amplitude_error.error + own);
      CHECK(of.force.amplitude_error.error < 0.3 * of.force.largest);
    }
  }
}

TEST_CASE("drill truck: booms that stretch along their axes are another mechanism", "[flexible]") {
  // The force in w1 at 25 Hz changes by some 70 %, in both models.
  const double stiff = truck(test::FrameKind::bending, 16).harmonic(25.0).of("w1").norm();
  const double elastic = truck(test::FrameKind::full, 16).harmonic(25.0).of("w1").norm();
  const double expected = elastic / stiff - 1.0;
  INFO(stiff << " N, " << elastic << " N");
  CHECK(std::abs(expected) > 0.5);
  const double found = joint_of(flexible_motion_of(shipped("full")), "w1").force.largest /
                           joint_of(flexible_motion_of(shipped("bending")), "w1").force.largest -
                       1.0;
  CHECK(found == Approx(expected).margin(0.05));
}

TEST_CASE("drill truck: joints within parts leave no order, and the stated error says so",
          "[flexible]") {
  for (const char* element : {"corrected", "classical"}) {
    INFO(element);
    const FlexibleMotionResult motion = flexible_motion_of(
        shipped("bending", {"model.division=equal", "model.element=" + std::string(element)}));
    const auto amplitudes = truck(test::FrameKind::bending, 32).harmonic(25.0);
    int seen = 0;
    for (const char* joint : joints) {
      const JointVibration& of = joint_of(motion, joint);
      const double expected = amplitudes.of(joint).norm();
      INFO(joint << ": " << of.force.largest << " stated " << of.force.amplitude_error.error
                 << ", expected " << expected);
      CHECK(std::abs(of.force.largest - expected) <= of.force.amplitude_error.error);
      seen += of.force.amplitude_error.order ? 1 : 0;
    }
    INFO(seen << " orders seen");
    CHECK(seen < static_cast<int>(joints.size()));
  }
}

}  // namespace drill_truck_test
