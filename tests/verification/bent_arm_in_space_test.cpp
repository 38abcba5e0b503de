// An L of two elastic beams in space, whichever is verified, against finite elements that share
// nothing with the program.

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/cut_arm.hpp"
#include "support/space_elements.hpp"

namespace bent_arm_in_space_test {

using namespace boxbeam;
using namespace test::cut_arm;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::space_arm::check_alike;
using test::space_arm::Cuts;
using test::space_arm::cuts_of;

namespace {

/// The axes of the second beam in those of the first.
Matrix3d second_axes(const Moved& of) {
  const spatial::State state = of.chain().at(of.rigid().begin().value());
  const auto axes = [&](const char* name) -> Matrix3d {
    return state.bodies[static_cast<std::size_t>(body_index(of.chain().mechanism(), name))].R_WB;
  };
  return axes("inner").transpose() * axes("outer");
}

/// The L by sixty even elements a beam, in the axes of the first beam, six freedoms for each node
/// from its start; of the second beam alone as well. Rotary inertia across the axes at the nodes.
struct FiniteElements {
  static constexpr Eigen::Index n = 60;
  MatrixXd K = MatrixXd::Zero(12 * n + 6, 12 * n + 6), M = K, K_second = K, M_second = K;
  std::vector<Vector3d> nodes;

  FiniteElements(const Section& first, const Section& second, const Matrix3d& axes) {
    add(first, Matrix3d::Identity(), first_length, Vector3d::Zero(), 0, K, M);
    add(second, axes, second_length, Vector3d(first_length, 0.0, 0.0), n, K_second, M_second);
    K += K_second;
    M += M_second;
  }

  /// The first frequencies with its start clamped [Hz].
  std::vector<double> frequencies(std::size_t count) const {
    const Eigen::Index free = K.rows() - 6;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
        M.bottomRightCorner(free, free), K.bottomRightCorner(free, free), Eigen::EigenvaluesOnly);
    std::vector<double> found;
    for (std::size_t k = 0; k < count; ++k)
      found.push_back(
          1.0 /
          (2.0 * pi * std::sqrt(modes.eigenvalues()[free - 1 - static_cast<Eigen::Index>(k)])));
    return found;
  }

 private:
  void add(const Section& section, const Matrix3d& axes, double length, const Vector3d& start,
           Eigen::Index at, MatrixXd& k, MatrixXd& m) {
    test::space_elements::add_beam({section, axes, length, 7850.0, n, 6 * at, true}, k, m);
    const double h = length / n;
    if (nodes.empty()) nodes.push_back(start);
    for (Eigen::Index i = 1; i <= n; ++i)
      nodes.push_back(start + h * static_cast<double>(i) * axes.col(0));
  }
};

}  // namespace

TEST_CASE("an L of two beams has the frequencies of a model of finite elements", "[beams_beside]") {
  const std::string text = bent_arm(hinge({0.48, -0.6, 0.64}, 1e-6, 2.0));
  const Moved inner = moved(text), outer = moved(text, 1);
  const FiniteElements elements(inner.project.beam.segments.front().from,
                                outer.project.beam.segments.front().from, second_axes(inner));
  const std::vector<double> expected = elements.frequencies(6);
  for (const Moved* of : {&inner, &outer}) {
    const std::vector<frame::BeamMode> found = of->modes(32, 6);
    REQUIRE(found.size() == 6);
    // Torsion and stretching of linear shapes: (k h)^2/24 of their part.
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(found[k].frequency == Approx(expected[k]).epsilon(k < 4 ? 5e-5 : 3e-4));
    // One beam alone, the other rigid, is far from it.
    Project stiff = of->project;
    stiff.elastic_beside.clear();
    CHECK(Moved(std::move(stiff)).modes(32, 1).front().frequency > 1.01 * expected.front());
  }
}

// A hinge that swings by a small angle: (K - omega^2 M) u = omega^2 M R, and what the start of each
// beam bears of u and of R together.
TEST_CASE("an L of two beams on a swinging hinge vibrates as a model of finite elements",
          "[beams_beside]") {
  const double small = 1e-6;
  for (const auto& [axis, frequency] :
       {std::pair{Vector3d(0.48, -0.6, 0.64), 3.0}, {Vector3d(1.0, 0.0, 0.0), 1.5}}) {
    const std::string text = bent_arm(hinge(axis, small, frequency));
    const Moved inner = moved(text), outer = moved(text, 1);
    const Matrix3d axes = second_axes(inner);
    const FiniteElements elements(inner.project.beam.segments.front().from,
                                  outer.project.beam.segments.front().from, axes);
    const Eigen::Index size = elements.K.rows(), free = size - 6;
    VectorXd R(size);
    for (std::size_t i = 0; i < elements.nodes.size(); ++i) {
      R.segment<3>(6 * static_cast<Eigen::Index>(i)) = axis.cross(elements.nodes[i]);
      R.segment<3>(6 * static_cast<Eigen::Index>(i) + 3) = axis;
    }
    const double square = std::pow(2.0 * pi * frequency, 2);
    VectorXd u = VectorXd::Zero(size);
    const MatrixXd dynamic = elements.K - square * elements.M;
    u.tail(free) =
        dynamic.bottomRightCorner(free, free).lu().solve(square * (elements.M * R).tail(free));
    const Cuts heel = -(dynamic * u - square * elements.M * R).head<6>();
    const Cuts knee =
        -((elements.K_second - square * elements.M_second) * u - square * elements.M_second * R)
             .segment<6>(6 * FiniteElements::n);
    Cuts in_second;
    in_second << axes.transpose() * knee.head<3>(), axes.transpose() * knee.tail<3>();
    const ElasticMotionInSpace of_inner = inner.by(8, 10), of_outer = outer.by(8, 10);
    INFO("axis " << axis.transpose() << ", " << frequency << " Hz against "
                 << of_inner.lowest_frequency());
    for (const double part : {0.2, 0.55}) {
      const double turn = small * std::sin(2.0 * pi * part);
      check_alike(cuts_of(of_inner.loads_at(inner.at(part)), 0.0), turn * heel, turn * heel, 5e-4);
      check_alike(cuts_of(of_outer.loads_at(outer.at(part)), 0.0), turn * in_second,
                  turn * in_second, 5e-4);
      // The rigid L is far from it.
      const Cuts rigid = cuts_of(outer.rigid().loads_at(outer.at(part)), 0.0);
      CHECK((rigid - turn * in_second).tail<3>().norm() >
            0.01 * std::abs(turn) * in_second.tail<3>().norm());
    }
  }
}

}  // namespace bent_arm_in_space_test
