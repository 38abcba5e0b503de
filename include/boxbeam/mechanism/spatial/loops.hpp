#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/tree.hpp"
#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam::spatial {

/// One equation of a closing joint, zero where it is closed; u in the axes of its body a, w in
/// those of b, p their places in the world:
///
///     along:    u . (p_b - p_a)
///     square:   u . w
///     distance: |p_b - p_a| - l(t)
///     thread:   u . (p_b - p_a) - lead theta/(2 pi),  theta the turn of b against a about u
///     mesh:     the sum of factor q of the coordinates that teeth tie, less their offset
///
/// A thread looks alike after every turn: which one it is follows from the motion.
struct LoopRow {
  enum class Kind { along, square, distance, thread, mesh };
  Kind kind = Kind::along;
  std::size_t joint = 0;  ///< index among the closing ones
  Eigen::Vector3d u = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();
};

class ForcedMotion;
class LoopFactors;

/// The closing joints of a mechanism: they decide the coordinates that neither drivers nor forces
/// move. Loops are cut at the closing joints; what the tree of the other joints leaves open there
/// is brought to zero by Newton's method on the free coordinates, and the multipliers of the
/// equations are those that leave the free joints without a force along their axes. An equation
/// asks only for the coordinates between the bodies of its joint, on the ways from them to the body
/// that carries both: by these alone it is evaluated, and the systems are solved by a sparse
/// elimination. Source: Haug, Computer Aided Kinematics and Dynamics (1989), chapter 9;
/// Featherstone (2008), chapter 8.
class Loops {
 public:
  /// A closed position: the free coordinates with their rates.
  struct Sample {
    double time = 0.0;
    Eigen::VectorXd q, rate, acceleration;
    Eigen::VectorXd turned = {};  ///< as `turned`
    /// Rates of the free coordinates per rate of each that forces move, a column for each.
    Eigen::MatrixXd following = {};
  };

  /// Closes them at t = 0, as near to the starts of the free coordinates as it can. Throws
  /// AnalysisError with place where no position closes them, or freedoms are left that nothing
  /// moves.
  explicit Loops(const Tree& tree);

  /// Follows the drivers, and what forces move, over the time that is looked at. Keeps `forced`.
  /// Throws AnalysisError where a dead point is met, equations contradict each other, or a period
  /// ends elsewhere than it began.
  void follow(const Tree& tree, const ForcedMotion* forced);

  /// From the driven and forced coordinates of a state and its time: the free ones, with their
  /// rates, and all bodies; always on the branch of the start. Throws AnalysisError.
  Sample close(const Tree& tree, State& state) const;

  /// The same beside a closed position; nothing where that is too far away.
  std::optional<Sample> close_beside(const Sample& near, const Tree& tree, State& state) const;
  /// What a state has of the free coordinates.
  Sample sample_of(const State& state) const;
  const Sample& first() const { return samples_.front(); }  ///< at t = 0

  /// The wrenches of the joints that carry bodies, and behind them what every closing joint does to
  /// its body b, about its place there, where `others` act beside the mechanism's loads.
  void wrenches(const Tree& tree, const State& state, std::span<const BodyWrench> others,
                std::vector<Wrench>& joints) const;

  std::size_t equations() const { return rows_.size(); }
  std::size_t repeating() const { return rows_.size() - chosen_.size(); }  ///< equations
  std::size_t freedoms() const {
    return free_.joints.size();
  }  ///< coordinates that the loops decide
  const std::vector<std::size_t>& joints() const { return free_.joints; }  ///< of these coordinates

  /// For every joint that carries a body, then every closing one: whether bodies without elasticity
  /// determine what it carries. They do not where joints repeat each other. Source: Wojtyra,
  /// Multibody System Dynamics 14 (2005).
  const std::vector<char>& unique() const { return unique_; }

  /// Sign of the determinant of the equations that are solved: branches that meet differ in it.
  int branch() const { return branch_; }

  /// Largest error of all equations in a state, lengths over the mechanism's size.
  double residual_of(const Tree& tree, const State& state) const;
  /// Condition number of the equations that are solved, without units.
  double condition_of(const Tree& tree, const State& state) const;

 private:
  using Rows = std::vector<std::size_t>;

  void set(State& state, const Sample& sample) const;
  /// A coordinate between the bodies of a closing joint: 1 where it moves its b, -1 its a.
  struct Between {
    Eigen::Index column;
    double sign;
  };
  /// Coordinates, which of them are between the bodies of every closing joint, and their scales.
  struct Columns {
    std::vector<std::size_t> joints;
    std::vector<std::vector<Between>> between;
    Eigen::VectorXd scale;
  };
  Columns columns_of(const Mechanism& mechanism, MovedBy moved_by) const;
  /// What rows of the derivative by coordinates have, without units, row by row.
  std::vector<double> entries(const Tree& tree, const State& state, const Rows& rows,
                              const Columns& columns) const;
  SparsePattern pattern_of(const Rows& rows) const;
  Eigen::SparseMatrix<double> jacobian(const Tree& tree, const State& state,
                                       const Rows& rows) const;
  LoopFactors factors(const Tree& tree, const State& state) const;  ///< of the chosen rows
  Eigen::VectorXd open(const Tree& tree, const State& state, const Rows& rows) const;

  /// Where screws close loops: how far each has turned by its slide, and all angles [rad]. Between
  /// two positions less than half a turn apart in all of them no screw changes its turn unseen.
  Eigen::VectorXd turned(const State& state) const;
  bool keeps_turns(const Sample& near, const State& state) const;

  Eigen::MatrixXd following(const Tree& tree, const State& state, const LoopFactors& J) const;

  void assemble(const Tree& tree, State& state) const;
  /// From free coordinates; how far all is open then.
  Eigen::VectorXd nearest_closed(const Tree& tree, State& state, Eigen::VectorXd q) const;
  /// The nearest one to the starts that is on the wanted branch; whether there is any.
  bool assemble_elsewhere(const Tree& tree, State& state, const Eigen::VectorXd& starts) const;
  void choose_rows(const Tree& tree, const State& state);
  void judge_uniqueness(const Tree& tree, const State& state);
  void keep_order(const Tree& tree, const State& state);
  void drive(const Tree& tree, State& state, double time) const;

  bool converge(const Tree& tree, State& state, Eigen::VectorXd& q, double& first) const;
  Sample with_rates(const Tree& tree, State& state, const Eigen::VectorXd& q) const;
  Sample followed(const Tree& tree, Sample from, double until, std::vector<Sample>* kept) const;

  std::vector<LoopRow> rows_;
  Rows all_, chosen_;                  ///< all rows; those that determine the free coordinates
  Columns free_, led_;                 ///< coordinates that the loops decide, and that forces move
  Eigen::VectorXd row_scale_;          ///< that leaves the Jacobian without units
  double size_ = 1.0;                  ///< of the mechanism [m]
  double longest_step_ = 0.01;         ///< of following [s]
  double begin_ = 0.0, period_ = 0.0;  ///< after which all repeats; 0: it does not
  int branch_ = 0;
  std::vector<ClosingJoint> screws_;  ///< those that close loops
  std::vector<std::size_t> angles_;   ///< joints whose coordinates are angles, where there are any
  std::vector<char> unique_;
  std::vector<Sample> samples_;
  const ForcedMotion* forced_ = nullptr;
  SparsePattern pattern_;                  ///< of the chosen rows
  std::vector<SparseElimination> orders_;  ///< of elimination, which suit along the motion
};

/// Joints whose loads bodies without elasticity do not determine.
std::vector<std::string> names_not_unique(const Mechanism& mechanism, const Loops& loops);

}  // namespace boxbeam::spatial
