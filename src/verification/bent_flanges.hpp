#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "patch_search.hpp"

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

/// The web that bears so, or nullptr.
const PatchedWeb* web_in(const Borne& way);

/// The flanges of a section with two webs, across what comes in.
struct Flanges {
  Length high, low, half_high, half_low;  ///< the webs: middles and half their thicknesses
  Length thickness;                       ///< of the weaker one
  Stress strength;

  Length apart() const { return high - low; }
  bool between(Length place) const { return place < high && place > low; }
  /// The faces of both webs, the nearer one; below zero above one.
  Length beside(Length place) const {
    return std::min(Length(abs(place - high) - half_high), Length(abs(place - low) - half_low));
  }
  /// The one of a force's places that is farther from the webs.
  Length farthest_place(const Patch::Standing& of) const {
    const auto& [one, other] = of.places;
    return beside(one) > beside(other) ? one : other;
  }
};

/// Nothing of sections without two webs.
std::optional<Flanges> flanges_across(const Patch& patch, const Borne& way);

/// What forces do to flanges on which they stand beside webs, or which turn off: they bend them
/// across, which is not judged.
class BentFlanges {
 public:
  explicit BentFlanges(const Project& project) : project_(&project) {}

  /// A patch and how a web bears it; `again`: at every cycle.
  void take(const Patch& patch, const Borne& way, double load_factor, bool again);

  /// What bends a flange across by more than its strength beside the beam's own stress.
  template <class Add>
  void add_gates(const Add& add) const {
    for (const auto& [name, of] : bent_) {
      if (of.with_own > 1.0)
        add(of.s, "flange under " + name + " at s = " + to_text(Station{of.s, Side::both}) +
                      " m: " + words_of(of));
    }
  }
  /// Of each kind one, by its worst: a verdict is to be read.
  void add_to(std::vector<NotJudged>& found) const;

 private:
  /// A flange under a force: the stress across it, over its strength, where that with the beam's
  /// own makes it yield most.
  struct Bent {
    Length s, beside;
    double use = 0.0;
    bool kinked = false, again = false;  ///< again: in cycles that a seam of it may feel
    bool along_z = true;
    double with_own = 0.0;  ///< sqrt(u^2 + eta_1^2 + u eta_1): on the face where signs are unlike
  };
  static std::string words_of(const Bent& of);

  const Project* project_;
  std::map<std::string, Bent> bent_;  ///< by the name of the force
};

}  // namespace boxbeam
