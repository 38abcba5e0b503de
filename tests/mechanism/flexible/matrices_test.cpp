#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"
#include "support/source_matrices.hpp"

namespace matrices_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Bar;
using test::Chance;
using test::coordinates_of;
using test::matrices_of;
using test::RandomMechanism;
using test::SourceMatrices;

namespace {

RandomMechanism sort(int i) {
  RandomMechanism want;
  want.links = 1 + i % 4;
  want.closed = i % 2 == 1;
  want.damped = i % 3 != 0;
  want.nodes_at_joints = i % 5 != 0;
  want.element = i % 4 < 2 ? Element::corrected : Element::classical;
  return want;
}

/// Full coordinates of all links from those of the matrices.
MatrixXd full_from(const Structure& structure, const SourceMatrices& matrices) {
  MatrixXd B = MatrixXd::Zero(3 * static_cast<Index>(structure.elements()), matrices.M.cols());
  Index row = 0;
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    const MatrixXd own = coordinates_of(structure.mechanism->links[k], structure.links[k]);
    B.block(row, matrices.link_start[k], own.rows(), own.cols()) = own;
    row += own.rows();
  }
  return B;
}

template <class Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> as_vector(const LinkColumns<Scalar>& columns) {
  Index size = 0;
  for (const auto& link : columns) size += link.size();
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> vector(size);
  Index row = 0;
  for (const auto& link : columns) {
    vector.segment(row, link.size()) = link.reshaped();
    row += link.size();
  }
  return vector;
}

/// The whole world shifted by (x, y) and turned about its origin: full coordinates.
VectorXd rigid_motion(const Structure& structure, const Eigen::Vector3d& motion) {
  LinkColumns<double> columns = no_loads<double>(structure);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Link& link = structure.mechanism->links[k];
    for (Index i = 0; i < columns[k].cols(); ++i) {
      const double s = structure.links[k].elements[static_cast<std::size_t>(i)].node;
      const Eigen::Vector2d at =
          link.origin + s * Eigen::Vector2d(std::cos(link.angle), std::sin(link.angle));
      const Eigen::Vector2d moved =
          Eigen::Rotation2Dd(-link.angle) *
          Eigen::Vector2d(motion[0] - motion[2] * at.y(), motion[1] + motion[2] * at.x());
      columns[k].col(i) << moved, motion[2];
    }
  }
  return as_vector(columns);
}

}  // namespace

TEST_CASE("Matrices are symmetric; their coordinates are named link by link",
          "[flexible][matrices]") {
  Chance chance(111);
  for (int i = 0; i < 40; ++i) {
    const Mechanism mechanism = test::random_elastic(chance, sort(i));
    const SourceMatrices matrices = matrices_of(structure_of(mechanism));
    for (const MatrixXd* of : {&matrices.M, &matrices.K, &matrices.C}) {
      CHECK((*of - of->transpose()).cwiseAbs().maxCoeff() <= 1e-14 * of->cwiseAbs().maxCoeff());
      CHECK(of->rows() == static_cast<Index>(matrices.names.size()));
    }
    REQUIRE(matrices.link_start.size() == mechanism.links.size());
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      CHECK(matrices.names[static_cast<std::size_t>(matrices.link_start[k])] ==
            mechanism.links[k].name + ".x");
    }
  }
}

TEST_CASE("Names of the coordinates of each kind of link", "[flexible][matrices]") {
  const auto names = [](LinkKind kind) {
    Mechanism mechanism;
    mechanism.links = {test::link_of(Bar{}, 2, kind)};
    return matrices_of(structure_of(mechanism)).names;
  };
  using Names = std::vector<std::string>;
  CHECK(names(LinkKind::rigid) == Names{"beam.x", "beam.y", "beam.phi"});
  CHECK(names(LinkKind::axial) ==
        Names{"beam.x", "beam.y", "beam.delta", "beam.xi_1", "beam.xi_2"});
  CHECK(names(LinkKind::bending) == Names{"beam.x", "beam.y", "beam.phi_0", "beam.eta_1",
                                          "beam.phi_1", "beam.eta_2", "beam.phi_2"});
  CHECK(names(LinkKind::full) == Names{"beam.x", "beam.y", "beam.phi_0", "beam.xi_1", "beam.eta_1",
                                       "beam.phi_1", "beam.xi_2", "beam.eta_2", "beam.phi_2"});
}

TEST_CASE("M of a rigid motion is the mass of the links, and K and C of it are none",
          "[flexible][matrices]") {
  Chance chance(112);
  for (int i = 0; i < 60; ++i) {
    Mechanism mechanism = test::random_elastic(chance, sort(i));
    std::erase_if(mechanism.joints, [](const Joint& joint) { return joint.b.link == ground; });
    const Structure structure = structure_of(mechanism);
    const SourceMatrices matrices = matrices_of(structure);
    const MatrixXd B = full_from(structure, matrices);
    // x and y, and the turn about the origin.
    MatrixXd q(B.cols(), 3);
    for (Index k = 0; k < 3; ++k) {
      const VectorXd full = rigid_motion(structure, Eigen::Vector3d::Unit(k));
      q.col(k) = B.colPivHouseholderQr().solve(full);
      CHECK((B * q.col(k) - full).norm() < 1e-12 * full.norm());
    }
    double mass = 0.0;
    double inertia = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (const Link& link : mechanism.links) {
      const RigidMass of = rigid_mass_of(link);
      const Eigen::Vector2d centre = link.origin + Eigen::Rotation2Dd(link.angle) * of.centre;
      mass += of.mass;
      moment += of.mass * centre;
      inertia += of.inertia + of.mass * centre.squaredNorm();
    }
    const Eigen::Matrix3d M = q.transpose() * matrices.M * q;
    CAPTURE(i);
    CHECK(M(0, 0) == Approx(mass).epsilon(1e-11));
    CHECK(M(1, 1) == Approx(mass).epsilon(1e-11));
    CHECK(M(0, 1) == Approx(0.0).margin(1e-11 * mass));
    CHECK(M(0, 2) == Approx(-moment.y()).margin(1e-11 * std::sqrt(mass * inertia)));
    CHECK(M(1, 2) == Approx(moment.x()).margin(1e-11 * std::sqrt(mass * inertia)));
    // Masses gathered in nodes keep the mass and its static moment only.
    if (mechanism.element == Element::classical) CHECK(M(2, 2) == Approx(inertia).epsilon(1e-11));

    const double size = q.cwiseAbs().maxCoeff();
    CHECK((matrices.K * q).cwiseAbs().maxCoeff() < 1e-12 * size * matrices.K.cwiseAbs().maxCoeff());
    CHECK((matrices.C * q).cwiseAbs().maxCoeff() <=
          1e-12 * size * matrices.C.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("The matrices written out give the response of the solver", "[flexible][matrices]") {
  Chance chance(113);
  for (int i = 0; i < 60; ++i) {
    Mechanism mechanism = test::random_elastic(chance, sort(i));
    // Not near a resonance without damping, where round-off has no limit.
    for (Link& link : mechanism.links) link.retardation += 1e-3;
    const Structure structure = structure_of(mechanism);
    const SourceMatrices matrices = matrices_of(structure);
    const MatrixXd B = full_from(structure, matrices);
    CAPTURE(i);

    const VectorXd motion = as_vector(static_response(structure).motion);
    const VectorXd f = B.transpose() * as_vector(static_loads(structure));
    const VectorXd statically = B * matrices.K.fullPivLu().solve(f);
    CHECK((statically - motion).norm() < 1e-7 * motion.norm());

    const double frequency = test::power_of_ten(chance, 0.0, 2.0);
    const double omega = 2.0 * std::numbers::pi * frequency;
    const Eigen::MatrixXcd Z = (matrices.K - omega * omega * matrices.M).cast<Complex>() +
                               Complex(0.0, omega) * matrices.C;
    const Eigen::VectorXcd vibrating = as_vector(harmonic_response(structure, frequency).motion);
    const Eigen::VectorXcd phasor = B.transpose() * as_vector(harmonic_loads(structure));
    const Eigen::VectorXcd solved = B * Z.fullPivLu().solve(phasor);
    CHECK((solved - vibrating).norm() < 1e-7 * vibrating.norm());
  }
}

TEST_CASE("K of a bending link of two parts in the coordinates of the source",
          "[flexible][matrices]") {
  // Classical springs of parts of length D between nodes at 0, D, 2D: shear GA/D, bending EI/D.
  Bar bar;
  bar.L = 2.0;
  bar.GA = 5.0;
  bar.EI = 3.0;
  Mechanism mechanism;
  mechanism.element = Element::classical;
  mechanism.links = {test::link_of(bar, 2, LinkKind::bending)};
  const MatrixXd K = matrices_of(structure_of(mechanism)).K;
  // Shift at a spring: w_i - D/2 phi_i - w_(i-1) - D/2 phi_(i-1), D = 1.
  MatrixXd shear = MatrixXd::Zero(2, 7);
  shear << 0, 0, -0.5, 1, -0.5, 0, 0,  //
      0, 0, 0, -1, -0.5, 1, -0.5;
  MatrixXd turn = MatrixXd::Zero(2, 7);
  turn << 0, 0, -1, 0, 1, 0, 0,  //
      0, 0, 0, 0, -1, 0, 1;
  const MatrixXd expected = 5.0 * shear.transpose() * shear + 3.0 * turn.transpose() * turn;
  CHECK((K - expected).cwiseAbs().maxCoeff() < 1e-14);
}

}  // namespace matrices_test
