#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "section_stress.hpp"

/// The oracle's own rules of what resists where.
namespace oracle {

/// The detail for direct stress that holds at a side of a station, and whether compression counts
/// less there: the weakest of the stretches that this side lies in and that are meant for such a
/// place, or that of the whole beam.
struct Resisting {
  const boxbeam::BeamDetail* detail = nullptr;
  bool compression_reduced = false;
  double range_factor =
      1.0;  ///< on the stress whose range is limited: the largest of all stretches
};

class Rules {
 public:
  explicit Rules(const boxbeam::Project& project);

  /// `plate` decides the size effect of the details that compete; along a flat its weld is one of
  /// them, by hand, category 100 (EN 1993-1-9, row 8.2/5).
  Resisting detail_at(const boxbeam::Station& station, PlaceKind kind, double plate, bool at_flat);

  /// The curve of a detail in a plate: (25 mm/t)^0.2 where its row has the size effect of a
  /// transverse butt weld (EN 1993-1-9, 7.2.2), and as the case has it elsewhere.
  const boxbeam::SnCurve& curve_of(const boxbeam::Detail& detail, double plate);

  /// Strength [Pa] of the curve at a number of cycles of one size, gamma_Mf not applied.
  double strength_at(const boxbeam::Detail& detail, double plate, double cycles);

  /// f_y of a plate [Pa].
  double yield_strength(double plate) const;
  /// f_u of a plate [Pa].
  double tensile_strength(double plate) const;

 private:
  const boxbeam::Project* project_;
  boxbeam::BeamDetail along_flat_;
  std::map<std::pair<const boxbeam::Detail*, double>, boxbeam::SnCurve> curves_;
  std::map<std::tuple<const boxbeam::Detail*, double, double>, double> strengths_;
};

/// Utilisation of a pin in double shear under a force [N]: EN 1993-1-8, table 3.10.
double pin_utilisation(double force, const boxbeam::PinInput& pin);

/// Utilisation of a rod under a compression or, negative, a tension [N]: EN 1993-1-1, 6.3.1, 6.2.3.
double rod_utilisation(double compression, const boxbeam::RodInput& rod);

}  // namespace oracle
