#include "boxbeam/mechanism/flexible/start_loads.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/core/angle.hpp"

namespace boxbeam::flexible {
namespace {

/// Calls `visit` with every number of loads that act in the plane of a mechanism: along x and z of
/// the beam, and about y.
template <class Loads, class Visit>
void each_in_plane(Loads& loads, const Visit& visit) {
  for (auto& point : loads.points) {
    visit(point.force.x());
    visit(point.force.z());
    visit(point.moment.y());
  }
  for (auto& line : loads.lines) {
    for (const std::size_t axis : {0U, 2U})
      for (auto& coefficient : line.force[axis].c) visit(coefficient);
    for (auto& coefficient : line.couple[1].c) visit(coefficient);
  }
}

Eigen::VectorXd numbers_in_plane(const BeamLoads& loads) {
  std::vector<double> numbers;
  each_in_plane(loads, [&](double number) { numbers.push_back(number); });
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

StartLoads::StartLoads(const Structure& structure, int link, const TaperedBeam& beam,
                       SuddenStartModes modes)
    : modes_(std::move(modes)) {
  Response response;
  response.frequency = 0.5 * std::numbers::inv_pi;  // omega = 1: time is the drive's angle
  response.constant = modes_.constant();
  response.harmonic.motion = no_loads<Complex>(structure);
  const Vibration at_rest{no_loads<Complex>(structure)};
  const auto by = [&](const Eigen::Matrix3Xcd& joints, const Vibration& inertial) {
    response.harmonic.joints = joints;
    return beam_response_of(structure, link, beam, response, inertial);
  };
  const Eigen::Matrix3Xcd& of_loads = modes_.of_loads().joints;
  driven_ = by(of_loads, at_rest);
  // The loads' own amplitudes stand in every response: they are the drive's alone.
  const Eigen::VectorXd amplitudes =
      numbers_in_plane(by(Eigen::Matrix3Xcd::Zero(3, of_loads.cols()), at_rest).sine);
  const auto add_column = [&](const BeamResponse& of, Eigen::MatrixXd& columns) {
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols<1>() = numbers_in_plane(of.sine) - amplitudes;
  };
  of_modes_.resize(amplitudes.size(), 0);
  of_speeds_.resize(amplitudes.size(), 0);
  for (const Mode& mode : modes_.modes()) {
    Vibration inertial = at_rest;
    inertial.square = std::pow(full_turn * mode.frequency, 2);
    for (std::size_t k = 0; k < inertial.motion.size(); ++k)
      inertial.motion[k] = mode.shape.motion[k];
    add_column(by(mode.shape.joints, inertial), of_modes_);
  }
  for (const Deformation<double>& of : modes_.of_speeds())
    add_column(by(of.joints, at_rest), of_speeds_);
}

BeamLoads StartLoads::at(double time) const {
  const StartNow now = modes_.at(time);
  BeamLoads loads = beam_loads_at(driven_, std::arg(now.turn));
  Eigen::VectorXd added = Eigen::VectorXd::Zero(of_modes_.rows());
  for (Eigen::Index j = 0; j < of_modes_.cols(); ++j) added += now.x[j] * of_modes_.col(j);
  for (Eigen::Index j = 0; j < of_speeds_.cols(); ++j) added += now.speed[j] * of_speeds_.col(j);
  const double* next = added.data();
  each_in_plane(loads, [&](double& number) { number += *next++; });
  return loads;
}

}  // namespace boxbeam::flexible
