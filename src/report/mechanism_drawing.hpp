#pragma once

#include "plot_script.hpp"

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

/// Bodies of one posture as lines and blocks, with rods, guides and bearings; returns the plot
/// commands.
std::string draw_bodies(Script& gp, const PostureFigure& posture, const View& view, const Ink& ink);

/// The loads of a posture as arrows that end where they act, with their names, and with their sizes
/// where asked for; those that the view sees from their tip are left out.
void draw_loads(Script& gp, const PostureFigure& posture, const View& view,
                double metres_per_newton, bool with_size);

/// The corners of all postures [m].
struct Extent {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);
};

Extent extent_of(const std::vector<PostureFigure>& postures);

}  // namespace boxbeam::plot
