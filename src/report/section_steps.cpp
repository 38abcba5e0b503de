#include "sheet_steps.hpp"

#include <cmath>
#include <optional>

#include "boxbeam/section/plain_box.hpp"

namespace boxbeam::report {
namespace {

std::string kind_of(const StressPoint& point) {
  if (point.lag || point.web_lag) return "eff";
  return point.net.area == point.gross.area ? "" : "net";
}

/// beta of the flanges and of the webs; one where there is no shear lag.
struct Betas {
  Traced flanges = 1.0, webs = 1.0;
};

Betas derive_betas(Derivation& steps, const StressPoint& point) {
  Betas betas;
  if (point.lag) betas.flanges = derive_shear_lag(steps, *point.lag, "flanges", "");
  if (point.web_lag) betas.webs = derive_shear_lag(steps, *point.web_lag, "webs", "_web");
  return betas;
}

/// The width that is idle in the middle of each plate, a constant zero without shear lag.
Traced derive_idle(Derivation& steps, const std::optional<ShearLag>& lag, const Traced& beta,
                   const char* symbol, const char* what) {
  if (!lag) return 0.0;
  return steps.define(symbol, 2.0 * (1.0 - beta) * steps.known("b_0", lag->b_0), what);
}

/// Whether strips in the middle of plates are all that the section at a point is less by: where
/// there are holes they may lie in what is idle.
bool is_less_strips(const StressPoint& point) {
  if (!point.lag && !point.web_lag) return false;
  const double strips =
      effective_properties_of(point.section, {}, {point.lag, point.web_lag}).area.value();
  constexpr double round_off = 1e-9;
  return std::abs(point.net.area.value() - strips) <= round_off * strips;
}

/// Where no formula of a few letters gives the section.
void give_values(Derivation& steps, const StressPoint& point, bool space) {
  const std::string kind = kind_of(point);
  const char* note = "along the border of the section";
  if (kind == "eff") note = "less what shear lag leaves idle, and holes";
  if (kind == "net") note = "less holes";
  if (point.beside_idle) note = "less as much as the beam's plates beside the weld leave idle";
  const auto given = [&](const std::string& symbol, const auto& value, const char* what) {
    steps.given({symbol, ""}, value, what);
  };
  given(area_symbol(point), point.net.area, note);
  given(inertia_symbol("I_y", point), point.net.I_y, "");
  const bool skew = point.net.I_yz.value() != 0.0;
  if (space || skew) given(inertia_symbol("I_z", point), point.net.I_z, "");
  if (skew) given(inertia_symbol("I_yz", point), point.net.I_yz, "");
}

}  // namespace

std::string area_symbol(const StressPoint& point) {
  const std::string kind = kind_of(point);
  return kind.empty() ? "A" : "A_" + kind;
}

std::string inertia_symbol(const std::string& of, const StressPoint& point) {
  const std::string kind = kind_of(point);
  return kind.empty() ? of : of + "," + kind;
}

void derive_section(Derivation& steps, const Project& project, const StressPoint& point) {
  const bool space = project.in_space;
  const std::optional<PlainBox> box = plain_box_of(point.section);
  std::optional<TracedSection> whole;
  if (box) whole = derive_plain_box(steps, *box, space);
  const Betas betas = derive_betas(steps, point);
  if (box && kind_of(point).empty()) return;
  if (box && is_less_strips(point)) {
    const Traced b_i =
        derive_idle(steps, point.lag, betas.flanges, "b_i", "idle width of each flange");
    const Traced h_i =
        derive_idle(steps, point.web_lag, betas.webs, "h_i", "idle width of each web");
    derive_box_less_strips(steps, *box, *whole, b_i, h_i, space);
  } else {
    give_values(steps, point, space);
  }
}

}  // namespace boxbeam::report
