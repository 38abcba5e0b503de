#include "boxbeam/mechanism/flexible/start_loads.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/core/angle.hpp"

namespace boxbeam::flexible {

StartLoads::StartLoads(const Structure& structure, int link, const TaperedBeam& beam,
                       SuddenStartModes modes)
    : modes_(std::move(modes)) {
  Response response;
  response.frequency = 0.5 * std::numbers::inv_pi;  // omega = 1: time is the drive's angle
  response.constant = modes_.constant();
  response.harmonic.motion = no_loads<Complex>(structure);
  const LinkColumns<Complex> at_rest = no_loads<Complex>(structure);
  const auto by = [&](const Eigen::Matrix3Xcd& joints, const LinkColumns<Complex>& inertial) {
    response.harmonic.joints = joints;
    return beam_response_of(structure, link, beam, response, inertial);
  };
  const Eigen::Matrix3Xcd& of_loads = modes_.of_loads().joints;
  driven_ = by(of_loads, at_rest);
  // The loads' own amplitudes stand in every response: they are the drive's alone.
  const BeamLoads amplitudes = by(Eigen::Matrix3Xcd::Zero(3, of_loads.cols()), at_rest).sine;
  const auto beside = [&](const BeamResponse& of) {
    BeamLoads loads = of.sine;
    add(loads, -1.0, amplitudes);
    return loads;
  };
  for (const Mode& mode : modes_.modes()) {
    const double square = std::pow(full_turn * mode.frequency, 2);
    LinkColumns<Complex> inertial = at_rest;
    for (std::size_t k = 0; k < inertial.size(); ++k) inertial[k] = square * mode.shape.motion[k];
    of_modes_.push_back(beside(by(mode.shape.joints, inertial)));
  }
  for (const Deformation<double>& of : modes_.of_speeds())
    of_speeds_.push_back(beside(by(of.joints, at_rest)));
}

BeamLoads StartLoads::at(double time) const {
  const StartNow now = modes_.at(time);
  BeamLoads loads = beam_loads_at(driven_, std::arg(now.turn));
  for (std::size_t j = 0; j < of_modes_.size(); ++j)
    add(loads, now.x[static_cast<Eigen::Index>(j)], of_modes_[j]);
  for (std::size_t j = 0; j < of_speeds_.size(); ++j)
    add(loads, now.speed[static_cast<Eigen::Index>(j)], of_speeds_[j]);
  return loads;
}

}  // namespace boxbeam::flexible
