#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "remark_parts.hpp"

namespace boxbeam::report {
namespace {

/// Of V what crosses from an outer to an inner profile that does not bend about its own centroid:
/// 1 - sum I_c/I (shear_flow.hpp), in space of V_y as well.
double share_between(const Section& section, bool space) {
  if (!section.inner) return 0.0;
  const SectionProperties whole = properties_of(section);
  const SectionProperties outer = properties_of({section.outer, {}});
  const SectionProperties inner = properties_of({*section.inner, {}});
  const double upright = 1.0 - ((outer.I_y + inner.I_y) / whole.I_y).value();
  const double across = 1.0 - ((outer.I_z + inner.I_z) / whole.I_z).value();
  return space ? std::max(upright, across) : upright;
}

}  // namespace

bool has_fillet_seams(const Project& project) {
  const auto filleted = [](const Section& section) {
    const auto* const box = std::get_if<Box>(&section.outer);
    return box != nullptr && box->seam_throat > Length{};
  };
  return std::any_of(project.beam.segments.begin(), project.beam.segments.end(),
                     [&](const Segment& of) { return filleted(of.from) || filleted(of.to); });
}

void add_slender_plates(const Project& project, const Verification& verification,
                        std::vector<std::string>& remarks) {
  // Where nothing is used more than by yielding no plate is among the checks.
  const auto judged_by = [&](PlateRoute route) {
    const bool reduced = route == PlateRoute::reduced_stresses;
    return std::any_of(verification.checks.begin(), verification.checks.end(),
                       [&](const CheckResult& of) {
                         return of.plates && (of.plates->reduced != nullptr) == reduced;
                       });
  };
  const std::string panels =
      project.beam.diaphragms.size() > 1
          ? "as panels between diaphragms"
          : "as panels as long as the beam with end posts that are not rigid: "
            "[[beam.diaphragms]] would only help";
  if (judged_by(PlateRoute::effective_widths)) {
    remarks.push_back(
        "plates with c/t above 42 eps are judged by effective widths under N, M_y and M_z, each by "
        "the section where it acts alone (EN 1993-1-5, clause 4, one pass), and in shear (clause "
        "5), without the flanges' part, " +
        panels);
  }
  if (std::any_of(verification.checks.begin(), verification.checks.end(),
                  [](const CheckResult& of) { return of.path.has_value(); })) {
    remarks.push_back(
        "paths with walls beyond class 3 are judged by effective widths under N, M_y and M_z, each "
        "by the section where it acts alone, step by step until that stays (EN 1993-1-5, clause "
        "4), "
        "in shear (clause 5) without the flanges' part, and by both together (7.1); " +
        panels);
  }
  if (judged_by(PlateRoute::reduced_stresses)) {
    remarks.push_back(
        "boxes with plates of c/t above 42 eps are judged by reduced stresses (EN 1993-1-5, clause "
        "10): each plate on the gross section under all that acts on it at an instant, where "
        "forces come into a web with them (6.4, annex B.1, recalled), " +
        panels);
  }
  for (const SegmentRoute& of : verification.routes) {
    if (of.reason.empty()) continue;
    remarks.push_back(fmt::format(
        "segment {} is judged by reduced stresses, for {}: its plates as rectangles of their "
        "largest width between diaphragms, normal stress along the edge, sigma/cos^2",
        of.segment, of.reason));
  }
}

void add_tapers(const Verification& verification, std::vector<std::string>& remarks) {
  std::vector<std::string> slopes;
  double steepest = 0.0;
  for (const TaperSlope& taper : verification.tapers) {
    const double degrees = taper.angle * 180.0 / std::numbers::pi;
    slopes.push_back(fmt::format("{} {:.1f} deg", taper.segment, degrees));
    steepest = std::max(steepest, degrees);
  }
  if (slopes.empty()) return;
  // Wedge under a tip force (Timoshenko and Goodier): M/W is 0.9939 of the exact edge stress at a
  // half-angle of 10 deg, 0.9861 at 15 deg.
  remarks.push_back(fmt::format(
      "flanges slope (segment {}): the shear is that of equilibrium, d/dx(M S/I), which leaves "
      "with "
      "them what they carry of V; V S/(I b) stands beside it in the calculation sheet{}",
      fmt::join(slopes, ", "),
      steepest > 10.0 ? "; M/W is 0.6 to 1.4 % low at the edge between 10 and 15 deg" : ""));
}

void add_warping(const Project& project, std::vector<std::string>& remarks) {
  const auto& segments = project.beam.segments;
  const bool path = std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return std::holds_alternative<ThinWalled>(segment.from.outer);
  });
  if (!project.in_space || !path) return;
  remarks.push_back(
      "torsion of thin-walled paths is Saint-Venant's, with free warping: where warping is held, "
      "as "
      "at a clamped end, an open section has normal stresses of warping besides, which are not "
      "counted");
}

std::string shape_text(const Project& project) {
  const auto is_open = [](const Segment& segment) {
    const auto* const path = std::get_if<ThinWalled>(&segment.from.outer);
    return path != nullptr && !segment.from.inner && !(enclosed_area_of(*path).value() > 0.0);
  };
  const auto& segments = project.beam.segments;
  const bool all = std::all_of(segments.begin(), segments.end(), is_open);
  if (project.in_space) {
    return all ? "warping, whether open sections keep their shape"
               : "warping, distortion but of boxes, rectangular tubes and paths around one "
                 "rectangle";
  }
  std::string text =
      all ? ""
          : "warping and distortion of the box (diaphragms where forces act are taken for granted; "
            "a case in the plane has no torque, and forces beside the middle of a box, as of an "
            "eccentric rail, are a case in space)";
  if (std::any_of(segments.begin(), segments.end(), is_open)) {
    text += text.empty() ? "" : ", ";
    text +=
        "whether open sections keep their shape where forces act (a case in the plane has these on "
        "the axis, about which they turn a section whose shear centre is beside it; others are a "
        "case in space)";
  }
  return text;
}

void add_nested_profiles(const Project& project, std::vector<std::string>& remarks) {
  std::string names;
  double share = 0.0;
  for (const Segment& segment : project.beam.segments) {
    if (!segment.from.inner) continue;
    names += (names.empty() ? "" : ", ") + segment.name;
    for (const Section* end : {&segment.from, &segment.to})
      share = std::max(share, share_between(*end, project.in_space));
  }
  if (names.empty()) return;
  // Profiles about one centroid need no tie for V.
  constexpr double nothing = 1e-6;
  remarks.push_back(fmt::format(
      "not checked: what ties the outer and the inner profile of {} to one section{}", names,
      share > nothing ? fmt::format("; their centroids differ, and it carries up to {:.2g} % of V",
                                    100.0 * share)
                      : ""));
}

}  // namespace boxbeam::report
