#include <fmt/format.h>

#include <algorithm>

#include "attachment_places.hpp"
#include "boxbeam/report/format.hpp"
#include "remark_parts.hpp"

namespace boxbeam::report {

void add_details(const Project& project, std::vector<std::string>& remarks) {
  const FatigueInput& fatigue = project.fatigue;
  const auto add = [&](const BeamDetail& of, const std::string& where) {
    const Detail& detail = of.detail;
    if (!of.assumed.empty()) {
      remarks.push_back(fmt::format("detail category {} is assumed for the {} at {}: {}",
                                    detail.curve.name, detail.name, where, of.assumed));
    }
    if (detail.unconfirmed) {
      remarks.push_back(fmt::format(
          "unconfirmed: the figures of {} {} for the {} at {} are recalled, not read in the code",
          detail.row.empty() ? detail.curve.code : "row " + detail.row,
          detail.row.empty() ? detail.curve.name : "(category " + detail.curve.name + ")",
          detail.name, where));
    }
    if (detail.deciding.empty()) return;
    remarks.push_back(fmt::format(
        "the {} at {} can be {} rows of the tables; the weakest, {} (category {}), is taken; to "
        "know: {}",
        detail.name, where, detail.candidates.size(), detail.row, detail.curve.name,
        fmt::join(detail.deciding, ", ")));
  };
  const auto place = [](const BeamDetail& of) {
    std::string where = "s = " + text::significant(of.from.value(), 3);
    if (of.to > of.from) where += " to " + text::significant(of.to.value(), 3);
    return where + " m";
  };
  add(fatigue.beam, "the whole beam");
  for (const BeamDetail& detail : fatigue.details) add(detail, place(detail));
  for (const report::AlikeWelds& of : report::alike_welds_of(fatigue)) add(*of.detail, of.where);
  for (const BeamHole& at : project.holes) {
    if (at.detail) add(*at.detail, "hole " + at.hole.name);
  }
  for (const WeldInput& weld : project.welds) {
    if (fatigue.asked) add(weld.toe, "weld " + weld.name);
  }
  for (const PinInput& pin : project.pins) {
    for (const LugInput& lug : pin.lugs) {
      if (fatigue.asked)
        add(lug.detail,
            fmt::format("pin {}, {}", pin.name, lug.inner ? "inner plate" : "outer plates"));
    }
  }
}

void add_pressed(const Verification& verification, std::vector<std::string>& remarks) {
  for (const CheckResult& result : verification.checks) {
    if (!result.pressed) continue;
    const Detail& detail = result.pressed->life.point.detail->detail;
    if (!detail.unconfirmed) continue;
    std::string remark = fmt::format(
        "unconfirmed: the figures of row {} (category {}) for the {} under forces are recalled, "
        "not read in the code",
        detail.row, detail.curve.name, detail.name);
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end())
      remarks.push_back(std::move(remark));
  }
}

void add_lugs(const Project& project, std::vector<std::string>& remarks) {
  if (!project.fatigue.asked) return;
  for (const PinInput& pin : project.pins) {
    const std::string unknown = unknown_plates_of(pin);
    if (unknown.empty()) continue;
    remarks.push_back(fmt::format(
        "pin {}: the fatigue of its {} is not judged: [[pins.lugs]] say how wide they are",
        pin.name, unknown));
  }
}

void add_thin_welds(const Project& project, std::vector<std::string>& remarks) {
  const auto look = [&](const std::string& what, Length throat) {
    if (!(throat > Length{}) || throat >= least_throat()) return;
    std::string remark = fmt::format(
        "{} has a throat of {}, below 3 mm, the least of a fillet weld (EN 1993-1-8, 4.5.2(2))",
        what, text::mm(throat.value()));
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end())
      remarks.push_back(std::move(remark));
  };
  for (const WeldInput& weld : project.welds) look("weld " + weld.name, weld.throat);
  for (const Segment& segment : project.beam.segments) {
    for (const Section* section : {&segment.from, &segment.to}) {
      if (const auto* const box = std::get_if<Box>(&section->outer))
        look("the seam of segment " + segment.name, box->seam_throat);
    }
  }
  for (const Diaphragm& diaphragm : project.beam.diaphragms) {
    look(fmt::format("the weld of the diaphragm at s = {} m",
                     to_text(Station{diaphragm.s, Side::both})),
         diaphragm.throat);
  }
}

void add_unsaid_welds(const Verification& verification, std::vector<std::string>& remarks) {
  if (!verification.unsaid_welds || !verification.unsaid_welds->throat) return;
  const UnsaidWelds& of = *verification.unsaid_welds;
  const double halves = 0.5e-3 * std::ceil((1.0 - 1e-9) * of.throat->value() / 0.5e-3);
  remarks.push_back(fmt::format(
      "the welds of diaphragms that take forces are not said: throats of {:g} mm on both their "
      "faces "
      "bear them, by {} at s = {} m (EN 1993-1-8, 4.5.3.2); [[beam.diaphragms]] say their throat",
      1e3 * halves, of.under, to_text(Station{of.s, Side::both})));
}

void add_holes(const Project& project, std::vector<std::string>& remarks) {
  const bool by_beam =
      std::any_of(project.holes.begin(), project.holes.end(),
                  [](const BeamHole& at) { return at.concentration && !at.detail; });
  if (!by_beam || !project.given_stresses.empty()) return;
  remarks.push_back(
      "at hole edges without a detail of their own the largest local stress around the edge "
      "(concentration included) is compared, as modified nominal stress, with the category of the "
      "beam; where that is one for holes on the net section, this counts the hole twice");
}

void add_short_lives(const Project& project, std::vector<std::string>& remarks) {
  if (!project.fatigue.asked || most_cycles_of(project) >= 1e4) return;
  remarks.push_back(
      "fewer than 1e4 cycles: the S-N lines of EN 1993-1-9 begin at 1e4, the strength shown is "
      "extrapolated and the yield check decides");
}

void add_joined_profiles(const Project& project, std::vector<std::string>& remarks) {
  const std::vector<Segment>& segments = project.beam.segments;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    if (segments[i].to.outer == segments[i + 1].from.outer) continue;
    const Length s = segments[i].end();
    const bool described = std::any_of(project.welds.begin(), project.welds.end(),
                                       [&](const WeldInput& weld) { return weld.s == s; });
    if (described) continue;
    remarks.push_back(fmt::format(
        "not checked: the weld between {} and {} at s = {:.6g} m carries all that is cut there; "
        "[[welds]] with its throat checks throat, root and toe",
        segments[i].name, segments[i + 1].name, s.value()));
  }
}

}  // namespace boxbeam::report
