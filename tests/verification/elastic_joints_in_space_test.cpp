// Joints in space that give way beside the beam of a mechanism: closed forms of a lever on springs.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/verification/front_end.hpp"
#include "catch.hpp"
#include "support/lever_in_space.hpp"

namespace elastic_joints_in_space_test {

using namespace boxbeam;
using namespace test::lever_in_space;
using Eigen::Index;

// 1/k = 1/k_1 + l/EA: a stay that has its own stiffness counts by that alone, so that the spring in
// series is that of the hinge of its foot.
TEST_CASE("rods and joints in space are springs in series", "[elastic_joints_in_space]") {
  constexpr double k1 = 300.0, k2 = 700.0, side = 7e-5;
  const double k3 = E * side * side / 2.0;
  const auto first = [](const Scene& scene) {
    return moved(scene, stiff_lever).in_plane(8, 1).front();
  };
  Scene own;
  own.side = side;
  hold_by_link(own, {L, 0.0, -2.0}, stiffness(k1));
  CHECK(first(own) == Approx(hertz(3.0 * k1 / M)).epsilon(1e-4));
  Scene by_section;
  by_section.side = side;
  hold_by_link(by_section, {L, 0.0, -2.0});
  CHECK(first(by_section) == Approx(hertz(3.0 * k3 / M)).epsilon(1e-4));
  // The post stands on a joint that gives way.
  Scene series = by_section;
  const std::string post = "kind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n";
  series.joints.insert(series.joints.find(post), stiffness(k2));
  const double k = 1.0 / (1.0 / k2 + 1.0 / k3);
  CHECK(first(series) == Approx(hertz(3.0 * k / M)).epsilon(1e-4));
}

namespace {

/// The lever tied by a joint of this kind at its start, to carry it or to close a loop, with what
/// is free in it held by drivers; k where it keeps a place, k_phi where it keeps from turning.
struct Held {
  std::string kind, axes;
  std::vector<std::string> carrying;  ///< of the joint, held
  std::vector<int> free;              ///< movements of a free joint, held beside one that closes
  std::vector<double> squares;        ///< circular frequencies [1/s^2]
  bool turning = true;
};

std::string hold(const std::string& joint, bool angle) {
  return fmt::format("[drivers.\"{0}\"]\njoint = \"{0}\"\nkind = \"hold\"\nvalue = \"0 {1}\"\n",
                     joint, angle ? "rad" : "m");
}

}  // namespace

// Of a rigid lever on springs at its start: along and about its axis alone, across and about
// together: K = diag(k, k_phi), M = [M, M L/2; M L/2, M L^2/3].
TEST_CASE("each kind of joint in space gives way where it holds", "[elastic_joints_in_space]") {
  constexpr double k = 3000.0, k_phi = 8000.0;
  Eigen::Matrix2d mass;
  mass << M, M * L / 2.0, M * L / 2.0, M * L * L / 3.0;
  const Eigen::Matrix2d held = Eigen::Vector2d(k, k_phi).asDiagonal();
  const Eigen::Vector2d both =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(held, mass).eigenvalues();
  const double along = k / M, about = k_phi / J, low = both[0], high = both[1];
  const std::vector<Held> all{
      {"fixed", "", {}, {}, {along, about, low, high, low, high}},
      {"revolute", "axis = \"y\"\n", {"hinge"}, {5}, {along, along, about, low, high}},
      {"prismatic", "axis = \"x\"\n", {"hinge"}, {1}, {about, low, high, low, high}},
      {"cylindrical", "axis = \"x\"\n", {"hinge.1", "hinge.2"}, {1, 6}, {low, high, low, high}},
      {"universal",
       "axis = \"y\"\nsecond_axis = \"z\"\n",
       {"hinge.1", "hinge.2"},
       {4, 5},
       {along, along, along, about}},
      {"spherical", "", {"hinge.1", "hinge.2", "hinge.3"}, {4, 5, 6}, {along, along, along}, false},
      {"planar",
       "axis = \"y\"\n",
       {"hinge.1", "hinge.2", "hinge.3"},
       {1, 3, 5},
       {low, high, about}},
      {"screw", "axis = \"x\"\nlead = \"10 mm\"\n", {"hinge"}, {6}, {along, low, high, low, high}}};
  for (const Held& of : all) {
    for (const bool closes : {false, true}) {
      CAPTURE(of.kind, closes);
      const std::string keys =
          of.axes + stiffness(k) + (of.turning ? turning(k_phi) : std::string());
      Scene scene;
      if (closes) {
        scene.hinge = "kind = \"free\"\n";
        scene.joints = fmt::format(
                           "[joints.closing]\nkind = \"{}\"\nconnect = [\"base.O\", "
                           "\"lever.A\"]\ncloses = true\n",
                           of.kind) +
                       keys;
        for (const int way : of.free) scene.drivers += hold(fmt::format("hinge.{}", way), way > 3);
      } else {
        scene.hinge = fmt::format("kind = \"{}\"\n", of.kind) + keys;
        for (const std::string& joint : of.carrying) {
          const bool shifts = of.kind == "prismatic" ||
                              (of.kind == "planar" && joint != "hinge.3") ||
                              (of.kind == "cylindrical" && joint == "hinge.2");
          scene.drivers += hold(joint, !shifts);
        }
      }
      const Moved at_rest = moved(scene, stiff_lever);
      const std::vector<double> found = at_rest.frequencies(8, of.squares.size());
      std::vector<double> expected = of.squares;
      std::sort(expected.begin(), expected.end());
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(found[i] == Approx(hertz(expected[i])).epsilon(2e-4));
      // What does not give way is rigid: the next mode is the lever's own.
      const std::vector<double> more = at_rest.frequencies(8, expected.size() + 1);
      if (more.size() > expected.size()) CHECK(more.back() > 2.0 * more[expected.size() - 1]);
    }
  }
  // On a ball at its start that does not spin, k across a line through its end: 3 k/M.
  Scene slotted;
  slotted.hinge = "kind = \"spherical\"\n";
  slotted.drivers = hold("hinge.3", true);
  slotted.joints =
      "[joints.slot]\nkind = \"slot\"\nconnect = [\"base.O\", \"lever.B\"]\naxis = \"x\"\n" +
      stiffness(k);
  for (const double found : moved(slotted, stiff_lever).frequencies(8, 2))
    CHECK(found == Approx(hertz(3.0 * k / M)).epsilon(1e-4));
}

// z (sin z cosh z - cos z sinh z) = (k L/EI) (1 + cos z cosh z): a cantilever whose root turns on a
// spring; k = 0 is tan z = tanh z, a large one the clamped root. Blevins, Formulas for Natural
// Frequency and Mode Shape (1979), table 8-1, by its boundary conditions.
TEST_CASE("a cantilever in space on a rotational spring", "[elastic_joints_in_space]") {
  for (const double k : {2e4, 2e5, 5e6}) {
    Scene scene;
    scene.hinge = "kind = \"fixed\"\n" + turning(k);
    const Moved of = moved(scene, without_shear);
    std::vector<double> expected;
    for (const double second : {I, I_z}) {
      for (const double z : roots_of(
               [&](double at) {
                 return at * (std::sin(at) * std::cosh(at) - std::cos(at) * std::sinh(at)) -
                        k * L / (E * second) * (1.0 + std::cos(at) * std::cosh(at));
               },
               2))
        expected.push_back(std::pow(z / L, 2) * std::sqrt(E * second / (rho * A)) / (2 * pi));
    }
    std::sort(expected.begin(), expected.end());
    std::vector<double> found;
    for (const frame::BeamMode& mode : of.modes(24, 12)) {
      double twist = 0.0;
      for (Index i = 3; i < mode.motion.size(); i += 6)
        twist = std::max(twist, std::abs(mode.motion[i]));
      if (twist < 1e-6 * mode.motion.norm()) found.push_back(mode.frequency);
    }
    REQUIRE(found.size() >= 4);
    for (std::size_t i = 0; i < 4; ++i) {
      CAPTURE(k, i);
      CHECK(found[i] == Approx(expected[i]).epsilon(1e-5));
    }
  }
}

// P_cr by x tan x = k L/EI, x = L sqrt(P/EI): Timoshenko, Gere, Theory of Elastic Stability (1961),
// section 2.1; shear takes N_cr/(G A) of it. The bisection is within 1e-3.
TEST_CASE("a column in space on a rotational spring", "[elastic_joints_in_space]") {
  constexpr double P = 1000.0;
  for (const double k : {1e4, 1e5}) {
    Scene scene;
    scene.hinge = "kind = \"fixed\"\n" + turning(k);
    scene.forces = fmt::format(
        "[forces.push]\nkind = \"force\"\npoint = \"lever.B\"\naxes = \"lever\"\n"
        "direction = \"-x\"\nsize = \"{} N\"\n",
        P);
    const Moved of = moved(scene, without_shear);
    const double x =
        roots_of([&](double at) { return at * std::sin(at) - k * L / (E * I_z) * std::cos(at); }, 1)
            .front();
    CHECK(of.critical_factor() * P == Approx(x * x * E * I_z / (L * L)).epsilon(2e-3));
    CHECK(moved(scene, rigid_beside).critical_factor() > 1.05 * of.critical_factor());
  }
}

}  // namespace elastic_joints_in_space_test
