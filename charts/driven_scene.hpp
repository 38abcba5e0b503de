#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "charts/arithmetic.hpp"
#include "charts/dyads.hpp"
#include "charts/scene.hpp"

namespace boxbeam::charts {

/// A planar mechanism whose drivers fix its motion, over one period or the time that is looked at,
/// at the instants that the program itself chooses. Friction is left out: it makes reactions depend
/// on each other, which is another question.
struct DrivenScene {
  std::string name;  ///< "sledge-rig, one period of 1.4286 s, 96 instants"
  planar::Mechanism mechanism;
  planar::Motion motion;
  DyadPlan dyads;

  /// Times of so many instants of the motion, from its begin.
  std::vector<double> times(std::size_t instants) const;
};

/// The planar scene, or why there is none: in `why`.
std::optional<DrivenScene> driven_scene_of(const Scenes& scenes, std::string& why);

/// The same states of a motion, much better.
struct ReferenceMotion {
  std::string name;  ///< "closed-form dyads, long double"
  std::vector<double> times;
  std::vector<InstantIn<long double>> instants;
};

/// At instants of the scene: closed-form dyads in long double where the mechanism is made of them,
/// else Newton's method in long double; multipliers by orthogonal decomposition in long double.
/// `name` says which.
ReferenceMotion reference_of(const DrivenScene& scene, std::size_t instants);
/// The second alone, whatever the mechanism is made of.
ReferenceMotion newton_reference_of(const DrivenScene& scene, std::size_t instants);

/// What of an instant is looked at.
enum class Quantity { position, velocity, acceleration, reaction };

/// "positions"
const char* to_text(Quantity quantity);

/// Largest errors of instants, each by the largest value over all of them; lengths by the
/// mechanism's size, forces by moments over that size; whole turns are no error.
class ErrorOf {
 public:
  ErrorOf(const planar::Mechanism& mechanism, const ReferenceMotion& reference);

  double operator()(Quantity quantity, const std::vector<InstantIn<long double>>& instants) const;
  /// Of one of them.
  double at(Quantity quantity, std::size_t index, const InstantIn<long double>& instant) const;

 private:
  using Vector = InstantIn<long double>::Vector;

  static const Vector& part(Quantity quantity, const InstantIn<long double>& instant);

  const ReferenceMotion* reference_;
  Vector col_weight_, row_weight_;
  long double largest_[4] = {};
};

/// The program's own state as an instant of this study.
InstantIn<long double> instant_of(const planar::State& state);

}  // namespace boxbeam::charts
