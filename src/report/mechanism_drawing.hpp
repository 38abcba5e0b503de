#pragma once

#include "canvas.hpp"

/// A mechanism's posture as lines and blocks, seen along an axis of the world.
namespace boxbeam::plot {

/// Which coordinates go to the right and up.
struct View {
  int across = 0;
  int up = 1;
};

/// The drawing of a posture.
struct Ink {
  std::string prefix;  ///< of the names of its data
  std::string colour;
  double guide_length = 0.0;  ///< half of what is shown of a slider's line or an axis [m]
};

/// Bodies of one posture as lines and blocks, with rods, guides and bearings: plot commands.
std::vector<std::string> draw_bodies(Script& gp, const PostureFigure& posture, const View& view,
                                     const Ink& ink);

/// The paths of the bodies' points over a cycle as thin lines: plot commands, none where no cycle
/// is known.
std::vector<std::string> draw_traces(Script& gp, const Verification& verification, const View& view,
                                     const std::string& prefix);

/// What labels had better not cross.
void keep_off_bodies(Labels& labels, const Panel& panel, const PostureFigure& posture,
                     const View& view);

/// How loads are drawn.
struct LoadInk {
  double pixels_per_newton = 1.0;
  double least_couple = 0.0;  ///< that is drawn [N m]
  bool with_size = false;     ///< behind the name
};

/// The room that the name of a load takes at most [px].
inline constexpr double longest_load_name = 90.0;

/// What is no couple beside the others, or the rounding of lever arms [N m].
double least_couple_of(const Verification& verification);

/// The loads of a posture with their names: forces as arrows that end where they act, those that
/// the view sees from their tip left out; couples as arrows around that place, with the component
/// about the line of sight.
void draw_loads(Script& gp, Labels& labels, const Panel& panel, const PostureFigure& posture,
                const View& view, const LoadInk& look);

/// The corners of postures [m].
struct Extents {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);

  void take(const Eigen::Vector3d& point);
  void take(const PostureFigure& posture);
  Eigen::Vector3d middle() const { return 0.5 * (low + high); }
  Eigen::Vector3d size() const { return high - low; }
};

/// The corners of all that is drawn of the mechanism: its postures, and its cycle.
Extents extents_of(const Verification& verification);

/// Axes of a drawing to scale, of so many metres per pixel, about a place in the middle.
Panel panel_to_scale(const Frame& frame, double metres_per_pixel, double across, double up);

}  // namespace boxbeam::plot
