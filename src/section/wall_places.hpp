#pragma once

#include <string>

#include "boxbeam/section/section_points.hpp"

/// Places on the walls of a section, shared by its named points and its stretches of wall.
namespace boxbeam::wall_places {

/// A place on a wall.
struct WallPlace {
  std::size_t wall = 0;
  double fraction = 0.0;
};

bool is_web(const Wall& wall);
bool has_webs(const Profile& profile);

void set_shear(StressInfluence& influence, const CutFactors& factors);

/// Shear stress on a face of a wall: 1 the right, -1 the left, 0 the outer one of a cell.
CutFactors wall_shear(const ShearFlow& flow, const WallPlace& place, double face);

/// A place of material without shear.
SectionPoint point_at(const StressField& field, const std::string& name, double y, double z,
                      Length plate);

/// Shear from the wall, normal stress at (y, z), which may be the face of the wall.
SectionPoint wall_point(const StressField& field, const std::string& name, const WallPlace& place,
                        double y, double z, double face, Length plate);

/// The place on walls of a part, of material if there is any, nearest to a coordinate along them: z
/// on webs, y on flanges. Walls run along their axis in ascending order.
WallPlace nearest(const WallGraph& graph, WallPart part, bool inner, double along);

/// The place of a round tube at an angle from +y towards +z.
WallPlace on_round(const WallGraph& graph, bool inner, double angle);

/// The outer face of a wall of a box or rectangular tube: y of a web, z of a flange.
double outer_face_of(const Wall& wall);

/// "+y", "-z".
std::string signed_axis(double sign, char axis);

}  // namespace boxbeam::wall_places
