#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/numerics/polynomial.hpp"
#include "boxbeam/section/section.hpp"
#include "boxbeam/section/taper.hpp"

namespace boxbeam {

/// A piece of a beam in which every dimension of the section varies linearly.
struct Segment {
  std::string name;
  Length start;  ///< s where it begins
  Length length;
  Section from, to;

  Length end() const { return start + length; }
};

/// The face of a station that is meant: just before it, just behind it, or both where nothing
/// jumps.
enum class Side { before, behind, both };

/// "-", "+" or "0".
const char* to_text(Side side);

/// A place on the beam axis, s from the beam's start.
struct Station {
  Length s;
  Side side = Side::both;

  friend bool operator==(const Station&, const Station&) = default;
};

/// A named place on the axis: a bearing, a joint, a place of interest.
struct BeamPoint {
  std::string name;
  Length s;
};

/// A plate across the beam, which keeps its section in shape and divides its plates into panels.
/// Its mass is not that of the beam.
struct Diaphragm {
  Length s;
  Length thickness;
  Length opening;  ///< width of its access hole; zero: none
  Length throat;   ///< of each of the fillet welds on both its faces; zero: not said
};

/// By which plates of a box a torque comes: forces on its webs or on its flanges, or all around
/// as the flow of torsion, which does not distort it.
enum class TorqueBy { webs, flanges, flow };

/// How forces come into the beam where no diaphragm takes them.
struct LoadIntroduction {
  Length from, to;  ///< the stretch on which it holds; the same: at one place
  /// Along the beam, over which a flange takes them; nothing: bosses or plates lead them into the
  /// webs over their depth.
  std::optional<Length> stiff_length;
  std::optional<TorqueBy> torque_by;  ///< nothing: not known, so that the worse counts
};

/// A beam along x of sections in a row, from s = 0 to its length.
struct TaperedBeam {
  std::vector<Segment> segments;  ///< in order, without gaps
  std::vector<BeamPoint> points;
  std::vector<Length> marks;          ///< more places of interest, which have no name: holes
  std::vector<Diaphragm> diaphragms;  ///< ascending
  std::vector<LoadIntroduction> introductions;
  Density density;
  /// Whether the sections' own rotary inertia counts, beside their mass on the axis.
  bool rotary_inertia = false;

  Length length() const { return segments.back().end(); }
};

/// The segment a station lies in; at a joint of two, the one on the station's side (`both`: the
/// one behind).
std::size_t segment_at(const TaperedBeam& beam, const Station& station);

/// Whether the section, or how it changes along the beam, differs on the two sides of the end of a
/// segment that is not the last.
bool kinks_behind(const TaperedBeam& beam, std::size_t segment);

/// The section at a station.
Section section_at(const TaperedBeam& beam, const Station& station);

/// How the section at a station changes along its segment; empty where it does not. Differences of
/// second order over steps that change no side by more than 1e-5 of itself, one-sided at the ends.
Taper taper_at(const TaperedBeam& beam, const Station& station);

/// The places where something is: ends of segments, holes and named points, ascending, each once.
std::vector<Length> places_of(const TaperedBeam& beam);

/// The place within round-off of s (a billionth of the beam), or s itself: stations typed as
/// numbers or computed must meet the ends of segments exactly, where cut forces jump.
Length place_near(const std::vector<Length>& places, Length s);

/// Mass and rotary inertia per length of one segment as polynomials of the distance from its
/// start: products of linear dimensions, hence exact at these degrees.
struct SegmentMass {
  Polynomial<2> mass;  ///< rho A [kg/m]
  /// rho I_y, rho I_z and rho I_yz [kg m]; zero where the beam does not count them.
  Polynomial<4> rotary_y, rotary_z, rotary_yz;
};

std::vector<SegmentMass> mass_distribution_of(const TaperedBeam& beam);

/// Mass, centre and moment of inertia of a piece of beam.
struct MassProperties {
  Mass mass;
  Length centre;       ///< s of the centre of mass
  MassMoment inertia;  ///< about the centre, axis y
  /// The whole tensor about the centre, beam axes [kg m^2].
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
};

MassProperties mass_properties_of(const TaperedBeam& beam);

/// Of the piece between two places of the axis.
MassProperties mass_properties_of(const TaperedBeam& beam, Length from, Length to);

}  // namespace boxbeam
