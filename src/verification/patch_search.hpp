#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/verification/plate_checks.hpp"

namespace boxbeam {

/// A force across the beam, or several so close that a web feels them together.
struct Patch {
  std::string name;
  Length s;
  bool along_z = true;  ///< borne by the webs; else by the flanges
  Force force;          ///< along its axis, signed
  Moment couple;        ///< about the beam's axis
  Length stiff_length;
  bool given = true;                     ///< the case says how it comes in
  const Diaphragm* diaphragm = nullptr;  ///< that takes it
  bool opposed = false;                  ///< one of the other sense is near

  /// The same from instant to instant.
  auto key() const {
    return std::tuple(name, along_z, force.value() > 0.0, given, diaphragm != nullptr);
  }
};

using PatchKey = decltype(Patch().key());

/// How one of the webs bears a patch.
struct Borne {
  PatchBasis basis;
  BoxPlate plate = BoxPlate::left_web;
};

/// What forces do to the webs that they come into, of the loads of one instant.
class PatchSearch {
 public:
  PatchSearch(const Project& project, const std::vector<BendingZone>& zones);

  /// Learns which joints at the ends of the beam clamp it: their couples are those of forces more
  /// than half its depth away, which friction in a pin never is.
  void learn_clamps(const SituationRun& run);

  bool has_something_to_do() const;

  /// What comes in under these loads.
  std::vector<Patch> patches_of(const BeamLoads& loads);

  /// How a web bears a patch, of all webs and sides the one that is used most; nothing where none
  /// is judged.
  std::optional<Borne> worst_of(const Patch& patch, const CutForceDiagram& diagram);

  /// Whether a force comes into a slender path where no diaphragm takes it: it is not judged.
  bool comes_into_path(const Patch& patch) const;
  /// Whether one comes into a slender path at a diaphragm, whose bearing is not judged.
  bool bears_on_path(const Patch& patch) const;

  /// On all loads, without the situation's own.
  double factor_of(const PatchBasis& basis) const;
  double eta_1_of(const PatchBasis& basis) const;

  /// Why an introduction of the case is not judged; "" where it is.
  std::string obstacle_of(const LoadIntroduction& of);

 private:
  struct Slender {
    bool along_z = false, along_y = false;
    bool path = false;  ///< a thin-walled one, whose walls are not judged
  };

  /// The section of a station by its effective widths and, where these do not judge it, by reduced
  /// stresses.
  struct JudgedBox {
    std::shared_ptr<const EffectiveBox> box;
    std::vector<std::shared_ptr<const ReducedPlate>> reduced;
  };

  std::optional<FourWalls> walls_at(const Station& station) const;

  bool is_at_end(Length s) const;

  /// By the introduction of the narrowest stretch.
  const LoadIntroduction* introduction_at(Length s) const;

  /// Whether the patch is to be looked at.
  bool say_how_it_comes_in(Patch& patch);

  /// Adds those that stand close together as one, and says which are opposed.
  void add_groups(std::vector<Patch>& patches) const;

  Length depth_at(const Patch& patch) const;

  const JudgedBox& box_at(const Station& station);

  std::vector<std::shared_ptr<const ReducedPlate>> reduced_at(const Station& station,
                                                              const Section& section,
                                                              const FourWalls& walls) const;

  std::vector<Borne> ways_at(const Patch& patch, const Station& station, const JudgedBox& judged,
                             const CutForceDiagram& diagram) const;

  /// Of webs that are stressed alike the one there is.
  static std::shared_ptr<const ReducedPlate> reduced_plate_of(const JudgedBox& judged,
                                                              BoxPlate plate);

  void bear_by_effective_widths(const PatchedWeb& web, PatchBasis& basis) const;

  void bear_by_reduced_stresses(const std::shared_ptr<const ReducedPlate>& plate, PatchedWeb web,
                                bool onto_high, PatchBasis& basis) const;

  /// A web as a force comes to it, in every way that may be meant.
  std::vector<PatchedWeb> webs_of(const FourWalls& walls, BoxPlate plate, const Patch& patch,
                                  const Station& station) const;

  /// From the stiff length to the nearer end of the beam that no diaphragm keeps off.
  std::optional<Length> distance_to_end(const Patch& patch) const;

  BearingStiffener stiffener_of(const FourWalls& walls, BoxPlate plate, const Diaphragm& diaphragm,
                                const Station& station) const;

  const Project* project_;
  const std::vector<BendingZone>* zones_;
  std::vector<Slender> slender_;  ///< by segment
  std::set<std::string> clamps_;
  std::set<const LoadIntroduction*> used_;  ///< by which a force has come in
  std::map<std::pair<double, Side>, JudgedBox> boxes_;
};

}  // namespace boxbeam
