#pragma once

#include <string>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/core/units.hpp"

namespace boxbeam {

enum class Criterion { yield, fatigue };

const char* to_text(Criterion criterion);

/// One criterion at one place: what acts against what resists.
struct Check {
  std::string id;  ///< "yield/4.2-/top": criterion, station with side, point
  Criterion criterion = Criterion::yield;
  Station station;
  std::string point;
  Time time;         ///< instant of the largest stress
  Stress acting;     ///< equivalent stress, or stress range
  Stress resisting;  ///< of the same kind, partial factors applied
  /// The largest factor on the whole load history for which the criterion still holds.
  double safety_factor = 0.0;
  double required = 1.0;
  std::string source;

  double utilisation() const { return required / safety_factor; }
  bool passes() const { return utilisation() <= 1.0; }
};

/// "4.2-", "0+", "1.9775": station in metres with its side, as ids and tables show it.
std::string to_text(const Station& station);

}  // namespace boxbeam
