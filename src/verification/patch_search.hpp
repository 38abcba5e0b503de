#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/numerics/exact_memo.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "force_kinds.hpp"
#include "kinked_flanges.hpp"
#include "pressed_plates.hpp"
#include "pulling_panels.hpp"

namespace boxbeam {

/// A force across the beam, or several so close that a web feels them together.
struct Patch {
  std::string name;
  Length s;
  Force force;    ///< along its axis, signed
  Moment couple;  ///< about the beam's axis
  Length stiff_length;
  Moment turns = {};                     ///< couples beside the forces, part of `couple`
  Moment torque = {};                    ///< couples alone: the webs take it with unlike senses
  const Diaphragm* diaphragm = nullptr;  ///< that takes it
  Force square_to_it = {};               ///< what one of its plates takes along the other axis
  const FlangeKink* kink = nullptr;      ///< that it comes from
  std::array<FlangeKink::Turned, 2> by_sides{};  ///< of that, the larger one of which it is
  /// A force on the section, and across it where it stands and where it would have its couple.
  struct Standing {
    Force force;
    std::array<Length, 2> places{};
  };
  /// How a flange is bent across: by kinks there, over its strength; by what stands on it.
  double bent = 0.0;
  std::vector<Standing> standing = {};
  std::optional<std::size_t> load = {};  ///< the point load that it is, among those of its name
  std::optional<bool> at_high = {};      ///< at which end of the section, where that is known
  std::optional<bool> hangs = {};        ///< from the flange that it pulls at, where that is known
  bool along_z = true;                   ///< borne by the webs; else by the flanges
  bool given = true;                     ///< the case says how it comes in
  bool opposed = false;                  ///< one of the other sense is near
  bool together = false;                 ///< several as one
  bool led_there = false;                ///< beside the diaphragm that takes it
  bool led_onto = false;                 ///< a single one beside the diaphragm it is led onto
  bool is_line = false;                  ///< a load along the beam
  bool through = false;                  ///< from both flanges into a diaphragm
  bool moves = false;                    ///< along the beam
  bool stout = false;  ///< looked at for its size alone: the case does not say how it comes in

  /// What of it is none, there is for what panels pull at a diaphragm alone.
  bool is_none() const { return force == Force{}; }
  bool is_torque() const { return torque != Moment{}; }
  /// Across itself, by its couple.
  Length stands_at() const { return (along_z ? 1.0 : -1.0) * couple / force; }
  /// Of stout webs: by a lug or boss, as what rolls along the beam, turns off from a flange or the
  /// case speaks of does not.
  bool may_come_beside_flanges() const { return stout && !moves && kink == nullptr; }

  /// The same from instant to instant.
  auto key() const {
    return std::tuple(name, along_z, force.value() > 0.0, given, diaphragm != nullptr);
  }
};

using PatchKey = decltype(Patch().key());

/// The plates of a box that bear forces along z, or along y.
constexpr std::array<BoxPlate, 2> webs_along(bool along_z) {
  return along_z ? std::array{BoxPlate::left_web, BoxPlate::right_web}
                 : std::array{BoxPlate::top_flange, BoxPlate::bottom_flange};
}

/// The flanges of a patch: the one that it pushes onto first, then the one that it may pull at.
std::array<BoxPlate, 2> flanges_of(const Patch& patch);

/// A wall of four as a web of forces onto another one, far from an end and under no force yet.
PatchedWeb web_onto(const FourWalls& walls, BoxPlate wall, BoxPlate onto);

/// Whether one flange of a web may spread less than another.
bool bears_less(const PatchedWeb& one, const PatchedWeb& other);

/// Of these the thickness of the thinner one.
Length thinner_flange(const FourWalls& walls, const Patch& patch);

/// How one of the webs bears a patch.
struct Borne {
  PatchBasis basis;
  BoxPlate plate = BoxPlate::left_web;
  std::string wall = {};  ///< of a path, in its place

  /// What it is of the plates, and of the welds; of these whether the case says how thick they are.
  enum class Part { plate, weld, unsaid_weld };
  Part part = Part::plate;
};

/// A web that a patch presses through its edge.
struct PressedWeb {
  BoxPlate plate = BoxPlate::left_web;
  Stress stress;          ///< F/(t l), as the force has its sign
  Length before, behind;  ///< of the force: what of the web it loads
  Length stiff_length;
  /// Instead of the web a weld of a diaphragm with it, or with the flange: the stress in that.
  const Diaphragm* diaphragm = nullptr;
  StiffenerWeld weld = {};
};

struct OnLength;
struct PathWeb;
struct PathWebs;

/// A diaphragm beside a web as what bears forces there; `inside`: from web to web.
BearingStiffener stiffener_of(const Project& project, const PatchedWeb& web, Length inside,
                              const Diaphragm& diaphragm, const Station& station);

/// Whether a diaphragm is stiff enough for the webs of a box, or in space its flanges, to stand on
/// (9.3.3(3), I_st >= 0.75 h_w t^3 of long panels), or for both webs of a path; of other sections
/// every one.
bool is_firm(const Project& project, const Diaphragm& of, bool along_z);

/// Whether the throat of a seam of a box is one of a plate of it.
bool joins(const StressPoint& throat, BoxPlate plate);

/// What forces do to the webs that they come into, of the loads of one instant.
class PatchSearch {
 public:
  PatchSearch(const Project& project, const std::vector<BendingZone>& zones);

  /// Learns of what kinds forces are. False where those of no run may be more than plates feel.
  bool has_something_to_do(const std::deque<SituationRun>& runs);

  /// What comes in under these loads.
  std::vector<Patch> patches_of(const BeamLoads& loads, const CutForceDiagram& diagram);

  /// How webs and how their welds bear a patch among all, of all places and sides the one that is
  /// used most of each part; none of what is not judged.
  std::vector<Borne> worst_of(const Patch& patch, const std::vector<Patch>& all,
                              const CutForceDiagram& diagram);

  /// Whether the case says how forces come in there.
  bool is_given_at(Length s) const { return introduction_at(s) != nullptr; }

  /// Whether webs that may buckle in shear stand there without a diaphragm.
  bool lacks_diaphragm(Length s);
  /// The same of the plates along y, which are the webs of a force along y.
  bool lacks_diaphragm_along_y(Length s, Force along_y);
  /// The moment about y, in space the larger one of both axes, that is not judged as forces where
  /// webs would feel it as two of them as far apart as the section is deep: of a load between the
  /// beam's ends, whatever diaphragms stand beside it, for what it puts into these is not judged;
  /// at an end of a joint that leads it on into a body whose plates are not known, lie elsewhere or
  /// are turned.
  std::optional<Moment> unjudged_moment_of(const PointLoad& load);
  bool is_at_end(Length s) const;

  /// The webs of a box that a patch presses where no diaphragm takes it, the worse of both sides.
  std::vector<PressedWeb> pressed_by(const Patch& patch);
  /// The fillets of diaphragms that a single force stresses which stands there, or would as it
  /// moves on, with webs and with the flange, of those of which the case says how thick they are.
  std::vector<PressedWeb> welds_stressed_by(const Patch& patch);

  /// Torque that comes into a slender path around cells where no diaphragm stands: the largest of
  /// these loads.
  struct PathTorque {
    Length s;
    Moment torque;
  };
  PathTorque torque_into_path(const BeamLoads& loads);
  /// A force into a path that is not judged: into its walls, or at a diaphragm, whose bearing is
  /// not judged.
  struct OnPath {
    bool open = false;   ///< without a diaphragm that takes it
    bool blocks = true;  ///< a wall would have to bear it
    std::string why = {};
    bool said = false;  ///< in the verdict line, where it does not block
  };
  /// Nothing where what it does is judged or hardly felt, or nothing of it is a path. `on_loads`:
  /// the factor on loads and what is required, by which stout walls are used.
  std::optional<OnPath> unjudged_on_path(const Patch& patch, double on_loads);

  /// On all loads, without the situation's own.
  double factor_of(const PatchBasis& basis) const;
  double eta_1_of(const PatchBasis& basis) const;

  /// Why an introduction of the case is not judged; "" where it is.
  std::string obstacle_of(const LoadIntroduction& of);

 private:
  /// How many forces come in at most, and whether they do so at places of their own.
  struct Points {
    double most = 0.0;
    bool apart = true;
  };
  Points points_of(const SituationRun& run) const;
  /// Whether what comes in is to be looked at for its cycles.
  bool again_and_again() const;

  /// The section of a station by its effective widths and, where these do not judge it, by reduced
  /// stresses; with its seams where they are fillets.
  struct JudgedSection {
    std::shared_ptr<const EffectiveBox> box;
    std::array<std::optional<Length>, 4> panels;  ///< how long those of its plates are
    std::shared_ptr<const EffectivePath> path;    ///< in its place
    std::vector<std::shared_ptr<const ReducedPlate>> reduced;
    std::vector<std::shared_ptr<const StressPoint>> seams;
  };

  std::optional<FourWalls> walls_at(const Station& station) const;

  /// By the introduction of the narrowest stretch.
  const LoadIntroduction* introduction_at(Length s) const;

  /// Forces and, where something holds the beam, what holds it; no clamps.
  std::vector<Patch> forces_of(const BeamLoads& loads) const;
  Extent extent_at(Length s) const;
  /// The couple of a load that comes in with its force along an axis: the torque, and the levers of
  /// that force and of what stands beyond the section along the other axis.
  Moment couple_along(const PointLoad& load, bool along_z) const;
  /// The torque beside the forces along an axis: both ways, for it may come by either flange.
  void add_torque(const PointLoad& load, bool along_z, std::vector<Patch>& patches) const;
  bool feels_couple(Length s, Moment couple, bool about_y);
  /// The middles of both webs of a section along a force; nothing where there are not two.
  std::optional<Length> webs_apart_at(Length s, bool along_z) const;
  std::optional<Length> find_webs_apart(Length s, bool along_z) const;
  /// What plates that turn off between segments put into those beside them. kinked_flanges.cpp
  std::vector<Patch> kinks_under(const CutForceDiagram& diagram) const;
  /// Diaphragms at which no force comes in, for what their panels pull at them.
  void add_bare_diaphragms(std::vector<Patch>& patches);
  /// A diaphragm's part beside a web as what bears a patch, and what each panel there pulls at it.
  void bear_by_stiffener(const Patch& patch, const BearingStiffener& stiffener, Length flange,
                         const std::string& plate, const CutForceDiagram& diagram, Borne borne,
                         std::vector<Borne>& ways);
  /// The welds of a diaphragm's part with the web and with the flange, of those the weaker one: as
  /// thick as the case says, else of the least throat.
  void bear_by_welds(const Patch& patch, const BearingStiffener& stiffener, Length flange,
                     Borne borne, std::vector<Borne>& ways) const;
  /// How much of the weld with the flange bears a share of a patch: of what stands between the webs
  /// what lies under it.
  /// `webs`: their middles across the patch.
  Length weld_under(const Patch& patch, const BearingStiffener& by, double share, Length flange,
                    const std::array<Length, 2>& webs) const;
  Length weld_under_several(const Patch& patch, const BearingStiffener& by, double share,
                            Length flange, const std::array<Length, 2>& webs) const;
  /// Why what a path bears of a patch is not judged, "" where it is.
  std::string path_obstacle_of(const Patch& patch, const PathWebs& of);
  /// Whether what stands on a flange of a path may do more than hardly bend it across.
  bool bends_a_flange(const Patch& patch, const PathSection& path, const PathWebs& of) const;
  std::optional<OnPath> unjudged_on_path_at(const Patch& patch, const Station& station,
                                            double on_loads);
  /// A web where a diaphragm takes a patch, and why it is not judged as one, "" where it is: of a
  /// single web by plates on both sides of it that do not twist.
  BearingStiffener path_stiffener_of(const Patch& patch, const PathWebs& of, const PathWeb& web,
                                     const Station& station) const;
  std::string bearing_obstacle_of(const Patch& patch, const PathWebs& of,
                                  const Station& station) const;
  std::vector<Borne> path_ways_at(const Patch& patch, const PatchBasis& start,
                                  const Station& station, const JudgedSection& judged,
                                  const CutForceDiagram& diagram);
  /// Loads along the beam: of each sense what stands on any length of the depth of the webs, with
  /// the forces there; and torques along it.
  void add_lines(const std::vector<LineLoad>& lines, bool along_z, std::vector<Patch>& patches);
  /// How much of the webs on either side of a diaphragm works with it.
  Length strip_beside(const Diaphragm& of, bool along_z);
  void add_onto_diaphragm(const OnLength& of, const Diaphragm& diaphragm, bool along_z,
                          std::vector<Patch>& patches);
  /// `others`: forces and torques by themselves.
  void add_length(const OnLength& of, const std::vector<Patch>& others, bool along_z,
                  std::vector<Patch>& patches);
  /// The torque along it, as couples at one place are.
  void add_torque_along(Patch line, Moment torque, std::vector<Patch>& patches);
  const Diaphragm* diaphragm_at(Length s) const;
  /// `is_firm`, once each.
  bool holds(const Diaphragm& of, bool along_z) const;

  /// Whether the patch is to be looked at, of all that come in at once.
  bool say_how_it_comes_in(Patch& patch, const ForcesAcross& all);

  /// Adds those that stand close together as one, and says which are opposed. What turns off from
  /// one flange and from the other does not meet.
  void add_groups(std::vector<Patch>& patches);
  /// Of some of all patches: whether enough of the other sense is near, in however many pieces.
  void mark_opposed(const std::vector<LineLoad>& lines, const std::vector<Patch>& all,
                    std::vector<Patch>& some);
  /// `high`: of kinks those at this end of the section; `turning`: with the torques of this sense.
  void add_groups_at(std::optional<bool> high, double turning, std::size_t singles,
                     const std::vector<Length>& depths, std::vector<Patch>& patches) const;
  /// What presses the plate of a diaphragm, and its welds with the webs, from both flanges with one
  /// sense: kinks of both, and the forces there.
  void add_through_diaphragms(std::size_t singles, std::vector<Patch>& patches) const;
  /// What stands so near a firm diaphragm that this takes it, is taken by it as well.
  void add_beside_diaphragms(std::vector<Patch>& patches);

  Length depth_at(const Patch& patch);
  static Length depth_of_path(const Patch& patch, const JudgedSection& judged);

  const JudgedSection& judged_at(const Station& station);

  /// What a diaphragm under a patch takes along the other axis, by one of its plates.
  static Force square_to(const Patch& patch, const std::vector<Patch>& all,
                         const JudgedSection& judged);

  std::vector<std::shared_ptr<const ReducedPlate>> reduced_at(const Station& station,
                                                              const Section& section,
                                                              const FourWalls& walls) const;

  /// Both webs of a patch, and the parts of it that they take, signed.
  struct Shared {
    std::array<BoxPlate, 2> webs{};
    std::array<double, 2> shares{};
  };
  static Shared shared_by_webs(const Patch& patch, const FourWalls& walls);

  /// What a patch is where it is borne: its force, and the beam's own stress there; of several that
  /// stand together, and of a load along the beam, the largest on what is loaded.
  PatchBasis basis_of(const Patch& patch, const Station& station, const CutForceDiagram& diagram);
  std::vector<Borne> ways_at(const Patch& patch, const PatchBasis& start, const Station& station,
                             const JudgedSection& judged, const CutForceDiagram& diagram);

  /// The seams by which a patch comes into the webs, pushing onto the one flange or pulling at the
  /// other. patched_seams.cpp
  std::vector<Borne> seams_at(const Patch& patch, const std::vector<Patch>& all,
                              const JudgedSection& judged, const CutForces& cut) const;
  /// A station that bears a patch: a part of its force, over this stiff length.
  struct Reached {
    Station at;
    double part = 1.0;
    Length stiff_length;
  };
  /// Both sides of its place bear all of it, the far sides of borders of segments what stands
  /// beyond these.
  std::vector<Reached> reached_by(const Patch& patch);

  /// What a patch loads of a seam, within the ends of the beam that no diaphragm holds.
  struct Spread {
    Length from, to;
  };
  Spread spread_of(const Patch& patch, const PatchedWeb& web) const;

  /// Of webs that are stressed alike the one there is.
  static std::shared_ptr<const ReducedPlate> reduced_plate_of(const JudgedSection& judged,
                                                              BoxPlate plate);

  void bear_by_effective_widths(const PatchedWeb& web, PatchBasis& basis) const;

  void bear_by_reduced_stresses(const std::shared_ptr<const ReducedPlate>& plate, PatchedWeb web,
                                bool onto_high, PatchBasis& basis) const;

  /// A web as a force comes to it by a flange, far from an end.
  static PatchedWeb web_of(const JudgedSection& judged, BoxPlate plate, BoxPlate flange,
                           const Patch& patch);
  static PatchedWeb web_under(PatchedWeb web, const Patch& patch);
  /// In every way that may be meant: far from an end, and near one.
  std::vector<PatchedWeb> in_every_way(PatchedWeb web, const Patch& patch) const;

  /// From the stiff length to the nearer end of the beam that no diaphragm keeps off.
  std::optional<Length> distance_to_end(const Patch& patch) const;

  const Project* project_;
  const std::vector<BendingZone>* zones_;
  PullingPanels pulling_;
  std::vector<FlangeKink> kinks_;
  std::vector<std::string> knees_;  ///< joints of members whose plates lead all on, or as kinks
  PressedPlatesAlong plates_;
  ForceKinds kinds_;
  std::set<const LoadIntroduction*> used_;  ///< by which a force has come in
  std::map<std::pair<double, Side>, JudgedSection> judged_;
  mutable ExactMemo<2, std::optional<Length>> webs_apart_;  ///< by place and axis
  mutable std::map<std::pair<const Diaphragm*, bool>, bool> holds_;
};

}  // namespace boxbeam
