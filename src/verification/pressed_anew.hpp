#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "patch_search.hpp"
#include "pressing_forces.hpp"

namespace boxbeam {

/// Webs, and welds of diaphragms, that forces press anew at every cycle and no check of fatigue
/// counts.
class PressedAnew {
 public:
  /// `counted`: what presses webs of boxes is judged in fatigue.
  PressedAnew(const Project& project, bool counted) : project_(&project), counted_(counted) {}

  /// All patches of an instant of a situation with cycles follow.
  void begin_instant() { ++instants_; }
  /// How the webs bear a patch; `all`: of an instant of which all patches follow.
  void take(const Patch& patch, const std::vector<Borne>& ways, bool all);

  void add_to(std::vector<NotJudged>& found) const;

 private:
  /// A web under a force over time, tension positive [Pa]; places [m].
  struct Pressed {
    static constexpr double unbounded = std::numeric_limits<double>::infinity();
    double least = unbounded, most = -unbounded, from = unbounded, to = -unbounded;
    bool unsaid = false;
    std::size_t seen = 0;  ///< at so many instants

    /// Of several at one instant, as of all lengths of a load along the beam, that of the largest
    /// size counts.
    void take(double stress, std::size_t instant);
    /// What is known with the last instant.
    Pressed whole() const;

   private:
    std::size_t at_ = 0;
    double now_ = 0.0;
  };
  using PressedByName = std::map<std::pair<std::string, bool>, Pressed>;  ///< and along z
  /// What of them changes at every cycle.
  struct Changing {
    std::vector<std::string> names;
    double most = 0.0;  ///< [Pa]
    bool unsaid = false;
  };
  Changing changing_in(const PressedByName& all) const;

  const Project* project_;
  bool counted_;
  std::size_t instants_ = 0;
  PressedByName webs_, welds_;
};

}  // namespace boxbeam
