// Where rigid finite elements fail in other methods: stiff joints (springs in absolute coordinates
// lose a digit with every power of ten), resonance, masses of very different size, links that are
// free, links of very different stiffness, resonance of a part.

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "catch.hpp"
#include "support/dense_structure.hpp"
#include "support/elastic_beams.hpp"
#include "support/frequency_count.hpp"
#include "support/refusals.hpp"

namespace rigid_elements_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::End;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double frequency_of(double square) { return std::sqrt(square) / (2.0 * std::numbers::pi); }

/// Steel, 2 m long, without shear.
Bar rod() {
  Bar bar = test::steel_bar(2.0, 0.1, 0.05);
  bar.GA = 1e30;
  return bar;
}

double tip(const Structure& structure, const Deformation<double>& of) {
  const Link& last = structure.mechanism->links.back();
  const int index = static_cast<int>(structure.mechanism->links.size()) - 1;
  return motion_at(structure, Attachment{index, {last.length, 0.0}}, of).y();
}

/// The load of unit size across link 0's last element.
LinkColumns<double> at_the_end(const Structure& structure) {
  auto loads = no_loads<double>(structure);
  loads[0](1, loads[0].cols() - 1) = 1.0;
  return loads;
}

struct Against {
  double motion = 0.0, joints = 0.0;  ///< largest difference over the largest entry
};

/// The solver against the dense system in long numbers.
Against against_dense(const Structure& structure, double square, const LinkColumns<double>& loads) {
  const auto dense = test::DenseStructure(structure).solve(square, loads).deformation;
  const auto fast = DynamicStiffness<double>(structure, square, 0.0).solve(loads);
  double size = 0.0;
  Against result;
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const Eigen::Matrix3Xd exact = dense.motion[l].real();
    size = std::max(size, exact.cwiseAbs().maxCoeff());
    result.motion = std::max(result.motion, (fast.motion[l] - exact).cwiseAbs().maxCoeff());
  }
  result.motion /= size;
  const Eigen::Matrix3Xd joints = dense.joints.real();
  result.joints = (fast.joints - joints).cwiseAbs().maxCoeff() / joints.cwiseAbs().maxCoeff();
  return result;
}

/// Square of the first angular frequency.
double first_square(const Structure& structure, double guess) {
  return test::natural_square(structure, 1, guess);
}

}  // namespace

TEST_CASE("joints 1e4 to 1e16 times stiffer than the link: all digits") {
  // Cantilever on a joint at its root: w = P L^3/(3 EI) + P/c_y + P L^2/c_phi; two of them, welded
  // by such a joint in the middle: likewise with P and P L/2 there. Independent of the ratio; K/k =
  // 1e12 leaves three digits to springs in absolute coordinates.
  const Bar bar = rod();
  const double L = bar.L, P = 1e3, own = 3.0 * bar.EI / (L * L * L);
  for (int power = 4; power <= 17; ++power) {
    const double c = power == 17 ? test::infinite : own * std::pow(10.0, power);
    for (const Element element : {Element::classical, Element::corrected}) {
      Mechanism mechanism = test::cantilever_of(bar, 8, element);
      mechanism.joints[0].stiffness = {c, c, c * L * L};
      mechanism.loads = {test::load_at(L, {0.0, P, 0.0})};
      const Structure structure = structure_of(mechanism);
      const double law = element == Element::classical ? 1.0 - 1.0 / 256.0 : 1.0;
      const double exact = P / own * law + P / c + P / c;
      const double w = tip(structure, static_response(structure));
      CAPTURE(power, static_cast<int>(element));
      CHECK(std::abs(w / exact - 1.0) < 20.0 * eps);

      // Cut in the middle.
      Bar half = bar;
      half.L = L / 2.0;
      Mechanism two = test::cantilever_of(half, 4, element);
      two.joints[0].stiffness = {c, c, c * L * L};
      two.links.push_back(two.links[0]);
      two.links[1].name = "second";
      two.links[1].origin = {half.L, 0.0};
      two.joints.push_back(
          {"weld", {0, {half.L, 0.0}}, {1, {0.0, 0.0}}, 0.4, {c, c, c * L * L}, {}});
      two.loads = {{"tip", {1, {half.L, 0.0}}, {0.0, P, 0.0}, {0.0, 0.0, 0.0}, 0.0}};
      const Structure welded = structure_of(two);
      const double sum = exact + P / c + P / (4.0 * c);
      CHECK(std::abs(tip(welded, static_response(welded)) / sum - 1.0) < 20.0 * eps);
    }
  }
}

TEST_CASE("a stiff prop: what it bears keeps its digits though the forces depend on it") {
  // R = (5/16) P L^3/(3 EI) / (L^3/(3 EI) + 1/c) for a load in the middle of a clamped beam.
  const Bar bar = rod();
  const double L = bar.L, P = 1e3, own = 3.0 * bar.EI / (L * L * L);
  for (int power = -4; power <= 17; ++power) {
    const double c = power == 17 ? test::infinite : own * std::pow(10.0, power);
    Mechanism mechanism = test::beam_of(bar, 10, End::clamped, End::pinned, Element::corrected);
    mechanism.joints[1].stiffness = {0.0, c, 0.0};
    mechanism.loads = {test::load_at(L / 2.0, {0.0, -P, 0.0})};
    const Structure structure = structure_of(mechanism);
    const Deformation<double> response = static_response(structure);
    const double R = 5.0 / 16.0 * P / (1.0 + own / c);
    CAPTURE(power);
    CHECK(std::abs(joint_force(structure, 1, response).y() / R - 1.0) < 50.0 * eps);
    CHECK(std::abs(joint_force(structure, 0, response).y() / (P - R) - 1.0) < 50.0 * eps);
  }
}

TEST_CASE("loops of stiff joints: statics and vibration keep their digits") {
  // Two beams, tied to each other at both ends and to the ground; no hand formula, but the dense
  // system in long numbers.
  const Bar bar = rod();
  for (int power = 4; power <= 17; power += 1) {
    const double c =
        power == 17 ? test::infinite : 3.0 * bar.EI / std::pow(bar.L, 3) * std::pow(10.0, power);
    Mechanism mechanism = test::cantilever_of(bar, 6, Element::corrected, LinkKind::full);
    mechanism.joints[0].stiffness = {c, c, c};
    mechanism.links.push_back(mechanism.links[0]);
    mechanism.links[1].origin = {0.3, 0.4};
    mechanism.links[1].angle = 0.2;
    for (const double s : {0.2, 1.7}) {
      const Attachment on{1, {s, 0.0}};
      mechanism.joints.push_back(
          {"tie", test::at_world(mechanism, 0, in_world(mechanism, on)), on, 0.7, {c, c, 0.0}, {}});
    }
    const Structure structure = structure_of(mechanism);
    for (const double square : {0.0, 1e2, 1e4, 1e6}) {
      const Against gap = against_dense(structure, square, at_the_end(structure));
      CAPTURE(power, square);
      CHECK(gap.motion < 1e-11);
      CHECK(gap.joints < 1e-11);
    }
  }
}

TEST_CASE("resonance approached: digits are lost with 1/(1 - r), not more") {
  // A mass on a spring, m omega_1^2 = c exact in binary: F/(c (1 - r^2)).
  Mechanism mechanism;
  mechanism.links.resize(1);
  mechanism.links[0].name = "body";
  mechanism.links[0].kind = LinkKind::rigid;
  mechanism.links[0].rigid = {2.0, {0.0, 0.0}, 1.0};
  mechanism.joints = {test::hold(mechanism, 0.0, {1e9, 512.0, 1e9}, "spring")};
  const Structure structure = structure_of(mechanism);
  const auto load = at_the_end(structure);
  for (int power = 2; power <= 9; ++power) {
    for (const double side : {-1.0, 1.0}) {
      const double square = 256.0 * (1.0 + side * std::pow(10.0, -power));
      const double exact = 1.0 / (512.0 - 2.0 * square);
      const double w = DynamicStiffness<double>(structure, square, 0.0).solve(load).motion[0](1, 0);
      CAPTURE(power, side);
      CHECK(std::abs(w / exact - 1.0) < 4.0 * eps * std::pow(10.0, power));
    }
  }
  // A beam: its own first frequency by counting; against the dense system at the same frequency.
  const Mechanism beam = test::cantilever_of(rod(), 12, Element::corrected);
  const Structure divided = structure_of(beam);
  const double first = first_square(divided, 1.0);
  for (int power = 2; power <= 9; ++power) {
    const double square = first * (1.0 - 2.0 * std::pow(10.0, -power));
    const Against gap = against_dense(divided, square, at_the_end(divided));
    CAPTURE(power, gap.motion);
    CHECK(gap.motion < 100.0 * eps * std::pow(10.0, power));
    CHECK(gap.joints < 100.0 * eps * std::pow(10.0, power));
  }
}

TEST_CASE("an antiresonance, where the load's own place stands still, is no resonance") {
  // The tip of a cantilever near the first frequency of the same beam pinned there as well.
  Mechanism mechanism = test::cantilever_of(test::Bar{}, 16, Element::corrected);
  mechanism.loads = {test::load_at(1.0, Eigen::Vector3d::Zero(), {0.0, 1.0, 0.0})};
  const Structure structure = structure_of(mechanism);
  const auto tip = [&](double frequency) {
    const Eigen::Matrix3Xcd motion = harmonic_response(structure, frequency).motion[0];
    return motion(1, motion.cols() - 1).real() / motion.row(1).cwiseAbs().maxCoeff();
  };
  const double near = std::pow(3.9266023120479188, 2) / (2.0 * std::numbers::pi);
  double low = 0.99 * near, high = 1.01 * near;
  REQUIRE(tip(low) * tip(high) < 0.0);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (tip(middle) * tip(low) > 0.0 ? low : high) = middle;
  }
  CHECK(std::abs(tip(low)) < 1e-10);
}

TEST_CASE("resonance hit without damping is an error that names the frequency; damped it is not") {
  Mechanism mechanism;
  mechanism.links.resize(1);
  mechanism.links[0].name = "body";
  mechanism.links[0].kind = LinkKind::rigid;
  mechanism.links[0].rigid = {2.0, {0.0, 0.0}, 1.0};
  mechanism.joints = {test::hold(mechanism, 0.0, {1e9, 512.0, 1e9}, "spring")};
  mechanism.loads = {test::load_at(0.0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0})};
  mechanism.frequency = frequency_of(256.0);  // 2.54648 Hz
  const auto fails_at = [](const Mechanism& of, const std::string& frequency) {
    try {
      response_of(structure_of(of));
    } catch (const AnalysisError& error) {
      INFO(error.what());
      CHECK(std::string(error.what()).find(frequency) != std::string::npos);
      return true;
    }
    return false;
  };
  CHECK(fails_at(mechanism, "2.54648 Hz"));
  CHECK_THROWS_AS((DynamicStiffness<double>(structure_of(mechanism), 256.0, 0.0)), AnalysisError);
  // Less than a millionth off it is still nothing but that distance.
  mechanism.frequency *= 1.0 + 2e-7;
  CHECK(fails_at(mechanism, "2.54648 Hz"));
  mechanism.frequency *= 1.0 + 2e-5;
  CHECK_FALSE(fails_at(mechanism, ""));
  // A load that does not excite it.
  mechanism.frequency = frequency_of(256.0) * (1.0 + 2e-7);
  mechanism.loads[0].amplitude = {1.0, 0.0, 0.0};
  CHECK_FALSE(fails_at(mechanism, ""));
  // Damped: F/(i omega d) at resonance.
  mechanism.loads[0].amplitude = {0.0, 1.0, 0.0};
  mechanism.frequency = frequency_of(256.0);
  mechanism.joints[0].damping = {0.0, 3.0, 0.0};
  const Structure damped = structure_of(mechanism);
  const Complex w = response_of(damped).harmonic.motion[0](1, 0);
  CHECK(std::abs(w - 1.0 / Complex(0.0, 16.0 * 3.0)) < 1e-12);
  // By next to nothing: |2 i zeta| = d omega/c below two millionths is no limit, above it is one.
  mechanism.joints[0].damping[1] = 1.9e-6 * 512.0 / 16.0;
  CHECK(fails_at(mechanism, "2.54648 Hz"));
  mechanism.joints[0].damping[1] = 2.1e-6 * 512.0 / 16.0;
  CHECK_FALSE(fails_at(mechanism, ""));

  // A beam at its first, second and third frequency.
  Mechanism beam = test::cantilever_of(rod(), 12, Element::corrected);
  beam.loads = {test::load_at(2.0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0})};
  const Structure structure = structure_of(beam);
  const double first = first_square(structure, 1.0);
  beam.frequency = frequency_of(first);
  CHECK(fails_at(beam, fmt::format("{:.6g} Hz", beam.frequency)));
  beam.links[0].retardation = 1e-5;
  CHECK_FALSE(fails_at(beam, ""));
}

TEST_CASE("elements next to without mass") {
  // The mass per length of every second stretch is 1e-12 of its neighbour's: the same beam as with
  // none there, and the dense system's answers.
  const Bar bar = rod();
  for (const double ratio : {1.0, 1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    Mechanism mechanism = test::cantilever_of(bar, 8, Element::corrected, LinkKind::full);
    const LinkStretch whole = mechanism.links[0].stretches[0];
    mechanism.links[0].stretches.clear();
    for (int i = 0; i < 4; ++i) {
      LinkStretch stretch = whole;
      stretch.start = 0.5 * i;
      stretch.length = 0.5;
      if (i % 2 == 1) {
        stretch.mass.c[0] *= ratio;
        stretch.rotary.c[0] *= ratio;
      }
      mechanism.links[0].stretches.push_back(stretch);
    }
    for (const Element element : {Element::classical, Element::corrected}) {
      mechanism.element = element;
      const Structure structure = structure_of(mechanism);
      for (const double square : {0.0, 1e3, 1e5, 1e7, -1e4}) {
        const Against gap = against_dense(structure, square, at_the_end(structure));
        CAPTURE(ratio, square, static_cast<int>(element));
        CHECK(gap.motion < 1e-11);
        CHECK(gap.joints < 1e-11);
      }
    }
  }
}

TEST_CASE("a mechanism with a free motion is an error that names the links that move") {
  const Bar bar = rod();
  const auto error_of = [](const Mechanism& mechanism) {
    return test::refusal_of<AnalysisError>(
        [&] { return static_response(structure_of(mechanism)); });
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  for (const Element element : {Element::classical, Element::corrected}) {
    // A pendulum, a cantilever beside it.
    Mechanism mechanism = test::beam_of(bar, 6, End::pinned, End::free, element);
    mechanism.links[0].name = "pendulum";
    mechanism.links.push_back(mechanism.links[0]);
    mechanism.links[1].name = "held";
    mechanism.joints.push_back(mechanism.joints[0]);
    mechanism.joints[1].a.link = 1;
    mechanism.joints[1].stiffness[2] = test::infinite;
    mechanism.gravity = {0.0, -9.81};
    const std::string text = error_of(mechanism);
    INFO(text);
    CHECK(has(text, "pendulum"));
    CHECK_FALSE(has(text, "held"));
    CHECK(has(text, "one motion"));
    // Held by a spring that is a hundred thousand times softer: it stands.
    mechanism.joints[0].stiffness[2] = 1e-5 * bar.EI / bar.L;
    CHECK(error_of(mechanism).empty());

    // Nothing holds it: three motions.
    mechanism.joints.erase(mechanism.joints.begin());
    const std::string loose = error_of(mechanism);
    INFO(loose);
    CHECK(has(loose, "pendulum"));
    CHECK(has(loose, "3 motions"));

    // A four-bar of elastic links, all on revolute joints: moves as one.
    Mechanism four;
    four.element = element;
    const Eigen::Vector2d corners[] = {{0.0, 0.0}, {0.3, 1.1}, {2.0, 1.4}, {1.9, 0.1}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d along = corners[i + 1] - corners[i];
      Bar side = bar;
      side.L = along.norm();
      Link link = test::link_of(side, 4, LinkKind::full);
      link.name = "bar " + std::to_string(i);
      link.origin = corners[i];
      link.angle = std::atan2(along.y(), along.x());
      four.links.push_back(link);
      const double c = 1e9;
      four.joints.push_back(
          {"pin " + std::to_string(i),
           {static_cast<int>(i), {0.0, 0.0}},
           i == 0 ? Attachment{ground, corners[0]}
                  : Attachment{static_cast<int>(i) - 1, {four.links[i - 1].length, 0.0}},
           0.0,
           {c, c, 0.0},
           {}});
      if (i == 2) {
        four.joints.push_back(
            {"foot", {2, {side.L, 0.0}}, {ground, corners[3]}, 0.0, {c, c, 0.0}, {}});
      }
    }
    const std::string moves = error_of(four);
    INFO(moves);
    for (const char* name : {"bar 0", "bar 1", "bar 2"}) CHECK(has(moves, name));
    CHECK(has(moves, "one motion"));
    // Its crank held: a structure.
    four.joints[0].stiffness[2] = 1e7;
    CHECK(error_of(four).empty());

    // Free to slide along its guide.
    Mechanism slide = test::cantilever_of(bar, 3, element, LinkKind::full);
    slide.joints[0].stiffness[0] = 0.0;
    CHECK(has(error_of(slide), "beam"));
  }
}

TEST_CASE("rigid joints that hold the same twice are an error that names them, not a free motion") {
  // A link that is rigid along its axis, held along it at both ends: how the two share a force
  // along it nothing says.
  for (const double square : {0.0, 1e4}) {
    Mechanism mechanism =
        test::beam_of(rod(), 6, End::pinned, End::pinned, Element::corrected, LinkKind::bending);
    mechanism.joints[1].stiffness[0] = test::infinite;
    std::string text;
    try {
      const DynamicStiffness<double> solver(structure_of(mechanism), square, 0.0);
    } catch (const AnalysisError& error) {
      text = error.what();
    }
    INFO(text);
    CHECK(text.find("start, end") != std::string::npos);
    CHECK(text.find("more than once") != std::string::npos);
    // With its elasticity along the axis it says: N (1 - a/L) at the start, N a/L at the end.
    mechanism.links[0].kind = LinkKind::full;
    mechanism.loads = {test::load_at(0.5, {4.0, 0.0, 0.0})};
    const Structure structure = structure_of(mechanism);
    const Deformation<double> response = static_response(structure);
    CHECK(joint_force(structure, 0, response).x() == Approx(-3.0).epsilon(1e-12));
    CHECK(joint_force(structure, 1, response).x() == Approx(-1.0).epsilon(1e-12));
    // So does a joint with a stiffness, however great.
    mechanism.links[0].kind = LinkKind::bending;
    mechanism.joints[1].stiffness[0] = 1e15;
    const Structure stiff = structure_of(mechanism);
    CHECK(std::abs(joint_force(stiff, 1, static_response(stiff)).x()) < 1e-12);
  }
}

TEST_CASE("a free link vibrates all the same: its rigid motion is -F/(m omega^2)") {
  const Bar bar = rod();
  const double m = bar.mass * bar.L;
  for (const Element element : {Element::classical, Element::corrected}) {
    const Mechanism mechanism =
        test::beam_of(bar, 8, End::free, End::free, element, LinkKind::full);
    const Structure structure = structure_of(mechanism);
    auto loads = no_loads<double>(structure);
    loads[0](0, 0) = 2.0;
    for (const double square : {1e-6, 1e-2, 1.0}) {
      const auto response = DynamicStiffness<double>(structure, square, 0.0).solve(loads);
      CHECK(response.motion[0](0, 0) == Approx(-2.0 / (m * square)).epsilon(1e-5 * square + 1e-10));
    }
    CHECK_THROWS_AS((DynamicStiffness<double>(structure, 0.0, 0.0)), AnalysisError);
  }
}

TEST_CASE("one element, and one spring") {
  const Bar bar = rod();
  for (const LinkKind kind : {LinkKind::rigid, LinkKind::bending, LinkKind::axial}) {
    Mechanism mechanism = test::cantilever_of(bar, 1, Element::corrected, kind);
    mechanism.joints[0].stiffness = {2e6, 3e6, 4e6};
    mechanism.loads = {test::load_at(bar.L, {5.0, 7.0, 0.0})};
    const Structure structure = structure_of(mechanism);
    CHECK(structure.links[0].elements.size() == (kind == LinkKind::rigid ? 1 : 2));
    const double L = bar.L;
    const Eigen::Vector3d end = motion_at(structure, {0, {L, 0.0}}, static_response(structure));
    const double bends = kind == LinkKind::bending ? 7.0 * L * L * L / (3.0 * bar.EI) : 0.0;
    const double stretches = kind == LinkKind::axial ? 5.0 * L / bar.EA : 0.0;
    CHECK(end.x() == Approx(5.0 / 2e6 + stretches).epsilon(1e-14));
    CHECK(end.y() == Approx(7.0 / 3e6 + 7.0 * L * L / 4e6 + bends).epsilon(1e-14));
    const Against gap = against_dense(structure, 1e3, at_the_end(structure));
    CHECK(gap.motion < 1e-12);
  }
}

TEST_CASE("very stiff links next to very soft ones") {
  // Two halves of a cantilever, the inner 10^k times as stiff as the outer: with a = L/2,
  // w = P a^3/(3 EI_2) + P (7/3) a^3/EI_1.
  const Bar soft = rod();
  for (int power = -14; power <= 14; power += 2) {
    Bar inner = soft;
    inner.L = 1.0;
    inner.EI *= std::pow(10.0, power);
    inner.EA *= std::pow(10.0, power);
    Bar outer = soft;
    outer.L = 1.0;
    Mechanism mechanism = test::cantilever_of(inner, 7, Element::corrected, LinkKind::full);
    mechanism.links.push_back(test::link_of(outer, 7, LinkKind::full));
    mechanism.links[1].origin = {1.0, 0.0};
    mechanism.joints.push_back({"weld",
                                {0, {1.0, 0.0}},
                                {1, {0.0, 0.0}},
                                0.0,
                                {test::infinite, test::infinite, test::infinite},
                                {}});
    mechanism.loads = {{"tip", {1, {1.0, 0.0}}, {0.0, 3.0, 0.0}, {0.0, 0.0, 0.0}, 0.0}};
    const Structure structure = structure_of(mechanism);
    const double w = 3.0 / (3.0 * outer.EI) + 7.0 / inner.EI;
    CAPTURE(power);
    CHECK(std::abs(tip(structure, static_response(structure)) / w - 1.0) < 50.0 * eps);
    const Eigen::Vector3d root = joint_force(structure, 0, static_response(structure));
    CHECK(root.z() == Approx(-6.0).epsilon(1e-13));
  }
}

TEST_CASE("a part of a link in resonance by itself is no resonance of the whole") {
  // What lies behind a spring, gathered towards a clamp, has resonances of its own, where I + F D
  // is singular. A beam pinned at both ends (its one end stays): the part behind any of its springs
  // passes through them as the frequency rises.
  const Bar bar = rod();
  const Mechanism mechanism = test::beam_of(bar, 12, End::pinned, End::pinned, Element::corrected);
  const Structure structure = structure_of(mechanism);
  for (const End far : {End::free, End::pinned}) {
    const Mechanism part = test::beam_of(bar, 12, End::clamped, far, Element::corrected);
    const double square = first_square(structure_of(part), 1.0);
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
      for (const double side : {-1.0, 1.0}) {
        auto loads = no_loads<double>(structure);
        loads[0](1, 5) = 1.0;
        const Against gap = against_dense(structure, square * (1.0 + side * off), loads);
        CAPTURE(static_cast<int>(far), off, side, gap.motion, gap.joints);
        CHECK(gap.motion < 1e-11);
        CHECK(gap.joints < 1e-11);
      }
    }
  }
  // The same with fewer elements, down to one mass behind one spring, exact in binary: a mass m
  // behind f = 1/c at m omega^2 = c.
  Mechanism chain;
  chain.element = Element::classical;
  chain.links = {test::link_of(Bar{2.0, 8.0, 1e30, 1.0, 1.0, 0.0}, 2, LinkKind::axial)};
  chain.joints = {test::hold(chain, 0.0, {3.0, test::infinite, test::infinite}, "root")};
  const Structure axial = structure_of(chain);
  // Elements 1/2, 1, 1/2 kg, springs 8 N/m: the last behind its spring at omega^2 = 16.
  auto loads = no_loads<double>(axial);
  loads[0](0, 2) = 1.0;
  for (const double off : {0.0, 1e-15, 1e-12, 1e-8, 1e-4}) {
    const Against gap = against_dense(axial, 16.0 * (1.0 + off), loads);
    CAPTURE(off);
    CHECK(gap.motion < 1e-12);
    CHECK(gap.joints < 1e-12);
  }
}

TEST_CASE("10 000 elements in vibration: round-off against ten times fewer") {
  // Discretisation of order 3 is 1e-9 of the answer at 1000 elements: what the finer division shows
  // beyond is round-off.
  const Bar bar = rod();
  const double first = std::pow(1.8751040687119612, 4) * bar.EI / (bar.mass * std::pow(bar.L, 4));
  std::vector<double> tips;
  for (const int n : {1000, 10000, 100000}) {
    const Mechanism mechanism = test::cantilever_of(bar, n, Element::corrected);
    const Structure structure = structure_of(mechanism);
    const auto response =
        DynamicStiffness<double>(structure, 0.25 * first, 0.0).solve(at_the_end(structure));
    tips.push_back(response.motion[0](1, response.motion[0].cols() - 1));
  }
  CHECK(std::abs(tips[1] / tips[0] - 1.0) < 1e-7);
  CHECK(std::abs(tips[2] / tips[0] - 1.0) < 1e-7);
}

}  // namespace rigid_elements_test
