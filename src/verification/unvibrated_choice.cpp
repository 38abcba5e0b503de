#include "model_choices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/model_ladder.hpp"

namespace boxbeam {

ModelChoice begun_choice(const Project& project, SecondOrderEstimate estimated) {
  ModelChoice choice;
  choice.bends_rigid_motion = true;
  choice.tolerance = project.model.tolerance;
  choice.second_order = std::move(estimated);
  return choice;
}

bool is_pressed_in_space(const Project& project, const SecondOrderEstimate& pressed) {
  if (!std::holds_alternative<spatial::Mechanism>(project.mechanism) || !pressed.whole)
    return false;
  const double across = pressed.across ? pressed.across->part : 0.0;
  return pressed.change && std::max(pressed.in_plane.part, across) > first_order_below;
}

std::string left_out_of_bending(const Project& project) {
  if (!std::holds_alternative<spatial::Mechanism>(project.mechanism)) return "";
  const auto open = [](const Section& section) {
    return std::holds_alternative<ThinWalled>(section.outer) &&
           !(enclosed_area_of(section.outer).value() > 0.0);
  };
  const bool warps =
      std::any_of(project.beam.segments.begin(), project.beam.segments.end(),
                  [&](const Segment& segment) { return open(segment.from) || open(segment.to); });
  return warps
             ? "; of open sections it has the axial force alone, not what moments do to them when "
               "they twist, which M/M_cr judges by itself"
             : "";
}

void choose_unvibrated(const Project& project, const std::string& obstacle, ModelChoice& choice,
                       const std::string& known) {
  if (project.model.demand == ModelDemand::flexible) {
    throw AnalysisError({fmt::format("the model that was demanded cannot be had, for the beam's "
                                     "vibration is not computed here: {}; use --model auto or "
                                     "--model rigid",
                                     obstacle),
                         "beam",
                         {},
                         {},
                         {}});
  }
  const SecondOrderEstimate& pressed = choice.second_order;
  const std::string why = fmt::format("{}{}; {}", known, obstacle, second_order_text(pressed));
  if (pressed.whole && pressed.change) {
    choice.weighed.push_back({{}, "second order alone", *pressed.change, {}});
    if ((*pressed.change > choice.tolerance || is_pressed_in_space(project, pressed)) &&
        project.model.demand == ModelDemand::automatic) {
      choice.chosen = bent;
      choice.counts_second_order = true;
      choice.weighed.push_back({bent, "second order is in it", 0.0, {}});
      choice.reason = fmt::format("{}: {}{}", describe(bent), why, left_out_of_bending(project));
      return;
    }
  }
  choice.reason = "rigid bodies; " + why;
}

}  // namespace boxbeam
