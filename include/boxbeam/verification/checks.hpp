#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/core/kept_apart.hpp"
#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/member_buckling.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/strength/reduced_stress.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "boxbeam/verification/whole_life.hpp"

namespace boxbeam {

/// Cycles of one size in the wanted life, and where they come from.
struct SpectrumRow {
  std::string situation;
  StressKind kind = StressKind::direct;
  Cycle cycle;  ///< its count is that of the life; the range as it counts (7.2.1)
  /// Cycles to failure, the loads taken safety_factor times; infinity where it does no damage.
  double endured = 0.0;
  double damage = 0.0;  ///< with the loads as they are, partial factors applied
};

/// What a computed check rests on, for the calculation sheet and the plots.
struct CheckBasis {
  StressPoint point;
  /// Which stress the extremes and the history below are of; of a range, the one that governs.
  StressKind kind = StressKind::direct;
  double stress_factor = 1.0;  ///< of the detail, by which these are multiplied
  /// Extremes of the stress [Pa] over the situation of the check; for yield both are the instant of
  /// the check.
  Extreme highest, lowest;
  CutForces cut_at_highest, cut_at_lowest;
  CutForces cut_at_time;  ///< at the check's own instant
  PointStress stress_at_time;
  std::size_t running = 0;  ///< index of the situation in which the stress is worst
  /// The stress over one period of it, of the checks that are drawn (`drawn_over_time`): instants
  /// [s], values [Pa].
  std::vector<double> times, history;
  WeldStrength weld;  ///< of a throat
  // Fatigue only:
  std::vector<SpectrumRow> spectrum;
  std::vector<SnCurve> curves;             ///< that resist, in the order direct, shear
  double constant_amplitude_factor = 0.0;  ///< EN 1993-1-9 7.1(2)
  double damage = 0.0;                     ///< in the wanted life, partial factors applied
  Stress equivalent;                       ///< range of 2e6 cycles with this damage; one curve only
};

/// What the check of a stress rests on that was given.
struct GivenBasis {
  GivenStress stress;
  Stress strength;                 ///< f_y, or the range of its cycles, as the case rounds it
  ResistingDetail resisting = {};  ///< of its ranges
};

struct SlenderPlates;
struct ShearedPlate;
struct ReducedPlate;

/// What the check of plates that buckle rests on.
struct PlateBasis {
  std::shared_ptr<const SlenderPlates> plates;
  std::shared_ptr<const EffectiveBox> box;  ///< by which the stress is, of them or below yield
  const ShearedPlate* plate = nullptr;      ///< of them; nothing of the section
  const ReducedPlate* reduced = nullptr;    ///< the same, where it is judged by reduced stresses
  CutForces cut;                            ///< at the check's instant
  CornerUse corner;                         ///< the one used most then
  double load_factor = 1.0;
};

struct SlenderPath;
struct ShearedWall;

/// What the check of a path whose plates buckle rests on.
struct PathBasis {
  std::shared_ptr<const SlenderPath> path;
  std::shared_ptr<const EffectivePath> section;  ///< by which the stress is, of it or below yield
  const ShearedWall* wall = nullptr;             ///< of it; nothing of the section
  const ReducedPlate* reduced = nullptr;         ///< of it, where reduced stresses look at it
  CutForces cut;                                 ///< at the check's instant
  PathUse use;                                   ///< of the place used most then
  double load_factor = 1.0;
};

/// A web under a force and all else that acts on it, by reduced stresses.
struct ReducedWeb {
  PatchedWeb web;  ///< by which the force alone would buckle it
  std::shared_ptr<const ReducedPlate> plate;
  bool onto_high = false;  ///< the edge that the force comes in by
  PanelStress stress;
};

/// The fillet seam of a web with the flange by which a force comes to it.
struct PatchedSeam {
  std::shared_ptr<const StressPoint> point;  ///< its throat
  BoxPlate flange = BoxPlate::top_flange;    ///< the plate on the other side of it
  Length loaded;                             ///< of the seam, s_s + 2 t_f
  Stress beside;  ///< across the throat, of other forces whose spread meets that of this one
  WeldStrength strength;
};

/// A panel in shear beyond the buckling of its plate, which pulls at the diaphragm that bounds it.
struct PullingPanel {
  Station at;        ///< by which it is judged
  ShearPanel panel;  ///< there
  Force shear;       ///< V_Ed there
};

/// What the check of a force that comes into a web rests on.
struct PatchBasis {
  /// What bears it: the web itself, or with a diaphragm at the place both as a column; and the seam
  /// that leads it into the web, or the welds of the diaphragm.
  std::variant<PatchedWeb, BearingStiffener, ReducedWeb, PatchedSeam, StiffenerWeld> bears;
  Force force;         ///< of all that stands so close together, on both webs
  double share = 0.5;  ///< of this web
  /// Of a diaphragm beside panels whose plate may buckle in shear, the one that pulls most.
  std::optional<PullingPanel> pulls = {};
  /// By reduced stresses and of a seam that with which, all else in proportion, it is used up.
  Force resistance;
  /// Which the stress of the beam there is by: its effective sections, whole where none buckles.
  std::shared_ptr<const EffectiveBox> box;
  std::shared_ptr<const EffectivePath> path = {};  ///< of paths, in its place
  CutForces cut;
  CornerUse corner;
  PathUse place = {};  ///< of paths
  Length used_most;    ///< at which station of what is loaded that stress is the largest
  double load_factor = 1.0;
};

/// What the check of a web that forces press anew at every cycle rests on.
struct PressedBasis {
  CheckBasis life;   ///< its cycles and what resists them
  Length thickness;  ///< of the web
  Force force;       ///< of those that press the place the largest on this web
  Length loaded;     ///< by it: s_s + 2 t_f, within the ends of the beam
  Length throat;     ///< of its fillet seam, where that is judged
  /// Of the fillets of a diaphragm, each as long as `loaded` and as thick as `throat`: how many.
  int welds = 0;
};

/// What the check of a box that is distorted rests on.
struct DistortionBasis {
  /// Of the point without distortion; in fatigue the cycles with it, and what resists them.
  CheckBasis stress;
  DistortionInfluence at;  ///< of the plate that is used most there, or of the throat of its seam
  bool in_throat = false;  ///< strength
  bool across = false;     ///< fatigue: by what bends the plate across, alone
  DistortionSize size;     ///< at the check's instant; in fatigue the range
  double load_factor = 1.0;
  Length introduced;  ///< where the torque comes that does most of it
  Moment torque;      ///< that comes there
};

/// What the check of the beam as a member rests on, all of it with load factors and the
/// safety factor that is asked for.
struct MemberBasis {
  bool turns_over = false;  ///< laterally and by torsion; else it bends
  BucklingCurve curve = BucklingCurve::c;
  std::string held;  ///< how the beam is taken to be held, in words
  MemberLoad load;
};

/// What the check of a deflection rests on.
struct DeflectionBasis {
  Length alone;                                     ///< w_1, without load factor
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< the same along y and z [m]
  double load_factor = 1.0;
};

/// A check and what it rests on: of a stress that was given and of a deflection something else.
struct CheckResult {
  CheckResult() = default;
  explicit CheckResult(Check of) : check(std::move(of)) {}
  CheckResult(const CheckResult&) = default;
  CheckResult& operator=(const CheckResult&) = default;
  // What a quantity is made of cannot throw, which its library does not say.
  CheckResult(CheckResult&&) noexcept = default;
  CheckResult& operator=(CheckResult&&) noexcept = default;
  ~CheckResult() = default;

  Check check;
  KeptApart<CheckBasis> basis;
  KeptApart<GivenBasis> given;
  KeptApart<DeflectionBasis> deflection;
  KeptApart<PlateBasis> plates;
  KeptApart<PathBasis> path;
  KeptApart<PatchBasis> patch;
  KeptApart<PressedBasis> pressed;
  KeptApart<DistortionBasis> distortion;
  KeptApart<MemberBasis> member;
  /// Of a throat: the least with which all checks of its weld, of a seam those of its place, pass;
  /// not below 3 mm (EN 1993-1-8:2005, 4.5.2(2)). Nothing where none does.
  std::optional<Length> sufficient_throat;
};

/// The first check of a criterion, of checks that stand worst first the worst; or nullptr.
const CheckResult* governing_of(const std::vector<CheckResult>& checks, Criterion criterion);

/// The first check that rests on cut forces, or nullptr.
const CheckResult* first_by_cut_forces(const std::vector<CheckResult>& checks);

/// "yield/4.2-/hole-hub-edge+z": no spaces, so that an id is one word on a command line.
std::string id_of(Criterion criterion, const Station& station, const std::string& point);

class StationExtremes;

/// A stress point over time: the turning points of its stresses, found once for all its checks.
class PointHistory {
 public:
  /// Looks at all of them, which stay.
  PointHistory(const Project& of, const std::vector<SituationHistory>& in, const StressPoint& at,
               StationExtremes* known = nullptr)
      : project(&of), histories(&in), point(&at), extremes(known) {}

  /// Of the direct stress times a factor.
  const Turns& direct(double factor);
  const Turns& shear();
  /// In each situation the largest equivalent stress, load factors not counted.
  std::vector<TurningPoint> largest_von_mises();

  const Project* project;
  const std::vector<SituationHistory>* histories;
  const StressPoint* point;
  StationExtremes* extremes;  ///< of the station, where those of other designs are kept

 private:
  std::map<double, Turns> direct_;
  std::optional<Turns> shear_;
};

/// Elastic verification of a point: the largest equivalent stress in any situation against the
/// yield strength of its plate. Nothing where the point is never stressed.
/// Source: EN 1993-1-1:2005, 6.2.1(5).
std::optional<CheckResult> check_yield(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const StressPoint& point);
std::optional<CheckResult> check_yield(PointHistory& of);

/// Fatigue of a point under direct stress, under shear stress, or under both together: the cycles
/// of all situations, as often as the life asks. Nothing where the stress does not change, and
/// nothing together where one of them does not. Source: EN 1993-1-9:2005, clauses 7 and 8, annex A.
std::optional<CheckResult> check_fatigue(const Project& project,
                                         const std::vector<SituationHistory>& histories,
                                         const StressPoint& point, Criterion criterion);
std::optional<CheckResult> check_fatigue(PointHistory& of, Criterion criterion);

/// Of long records the stresses of that check, as they are to be counted.
std::vector<WholePlace> whole_places_of(const std::vector<SituationHistory>& histories,
                                        const StressPoint& point, Criterion criterion);

/// The largest stress range of a point against 1.5 f_y, direct, or 1.5 f_y/sqrt(3), shear.
/// Source: EN 1993-1-9:2005, 8(1), equation 8.1.
std::optional<CheckResult> check_range(const Project& project,
                                       const std::vector<SituationHistory>& histories,
                                       const StressPoint& point);
std::optional<CheckResult> check_range(PointHistory& of);

/// The throat of a seam between web and flange under the shear flow: directional method with
/// tau_par alone. Source: EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1.
std::optional<CheckResult> check_throat(const Project& project,
                                        const std::vector<SituationHistory>& histories,
                                        const StressPoint& point);

}  // namespace boxbeam
