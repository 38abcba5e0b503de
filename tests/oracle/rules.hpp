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
  /// them, by hand, category 100 (EN 1993-1-9, row 8.2/5), and at a diaphragm its fillets, with
  /// the legs of its throat, or as long as it is thick: 80 up to 50 mm between their toes, 71
  /// beyond (row 8.4/8).
  Resisting detail_at(const boxbeam::Station& station, PlaceKind kind, double plate, bool at_flat);

  /// The curve of a detail in a plate: (25 mm/t)^0.2 where its row has the size effect of a
  /// transverse butt weld (EN 1993-1-9, 7.2.2), and as the case has it elsewhere.
  const boxbeam::SnCurve& curve_of(const boxbeam::Detail& detail, double plate);

  /// Strength [Pa] of the curve at a number of cycles of one size, gamma_Mf not applied.
  double strength_at(const boxbeam::Detail& detail, double plate, double cycles);

  /// f_y of a plate of a thickness in a segment [Pa].
  double yield_strength(std::size_t segment, boxbeam::PlateKind wall, double plate) const;
  /// f_y where a place is: of the weaker plate where one ends at another of another steel.
  double yield_strength(std::size_t segment, const Place& place) const;
  /// f_u/beta_w of the weaker of the plates that a throat joins [Pa].
  double weld_strength(std::size_t segment, const Place& throat) const;

 private:
  /// The last that [[part_materials]] say of a plate of a segment.
  const boxbeam::Material& material_of(std::size_t segment, boxbeam::PlateKind wall) const;

  const boxbeam::Project* project_;
  boxbeam::BeamDetail along_flat_, thin_diaphragm_, thick_diaphragm_;
  std::map<std::pair<const boxbeam::Detail*, double>, boxbeam::SnCurve> curves_;
  std::map<std::tuple<const boxbeam::Detail*, double, double>, double> strengths_;
};

/// Utilisation of a pin in double shear under a force [N]: EN 1993-1-8, table 3.10. Random cases
/// say no partial factors of pins and rods: those of [strength] hold for them.
double pin_utilisation(double force, const boxbeam::PinInput& pin,
                       const boxbeam::StrengthDemand& factors);

/// Utilisation of a plate of a pin beside and before its hole, under the pin's force [N]: EN
/// 1993-1-8, table 3.9, type A.
double lug_utilisation(double force, const boxbeam::PinInput& pin, const boxbeam::LugInput& lug,
                       const boxbeam::StrengthDemand& factors);
/// The stress at the hole of a plate of a pin under the pin's force [Pa]: K_t of a lug under a
/// close pin (Peterson), or what the case gives, times that of the net section.
double lug_stress(double force, const boxbeam::LugInput& lug);

/// Utilisation of a rod under a compression or, negative, a tension [N]: EN 1993-1-1, 6.3.1, 6.2.3.
double rod_utilisation(double compression, const boxbeam::RodInput& rod,
                       const boxbeam::StrengthDemand& factors);

}  // namespace oracle
