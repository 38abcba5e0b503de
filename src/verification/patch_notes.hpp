#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "patch_search.hpp"
#include "pressed_webs.hpp"

namespace boxbeam {

/// Less than this part of the yield strength across a flange is none.
inline constexpr double hardly_bent = 0.1;
/// The largest moment at the edge of a plate by a force on it: clamped along that edge it is F/pi
/// wherever the force stands, by w = F x^2 xi^2/(2 pi D (xi^2 + y^2)) beside it (Michell's
/// solution; a second clamped edge lessens it, to 0.168 F in the middle of a strip), and half as
/// much again (0.509 F) where the force stands on the free edge of a strip. Sources: Timoshenko,
/// Woinowsky-Krieger, Theory of Plates and Shells, sections 44 and 50; Jaramillo, J. Appl. Mech. 17
/// (1950), for the cantilever.
inline constexpr double bent_between = 0.3183, bent_outside = 0.509;
/// Of a strip clamped at both ends, b apart, under a load q along the plate at a third of it:
/// 4/27 q b, the largest that there is.
inline constexpr double bent_strip = 4.0 / 27.0;
/// The cut-off of category 36 with gamma_Mf = 1.35.
inline constexpr Stress hardly_changes = 0.405 * 36e6 / 1.35 * pascal;

/// A use and where that is, by the name of a force.
using UseByName = std::map<std::string, std::pair<double, Length>>;

/// What forces that come into webs do beside what is judged: they bend a flange across on which
/// they stand between webs, or that turns off, and they press webs anew at every cycle.
class PatchNotes {
 public:
  /// `steps`: of the beam; `counted`: by which what presses webs is judged in fatigue, or nothing.
  PatchNotes(const Project& project, std::vector<FlangeStep> steps, const PressedWebs* counted);

  /// What plates that end have to lead on at an instant. `all`: all patches of the instant follow.
  void take_instant(const CutForceDiagram& diagram, const Situation& situation, bool all);

  /// How the webs bear a patch at an instant of a situation.
  void take(const Patch& patch, const std::vector<Borne>& ways, const Situation& situation,
            bool all);

  /// A moment about the beam's y or z that comes in between its ends, by forces that are not known.
  void take_couple(const std::string& name, Length s, Moment couple);
  /// A moment at an end that a joint leads on into a body whose plates are not known to be in line.
  void take_led_on(const std::string& name, Length s, Moment moment);
  /// Where slender webs are held without a diaphragm, or along y the plates that are webs of that.
  void take_bare_support(Length s, bool along_z);

  std::vector<NotJudged> not_judged() const;
  /// Of boxes in space, of each force the largest.
  std::vector<IntoDiaphragm> into_diaphragms() const;
  /// What bends a flange across by more than its strength beside the beam's own stress, and where
  /// one ends on bare webs.
  std::vector<Gate> gates() const;

 private:
  /// A flange under a force: the stress across it, over its strength, where that with the beam's
  /// own makes it yield most.
  struct BentFlange {
    Length s, beside;
    double use = 0.0;
    bool kinked = false, again = false;  ///< again: in cycles that a seam of it may feel
    bool along_z = true;
    double with_own = 0.0;  ///< sqrt(u^2 + eta_1^2 + u eta_1): on the face where signs are unlike
  };
  /// Of a web under a force over time, tension positive [Pa]; places [m].
  struct PressedWeb {
    static constexpr double unbounded = std::numeric_limits<double>::infinity();
    double least = unbounded, most = -unbounded, from = unbounded, to = -unbounded;
    bool unsaid = false;
    std::size_t seen = 0;  ///< at so many instants

    /// Of several at one instant, as of all lengths of a load along the beam, that of the largest
    /// size counts.
    void take(double stress, std::size_t instant);
    /// What is known with the last instant.
    PressedWeb whole() const;

   private:
    std::size_t at_ = 0;
    double now_ = 0.0;
  };

  using PressedByName = std::map<std::pair<std::string, bool>, PressedWeb>;
  /// What of them changes at every cycle.
  struct Anew {
    std::vector<std::string> names;
    double most = 0.0;  ///< [Pa]
    bool unsaid = false;
  };
  Anew anew_of(const PressedByName& all) const;

  static std::string words_of(const BentFlange& of);
  /// The plate of a diaphragm that leads to the webs what turns off from flanges.
  void take_plate_between(const Patch& patch, const Borne& way, double load_factor);
  void take_into(const Patch& patch, const Borne& way, IntoDiaphragm::Part part, double use,
                 double load_factor);
  void take_welds(const Patch& patch, const Borne& way, const StiffenerWeld& weld,
                  double load_factor);
  /// A diaphragm that leads to the webs what stands between them.
  void take_diaphragm(const Patch& patch, const Borne& way, double load_factor);
  void take_flange(const Patch& patch, const Borne& way, double load_factor, bool again);
  /// The webs between both beams of a knee, which what turns off from a flange shears.
  void take_corner(const Patch& patch, const Borne& way, double load_factor);
  void keep(const std::string& name, const BentFlange& of);
  void take_cycles(const Patch& patch, const std::vector<Borne>& ways, bool all);

  const Project* project_;
  const PressedWebs* counted_;
  std::vector<FlangeStep> steps_;
  std::size_t instants_ = 0;      ///< of situations with cycles
  std::vector<double> at_steps_;  ///< their largest forces [N]
  /// Diaphragms: their plates in shear, what presses their edges, strips beside access holes.
  UseByName sheared_, edges_, bridged_;
  std::map<std::tuple<const Diaphragm*, IntoDiaphragm::Part, std::string>, IntoDiaphragm> into_;
  UseByName corners_;                       ///< of knees in shear
  std::map<std::string, BentFlange> bent_;  ///< by the name of the force
  PressedByName pressed_, welded_;          ///< and along z; webs, and welds of diaphragms
  using MomentByName = std::map<std::string, std::pair<Moment, Length>>;
  MomentByName couples_, led_on_;
  std::set<std::string> bare_, bare_along_y_;
};

}  // namespace boxbeam
