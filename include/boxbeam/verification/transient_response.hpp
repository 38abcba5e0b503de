#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace boxbeam {

/// What moves modal coordinates at an instant: eta'' + damping eta' + stiffness eta = force.
struct ModalEquations {
  Eigen::MatrixXd damping;    ///< [1/s]
  Eigen::MatrixXd stiffness;  ///< [1/s^2]
  Eigen::VectorXd force;      ///< [sqrt(kg) m/s^2]
};

/// Modal coordinates and their rates at an instant.
struct ModalState {
  Eigen::VectorXd eta;    ///< [sqrt(kg) m]
  Eigen::VectorXd speed;  ///< [sqrt(kg) m/s]
};

/// Modal coordinates over a span of time that does not repeat, from a state at its beginning:
///
///     eta'' + C(t) eta' + K(t) eta = p(t)
///
/// by Gauss's method of three stages, which is collocation at the zeros of Legendre's polynomial:
/// of order 6 at the ends of steps, stable for steps of any length, and without damping of its own:
/// at constant C and K its vibrations keep their energy. Between the ends of steps the polynomial
/// of collocation holds, of order 5 in eta, 4 in its rate. Steps end at every border, where C, K
/// and p may jump or bend; the equations are asked inside steps only.
/// Source: Butcher, Math. Comp. 18 (1964), 50; Hairer, Lubich, Wanner, Geometric Numerical
/// Integration (2006), II.1.3.
class TransientResponse {
 public:
  using EquationsAt = std::function<ModalEquations(double time)>;

  /// `borders`: ascending, with both ends [s]. A step of a twentieth of a period has its phase
  /// wrong by 6e-8 of a turn in each period.
  TransientResponse(const EquationsAt& equations, const std::vector<double>& borders,
                    ModalState start, double longest_step);

  /// Goes on from the end over further borders.
  void go_on(const EquationsAt& equations, const std::vector<double>& borders, double longest_step);

  /// From the end on in other coordinates, `by` times those before; there may be more or fewer.
  void turn(const Eigen::MatrixXd& by);

  /// At a time of the span [s]; before it the start, behind it the end; where coordinates turn,
  /// those behind.
  ModalState at(double time) const;

  /// The ends of all steps with the beginning [s], and the states there.
  const std::vector<double>& times() const { return times_; }
  const std::vector<ModalState>& states() const { return states_; }

 private:
  static constexpr Eigen::Index stages = 3;
  std::vector<double> times_;
  std::vector<ModalState> states_;
  std::vector<Eigen::MatrixXd> accelerations_;  ///< of each step, a column for each stage
};

/// Modal coordinates that nothing couples and whose damping and stiffness stay,
///
///     eta_j'' + damping_j eta_j' + stiffness_j eta_j = p_j(t)
///
/// at the ends of the steps of `TransientResponse`, by its method.
struct UncoupledResponse {
  std::vector<double> times;   ///< [s]
  Eigen::MatrixXd eta, speed;  ///< a row for each time, a column for each mode
};
UncoupledResponse uncoupled_response(const std::function<Eigen::VectorXd(double time)>& force,
                                     const Eigen::VectorXd& damping,
                                     const Eigen::VectorXd& stiffness,
                                     const std::vector<double>& borders, const ModalState& start,
                                     double longest_step);

/// The state of rest under constant equations: K eta = p, of what moves without force none.
ModalState resting(const ModalEquations& equations);

/// The state that goes through three values at steps of h, at the first, by the parabola.
ModalState moving_with(const std::array<Eigen::VectorXd, 3>& eta, double h);

}  // namespace boxbeam
