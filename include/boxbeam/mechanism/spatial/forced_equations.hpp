#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/friction.hpp"
#include "boxbeam/mechanism/spatial/loops.hpp"

namespace boxbeam::spatial {

/// What the coordinates that forces move do at an instant. Their accelerations a are those with
/// which all that acts, and what is inert, has no power in any motion that they leave free:
///
///     sum_k M_jk a_k + sum_i u_ij Q_i = 0,   M_jk = sum m c_j . c_k + w_j . I w_k
///
/// c_j, w_j velocity of a body's centre of mass and its rate of turn per rate of coordinate j, u_ij
/// the rate of joint i, Q_i what the inverse dynamics of all joints without the loops asks of it
/// where a = 0. Source: Kane and Levinson, Dynamics: Theory and Applications (1985), 4.1 to 6.1.
class ForcedEquations {
 public:
  /// `loops`: assembled at t = 0, or nothing; keeps it. `tolerance`: as of `ForcedMotion`.
  ForcedEquations(const Mechanism& mechanism, const Loops* loops, double tolerance);

  std::size_t freedoms() const { return joints_.size(); }
  /// Of a coordinate: 1, or the mechanism's size [m].
  double scale(std::size_t k) const { return scales_[k]; }
  const std::vector<FrictionContact>& contacts() const { return contacts_; }
  const std::vector<Friction>& laws() const { return laws_; }       ///< of the contacts
  const std::vector<std::string>& names() const { return names_; }  ///< of the contacts
  bool sticking() const { return sticking_; }                       ///< whether any contact can
  double rest() const { return rest_; }  ///< sliding velocity that is none, for the tolerance [m/s]

  /// Where they begin: coordinates and then rates, without units, as every `y` here.
  std::vector<double> start_of(const Mechanism& mechanism) const;
  void set(State& state, const std::vector<double>& y) const;
  /// Sets the coordinates, of a state whose time drivers have been asked for, and all bodies, where
  /// loops are closed beside `near`, without what forces give of accelerations. Nothing where they
  /// are not closed.
  std::optional<Loops::Sample> place(const Tree& tree, const std::vector<double>& y, double time,
                                     const Loops::Sample& near, State& state) const;
  /// A state as `accelerate` asks for it, with accelerations that forces give.
  void move(const Tree& tree, State& state, const Loops::Sample& closed,
            const Eigen::VectorXd& accelerations) const;

  /// Why accelerations are not determined.
  struct Unsolved {
    std::size_t massless = 0;  ///< a joint that moves nothing inert, or
    bool locked = false;       ///< friction locks
  };
  /// The accelerations without friction and what it does to them, without units.
  struct Response {
    Eigen::VectorXd accelerations;
    Eigen::MatrixXd by_friction;  ///< per unit of each force, a column each
    FrictionResponse of;
    std::optional<Unsolved> unsolved = {};
  };
  Response response_in(const Tree& tree, const State& state, const Loops::Sample& closed) const;

  /// The accelerations, the friction force of every contact, and what presses on it.
  struct Solution {
    Eigen::VectorXd accelerations;
    std::vector<double> friction = {};
    bool go_on = true;  ///< contacts, as they slide or stick
    std::optional<Unsolved> unsolved = {};
  };
  Solution solve(const Tree& tree, const State& state, const Loops::Sample& closed,
                 const std::vector<Slip>& slips) const;
  /// An acceleration without its unit.
  double acceleration_of(const Solution& of, std::size_t k) const {
    return of.accelerations[static_cast<Eigen::Index>(k)] / scales_[k];
  }
  void accelerate(const Tree& tree, State& state, const Loops::Sample& closed,
                  const std::vector<Slip>& slips) const;
  [[noreturn]] void say_unsolved(const Tree& tree, double time, const Unsolved& why) const;

 private:
  struct Directions;
  Directions directions_in(const Tree& tree, const State& state, const Loops::Sample& closed) const;
  /// Adds what rubs and what friction does to it.
  void know_friction(const Tree& tree, const State& state, const Loops::Sample& closed,
                     Response& of) const;

  const Loops* loops_;
  std::vector<FrictionContact> contacts_;
  std::vector<std::size_t> joints_;
  std::vector<double> scales_;
  std::vector<Friction> laws_;
  std::vector<std::string> names_;
  bool sticking_ = false;
  double rest_;
};

}  // namespace boxbeam::spatial
