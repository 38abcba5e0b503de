#pragma once

#include <map>
#include <string>

#include "boxbeam/verification/cycle_figure.hpp"
#include "json_number.hpp"

namespace boxbeam::report::html {

/// Beams by their surfaces, each once, whatever situations show it.
class BeamShapes {
 public:
  /// Its number among them.
  std::size_t number_of(const TaperedBeam& beam, double unit);
  const Json& all() const { return all_; }

 private:
  Json all_ = Json::array();
  std::map<std::string, std::size_t> known_;
};

/// The scene of a situation in space, as assets/scene.js shows it: places in multiples of `unit`, a
/// power of ten below 1e-4 of the scene's size; the motion of each body by keys, a thousandth of
/// the size astray at most (pose_track.hpp); `forces` on the beam for each frame of the figure, as
/// its posture names them, the critical one last. Null where the situation has none.
Json scene_data(const CycleFigure& cycle, BeamShapes& shapes);

}  // namespace boxbeam::report::html
