#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/verification/situation_run.hpp"

/// Webs of boxes and tubes by their stresses over time, and how near these come to class 4.
namespace boxbeam {

/// A plate of a box or tube between its neighbours, seen as a web: what bends it in its plane.
struct StressedWeb {
  std::string name;
  SectionPlace low, high;  ///< ends of its clear width, on its mid-line
  Length thickness;
  PlateKind kind = PlateKind::wall;
  bool flange = false;

  Length depth() const { return flange ? high.y - low.y : high.z - low.z; }
};

/// In the plane the webs, one where both are `alike`; in space all four plates.
std::vector<StressedWeb> stressed_webs_of(const Profile& profile, bool in_space, bool alike);

/// Whether the webs of a section are stressed alike in the plane and are of one material.
bool webs_are_alike(const Section& section, const PlateMaterials& materials);

/// The limit of class 3 as it is for a part that is not stressed up to its yield strength: epsilon
/// grows by sqrt((f_y/gamma_M0)/sigma_com,Ed), EN 1993-1-1, 5.5.2(9); but not where members are
/// verified for buckling, 5.5.2(10).
class Class3Limit {
 public:
  Class3Limit(const StrengthDemand& demand, Stress yield, bool member_buckles);

  double epsilon() const { return epsilon_; }
  double at(double psi, double design_stress) const;

 private:
  double per_stress_, epsilon_;
  bool member_buckles_;
};

/// The stress over a web that comes nearest to its limit of class 3.
struct WorstStress {
  double psi = -1.0;
  double most = 0.0;   ///< compression [Pa], with load factor and required safety factor
  double limit = 0.0;  ///< of c/t; 0 where nothing is compressed
};

/// By the stresses at both ends of a web, which count `required` times. Compression below a
/// hundredth of the largest stress has no class.
WorstStress worst_over(const std::vector<SituationHistory>& histories,
                       const StressInfluence& at_low, const StressInfluence& at_high,
                       double required, const Class3Limit& limit);

}  // namespace boxbeam
