// Statics of the second order of beams one after the other in space, against elements of the test's
// own whose second order is that of exact rotations.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
#include "support/bent_in_space.hpp"

namespace bent_chains_test {

using namespace boxbeam;
using namespace test::bent;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double pi = std::numbers::pi;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

std::string place_text(const Vector3d& of) {
  return fmt::format("[\"{:.17g} m\", \"{:.17g} m\", \"{:.17g} m\"]", of.x(), of.y(), of.z());
}

Matrix3d cross(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Matrix3d turned(const Vector3d& theta) {
  const double angle = theta.norm();
  if (angle == 0.0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, theta / angle).toRotationMatrix();
}

Vector3d turn_of(const Matrix3d& R) {
  const Eigen::AngleAxisd of(R);
  return of.angle() * of.axis();
}

/// Elements of the test's own: two nodes with shifts and exact turns, strained as a whole by what
/// the second node is moved and turned, seen from axes half between those of both. `h`: along x.
struct Element {
  static Vector6 strain(const Vector12& q, double h) {
    const Matrix3d R_1 = turned(q.segment<3>(3)), R_2 = turned(q.segment<3>(9));
    const Vector3d between = turn_of(R_1.transpose() * R_2);
    const Matrix3d middle = R_1 * turned(0.5 * between);
    Vector6 of;
    of.head<3>() =
        middle.transpose() * Vector3d(h * Vector3d::UnitX() + q.segment<3>(6) - q.head<3>()) -
        h * Vector3d::UnitX();
    of.tail<3>() = between;
    return of;
  }

  /// Second derivative of the work of cut forces, by differences of the exact strains.
  static Matrix12 stress(const Vector6& cut, double h) {
    constexpr double d = 2e-4;
    Matrix12 of;
    const auto work = [&](Index i, double a, Index j, double b) {
      Vector12 q = Vector12::Zero();
      q[i] += a;
      q[j] += b;
      return cut.dot(strain(q, h));
    };
    for (Index i = 0; i < 12; ++i)
      for (Index j = 0; j <= i; ++j)
        of(i, j) = of(j, i) =
            (work(i, d, j, d) - work(i, d, j, -d) - work(i, -d, j, d) + work(i, -d, j, -d)) /
            (4.0 * d * d);
    return of;
  }

  /// First derivative of the strains.
  static Eigen::Matrix<double, 6, 12> rates(double h) {
    Eigen::Matrix<double, 6, 12> of = Eigen::Matrix<double, 6, 12>::Zero();
    of.leftCols<6>() = -Eigen::Matrix<double, 6, 6>::Identity();
    of.rightCols<6>() = Eigen::Matrix<double, 6, 6>::Identity();
    // The vector between both nodes, seen from axes that turn by the mean.
    of.block<3, 3>(0, 3) = of.block<3, 3>(0, 9) = 0.5 * cross(h * Vector3d::UnitX());
    return of;
  }
};

/// A beam in a frame, its axes and where its nodes are.
struct OwnBeam {
  Section section;
  Vector3d start;
  Matrix3d axes;
  double length = 0.0;
};

/// A dead force on the end of a beam, beside its axis.
struct OwnForce {
  int beam = 0;
  Vector3d arm, force;  // world
};

/// Beams one after the other, joined rigidly, the first clamped.
struct Chained {
  std::vector<OwnBeam> beams;
  std::vector<OwnForce> forces;

  /// Moments that second order adds at the starts of the beams, in the axes of each: T, M_y, M_z.
  std::vector<Vector3d> added(int n) const {
    const auto per_beam = static_cast<Index>(n);
    const auto count = static_cast<Index>(beams.size());
    const Index size = 6 * per_beam * count;  // the first node is fixed
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd strained = VectorXd::Zero(size);
    const auto put = [&](Index row, Index column, const MatrixXd& block) {
      for (Index i = 0; i < block.rows(); ++i)
        for (Index j = 0; j < block.cols(); ++j)
          if (row + i >= 0 && column + j >= 0)
            entries.emplace_back(row + i, column + j, block(i, j));
    };
    struct Solved {
      Matrix12 K, K_g, into;
      Vector12 f;
      Vector3d moment;
    };
    std::vector<Solved> firsts;
    for (Index b = 0; b < count; ++b) {
      const OwnBeam& of = beams[static_cast<std::size_t>(b)];
      const double h = of.length / n;
      const SectionProperties properties = properties_of(of.section);
      const ShearAreas shear = shear_areas_of(of.section);
      Vector6 stiff;
      // Stretching, which theory of the second order leaves out, is held.
      constexpr double far_stiffer = 1e3;
      stiff << far_stiffer * E * properties.area.value(), G * shear.y.value(), G * shear.z.value(),
          G * torsion_properties_of(of.section).I_T->value(), E * properties.I_y.value(),
          E * properties.I_z.value();
      const auto rates = Element::rates(h);
      const Matrix12 K = rates.transpose() * (stiff / h).asDiagonal() * rates;
      std::array<Matrix12, 6> stress;
      for (Index c = 0; c < 6; ++c)
        stress[static_cast<std::size_t>(c)] = Element::stress(Vector6::Unit(c), h);
      Matrix12 into = Matrix12::Zero();
      for (Index k = 0; k < 4; ++k) into.block<3, 3>(3 * k, 3 * k) = of.axes.transpose();
      for (Index e = 0; e < per_beam; ++e) {
        const Vector3d middle = of.start + (static_cast<double>(e) + 0.5) * h * of.axes.col(0);
        const Vector6 cut = cut_at(static_cast<int>(b), middle);
        Matrix12 K_g = Matrix12::Zero();
        for (Index c = 0; c < 6; ++c) K_g += cut[c] * stress[static_cast<std::size_t>(c)];
        // Shear forces stand across the axis that bends, not across sections (Engesser's column).
        K_g += cut[0] / h * rates.middleRows<2>(1).transpose() * rates.middleRows<2>(1);
        const Index row = 6 * (b * per_beam + e - 1);
        put(row, row, into.transpose() * (K + K_g) * into);
        const Vector12 f = rates.transpose() * cut;
        const Vector12 world = into.transpose() * f;
        for (Index i = 0; i < 12; ++i)
          if (row + i >= 0) strained[row + i] += world[i];
        if (e == 0)
          firsts.push_back({K, K_g, into, f, cut_at(static_cast<int>(b), of.start).tail<3>()});
      }
    }
    for (const OwnForce& force : forces) {
      const Index row = 6 * ((force.beam + 1) * per_beam - 1) + 3;
      // -F . exp(theta) a, twice derived: theta^2 F . a - F . theta a . theta.
      put(row, row,
          force.force.dot(force.arm) * Matrix3d::Identity() -
              0.5 * (force.force * force.arm.transpose() + force.arm * force.force.transpose()));
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    REQUIRE(solver.info() == Eigen::Success);
    REQUIRE((solver.vectorD().array() > 0.0).all());
    const VectorXd motion = solver.solve(strained);
    std::vector<Vector3d> moments;
    for (Index b = 0; b < count; ++b) {
      const Solved& first = firsts[static_cast<std::size_t>(b)];
      Vector12 ends = Vector12::Zero();
      const Index row = 6 * (b * per_beam - 1);
      for (Index i = 0; i < 12; ++i)
        if (row + i >= 0) ends[i] = motion[row + i];
      ends = (first.into * ends).eval();
      const Vector12 added = (first.K + first.K_g) * ends - first.f;
      // Against the rigid beam the end forces of its first element are those of its cut forces.
      Vector3d moment = -added.segment<3>(3) - first.moment + first.moment;
      // In turned axes: half a turn more than vectors of turn have.
      moment -= 0.5 * Vector3d(ends.segment<3>(3)).cross(first.moment);
      moments.push_back(moment);
    }
    return moments;
  }

  /// Cut forces of the rigid chain in a beam's axes, of the forces beyond.
  Vector6 cut_at(int beam, const Vector3d& place) const {
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (const OwnForce& of : forces) {
      if (of.beam < beam) continue;
      const OwnBeam& on = beams[static_cast<std::size_t>(of.beam)];
      const Vector3d at = on.start + on.length * on.axes.col(0) + of.arm;
      force += of.force;
      moment += (at - place).cross(of.force);
    }
    const Matrix3d& axes = beams[static_cast<std::size_t>(beam)].axes;
    Vector6 cut;
    cut << axes.transpose() * force, axes.transpose() * moment;
    return cut;
  }

  /// Towards endlessly many elements (Richardson).
  std::vector<Vector3d> limit(int n) const {
    std::vector<Vector3d> coarse = added(n), fine = added(2 * n);
    for (std::size_t b = 0; b < fine.size(); ++b) fine[b] += (fine[b] - coarse[b]) / 3.0;
    return fine;
  }
};

struct L_case {
  double first = 3.0, second = 2.0;
  double about_z = 0.0, about_y = -90.0;  // how the second stands on the first [degrees]
  Vector3d force = Vector3d(-4e3, 3e3, -40e3), beside = Vector3d::Zero(), arm = Vector3d::Zero();
  std::string sections = test::bent::sections;

  std::string text() const {
    std::string of = header();
    of += fmt::format(
        "[bodies.inner]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"{0:.17g} m\", \"0 "
        "m\", "
        "\"0 m\"] }}\n[bodies.outer]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"{1:.17g} "
        "m\", \"0 m\", \"0 m\"], C = {2} }}\n",
        first, second, place_text(Vector3d(second, 0.0, 0.0) + arm));
    of += fmt::format(
        "[joints.heel]\nkind = \"fixed\"\nconnect = [\"ground\", \"inner.A\"]\nat = [\"0 m\", \"0 "
        "m\", \"0 m\"]\n[joints.knee]\nkind = \"fixed\"\nconnect = [\"inner.B\", "
        "\"outer.A\"]\nturn = [[\"z\", \"{:.17g} deg\"], [\"y\", \"{:.17g} deg\"]]\n",
        about_z, about_y);
    of += force_text("push", "outer.B", force);
    if (beside.norm() > 0.0) of += force_text("pull", "outer.C", beside);
    const auto beam = [&](const char* name, double length, const char* section) {
      return fmt::format(
          "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\nstart = \"A\"\naxis = \"x\"\nz = "
          "\"z\"\ndensity = \"1e-3 kg/m^3\"\n[[beam.segments]]\nlength = \"{1:.17g} m\"\nsection = "
          "\"{2}\"\n",
          name, length, section);
    };
    return of + sections + beam("inner", first, "arm") + beam("outer", second, "tip") + demands;
  }

  Chained own(const Section& inner, const Section& outer) const {
    const Matrix3d R = (Eigen::AngleAxisd(about_z * pi / 180.0, Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(about_y * pi / 180.0, Vector3d::UnitY()))
                           .toRotationMatrix();
    Chained of;
    of.beams = {{inner, Vector3d::Zero(), Matrix3d::Identity(), first},
                {outer, Vector3d(first, 0.0, 0.0), R, second}};
    of.forces = {{1, Vector3d::Zero(), force}};
    if (beside.norm() > 0.0) of.forces.push_back({1, R * arm, beside});
    return of;
  }

  /// The largest moment that second order adds by the elements, and how far the program is off.
  std::pair<double, double> compared(int n, int parts) const {
    const std::vector<Project> projects = parse_beams("L.toml", text());
    REQUIRE(projects.size() == 2);
    const Chained chained =
        own(projects[0].beam.segments.front().from, projects[1].beam.segments.front().from);
    const std::vector<Vector3d> expected = chained.limit(n);
    double largest = 0.0, wrong = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
      const Bent of(projects[b], parts);
      const Vector6 found =
          cuts_at(of.diagram(), 0.0, Side::behind) - cuts_at(of.straight(), 0.0, Side::behind);
      largest = std::max(largest, expected[b].norm());
      wrong = std::max(wrong, (found.tail<3>() - expected[b]).norm());
      CAPTURE(b, expected[b].transpose(), found.tail<3>().transpose());
    }
    return {largest, wrong};
  }
};

}  // namespace

TEST_CASE("an L of two beams bends as elements with exact turns do", "[second_order]") {
  for (const bool beside : {false, true}) {
    L_case of;
    if (beside) {
      of.beside = {6e3, -2e3, -8e3};
      of.arm = {0.0, 0.35, -0.2};
    }
    const auto [largest, wrong] = of.compared(20, 32);
    CAPTURE(beside, largest, wrong);
    CHECK(largest > 300.0);
    CHECK(wrong < 3e-5 * largest);
  }
}

TEST_CASE("any L of two beams bends as elements with exact turns do", "[second_order]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    L_case of;
    of.first = between(1.5, 4.0);
    of.second = between(1.0, 3.0);
    of.about_z = between(-170.0, 170.0);
    of.about_y = between(-80.0, 80.0);
    const auto any = [&](double size) {
      return Vector3d(between(-size, size), between(-size, size), between(-size, size));
    };
    of.force = any(25e3);
    of.beside = any(8e3);
    of.arm = {0.0, between(-0.4, 0.4), between(-0.4, 0.4)};
    CAPTURE(seed);
    const auto [largest, wrong] = of.compared(20, 32);
    CAPTURE(largest, wrong);
    CHECK(wrong < 3e-5 * largest);
  }
}

}  // namespace bent_chains_test
