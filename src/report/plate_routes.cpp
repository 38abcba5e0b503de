#include "report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/format.hpp"
#include "boxbeam/verification/plate_checks.hpp"

namespace boxbeam::report {
namespace {

std::string name_of(PlateRoute route) {
  return fmt::format("{} (EN 1993-1-5, {})", to_text(route),
                     route == PlateRoute::effective_widths ? "4 to 7" : "10");
}

/// "reduced stress at 12- m, bottom flange, 71.7 %"
std::string use_of(const CheckResult& result) {
  const Check& check = result.check;
  return fmt::format("{} at {} m, {}, {}", to_text(check.criterion), to_text(check.station),
                     check.point, text::percent(check.utilisation()));
}

/// The worst check of plates; or nullptr.
const CheckResult* worst_in(const std::vector<CheckResult>& checks) {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const CheckResult& of) { return of.plates || of.path; });
  return found == checks.end() ? nullptr : &*found;
}

}  // namespace

std::string plate_routes_text(const Verification& verification) {
  const std::vector<SegmentRoute>& routes = verification.routes;
  if (routes.empty()) return "";
  const bool alike = std::all_of(routes.begin(), routes.end(), [&](const SegmentRoute& of) {
    return of.route == routes.front().route && of.reason == routes.front().reason;
  });
  std::string out = "slender ones by ";
  for (const SegmentRoute& of : routes) {
    if (alike && &of != &routes.front()) break;
    if (&of != &routes.front()) out += "; ";
    out += name_of(of.route);
    if (!alike) out += " in segment " + of.segment;
    if (!of.reason.empty()) out += ", for " + of.reason;
  }
  const CheckResult* const worst = worst_in(verification.checks);
  out += worst == nullptr ? "; no more used than by yielding" : "; most used " + use_of(*worst);
  if (!verification.beside.empty())
    out += ". Beside it, no part of the verdict: " + use_of(verification.beside.front());
  return out;
}

}  // namespace boxbeam::report
