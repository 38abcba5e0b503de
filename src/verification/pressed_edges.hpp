#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "channel_life.hpp"

namespace boxbeam {

/// A place along the edge by which a force comes into a web.
struct PressedEdge {
  double s = 0.0;  ///< [m]
  BoxPlate web = BoxPlate::left_web;
  bool unsaid_as_fillets = false;  ///< a seam of which nothing is said, all of one as thick as it

  bool operator<(const PressedEdge& other) const {
    return std::tie(s, web, unsaid_as_fillets) <
           std::tie(other.s, other.web, other.unsaid_as_fillets);
  }
};

/// What resists a force that comes in there at every cycle, and the shear stress that counts beside
/// it. Sources: `PressedWebs`.
class PressedEdges {
 public:
  PressedEdges(const Project& project, const std::deque<SituationRun>& runs,
               const std::vector<BendingZone>& zones)
      : project_(&project), runs_(&runs), zones_(&zones) {}

  /// As small as no stress is one (`no_stress_at`), of mild steel [Pa].
  static constexpr double no_stress = 235.0;

  struct Resisting {
    std::shared_ptr<const BeamDetail> detail;
    Length thickness, throat;  ///< no throat: the web
  };
  /// Where two segments meet the side that resists less, by the stress in its web.
  const Resisting& at(const PressedEdge& edge) const;
  /// Fillets of diaphragms.
  static const Resisting& weld();

  /// Whether shear there can do damage with the loads taken k times: by the largest cut forces.
  bool shear_may_count(const PressedEdge& edge, double k) const;
  /// The cycles of the shear stresses there, each one of them with what resists it.
  const std::vector<LifeChannel>& shear_at(const PressedEdge& edge) const;

  /// What the case says of it has become another.
  void forget_resistance() { shear_.clear(); }

 private:
  Resisting resisting_on(const Station& at, BoxPlate plate, bool unsaid_as_fillets) const;
  /// A place where shear is looked at.
  struct Sheared {
    Station station;
    StressInfluence influence;
  };
  /// Of the seams of a plate on both sides of a place; of tubes all around the section.
  std::vector<Sheared> sheared_at(const PressedEdge& edge) const;
  /// The throats of the seams of a section, or all its points: once for all its plates.
  const std::vector<StressPoint>& sheared_points_at(const Station& station, bool seamed) const;
  SnCurve shear_curve_at(const PressedEdge& edge) const;

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const std::vector<BendingZone>* zones_;
  mutable std::map<PressedEdge, Resisting> resisting_;
  mutable std::map<std::pair<double, Side>, std::vector<StressPoint>> points_;
  mutable std::map<PressedEdge, std::vector<LifeChannel>> shear_;
  mutable std::map<PressedEdge, double> most_shear_;  ///< [Pa]
};

}  // namespace boxbeam
