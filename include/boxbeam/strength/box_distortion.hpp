#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "boxbeam/core/units.hpp"
#include "boxbeam/section/section.hpp"

/// Distortion of boxes: a rectangular cell that is racked to a parallelogram between diaphragms.
///
/// Let gamma be the change of the right angle between webs and flanges. The cell resists it as a
/// frame of its plates, which bend across, and along the beam by bending and shear of every plate
/// in its own plane: a beam on an elastic foundation,
///
///     k gamma - Q' = d,  Q = b h (M_D/(b h))' = S (gamma' - theta)
///     M_D = -E I_w/4 (b h theta)'/(b h),  lambda = (k/(E I_w))^(1/4)
///
/// with I_w the integral of the warping omega squared, omega = y z made orthogonal to 1, y and z.
/// Of forces in the planes of the plates the work is d gamma: with u_z = y gamma/2 of the webs and
/// u_y = z gamma/2 of the flanges, a couple T_w of two web forces and a couple T_f of two flange
/// forces (torques about x) do
///
///     d = (T_w - T_f)/2
///
/// so that a torque T distorts by T/2 where it comes by webs only, by -T/2 where by flanges only,
/// and not at all as Bredt's flow, in which T_w = T_f. Plates bend across only around the cell.
/// Where it tapers, edges stretch by (b h theta)'/(b h), for they bend with both their plates while
/// the section twists freely by phi' = (h'/h - b'/b) gamma/2; a torque T does work on that, and so
/// distorts by d = T/2 (h'/h - b'/b) per length. Left out: that shear of distortion and of torsion
/// are coupled where b t_w and h t_f are unlike.
/// Sources: Vlasov, Thin-Walled Elastic Beams (1961), chapter IV; Wright, Abdel-Samad, Robinson,
/// BEF analogy for analysis of box girders, J. Struct. Div. ASCE 94 (1968), both recalled; here
/// derived.
namespace boxbeam {

/// A rectangular cell by the mid-lines of its four plates.
struct BoxCell {
  Length width, height;             ///< between the mid-lines of webs, of flanges
  std::array<Length, 4> thickness;  ///< by BoxPlate
};

/// The cell of a box, without its stiffeners, of a rectangular tube, its corners taken as sharp, or
/// of a thin-walled path around one rectangle along y and z, each of whose four plates is of one
/// thickness, without what ends freely within it or leads a plate on; nothing of other profiles.
std::optional<BoxCell> box_cell_of(const Profile& profile);

/// Corners of a cell in the order in which its values stand, one behind the other around it.
enum class CellCorner { top_left, bottom_left, bottom_right, top_right };

/// What a cell resists distortion with, per length of the beam.
struct CellDistortion {
  double warping_inertia = 0.0;            ///< I_w [m^6]
  std::array<double, 4> warping{};         ///< omega at the corners, by CellCorner [m^2]
  double frame_stiffness = 0.0;            ///< k [N m/m per rad]
  std::array<double, 4> corner_moments{};  ///< at the corners, of gamma = 1 [N m/m]

  double decay = 0.0;            ///< lambda [1/m]
  double shear_stiffness = 0.0;  ///< S [N m^2]
  /// Shear flow of Q = 1 at the corners, on the plate that begins there [1/m^2].
  std::array<double, 4> flow{};
};

/// A place on a plate of a cell: plate k leads from corner k to the next one, its part from 0 to 1,
/// beyond that where the plate of a path leads on.
struct CellPlace {
  std::size_t plate = 0;
  double part = 0.0;
};

/// Where in its cell a place of a box or rectangular tube lies: on one plate, in a corner on both
/// that meet there, and on none inside or in other profiles. A rounded corner is all corner.
std::vector<CellPlace> places_in_cell(const Profile& profile, Length y, Length z);

/// What distortion does at a place, by size where its sign changes from face to face.
struct DistortionInfluence {
  double along = 0.0;   ///< stress along the beam of M_D = 1, 2 omega/I_w [1/m^4]
  double moment = 0.0;  ///< that bends the plate across, of gamma = 1 [N m/m]
  double across = 0.0;  ///< its stress, 6 m/t^2 [Pa]
  double flow = 0.0;    ///< shear flow of Q = 1 [1/m^2]
  double shear = 0.0;   ///< its stress, q/t [1/m^3]
  Length thickness;     ///< t

  /// The same in a weld that is as thick as this, which no stress along it counts in.
  DistortionInfluence in_throat(Length throat) const;
};

/// What distorts a place at most, by size.
struct DistortionSize {
  double angle = 0.0;   ///< gamma [rad]
  double moment = 0.0;  ///< M_D [N m^2]
  double shear = 0.0;   ///< Q [N m]
};

/// How far it comes over a history that repeats: from lowest to highest, and the sum of all by
/// which it rises.
struct DistortionTravel {
  DistortionSize range, rise;
};

/// Equivalent stress of a plate that is stretched along the beam and bent across it: on one of its
/// faces both stresses have unlike signs.
///
///     sigma_v = sqrt(sigma_x^2 + sigma_t^2 + |sigma_x sigma_t| + 3 tau^2)
///
/// Sizes of all. Source: EN 1993-1-1:2005, 6.2.1(5), equation 6.1.
template <class Value>
Value bent_across_stress(const Value& sigma_x, const Value& sigma_t, const Value& tau) {
  using std::sqrt;
  return sqrt(sigma_x * sigma_x + sigma_t * sigma_t + sigma_x * sigma_t + 3.0 * tau * tau);
}

/// The same in the throat of a weld, whose plane the moment across bends: sigma_perp = sigma_t.
///
///     sigma_v = sqrt(sigma_t^2 + 3 tau_par^2)
///
/// Source: EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1.
template <class Value>
Value bent_throat_stress(const Value& sigma_t, const Value& tau_par) {
  using std::sqrt;
  return sqrt(sigma_t * sigma_t + 3.0 * tau_par * tau_par);
}

/// Of four plates of any thickness: the frame by slope and deflection, plates of stiffness
///
///     D = E t^3/(12 (1 - nu^2)),   M_ij = 2 D/L (2 theta_i + theta_j - 3 psi)
///
/// with psi = gamma of the webs and 0 of the flanges. Of equal webs and equal flanges
/// k = 24/(h/D_w + b/D_f), the corner moment k/4 and I_w = b^2 h^2 (b t_f + h t_w)/24. S by the
/// energy of the shear flow that balances the warping stresses and has no torque. E [Pa].
CellDistortion cell_distortion_of(const BoxCell& cell, double E, double nu);

/// Warping stresses and the moments across are linear along a plate, the shear flow a parabola.
DistortionInfluence distortion_at(const BoxCell& cell, const CellDistortion& of,
                                  const CellPlace& place);

/// Of a plate across the cell, in shear in its plane [N m/rad]:
///
///     K = G t b h
///
/// with an opening (its width, taken as a square in the middle) the frame of the four strips around
/// it, which bend and shear, is taken instead: less than what they are with their corners, on the
/// safe side; 0 where the opening leaves nothing.
double diaphragm_stiffness(const BoxCell& cell, Length thickness, Length opening, double E,
                           double nu);

/// A box beam in elements from end to end. Values of elements stand at their Gauss points.
struct DistortedBeam {
  static constexpr std::size_t gauss_points = 4;
  using AtGauss = std::array<double, gauss_points>;

  std::vector<double> nodes;               ///< ascending [m]
  std::vector<AtGauss> warping_stiffness;  ///< E I_w/4 [N m^4]
  std::vector<AtGauss> shear_stiffness;    ///< S [N m^2]
  std::vector<AtGauss> frame_stiffness;    ///< k [N]
  std::vector<AtGauss> taper;              ///< (b h)'/(b h) [1/m]
  std::vector<AtGauss> of_torque;          ///< d per length of a torque of 1 there [1/m]
  /// Of each node, what a diaphragm there resists gamma with [N m/rad]; infinite: a rigid one.
  std::vector<double> diaphragms;
  /// Whether nothing warps at the ends, too; else they warp freely, with a diaphragm or without.
  bool start_held = false, end_held = false;

  /// Where the Gauss points of an element stand [m].
  AtGauss places(std::size_t element) const;
  /// The node nearest to a place.
  std::size_t nearest(double s) const;
};

/// A beam without diaphragms whose nodes stand at the places, ascending, and between them at most
/// `part` of 1/lambda apart; the cell changes evenly between neighbouring places. With 1/16 its
/// moments are exact to 2e-4 of the largest.
DistortedBeam distorted_beam(const std::vector<double>& places,
                             const std::function<BoxCell(double)>& cell_at, double E, double nu,
                             double part = 0.0625);

/// The distortion of a beam at its nodes.
struct Distortion {
  std::vector<double> angle;   ///< gamma [rad]
  std::vector<double> moment;  ///< M_D [N m^2]
  std::vector<double> held;    ///< what the diaphragms take of d [N m]
  /// Q at both ends of each element [N m].
  std::vector<std::array<double, 2>> shear;

  /// Stress along the beam at a corner, 2 M_D omega/I_w [Pa], tension positive.
  double warping_stress(std::size_t node, const CellDistortion& cell, CellCorner corner) const;
  /// Stress across the plate that is bent most at a corner, 6 m/t^2 of the thinner of the two that
  /// meet there [Pa], not negative.
  double frame_stress(std::size_t node, const CellDistortion& cell, const BoxCell& of,
                      CellCorner corner) const;
};

/// Solves a beam by elements that bend and shear, once for any number of loads.
class DistortionSolver {
 public:
  explicit DistortionSolver(DistortedBeam beam);

  /// `loads`: d at each node [N m]; `lines`: d per length at the Gauss points of each element [N],
  /// or none. A beam that nothing keeps in shape does not exist: k is above zero.
  Distortion solve(const std::vector<double>& loads,
                   const std::vector<DistortedBeam::AtGauss>& lines = {}) const;

  const DistortedBeam& beam() const { return beam_; }

 private:
  bool is_rigid(std::size_t node) const;
  Eigen::Vector4d line_load(std::size_t element, const DistortedBeam::AtGauss& line) const;

  DistortedBeam beam_;
  std::vector<Eigen::Matrix4d> elements_;
  std::vector<Eigen::Matrix2d> pivots_;  ///< inverse
  std::vector<Eigen::Matrix2d> beside_;  ///< from each node to the next
};

}  // namespace boxbeam
