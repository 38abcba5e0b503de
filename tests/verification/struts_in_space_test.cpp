// Rods with mass that are elastic beside the beam of a mechanism in space: finite elements that
// share nothing with the program, and any way that they lie.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "catch.hpp"
#include "support/lever_in_space.hpp"
#include "support/space_elements.hpp"
#include "support/uniform.hpp"

namespace struts_in_space_test {

using namespace boxbeam;
using namespace test::lever_in_space;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::space_arm::check_alike;
using test::space_arm::Cuts;
using test::space_arm::cuts_of;

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
    test::space_elements::add_beam(
        {project.beam.segments.front().from, Matrix3d::Identity(), L, rho, n, 0, false}, K, Mass);
    const double A_rod = properties_of(rod_section).area.value();
    test::space_elements::add_beam(
        {rod_section, axes, line.norm(), mass / (A_rod * line.norm()), n, 6 * (n + 1), true}, K,
        Mass);
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
          "[struts_in_space]") {
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
          "[struts_in_space]") {
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
TEST_CASE("elastic rods and joints in space vibrate alike however they lie", "[struts_in_space]") {
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

TEST_CASE("rods in space that cannot be laid out count as rigid, and say why",
          "[struts_in_space]") {
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

TEST_CASE("random levers on oblique struts have the frequencies of finite elements",
          "[.][random_rods_in_space]") {
  test::Uniform between(5);
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

}  // namespace struts_in_space_test
