#pragma once

#include <functional>

#include "canvas.hpp"

/// A mechanism's posture as lines and blocks: in figures, and in the page where it moves.
namespace boxbeam::plot {

/// What goes to the right and up of a drawing, by rows: unit vectors of the world.
using View = Eigen::Matrix<double, 2, 3>;

/// The view along one axis of the world: which coordinates go to the right and up.
View flat_view(int across, int up);

/// The world on a drawing.
struct Projection {
  View view;
  Panel panel;  ///< of what is seen [m]

  Pixel at(const Eigen::Vector3d& place) const;
  /// Towards the viewer: couples about it turn counter-clockwise.
  Eigen::Vector3d normal() const;
};

/// Every place of a posture that its drawing must hold.
void each_place(const PostureFigure& posture,
                const std::function<void(const Eigen::Vector3d&)>& take);

/// Bodies of one posture as lines and blocks, with rods, guides and bearings, the beam in front;
/// of guides and axes so much is shown at either side [px]. The first line of the beam is its axis.
void draw_bodies(Drawing& drawing, const PostureFigure& posture, const Projection& projection,
                 const std::string& colour, double guide);

/// The paths of the bodies' points over a cycle as thin lines; none where no cycle is known.
void draw_traces(Drawing& drawing, const Verification& verification, const Projection& projection);

/// What labels had better not cross.
void keep_off_bodies(Labels& labels, const PostureFigure& posture, const Projection& projection);

/// How loads are drawn.
struct LoadInk {
  double pixels_per_newton = 1.0;
  double least_couple = 0.0;  ///< that is drawn [N m]
  bool with_size = false;     ///< behind the name
};

/// The name of a load, or where it acts.
std::string name_of(const BeamLoadRow& load);

/// The loads of a posture with their names: forces as arrows that end where they act, those that
/// the view sees from their tip left out; couples as arrows around that place.
void draw_loads(Drawing& drawing, Labels& labels, const PostureFigure& posture,
                const Projection& projection, const LoadInk& look);

/// What must find room in a view: bodies, and arrows with words at their tails.
class Room {
 public:
  explicit Room(const View& view) : view_(view) {}
  void take(const Eigen::Vector3d& place);
  void take(const PostureFigure& posture);
  void take_loads(const PostureFigure& posture, const LoadInk& look);

  Eigen::Vector2d size() const { return high_ - low_; }  ///< of the bodies [m]
  /// The corners at a scale [px], from the origin of the world.
  Frame at(double metres_per_pixel) const;

 private:
  struct Arrow {
    Eigen::Vector2d tip;   ///< [m]
    Eigen::Vector2d back;  ///< from there to its tail [px]
    double left, right;    ///< that its words take beside the tail [px]
  };
  View view_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high_ = Eigen::Vector2d::Constant(-1e300);
  std::vector<Arrow> arrows_;
};

/// The finest scale [m/px] at which something fits, which at a coarse one does; size is that of
/// the mechanism [m].
double finest_scale(double size, const std::function<bool(double metres_per_pixel)>& fits);

/// The largest of forces, and what is no couple beside the others or the rounding of lever arms.
class LoadSizes {
 public:
  void take(const PostureFigure& posture);
  double force() const { return force_; }  ///< [N]
  double least_couple(double size) const;  ///< [N m], of a mechanism so large [m]

 private:
  double force_ = 1e-9;
  double couple_ = 0.0;
};
LoadSizes load_sizes_of(const Verification& verification);

/// What the postures that are drawn, and those of the cycle, take in a view, without loads.
Room room_of(const Verification& verification, const View& view);

/// Axes of a drawing to scale about a place in the middle.
Panel panel_to_scale(const Frame& frame, double metres_per_pixel, const Eigen::Vector2d& middle);

}  // namespace boxbeam::plot
