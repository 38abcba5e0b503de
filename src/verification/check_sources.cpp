#include "check_sources.hpp"

#include <algorithm>

namespace boxbeam {

std::string yield_source(const Material& material) {
  return "EN 1993-1-1:2005, 6.2.1(5) (elastic, von Mises); yield strength by " + material.source;
}

std::string fatigue_source(const FatigueInput& fatigue, const std::vector<SnCurve>& curves) {
  if (fatigue.published_step) return curves.front().code + ": " + curves.front().source;
  std::string source = curves.front().code;
  source += fatigue.demand.loading == Loading::spectrum ? ", 7.1(3), 8, annex A.5" : ", 7.1(2), 8";
  if (curves.size() > 1) source += ", equation 8.3";
  if (std::any_of(curves.begin(), curves.end(),
                  [](const SnCurve& curve) { return curve.unconfirmed; })) {
    source += " (unconfirmed figures)";
  }
  return source;
}

}  // namespace boxbeam
