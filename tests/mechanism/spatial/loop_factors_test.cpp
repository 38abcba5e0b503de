// Loops by the entries of their Jacobian alone, against whole matrices: differences of the closing
// errors, factorised and judged here as dense ones.

#include "src/mechanism/spatial/loop_factors.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "src/mechanism/spatial/loop_rows.hpp"
#include "support/random_loops.hpp"
#include "support/spatial_balance.hpp"

namespace loop_factors_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::add;
using test::check_balance;
using test::closing;
using test::joint_of;

namespace {

std::vector<std::size_t> free_joints(const Mechanism& mechanism) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.kind != JointKind::fixed && joint.moved_by == MovedBy::loops) free.push_back(i);
  }
  return free;
}

/// Of every row, lengths over the mechanism's size.
VectorXd each_row(const Mechanism& mechanism, const State& state, double RowMotion::*of) {
  const std::vector<LoopRow> rows = rows_of(mechanism);
  const double size = size_of(mechanism);
  VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    values[static_cast<Eigen::Index>(r)] = spatial::motion_of(mechanism, rows[r], state).*of /
                                           (rows[r].kind == LoopRow::Kind::square ? 1.0 : size);
  }
  return values;
}

double scale_of(const Mechanism& mechanism, std::size_t joint) {
  return is_angle(mechanism.joints[joint].kind) ? 1.0 : size_of(mechanism);
}

/// Central differences of all rows by the free coordinates, lengths over the mechanism's size.
MatrixXd by_differences(const Mechanism& mechanism, const State& state) {
  constexpr double h = 1e-6;
  const Tree tree(mechanism);
  const std::vector<std::size_t> free = free_joints(mechanism);
  MatrixXd J(rows_of(mechanism).size(), free.size());
  State beside = state;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const double step = h * scale_of(mechanism, free[k]);
    const auto at = [&](double q) {
      beside.coordinates[free[k]].value = q;
      tree.move(beside);
      return each_row(mechanism, beside, &RowMotion::value);
    };
    const double q = state.coordinates[free[k]].value;
    J.col(static_cast<Eigen::Index>(k)) = (at(q + step) - at(q - step)) / (2.0 * h);
    beside.coordinates[free[k]].value = q;
  }
  return J;
}

/// Of all rows, by a small shift or turn of all that a joint carries.
MatrixXd by_displaced_branches(const Mechanism& mechanism, const State& state, std::size_t joint) {
  constexpr double h = 1e-6;
  MatrixXd J(rows_of(mechanism).size(), 6);
  std::vector<char> carried(mechanism.bodies.size(), 0);
  for (std::size_t i = joint; i < carried.size(); ++i) {
    const int parent = mechanism.joints[i].parent;
    carried[i] = i == joint || (parent != ground && carried[static_cast<std::size_t>(parent)]);
  }
  for (int way = 0; way < 6; ++way) {
    const auto at = [&](double step) {
      State beside = state;
      for (std::size_t i = 0; i < carried.size(); ++i) {
        if (!carried[i]) continue;
        BodyMotion& body = beside.bodies[i];
        if (way < 3) {
          body.position += step * size_of(mechanism) * Vector3d::Unit(way);
          continue;
        }
        const Eigen::Matrix3d turn = rotation_about(step * Vector3d::Unit(way - 3));
        const Vector3d pivot = state.bodies[joint].joint;
        body.position = pivot + turn * (body.position - pivot);
        body.R_WB = turn * body.R_WB;
      }
      return each_row(mechanism, beside, &RowMotion::value);
    };
    J.col(way) = (at(h) - at(-h)) / (2.0 * h);
  }
  return J;
}

/// Uniqueness by the null space of the whole transposed Jacobian, by what its multipliers do to
/// every joint.
std::vector<char> unique_by_svd(const Mechanism& mechanism, const State& state) {
  const MatrixXd J = by_differences(mechanism, state);
  const Eigen::BDCSVD<MatrixXd> svd(J, Eigen::ComputeFullU);
  const Eigen::Index rank = (svd.singularValues().array() > 1e-6 * svd.singularValues()[0]).count();
  const MatrixXd held = svd.matrixU().rightCols(J.rows() - rank);
  std::vector<char> unique;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const MatrixXd carried = by_displaced_branches(mechanism, state, i).transpose() * held;
    unique.push_back(carried.norm() < 1e-5);
  }
  const std::vector<LoopRow> rows = rows_of(mechanism);
  for (std::size_t k = 0; k < mechanism.closing.size(); ++k) {
    double size = 0.0;
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (rows[r].joint == k) size += held.row(static_cast<Eigen::Index>(r)).norm();
    unique.push_back(size < 1e-5);
  }
  return unique;
}

std::optional<Chain> chain_of(const Mechanism& mechanism) {
  std::optional<Chain> chain;
  try {
    chain.emplace(mechanism);
  } catch (const AnalysisError&) {  // by chance they leave freedoms, or cannot follow
  }
  return chain;
}

/// Cranks of 1 m, 1 m apart, about y, each with the next a parallelogram: couplers on universal
/// joints that end in balls, or on revolute joints that end in revolute joints. All turn alike.
struct Row {
  Mechanism mechanism;
  std::vector<int> cranks;
};

Row parallelograms(int loops, bool flat) {
  Row row;
  row.mechanism.gravity = {0.0, 0.0, -9.81};
  row.mechanism.duration = Duration{0.0, 0.1};
  const auto moved = [](const char* name, int parent, const Vector3d& at, const Vector3d& axis) {
    Joint joint = joint_of(name, JointKind::revolute, parent, at, axis);
    joint.moved_by = MovedBy::loops;
    return joint;
  };
  Joint first = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitY());
  first.driver = PolynomialDriver{{0.1, 0.5}};
  const auto with_mass = [&](int body) {
    test::set_mass(row.mechanism.bodies[static_cast<std::size_t>(body)], 2.0, {0.1, 0.2, 0.3},
                   {0.1, 0.2, 0.15});
    return body;
  };
  int last = with_mass(add(row.mechanism, first, false));
  row.cranks.push_back(last);
  for (int i = 1; i <= loops; ++i) {
    const int next = with_mass(
        add(row.mechanism, moved("crank", ground, {1.0 * i, 0.0, 0.0}, Vector3d::UnitY()), true));
    int coupler =
        add(row.mechanism, moved("coupler", last, Vector3d::UnitZ(), Vector3d::UnitY()), true);
    if (!flat)
      coupler =
          add(row.mechanism, moved("hook", coupler, Vector3d::Zero(), Vector3d::UnitZ()), true);
    with_mass(coupler);
    ClosingJoint end = closing("end", flat ? ClosingKind::revolute : ClosingKind::spherical,
                               {coupler, {1.0, 0.0, 0.0}}, {next, Vector3d::UnitZ()});
    end.axis = Vector3d::UnitY();
    row.mechanism.closing.push_back(end);
    row.cranks.push_back(last = next);
  }
  return row;
}

}  // namespace

TEST_CASE("factors solve as whole matrices do, with the sign of their determinant") {
  test::Chance chance(7);
  int signs = 0;
  for (int size = 1; size <= 40; ++size) {
    MatrixXd A = MatrixXd::Zero(size, size);
    SparsePattern pattern;
    pattern.rows = pattern.cols = size;
    std::vector<double> values;
    // A circle of entries, so that there is a determinant, and some more.
    const int shift = chance.one_of(size);
    for (int r = 0; r < size; ++r) {
      pattern.row_start.push_back(static_cast<int>(values.size()));
      std::set<int> columns{(r + shift) % size};
      for (int more = 0; more < 2; ++more) columns.insert(chance.one_of(size));
      for (const int c : columns) {
        pattern.col.push_back(c);
        values.push_back(A(r, c) = chance.any());
      }
    }
    pattern.row_start.push_back(static_cast<int>(values.size()));
    INFO(size);
    const Eigen::JacobiSVD<MatrixXd> svd(A);
    const double condition = svd.singularValues()[0] / svd.singularValues()[size - 1];
    if (!(condition < 1e6)) continue;
    const LoopFactors factors(pattern, values, {});
    VectorXd b(size);
    for (double& x : b) x = chance.any();
    CHECK((A * factors.solve(b) - b).norm() < 1e-12 * condition);
    CHECK((A.transpose() * factors.solve_transposed(b) - b).norm() < 1e-12 * condition);
    const double determinant = A.determinant();
    signs |= determinant > 0.0 ? 1 : 2;
    CHECK(factors.sign_of_determinant() == (determinant > 0.0 ? 1 : -1));
    // Twice the same row.
    if (size < 2) continue;
    SparsePattern singular = pattern;
    std::vector<double> same = values;
    const auto row = [&](int r) {
      return std::pair(pattern.row_start[static_cast<std::size_t>(r)],
                       pattern.row_start[static_cast<std::size_t>(r) + 1]);
    };
    const auto [from, until] = row(0);
    singular.col.insert(singular.col.end(), pattern.col.begin() + from,
                        pattern.col.begin() + until);
    same.insert(same.end(), values.begin() + from, values.begin() + until);
    const auto [last, end] = row(size - 1);
    singular.col.erase(singular.col.begin() + last, singular.col.begin() + end);
    same.erase(same.begin() + last, same.begin() + end);
    singular.row_start.back() = static_cast<int>(same.size());
    const VectorXd none = LoopFactors(singular, same, {}).solve(b);
    CHECK(!(none.cwiseAbs().maxCoeff() < 1e12));
  }
  CHECK(signs == 3);
}

TEST_CASE("loops by chance move as the whole Jacobian by differences says, and are in balance") {
  int judged = 0, large = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    test::Chance chance(seed);
    const int chains = 2 + static_cast<int>(seed % 5);
    const Mechanism mechanism = test::random_loops(chance, {}, chains);
    const std::optional<Chain> chain = chain_of(mechanism);
    if (!chain) continue;
    ++judged;
    INFO("seed " << seed);
    const Loops& loops = *chain->loops();
    State state = chain->at(0.37);
    const MatrixXd J = by_differences(mechanism, state);
    const Eigen::JacobiSVD<MatrixXd> svd(J);
    const VectorXd& values = svd.singularValues();
    const double condition = values[0] / values[values.size() - 1];
    CHECK(loops.condition_of(chain->tree(), state) ==
          Approx(condition).epsilon(1e-6 + 1e-8 * condition));
    CHECK(loops.repeating() == 0);
    CHECK(loops.branch() == (J.determinant() > 0.0 ? 1 : -1));
    for (const char unique : loops.unique()) CHECK(unique != 0);
    check_balance(*chain, 0.37, std::max(1e-10, 1e-14 * condition));
    if (J.rows() <= LoopFactors::most_whole) continue;
    ++large;
    // Rates: J q' + what the rows have without q' = 0.
    const std::vector<std::size_t> free = free_joints(mechanism);
    State without = state;
    for (const std::size_t i : free) without.coordinates[i].rate = 0.0;
    chain->tree().move(without);
    const VectorXd rates = J.fullPivLu().solve(-each_row(mechanism, without, &RowMotion::rate));
    double off = 0.0;
    for (std::size_t k = 0; k < free.size(); ++k)
      off = std::max(off, std::abs(state.coordinates[free[k]].rate / scale_of(mechanism, free[k]) -
                                   rates[static_cast<Eigen::Index>(k)]));
    CHECK(off < 1e-8 * condition * (1.0 + rates.cwiseAbs().maxCoeff()));
    const double size =
        each_row(mechanism, without, &RowMotion::acceleration).cwiseAbs().maxCoeff();
    CHECK(each_row(mechanism, state, &RowMotion::rate).cwiseAbs().maxCoeff() < 1e-11 * condition);
    CHECK(each_row(mechanism, state, &RowMotion::acceleration).cwiseAbs().maxCoeff() <
          1e-11 * condition * (1.0 + size));
  }
  CHECK(judged > 200);
  CHECK(large > 80);
}

TEST_CASE("joints twice repeat each other, as the singular values of the whole Jacobian say") {
  int judged = 0;
  for (unsigned seed = 1; seed <= 90; ++seed) {
    test::Chance chance(seed);
    Mechanism mechanism = test::random_loops(chance, {}, 2 + static_cast<int>(seed % 4));
    const auto twice =
        static_cast<std::size_t>(chance.one_of(static_cast<int>(mechanism.closing.size())));
    mechanism.closing.push_back(mechanism.closing[twice]);
    const std::optional<Chain> chain = chain_of(mechanism);
    if (!chain) continue;
    ++judged;
    INFO("seed " << seed);
    const State state = chain->at(0.2);
    const MatrixXd J = by_differences(mechanism, state);
    CHECK(chain->loops()->repeating() == static_cast<std::size_t>(J.rows() - J.cols()));
    CHECK(chain->loops()->unique() == unique_by_svd(mechanism, state));
    CHECK(chain->loops()->unique()[mechanism.bodies.size() + twice] == 0);
    const double condition = chain->loops()->condition_of(chain->tree(), state);
    check_balance(*chain, 0.2, std::max(1e-10, 1e-14 * condition));
  }
  CHECK(judged > 25);
}

TEST_CASE("what flat parallelograms in space carry across is not unique, few or many") {
  for (const int loops : {1, 4, 80}) {
    INFO(loops);
    const Row row = parallelograms(loops, true);
    const Chain chain(row.mechanism);
    const State state = chain.at(0.08);
    const Eigen::Index asked = 5 * loops, free = 2 * loops;
    CHECK(chain.loops()->equations() == static_cast<std::size_t>(asked));
    CHECK(chain.loops()->repeating() == static_cast<std::size_t>(asked - free));
    CHECK(chain.loops()->unique() == unique_by_svd(row.mechanism, state));
    check_balance(chain, 0.08);
  }
}

TEST_CASE("a thousand parallelograms in a row turn as the first, in balance") {
  const Row row = parallelograms(1000, false);
  const Chain chain(row.mechanism);
  const State state = chain.at(0.08);
  double worst = 0.0;
  for (const int crank : row.cranks) {
    const DriverState& q = state.coordinates[static_cast<std::size_t>(crank)];
    worst = std::max(
        {worst, std::abs(q.value - 0.14), std::abs(q.rate - 0.5), std::abs(q.acceleration)});
  }
  CHECK(worst < 1e-9);
  check_balance(chain, 0.08, 1e-9);
}

TEST_CASE("a freedom that many loops leave is named") {
  Row row = parallelograms(80, false);
  // The last crank slides besides, and nothing holds that.
  const int slide = add(row.mechanism,
                        joint_of("slide", JointKind::prismatic, row.cranks.back(), Vector3d::Zero(),
                                 Vector3d::UnitY()),
                        true);
  const int spin =
      add(row.mechanism,
          joint_of("spin", JointKind::revolute, slide, Vector3d::Zero(), Vector3d::UnitZ()), true);
  row.mechanism.closing.push_back(closing(
      "held", ClosingKind::slot, {row.cranks.back(), Vector3d::Zero()}, {spin, Vector3d::Zero()}));
  try {
    const Chain chain(row.mechanism);
    FAIL("nothing was refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().what.find("freedom") != std::string::npos);
    CHECK(error.failure().what.find("spin") != std::string::npos);
  }
}

}  // namespace loop_factors_test
