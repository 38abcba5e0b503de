#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "patch_search.hpp"

namespace boxbeam {

/// Less than this part of the yield strength across a flange is none.
inline constexpr double hardly_bent = 0.1;
/// The moment of a long plate clamped at both edges at one of them, by a force in its middle.
/// Source: Timoshenko, Woinowsky-Krieger, Theory of Plates and Shells, section 44.
inline constexpr double bent_by_force = 0.168;
/// The cut-off of category 36 with gamma_Mf = 1.35.
inline constexpr Stress hardly_changes = 0.405 * 36e6 / 1.35 * pascal;

/// What forces that come into webs do beside what is judged: they bend a flange across on which
/// they stand between webs, or that turns off, and they press webs anew at every cycle.
class PatchNotes {
 public:
  explicit PatchNotes(const Project& project);

  /// Whether a plate ends where another begins elsewhere.
  bool has_steps() const { return !steps_.empty(); }
  /// What plates that end have to lead on at an instant.
  void take_steps(const CutForceDiagram& diagram, double load_factor);

  /// How the webs bear a patch at an instant of a situation.
  void take(const Patch& patch, const std::vector<Borne>& ways, const Situation& situation);

  std::vector<NotJudged> not_judged() const;
  /// What bends a flange across by more than its strength, and where one ends on bare webs.
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
  void take_cycles(const Patch& patch, const std::vector<Borne>& ways, bool again);

  const Project* project_;
  std::vector<FlangeStep> steps_;
  std::vector<double> at_steps_;                                ///< their largest forces [N]
  std::map<std::string, BentFlange> bent_;                      ///< by the name of the force
  std::map<std::pair<std::string, bool>, PressedWeb> pressed_;  ///< and along z
};

}  // namespace boxbeam
