#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// How the stress ranges of a life are distributed, EN 1993-1-9 clause 7.1(2) and (3).
enum class Loading {
  spectrum,            ///< ranges of many sizes: every branch of the curve down to its cut-off
  constant_amplitude,  ///< one range: none below the constant-amplitude limit does damage
};

/// Which stress a curve resists.
enum class StressKind { direct, shear };

/// A straight piece of a curve in logarithmic axes: range^slope N is constant on it.
struct SnBranch {
  double slope = 3.0;
  double until = 0.0;  ///< cycles at its lower end; infinity where it never ends
};

/// A fatigue strength curve: stress range over cycles, continuous, of straight pieces.
///
///     range^m N = reference^m N_ref on the first branch; each branch begins where the last ends
///
/// EN 1993-1-9: reference d_sigma_C at 2e6, m = 3 until 5e6 (d_sigma_D, the constant-amplitude
/// limit), m = 5 until 1e8 (d_sigma_L, the cut-off). Source: 7.1(2), 7.1(3), figure 7.1.
struct SnCurve {
  std::string code;  ///< with its edition
  std::string name;  ///< within the code: "100", "36*", "C2"
  StressKind kind = StressKind::direct;
  Stress reference;  ///< a point of the first branch
  double reference_cycles = 2e6;
  std::vector<SnBranch> branches;                  ///< from short to long lives
  std::optional<double> constant_amplitude_limit;  ///< cycles at which the limit lies
  std::optional<double> cut_off;  ///< cycles at which the cut-off lies; none: every range damages
  bool unconfirmed = false;       ///< the figures are recalled, not read in the code
  std::string source;             ///< clause or table
};

/// A curve prepared for many evaluations. SI: ranges in Pa.
class SnLine {
 public:
  explicit SnLine(const SnCurve& curve);

  /// Largest range that `cycles` cycles of one size may have.
  double strength_at(double cycles, Loading loading) const;
  /// Cycles of one range to failure; infinity at ranges that do no damage.
  double cycles_to_failure(double range, Loading loading) const;
  /// Strength at the constant-amplitude limit; zero where the curve has none.
  double limit() const { return limit_; }
  /// Strength at the cut-off; zero where the curve has none.
  double cut_off() const { return cut_off_; }

 private:
  struct Piece {
    double slope, until, strength;  ///< strength at `until`; zero at the end of an endless branch
    double from_cycles, from_strength;  ///< a point on it
  };
  std::vector<Piece> pieces_;
  double limit_ = 0.0, cut_off_ = 0.0;
  double limit_cycles_ = 0.0, cut_off_cycles_ = 0.0;
};

/// Largest range that `cycles` cycles of one size may have; never below the constant-amplitude
/// limit (constant amplitude) or the cut-off (spectrum), where the curve has them.
Stress strength_at(const SnCurve& curve, double cycles, Loading loading);

/// Cycles of one range to failure; infinity at ranges that do no damage.
double cycles_to_failure(const SnCurve& curve, Stress range, Loading loading);

/// Strength at the constant-amplitude limit (EN 1993-1-9: d_sigma_D); zero where there is none.
Stress knee_of(const SnCurve& curve);
/// Strength at the cut-off (EN 1993-1-9: d_sigma_L); zero where there is none.
Stress cut_off_of(const SnCurve& curve);

/// The same curve with all its strengths multiplied, as the size effect and partial factors ask.
SnCurve scaled(SnCurve curve, double factor);

/// Detail category for direct stress, EN 1993-1-9 figure 7.1 [MPa]; its range of names is the
/// reader's business.
SnCurve en_1993_1_9_direct(double category);
/// Detail category for shear stress: m = 5 until 1e8, no constant-amplitude limit. Figure 7.2.
SnCurve en_1993_1_9_shear(double category);

/// The sledge-rig thesis' arithmetic, kept for comparison only: it puts the category at 5e6 cycles,
/// d_sigma = d_sigma_C (5e6/N)^(1/5).
SnCurve published_step(double category);

}  // namespace boxbeam
