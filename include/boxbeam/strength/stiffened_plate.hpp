#pragma once

#include <optional>
#include <vector>

#include "boxbeam/core/units.hpp"
#include "boxbeam/strength/effective_width.hpp"

/// Plates with longitudinal stiffeners in compression: what of them works once subpanels have
/// buckled between the stiffeners, and the stiffeners with the plate. EN 1993-1-5:2006, 4.5 and
/// annex A. E = 210 GPa, nu = 0.3.
namespace boxbeam {

class Derivation;
class Traced;

/// A flat bar along a plate, on one side of it.
struct FlatStiffener {
  Length place;  ///< of its middle, across the plate
  Length depth, thickness;
};

/// Whether a flat does not twist before it yields.
///
///     I_T/I_p >= 5.3 f_y/E,  I_T = d t^3/3,  I_p = d^3 t/3 + d t^3/12
///
/// I_p  about the edge that is welded to the plate
///
/// Such a flat works whole: d/t is at most 13.0 eps, and an outstand is whole up to 13.9 eps.
/// Source: EN 1993-1-5:2006, 9.2.1(8), 9.2.2(1).
bool resists_torsional_buckling(const FlatStiffener& flat, Stress yield_strength);

/// A rectangular plate between supports along its edges and across, in compression along it.
struct StiffenedPlate {
  Length low, high;  ///< ends of its clear width
  Length thickness;
  Stress yield_strength;                       ///< by which it buckles
  std::vector<FlatStiffener> stiffeners = {};  ///< by place, apart from each other
  /// a, between supports across that do not give way; nothing: so long that they do not help.
  std::optional<Length> length = {};
};

/// Stiffness of all stiffeners of a plate together, each with half of the subpanels beside it, over
/// that of the plate: gamma = sum I/(b t^3/10.92).
double relative_stiffness(const StiffenedPlate& plate);

/// Whether stiffeners divide their plate: gamma >= 25. With weaker ones 4.5 holds more at the edges
/// of the plate than it has without them. Source: EN 1993-1-5/NA (Germany) to 4.5, where it is of
/// each stiffener (recalled, not confirmed).
bool are_stiff_enough(const StiffenedPlate& plate);

/// A stiffener with the parts of the plate beside it, as a column that buckles out of the plate.
struct StiffenerColumn {
  Length place;
  Area area;             ///< A_sl,1, gross
  SecondMoment inertia;  ///< I_sl,1, gross
  Area effective;        ///< A_sl,1,eff: less what has buckled in the subpanels
  /// The larger distance of the centroids of plate and stiffener from that of both.
  Length e;
  double stress = 1.0;  ///< in it, over that of the edge that is compressed most: b_sl,1/b_c
};

/// Length of the half-wave in which a column buckles that the plate holds.
///
///     a_c = 4.33 [I_sl,1 b_1^2 b_2^2/(t^3 b)]^(1/4)
///
/// b_1, b_2  from the stiffener to the supports of the plate beside it, b = b_1 + b_2
///
/// Source: EN 1993-1-5:2006, A.2.2(1).
Length held_column_wave(SecondMoment inertia, Length b_1, Length b_2, Length thickness);

/// Critical stress of a column that the plate beside it holds as an elastic foundation.
///
///     a >= a_c: 1.05 E sqrt(I_sl,1 t^3 b)/(A_sl,1 b_1 b_2)
///     a < a_c:  pi^2 E I_sl,1/(A_sl,1 a^2) + E t^3 b a^2/(4 pi^2 (1 - nu^2) A_sl,1 b_1^2 b_2^2)
///
/// Symbols as above. Source: EN 1993-1-5:2006, A.2.2(1), equation A.4.
Stress held_column_stress(Area area, SecondMoment inertia, Length b_1, Length b_2, Length thickness,
                          std::optional<Length> length);

/// Critical stress of a column by itself, pi^2 E I_sl,1/(A_sl,1 a^2).
/// Source: EN 1993-1-5:2006, 4.5.3(3), equation 4.9.
Stress column_stress(Area area, SecondMoment inertia, Length length);

/// Critical stress of a strip of a bare plate, pi^2 E t^2/(12 (1 - nu^2) a^2).
/// Source: EN 1993-1-5:2006, 4.5.3(2), equation 4.8.
Stress plate_column_stress(Length thickness, Length length);

/// Buckling factor of a plate with at least three alike stiffeners at equal distances, smeared.
///
///     alpha <= gamma^(1/4): 2 [(1 + alpha^2)^2 + gamma - 1]/[alpha^2 (psi + 1)(1 + delta)]
///     else:                 4 (1 + sqrt(gamma))/[(psi + 1)(1 + delta)]
///
/// alpha  a/b; nothing where it does not count
/// psi    smaller over larger edge stress
/// gamma  second moment of area of the whole stiffened plate over b t^3/10.92
/// delta  area of the stiffeners over b t
///
/// Valid for psi >= 0.5 and alpha >= 0.5. A smaller psi counts as 0.5: what compresses less nowhere
/// buckles sooner. Of a shorter plate the larger of k at alpha = 0.5 and of k with psi = 1 counts,
/// neither of which is too large. Source: EN 1993-1-5:2006, A.1(2), equation A.2.
double orthotropic_buckling_factor(std::optional<double> alpha, double psi, double gamma,
                                   double delta);

/// Imperfection of a column of a plate and open stiffeners on one side, 0.49 + 0.09 e/i.
/// Source: EN 1993-1-5:2006, 4.5.3(5), equation 4.12.
double column_imperfection(Length e, Length radius_of_gyration);

/// chi_c of a column, EN 1993-1-1, 6.3.1.2, by the imperfection above; 0.21 of a bare plate.
/// Source: EN 1993-1-5:2006, 4.5.3(5).
double column_like_reduction(double lambda_c, double imperfection);

/// Between the buckling of a plate and of a column.
///
///     rho_c = (rho - chi_c) xi (2 - xi) + chi_c,  xi = sigma_cr,p/sigma_cr,c - 1 in 0 .. 1
///
/// Source: EN 1993-1-5:2006, 4.5.4(1), equation 4.13.
double interpolated_reduction(double rho, double chi_c, double xi);

/// Column-like buckling of a bare plate that is short.
struct ShortPlate {
  double chi_c = 1.0, xi = 0.0;
};

/// Effective width of a bare plate between supports across: as `internal_effective_width`, its rho
/// the interpolated one where xi < 1, at yield whatever the level. Source: EN 1993-1-5:2006,
/// 4.4(6), 4.5.4.
std::optional<EffectiveWidth> panel_effective_width(Length width, Length thickness, double psi,
                                                    Stress yield_strength,
                                                    std::optional<Length> length,
                                                    const StressLevel& level = {});

/// What makes the width above less than that of a long plate; nothing where xi is 1.
std::optional<ShortPlate> short_plate_of(Length width, Length thickness, double k_sigma,
                                         Stress yield_strength, std::optional<Length> length);

/// A subpanel between stiffeners and edges.
struct Subpanel {
  Length low, high;
  bool pressed = false;
  double psi = 1.0;
  EffectiveWidth width;  ///< where it is pressed
};

/// A part of a plate and how much of its thickness works.
struct WorkingStrip {
  Length low, high;
  double works = 1.0;
};

/// How sigma_cr,p of a stiffened plate is found.
enum class PlateModel {
  held_column,  ///< A.2: one stiffener, or the worst of one, the other, and both of two as one
  orthotropic,  ///< A.1
  column,       ///< three and more unlike or at unequal distances: the plate counts as no support
};

/// Buckling of a plate with its stiffeners, between supports across.
struct StiffenerBuckling {
  PlateModel model = PlateModel::held_column;
  int compressed = 0;      ///< stiffeners under compression
  StiffenerColumn column;  ///< nearest to the edge that is compressed most
  StiffenerColumn held;    ///< of A.2, the worst one
  Length b_1, b_2;         ///< of that
  double gamma = 0.0, delta = 0.0, k_sigma_p = 0.0;  ///< of A.1
  Area gross, local;  ///< A_c and A_c,eff,loc: of the compressed plate without its held edges
  Stress sigma_cr_p, sigma_cr_c;  ///< at the edge that is compressed most; sigma_cr_c <= sigma_cr_p
  double lambda_p = 0.0, rho = 1.0, lambda_c = 0.0, chi_c = 1.0, xi = 1.0, rho_c = 1.0;
};

/// What is left of a stiffened plate.
struct StiffenedWidths {
  std::vector<WorkingStrip> strips;  ///< all of its clear width, in order
  std::vector<double> stiffeners;    ///< how much of each works, by its place in the plate
  std::vector<Subpanel> subpanels;   ///< from the edge that is compressed most
  StiffenerBuckling buckling;
  double psi = 1.0;  ///< of the whole plate, smaller over larger edge stress

  /// Something does not work.
  bool reduced() const;
};

/// What is left of a stiffened plate under a linear stress across it.
///
/// at_low, at_high  stress at the ends of its clear width, compression positive
///
/// Subpanels lose width by 4.4; what is compressed, but for the parts that the edges hold, is
/// reduced by rho_c all over, stiffeners included: A_c,eff = rho_c A_c,eff,loc + sum b_edge,eff t.
/// In even compression both edges are taken for the one that is compressed most, and the worse
/// counts. Stiffeners in tension do not count but as borders of subpanels. Nothing is returned
/// where no stiffener is compressed: there the plate is a bare one. Source: EN 1993-1-5:2006, 4.5.1
/// to 4.5.4, A.1, A.2.
std::optional<StiffenedWidths> stiffened_widths(const StiffenedPlate& plate, double at_low,
                                                double at_high);

/// rho_c step by step, from the plate on.
Traced derive_stiffened(Derivation& steps, const StiffenedPlate& plate, const StiffenedWidths& of);

}  // namespace boxbeam
