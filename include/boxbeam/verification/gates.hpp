#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// Something to be looked at before elastic stresses are believed.
struct Gate {
  std::string segment;
  std::string plate;    ///< "flange", "web"; "" where it is the whole section
  std::string finding;  ///< what is the matter, with its numbers and clause
  /// Whether the stresses computed mean nothing here: no check that passes counts.
  bool blocks = false;
};

/// What keeps stresses from being believed. Section class with the stress that is there (EN
/// 1993-1-1, table 5.2 and 5.5.2(9); class 4 with its effective width, EN 1993-1-5, 4.4), need of a
/// shear buckling check (EN 1993-1-5, 5.1(2)), shear lag (EN 1993-1-5, 3.1; reduces the stresses'
/// flanges, does not block), stress above yield. Each plate of a segment once, where it is worst.
/// In space both webs under their own stress of N, M_y and M_z, the flanges as in the plane evenly
/// compressed, all four plates in shear (V_y, T). A web counts as compressed in an instant where
/// its compression is more than 1 % of its largest stress. Where the beam as a member may buckle
/// (N/N_cr above 0.04) the limits of table 5.2 hold as they are, 5.5.2(10). Of plates that are
/// judged by a route of EN 1993-1-5 (`slender_plates_at`) neither class nor shear stops a check,
/// but for beams that may buckle as members; their fatigue is stopped where less than half of a
/// plate is effective, 2.2(5), or it breathes, EN 1993-2, 7.4. Paths stop, too, of which a slender
/// outstand is sheared or shear lag reduces a flange. Forces that come into webs are looked at
/// elsewhere (`check_patches`).
class PlateGates {
 public:
  /// Looks at what is given, which stays.
  PlateGates(const Project& project, const std::vector<BendingZone>& zones,
             const ModelChoice& model);

  /// Looks at the plates of a station.
  void look_at(const Station& station, const std::vector<SituationHistory>& histories);

  /// Looks at the stresses that were checked.
  void look_at(const std::vector<CheckResult>& checks);

  std::vector<Gate> gates() const;

 private:
  /// Of all gates of a kind on a plate of a segment, the worst is kept.
  void add(const std::string& kind, Gate gate, double excess);
  void look_at_class(const std::string& segment, const Profile& profile,
                     const PlateMaterials& materials, bool alike, const AreaSums& sums,
                     const std::vector<SituationHistory>& histories, const std::string& obstacle,
                     bool judged);
  /// slender_plate_gates.cpp
  void look_at_slender(const std::string& segment, const SlenderPlates& plates,
                       const AreaSums& sums, const std::vector<SituationHistory>& histories);
  void look_at_slender(const std::string& segment, const SlenderPath& path,
                       const std::vector<SituationHistory>& histories);
  /// `counts`: in the effective section.
  void look_at_path_lag(const std::string& segment, const Station& station,
                        const PathSection& section, bool counts);
  void add_effective_area(const std::string& segment, const std::string& plate, double share);
  void add_breathing(const std::string& segment, const std::string& plate, double breathing,
                     double ratio);
  void look_at_shear_lag(const std::string& segment, const std::string& plate,
                         const std::optional<ShearLag>& lag);

  const Project* project_;
  const std::vector<BendingZone>* zones_;
  bool member_buckles_;
  std::map<std::string, std::pair<Gate, double>> worst_;
  std::vector<std::string> order_;
};

/// The largest c/t of a web at a station, over its limit of class 3 under its stress (5.5.2(9)); 0
/// where all would do in even compression. By it the search finds the place that PlateGates looks
/// at.
double class_3_use_at(const Project& project, const Station& station,
                      const std::vector<SituationHistory>& histories);

}  // namespace boxbeam
