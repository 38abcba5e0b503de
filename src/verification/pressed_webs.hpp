#pragma once

#include <compare>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "channel_life.hpp"
#include "patch_search.hpp"
#include "pressed_edges.hpp"

namespace boxbeam {

/// Whether a situation has cycles, or is part of one that has.
bool has_cycles(const Project& project, const Situation& situation);

/// Webs of boxes and rectangular tubes that forces press anew at every cycle, in fatigue.
///
///     sigma_z = F/(t (s_s + 2 t_f))   in the web, category 71 (row 8.10/2), rolled 160 (8.10/1)
///     sigma_w = sigma_z t/a           in the throats a of a fillet seam together, 36 (row 8.10/4)
///
/// A seam of which nothing is said is judged as one that penetrates fully, and beside that as
/// fillets. At a place it is that of all forces whose loaded length reaches it: of those that push
/// down at some time, of those that push up, and of all, each with its signs, for they may come by
/// unlike flanges or by the same one; of what turns off from flanges, with what turns off from one.
/// Fillets of diaphragms whose thickness the case says are judged likewise, each by what forces
/// that stand there, or pass, put into it: root, 36 (8.5/3), with the flange across them, or along
/// the web by the same. What moves on loads a place from none to all of it and back at every
/// passage, however far it gets between two instants; beside that the instants count. With it
/// counts the shear stress there (8.3): of the web at its seams, or in the throat; of tubes the one
/// that does most anywhere around the section. Stresses along the beam are judged by details of
/// their own. At an end of the beam it loads the web as far as that goes, but where a diaphragm
/// stands there. Source: EN 1993-1-9:2005+AC:2009, table 8.10, equation 8.3; loaded length EN
/// 1993-1-5:2006, 6.3.
class PressedWebs {
 public:
  PressedWebs(const Project& project, const std::deque<SituationRun>& runs,
              const std::vector<BendingZone>& zones, PatchSearch& search)
      : project_(&project), search_(&search), edges_(project, runs, zones) {}

  /// Whether a patch is one of those: not loads along the beam, whose places are none of their own.
  static bool counts(const Patch& patch);

  /// Learns what the forces of a run press, from instant to instant; `goes_on`: from the one
  /// before.
  void begin(const SituationRun& run);
  void take(Time time, bool goes_on, const std::vector<Patch>& patches);
  void end(Time period);

  /// A check, and whether the case says how forces come in there.
  struct Found {
    CheckResult result;
    bool given = true;
    bool unsaid = false;  ///< taken as fillets where the case does not say what they are
    bool turned = false;  ///< of what turns off from flanges alone
  };
  struct Checks {
    /// Of every web the place that is used most, of each sense, of those where the case says that
    /// and of the others.
    std::vector<Found> found;
    /// Where a web and a flange, which meet in a seam, are pressed at one place, the worst of all
    /// by both, as if in phase, and its use: above 1 what is not judged.
    std::optional<std::pair<Check, double>> square;
  };
  Checks checks() const;
  /// What resists has become another.
  void forget_resistance() { edges_.forget_resistance(); }

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
  /// A place of a web, and the sense of what is looked at.
  struct Place {
    BoxPlate web;
    double s = 0.0;
    double sense = 1.0;                    ///< 0: both
    bool at_high = true;                   ///< of what is known to come by one flange, which
    std::size_t side = 0;                  ///< of what kinks turn off, by which side
    const Diaphragm* diaphragm = nullptr;  ///< its weld with the web,
    bool to_flange = false;                ///< or with the flange beside it

    auto operator<=>(const Place&) const = default;

    bool is_of(const PressedWeb& web_) const {
      return web_.plate == web && web_.diaphragm == diaphragm && web_.weld.to_flange == to_flange;
    }
  };
  /// How much of a place is used.
  struct Used {
    Place place;
    double use = 0.0;
  };
  struct Series {
    std::vector<double> times, values;
  };
  void add(const Patch& patch, std::optional<std::size_t> side, Instant& instant);
  /// Finds the forces that move on from an instant to the next one.
  void follow(Instant& instant, const Instant& next) const;
  bool acts(const Place& place, std::size_t force) const;
  /// Of each force.
  std::vector<bool> acting_on(const Place& place) const;
  /// The stress of a place under some loads.
  static double stress_at(const Place& place, const std::vector<bool>& acting,
                          std::span<const Pressing> forces);
  Series series_at(const Place& place, const Run& run) const;
  void add_passages(const Place& place, const std::vector<bool>& acting, const Instant& before,
                    const Instant& behind, Series& series) const;
  /// Whether it presses plates themselves, not diaphragms alone.
  static bool presses_plates(const Source& of);
  /// Where plates are looked at, all of them alike, for web and flange meet in seams.
  std::vector<double> places() const;
  /// In every sense that there is, of one plate, or of the weld of a diaphragm with it.
  template <class Take>
  void look_at(BoxPlate web, const Diaphragm* diaphragm, bool any_unsaid,
               const std::vector<double>& places, std::vector<Used>& used, const Take& take) const;
  /// The worst of all places like one.
  template <class Take>
  void look(Place place, const std::vector<double>& places, bool any_unsaid,
            std::vector<Used>& used, const Take& take) const;
  std::optional<std::pair<Check, double>> square_of(std::vector<Used> used) const;
  template <class Look>
  void for_all_at(const Place& place, const Look& look) const;
  /// Found once, for it does not depend on what resists.
  const Turns& turns_at(const Place& place) const;
  std::optional<CheckResult> check_at(const Place& place, Turns turns,
                                      bool unsaid_as_fillets) const;
  /// Returns whether a kink turns all that presses there.
  bool name(const Place& place, CheckResult& result) const;

  const Project* project_;
  PatchSearch* search_;
  PressedEdges edges_;
  std::vector<Run> runs_;
  std::vector<Source> sources_;
  bool sides_differ_ = false;  ///< of a kink, at some instant
  mutable std::map<Place, Turns> turns_;
  std::map<std::tuple<std::string, bool, double, std::size_t>, std::size_t> numbers_;
};

}  // namespace boxbeam
