#pragma once

#include <compare>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "patch_search.hpp"

namespace boxbeam {

/// Whether a situation has cycles, or is part of one that has.
bool has_cycles(const Project& project, const Situation& situation);

/// A place of a web, and the sense of what is looked at.
struct PressedPlace {
  BoxPlate web;
  double s = 0.0;
  double sense = 1.0;                    ///< 0: both
  bool at_high = true;                   ///< of what is known to come by one flange, which
  std::size_t side = 0;                  ///< of what kinks turn off, by which side
  const Diaphragm* diaphragm = nullptr;  ///< its weld with the web,
  bool to_flange = false;                ///< or with the flange beside it

  auto operator<=>(const PressedPlace&) const = default;

  bool is_of(const PressedWeb& web_) const {
    return web_.plate == web && web_.diaphragm == diaphragm && web_.weld.to_flange == to_flange;
  }
};

/// What forces that come in press of plates, and of welds of diaphragms, from instant to instant of
/// all runs. What moves on loads a place from none to all of it and back at every passage, however
/// far it gets between two instants; beside that the instants count.
class PressingForces {
 public:
  PressingForces(const Project& project, PatchSearch& search)
      : project_(&project), search_(&search) {}

  /// Whether a patch is one of those: not loads along the beam, whose places are none of their own.
  static bool counts(const Patch& patch);

  /// Learns what the forces of a run press, from instant to instant; `goes_on`: from the one
  /// before.
  void begin(const SituationRun& run);
  void take(Time time, bool goes_on, const std::vector<Patch>& patches);
  void end(Time period);

  /// Whether any situation has cycles.
  bool have_cycles() const;
  /// Where plates are looked at, all of them alike, for web and flange meet in seams: where forces
  /// stand, and some along the ways of those that move, of all of a name together; where the
  /// lengths overlap that forces load which stand apart, their ends.
  std::vector<double> places() const;
  /// A plate, or the weld of a diaphragm with it, in every sense in which anything presses it; at
  /// no place yet.
  std::vector<PressedPlace> senses_of(BoxPlate web, const Diaphragm* diaphragm) const;
  /// Of the stress there over all runs. Found once, for it does not depend on what resists.
  const Turns& turns_at(const PressedPlace& place) const;
  /// What presses there.
  struct By {
    std::vector<std::string> names;
    const PressedWeb* most = nullptr;
    bool turned = true;  ///< off from flanges, all of it
  };
  By by(const PressedPlace& place) const;

 private:
  /// A force at an instant.
  struct Pressing {
    std::size_t force = 0;                 ///< its number
    double s = 0.0;                        ///< [m]
    std::vector<PressedWeb> webs, welds;   ///< of diaphragms, where it is or may come to be
    double before = 0.0, behind = 0.0;     ///< of it what all these reach at most [m]
    std::optional<std::size_t> next = {};  ///< of the next instant's, where it has moved on

    const std::vector<PressedWeb>& of(const Diaphragm* diaphragm) const {
      return diaphragm != nullptr ? welds : webs;
    }
  };
  struct Instant {
    Time time;
    bool goes_on = false;  ///< from the one before
    std::vector<Pressing> forces;
    double from = 1e300, to = -1e300;  ///< between which all they reach lies [m]
  };
  struct Run {
    std::size_t situation = 0;
    bool counted = false;
    bool closed = true;
    std::vector<Instant> instants;
  };
  /// One force of all runs.
  struct Source {
    std::string name;
    double from = 0.0, to = 0.0;        ///< its way [m]
    double before = 0.0, behind = 0.0;  ///< of it what is loaded at most [m]
    /// Least and most of each web, or of the weld of a diaphragm with it [Pa].
    std::map<std::pair<BoxPlate, const Diaphragm*>, std::pair<double, double>> presses;
    std::optional<bool> at_high;      ///< by the flange at which end of the section, where known
    std::optional<std::size_t> side;  ///< of a kink: by the forces on which side of it
  };
  struct Series {
    std::vector<double> times, values;
  };
  void add(const Patch& patch, std::optional<std::size_t> side, Instant& instant);
  /// Finds the forces that move on from an instant to the next one.
  void follow(Instant& instant, const Instant& next) const;
  bool acts(const PressedPlace& place, std::size_t force) const;
  /// Of each force.
  std::vector<bool> acting_on(const PressedPlace& place) const;
  /// The stress of a place under some loads.
  static double stress_at(const PressedPlace& place, const std::vector<bool>& acting,
                          std::span<const Pressing> forces);
  Series series_at(const PressedPlace& place, const Run& run) const;
  void add_passages(const PressedPlace& place, const std::vector<bool>& acting,
                    const Instant& before, const Instant& behind, Series& series) const;
  /// Whether it presses plates themselves, not diaphragms alone.
  static bool presses_plates(const Source& of);

  const Project* project_;
  PatchSearch* search_;
  std::vector<Run> runs_;
  std::vector<Source> sources_;
  bool sides_differ_ = false;  ///< of a kink, at some instant
  mutable std::map<PressedPlace, Turns> turns_;
  std::map<std::tuple<std::string, bool, double, std::size_t>, std::size_t> numbers_;
};

}  // namespace boxbeam
