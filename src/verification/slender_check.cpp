#include "slender_check.hpp"

#include <fmt/format.h>

namespace boxbeam {

Check slender_check_of(const Project& project, const Station& station, const WorstInstant& worst,
                       const SlenderUse& of) {
  const double use = worst.use;
  Check check;
  check.criterion = of.criterion;
  check.station = station;
  check.point = of.point;
  check.id = id_of(of.criterion, station, of.point);
  check.situation = worst.at->situation->name;
  check.time = worst.largest.time;
  check.safety_factor = 1.0 / use;
  check.required = project.strength.required;
  const auto by_stress = [&](Stress strength, double gamma) {
    const Stress resisting(strength / gamma);
    check.resisting = resisting;
    check.acting = Stress(resisting.value() * use * pascal);
  };
  switch (of.criterion) {
    case Criterion::effective_section:
      by_stress(of.yield_strength, project.strength.gamma_M0);
      check.source =
          fmt::format("EN 1993-1-5:2006, 4.6, equation 4.15 (effective widths, {})", of.clause);
      break;
    case Criterion::shear_buckling:
      check.resisting = of.wall->resists.resistance;
      check.acting = Force(use * of.wall->resists.resistance);
      check.source = "EN 1993-1-5:2006, 5.5, equation 5.10 (without the flanges' part)";
      break;
    case Criterion::reduced_stress:
      by_stress(of.reduced->panel.yield_strength, project.strength.gamma_M1);
      check.source = "EN 1993-1-5:2006, clause 10, equation 10.5";
      break;
    default:
      check.resisting = 1.0;
      check.acting = use;
      check.source = of.web ? "EN 1993-1-5:2006, 7.1(1), equation 7.1"
                            : "EN 1993-1-5:2006, 7.1(5), equation 7.1";
  }
  return check;
}

}  // namespace boxbeam
