#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/planar/elastic_joint.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/elastic_joint.hpp"
#include "boxbeam/project/beam_demands.hpp"
#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/lug.hpp"
#include "boxbeam/strength/pin.hpp"

/// What a case asks of what stands beside the beam or is joined to it, and how far it may bend.
namespace boxbeam {

/// A plate that a pin pulls at.
struct LugInput {
  bool inner = true;  ///< else each of both outer ones
  Lug plate;
  Stress yield_strength;
  BeamDetail detail;        ///< with the stress at the hole over that of the net section
  bool own_factor = false;  ///< which the case gives; else it is K_t
};

/// A pin of the mechanism and the plates it bears on.
struct PinInput {
  std::string name;
  int joint = 0;  ///< in space behind those that carry bodies those that close loops
  PinJoint geometry;
  PinStrength strength;
  bool replaceable = false;  ///< in service, whose limits it keeps as well
  std::vector<LugInput> lugs;
  double required = 1.0;
};

/// Plates of a pin that are not given, in words; "" where all are.
inline std::string unknown_plates_of(const PinInput& pin) {
  const auto said = [&](bool inner) {
    return std::any_of(pin.lugs.begin(), pin.lugs.end(),
                       [&](const LugInput& lug) { return lug.inner == inner; });
  };
  if (said(true)) return said(false) ? "" : "outer plates";
  return said(false) ? "inner plate" : "plates";
}

/// A rod between two points of one body, in the plane or in space.
struct PlanarRod {
  planar::Attachment from, to;
};
struct SpatialRod {
  spatial::Attachment from, to;
};

/// A rod without mass: a joint that keeps or drives a distance, or a spring.
struct RodLink {
  bool spring = false;
  /// Among the joints of the plane, in space those that close loops; of a spring among the forces
  /// of the plane, in space the springs.
  std::size_t index = 0;
};

/// A body that is a beam.
struct WholeBody {
  int body = 0;
  spatial::BeamPlacement placement = {};  ///< in space only
};

/// A body in space that is a rod from one of its points to another.
struct RodBody {
  spatial::BeamPlacement placement;
  bool directed = false;  ///< whether the case says where its section's z points
};

/// What is elastic with the verified beam of a mechanism: another beam of the case, a rod by its
/// section, or a joint that has a stiffness.
struct ElasticBeside {
  std::string name;  ///< of the beam's body, the rod or the joint
  std::variant<WholeBody, PlanarRod, RodLink, planar::ElasticJoint, RodBody, spatial::ElasticJoint>
      place;
  TaperedBeam
      beam;  ///< of a rod from end to end, its mass being what its body says; of a joint none
};

/// A rod of the mechanism, looked at under tension and compression.
struct RodInput {
  std::string name;
  std::variant<PlanarRod, SpatialRod, RodLink> place;
  Length length;  ///< between its ends; of one whose length changes that against buckling
  Section section;
  Stress yield_strength;         ///< of its thickest wall
  Stress tensile_strength;       ///< likewise
  std::optional<Area> net_area;  ///< where holes for fasteners weaken it most; nothing: no holes
  Length buckling_length;
  BucklingCurve curve = BucklingCurve::c;
  double gamma_M0 = 1.0, gamma_M1 = 1.0, gamma_M2 = 1.25;
  double required = 1.0;
};

/// A weld around a profile that joins two parts of the beam at a station and carries all that is
/// cut there.
struct WeldInput {
  std::string name;
  Length s;
  Profile around;      ///< the weld follows its outline
  Length throat;       ///< nominal; zero where it penetrates fully
  Length penetration;  ///< beyond that, as tests confirm it: EN 1993-1-8, 4.5.2(3), 4.7.2
  bool full = false;   ///< penetrates fully: as strong as the weaker part, 4.7.1
  Length thickness;    ///< of the thicker part joined, which decides the tensile strength
  BeamDetail root;     ///< across the throat: EN 1993-1-9, row 8.5/3; none of full penetration
  Detail shear;        ///< along it
  BeamDetail toe;      ///< in the profile's walls: row 8.5/1
  double required = 1.0;
};

/// The straight line between the places of two stations, which stay on it.
struct Chord {
  Length from, to;
};

/// The line along the beam as it lies at a station: the place and the turn there are none.
struct Tangent {
  Length at;
};

/// The beam's axis where nothing loads it; of frames at rest, whose motion as a whole is known.
struct UnloadedAxis {};

/// The line from which a deflection is measured.
using MeasuredFrom = std::variant<Chord, Tangent, UnloadedAxis>;

/// How far the beam may bend away from a line.
struct DeflectionInput {
  Length limit;
  MeasuredFrom against;
  std::string measured_from;  ///< "the tangent at s = 0 m, where joint root clamps the beam"
  bool load_factor = false;   ///< whether the situations' load factors multiply it
  Stress youngs_modulus;
  Stress shear_modulus;
};

}  // namespace boxbeam
