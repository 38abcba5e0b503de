#include "boxbeam/mechanism/flexible/start_loads.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"

namespace boxbeam::flexible {

BeamLoads beam_loads_after_start(const Structure& structure, int link, const TaperedBeam& beam,
                                 const SuddenStartModes& modes, double time) {
  const StartNow now = modes.at(time);
  // As a phasor h of the drive, a real quantity r of this time is i r/turn: Im(turn h) = r.
  const Complex as_phasor = Complex(0.0, 1.0) * std::conj(now.turn);
  Response response;
  response.frequency = 0.5 * std::numbers::inv_pi;  // omega = 1: time is the drive's angle
  response.constant = modes.constant();
  response.harmonic.motion = no_loads<Complex>(structure);
  response.harmonic.joints = modes.of_loads().joints;
  LinkColumns<Complex> inertial = no_loads<Complex>(structure);
  for (std::size_t j = 0; j < modes.modes().size(); ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    const Mode& mode = modes.modes()[j];
    const double square = std::pow(full_turn * mode.frequency, 2);
    response.harmonic.joints += (now.x[at] * as_phasor) * mode.shape.joints;
    if (!modes.of_speeds().empty()) {
      response.harmonic.joints += (now.speed[at] * as_phasor) * modes.of_speeds()[j].joints;
    }
    for (std::size_t k = 0; k < inertial.size(); ++k) {
      inertial[k] += (now.x[at] * square * as_phasor) * mode.shape.motion[k];
    }
  }
  return beam_loads_at(beam_response_of(structure, link, beam, response, inertial),
                       std::arg(now.turn));
}

}  // namespace boxbeam::flexible
