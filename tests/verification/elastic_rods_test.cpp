// Rods that are elastic by their section beside the verified beam: closed forms of a lever on a
// rod, elements of the test's own, and rods of no flexibility, which are rigid ones.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace elastic_rods_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 2.1e11;
constexpr double L = 4.0;  ///< of the lever
constexpr double rho = 7850.0;
constexpr double A = 0.06 * 0.08 - 0.052 * 0.072;
constexpr double M = rho * A * L;  ///< of the lever [kg]
const double I = (0.06 * std::pow(0.08, 3) - 0.052 * std::pow(0.072, 3)) / 12.0;

const std::string at_ground = "connect = [\"lever.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n";

/// What the texts of the scenes are put together from.
struct Scene {
  double gravity = 0.0;
  double angle = 0.0;  ///< of the lever [deg]
  std::string hinge = "kind = \"pin\"\n" + at_ground;
  std::string bodies, joints, forces, rod;
  double side = 0.002;  ///< of the rod's square section [m]
  std::string model;
  bool moves = false;

  std::string text() const {
    return "[case]\nname = \"lever\"\nkind = \"planar\"\n[mechanism]\n" +
           fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) +
           "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\"], M = [\"2 m\", \"0 m\"], "
           "B = [\"4 m\", \"0 m\"] }\n" +
           fmt::format("sketch = {{ at = [\"0 m\", \"0 m\"], angle = \"{} deg\" }}\n", angle) +
           bodies + "[joints.hinge]\n" + hinge + joints + forces +
           (moves ? "" : "[motion]\nduration = \"1 s\"\n") +
           "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
           "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
           fmt::format("[sections.bar]\nkind = \"plate\"\nwidth = \"{0} m\"\nheight = \"{0} m\"\n",
                       side) +
           "[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n"
           "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n" +
           model + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" + rod;
  }
};

/// A rod without mass from the lever's end to the ground.
void hold_by_link(Scene& scene, double x, double y, double length) {
  scene.joints += fmt::format(
      "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"ground\"]\n"
      "at = [\"{} m\", \"{} m\"]\nlength = \"{:.17g} m\"\n",
      x, y, length);
  scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
}

/// A rod of this mass from the lever's end to the ground or another body. Its points lie along
/// (3, 4) of its own axes.
void hold_by_body(Scene& scene, double mass, double x, double y, double length,
                  const std::string& foot = "\"ground\"", double inertia_of_even = 1.0,
                  const std::string& name = "stay") {
  const Eigen::Vector2d end(L * std::cos(scene.angle * pi / 180.0),
                            L * std::sin(scene.angle * pi / 180.0));
  const Eigen::Vector2d line = end - Eigen::Vector2d(x, y);
  const Eigen::Vector2d middle = 0.5 * (end + Eigen::Vector2d(x, y));
  scene.bodies += fmt::format(
      "[bodies.{0}]\nmass = \"{1:.17g} kg\"\ninertia = \"{2:.17g} kg m^2\"\n"
      "points = {{ P = [\"{3:.17g} m\", \"{4:.17g} m\"], Q = [\"{5:.17g} m\", \"{6:.17g} m\"] }}\n"
      "sketch = {{ at = [\"{7} m\", \"{8} m\"], angle = \"{9} deg\" }}\n",
      name, mass, inertia_of_even * mass * length * length / 12.0, -0.3 * length, -0.4 * length,
      0.3 * length, 0.4 * length, middle.x(), middle.y(),
      (std::atan2(line.y(), line.x()) - std::atan2(4.0, 3.0)) * 180.0 / pi);
  scene.joints += fmt::format(
      "[joints.head]\nkind = \"pin\"\nconnect = [\"{0}.Q\", \"lever.B\"]\n"
      "[joints.foot]\nkind = \"pin\"\nconnect = [\"{0}.P\", {1}]\n",
      name, foot);
  if (foot == "\"ground\"") scene.joints += fmt::format("at = [\"{} m\", \"{} m\"]\n", x, y);
  scene.rod = fmt::format(
      "[[rods]]\nname = \"stay\"\nfrom = \"{0}.P\"\nto = \"{0}.Q\"\nsection = \"bar\"\n"
      "curve = \"c\"\n",
      name);
}

/// A shoe under the lever's end that a driver moves up and down.
void drive_shoe(Scene& scene, double x, double y, const std::string& driver) {
  scene.moves = true;
  scene.bodies += fmt::format(
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = {{ S = [\"0 m\", \"0 m\"] }}\n"
      "sketch = {{ at = [\"{} m\", \"{} m\"] }}\n",
      x, y);
  scene.joints += fmt::format(
      "[joints.guide]\nkind = \"slider\"\npoint = \"shoe.S\"\nthrough = [\"{} m\", \"0 m\"]\n"
      "direction = \"90 deg\"\nangle = \"-90 deg\"\n"
      "[drivers.shake]\ncoordinate = \"y\"\npoint = \"shoe.S\"\n",
      x);
  scene.joints += driver;
}

std::string force_at_end(double x, double y) {
  const auto one = [](const char* name, double direction, double size) {
    return fmt::format(
        "[forces.{}]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"{} deg\"\n"
        "size = \"{:.17g} N\"\n",
        name, direction, size);
  };
  return one("across", 0.0, x) + one("along", 90.0, y);
}

/// A case and its motion by rigid bodies.
struct Solved {
  Project project;
  planar::Motion motion;
  planar::BeamBody body;
  std::shared_ptr<planar::StatesAround> finder;

  explicit Solved(const Scene& scene, int instants = 0)
      : project(parse_project("lever.toml", scene.text())),
        motion(instants > 0 ? planar::solve_motion(planar_of(project), instants)
                            : planar::solve_motion(planar_of(project))),
        body(planar::beam_body_of(project.beam, project.beam_body)),
        finder(std::make_shared<planar::StatesAround>(planar_of(project), motion)) {}
  Solved(const Solved&) = delete;
  Solved& operator=(const Solved&) = delete;

  BeamLoads loads(const planar::State& state) const {
    return planar::beam_loads_of(planar_of(project), state, body);
  }
  RigidMotion rigid() const {
    return {&planar_of(project), &motion, &project.beam,
            [this](Time time) { return loads(finder->at(time.value())); }};
  }
  LoadedPosture posture(const ElasticBody& elastic, double factor = 1.0) const {
    const planar::State& state = motion.states.front();
    return loaded_posture(planar_of(project), state, elastic, project.beam, loads(state), factor);
  }
  std::vector<double> frequencies(const ElasticBody& elastic, std::size_t count) const {
    return modes_in_posture(posture(elastic), count).frequencies;
  }
  /// All forces times which the posture no longer stands.
  double critical_factor(const ElasticBody& elastic) const {
    const auto holds = [&](double factor) {
      try {
        return stands(posture(elastic, factor));
      } catch (const AnalysisError&) {
        return false;  // to round-off it is free to move there
      }
    };
    double low = 0.0, high = 1.0;
    while (holds(high)) high *= 2.0;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (holds(middle) ? low : high) = middle;
    }
    return low;
  }
};

/// So many times stiffer.
void stiffen(ElasticBody& of, double EA, double GA, double EI) {
  for (flexible::LinkStretch& stretch : of.stretches) {
    stretch.EA = EA * stretch.EA;
    stretch.GA = GA * stretch.GA;
    stretch.EI = EI * stretch.EI;
  }
}

/// Without shear.
ElasticBody slender(const Project& project, int parts) {
  ElasticBody elastic = elastic_body_of(project, parts);
  stiffen(elastic, 1.0, 1e6, 1.0);
  for (ElasticBody& other : elastic.beside) stiffen(other, 1.0, 1e6, 1.0);
  return elastic;
}

/// Roots z of EI (z/L)^3 (sin z coth z - cos z) = 2 k sin z, ascending: an even beam on a hinge
/// with a spring at its end, w = sin(z x/L) + sin z/sinh z sinh(z x/L), EI w''' = k w at the end.
std::vector<double> roots_on_spring(double EI, double k, int count) {
  const auto f = [&](double z) {
    return EI * std::pow(z / L, 3) * (std::sin(z) / std::tanh(z) - std::cos(z)) -
           2.0 * k * std::sin(z);
  };
  std::vector<double> roots;
  constexpr double step = 1e-3;
  for (double z = 0.05; static_cast<int>(roots.size()) < count; z += step) {
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

}  // namespace

TEST_CASE("a beam on a hinge and a rod vibrates as on a spring EA/l", "[elastic_rods]") {
  for (const double side : {0.0005, 0.002, 0.01}) {
    Scene scene;
    scene.side = side;
    hold_by_link(scene, L, -2.0, 2.0);
    const Solved of(scene);
    const ElasticBody elastic = slender(of.project, 32);
    REQUIRE(elastic.lines.size() == 1);
    const std::vector<double> found = of.frequencies(elastic, 3);
    const std::vector<double> z = roots_on_spring(E * I, E * side * side / 2.0, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(side, i);
      CHECK(found[i] ==
            Approx(std::pow(z[i] / L, 2) * std::sqrt(E * I / (rho * A)) / (2 * pi)).epsilon(2e-4));
    }
    // A stiff lever on the spring alone: omega^2 = 3 k/M.
    ElasticBody stiff = elastic;
    stiffen(stiff, 1e6, 1.0, 1e6);
    const double k = E * side * side / 2.0;
    CHECK(of.frequencies(stiff, 1).front() ==
          Approx(std::sqrt(3.0 * k / M) / (2 * pi)).epsilon(1e-4));
  }
}

TEST_CASE("a stiff lever on an elastic rod buckles at k L", "[elastic_rods]") {
  // Timoshenko, Gere, Theory of Elastic Stability (1961), section 2.1: the restoring moment k L^2
  // phi against P L phi.
  Scene scene;
  scene.angle = 90.0;
  hold_by_link(scene, 2.0, L, 2.0);
  constexpr double P = 1000.0;
  scene.forces = force_at_end(0.0, -P);
  const Solved of(scene);
  ElasticBody elastic = elastic_body_of(of.project, 8);
  stiffen(elastic, 1e7, 1e7, 1e7);
  const double k = E * scene.side * scene.side / 2.0;
  CHECK(of.critical_factor(elastic) == Approx(k * L / P).epsilon(1e-5));
  elastic.lines.clear();
  CHECK(of.critical_factor(elastic) > 1e3 * k * L / P);
}

TEST_CASE("what a pushed rod of a stiff lever adds to its stiffness", "[elastic_rods]") {
  // With r the lever's end from the rod's foot, u its direction, the second derivative of the
  // energy by the turn is k (u.r')^2 + F ((r'.r' - (u.r')^2)/l + u.r'') - P L, F the tension, which
  // the force H across asks for: F u.r' = H L of the end moving by -L phi along x.
  for (const double H : {-2e3, 1e3}) {
    Scene scene;
    scene.angle = 90.0;
    const Eigen::Vector2d foot(1.5, 2.5), end(0.0, L);
    const double l = (end - foot).norm();
    hold_by_link(scene, foot.x(), foot.y(), l);
    constexpr double P = 900.0;
    scene.forces = force_at_end(H, -P);
    const Solved of(scene);
    ElasticBody elastic = elastic_body_of(of.project, 8);
    stiffen(elastic, 1e7, 1e7, 1e7);
    const Eigen::Vector2d u = (end - foot) / l, first(-L, 0.0), second(0.0, -L);
    const double F = H * first.x() / u.dot(first);
    const double k = E * scene.side * scene.side / l;
    const double along = u.dot(first);
    const double per_load = F * ((first.squaredNorm() - along * along) / l + u.dot(second)) - P * L;
    CAPTURE(H, F);
    REQUIRE(per_load < 0.0);
    CHECK(of.critical_factor(elastic) == Approx(-k * along * along / per_load).epsilon(1e-5));
  }
}

namespace {

/// Elements of the test's own: bars that bend by cubics and stretch linearly, consistent mass.
/// Source: Przemieniecki, Theory of Matrix Structural Analysis (1968), sections 5.6 and 11.5.
struct Frame {
  Eigen::MatrixXd K, M;

  explicit Frame(Eigen::Index freedoms) : K(Eigen::MatrixXd::Zero(freedoms, freedoms)), M(K) {}

  /// `dofs`: u, v, phi of both ends, in the world; -1: held.
  void add(const std::array<int, 6>& dofs, double length, double angle, double EA, double EI,
           double mass) {
    const double l = length;
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero(), m = k;
    k(0, 0) = k(3, 3) = EA / l;
    k(0, 3) = k(3, 0) = -EA / l;
    m(0, 0) = m(3, 3) = mass * l / 3;
    m(0, 3) = m(3, 0) = mass * l / 6;
    Eigen::Matrix4d b, c;
    b << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l,
        2 * l * l, -6 * l, 4 * l * l;
    c << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l,
        -13 * l, -3 * l * l, -22 * l, 4 * l * l;
    const std::array<int, 4> bends{1, 2, 4, 5};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        k(bends[i], bends[j]) = EI / (l * l * l) * b(i, j);
        m(bends[i], bends[j]) = mass * l / 420 * c(i, j);
      }
    }
    Eigen::Matrix<double, 6, 6> T = Eigen::Matrix<double, 6, 6>::Zero();
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(-angle).toRotationMatrix();
    T.block<2, 2>(0, 0) = T.block<2, 2>(3, 3) = R;
    T(2, 2) = T(5, 5) = 1.0;
    k = T.transpose() * k * T;
    m = T.transpose() * m * T;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        if (dofs[i] < 0 || dofs[j] < 0) continue;
        K(dofs[i], dofs[j]) += k(i, j);
        M(dofs[i], dofs[j]) += m(i, j);
      }
    }
  }
};

/// Frequencies of the lever on a hinge and a rod between pins [Hz].
std::vector<double> by_elements(const Eigen::Vector2d& foot, double rod_mass, double rod_side,
                                int count) {
  constexpr int n = 24;
  const Eigen::Vector2d end(L, 0.0), line = end - foot;
  const double l = line.norm();
  int next = 0;
  // Nodes of the lever: the first turns alone; of the rod likewise, its last moves with the lever.
  std::vector<std::array<int, 3>> lever{{-1, -1, next++}}, rod{{-1, -1, next++}};
  for (int i = 1; i <= n; ++i) {
    lever.push_back({next, next + 1, next + 2});
    next += 3;
  }
  for (int i = 1; i < n; ++i) {
    rod.push_back({next, next + 1, next + 2});
    next += 3;
  }
  rod.push_back({lever.back()[0], lever.back()[1], next++});
  Frame frame(next);
  const auto add_all = [&](const std::vector<std::array<int, 3>>& nodes, double length,
                           double angle, double EA, double EI, double mass) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const auto& [a, b, c] = nodes[i];
      const auto& [d, e, f] = nodes[i + 1];
      frame.add({a, b, c, d, e, f}, length / n, angle, EA, EI, mass);
    }
  };
  add_all(lever, L, 0.0, E * A, E * I, rho * A);
  add_all(rod, l, std::atan2(line.y(), line.x()), E * rod_side * rod_side,
          E * std::pow(rod_side, 4) / 12.0, rod_mass / l);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(frame.K, frame.M,
                                                                         Eigen::EigenvaluesOnly);
  std::vector<double> frequencies;
  for (int i = 0; i < count; ++i)
    frequencies.push_back(std::sqrt(solver.eigenvalues()[i]) / (2 * pi));
  return frequencies;
}

}  // namespace

TEST_CASE("a rod with mass bends between its pins", "[elastic_rods]") {
  const Eigen::Vector2d foot(3.0, -std::sqrt(3.0));
  for (const double side : {0.02, 0.03}) {
    for (const double mass : {2.0, 20.0}) {
      Scene scene;
      scene.side = side;
      hold_by_body(scene, mass, foot.x(), foot.y(), 2.0);
      const Solved of(scene);
      const ElasticBody elastic = slender(of.project, 32);
      REQUIRE(elastic.beside.size() == 1);
      const std::vector<double> found = of.frequencies(elastic, 4);
      const std::vector<double> expected = by_elements(foot, mass, side, 4);
      for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(side, mass, i);
        CHECK(found[i] == Approx(expected[i]).epsilon(3e-4));
      }
    }
  }
}

TEST_CASE("a rod has the mass, centre and inertia of its body, and is in balance",
          "[elastic_rods]") {
  // Of inertias between 0.6 and 1.8 of an even rod the mass per length is nowhere negative.
  for (const double part : {0.65, 1.0, 1.75}) {
    Scene scene;
    scene.gravity = 9.81;
    scene.angle = 20.0;
    const Eigen::Vector2d end(L * std::cos(pi / 9), L * std::sin(pi / 9)), foot(3.0, -0.8);
    const double l = (end - foot).norm();
    drive_shoe(scene, foot.x(), foot.y(),
               "kind = \"harmonic\"\nmean = \"-0.8 m\"\namplitude = \"0.3 m\"\nfrequency = "
               "\"1.2 Hz\"\n");
    hold_by_body(scene, 40.0, foot.x(), foot.y(), l, "\"shoe.S\"", part);
    const Solved of(scene, 24);
    const ElasticBody elastic = elastic_body_of(of.project, 8);
    REQUIRE(elastic.beside.size() == 1);
    const ElasticBody& rod = elastic.beside.front();
    flexible::Link link;
    link.kind = flexible::LinkKind::full;
    link.length = rod.length;
    link.stretches = rod.stretches;
    const flexible::RigidMass mass = flexible::rigid_mass_of(link);
    CAPTURE(part);
    CHECK(mass.mass == Approx(40.0).epsilon(1e-12));
    CHECK(mass.centre.x() == Approx(0.5 * l).epsilon(1e-12));
    CHECK(mass.inertia == Approx(part * 40.0 * l * l / 12.0).epsilon(1e-9));
    for (const planar::State& state : of.motion.states) {
      const BeamLoads loads = planar::beam_loads_of(planar_of(of.project), state, rod.laid_out);
      double largest = 0.0;
      for (const PointLoad& load : loads.points) largest = std::max(largest, load.force.norm());
      const Imbalance left = imbalance_of(loads);
      CHECK(left.force.norm() < 1e-7 * largest);
      CHECK(left.moment.norm() < 1e-7 * largest * l);
    }
  }
}

namespace {

void check_same_loads(const BeamLoads& found, const BeamLoads& expected, double within) {
  const CutForceDiagram one = cut_forces_of(found), other = cut_forces_of(expected);
  double N = 0.0, V = 0.0, M = 0.0;
  for (int i = 1; i < 20; ++i) {
    const CutForces cut = other.at({si<Length>(i * L / 20), Side::before});
    N = std::max(N, std::abs(cut.N.value()));
    V = std::max(V, std::abs(cut.V_z.value()));
    M = std::max(M, std::abs(cut.M_y.value()));
  }
  for (int i = 1; i < 20; ++i) {
    const Station at{si<Length>(i * L / 20), Side::before};
    CHECK(one.at(at).N.value() == Approx(other.at(at).N.value()).margin(within * std::max(N, V)));
    CHECK(one.at(at).V_z.value() == Approx(other.at(at).V_z.value()).margin(within * V));
    CHECK(one.at(at).M_y.value() == Approx(other.at(at).M_y.value()).margin(within * M));
  }
}

/// The lever, loaded at its end and moved by a shoe by way of an inclined rod.
Scene moved(bool body, const std::string& driver) {
  Scene scene;
  scene.gravity = 9.81;
  scene.angle = 30.0;
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const double l = (end - foot).norm();
  drive_shoe(scene, foot.x(), foot.y(), driver);
  if (body) {
    hold_by_body(scene, 12.0, foot.x(), foot.y(), l, "\"shoe.S\"");
    scene.side = 0.03;
  } else {
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  scene.forces = force_at_end(-150.0, -400.0);
  return scene;
}

const std::string shaking =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.05 m\"\nfrequency = \"1.1 Hz\"\n";
const std::string lifting =
    "kind = \"smooth step\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\nend = \"0.8 s\"\n";

}  // namespace

TEST_CASE("a rod of no flexibility is a rigid rod", "[elastic_rods]") {
  for (const bool body : {false, true}) {
    for (const std::string& driver : {shaking, lifting}) {
      Scene scene = moved(body, driver);
      const Solved of(scene, 48);
      ElasticBody stiff = elastic_body_of(of.project, 8);
      stiff.retardation = 1e-3;
      for (ElasticBody& other : stiff.beside) stiffen(other, 1e9, 1e9, 1e9);
      for (ElasticLine& line : stiff.lines) line.EA *= 1e12;
      ElasticBody alone = stiff;
      alone.beside.clear();
      alone.lines.clear();
      CAPTURE(body, driver);
      const std::vector<double> found = of.frequencies(stiff, 3), rigid = of.frequencies(alone, 3);
      // The mass of a body is gathered in nodes, as of any elastic link: eight parts.
      const double within = body ? 1e-6 : 1e-9;
      for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(rigid[i]).epsilon(within));
      CHECK(of.critical_factor(stiff) ==
            Approx(of.critical_factor(alone)).epsilon(0.1 * within + 1e-8));
      const Time time = si<Time>(0.4);
      check_same_loads(bent_statically(of.rigid(), stiff)(time),
                       bent_statically(of.rigid(), alone)(time), 1e-9);
      check_same_loads(ElasticMotion(of.rigid(), stiff, 2).loads_at(time),
                       ElasticMotion(of.rigid(), alone, 2).loads_at(time), within);
    }
  }
}

TEST_CASE("a stiff lever on a rod that is shaken swings as one mass on a spring",
          "[elastic_rods]") {
  // M/3 at its end on k = EA/l: amplitude 1/(1 - r^2) of the rigid motion; what the shaken end
  // bears grows so.
  for (const double r : {0.3, 0.7, 1.6}) {
    Scene scene;
    const double k = E * scene.side * scene.side / 2.0;
    const double omega = r * std::sqrt(3.0 * k / M);
    drive_shoe(scene, L, -2.0,
               fmt::format("kind = \"harmonic\"\nmean = \"-2 m\"\namplitude = \"0.0002 m\"\n"
                           "angular_frequency = \"{:.17g} rad/s\"\n",
                           omega));
    scene.joints +=
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"2 m\"\n";
    scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
    const Solved of(scene, 48);
    ElasticBody elastic = elastic_body_of(of.project, 8);
    stiffen(elastic, 1e6, 1e6, 1e6);
    const ElasticMotion motion(of.rigid(), elastic, 1);
    CHECK(motion.lowest_frequency() == Approx(omega / r / (2 * pi)).epsilon(1e-3));
    for (const double part : {0.1, 0.25, 0.7}) {
      const Time time = si<Time>(part * of.motion.period);
      const auto moment = [&](const BeamLoads& loads) {
        return cut_forces_of(loads).at({si<Length>(0.5 * L), Side::before}).M_y.value();
      };
      CAPTURE(r, part);
      CHECK(moment(motion.loads_at(time)) ==
            Approx(moment(of.loads(of.finder->at(time.value()))) / (1.0 - r * r)).epsilon(3e-3));
    }
  }
}

TEST_CASE("a model is chosen with the rods of the case", "[elastic_rods]") {
  Scene scene = moved(false, shaking);
  const ModelChoice with = choose_model(parse_project("lever.toml", scene.text()));
  CHECK(with.reason.find("(stay elastic as well)") != std::string::npos);
  const Solved of(scene);
  CHECK(with.frequencies.front() < 0.9 * [&] {
    ElasticBody alone = elastic_body_of(of.project, 8);
    alone.lines.clear();
    return of.frequencies(alone, 1).front();
  }());
  scene.rod.clear();
  const ModelChoice without = choose_model(parse_project("lever.toml", scene.text()));
  CHECK(without.reason.find("elastic as well") == std::string::npos);
  CHECK(without.frequencies.front() > with.frequencies.front());
}

TEST_CASE("N/N_cr in the plane is that of a lever on an elastic rod", "[elastic_rods]") {
  Scene scene;
  scene.angle = 90.0;
  scene.side = 0.0002;
  hold_by_link(scene, 2.0, L, 2.0);
  constexpr double P = 2000.0;
  scene.forces = force_at_end(0.0, -P);
  const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
  const double k = E * scene.side * scene.side / 2.0;
  // The lever bends as well, by Euler's load between pins, 1/P_cr of both together to a per cent
  // as Southwell's sum where one is far below the other.
  const double euler = pi * pi * E * I / (L * L);
  REQUIRE(k * L < 0.3 * euler);
  CHECK(of.second_order.in_plane.part >= P / (k * L));
  CHECK(of.second_order.in_plane.part <= P / (k * L) + P / euler);
}

TEST_CASE("a rod between pins that buckles is judged by its own check", "[elastic_rods]") {
  // The lever bears no axial force, and how the strut bows moves nothing: N/N_cr of the lever is
  // small whatever the strut's own.
  const double euler = pi * pi * E * std::pow(0.03, 4) / 12.0 / 4.0;
  for (const double part : {0.6, 1.3}) {
    Scene scene;
    scene.gravity = 9.81;  // so that something bends the lever
    scene.side = 0.03;
    hold_by_body(scene, 5.0, L, -2.0, 2.0);
    scene.forces = force_at_end(0.0, -part * euler);
    const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
    CAPTURE(part, of.reason);
    CHECK(of.second_order.in_plane.part < 0.02);
    CHECK((of.reason.find("a rod, buckles by itself") != std::string::npos) == (part > 1.0));
    if (part > 1.0) continue;
    // omega^2 of the strut between pins falls by N/N_cr: Timoshenko, Young, Weaver, Vibration
    // Problems in Engineering (1974), section 5.12.
    const Solved solved(scene);
    const ElasticBody elastic = slender(solved.project, 32);
    REQUIRE(elastic.beside.front().between_pins);
    const double free = std::pow(pi / 2.0, 2) * std::sqrt(E * std::pow(0.03, 4) / 12.0 / 2.5);
    const std::vector<double> found = solved.frequencies(elastic, 6);
    // With half of the lever's weight and, on the average, of its own.
    const double N = part * euler + 0.5 * (M + 5.0) * 9.81;
    const double expected = free * std::sqrt(1.0 - N / euler) / (2 * pi);
    CHECK(std::any_of(found.begin(), found.end(),
                      [&](double f) { return std::abs(f - expected) < 2e-3 * expected; }));
  }
}

namespace {

std::string obstacle_in(const Scene& scene) {
  const Project project = parse_project("lever.toml", scene.text());
  REQUIRE(!project.elastic_beside.empty());
  return obstacle_to_elasticity(project, project.elastic_beside.front());
}

Scene held_by_body(double inertia = 1.0) {
  Scene scene;
  hold_by_body(scene, 20.0, 3.0, -std::sqrt(3.0), 2.0, "\"ground\"", inertia);
  return scene;
}

}  // namespace

TEST_CASE("rods that cannot be laid out count as rigid, and say why", "[elastic_rods]") {
  CHECK(obstacle_in(held_by_body()).empty());
  CHECK(obstacle_in(held_by_body(0.5)).find("inertia") != std::string::npos);
  CHECK(obstacle_in(held_by_body(1.9)).find("inertia") != std::string::npos);
  Scene twice = held_by_body();
  twice.rod +=
      "[[rods]]\nname = \"second\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\n"
      "section = \"bar\"\ncurve = \"c\"\n";
  CHECK(obstacle_in(twice).find("several rods") != std::string::npos);
  Scene beyond = held_by_body();
  beyond.forces =
      "[forces.f]\nkind = \"force\"\npoint = \"stay.R\"\ndirection = \"0 deg\"\nsize = \"1 N\"\n";
  const std::string points = "Q = [";
  beyond.bodies.insert(beyond.bodies.find(points), "R = [\"0.9 m\", \"1.2 m\"], ");
  CHECK(obstacle_in(beyond).find("f takes hold of its body beyond") != std::string::npos);
  Scene aside = held_by_body();
  aside.bodies.insert(aside.bodies.find("points"), "centre = [\"0.1 m\", \"0 m\"]\n");
  CHECK(obstacle_in(aside).find("beside its line") != std::string::npos);
  const std::string said = elastic_beside_text(parse_project("l.toml", aside.text()));
  CHECK(said.find("(rod stay counts as rigid: its centre of mass") != std::string::npos);
}

TEST_CASE("a rod without mass is judged by what its joint bears", "[elastic_rods]") {
  // Half of what stands on the lever, M g/2, and P at its end.
  Scene scene;
  scene.gravity = 9.81;
  scene.side = 0.03;
  hold_by_link(scene, L, 2.0, 2.0);
  constexpr double P = 1500.0;
  scene.forces = force_at_end(0.0, -P);
  const Project project = parse_project("lever.toml", scene.text());
  const std::deque<SituationRun> runs = run_situations(project, {});
  const NeighbourChecks checks = check_rods(project, runs);
  REQUIRE(checks.results.size() == 1);
  CHECK(checks.results.front().check.criterion == Criterion::rod);
  CHECK(checks.results.front().check.acting.value() ==
        Approx(0.5 * rho * A * L * 9.81 + P).epsilon(1e-9));
  scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"guy\"\nsection = \"bar\"\ncurve = \"c\"\n";
  CHECK_THROWS_AS(parse_project("lever.toml", scene.text()), InputError);
  // A spring of k pulls with k times what it is longer than without force.
  Scene hung = scene;
  const std::string distance = "[joints.stay]";
  hung.joints.resize(hung.joints.find(distance));
  hung.joints +=
      "[drivers.hold]\ncoordinate = \"angle\"\npoint = \"lever.A\"\nkind = \"hold\"\n"
      "value = \"0 deg\"\n";
  hung.forces +=
      "[forces.guy]\nkind = \"spring\"\nconnect = [\"lever.B\", \"ground\"]\n"
      "at = [\"4 m\", \"2 m\"]\nstiffness = \"20 kN/m\"\nfree_length = \"1.9 m\"\n";
  hung.rod =
      "[[rods]]\nname = \"guy\"\nlink = \"guy\"\nsection = \"bar\"\ncurve = \"c\"\n"
      "buckling_length = \"2 m\"\n";
  const Project sprung = parse_project("hung.toml", hung.text());
  CHECK(sprung.elastic_beside.empty());
  const NeighbourChecks of = check_rods(sprung, run_situations(sprung, {}));
  REQUIRE(of.results.size() == 1);
  CHECK(of.results.front().check.acting.value() == Approx(2000.0).epsilon(1e-9));
}

namespace {

/// Puts keys behind the head of a joint's table.
void give(Scene& scene, const std::string& joint, const std::string& keys) {
  const std::string head = "[joints." + joint + "]\n";
  const std::size_t at = scene.joints.find(head);
  REQUIRE(at != std::string::npos);
  scene.joints.insert(at + head.size(), keys);
}

std::string stiffness(double k) { return fmt::format("stiffness = \"{:.17g} N/m\"\n", k); }

ElasticBody stiff_lever(const Project& project, double factor = 1e7) {
  ElasticBody elastic = elastic_body_of(project, 32);
  stiffen(elastic, factor, factor, factor);
  return elastic;
}

double moment_at(const BeamLoads& loads, double s) {
  return cut_forces_of(loads).at({si<Length>(s), Side::behind}).M_y.value();
}

}  // namespace

TEST_CASE("pins that give way and a rod are springs in series", "[elastic_joints]") {
  Scene scene;
  hold_by_body(scene, 1e-6, L, -2.0, 2.0);
  constexpr double k1 = 3e5, k2 = 7e5;
  give(scene, "head", stiffness(k1));
  give(scene, "foot", stiffness(k2));
  const Solved of(scene);
  const ElasticBody elastic = stiff_lever(of.project);
  REQUIRE(elastic.joints.size() == 2);
  const double k3 = E * scene.side * scene.side / 2.0;
  const double k = 1.0 / (1.0 / k1 + 1.0 / k2 + 1.0 / k3);
  CHECK(of.frequencies(elastic, 1).front() ==
        Approx(std::sqrt(3.0 * k / M) / (2 * pi)).epsilon(1e-4));
}

TEST_CASE("a stiff lever on a hinge and a stay that give way", "[elastic_joints]") {
  // Along it k/M, both ends alike 2 k/M, one against the other k L^2/2 over M L^2/12.
  constexpr double k = 2e5;
  for (const double angle : {0.0, 35.0}) {
    Scene scene;
    scene.angle = angle;
    scene.hinge += stiffness(k);
    const double c = std::cos(angle * pi / 180.0), s = std::sin(angle * pi / 180.0);
    hold_by_link(scene, L * c + 2.0 * s, L * s - 2.0 * c, 2.0);
    give(scene, "stay", stiffness(k));
    const Solved of(scene);
    const ElasticBody elastic = stiff_lever(of.project);
    // Its own stiffness counts, not that of the section.
    REQUIRE(elastic.lines.empty());
    const std::vector<double> found = of.frequencies(elastic, 3);
    const double squares[] = {k / M, 2.0 * k / M, 6.0 * k / M};
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(angle, i);
      CHECK(found[i] == Approx(std::sqrt(squares[i]) / (2 * pi)).epsilon(1e-4));
    }
  }
}

TEST_CASE("a lever in a clamp that gives way", "[elastic_joints]") {
  // omega^2 = 3 k/(M L^2); P_cr = k/L, M_0 = H L/(1 - P/P_cr) under H across its end: Timoshenko,
  // Gere, Theory of Elastic Stability (1961), section 2.1.
  constexpr double k = 5e4, P = 4000.0, H = 50.0;
  Scene scene;
  scene.angle = 90.0;
  scene.hinge =
      fmt::format("kind = \"rigid\"\nangle = \"90 deg\"\nturning_stiffness = \"{} N m/rad\"\n", k) +
      at_ground;
  scene.forces = force_at_end(H, -P);
  const Solved of(scene);
  const ElasticBody elastic = stiff_lever(of.project);
  REQUIRE(elastic.joints.size() == 1);
  CHECK(of.critical_factor(elastic) == Approx(k / (L * P)).epsilon(1e-5));
  CHECK(of.frequencies(elastic, 1).front() ==
        Approx(std::sqrt(3.0 * (k - P * L) / (M * L * L)) / (2 * pi)).epsilon(1e-4));
  const BeamLoads straight = of.loads(of.motion.states.front());
  const BeamLoads bent = bent_statically(of.rigid(), elastic)(Time{});
  CHECK(std::abs(moment_at(straight, 0.0)) == Approx(H * L).epsilon(1e-9));
  CHECK(moment_at(bent, 0.0) == Approx(moment_at(straight, 0.0) / (1.0 - P * L / k)).epsilon(1e-4));
  CHECK(imbalance_of(bent).force.norm() < 1e-6 * P);
  CHECK(imbalance_of(bent).moment.norm() < 1e-6 * P * L);
}

TEST_CASE("each kind of joint gives way where it holds", "[elastic_joints]") {
  constexpr double k = 3e5, turning = 8e4;
  const std::string both =
      stiffness(k) + fmt::format("turning_stiffness = \"{} N m/rad\"\n", turning);
  // Across and about its start: K = diag(k, k_phi), M = [M, M L/2; M L/2, M L^2/3].
  Eigen::Matrix2d mass;
  mass << M, M * L / 2.0, M * L / 2.0, M * L * L / 3.0;
  const Eigen::Matrix2d held = Eigen::Vector2d(k, turning).asDiagonal();
  const Eigen::Vector2d squares =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(held, mass).eigenvalues();
  const auto expect = [](const Scene& scene, std::vector<double> expected) {
    const Solved of(scene);
    const std::vector<double> found = of.frequencies(stiff_lever(of.project), expected.size());
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(scene.hinge, i);
      CHECK(found[i] == Approx(std::sqrt(expected[i]) / (2 * pi)).epsilon(1e-4));
    }
  };
  Scene clamped;
  clamped.hinge = "kind = \"rigid\"\n" + at_ground + both;
  expect(clamped, {k / M, squares[0], squares[1]});
  Scene guided;
  guided.hinge =
      "kind = \"slider\"\npoint = \"lever.A\"\nthrough = [\"0 m\", \"0 m\"]\n"
      "direction = \"0 deg\"\n" +
      both;
  guided.joints =
      "[drivers.along]\ncoordinate = \"x\"\npoint = \"lever.A\"\nkind = \"hold\"\n"
      "value = \"0 m\"\n";
  expect(guided, {squares[0], squares[1]});
  Scene slotted;
  slotted.joints =
      "[joints.slot]\nkind = \"pin in slot\"\npoint = \"lever.B\"\n"
      "through = [\"0 m\", \"0 m\"]\ndirection = \"0 deg\"\n" +
      stiffness(k);
  expect(slotted, {3.0 * k / M});
}

TEST_CASE("a rod of driven length is elastic as one that keeps it", "[elastic_rods]") {
  Scene kept, driven;
  hold_by_link(kept, 3.0, -2.0, std::sqrt(5.0));
  driven.joints = fmt::format(
      "[drivers.stay]\ncoordinate = \"length\"\npoints = [\"lever.B\", \"ground\"]\n"
      "at = [\"3 m\", \"-2 m\"]\nkind = \"hold\"\nvalue = \"{:.17g} m\"\n",
      std::sqrt(5.0));
  driven.rod = kept.rod + "buckling_length = \"2.3 m\"\n";
  const Solved one(kept), other(driven);
  const ElasticBody elastic = elastic_body_of(other.project, 8);
  REQUIRE(elastic.lines.size() == 1);
  const std::vector<double> expected = one.frequencies(elastic_body_of(one.project, 8), 3),
                            found = other.frequencies(elastic, 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(1e-9));
}

TEST_CASE("a shaken lever on a stay with a damper", "[elastic_joints]") {
  // m = M/3 at its end: the end follows the shoe as (k + i c w)/(k - m w^2 + i c w), and what bends
  // the lever follows its end. Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974),
  // section 1.10.
  using Complex = std::complex<double>;
  constexpr double k = 4e5;
  for (const auto& [r, zeta] : {std::pair(0.3, 0.0), std::pair(0.7, 0.1), std::pair(1.0, 0.2)}) {
    Scene scene;
    const double m = M / 3.0, omega = r * std::sqrt(k / m), c = 2.0 * zeta * std::sqrt(k * m);
    drive_shoe(scene, L, -2.0,
               fmt::format("kind = \"harmonic\"\nmean = \"-2 m\"\namplitude = \"0.0002 m\"\n"
                           "angular_frequency = \"{:.17g} rad/s\"\n",
                           omega));
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"2 m\"\n{}damping = \"{:.17g} N s/m\"\n",
        stiffness(k), c);
    const Solved of(scene, 48);
    const ElasticBody elastic = stiff_lever(of.project, 1e6);
    const ElasticMotion motion(of.rigid(), elastic, 1);
    const auto rigid_at = [&](double part) {
      return moment_at(of.loads(of.finder->at(part * of.motion.period)), 0.5 * L);
    };
    const Complex follows =
        Complex(k, c * omega) / Complex(k - m * omega * omega, c * omega) * rigid_at(0.25);
    for (const double part : {0.1, 0.25, 0.7}) {
      CAPTURE(r, zeta, part);
      CHECK(moment_at(motion.loads_at(si<Time>(part * of.motion.period)), 0.5 * L) ==
            Approx((follows * std::polar(1.0, 2 * pi * part)).imag())
                .margin(3e-3 * std::abs(follows)));
    }
    if (zeta > 0.0) continue;
    // What rigid bodies miss: 1/(1 - r^2) - 1.
    const LoadHistory history{{si<Time>(of.motion.begin), si<Time>(of.motion.period),
                               of.motion.states.size(), of.motion.closed},
                              of.rigid().loads};
    CHECK(estimate_vibration(of.rigid(), elastic, history).without_modes.front() ==
          Approx(r * r / (1.0 - r * r)).epsilon(5e-3));
  }
}

TEST_CASE("joints of no flexibility are rigid joints", "[elastic_joints]") {
  for (const std::string& driver : {shaking, lifting}) {
    Scene scene = moved(false, driver);
    scene.hinge += stiffness(1e16);
    give(scene, "guide", stiffness(1e16) + "turning_stiffness = \"1e16 N m/rad\"\n");
    give(scene, "stay", stiffness(1e16));
    const Solved of(scene, 48);
    const ElasticBody stiff = elastic_body_of(of.project, 8);
    REQUIRE(stiff.joints.size() == 3);
    ElasticBody alone = stiff;
    alone.joints.clear();
    const std::vector<double> found = of.frequencies(stiff, 3), rigid = of.frequencies(alone, 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(rigid[i]).epsilon(1e-9));
    const Time time = si<Time>(0.4);
    check_same_loads(bent_statically(of.rigid(), stiff)(time),
                     bent_statically(of.rigid(), alone)(time), 1e-9);
    check_same_loads(ElasticMotion(of.rigid(), stiff, 2).loads_at(time),
                     ElasticMotion(of.rigid(), alone, 2).loads_at(time), 1e-8);
  }
}

TEST_CASE("joints that give way in a case", "[elastic_joints]") {
  Scene scene = moved(false, shaking);
  scene.hinge += stiffness(5e5);
  const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
  CHECK(of.reason.find("(joint hinge, stay elastic as well)") != std::string::npos);
  const auto problems_of = [](const std::string& text) -> std::string {
    try {
      parse_project("lever.toml", text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Scene damped = moved(false, shaking);
  damped.hinge += "damping = \"1 N s/m\"\n";
  CHECK(problems_of(damped.text()).find("without \"stiffness\" nothing does") != std::string::npos);
  scene.rod +=
      "[[situations]]\nname = \"one\"\n[[situations]]\nname = \"other\"\n"
      "set = { \"joints.hinge.stiffness\" = \"6e5 N/m\" }\n";
  CHECK(problems_of(scene.text()).find("those of all situations") != std::string::npos);
}

namespace {

constexpr double tolerance = 0.02;

double apart(const Project& project, const SituationRun& model, const SituationRun& better) {
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  const double begin = better.loads.begin().value(), length = better.loads.period().value();
  constexpr int looks = 120;
  double difference = 0.0, largest = 0.0;
  for (int i = 0; i < looks; ++i) {
    const Time time = si<Time>(begin + length * i / looks);
    const Eigen::ArrayXd of_better = fibre_stresses(better.loads.diagram_at(time), places);
    const Eigen::ArrayXd of_model = fibre_stresses(model.loads.diagram_at(time), places);
    difference = std::max(difference, (of_model - of_better).abs().maxCoeff());
    largest = std::max(largest, of_better.abs().maxCoeff());
  }
  return difference / largest;
}

}  // namespace

TEST_CASE("random mechanisms with elastic rods are as near to many modes as the tolerance says",
          "[.][random_rods]") {
  std::mt19937 random(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int by_rigid = 0, by_modes = 0, refused = 0, fine = 0;
  for (int i = 0; i < 60; ++i) {
    const bool body = i % 2 == 1, once = i % 3 == 0;
    Scene scene = moved(body, once ? fmt::format("kind = \"smooth step\"\nfrom = \"0.2 m\"\n"
                                                 "to = \"{} m\"\nend = \"{} s\"\n",
                                                 between(0.25, 0.5), between(0.3, 1.2))
                                   : fmt::format("kind = \"harmonic\"\nmean = \"0.2 m\"\n"
                                                 "amplitude = \"{} m\"\nfrequency = \"{} Hz\"\n",
                                                 between(0.01, 0.1), between(0.4, 2.0)));
    scene.side = body ? between(0.012, 0.04) : std::pow(10.0, between(-3.3, -1.7));
    scene.forces = force_at_end(between(-200.0, 200.0), between(-500.0, 200.0));
    if (i % 4 >= 2) scene.hinge += stiffness(std::pow(10.0, between(4.5, 7.0)));
    if (i % 5 == 0)
      give(scene, "guide",
           fmt::format("turning_stiffness = \"{} N m/rad\"\n", std::pow(10.0, between(4.0, 6.0))));
    Project project = parse_project("lever.toml", scene.text());
    project.model.tolerance = tolerance;
    const double softer = std::pow(10.0, between(-0.6, 0.3));
    project.model.youngs_modulus *= softer;
    project.model.shear_modulus *= softer;
    project.model.retardation = once ? between(1e-4, 2e-3) : between(0.0, 2e-3);
    INFO("scene " << i);
    try {
      const ModelledRuns chosen = run_by_chosen_model(project);
      INFO(chosen.model.reason);
      const bool modal = chosen.model.chosen.level == ModelLevel::modal;
      if (!modal && (chosen.model.weighed.empty() ||
                     chosen.model.weighed.back().found.value_or(chosen.model.weighed.back().error) >
                         tolerance)) {
        ++refused;
        continue;
      }
      const int parts = 4 * std::max(8, chosen.model.chosen.parts);
      std::optional<std::deque<SituationRun>> better;
      // As many modes as the instants resolve.
      for (const int modes : {12, 8, 5}) {
        try {
          better = run_situations(project, {ModelLevel::modal, modes, parts, {}, false});
        } catch (const AnalysisError&) {
          continue;
        }
        if (modes == 12) ++fine;
        break;
      }
      if (!better) {
        ++refused;
        continue;
      }
      (modal ? by_modes : by_rigid) += 1;
      CHECK(apart(project, chosen.runs.front(), better->front()) < tolerance);
    } catch (const AnalysisError& error) {
      INFO(error.what());
      ++refused;
    }
  }
  WARN("rigid or bent " << by_rigid << ", modal " << by_modes << ", refused " << refused
                        << ", against 12 modes " << fine);
  CHECK(by_rigid + by_modes >= 40);
  CHECK(by_modes >= 10);
}

}  // namespace elastic_rods_test
