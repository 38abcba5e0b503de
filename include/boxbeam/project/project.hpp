#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/detail.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"
#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"
#include "boxbeam/mechanism/planar/elastic_joint.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/mechanism/planar/newton_chain.hpp"
#include "boxbeam/mechanism/recorded/loads.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/elastic_joint.hpp"
#include "boxbeam/mechanism/spatial/mechanism.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/hole_concentration.hpp"
#include "boxbeam/strength/lug.hpp"
#include "boxbeam/strength/material.hpp"
#include "boxbeam/strength/pin.hpp"

namespace boxbeam {

/// What moves or loads the beam: rigid bodies in the plane or in space, elastic links in a plane,
/// a frame at rest, or loads that others have measured or computed.
using AnyMechanism = std::variant<planar::Mechanism, spatial::Mechanism, flexible::Mechanism,
                                  frame::Structure, recorded::Loads>;

/// The words for these kinds in a case, in the same order.
inline constexpr std::array kind_words{"planar", "spatial", "flexible", "static", "loads"};
static_assert(kind_words.size() == std::variant_size_v<AnyMechanism>);

/// The word for the kind of a mechanism.
inline const char* kind_word_of(const AnyMechanism& mechanism) {
  return kind_words[mechanism.index()];
}

/// Where the loads on the beam come from.
enum class Dynamics {
  rigorous,      ///< reactions of the mechanism, distributed weight and inertia
  newton_chain,  ///< the published chain of the sledge-rig thesis
};

const char* to_text(Dynamics dynamics);

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

/// A stress taken from a published calculation instead of being computed.
struct GivenStress {
  std::string name;
  Length s;
  Stress peak;                     ///< largest, concentration included
  std::optional<Stress> opposite;  ///< largest of the other sign, as a positive number
  Length thickness;                ///< of the plate, for its yield strength
  Time time;                       ///< of the peak
  std::string note;
};

/// So many cycles whose range is a share of a change between situations.
struct SpectrumLevel {
  double share = 1.0;
  double cycles = 0.0;
};

/// A way in which the beam is used: normal running, an emergency stop, a start and a stop.
struct Situation {
  std::string name;  ///< "" where the case has only one
  /// Repetitions of its period, or of the change between situations, in the wanted life; zero where
  /// it counts for the strength only.
  double cycles = 0.0;
  /// On all its loads, for strength; zero where it does not count for that.
  double load_factor = 1.0;
  bool serviceability = true;    ///< whether it counts for the deflection
  std::vector<std::string> set;  ///< what differs from the case, "drivers.exciter.frequency = ..."
  std::optional<AnyMechanism> changed;  ///< the mechanism with that; nothing: as the case is
  /// Where not empty: made of these situations (indices). Either the change between them, one
  /// stress cycle from the highest to the lowest stress in any of them, or one after the other, in
  /// order, counted as one history that repeats.
  std::vector<std::size_t> between;
  bool in_order = false;
  /// Of a change: its cycles, `cycles` all together; one at the whole change among them. Empty: all
  /// of them are whole.
  std::vector<SpectrumLevel> spectrum;
  /// Elastic links: the harmonic loads are switched on at once on the structure at rest, and the
  /// time after it is looked at, instead of the steady vibration.
  bool sudden_start = false;

  /// Whether it is a motion of its own.
  bool runs() const { return between.empty(); }
  bool is_change() const { return !between.empty() && !in_order; }
};

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

struct EquivalentMassDemand {
  int joint = 0;
  int on = 0;
  int adjust = 0;
  Mass wanted;
};

/// Which model of the mechanism is wanted.
enum class ModelDemand {
  automatic,  ///< the cheapest whose error is within the tolerance
  rigid,      ///< rigid bodies
  flexible,   ///< elastic links
};

struct ModelInput {
  ModelDemand demand = ModelDemand::automatic;
  double tolerance = 0.01;  ///< on the governing stress, relative
  /// Of the beam; structural steel where not said, EN 1993-1-1:2005, 3.2.6 [Pa].
  double youngs_modulus = 2.1e11;
  double shear_modulus = 8.1e10;  ///< [Pa]
  double retardation = 0.0;       ///< Kelvin-Voigt damping of the beam [s]
  /// Whether the loads were measured on the running machine: they contain its vibration.
  bool measured_loads = false;
};

/// A formula of the user's own, evaluated, to be printed beside what the program finds.
struct HandFormula {
  enum class Quantity { omega, alpha, position, velocity, acceleration };

  std::string name;
  Quantity quantity = Quantity::omega;
  int body = spatial::ground;  ///< of omega and alpha
  spatial::Attachment point;   ///< of the others
  Time time;
  std::vector<std::string> formula;                 ///< of x, y and z, as written
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< SI, world axes
  std::string note;
};

/// What a report says of itself; texts of the user's, "" where not said.
struct CaseHeader {
  std::string project, client, revision;
  std::string standard;         ///< with the national annex whose values the case has
  std::string author, checker;  ///< names
  std::vector<std::string> remarks;
};

/// What some plates of a beam are made of.
struct PartMaterial {
  Material material;
  std::vector<bool> segments;  ///< which
  std::array<bool, plate_kinds> plates{};
};

/// A case: everything a verification needs, validated. Behind it nothing is checked again.
struct Project {
  // Defined once: every source that holds a project would compile what it is made of anew.
  Project();
  Project(const Project&);
  Project(Project&&) noexcept;
  Project& operator=(const Project&);
  Project& operator=(Project&&) noexcept;
  ~Project();

  std::string name;
  std::string title;
  CaseHeader header;
  std::string path;
  std::string text;               ///< of the case file, as it was read; lines end with "\n"
  std::string sha256;             ///< of the case, its overrides and its tables
  std::vector<InputFile> tables;  ///< files of numbers that drivers and forces follow
  std::vector<std::string> assumptions;
  std::vector<std::string> overrides;

  AnyMechanism mechanism;               ///< as the case writes it, before any situation
  bool in_space = false;                ///< all six cut forces count; in the plane N, V_z and M_y
  std::vector<Situation> situations;    ///< at least one; the first runs
  std::string beam_name;                ///< "" where the case has only one
  std::size_t beam_index = 0;           ///< among the beams of the case
  std::vector<std::string> beam_names;  ///< of all beams; none where the case has only one
  TaperedBeam beam;                     ///< whose marks are the places of the holes
  std::vector<BeamHole> holes;
  std::vector<Restraint> restraints;  ///< in stability alone
  /// The beam's body or link; ground: the beam is no body, only the chain can load it.
  int beam_body = planar::ground;
  std::vector<ElasticBeside> elastic_beside;  ///< whichever beam of the case is verified
  Dynamics dynamics = Dynamics::rigorous;
  spatial::BeamPlacement placement;  ///< of the beam in its body; in space only
  ModelInput model;
  std::optional<planar::NewtonChain> chain;
  std::optional<EquivalentMassDemand> equivalent_mass;

  Material material;  ///< of all plates that are not of another
  std::vector<PartMaterial>
      part_materials;  ///< of some plates; the last one that has a plate counts
  StrengthDemand strength;
  FatigueInput fatigue;
  std::vector<NamedPoint> points;
  std::vector<PinInput> pins;
  std::vector<RodInput> rods;
  std::vector<WeldInput> welds;
  std::optional<DeflectionInput> deflection;
  std::vector<GivenStress> given_stresses;
  std::vector<HandFormula> hand_formulas;
};

/// Adds a hole, and its mark to the beam.
void add_hole(Project& project, BeamHole hole);

/// What holes take out of the section at s, where the centre of one of them is: those there, and
/// of those beside it in the same plates what a path across the plate through both loses by them,
///
///     d - s^2/(4 p)
///
/// s and p are the distances of their centres along and across the beam. Nothing at other stations.
/// Source: EN 1993-1-1:2005, 6.2.2.2(4).
std::vector<Hole> holes_at(const Project& project, Length s);

/// The mechanism of a case, of a kind that the caller knows.
inline const planar::Mechanism& planar_of(const Project& project) {
  return std::get<planar::Mechanism>(project.mechanism);
}
inline planar::Mechanism& planar_of(Project& project) {
  return std::get<planar::Mechanism>(project.mechanism);
}
inline const spatial::Mechanism& spatial_of(const Project& project) {
  return std::get<spatial::Mechanism>(project.mechanism);
}
inline spatial::Mechanism& spatial_of(Project& project) {
  return std::get<spatial::Mechanism>(project.mechanism);
}
inline const flexible::Mechanism& flexible_of(const Project& project) {
  return std::get<flexible::Mechanism>(project.mechanism);
}
inline flexible::Mechanism& flexible_of(Project& project) {
  return std::get<flexible::Mechanism>(project.mechanism);
}
inline const frame::Structure& frame_of(const Project& project) {
  return std::get<frame::Structure>(project.mechanism);
}
inline const recorded::Loads& recorded_of(const Project& project) {
  return std::get<recorded::Loads>(project.mechanism);
}

/// The mechanism as it runs in a situation, of whichever kind.
inline const AnyMechanism& mechanism_in(const Project& project, const Situation& situation) {
  return situation.changed ? *situation.changed : project.mechanism;
}

/// The same of a kind that the caller knows.
inline const planar::Mechanism& planar_in(const Project& project, const Situation& situation) {
  return std::get<planar::Mechanism>(mechanism_in(project, situation));
}
inline const spatial::Mechanism& spatial_in(const Project& project, const Situation& situation) {
  return std::get<spatial::Mechanism>(mechanism_in(project, situation));
}
inline const flexible::Mechanism& flexible_in(const Project& project, const Situation& situation) {
  return std::get<flexible::Mechanism>(mechanism_in(project, situation));
}
inline const frame::Structure& frame_in(const Project& project, const Situation& situation) {
  return std::get<frame::Structure>(mechanism_in(project, situation));
}
inline const recorded::Loads& recorded_in(const Project& project, const Situation& situation) {
  return std::get<recorded::Loads>(mechanism_in(project, situation));
}

/// Where the beam lies in the mechanism of a situation, whose bodies may stand in another order.
spatial::BeamPlacement placement_in(const Project& project, const spatial::Mechanism& mechanism);
/// That of another place on a body of the case as it is written.
spatial::BeamPlacement placement_in(const Project& project, spatial::BeamPlacement placement,
                                    const spatial::Mechanism& mechanism);

/// The time that a case is looked at.
const Duration& duration_of(const Project& project);

/// Cycles of the situation that runs most often in the wanted life.
double most_cycles_of(const Project& project);

/// Reads a case file for each of its beams, in its order: they have all in common but the beam and
/// what is said of it alone. Pins, rods and the mass that is felt stand with the first.
std::vector<Project> read_beams(const std::string& path,
                                const std::vector<std::string>& overrides = {},
                                std::optional<Dynamics> dynamics = {});

/// Reads a case file, of several beams for the first. `overrides` are "key.path=value"; `dynamics`
/// replaces the case's choice. Throws InputError with all problems.
Project read_project(const std::string& path, const std::vector<std::string>& overrides = {},
                     std::optional<Dynamics> dynamics = {});

/// All beams of a case from text, under a name for messages.
std::vector<Project> parse_beams(const std::string& path, const std::string& text,
                                 const std::vector<std::string>& overrides = {},
                                 std::optional<Dynamics> dynamics = {});

/// Of several beams the first.
Project parse_project(const std::string& path, const std::string& text,
                      const std::vector<std::string>& overrides = {},
                      std::optional<Dynamics> dynamics = {});

}  // namespace boxbeam
