#pragma once

#include <array>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "second_order_growth.hpp"

namespace boxbeam {

/// How much of the yield strength of a beam its cut forces use at the places that are compared,
/// each of these shares the largest of them: what checks of members are made of.
class YieldShares {
 public:
  YieldShares(const Project& project, std::vector<ComparedPlace> places);

  const std::vector<ComparedPlace>& places() const { return places_; }

  /// Compression over A f_y.
  double compression(const CutForceDiagram& diagram) const;
  /// M_y/(W_y f_y); the same of the fibre stresses of some instants, taken `factor` times.
  double bending(const CutForceDiagram& diagram) const;
  double bending(const Compared& of, double factor) const;
  /// M_z/(W_z f_y).
  double bending_across(const CutForceDiagram& diagram) const;
  /// What N off the centroid and unlike axes add to M_y/W_y + M_z/W_z, over f_y.
  double excess(const CutForceDiagram& diagram) const;

  /// Stresses of the other plane, whose bending is by W_y, by that plane's own modulus.
  Compared with_modulus_across(Compared of) const;

 private:
  /// Stress per N, M_y and M_z at a point, less N/A.
  using ExcessPoint = std::array<double, 3>;
  struct Strength {
    double yield = 0.0;           ///< of the flanges [Pa]
    double modulus_across = 0.0;  ///< W_z [m^3]
    std::vector<ExcessPoint> excess;
  };
  static std::vector<ExcessPoint> excess_points_of(const Section& section);
  Strength strength_of(const Section& section, Length s) const;
  /// The largest over all places of what `use` says of one and its cut forces.
  template <class Use>
  double largest(const CutForceDiagram& diagram, const Use& use) const;

  const Project* project_;
  std::vector<ComparedPlace> places_;
  std::vector<Strength> strengths_;  ///< of each place
};

}  // namespace boxbeam
