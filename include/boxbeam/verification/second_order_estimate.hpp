#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/core/units.hpp"
#include "boxbeam/strength/member_buckling.hpp"

namespace boxbeam {

struct Project;
struct SituationRun;

/// An axial load against the one that buckles, in one plane of bending.
struct BucklingLoad {
  /// Largest N/N_cr over the motion, times the load factor of its situation and the safety factor
  /// that is asked for; zero: nothing is compressed.
  double part = 0.0;
  Time when;  ///< of it
  std::size_t situation = 0;
  std::string held;      ///< how the beam is taken to be held, in words
  bool assumed = false;  ///< neither the case nor the mechanism says so
};

/// How much of the load at which the beam bends sideways and turns over acts.
struct LateralLoad {
  /// Largest M/M_cr over the motion, times the load factor of its situation and the safety factor
  /// that is asked for.
  double part = 0.0;
  Time when;  ///< of it
  std::size_t situation = 0;
  std::string held;  ///< where the beam is taken to be held sideways and against turning, in words
  bool assumed = false;  ///< the case does not say so
};

/// How much more a place of the beam is stressed than the straight beam is, by its stress there.
struct StressGrowth {
  Station station;
  double stress = 0.0;  ///< of the largest, by the loads that are to be borne
  double range = 0.0;   ///< of the largest range, by the loads times one
};

/// What bending under its axial force changes in a beam that was computed as a straight one.
///
/// N_cr is the factor on all forces of an instant at which the tapered beam with its axial force as
/// it is distributed buckles, by the count of negative eigenvalues of K + K_g (`LoadedPosture`).
/// In a planar mechanism that balance determines the beam is held as the mechanism holds it; else,
/// and across the plane, as the restraints of the case say, or where they say nothing by pins at
/// its two outermost joints, which is on the safe side where joints do not give way; in space
/// clamped at the joint that carries its body.
/// Sources: EN 1993-1-1, 5.2.1; Timoshenko, Gere, Theory of Elastic Stability (1961), chapter 2.
struct SecondOrderEstimate {
  BucklingLoad in_plane;
  std::optional<BucklingLoad> across;  ///< nothing where the section has no such plane
  std::optional<LateralLoad> lateral;  ///< nothing where the torsion constant is not known
  /// Of open beams that twist as they buckle (`twisting_load_of`).
  std::optional<BucklingLoad> twisting;
  /// As `difference_between`, of the straight beam from the bent one; nothing where it buckles.
  std::optional<double> change;
  /// Along the beam, none where it buckles; of a model whose cut forces hold the second order of
  /// the loads times one, what the loads that are to be borne add to it.
  std::vector<StressGrowth> growth;
  /// What the sway of the whole that carries the beam adds at least, 1/(alpha_cr - 1); 0: nothing
  /// is known of it. Source: EN 1993-1-1:2005, 5.2.2(5), equation 5.4.
  double sway = 0.0;
  double turn = 0.0;  ///< largest turn of a section by bending [rad]
  /// Times the load factor of its situation and the safety factor that is asked for: the largest
  /// N/(A f_y), and M/(W f_y) in the plane, of the bent beam, of the straight one where it buckles;
  /// and of the straight one in the plane and across it, where N off the centroid and axes that are
  /// not principal ones count as a bow grows. Over all instants where N/N_cr or M/M_cr is above
  /// `no_buckling_below`, and of beams of open thin walls; else at those looked at.
  double compressed = 0.0, bending = 0.0, straight = 0.0, bending_across = 0.0;
  bool whole = false;  ///< the mechanism holds the beam in all of this
};

/// Of the loads of rigid bodies, or of elastic links, at up to 48 instants of every situation, 12
/// where second order reaches nothing, and those of its largest compressions and moments.
SecondOrderEstimate estimate_second_order(const Project& project,
                                          const std::deque<SituationRun>& runs);

/// N/N_cr below which a code lets second order be ignored: EN 1993-1-1, 5.2.1(3).
inline constexpr double first_order_below = 0.1;

/// What second order is estimated to add to the stress, or to its range, at a station, by what it
/// is there: the larger of the places on either side of it and of the sway. Where it buckles:
/// infinite.
double second_order_growth_at(const SecondOrderEstimate& of, Length s, bool of_range);

/// How the beam is taken to be held, wherever this counts and nobody has said so: "across the plane
/// of motion the beam is pinned at s = 0 m and 3 m, by which N/N_cr = 0.2; [[beam.restraints]] ..".
std::vector<std::string> assumed_holds_of(const SecondOrderEstimate& of, bool in_space);

/// "lateral torsional buckling: M/M_cr = 0.012 at most, held ..".
std::string lateral_text(const LateralLoad& of);

/// "second order is estimated to change it by 0.3 %, N/N_cr = 0.012 at most in the plane, 0.004
/// across it".
std::string second_order_text(const SecondOrderEstimate& of);

}  // namespace boxbeam
