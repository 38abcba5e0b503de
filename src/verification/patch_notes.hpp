#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "patch_search.hpp"
#include "pressed_webs.hpp"

namespace boxbeam {

/// What forces that come into webs do beside what is judged: they bend a flange across on which
/// they stand between webs, or that turns off, and they press webs anew at every cycle.
class PatchNotes {
 public:
  /// `counted`: by which what presses webs is judged in fatigue, or nothing.
  PatchNotes(const Project& project, const PressedWebs* counted)
      : project_(&project), counted_(counted) {}

  /// How the webs bear a patch at an instant of a situation.
  void take(const Patch& patch, const std::vector<Borne>& ways, const Situation& situation);

  std::vector<NotJudged> not_judged() const;
  /// What bends a flange across by more than its strength.
  std::vector<Gate> gates() const;

 private:
  /// A flange under a force: the stress across it, over its strength, where that is largest.
  struct BentFlange {
    Length s, beside;
    double use = 0.0;
  };
  /// Of a web under a force over time, tension positive [Pa]; places [m].
  struct PressedWeb {
    double least = 0.0, most = 0.0, from = 0.0, to = 0.0;
    bool known = false;
  };

  static std::string words_of(const BentFlange& of);
  void take_flange(const Patch& patch, const Borne& way, double load_factor);
  void take_cycles(const Patch& patch, const std::vector<Borne>& ways);

  const Project* project_;
  const PressedWebs* counted_;
  std::map<std::string, BentFlange> bent_;                      ///< by the name of the force
  std::map<std::pair<std::string, bool>, PressedWeb> pressed_;  ///< and along z
};

}  // namespace boxbeam
