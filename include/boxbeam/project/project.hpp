#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/mechanism/planar/newton_chain.hpp"
#include "boxbeam/mechanism/recorded/loads.hpp"
#include "boxbeam/mechanism/spatial/mechanism.hpp"
#include "boxbeam/project/beam_demands.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/neighbour_demands.hpp"
#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/strength/material.hpp"

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
