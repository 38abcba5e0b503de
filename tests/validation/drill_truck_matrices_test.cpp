// The closed matrices of Wojnarowski, Wojciech, Płosa, Płoski: Wyznaczanie reakcji dynamicznych w
// węzłach wozu wiertniczego przy uwzględnieniu podatności ogniw, Mechanika 85 (1987), equations (2)
// to (11), against the assembled ones, for random geometry. Coordinates are counted from one where
// the paper does.
//
// What the paper has wrong, each shown below:
// - (13) has + H on the side of the forces; V contains + q^T H, so that it must be - H;
// - K_12 of the sliding joint has r_P31 cos(gamma_P41) for r_P41 cos(gamma_P41);
// - n counts springs in axial links (elements 0 to n), but elements in bending links (1 to n);
// - the gap of the sliding joint leaves out that the links shift as a whole, x and y;
// - in K_12 of w5 our copy has + l_2 r_35 cos(eps_53 - alpha_2) for -.

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "support/source_matrices.hpp"

namespace drill_truck_matrices_test {

using namespace boxbeam::flexible;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::matrices_of;
using test::SourceMatrices;

namespace {

constexpr double tolerance = 1e-12;

double relative_difference(const MatrixXd& found, const MatrixXd& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// A row of rigid elements as the paper draws it: the first moves with the link's origin, the
/// others with their centres.
struct Row {
  VectorXd m, J;       ///< of the elements, J about the centre
  VectorXd centre;     ///< from the origin
  VectorXd place;      ///< of the springs
  VectorXd axial;      ///< stiffness of the springs
  VectorXd across;     ///< c
  VectorXd rotation;   ///< k
  double angle = 0.0;  ///< alpha
};

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double positive() { return std::uniform_real_distribution<double>(0.5, 2.0)(random_); }
  double angle() { return std::uniform_real_distribution<double>(-3.0, 3.0)(random_); }
  Index count() { return std::uniform_int_distribution<Index>(2, 7)(random_); }
  VectorXd positives(Index size) {
    VectorXd values(size);
    for (double& value : values) value = positive();
    return values;
  }
  Row row() {
    Row row;
    const Index springs = count();
    row.m = positives(springs + 1);
    row.J = positives(springs + 1);
    row.axial = positives(springs);
    row.across = positives(springs);
    row.rotation = positives(springs);
    row.centre = VectorXd::Zero(springs + 1);
    row.place = VectorXd::Zero(springs);
    double x = 0.0;
    for (Index i = 0; i < springs; ++i) {
      row.centre[i] = x += positive();
      row.place[i] = x += positive();
    }
    row.centre[springs] = x + positive();
    row.angle = angle();
    return row;
  }

 private:
  std::mt19937 random_;
};

/// Assembles links and joints given by hand.
struct Assembly {
  Mechanism mechanism;
  Structure structure;

  void add(const Row& row, LinkKind kind) {
    Link link;
    link.name = std::to_string(mechanism.links.size());
    link.kind = kind;
    link.angle = row.angle;
    mechanism.links.push_back(link);
    DividedLink divided;
    for (Index i = 0; i < row.m.size(); ++i) {
      RigidElement element;
      element.mass = row.m[i];
      element.node = i == 0 ? 0.0 : row.centre[i];
      const double r = row.centre[i] - element.node;
      element.first_moment.x() = row.m[i] * r;
      element.inertia = row.J[i] + row.m[i] * r * r;
      divided.elements.push_back(element);
    }
    for (Index i = 0; i < row.place.size(); ++i) {
      SpringElement spring;
      spring.place = row.place[i];
      if (kind == LinkKind::axial) spring.axial = 1.0 / row.axial[i];
      if (kind == LinkKind::bending) {
        spring.bending.diagonal() << 1.0 / row.across[i], 1.0 / row.rotation[i];
      }
      divided.springs.push_back(spring);
    }
    structure.links.push_back(divided);
  }

  /// Takes hold of an element at r from its node, link axes.
  Grip grip(int link, Index element, Eigen::Vector2d r) const {
    const double angle = mechanism.links[static_cast<std::size_t>(link)].angle;
    Grip grip;
    grip.link = link;
    grip.element = static_cast<std::size_t>(element);
    Eigen::Matrix3d to_place = Eigen::Matrix3d::Identity();
    to_place.topRightCorner<2, 1>() << -r.y(), r.x();
    Eigen::Matrix3d to_world = Eigen::Matrix3d::Identity();
    to_world.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    grip.motion = to_world * to_place;
    return grip;
  }

  void join(const Grip& a, const Grip& b, double angle, std::array<double, 3> stiffness) {
    Joint joint;
    joint.stiffness = stiffness;
    joint.angle = angle;
    mechanism.joints.push_back(joint);
    Structure::Ends ends;
    ends.a = a;
    ends.b = b;
    ends.axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(-angle).toRotationMatrix();
    structure.joints.push_back(ends);
  }

  SourceMatrices matrices() {
    structure.mechanism = &mechanism;
    return matrices_of(structure);
  }
};

MatrixXd symmetric(const MatrixXd& upper) { return upper.selfadjointView<Eigen::Upper>(); }

/// Equation (2); elements 0 to n.
MatrixXd mass_of_axial_link(const Row& row) {
  const Index n = row.m.size() - 1;
  const double c = std::cos(row.angle);
  const double s = std::sin(row.angle);
  const double m = row.m.sum();
  const double g = row.m.dot(row.centre);
  const double J = row.m.dot(row.centre.cwiseAbs2()) + row.J.sum();
  MatrixXd M = MatrixXd::Zero(n + 3, n + 3);
  M.topLeftCorner<3, 3>() << m, 0, -g * s, 0, m, g * c, 0, 0, J;
  for (Index i = 1; i <= n; ++i) {
    M(0, i + 2) = row.m[i] * c;
    M(1, i + 2) = row.m[i] * s;
    M(i + 2, i + 2) = row.m[i];
  }
  return symmetric(M);
}

/// Equation (3); `elements` of them, 1 to n, with 2 n + 1 coordinates.
MatrixXd mass_of_bending_link(const Row& row, Index elements) {
  const double c = std::cos(row.angle);
  const double s = std::sin(row.angle);
  const double r = row.centre[0];
  MatrixXd M = MatrixXd::Zero(2 * elements + 1, 2 * elements + 1);
  const double m = row.m.head(elements).sum();
  M.topLeftCorner<3, 3>() << m, 0, -row.m[0] * r * s, 0, m, row.m[0] * r * c, 0, 0,
      row.J[0] + row.m[0] * r * r;
  for (Index i = 2; i <= elements; ++i) {
    const Index eta = 2 * i - 1;  // counted from zero
    M(0, eta) = -row.m[i - 1] * s;
    M(1, eta) = row.m[i - 1] * c;
    M(eta, eta) = row.m[i - 1];
    M(eta + 1, eta + 1) = row.J[i - 1];
  }
  return symmetric(M);
}

/// Equation (5): each spring between the shifts on its two sides.
MatrixXd stiffness_of_axial_link(const Row& row) {
  const Index n = row.m.size() - 1;
  MatrixXd K = MatrixXd::Zero(n + 3, n + 3);
  for (Index i = 1; i <= n; ++i) {
    K(i + 2, i + 2) = row.axial[i - 1] + (i < n ? row.axial[i] : 0.0);
    if (i < n) K(i + 2, i + 3) = -row.axial[i];
  }
  return symmetric(K);
}

/// Equation (6). Spring i is b_i beyond the place that element i moves with and a_i+1 before the
/// centre of element i + 1.
MatrixXd stiffness_of_bending_link(const Row& row) {
  const Index n = row.m.size();
  MatrixXd K = MatrixXd::Zero(2 * n + 1, 2 * n + 1);
  for (Index i = 1; i <= n; ++i) {
    const Index eta = 2 * i - 1;
    const Index phi = 2 * i;
    const bool last = i == n;
    const double node = i == 1 ? 0.0 : row.centre[i - 1];
    const double c = last ? 0.0 : row.across[i - 1];
    const double k = last ? 0.0 : row.rotation[i - 1];
    const double b = last ? 0.0 : row.place[i - 1] - node;
    const double next_a = last ? 0.0 : row.centre[i] - row.place[i - 1];
    const double c_before = i == 1 ? 0.0 : row.across[i - 2];
    const double k_before = i == 1 ? 0.0 : row.rotation[i - 2];
    const double a = i == 1 ? 0.0 : node - row.place[i - 2];
    K(phi, phi) = c_before * a * a + c * b * b + k_before + k;
    if (i > 1) {
      K(eta, eta) = c_before + c;
      K(eta, phi) = c * b - c_before * a;
    }
    if (last) continue;
    K(phi, eta + 2) = -c * b;
    K(phi, phi + 2) = c * b * next_a - k;
    if (i > 1) {
      K(eta, eta + 2) = -c;
      K(eta, phi + 2) = c * next_a;
    }
  }
  return symmetric(K);
}

/// Equations (8) to (10): the end of axial link 2, l from its origin, on the last element of
/// bending link 3, r from its centre, r in the direction eps of the world.
struct RevoluteJoint {
  double C, l, alpha_2, alpha_3, r, eps;
  Index size_2, size_3;

  MatrixXd K_11() const {
    const Index last = size_2 - 1;
    MatrixXd K = MatrixXd::Zero(size_2, size_2);
    K.topLeftCorner<3, 3>() << 1, 0, -l * std::sin(alpha_2), 0, 1, l * std::cos(alpha_2), 0, 0,
        l * l;
    K(0, last) = std::cos(alpha_2);
    K(1, last) = std::sin(alpha_2);
    K(last, last) = 1.0;
    return C * symmetric(K);
  }

  /// `sign` of the entry of the two rotations: -1; our copy has +1.
  MatrixXd K_12(double sign) const {
    const Index eta = size_3 - 2;
    const Index last = size_2 - 1;
    MatrixXd K = MatrixXd::Zero(size_2, size_3);
    K(0, 0) = K(1, 1) = -1.0;
    K(2, 0) = l * std::sin(alpha_2);
    K(2, 1) = -l * std::cos(alpha_2);
    K(last, 0) = -std::cos(alpha_2);
    K(last, 1) = -std::sin(alpha_2);
    K.row(0).tail<2>() << std::sin(alpha_3), r * std::sin(eps);
    K.row(1).tail<2>() << -std::cos(alpha_3), -r * std::cos(eps);
    K.row(2).tail<2>() << -l * std::cos(alpha_3 - alpha_2), sign * l * r * std::cos(eps - alpha_2);
    K(last, eta) = std::sin(alpha_3 - alpha_2);
    K(last, eta + 1) = r * std::sin(eps - alpha_2);
    return C * K;
  }

  MatrixXd K_22() const {
    const Index eta = size_3 - 2;
    MatrixXd K = MatrixXd::Zero(size_3, size_3);
    K(0, 0) = K(1, 1) = 1.0;
    K.row(0).tail<2>() << -std::sin(alpha_3), -r * std::sin(eps);
    K.row(1).tail<2>() << std::cos(alpha_3), r * std::cos(eps);
    K(eta, eta) = 1.0;
    K(eta, eta + 1) = r * std::cos(eps - alpha_3);
    K(eta + 1, eta + 1) = r * r;
    return C * symmetric(K);
  }

  /// Equation (11), of both links; A and B the gap of the joint where all coordinates are zero.
  VectorXd H(double A, double B) const {
    VectorXd H = VectorXd::Zero(size_2 + size_3);
    H.head<3>() << A, B, l * (-A * std::sin(alpha_2) + B * std::cos(alpha_2));
    H[size_2 - 1] = A * std::cos(alpha_2) + B * std::sin(alpha_2);
    H.segment<2>(size_2) << -A, -B;
    H.tail<2>() << A * std::sin(alpha_3) - B * std::cos(alpha_3),
        r * (A * std::sin(eps) - B * std::cos(eps));
    return C * H;
  }
};

}  // namespace

TEST_CASE("Mass and stiffness of axial and bending links are the closed ones of the paper",
          "[flexible][validation]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Draw draw(seed);
    const Row axial = draw.row();
    const Row bending = draw.row();
    Assembly assembly;
    assembly.add(axial, LinkKind::axial);
    assembly.add(bending, LinkKind::bending);
    const SourceMatrices found = assembly.matrices();
    const Index size_2 = found.link_start[1];
    const Index size_3 = found.M.cols() - size_2;
    CHECK(relative_difference(found.M.topLeftCorner(size_2, size_2), mass_of_axial_link(axial)) <
          tolerance);
    CHECK(relative_difference(found.K.topLeftCorner(size_2, size_2),
                              stiffness_of_axial_link(axial)) < tolerance);
    CHECK(relative_difference(found.M.bottomRightCorner(size_3, size_3),
                              mass_of_bending_link(bending, bending.m.size())) < tolerance);
    CHECK(relative_difference(found.K.bottomRightCorner(size_3, size_3),
                              stiffness_of_bending_link(bending)) < tolerance);
    CHECK(found.M.topRightCorner(size_2, size_3).isZero(0.0));
    CHECK(found.K.topRightCorner(size_2, size_3).isZero(0.0));

    // n springs in both: the paper's vector of a bending link, that ends at phi_n, lacks an
    // element.
    const Index n = bending.place.size();
    CHECK(size_2 == axial.place.size() + 3);
    REQUIRE(size_3 != 2 * n + 1);
    REQUIRE(mass_of_bending_link(bending, n)(0, 0) != Approx(bending.m.sum()));
    CHECK(size_3 == 2 * (n + 1) + 1);
  }
}

TEST_CASE("Revolute joint w5 of an axial with a bending link", "[flexible][validation]") {
  for (unsigned seed = 100; seed < 200; ++seed) {
    Draw draw(seed);
    const Row axial = draw.row();
    const Row bending = draw.row();
    RevoluteJoint joint{};
    joint.C = 10.0 * draw.positive();
    joint.alpha_2 = axial.angle;
    joint.alpha_3 = bending.angle;
    joint.l = axial.centre[axial.centre.size() - 1] + draw.positive();
    joint.r = draw.positive();
    joint.eps = draw.angle();

    Assembly assembly;
    assembly.add(axial, LinkKind::axial);
    assembly.add(bending, LinkKind::bending);
    const Index last_2 = axial.m.size() - 1;
    const Index last_3 = bending.m.size() - 1;
    const Eigen::Vector2d r = joint.r * Eigen::Vector2d(std::cos(joint.eps - joint.alpha_3),
                                                        std::sin(joint.eps - joint.alpha_3));
    assembly.join(assembly.grip(0, last_2, {joint.l - axial.centre[last_2], 0.0}),
                  assembly.grip(1, last_3, r), draw.angle(), {joint.C, joint.C, 0.0});
    const SourceMatrices found = assembly.matrices();
    joint.size_2 = found.link_start[1];
    joint.size_3 = found.K.cols() - joint.size_2;

    CHECK(relative_difference(found.K.topLeftCorner(joint.size_2, joint.size_2),
                              stiffness_of_axial_link(axial) + joint.K_11()) < tolerance);
    CHECK(relative_difference(found.K.topRightCorner(joint.size_2, joint.size_3),
                              joint.K_12(-1.0)) < tolerance);
    CHECK(relative_difference(found.K.bottomRightCorner(joint.size_3, joint.size_3),
                              stiffness_of_bending_link(bending) + joint.K_22()) < tolerance);
    CHECK(relative_difference(found.K, found.K.transpose()) < tolerance);
    REQUIRE(relative_difference(found.K.topRightCorner(joint.size_2, joint.size_3),
                                joint.K_12(1.0)) > 1e-6);
  }
}

TEST_CASE("Sliding joint P1 of two parallel bending links", "[flexible][validation]") {
  for (unsigned seed = 200; seed < 300; ++seed) {
    Draw draw(seed);
    const Row row_3 = draw.row();
    Row row_4 = draw.row();
    row_4.angle = row_3.angle;
    const double C = 10.0 * draw.positive();
    const double r_3 = draw.positive();
    const double r_4 = draw.positive();
    const double gamma_3 = draw.angle();
    const double gamma_4 = draw.angle();
    const Index p_3 = 2;  // element of each that holds the joint, counted from one
    const Index p_4 = row_4.m.size();

    Assembly assembly;
    assembly.add(row_3, LinkKind::bending);
    assembly.add(row_4, LinkKind::bending);
    const auto at = [](double r, double gamma) {
      return Eigen::Vector2d(r * std::cos(gamma), r * std::sin(gamma));
    };
    assembly.join(assembly.grip(0, p_3 - 1, at(r_3, gamma_3)),
                  assembly.grip(1, p_4 - 1, at(r_4, gamma_4)), row_3.angle, {0.0, C, 0.0});
    const MatrixXd K = assembly.matrices().K;
    const Index size_3 = 2 * row_3.m.size() + 1;
    const Index size_4 = 2 * row_4.m.size() + 1;

    // From eta on as printed; x and y of the links, left out there, shift the contact too.
    const double s = std::sin(row_3.angle);
    const double c = std::cos(row_3.angle);
    MatrixXd K_11 = MatrixXd::Zero(size_3, size_3);
    MatrixXd K_12 = MatrixXd::Zero(size_3, size_4);
    MatrixXd K_22 = MatrixXd::Zero(size_4, size_4);
    const double b_3 = r_3 * std::cos(gamma_3);
    const double b_4 = r_4 * std::cos(gamma_4);
    const Index eta_3 = 2 * p_3 - 1;
    const Index eta_4 = 2 * p_4 - 1;
    K_11.block<2, 2>(eta_3, eta_3) << C, C * b_3, C * b_3, C * b_3 * b_3;
    K_12.block<2, 2>(eta_3, eta_4) << -C, -C * b_4, -C * b_3, -C * b_3 * b_4;
    K_22.block<2, 2>(eta_4, eta_4) << C, C * b_4, C * b_4, C * b_4 * b_4;
    const MatrixXd printed_K_11 = K_11;
    MatrixXd printed_K_12 = K_12;
    printed_K_12(eta_3, eta_4 + 1) = -C * r_3 * std::cos(gamma_4);
    const Eigen::RowVector2d across(-s, c);
    K_11.topLeftCorner<2, 2>() = C * across.transpose() * across;
    K_11.block<2, 2>(0, eta_3) = C * across.transpose() * Eigen::RowVector2d(1.0, b_3);
    K_11.block<2, 2>(eta_3, 0) = K_11.block<2, 2>(0, eta_3).transpose();
    K_22.topLeftCorner<2, 2>() = C * across.transpose() * across;
    K_22.block<2, 2>(0, eta_4) = C * across.transpose() * Eigen::RowVector2d(1.0, b_4);
    K_22.block<2, 2>(eta_4, 0) = K_22.block<2, 2>(0, eta_4).transpose();
    K_12.topLeftCorner<2, 2>() = -C * across.transpose() * across;
    K_12.block<2, 2>(0, eta_4) = -C * across.transpose() * Eigen::RowVector2d(1.0, b_4);
    K_12.block<2, 2>(eta_3, 0) = -C * Eigen::Vector2d(1.0, b_3) * across;

    CHECK(relative_difference(K.topLeftCorner(size_3, size_3),
                              stiffness_of_bending_link(row_3) + K_11) < tolerance);
    CHECK(relative_difference(K.topRightCorner(size_3, size_4), K_12) < tolerance);
    CHECK(relative_difference(K.bottomRightCorner(size_4, size_4),
                              stiffness_of_bending_link(row_4) + K_22) < tolerance);

    const auto elastic = [&](const MatrixXd& block) {
      return MatrixXd(block.bottomRightCorner(block.rows() - 2, block.cols() - 2));
    };
    REQUIRE(relative_difference(elastic(K.topRightCorner(size_3, size_4)), elastic(printed_K_12)) >
            1e-6);
    // A shift of link 3 across itself closes the gap by as much; printed: nothing.
    VectorXd shift = VectorXd::Zero(size_3);
    shift.head<2>() = across.transpose();
    REQUIRE(shift.dot(printed_K_11 * shift) == 0.0);
    CHECK(shift.dot(K.topLeftCorner(size_3, size_3) * shift) == Approx(C).epsilon(tolerance));
  }
}

TEST_CASE("The vectors H of the paper vanish from the unstressed posture on, and act as - H",
          "[flexible][validation]") {
  for (unsigned seed = 300; seed < 400; ++seed) {
    Draw draw(seed);
    RevoluteJoint joint{};
    joint.C = draw.positive();
    joint.l = draw.positive();
    joint.r = draw.positive();
    joint.alpha_2 = draw.angle();
    joint.alpha_3 = draw.angle();
    joint.eps = draw.angle();
    joint.size_2 = draw.count() + 3;
    joint.size_3 = 2 * draw.count() + 3;
    MatrixXd K(joint.size_2 + joint.size_3, joint.size_2 + joint.size_3);
    K << joint.K_11(), joint.K_12(-1.0), joint.K_12(-1.0).transpose(), joint.K_22();

    // The gap of the joint in absolute coordinates, links unstressed: what the coordinates x and y
    // of the origins add to A and B is nothing where the joint fits.
    const double A = draw.angle();
    const double B = draw.angle();
    const VectorXd H = joint.H(A, B);
    VectorXd unstressed = VectorXd::Zero(K.cols());
    unstressed.head<2>() << draw.angle(), draw.angle();
    unstressed.segment<2>(joint.size_2) = unstressed.head<2>() + Eigen::Vector2d(A, B);
    const double scale = H.cwiseAbs().maxCoeff();
    CHECK((K * unstressed + H).cwiseAbs().maxCoeff() < tolerance * 10.0 * scale);
    REQUIRE((K * unstressed - H).cwiseAbs().maxCoeff() > 0.1 * scale);  // the sign of (13)

    // Measured from there the same force is K (q - q_0): no H.
    const VectorXd q = draw.positives(K.cols());
    CHECK(relative_difference(K * (q - unstressed), K * q + H) < 10.0 * tolerance);
  }
}

}  // namespace drill_truck_matrices_test
