#pragma once

#include <map>
#include <string>

#include "boxbeam/report/document.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "json_number.hpp"

namespace boxbeam::report::html {

/// A moving picture as a <figure>: the mechanism as it stands where the beam's bending moment is
/// largest, drawn as it is without script, and the data from which assets/cycle.js moves it.
/// It has no number, so that the figures of all forms of a report have the same.
std::string cycle_figure(const MovingPicture& picture);

/// Whether any of its situations is shown in space by assets/scene.js.
bool has_scene(const MovingPicture& picture);

/// The figure of designs, as data for the page's script.
std::string designs_figure(const DesignTable& table);

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
