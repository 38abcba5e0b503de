#pragma once

#include <set>
#include <string>
#include <vector>

#include "bent_flanges.hpp"
#include "loaded_diaphragms.hpp"
#include "most_by_name.hpp"
#include "pressed_anew.hpp"

namespace boxbeam {

/// What forces that come into webs do beside what is judged: they bend a flange across on which
/// they stand between webs, or that turns off, and they press webs anew at every cycle.
class PatchNotes {
 public:
  /// `steps`: of the beam; `counted`: what presses webs of boxes is judged in fatigue.
  PatchNotes(const Project& project, std::vector<FlangeStep> steps, bool counted);

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
  std::vector<IntoDiaphragm> into_diaphragms() const { return diaphragms_.into(); }
  /// What bends a flange across by more than its strength beside the beam's own stress, and where
  /// one ends on bare webs.
  std::vector<Gate> gates() const;

 private:
  /// The webs between both beams of a knee, which what turns off from a flange shears.
  void take_corner(const Patch& patch, const Borne& way, double load_factor);

  const Project* project_;
  std::vector<FlangeStep> steps_;
  std::vector<double> at_steps_;  ///< their largest forces [N]
  BentFlanges flanges_;
  LoadedDiaphragms diaphragms_;
  PressedAnew pressed_;
  UseByName corners_;  ///< of knees in shear
  MostByName<Moment> couples_, led_on_;
  std::set<std::string> bare_, bare_along_y_;
};

}  // namespace boxbeam
