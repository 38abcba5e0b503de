#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/detail.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/hole_concentration.hpp"

/// What a case asks of the beam itself.
namespace boxbeam {

/// A point of a section that the user wants to see, at a station (both sides of it).
struct NamedPoint {
  std::string name;
  Length s;
  Length z;
};

/// Where in a section a detail is.
enum class DetailPlace {
  section,  ///< anywhere
  fibres,   ///< flanges, corners, round walls, stiffeners, walls of paths, solid sections
  webs,     ///< webs between their ends
  seams,    ///< where webs and flanges meet
};

/// A detail on a stretch of the beam.
struct BeamDetail {
  Length from, to;
  DetailPlace on = DetailPlace::section;
  Detail detail;
  /// The stress of the detail over the nominal one of the section: k_f of EN 1993-1-9 6.3, the
  /// structural stress of annex B, the stress in a throat by t/a.
  double stress_factor = 1.0;
  std::string assumed;  ///< why it is taken so, where nobody classified it
};

/// The line of a flat along a plate of a box.
struct FlatLine {
  std::string name;  ///< "stiffener 1 weld", "stiffener 1 end", as a point of the section
  BoxPlate plate = BoxPlate::top_flange;
  Length from, to;  ///< where on the plate it stands, at both ends of the stretch
};

/// A weld of what is attached to the beam: it is looked at beside the details that the case has
/// there, not in their place.
struct AttachmentWeld {
  BeamDetail detail;
  std::optional<FlatLine> flat;  ///< nothing: around the section, of a diaphragm
};

/// What resists a range: the detail's curve with its size effect.
SnCurve curve_of(const Detail& detail);

/// The two ways of EN 1993-1-5 to judge plates that buckle, which are never mixed in one section.
enum class PlateRoute {
  effective_widths,  ///< clauses 4 to 7: what buckles sheds its load to what does not
  reduced_stresses,  ///< clause 10: gross section, each plate by itself
};

struct StrengthDemand {
  double gamma_M0 = 1.0;
  double gamma_M1 = 1.0;   ///< of plates and members that buckle
  double gamma_M2 = 1.25;  ///< of welds and pins
  WidthRule effective_widths = WidthRule::at_yield;
  /// Equivalent uniform moment factors of members, EN 1993-1-1, table B.3; 1 on the safe side.
  double C_my = 1.0, C_mz = 1.0;
  bool shear_lag = true;  ///< whether wide flanges are reduced, EN 1993-1-5 3.2
  PlateRoute plates = PlateRoute::effective_widths;  ///< steep segments by reduced stresses anyway
  double required = 1.0;
};

struct FatigueInput {
  /// Whether the case asks for fatigue at all; without [fatigue] the rest means nothing and no
  /// situation has cycles.
  bool asked = true;
  BeamDetail beam;  ///< of the whole beam, unless one of the details says otherwise
  /// Plates under shear stress, and the throats of seams, anywhere on the beam.
  Detail shear, throat;
  /// Plates of boxes bent across, in their corners.
  Detail corner;
  /// The thesis' arithmetic instead of the standard's curve, for comparison only.
  bool published_step = false;
  /// Fatigue strengths are rounded to a multiple of this where given (published arithmetic).
  std::optional<Stress> round_strength_to;
  FatigueDemand demand;
  std::string gamma_Mf_source;  ///< "safe life, high consequence" where table 3.1 gave it
  double required = 1.0;
  std::vector<BeamDetail> details;
  std::vector<AttachmentWeld> attachments;  ///< of its diaphragms and flats
  std::vector<std::string> codes;           ///< families of curves to be shown beside
};

/// A hole of the beam and how the stress at it is verified. Its material is missing from the stress
/// section through its centre only; the mass of the beam is taken without holes.
struct BeamHole {
  Length s;
  Hole hole;
  /// Which problem its concentration is; none where its detail is one for the net section.
  std::optional<HoleCase> concentration;
  std::optional<BeamDetail> detail;  ///< of its own; none: that of the beam
};

/// What holds the beam at a station, as the case says it: of each way that it is held in anywhere
/// the case says all, in place of what the program would take from the mechanism.
struct Restraint {
  Length s;
  bool along_y = false, along_z = false;  ///< its axis stays there
  bool turning = false;                   ///< and it does not turn about it
  bool clamped = false;                   ///< along y and z it keeps its direction, too
};

}  // namespace boxbeam
