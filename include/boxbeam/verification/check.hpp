#pragma once

#include <array>
#include <cassert>
#include <string>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// What a criterion compares: a quantity of whatever dimension, SI.
class Amount {
 public:
  Amount() = default;
  Amount(Stress stress) : value_(stress.value()), unit_("Pa") {}
  Amount(Force force) : value_(force.value()), unit_("N") {}
  Amount(Length length) : value_(length.value()), unit_("m") {}
  Amount(double number) : value_(number), unit_("1") {}

  double value() const { return value_; }
  std::string unit() const { return unit_; }

  /// Ratio of two amounts of the same dimension.
  friend double operator/(const Amount& a, const Amount& b) {
    assert(a.unit() == b.unit());
    return a.value_ / b.value_;
  }

 private:
  double value_ = 0.0;
  const char* unit_ = "1";
};

enum class Criterion {
  yield,               ///< equivalent stress against the yield strength
  fatigue,             ///< normal stress ranges against a detail category
  shear_fatigue,       ///< shear stress ranges likewise
  combined_fatigue,    ///< both together
  stress_range,        ///< the largest range against 1.5 times the yield strength
  weld,                ///< throat of a weld
  effective_section,   ///< normal stress on what of the plates works once they buckle
  shear_buckling,      ///< of a plate
  interaction,         ///< of both
  reduced_stress,      ///< all stresses of a plate together, as it buckles
  patch_loading,       ///< of a web, by a force that a flange leads into it
  patch_fatigue,       ///< ranges of what forces press into webs
  distortion,          ///< a box that is racked: its plates stretched along and bent across
  distortion_fatigue,  ///< ranges of the same
  member,              ///< flexural or lateral torsional buckling of the whole beam
  pin,                 ///< a pin, its bearing and its lugs
  lug_fatigue,         ///< ranges at the hole of a lug
  rod,                 ///< a rod under tension
  buckling,            ///< a rod under compression
  deflection,          ///< of the beam
};

/// All criteria, in the order of a report.
inline constexpr std::array criteria{Criterion::yield,
                                     Criterion::fatigue,
                                     Criterion::shear_fatigue,
                                     Criterion::combined_fatigue,
                                     Criterion::stress_range,
                                     Criterion::weld,
                                     Criterion::effective_section,
                                     Criterion::shear_buckling,
                                     Criterion::interaction,
                                     Criterion::reduced_stress,
                                     Criterion::patch_loading,
                                     Criterion::patch_fatigue,
                                     Criterion::distortion,
                                     Criterion::distortion_fatigue,
                                     Criterion::member,
                                     Criterion::pin,
                                     Criterion::lug_fatigue,
                                     Criterion::rod,
                                     Criterion::buckling,
                                     Criterion::deflection};

/// "yield", "shear fatigue", ...; in ids with "-" for the space.
const char* to_text(Criterion criterion);

/// One criterion at one place: what acts against what resists.
struct Check {
  std::string id;  ///< "yield/4.2-/fibre+z": criterion, station with side, point
  Criterion criterion = Criterion::yield;
  Station station;
  bool on_beam = true;  ///< else a neighbour of the beam: it has no station
  std::string point;
  std::string situation;  ///< in which it is worst; "" where the case has only one
  Time time;              ///< instant of the largest stress or load in it
  Amount acting;          ///< equivalent stress, stress range, force, ...
  Amount resisting;       ///< of the same kind, partial factors applied
  /// The largest factor on the whole load history for which the criterion still holds.
  double safety_factor = 0.0;
  double required = 1.0;
  std::string source;

  double utilisation() const { return required / safety_factor; }
  bool passes() const { return utilisation() <= 1.0; }
};

/// Something that a case asks for and that could not be judged.
struct NotJudged {
  Criterion by;        ///< what would have judged it
  std::string what;    ///< "fatigue", "rod hanger"
  std::string reason;  ///< "no stress range"
};

/// "4.2-", "0+", "1.9775": station in metres with its side, as ids and tables show it.
std::string to_text(const Station& station);

}  // namespace boxbeam
