#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/point_stress.hpp"
#include "boxbeam/section/shear_flow.hpp"

namespace boxbeam {

/// A section with everything that its stresses follow from.
struct StressField {
  Section section;
  std::vector<Hole> holes;
  Taper taper;
  AreaSums sums;                       ///< net
  std::optional<ShearFlow> flow;       ///< equilibrium flow; nothing for solid sections
  std::optional<ShearFlow> prismatic;  ///< V S/I, as if the section did not change, where it does

  /// As if the section did not change. Precondition: walls.
  const ShearFlow& unchanging() const { return prismatic ? *prismatic : *flow; }
};

/// Whether the flow is found as well that is only shown for comparison.
enum class Prismatic { found, left_out };

StressField stress_field_of(const Section& section, const std::vector<Hole>& holes,
                            const Taper& taper, Prismatic prismatic = Prismatic::found);

/// Whether both halves of a section beside y = 0 are stressed alike in the plane: it mirrors
/// itself, and so do the sections that it tapers to.
bool is_mirrored(const StressField& field);

/// The weld that joins a web of a box and its flange.
struct SeamThroat {
  std::string name;
  StressInfluence influence;  ///< its shear is q/a, a the throat of the whole seam
};

/// Where in a section a place is, as far as it decides what resists there.
enum class SectionPart {
  fibre,    ///< a flange, a corner, a round wall, a stiffener, a wall of a path, a solid
  web,      ///< a web between its ends
  web_end,  ///< where a web meets its flange
};

/// A place in a section whose stress is to be verified.
struct SectionPoint {
  std::string name;
  Length y, z;
  Length plate;               ///< thickness that decides the yield strength
  StressInfluence influence;  ///< shear by equilibrium, taper included
  StressInfluence prismatic;  ///< shear by V S/(I t), for comparison; the same without taper
  std::optional<SeamThroat> throat = std::nullopt;  ///< where a web of a box meets its flange
  SectionPart part = SectionPart::fibre;
  bool neutral = false;  ///< of the outer profile, on the axis where N and M_y leave no bending
  std::optional<WallTorsion> torsion = std::nullopt;  ///< in walls: what its c_T is made of
};

/// Which places of a section are looked at.
enum class PointSet {
  in_plane,  ///< those that can govern under N, V_z and M_y in a section symmetric about z
  all,       ///< those that can govern under N, V_z and M_y in any section
  in_space   ///< those that can govern under all six cut forces, beside the stretches of the walls
};

/// The named places of a section. In plane: "fibre +z", "fibre -z", of boxes and rectangular tubes
/// "web end +z", "web end -z", "neutral axis", and "inner fibre +z", "inner web end -z" .. of an
/// inner profile. All: besides them corners, webs on both sides and flanges beside them ("web end
/// +y +z"), faces of the webs ("fibre +y"), every 45 degrees of a round tube, ends, middle and
/// neutral axis of every wall of a path on both faces, every corner of a polygon. Sections that are
/// not symmetric about z, or taper to such, always give all in the plane. A place in a hole is left
/// out.
///
/// In space: of boxes and rectangular tubes the corners, the middles of the four faces and the ends
/// of the webs on their outer faces ("corner +y +z", "fibre +y", "web end +y -z"), edges of
/// stiffeners, of plates and polygons all; between them, and all of round tubes and paths, see
/// wall_stretches_of.
///
/// The shear of a wall is q/t, on the outer face of a cell or, in an open wall, on the face named,
/// with t/I_T per torque. Solid sections have a mean over a level,
///
///     tau = dF/dx/b,  F the force of the part beyond z; V S/(I b) without taper
///
/// Plates know V_y likewise, and T by the exact series in the middles of the sides. Of polygons V_y
/// and T are not known: their factors are NaN. Source: Jourawski (1856); Timoshenko and Goodier,
/// article 109.
std::vector<SectionPoint> points_of(const StressField& field, PointSet set);

/// The material at a level: of a web, wall to wall (both webs where they may differ), in a flange
/// the mean over its width. Nothing where the level lies in a hole. In space: both sides, on the
/// outer face, of a flange its middle and its edges, of a path every wall on both faces.
std::vector<SectionPoint> points_at_level(const StressField& field, const std::string& name,
                                          Length z, PointSet set);

/// A place on the outer face of a flange of a box or rectangular tube; `up` is +1 for the top, -1
/// for the bottom. Shear as in the wall between the webs.
SectionPoint point_on_flange(const StressField& field, const std::string& name, Length y,
                             double up);

/// A place in or on a plate or polygon: shear of the mean over its level, of plates on their faces
/// V_y and T as well.
SectionPoint point_in_solid(const StressField& field, const std::string& name, double y, double z);

/// Why the shear of V_y or T is not known in a section, or nothing.
std::optional<std::string> unknown_shear_of(const Section& section);

}  // namespace boxbeam
