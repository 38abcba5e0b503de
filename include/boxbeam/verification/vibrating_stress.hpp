#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/verification/load_history.hpp"

namespace boxbeam {

/// A place of a beam at which models are compared, with what makes stress of cut forces.
struct ComparedPlace {
  Station station;
  double per_N = 0.0;  ///< 1/A [1/m^2]
  double per_M = 0.0;  ///< 1/W_y [1/m^3]
};

/// Both sides of all named places, joints and ends of segments, and places between, about 32.
std::vector<ComparedPlace> compared_places_of(const TaperedBeam& beam,
                                              const std::vector<Length>& joints = {});

/// N/A + M/W and N/A - M/W at every place: nominal stress of the two outer fibres [Pa].
Eigen::ArrayXd fibre_stresses(const CutForceDiagram& diagram,
                              const std::vector<ComparedPlace>& places);

/// Stresses of the places at all instants, a row for each instant.
Eigen::MatrixXd stress_history(const LoadHistory& history,
                               const std::vector<ComparedPlace>& places);

/// Over the rows, of the column in which it is largest; zero where it is round-off of the stresses.
double largest_range(const Eigen::MatrixXd& stresses);

/// What is left out with none, one, ... and all of some modes counted: the largest stress of the
/// others together, by `peak`, or its largest range, by `range`, whichever is more; 1e6 at most.
/// Exact: only places where the others, each at its largest, stay below what is found are passed
/// over.
/// `parts`: of each mode over time, a column each; `stresses`: of a unit of each at the places, a
/// row each [Pa]; `peak`, `range`: of the whole stress [Pa]. A range of zero is not looked at.
std::vector<double> missed_without(const Eigen::MatrixXd& parts, const Eigen::MatrixXd& stresses,
                                   double peak, double range);

/// Nominal stress of a vibrating beam, place by place.
struct VibratingStress {
  Eigen::ArrayXd constant;   ///< [Pa]
  Eigen::ArrayXcd harmonic;  ///< phasor [Pa]

  double peak() const;       ///< largest over places and time [Pa]
  double amplitude() const;  ///< half the largest range [Pa]
};

VibratingStress vibrating_stress_of(const flexible::BeamResponse& response,
                                    const std::vector<ComparedPlace>& places);

/// How far one model's stresses are from another's: the largest difference over places and time,
/// of the whole stress by the largest stress, of its vibrating part by the largest amplitude; the
/// larger of the two counts. It bounds the error of the governing stress and that of its range.
double difference_between(const VibratingStress& model, const VibratingStress& better);

}  // namespace boxbeam
