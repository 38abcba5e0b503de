// Rods and joints that are elastic beside the beam of a mechanism in space: closed forms, finite
// elements that share nothing with the program, cases of the plane written in space, and rods and
// joints of no flexibility, which are rigid ones.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "src/verification/elastic_motion_in_space.hpp"
#include "src/verification/vibration_in_space.hpp"
#include "support/space_elements.hpp"

namespace elastic_rods_in_space_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double pi = std::numbers::pi, E = 2.1e11;
constexpr double L = 4.0;  ///< of the lever
constexpr double rho = 7850.0;
constexpr double A = 0.06 * 0.08 - 0.052 * 0.072;
constexpr double M = rho * A * L;  ///< of the lever [kg]
const double I = (0.06 * std::pow(0.08, 3) - 0.052 * std::pow(0.072, 3)) / 12.0;    ///< about y
const double I_z = (0.08 * std::pow(0.06, 3) - 0.072 * std::pow(0.052, 3)) / 12.0;  ///< about z
const double J = rho * (I + I_z) * L;  ///< of inertia of the lever about its axis

std::string vector(const Vector3d& v, const char* unit) {
  return fmt::format("[\"{0:.17g} {3}\", \"{1:.17g} {3}\", \"{2:.17g} {3}\"]", v.x(), v.y(), v.z(),
                     unit);
}
std::string direction(const Vector3d& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

/// What the texts of the scenes are put together from: a lever along x on a base, about which
/// everything may be turned.
struct Scene {
  double gravity = 0.0;
  std::string turn;  ///< of all
  std::string hinge = "kind = \"revolute\"\naxis = \"-y\"\n";
  std::string bodies, joints, forces, rod, drivers;
  double side = 0.002;  ///< of the rod's square section [m]
  std::string model;
  bool moves = false;

  std::string text() const {
    return "[case]\nname = \"lever\"\nkind = \"spatial\"\n[mechanism]\ngravity = " +
           vector({0.0, 0.0, -gravity}, "m/s^2") +
           "\n[bodies.base]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"] }\n"
           "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], M = [\"2.5 m\", \"0 m\", "
           "\"0 m\"], B = [\"4 m\", \"0 m\", \"0 m\"] }\n" +
           bodies + "[joints.base]\nkind = \"fixed\"\nconnect = [\"ground\", \"base.O\"]\n" + turn +
           "[joints.hinge]\nconnect = [\"base.O\", \"lever.A\"]\n" + hinge + joints + forces +
           drivers + (moves ? "" : "[motion]\nduration = \"1 s\"\n") +
           "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
           "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
           fmt::format(
               "[sections.bar]\nkind = \"plate\"\nwidth = \"{0:.17g} m\"\nheight = \"{0:.17g} m\"\n"
               "[sections.flat]\nkind = \"plate\"\nwidth = \"10 mm\"\nheight = \"50 mm\"\n",
               side) +
           "[beam]\nbody = \"lever\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n"
           "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n" +
           model + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" + rod;
  }
};

/// A rod without mass from a place of the base, which is the body "post", to the lever's end.
void hold_by_link(Scene& scene, const Vector3d& from, const std::string& keys = "") {
  const double length = (Vector3d(L, 0.0, 0.0) - from).norm();
  scene.bodies +=
      "[bodies.post]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"], F = " + vector(from, "m") +
      " }\n";
  scene.joints += fmt::format(
      "[joints.post]\nkind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n"
      "[joints.stay]\nkind = \"distance\"\nconnect = [\"post.F\", \"lever.B\"]\n"
      "length = \"{:.17g} m\"\n{}",
      length, keys);
  scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
}

/// A case whose rigid bodies have moved.
struct Moved {
  explicit Moved(Project of) : project(std::move(of)), runs(run_situations(project)) {}

  const LoadHistory& rigid() const { return runs.front().loads; }
  const spatial::Chain& chain() const { return chain_of(runs.front()); }
  std::vector<frame::BeamMode> modes(int parts, std::size_t count) const {
    StoppedVibration stopped(project, chain(), parts);
    const double begin = rigid().begin().value();
    return stopped.modes(chain().at(begin), rigid().diagram_at(si<Time>(begin)), count);
  }
  std::vector<double> frequencies(int parts, std::size_t count) const {
    std::vector<double> found;
    for (const frame::BeamMode& mode : modes(parts, count)) found.push_back(mode.frequency);
    return found;
  }
  /// Those in which the lever stays in its plane x z.
  std::vector<double> in_plane(int parts, std::size_t count) const {
    std::vector<double> found;
    for (const frame::BeamMode& mode : modes(parts, 40)) {
      double across = 0.0;
      for (Index k = 0; k < mode.motion.size(); ++k)
        if (k % 6 == 1 || k % 6 == 3 || k % 6 == 5) across += std::pow(mode.motion[k], 2);
      if (across < 1e-6 * mode.motion.squaredNorm()) found.push_back(mode.frequency);
    }
    REQUIRE(found.size() >= count);
    found.resize(count);
    return found;
  }
  ElasticMotionInSpace by(std::size_t modes, int parts) const {
    return {project, chain(), rigid().span(), [this](Time time) { return rigid().loads_at(time); },
            modes,   parts};
  }
  Time at(double part) const { return rigid().begin() + part * rigid().period(); }
  double critical_factor() const {
    const auto factor =
        runs.front().motion->critical_factor_at(rigid().time_of(0), rigid().diagram(0), 1e6);
    REQUIRE(factor);
    return *factor;
  }

  Project project;
  std::deque<SituationRun> runs;
};

Moved moved(const Scene& scene, const std::function<void(Project&)>& change = {}) {
  Project project = parse_project("lever.toml", scene.text());
  if (change) change(project);
  return Moved(std::move(project));
}

/// Rods and joints count as rigid ones.
void rigid_beside(Project& project) { project.elastic_beside.clear(); }
Moved alone(const Scene& scene) { return moved(scene, rigid_beside); }
/// Beams without shear; rods are of steel.
void without_shear(Project& project) {
  project.model.youngs_modulus = E;
  project.model.shear_modulus = 1e6 * 8.1e10;
}
/// A stiff lever beside springs of some hundred newtons a metre; rods are of steel.
void stiff_lever(Project& project) {
  project.model.youngs_modulus = 1e3 * E;
  project.model.shear_modulus = 1e3 * 8.1e10;
}

using Cuts = Eigen::Matrix<double, 6, 1>;

Cuts cuts_of(const BeamLoads& loads, double s, Side side = Side::behind) {
  return cuts_at(cut_forces_of(loads), {{si<Length>(s), side}});
}

void check_alike(const Cuts& found, const Cuts& expected, const Cuts& size, double within) {
  INFO("found " << found.transpose() << "\nexpected " << expected.transpose());
  CHECK((found - expected).head<3>().norm() < within * size.head<3>().norm());
  CHECK((found - expected).tail<3>().norm() < within * size.tail<3>().norm());
}

std::vector<double> roots_of(const std::function<double(double)>& f, std::size_t count) {
  std::vector<double> roots;
  constexpr double step = 1e-3;
  for (double z = 0.02; roots.size() < count; z += step) {
    if (f(z) * f(z + step) > 0.0) continue;
    double low = z, high = z + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (f(low) * f(middle) <= 0.0 ? high : low) = middle;
    }
    roots.push_back(low);
  }
  return roots;
}

double hertz(double square) { return std::sqrt(square) / (2.0 * pi); }

std::string stiffness(double k, double c = 0.0) {
  return fmt::format("stiffness = \"{:.17g} N/m\"\n", k) +
         (c > 0.0 ? fmt::format("damping = \"{:.17g} N s/m\"\n", c) : "");
}
std::string turning(double k) {
  return fmt::format("turning_stiffness = \"{:.17g} N m/rad\"\n", k);
}

}  // namespace

// EI (z/L)^3 (sin z coth z - cos z) = 2 k sin z: an even beam on a hinge with a spring at its end,
// w = sin(z x/L) + sin z/sinh z sinh(z x/L), EI w''' = k w there.
TEST_CASE("a beam on a hinge and a rod in space vibrates as on a spring EA/l",
          "[elastic_rods_in_space]") {
  for (const double side : {0.0005, 0.002, 0.01}) {
    Scene scene;
    scene.side = side;
    hold_by_link(scene, {L, 0.0, -2.0});
    const Moved of = moved(scene, without_shear);
    const double k = E * side * side / 2.0;
    const std::vector<double> z = roots_of(
        [&](double at) {
          return E * I * std::pow(at / L, 3) * (std::sin(at) / std::tanh(at) - std::cos(at)) -
                 2.0 * k * std::sin(at);
        },
        3);
    const std::vector<double> found = of.in_plane(32, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(side, i);
      CHECK(found[i] ==
            Approx(std::pow(z[i] / L, 2) * std::sqrt(E * I / (rho * A)) / (2 * pi)).epsilon(2e-5));
    }
  }
}

// 1/k = 1/k_1 + l/EA: a stay that has its own stiffness counts by that alone, so that the spring in
// series is that of the hinge of its foot.
TEST_CASE("rods and joints in space are springs in series", "[elastic_rods_in_space]") {
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
TEST_CASE("each kind of joint in space gives way where it holds", "[elastic_rods_in_space]") {
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
TEST_CASE("a cantilever in space on a rotational spring", "[elastic_rods_in_space]") {
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
TEST_CASE("a column in space on a rotational spring", "[elastic_rods_in_space]") {
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

// The restoring moment k L^2 phi of a rod across the end of a stiff lever against P L phi: k L.
TEST_CASE("a stiff lever in space on an elastic rod buckles at k L", "[elastic_rods_in_space]") {
  constexpr double P = 1.0, side = 7e-5;
  Scene scene;
  scene.side = side;
  hold_by_link(scene, {L, 0.0, -2.0});
  scene.forces = fmt::format(
      "[forces.push]\nkind = \"force\"\npoint = \"lever.B\"\naxes = \"base\"\n"
      "direction = \"-x\"\nsize = \"{} N\"\n",
      P);
  const double k = E * side * side / 2.0;
  CHECK(moved(scene, stiff_lever).critical_factor() == Approx(k * L / P).epsilon(3e-3));
}

namespace {

/// A rod with mass between pins or, in space, a ball and a universal joint.
void hold_by_body(Scene& scene, double mass, const Vector3d& foot, const Vector3d& head,
                  const std::string& point, const std::string& carrier = "lever",
                  const Vector3d& inertia = Vector3d::Zero(), const std::string& section = "bar") {
  const Vector3d line = foot - head;
  const double l = line.norm();
  const Vector3d d = line / l;
  const Vector3d about =
      inertia.isZero(0.0) ? Vector3d(0.0, mass * l * l / 12.0, mass * l * l / 12.0) : inertia;
  scene.bodies += fmt::format(
      "[bodies.stay]\nmass = \"{:.17g} kg\"\ncentre = [\"{:.17g} m\", \"0 m\", \"0 m\"]\ninertia "
      "= {}\npoints = {{ Q = [\"0 m\", \"0 m\", \"0 m\"], P = [\"{:.17g} m\", \"0 m\", \"0 m\"] "
      "}}\n[bodies.post]\npoints = {{ O = [\"0 m\", \"0 m\", \"0 m\"], F = {} }}\n",
      mass, 0.5 * l, vector(about, "kg m^2"), l, vector(foot, "m"));
  scene.joints += fmt::format(
      "[joints.post]\nkind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n"
      "[joints.head]\nkind = \"universal\"\nconnect = [\"{}.{}\", \"stay.Q\"]\n"
      "axis = \"y\"\nsecond_axis = \"z\"\nturn = [[\"z\", \"{:.17g} rad\"], [\"y\", \"{:.17g} "
      "rad\"]]\n"
      "[joints.foot]\nkind = \"spherical\"\ncloses = true\nconnect = [\"post.F\", \"stay.P\"]\n",
      carrier, point, std::atan2(d.y(), d.x()), -std::asin(d.z()));
  scene.rod = fmt::format(
      "[[rods]]\nname = \"stay\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\nsection = \"{}\"\n"
      "curve = \"c\"\n",
      section);
}

/// The lever and the rod by even elements of the test's own, in the axes of the lever; motions that
/// joints hold are taken out by an orthonormal basis of what is left.
struct Crane {
  static constexpr Index n = 24;
  MatrixXd K, Mass, free;
  Matrix3d axes;  ///< of the rod

  Crane(const Project& project, const Vector3d& head, const Vector3d& foot, double mass,
        const Section& rod_section, Index head_node) {
    const Index nodes = 2 * (n + 1);
    K = MatrixXd::Zero(6 * nodes, 6 * nodes);
    Mass = K;
    const Vector3d line = foot - head, d = line.normalized();
    axes.col(0) = d;
    axes = (Eigen::AngleAxisd(std::atan2(d.y(), d.x()), Vector3d::UnitZ()) *
            Eigen::AngleAxisd(-std::asin(d.z()), Vector3d::UnitY()))
               .toRotationMatrix();
    add(project.beam.segments.front().from, Matrix3d::Identity(), L, rho, 0, false);
    const double A_rod = properties_of(rod_section).area.value();
    add(rod_section, axes, line.norm(), mass / (A_rod * line.norm()), n + 1, true);
    // Start of the lever: its turn about y is free. Head: a universal joint, the turn about the
    // rod is held. Foot: a ball.
    MatrixXd held = MatrixXd::Zero(12, 6 * nodes);
    Index row = 0;
    for (const Index k : {0, 1, 2, 3, 5}) held(row++, k) = 1.0;
    for (Index k = 0; k < 3; ++k) {
      held(row, 6 * head_node + k) = 1.0;
      held(row++, 6 * (n + 1) + k) = -1.0;
    }
    held.block<1, 3>(row, 6 * head_node + 3) = axes.col(0).transpose();
    held.block<1, 3>(row++, 6 * (n + 1) + 3) = -axes.col(0).transpose();
    for (Index k = 0; k < 3; ++k) held(row++, 6 * (2 * n + 1) + k) = 1.0;
    const Eigen::HouseholderQR<MatrixXd> qr(held.transpose());
    const MatrixXd Q = qr.householderQ();
    free = Q.rightCols(6 * nodes - 12);
  }

  std::vector<double> frequencies(std::size_t count) const {
    const MatrixXd k = free.transpose() * K * free, m = free.transpose() * Mass * free;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(m, k, Eigen::EigenvaluesOnly);
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i)
      found.push_back(hertz(1.0 / solver.eigenvalues()[k.rows() - 1 - static_cast<Index>(i)]));
    return found;
  }

 private:
  void add(const Section& section, const Matrix3d& of_axes, double length, double density, Index at,
           bool rotary) {
    const double h = length / n;
    const test::space_elements::Element element =
        test::space_elements::element(section, h, density);
    Eigen::Matrix<double, 12, 12> into = Eigen::Matrix<double, 12, 12>::Zero();
    for (Index i = 0; i < 12; i += 3) into.block<3, 3>(i, i) = of_axes.transpose();
    const SectionProperties of = properties_of(section);
    const Matrix3d slices =
        of_axes * Vector3d(0.0, density * of.I_y.value(), density * of.I_z.value()).asDiagonal() *
        of_axes.transpose();
    for (Index i = 0; i < n; ++i) {
      const Index r = 6 * (at + i);
      K.block<12, 12>(r, r) += into.transpose() * element.K * into;
      Mass.block<12, 12>(r, r) += into.transpose() * element.M * into;
      if (!rotary) continue;
      for (const Index end : {r, r + 6}) Mass.block<3, 3>(end + 3, end + 3) += 0.5 * h * slices;
    }
  }
};

/// Moments of inertia of an even rod of a square section, slices and all.
Vector3d of_even_rod(double mass, double side, double l) {
  const double slices = mass * side * side / 12.0, whole = mass * l * l / 12.0;
  return {2.0 * slices, whole + slices, whole + slices};
}

const Vector3d crane_head(2.5, 0.0, 0.0), crane_foot(1.0, 0.9, -1.6);

Scene crane(double mass, double side) {
  Scene scene;
  scene.side = side;
  hold_by_body(scene, mass, crane_foot, crane_head, "M", "lever",
               of_even_rod(mass, side, (crane_foot - crane_head).norm()));
  return scene;
}

}  // namespace

// n = 24: head at the 15th node. Torsion and stretching of linear shapes: (k h)^2/24 of their part.
TEST_CASE("a lever on an oblique strut has the frequencies of a model of finite elements",
          "[elastic_rods_in_space]") {
  for (const auto& [mass, side] : {std::pair(3.0, 0.02), std::pair(20.0, 0.035)}) {
    const Moved of = moved(crane(mass, side), [](Project& project) {
      project.model.youngs_modulus = 210e9;
      project.model.shear_modulus = 81e9;
    });
    REQUIRE(elastic_beside_text(of.project) == " (stay elastic as well)");
    const Crane elements(of.project, crane_head, crane_foot, mass, of.project.rods.front().section,
                         15);
    const std::vector<double> expected = elements.frequencies(6), found = of.frequencies(32, 6);
    for (std::size_t i = 0; i < 6; ++i) {
      CAPTURE(side, i);
      CHECK(found[i] == Approx(expected[i]).epsilon(1e-4));
    }
    // With a rigid strut it is stiffer.
    CHECK(moved(crane(mass, side),
                [](Project& project) {
                  project.model.youngs_modulus = 210e9;
                  project.model.shear_modulus = 81e9;
                  project.elastic_beside.clear();
                })
              .frequencies(32, 1)
              .front() > 1.0005 * found.front());
  }
}

// (K - omega^2 M) u = f: what the start of the lever bears beyond the rigid mechanism.
TEST_CASE("a lever on an oblique strut under a harmonic force bears what finite elements bear",
          "[elastic_rods_in_space]") {
  constexpr double mass = 3.0, side = 0.02;
  constexpr double P = 1e-3;  // so small that axial forces do not count
  for (const double frequency : {1.5, 3.0}) {
    Scene scene = crane(mass, side);
    scene.moves = true;
    const Vector3d along(0.36, 0.48, 0.8);
    scene.forces = fmt::format(
        "[forces.push]\nkind = \"force\"\npoint = \"lever.B\"\naxes = \"base\"\ndirection = {}\n"
        "law = {{ kind = \"harmonic\", mean = \"0 N\", amplitude = \"{} N\", frequency = \"{} "
        "Hz\" }}\n",
        direction(along), P, frequency);
    const Moved of = moved(scene, [](Project& project) {
      project.model.youngs_modulus = 210e9;
      project.model.shear_modulus = 81e9;
    });
    const Crane elements(of.project, crane_head, crane_foot, mass, of.project.rods.front().section,
                         15);
    VectorXd f = VectorXd::Zero(elements.K.rows());
    f.segment<3>(6 * Crane::n) = P * along;
    const double square = std::pow(2.0 * pi * frequency, 2);
    const MatrixXd dynamic = elements.K - square * elements.Mass;
    const MatrixXd& free = elements.free;
    const VectorXd u = free * (free.transpose() * dynamic * free).lu().solve(free.transpose() * f);
    const VectorXd statically =
        free * (free.transpose() * elements.K * free).lu().solve(free.transpose() * f);
    const Cuts heel = -(dynamic * u).head<6>(), still = -(elements.K * statically).head<6>();
    const ElasticMotionInSpace elastic = of.by(8, 16);
    for (const double part : {0.2, 0.55}) {
      const double now = std::sin(2.0 * pi * part);
      CAPTURE(frequency, elastic.lowest_frequency());
      // Statics are those of rigid bodies: the strut is determinate.
      check_alike(cuts_of(of.rigid().loads_at(of.at(part)), 0.0), now * still, now * still, 1e-6);
      check_alike(cuts_of(elastic.loads_at(of.at(part)), 0.0), now * heel, now * heel, 1e-3);
      CHECK((heel - still).norm() > 0.02 * still.norm());
    }
  }
}

// Invariant: however the scene lies.
TEST_CASE("elastic rods and joints in space vibrate alike however they lie",
          "[elastic_rods_in_space]") {
  Scene scene = crane(8.0, 0.02);
  scene.hinge += stiffness(2e5, 30.0) + turning(3e4);
  scene.moves = true;
  scene.forces =
      "[forces.push]\nkind = \"force\"\npoint = \"lever.B\"\naxes = \"base\"\n"
      "direction = [0.36, 0.48, 0.8]\nlaw = { kind = \"harmonic\", mean = \"200 N\", amplitude = "
      "\"100 N\", frequency = \"2 Hz\" }\n";
  Scene turned = scene;
  turned.turn = "turn = [[\"x\", \"70 deg\"], [\"z\", \"-130 deg\"], [\"y\", \"15 deg\"]]\n";
  const Moved of = moved(scene), other = moved(turned);
  REQUIRE(elastic_beside_text(of.project) == " (joint hinge, stay elastic as well)");
  const std::vector<double> expected = of.frequencies(12, 6), found = other.frequencies(12, 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(1e-9));
  const ElasticMotionInSpace one = of.by(5, 8), another = other.by(5, 8);
  for (const double part : {0.1, 0.43, 0.8}) {
    for (const double s : {0.0, 1.5, 3.0}) {
      const Cuts by_first = cuts_of(one.loads_at(of.at(part)), s);
      check_alike(cuts_of(another.loads_at(other.at(part)), s), by_first, by_first, 1e-7);
    }
  }
  CHECK(of.critical_factor() == Approx(other.critical_factor()).epsilon(3e-3));
}

namespace {

/// A shoe that a driver moves up and down below the lever's end.
void drive_shoe(Scene& scene, double x, const std::string& driver, const std::string& keys = "") {
  scene.moves = true;
  scene.bodies +=
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = { S = [\"0 m\", \"0 m\", \"0 m\"] }\n"
      "[bodies.post]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"], F = " +
      vector({x, 0.0, 0.0}, "m") + " }\n";
  scene.joints +=
      "[joints.post]\nkind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n"
      "[joints.guide]\nkind = \"prismatic\"\nconnect = [\"post.F\", \"shoe.S\"]\naxis = \"z\"\n" +
      keys;
  scene.drivers += "[drivers.shake]\njoint = \"guide\"\n" + driver;
}

double moment_at(const BeamLoads& loads, double s) {
  return cut_forces_of(loads).at({si<Length>(s), Side::behind}).M_y.value();
}

}  // namespace

// m = M/3 at its end: the end follows the shoe as (k + i c w)/(k - m w^2 + i c w), and what bends
// the lever follows its end. Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974),
// section 1.10. What rigid bodies miss: 1/(1 - r^2) - 1.
TEST_CASE("a lever in space that is shaken by way of a stay with a damper",
          "[elastic_rods_in_space]") {
  using Complex = std::complex<double>;
  constexpr double k = 400.0;
  for (const auto& [r, zeta] : {std::pair(0.3, 0.0), std::pair(0.7, 0.1), std::pair(1.0, 0.2)}) {
    Scene scene;
    const double m = M / 3.0, omega = r * std::sqrt(k / m), c = 2.0 * zeta * std::sqrt(k * m);
    drive_shoe(scene, L,
               fmt::format("kind = \"harmonic\"\nmean = \"-2 m\"\namplitude = \"0.0002 m\"\n"
                           "angular_frequency = \"{:.17g} rad/s\"\n",
                           omega));
    scene.joints +=
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"shoe.S\", \"lever.B\"]\n"
        "length = \"2 m\"\n" +
        stiffness(k, c);
    const Moved of = moved(scene, stiff_lever);
    const ElasticMotionInSpace motion = of.by(1, 8);
    const Complex follows = Complex(k, c * omega) / Complex(k - m * omega * omega, c * omega) *
                            moment_at(of.rigid().loads_at(of.at(0.25)), 0.5 * L);
    for (const double part : {0.1, 0.25, 0.7}) {
      CAPTURE(r, zeta, part);
      CHECK(moment_at(motion.loads_at(of.at(part)), 0.5 * L) ==
            Approx((follows * std::polar(1.0, 2 * pi * part)).imag())
                .margin(3e-3 * std::abs(follows)));
    }
    if (zeta > 0.0) continue;
    CHECK(estimate_vibration_in_space(of.project, of.runs.front()).estimate.without_modes.front() ==
          Approx(r * r / (1.0 - r * r)).epsilon(5e-3));
  }
}

namespace {

const std::string shaking =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.05 m\"\nfrequency = \"1.1 Hz\"\n";
/// So small a motion that the posture stays and no axial force counts.
const std::string slightly =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.000001 m\"\nfrequency = \"3 Hz\"\n";
const std::string lifting =
    "kind = \"smooth step\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\nend = \"0.8 s\"\n";

/// The lever at 30 deg, loaded at its end and moved by a shoe by way of an inclined rod, in the
/// plane x z.
Scene in_the_plane(bool body, const std::string& driver, bool loaded = true) {
  Scene scene;
  scene.gravity = loaded ? 9.81 : 0.0;
  scene.hinge += "start = \"30 deg\"\n";
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const double l = (end - foot).norm();
  drive_shoe(scene, foot.x(), driver);
  if (body) {
    scene.side = 0.03;
    const Eigen::Vector2d line = (foot - end) / l;
    // Angle of the rod's x from that of the lever, positive upwards, about -y.
    const double angle = std::atan2(line.y(), line.x()) - pi / 6;
    scene.bodies += fmt::format(
        "[bodies.stay]\nmass = \"12 kg\"\ncentre = [\"{0:.17g} m\", \"0 m\", \"0 m\"]\n"
        "inertia = [\"0 kg m^2\", \"{1:.17g} kg m^2\", \"{1:.17g} kg m^2\"]\n"
        "points = {{ Q = [\"0 m\", \"0 m\", \"0 m\"], P = [\"{2:.17g} m\", \"0 m\", \"0 m\"] }}\n",
        0.5 * l, l * l, l);
    scene.joints += fmt::format(
        "[joints.head]\nkind = \"revolute\"\naxis = \"-y\"\nconnect = [\"lever.B\", \"stay.Q\"]\n"
        "start = \"{:.17g} rad\"\n"
        "[joints.foot]\nkind = \"slot\"\nconnect = [\"shoe.S\", \"stay.P\"]\naxis = \"y\"\n",
        angle);
    scene.rod =
        "[[rods]]\nname = \"stay\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  } else {
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"shoe.S\", \"lever.B\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  if (loaded)
    scene.forces =
        "[forces.across]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"-x\"\nsize = \"150 "
        "N\"\n[forces.down]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"-z\"\nsize = "
        "\"400 N\"\n";
  return scene;
}

/// The same written in the plane.
std::string of_the_plane(bool body, const std::string& driver, double side, bool loaded) {
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const Eigen::Vector2d line = foot - end, middle = 0.5 * (end + foot);
  const double l = line.norm();
  std::string text =
      "[case]\nname = \"lever\"\nkind = \"planar\"\n[mechanism]\n" +
      fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", loaded ? -9.81 : 0.0) +
      "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"4 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"], angle = \"30 deg\" }\n"
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = { S = [\"0 m\", \"0 m\"] }\n"
      "sketch = { at = [\"3 m\", \"0.2 m\"] }\n"
      "[joints.hinge]\nkind = \"pin\"\nconnect = [\"lever.A\", \"ground\"]\nat = [\"0 m\", \"0 "
      "m\"]\n[joints.guide]\nkind = \"slider\"\npoint = \"shoe.S\"\nthrough = [\"3 m\", \"0 m\"]\n"
      "direction = \"90 deg\"\nangle = \"-90 deg\"\n"
      "[drivers.shake]\ncoordinate = \"y\"\npoint = \"shoe.S\"\n" +
      driver;
  std::string rod;
  if (body) {
    text += fmt::format(
        "[bodies.stay]\nmass = \"12 kg\"\ninertia = \"{0:.17g} kg m^2\"\npoints = {{ Q = "
        "[\"{1:.17g} m\", \"0 m\"], P = [\"{2:.17g} m\", \"0 m\"] }}\nsketch = {{ at = [\"{3:.17g} "
        "m\", \"{4:.17g} m\"], angle = \"{5:.17g} rad\" }}\n"
        "[joints.head]\nkind = \"pin\"\nconnect = [\"stay.Q\", \"lever.B\"]\n"
        "[joints.foot]\nkind = \"pin\"\nconnect = [\"stay.P\", \"shoe.S\"]\n",
        l * l, -0.5 * l, 0.5 * l, middle.x(), middle.y(), std::atan2(line.y(), line.x()));
    rod =
        "[[rods]]\nname = \"stay\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  } else {
    text += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  if (loaded)
    text +=
        "[forces.across]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"0 deg\"\nsize = "
        "\"-150 N\"\n[forces.down]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"90 "
        "deg\"\nsize = \"-400 N\"\n";
  return text +
         "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
         "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
         fmt::format("[sections.bar]\nkind = \"plate\"\nwidth = \"{0} m\"\nheight = \"{0} m\"\n",
                     side) +
         "[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 "
         "m\"\nsection = \"box\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" +
         rod;
}

}  // namespace

// The same lever and rod as chains of rigid finite elements of the plane and by pieces in space, in
// a motion so small that the posture stays; what is estimated is relative.
TEST_CASE("a lever of the plane on an elastic rod has its frequencies and its estimate in space",
          "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    CAPTURE(body);
    const Scene scene = in_the_plane(body, slightly, false);
    const Project plane =
        parse_project("plane.toml", of_the_plane(body, slightly, scene.side, false));
    const std::deque<SituationRun> runs = run_situations(plane);
    const LoadHistory& of_plane = runs.front().loads;
    const RigidMotion motion{&planar_of(plane), &planar_motion_of(runs.front()), &plane.beam,
                             [&](Time time) { return of_plane.loads_at(time); }};
    const VibrationEstimate expected =
        estimate_vibration(motion, elastic_body_of(plane, 128), of_plane);
    const Moved of = moved(scene);
    REQUIRE(elastic_beside_text(of.project) == " (stay elastic as well)");
    // The loads of the rigid motion are the same.
    for (const double part : {0.1, 0.6}) {
      CHECK(moment_at(of.rigid().loads_at(of.at(part)), 2.0) ==
            Approx(moment_at(of_plane.loads_at(of_plane.begin() + part * of_plane.period()), 2.0))
                .epsilon(1e-6));
    }
    const std::vector<double> found = of.in_plane(32, 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CAPTURE(i);
      CHECK(found[i] == Approx(expected.frequencies[i]).epsilon(i == 0 ? 1e-5 : 5e-5));
    }
    const VibrationInSpace estimate = estimate_vibration_in_space(of.project, of.runs.front(), 32);
    REQUIRE(estimate.obstacle.empty());
    REQUIRE(expected.without_modes.front() > 0.01);
    CHECK(estimate.estimate.without_modes.front() ==
          Approx(expected.without_modes.front()).epsilon(5e-4));
    const Moved rigid = alone(scene);
    CHECK(estimate_vibration_in_space(rigid.project, rigid.runs.front(), 32)
              .estimate.without_modes.front() < 0.995 * expected.without_modes.front());
  }
}

// The limit: rods and joints so stiff that they do not give way.
TEST_CASE("rods and joints in space of no flexibility are rigid", "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    for (const std::string& driver : {shaking, lifting}) {
      CAPTURE(body, driver);
      Scene scene = in_the_plane(body, driver);
      scene.hinge += stiffness(1e16) + turning(1e16);
      scene.model = "[model]\ndamping = { ratio = 0.02, at = \"10 Hz\" }\n";
      const Moved stiff = moved(scene, [&](Project& project) {
        std::erase_if(project.elastic_beside, [](const ElasticBeside& of) {
          return !std::holds_alternative<spatial::ElasticJoint>(of.place);
        });
      });
      REQUIRE(stiff.project.elastic_beside.size() == 1);
      const Moved rigid = moved(scene, rigid_beside);
      const std::vector<double> found = stiff.frequencies(8, 4), expected = rigid.frequencies(8, 4);
      for (std::size_t i = 0; i < 4; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(1e-9));
      const ElasticMotionInSpace one = stiff.by(2, 8), other = rigid.by(2, 8);
      for (const double s : {0.5, 2.5}) {
        const Cuts expects = cuts_of(other.loads_at(si<Time>(0.4)), s);
        check_alike(cuts_of(one.loads_at(si<Time>(0.4)), s), expects, expects, 1e-8);
      }
    }
  }
  // What is left falls as the flexibility.
  const auto apart = [](double k) {
    Scene scene = in_the_plane(false, shaking);
    scene.hinge += stiffness(k);
    const auto joint_alone = [](Project& project) {
      std::erase_if(project.elastic_beside, [](const ElasticBeside& of) {
        return !std::holds_alternative<spatial::ElasticJoint>(of.place);
      });
    };
    return 1.0 - moved(scene, joint_alone).frequencies(8, 1).front() /
                     moved(scene, rigid_beside).frequencies(8, 1).front();
  };
  const double once = apart(1e7), ten_times = apart(1e8);
  CHECK(once > 1e-6);
  CHECK(ten_times == Approx(0.1 * once).epsilon(0.05));
}

TEST_CASE("a rod in space of a stout section is a rigid rod", "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    CAPTURE(body);
    const Scene scene = in_the_plane(body, slightly, false);
    const auto of_side = [&](double side) {
      return moved(scene, [&](Project& project) {
        const Section section{Plate{si<Length>(side), si<Length>(side)}, {}};
        Segment& rod = project.elastic_beside.front().beam.segments.front();
        rod.from = rod.to = section;
      });
    };
    const Moved stout = of_side(body ? 1.0 : 10.0), rigid = alone(scene);
    const double within = body ? 1e-4 : 1e-8;
    const std::vector<double> found = stout.frequencies(8, 3), expected = rigid.frequencies(8, 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(within));
    const ElasticMotionInSpace one = stout.by(2, 8), other = rigid.by(2, 8);
    for (const double s : {0.5, 2.5}) {
      const Cuts expects = cuts_of(other.loads_at(si<Time>(0.1)), s);
      check_alike(cuts_of(one.loads_at(si<Time>(0.1)), s), expects, expects, within);
    }
  }
}

TEST_CASE("a model in space is chosen with the rods and joints of the case",
          "[elastic_rods_in_space]") {
  Scene scene = in_the_plane(false, shaking);
  scene.side = 0.001;
  scene.hinge += stiffness(5e5);
  const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
  CHECK_THAT(of.reason, Catch::Contains("(joint hinge, stay elastic as well)"));
  Project alone = parse_project("lever.toml", scene.text());
  alone.elastic_beside.clear();
  CHECK(choose_model(alone).frequencies.front() > 1.01 * of.frequencies.front());
}

TEST_CASE("rods in space that cannot be laid out count as rigid, and say why",
          "[elastic_rods_in_space]") {
  const auto obstacle = [](const Scene& scene) {
    const Project project = parse_project("lever.toml", scene.text());
    REQUIRE(!project.elastic_beside.empty());
    return obstacle_to_elasticity(project, project.elastic_beside.front());
  };
  const double l = (crane_foot - crane_head).norm(), even = 20.0 * l * l / 12.0;
  const auto of_inertia = [&](const Vector3d& inertia, const std::string& section = "bar") {
    Scene scene;
    hold_by_body(scene, 20.0, crane_foot, crane_head, "M", "lever", inertia, section);
    return scene;
  };
  CHECK(obstacle(of_inertia({0.0, even, even})).empty());
  CHECK_THAT(obstacle(of_inertia({0.0, 0.5 * even, 0.5 * even})), Catch::Contains("inertia"));
  CHECK_THAT(obstacle(of_inertia({0.0, 1.9 * even, 1.9 * even})), Catch::Contains("inertia"));
  Scene flat = of_inertia({0.0, even, even}, "flat");
  CHECK_THAT(obstacle(flat), Catch::Contains("where its section points is not said (z)"));
  flat.rod += "z = [0.0, 0.6, 0.8]\n";
  CHECK(obstacle(flat).empty());
  flat.rod.replace(flat.rod.find("z = "), std::string::npos, "z = \"x\"\n");
  CHECK_THROWS_WITH(parse_project("lever.toml", flat.text()),
                    Catch::Contains("the section's z stands across the rod"));
  Scene aside = of_inertia({0.0, even, even});
  const std::string centre = "m\", \"0 m\", \"0 m\"]\ninertia";
  aside.bodies.replace(aside.bodies.find(centre), centre.size(),
                       "m\", \"0.1 m\", \"0 m\"]\ninertia");
  CHECK_THAT(obstacle(aside), Catch::Contains("beside its line"));
  Scene pushed = of_inertia({0.0, even, even});
  pushed.forces =
      "[forces.f]\nkind = \"line force\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\n"
      "direction = \"z\"\nsize = \"1 N/m\"\n";
  CHECK_THAT(obstacle(pushed), Catch::Contains("f acts along it"));
  const std::string said = elastic_beside_text(parse_project("l.toml", pushed.text()));
  CHECK_THAT(said, Catch::Contains("(rod stay counts as rigid: f acts along it)"));
}

TEST_CASE("bad input of joints in space that give way", "[elastic_rods_in_space]") {
  const auto problems = [](const Scene& scene) -> std::string {
    try {
      parse_project("lever.toml", scene.text());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Scene damped = in_the_plane(false, shaking);
  damped.hinge += "turning_damping = \"1 N m s/rad\"\n";
  CHECK_THAT(problems(damped), Catch::Contains("without \"turning_stiffness\" nothing does"));
  Scene ball;
  ball.hinge = "kind = \"spherical\"\n" + turning(1e3);
  CHECK_THAT(problems(ball), Catch::Contains("turning_stiffness"));
  Scene changed = in_the_plane(false, shaking);
  changed.hinge += stiffness(5e5);
  changed.rod +=
      "[[situations]]\nname = \"one\"\n[[situations]]\nname = \"other\"\n"
      "set = { \"joints.hinge.stiffness\" = \"6e5 N/m\" }\n";
  CHECK_THAT(problems(changed), Catch::Contains("those of all situations"));
}

TEST_CASE("random levers on oblique struts have the frequencies of finite elements",
          "[.][random_rods_in_space]") {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 30; ++i) {
    const Vector3d foot(between(0.3, 3.5), between(-1.5, 1.5), between(-2.0, -0.8));
    const double mass = between(1.0, 30.0), side = between(0.01, 0.05);
    Scene scene;
    scene.side = side;
    hold_by_body(scene, mass, foot, crane_head, "M", "lever",
                 of_even_rod(mass, side, (foot - crane_head).norm()));
    const Moved of = moved(scene, [](Project& project) {
      project.model.youngs_modulus = 210e9;
      project.model.shear_modulus = 81e9;
    });
    const Crane elements(of.project, crane_head, foot, mass, of.project.rods.front().section, 15);
    const std::vector<double> expected = elements.frequencies(5), found = of.frequencies(24, 5);
    for (std::size_t k = 0; k < 5; ++k) {
      CAPTURE(i, k, foot.transpose(), mass, side);
      CHECK(found[k] == Approx(expected[k]).epsilon(5e-4));
    }
  }
}

}  // namespace elastic_rods_in_space_test
