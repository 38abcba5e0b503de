#include "slender_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle.hpp"

namespace oracle {

using namespace boxbeam;

namespace {

/// Why a profile of a section is slender, "" where it is not.
std::string slender_wall_of(const Project& project, const Rules& rules, const LocalSection& section,
                            const Profile& profile, bool inner, std::size_t segment,
                            const std::vector<Cuts>& cuts,
                            const std::vector<double>& load_factors) {
  const auto eps = [&](PlateKind of, double t) {
    return std::sqrt(235e6 / rules.yield_strength(segment, inner ? PlateKind::inner : of, t));
  };
  if (const auto* round = std::get_if<RoundTube>(&profile)) {
    const double t = round->wall.value();
    const double e = eps(PlateKind::wall, t);
    return round->diameter.value() / t > 90.0 * e * e ? "round wall of class 4" : "";
  }
  const auto* box = std::get_if<Box>(&profile);
  const auto* tube = std::get_if<RectangularTube>(&profile);
  if (box == nullptr && tube == nullptr) return "";
  const double W = (box ? box->width : tube->width).value();
  const double H = (box ? box->height : tube->height).value();
  const double top = (box ? box->top_flange : tube->wall).value();
  const double bottom = (box ? box->bottom_flange : tube->wall).value();
  const double left = (box ? box->left_web : tube->wall).value();
  const double right = (box ? box->right_web : tube->wall).value();
  const bool plates = box != nullptr && !inner;
  const auto kind = [&](PlateKind of) {
    return inner ? PlateKind::inner : plates ? of : PlateKind::wall;
  };
  using Wall = std::pair<PlateKind, double>;
  const Wall flanges[] = {{kind(PlateKind::top_flange), top},
                          {kind(PlateKind::bottom_flange), bottom}};
  const Wall webs[] = {{kind(PlateKind::left_web), left}, {kind(PlateKind::right_web), right}};
  const bool bars = box != nullptr && !box->stiffeners.empty();
  const double c_flange = W - left - right, h_w = H - top - bottom;
  if (!bars) {
    for (const auto& [of, t] : flanges)
      if (c_flange / t > 42.0 * eps(of, t)) return "flange of class 4";
  }
  for (const auto& [of, t] : webs)
    if (h_w / t > 72.0 / 1.2 * eps(of, t)) return "web that may buckle in shear";
  if (project.in_space) {
    for (const auto& [of, t] : flanges)
      if (c_flange / t > 72.0 / 1.2 * eps(of, t)) return "flange that may buckle in shear";
  }
  const Plane plane = plane_of({section.here, {}, {}, section.space, 1.0, 1.0}, false, false);
  const auto stress = [&](const auto& cut, double y, double z) {
    double sum = 0.0;
    const double forces[] = {cut[cut_force::N], cut[cut_force::M_y], cut[cut_force::M_z]};
    for (std::size_t k = 0; k < 3; ++k)
      sum += forces[k] * (plane.of[k][0] + plane.of[k][1] * y + plane.of[k][2] * z);
    return sum;
  };
  for (const double side : {1.0, -1.0}) {
    const double t = side > 0.0 ? left : right;
    const PlateKind of = (side > 0.0 ? webs[0] : webs[1]).first;
    const double ratio = h_w / t, e = eps(of, t);
    if (ratio <= 42.0 * e) continue;
    const double y = side * 0.5 * (W - t);
    double largest = 0.0;
    for (const Cuts& run : cuts) {
      for (const auto& cut : run.rowwise())
        largest = std::max({largest, std::abs(stress(cut, y, 0.5 * H - top)),
                            std::abs(stress(cut, y, -0.5 * H + bottom))});
    }
    for (std::size_t r = 0; r < cuts.size(); ++r) {
      const double design = project.strength.required * project.strength.gamma_M0 *
                            load_factors[r] / rules.yield_strength(segment, of, t);
      for (const auto& cut : cuts[r].rowwise()) {
        const double up = -stress(cut, y, 0.5 * H - top), low = -stress(cut, y, bottom - 0.5 * H);
        const double most = std::max(up, low);
        if (most <= 0.01 * largest) continue;  // compression that does not matter
        const double psi = std::min(up, low) / most;
        // The branches miss each other by 0.4 % at -1, where rounding does not decide.
        const double limit = psi > -1.0 + 1e-9 ? 42.0 * e / (0.67 + 0.33 * psi)
                                               : 62.0 * e * (1.0 - psi) * std::sqrt(-psi);
        // 5.5.2(9): of a part with less than its yield strength eps is larger.
        if (ratio * std::sqrt(std::min(1.0, design * most)) > limit) return "web of class 4";
      }
    }
  }
  return "";
}

/// A stiffened box with a web that may buckle in shear: judged by effective widths, of which the
/// oracle knows nothing.
bool has_slender_webs_and_bars(const Project& project, const Section& section) {
  const auto* box = std::get_if<Box>(&section.outer);
  if (box == nullptr || box->stiffeners.empty()) return false;
  const Length depth = box->height - box->top_flange - box->bottom_flange;
  const Length thinnest = std::min(box->left_web, box->right_web);
  const auto yield = yield_strength_of(project.material, thinnest);
  return !yield || depth / thinnest > 72.0 / 1.2 * std::sqrt(235e6 / yield->value());
}

}  // namespace

std::string slender_wall_at(const Project& project, const Rules& rules, const LocalSection& section,
                            const Station& station, std::size_t segment,
                            const std::vector<Cuts>& cuts,
                            const std::vector<double>& load_factors) {
  std::string why = slender_wall_of(project, rules, section, section.here.outer, false, segment,
                                    cuts, load_factors);
  if (why.empty() && section.here.inner)
    why = slender_wall_of(project, rules, section, *section.here.inner, true, segment, cuts,
                          load_factors);
  return why.empty() ? why : fmt::format("{} at s = {:.6g} m", why, station.s.value());
}

bool covers(const Project& project) {
  if (!project.given_stresses.empty() || !project.points.empty()) return false;
  if (!project.welds.empty()) return false;
  if (project.dynamics == Dynamics::newton_chain) return false;
  for (const BeamHole& at : project.holes) {
    const Section section = section_at(project.beam, {at.s, Side::both});
    if (std::holds_alternative<Plate>(section.outer)) return false;
  }
  return std::all_of(
      project.beam.segments.begin(), project.beam.segments.end(), [&](const Segment& s) {
        return covers(s.from) && covers(s.to) && !has_slender_webs_and_bars(project, s.from) &&
               !has_slender_webs_and_bars(project, s.to);
      });
}

}  // namespace oracle
