#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Whether a place is one of the ends of the beam.
bool stands_at_end(const TaperedBeam& beam, Length s);

/// Whether bosses or plates lead in what stands at a place, of a section so deep.
bool is_led_in(const TaperedBeam& beam, Length s, Length depth = {});

/// What is to be known of the forces on a beam before they are looked at one by one.
class ForceKinds {
 public:
  explicit ForceKinds(const Project& project) : project_(&project) {}

  void learn(const SituationRun& run);

  /// Whether a joint at an end of the beam clamps it: it holds its turning rigidly, or its couple
  /// is that of a force more than half the beam's depth away, which friction in a pin never is, and
  /// no pin with a lever so long.
  bool clamps(std::string_view name) const { return clamps_.count(name) > 0; }
  /// Whether one at an end of the beam is a joint that leads moments on into another body.
  bool leads_on(std::string_view name) const { return leading_on_.count(name) > 0; }
  /// Whether one moves along the beam, by its number among those of its name.
  bool moves(std::string_view name, std::size_t number) const {
    return moving_.count({std::string(name), number}) > 0;
  }
  bool any_moves() const { return !moving_.empty(); }

 private:
  const Project* project_;
  std::set<std::string, std::less<>> clamps_, leading_on_;
  std::set<std::pair<std::string, std::size_t>> moving_;
};

}  // namespace boxbeam
