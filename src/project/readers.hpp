#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/index_by_name.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "time_tables.hpp"

/// The parts of a case file, each read by one function. They note problems and go on; what they
/// return is only meaningful where none was noted.
namespace boxbeam::readers {

using Sections = std::map<std::string, Section>;

/// [sections]: every kind of profile, and nested ones. A section with a problem has a defect.
Sections read_sections(TableReader table);

/// The section of a name that stands under a key; one with a defect where there is none.
Section section_called(TableReader& table, std::string_view key, const std::string& name,
                       const Sections& sections);

/// The section named by the value of a key; likewise.
Section named_section(TableReader& table, const Key& key, const Sections& sections);

/// One of [[segments]]; `number` names it where it has no name.
Segment read_segment(TableReader table, std::size_t number, Length start, const Sections& sections);

/// Whether a name may be that of a folder.
bool is_plain_name(const std::string& name);

/// Density and segments of a beam.
TaperedBeam read_tapered_beam(TableReader& table, const Sections& sections);

/// Segments, holes and places of [beam]; fills the project's beam and hole cases.
void read_beam(TableReader& table, const Sections& sections, Project& project);

/// The mechanism as written. Points stay in the axes in which they are written until
/// `place_at_centres` moves them; the mass of the beam body is not known before.
struct MechanismDraft {
  planar::Mechanism mechanism;
  std::vector<Eigen::Vector2d> centres;  ///< of mass, in the axes in which the points are written
  std::vector<planar::ElasticJoint> elastic;
};

/// Bodies, joints, drivers, forces, loops and the time to look at. `beam_bodies`: the bodies that
/// are beams, that of the verified one first. `tables` takes the files of numbers that drivers and
/// forces follow.
MechanismDraft read_mechanism(TableReader& root, const std::vector<std::string>& beam_bodies,
                              TimeTables& tables);

/// Gives the body of a beam the beam's mass properties.
void give_mass(MechanismDraft& draft, const TaperedBeam& beam, int body);

/// Moves every body's axes to its centre.
planar::Mechanism place_at_centres(MechanismDraft draft);

/// Notes keys of mass on the beam's body: its mass properties come from its sections.
void refuse_mass(TableReader& table);

/// [bodies]; where [beam] is missing or misspells its body, the body without a mass is meant.
void read_bodies(TableReader& root, const std::vector<std::string>& beam_bodies,
                 MechanismDraft& draft);

/// [joints], [drivers] and [forces]: each is added to the mechanism.
void read_joints(TableReader& root, MechanismDraft& draft);
void read_drivers(TableReader& root, planar::Mechanism& mechanism, TimeTables& tables);
void read_forces(TableReader& root, planar::Mechanism& mechanism, TimeTables& tables);

/// What a function of time gives, and the words for messages.
struct FunctionOf {
  WantedDimension value;
  const char* unit;    ///< "m"
  const char* column;  ///< of a table in examples, "stroke"
  const char* still;   ///< where it is a constant: "the driver does not move"
  bool moves = false;  ///< a coordinate, whose acceleration is needed
};

/// A function of time: harmonic, constant rate, polynomial, smooth step or table. Nothing where its
/// kind is not known and its other keys mean nothing.
std::optional<Driver> read_function(TableReader& table, const FunctionOf& of, TimeTables& tables);

/// [motion], how long to look.
Duration read_duration(TableReader& root);

/// The tables of a case in which functions of time are written.
struct FunctionTables {
  const char* joints = "drivers";
  const char* forces = "forces";
};

/// Notes functions of time by which the time to look at is not known, or that say nothing of a part
/// of it: without a duration the motion is looked at for a common period, or to the end of a step;
/// tables cover it from 0 s to its end.
void check_functions(TableReader& root, const std::vector<DriverUse>& functions,
                     const Duration& duration, const FunctionTables& tables);

/// The constant "size" of a force, or its function of time "law".
Driver read_size(TableReader& table, const FunctionOf& of, TimeTables& tables);

/// A joint in space that gives way, by the name of the case.
struct NamedElasticJoint {
  std::string name;
  spatial::ElasticJoint of;

  friend bool operator==(const NamedElasticJoint&, const NamedElasticJoint&) = default;
};

/// A mechanism in space as written; its beams have no mass before `place_beam`.
struct ChainDraft {
  spatial::Mechanism mechanism;
  std::vector<NamedElasticJoint> giving_way;
};

ChainDraft read_chain(TableReader& root, const std::vector<std::string>& beam_bodies,
                      TimeTables& tables);

/// [joints] and [drivers] of a mechanism in space whose bodies are read, which then stand in the
/// order of its tree. False where they form none: nothing else can be found in it.
bool read_chain_joints(TableReader& root, ChainDraft& chain, TimeTables& tables);

/// [forces] on the bodies of a mechanism in space.
void read_chain_loads(TableReader& root, spatial::Mechanism& mechanism, TimeTables& tables);
/// [loops]: which assemblies are wanted.
void read_chain_branches(TableReader& root, spatial::Mechanism& mechanism);

/// Where the beam lies in its body: "start", "axis" and "z" of [beam].
spatial::BeamPlacement read_placement(TableReader& beam, const spatial::Mechanism& mechanism,
                                      int body);

/// Gives the beam's body its mass, and notes line forces that do not lie along whole segments.
void place_beam(TableReader& root, const TaperedBeam& beam, const spatial::BeamPlacement& placement,
                spatial::Mechanism& mechanism);

/// How elastic links are divided.
struct ElasticForm {
  flexible::Element element = flexible::Element::corrected;
  bool nodes_at_joints = true;
};

/// [model], which may be missing: which model is wanted, into the project; and what all elastic
/// links have in common.
ElasticForm read_model(TableReader& root, Project& project);

/// "damping" of elastic links as retardation time [s]: a time tau, or a ratio zeta at a frequency
/// f, tau = 2 zeta/(2 pi f).
double read_retardation(TableReader& table, std::optional<double> fallback);

/// What the links of a case have in common.
struct LinkDefaults {
  const Sections* sections = nullptr;
  const TaperedBeam* beam = nullptr;
  std::string beam_link;
  std::vector<std::pair<std::string, TaperedBeam>> other_beams = {};  ///< by their links
  const ModelInput* model = nullptr;
  ElasticForm form;
};

/// [links], in the order of the file, placed in the world.
std::vector<flexible::Link> read_links(TableReader& root, const LinkDefaults& defaults);

/// A mechanism of elastic links: [mechanism], [links], [joints], [loads] and [motion].
flexible::Mechanism read_flexible(TableReader& root, const LinkDefaults& defaults);

/// [[hand_formulas]]: the user's own formulas, evaluated, to be printed beside the results.
std::vector<HandFormula> read_hand_formulas(TableReader& root, const spatial::Mechanism& mechanism);

/// A point of a body in space written "body.point", as the value of a key or in a list under it.
spatial::Attachment point_named(TableReader& table, std::string_view key,
                                const std::string& reference, const spatial::Mechanism& mechanism);
spatial::Attachment attachment_of(TableReader& table, const Key& key,
                                  const spatial::Mechanism& mechanism);

/// A point written "body.point".
planar::Attachment attachment_of(TableReader& table, const Key& key,
                                 const planar::Mechanism& mechanism);
std::vector<planar::Attachment> attachments_of(TableReader& table, const Key& key,
                                               std::size_t count,
                                               const planar::Mechanism& mechanism);

/// A point "body.point", or "ground" with its place in the key "at".
planar::Attachment place_of(TableReader& table, const Key& key, const planar::Mechanism& mechanism);

/// How two points are written in a list under a key.
struct EndsKey {
  Key key;                   ///< "connect"
  const char* what;          ///< connects them: "a pin"
  bool ground_point = true;  ///< whether "ground" wants its point in the key "at"
};

/// Two points of two bodies, or of a body and the ground.
std::pair<planar::Attachment, planar::Attachment> ends_in(TableReader& table, const EndsKey& of,
                                                          const planar::Mechanism& mechanism);

/// Notes a name that a joint, driver or force before it has; `what`: "driver".
void check_name(TableReader& table, const std::string& name, const char* what,
                const planar::Mechanism& mechanism);

/// The nearest of the known names, or all of them where none is near.
std::string unknown_hint(std::string_view name, const std::vector<std::string>& known);

/// Index of a body or joint named by the value of a key, a problem and -1 where there is none.
int body_of(TableReader& table, const Key& key, const planar::Mechanism& mechanism);
int body_of(TableReader& table, const Key& key, const spatial::Mechanism& mechanism);
int joint_of(TableReader& table, const Key& key, const planar::Mechanism& mechanism);

/// "friction" of a joint that slides; none where it says nothing.
Friction read_friction(TableReader& joint);

/// What a torsion spring says beside where it is.
struct TorsionOf {
  double stiffness = 0.0, free_angle = 0.0, damping = 0.0;  ///< [N m/rad, rad, N m s/rad]
};
TorsionOf read_torsion(TableReader& table);

/// Which way a spring acts, and the law of the impact of one that acts one way, where it says one:
/// makes its stiffness that of the law.
struct ActingOf {
  Acts acts = Acts::both;
  std::optional<Impact> impact = {};
};
ActingOf read_acting(TableReader& spring, double& stiffness, double damping);

/// The contact of a joint that says a clearance: its stiffness has no default.
struct ClearanceOf {
  double clearance = 0.0, stiffness = 0.0;  ///< [m, N/m^n]
  Impact impact;
};
std::optional<ClearanceOf> read_clearance(TableReader& joint);

/// Refuses a spring with neither stiffness nor damping.
void refuse_idle(TableReader& table, double stiffness, double damping,
                 const WantedDimension& of_stiffness);

/// What a spring between two points says beside where it is; in the plane or in space.
template <class Spring>
void read_spring_law(TableReader& table, Spring& spring) {
  spring.stiffness = table.not_negative({"stiffness", "force per length"}, wanted::stiffness);
  spring.free_length = table.not_negative({"free_length", "without force"}, wanted::length, 0.0);
  spring.damping = table.not_negative({"damping", "force per velocity"}, wanted::damping, 0.0);
  refuse_idle(table, spring.stiffness, spring.damping, wanted::stiffness);
  const ActingOf acting = read_acting(table, spring.stiffness, spring.damping);
  spring.acts = acting.acts;
  spring.impact = acting.impact;
}

/// [[beam.restraints]] of a beam that is read. Refuses those that do not hold it.
std::vector<Restraint> read_restraints(TableReader& table, const TaperedBeam& beam);

/// A station given as a length along the beam, within it.
Length station_of(TableReader& table, const Key& key, const TaperedBeam& beam);

planar::NewtonChain read_newton_chain(TableReader table, const planar::Mechanism& mechanism,
                                      const TaperedBeam& beam, int beam_body);

class FrontEndReader;

/// [[situations]], or the only one there is. `tree` is the case, which a situation changes.
void read_situations(TableReader& root, const Node& tree, const FrontEndReader& front_end,
                     Project& project);

void read_demands(TableReader& root, Project& project);

/// [material], before the moduli that [model] or a member may say otherwise.
void read_material(TableReader& root, Project& project);

/// [[part_materials]] of the beam, which is read; refuses plates thicker than the tables of their
/// materials go.
void read_part_materials(TableReader& root, Project& project);

/// Refuses a material of one's own whose modulus is taken to be that of steel, and with it the
/// rules for steel, where the density of the beam is not. `tree` is the case.
void check_modulus(TableReader& root, const Node& tree, const Project& project);

/// What to write instead of plates thicker than a material's table goes.
std::string thickest_hint(const Material& material);

/// [fatigue] and its details.
FatigueInput read_fatigue(TableReader table, const TaperedBeam& beam);

/// Refuses categories for the net section on stretches with holes whose concentration is computed.
void check_net_sections(TableReader& root, const Project& project);

/// [[pins]], [[rods]] and [deflection], what the loads decide beside the beam. In space the
/// directions of the z of the rods' sections in their bodies; nothing where a case does not say it.
std::vector<std::optional<Eigen::Vector3d>> read_neighbours(TableReader& root,
                                                            const Sections& sections,
                                                            Project& project);

/// [deflection]: its limit, and the line that it is measured from, which the beam's supports say
/// where the case does not.
void read_deflection_of(TableReader& root, Project& project);

/// [[welds]] between parts of the beam.
void read_welds(TableReader& root, const Sections& sections, Project& project);

/// A steel of the catalogue named by the value of a key.
Material named_steel(TableReader& table, const Key& key, const std::string& source = {});

}  // namespace boxbeam::readers
