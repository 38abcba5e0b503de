// Flats along plates that buckle.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/project/case_lists.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "plate_panels.hpp"
#include "remedy_search.hpp"

namespace boxbeam {
namespace {

/// A flat as it is bought.
struct Flat {
  Length depth, thickness;
};

/// Where flats stand on a plate, by parts of its clear width from its low end.
struct Layout {
  std::vector<double> at;  ///< none: where there are some
  std::string where;       ///< "in the middle"
};

/// What is stiffened, and how.
struct Plan {
  std::vector<BoxPlate> plates;  ///< one flange, or both webs
  std::string word;              ///< "the webs"
  std::vector<Layout> layouts;   ///< of few flats before those of many
};

/// Flats of usual thickness as deep as does not twist (EN 1993-1-5, 9.2.1(8)), in whole
/// centimetres, the smallest first.
std::vector<Flat> flats_of(Stress yield_strength) {
  constexpr double mm = 1e-3;
  std::vector<Flat> flats;
  for (const double thickness : {8.0, 10.0, 12.0, 15.0, 20.0}) {
    Flat flat{si<Length>(10.0 * mm), si<Length>(thickness * mm)};
    const auto deeper = [&] { return si<Length>(flat.depth.value() + 10.0 * mm); };
    while (resists_torsional_buckling({{}, deeper(), flat.thickness}, yield_strength))
      flat.depth = deeper();
    flats.push_back(flat);
  }
  return flats;
}

/// A fifth of the depth from the edge of a web that is compressed most, where bending holds most
/// of it; in the middle where it is compressed evenly.
Layout against_bending(const FourWalls& box, BoxPlate web, const CutForces& cut) {
  const auto [low, high] = PlateEnds(box, web, box.gross).compression_under(cut);
  const Stress most = std::max(low, high, std::less<>()),
               least = std::min(low, high, std::less<>());
  constexpr double even = 0.5, fifth = 0.2;
  if (!(most > Stress{}) || least > even * most) return {{0.5}, "in their middle"};
  if (high > low) return {{1.0 - fifth}, "a fifth of their depth below the top flange"};
  return {{fifth}, "a fifth of their depth above the bottom flange"};
}

Plan plan_of_flange(BoxPlate flange) {
  return {{flange},
          fmt::format("the {}", to_text(flange)),
          {{{0.5}, "in its middle"}, {{1.0 / 3.0, 2.0 / 3.0}, "in its thirds"}}};
}

Plan plan_of_webs(std::vector<Layout> layouts) {
  return {{BoxPlate::left_web, BoxPlate::right_web}, "the webs", std::move(layouts)};
}

/// For each plate that may buckle where the check governs.
std::vector<Plan> plans_for(const CheckResult& governing) {
  const PlateBasis& basis = *governing.plates;
  const FourWalls& box = basis.plates->box.box();
  const Layout middle{{0.5}, "in their middle"}, thirds{{1.0 / 3.0, 2.0 / 3.0}, "in their thirds"};
  std::vector<Plan> plans;
  if (governing.check.criterion == Criterion::effective_section) {
    // Of both flanges the one that is compressed more.
    const auto compression = [&](BoxPlate plate) {
      return PlateEnds(box, plate, box.gross).under(basis.cut).compression;
    };
    const BoxPlate flange = compression(BoxPlate::top_flange) > compression(BoxPlate::bottom_flange)
                                ? BoxPlate::top_flange
                                : BoxPlate::bottom_flange;
    if (may_buckle(box.of(flange)) && compression(flange) > Stress{})
      plans.push_back(plan_of_flange(flange));
    const BoxPlate web = compression(BoxPlate::left_web) > compression(BoxPlate::right_web)
                             ? BoxPlate::left_web
                             : BoxPlate::right_web;
    if (may_buckle(box.of(web)))
      plans.push_back(plan_of_webs({against_bending(box, web, basis.cut), middle}));
    return plans;
  }
  const BoxPlate plate = basis.plate->plate;
  if (is_flange(plate)) {
    plans.push_back(plan_of_flange(plate));
  } else if (governing.check.criterion == Criterion::interaction) {
    plans.push_back(plan_of_webs({against_bending(box, plate, basis.cut), middle, thirds}));
  } else {
    plans.push_back(plan_of_webs({middle, thirds}));
  }
  return plans;
}

/// Ends of a plate's clear width in a box, from where places on it are counted.
std::array<double, 2> clear_ends_of(const Box& box, BoxPlate plate) {
  if (is_flange(plate))
    return {(box.right_web - 0.5 * box.width).value(), (0.5 * box.width - box.left_web).value()};
  return {clear_bottom_of(box).value(), clear_top_of(box).value()};
}

bool is_on(const Plan& plan, const Stiffener& bar) {
  return std::find(plan.plates.begin(), plan.plates.end(), bar.plate) != plan.plates.end();
}

/// The largest section of the flats that a plan's plates have already.
Area largest_flat(const AlikeBoxes& alike, const Plan& plan) {
  Area largest;
  for (const NamedBox& of : alike.boxes) {
    for (const Stiffener& bar : of.box.stiffeners)
      if (is_on(plan, bar)) largest = std::max(largest, bar.depth * bar.thickness);
  }
  return largest;
}

/// Flats in place of those that a section has.
std::vector<std::string> exchanged(const NamedBox& of, const Plan& plan, const Flat& flat) {
  std::vector<std::string> set;
  for (std::size_t i = 0; i < of.box.stiffeners.size(); ++i) {
    if (!is_on(plan, of.box.stiffeners[i])) continue;
    const std::string bar = fmt::format("sections.{}.stiffeners.{}", of.name, i);
    set.push_back(fmt::format("{}.depth={:.6g} mm", bar, 1e3 * flat.depth.value()));
    set.push_back(fmt::format("{}.thickness={:.6g} mm", bar, 1e3 * flat.thickness.value()));
  }
  return set;
}

/// Flats beside those that a section has.
std::vector<std::string> added(const Project& project, const NamedBox& of, const Plan& plan,
                               const Layout& layout, const Flat& flat) {
  std::vector<std::string> tables;
  for (const BoxPlate plate : plan.plates) {
    const auto [low, high] = clear_ends_of(of.box, plate);
    for (const double at : layout.at) {
      tables.push_back(fmt::format(
          "{{on = \"{}\", at = \"{:.0f} mm\", depth = \"{:.6g} mm\", thickness = \"{:.6g} mm\"}}",
          to_text(plate), std::round(1e3 * (low + at * (high - low))) + 0.0,
          1e3 * flat.depth.value(), 1e3 * flat.thickness.value()));
    }
  }
  return added_to(project, fmt::format("sections.{}.stiffeners", of.name), tables);
}

/// The same in all boxes that must be alike.
std::vector<std::string> keys_of(const RemedySearch& search, const AlikeBoxes& alike,
                                 const Plan& plan, const Layout& layout, const Flat& flat) {
  std::vector<std::string> set;
  for (const NamedBox& of : alike.boxes) {
    for (std::string& key : layout.at.empty() ? exchanged(of, plan, flat)
                                              : added(search.project, of, plan, layout, flat))
      set.push_back(std::move(key));
  }
  return set;
}

/// Whether a case has stiffeners that twist or do not divide their plate: it cannot pass.
bool has_poor_stiffeners(const Project& changed) {
  return std::any_of(
      changed.beam.segments.begin(), changed.beam.segments.end(), [&](const Segment& segment) {
        const std::vector<FourWalls> ends =
            walls_of_segment(changed, {segment.start, Side::behind});
        return std::any_of(ends.begin(), ends.end(),
                           [](const FourWalls& of) { return !stiffener_obstacle(of).empty(); });
      });
}

/// "120 x 12 mm along the webs"
std::string size_of(const Flat& flat, const Plan& plan) {
  return fmt::format("{:.6g} x {:.6g} mm along {}", 1e3 * flat.depth.value(),
                     1e3 * flat.thickness.value(), plan.word);
}

/// The smallest first, one by one: a larger one need not pass, for its weight and its shift.
void look_at_plan(RemedySearch& search, const AlikeBoxes& alike, const Plan& plan,
                  const std::vector<Flat>& flats) {
  const bool exchanges = plan.layouts.front().at.empty();
  bool fits = false;
  for (const Flat& flat : flats) {
    for (const Layout& layout : plan.layouts) {
      std::vector<std::string> set = keys_of(search, alike, plan, layout, flat);
      const auto changed = search.changed_by(set);
      if (!changed) continue;
      fits = true;
      if (has_poor_stiffeners(*changed)) continue;
      const Outcome outcome = RemedySearch::verified(*changed);
      if (!outcome) continue;
      const bool one = plan.plates.size() * layout.at.size() == 1;
      search.remedies.found.push_back({Remedy::What::stiffeners,
                                       fmt::format("{} of {} ({})", one ? "a flat" : "flats",
                                                   size_of(flat, plan), layout.where),
                                       flat.thickness.value(), *outcome, std::move(set)});
      return;
    }
  }
  if (fits)
    search.remedies.in_vain.push_back(fmt::format("flats up to {}", size_of(flats.back(), plan)));
  else
    search.remedies.not_searched.push_back(fmt::format(
        "flats along {} ({})", plan.word, exchanges ? "no larger ones fit" : "none fits"));
}

}  // namespace

void look_at_stiffeners(RemedySearch& search) {
  const auto not_searched = [&](const std::string& what, const char* reason) {
    search.remedies.not_searched.push_back(fmt::format("{} ({})", what, reason));
  };
  if (search.governing.check.criterion == Criterion::reduced_stress)
    return not_searched("stiffeners", "reduced stresses do not judge them");
  if (search.is_elastic()) return not_searched("stiffeners", "the model is elastic");
  const AlikeBoxes alike = alike_boxes_of(search.project, search.segment());
  if (alike.boxes.empty()) return not_searched("stiffeners", "no section of the case takes them");
  const FourWalls& box = search.governing.plates->plates->box.box();
  for (Plan& plan : plans_for(search.governing)) {
    std::vector<Flat> flats = flats_of(box.of(plan.plates.front()).class_strength);
    const Area now = largest_flat(alike, plan);
    if (now > Area{}) {
      plan.layouts = {{{}, "in place of those that are there"}};
      std::erase_if(flats, [&](const Flat& of) { return of.depth * of.thickness <= now; });
    }
    look_at_plan(search, alike, plan, flats);
  }
}

}  // namespace boxbeam
