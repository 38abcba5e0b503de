#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "stopped_vibration.hpp"

namespace boxbeam {

/// Largest part of a mode's elastic energy, in words: "bending about y", "bending about z",
/// "torsion", "stretching", "springs and joints beside the beam", "other beams and rods".
std::string shape_of(const frame::BeamMode& mode);

/// The part of a mode's elastic energy that is in beams.
double strained_part_of(const frame::BeamMode& mode);

/// `estimate_vibration` of a beam in space: the modes of its stopped mechanism, stresses of N, M_y
/// and M_z at the corners of the sections' extent and sqrt(3) times that of T in walls of even
/// thickness, T/sqrt(I_T A) of closed profiles, of others T sqrt(3/(I_T A)).
struct VibrationInSpace {
  VibrationEstimate estimate;
  std::string obstacle;  ///< why there is none; "" where there is
  Time lowest_at;        ///< when the first frequency is lowest
  std::string shape;     ///< of the first mode then
};

/// What makes these stresses of the cut forces of a place.
struct PlaceInSpace {
  Station station;
  double per_N, per_M_y, per_M_z, per_T;
};
inline constexpr Eigen::Index stresses_of_place = 5;

/// `joints`: as of `compared_places_of`.
std::vector<PlaceInSpace> places_in_space(const TaperedBeam& beam,
                                          const std::vector<Length>& joints = {});

/// These stresses of one place after the other.
Eigen::RowVectorXd stresses_at(const CutForceDiagram& diagram,
                               const std::vector<PlaceInSpace>& places);

/// These stresses along a beam at the even instants of its loads, a row for each.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam);
/// The same at the even instants of another time.
Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam,
                                        const LoadSpan& span);

/// What modes do beside the loads of a history, relative to the largest of these stresses or of
/// their ranges, with none, one, ... of them counted, and the harmonics of what repeats; nothing
/// of a beam without stress.
struct MissedInSpace {
  std::vector<double> without_modes;
  std::vector<LoadHarmonic> harmonics;
};
/// `parts`: of each mode beyond its static one over time (`dynamic_part`), a column each.
MissedInSpace missed_in_space(const LoadHistory& history, const TaperedBeam& beam,
                              const std::vector<frame::BeamMode>& modes,
                              const Eigen::MatrixXd& parts);

/// The largest of these stresses that a unit of each mode makes.
Eigen::VectorXd largest_stresses_in_space(const std::vector<frame::BeamMode>& modes,
                                          const TaperedBeam& beam);

/// Why nothing is estimated in any of the situations that run; "" where the motion lets it.
std::string obstacle_to_vibration_in_space(const std::deque<SituationRun>& rigid);

/// What rigid bodies, or loads on a frame that act slowly, were estimated to miss by vibration, of
/// the governing stress, without second order where the model weighs it; zero where that was not
/// estimated, and of mechanisms in the plane, where it decides on the model.
double vibration_missed_in_space(const Project& project, const ModelChoice& model);

/// At instants evenly spread over a run and about the lowest first frequency. Of loads whose edges
/// are steeper than the instants the frequencies alone. `bends_known`: whether what springs take
/// over from a beam that bends statically is part of what the second order adds; else it is of
/// this.
VibrationInSpace estimate_vibration_in_space(const Project& project, const SituationRun& run,
                                             int parts = 8, bool bends_known = true);

}  // namespace boxbeam
