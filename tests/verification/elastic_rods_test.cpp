// Rods that are elastic by their section beside the verified beam: closed forms of a lever on a
// rod, elements of the test's own, and rods of no flexibility, which are rigid ones.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/lever.hpp"
#include "support/uniform.hpp"

namespace elastic_rods_test {

using namespace boxbeam;
using namespace test::lever;

namespace {

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
  test::Uniform between(11);
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
