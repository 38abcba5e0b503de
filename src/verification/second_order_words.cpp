#include <fmt/format.h>

#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"

namespace boxbeam {

std::vector<std::string> assumed_holds_of(const SecondOrderEstimate& of, bool in_space) {
  std::vector<std::string> texts;
  const auto say = [&](const char* way, const char* key, const auto& load, double least,
                       const char* part) {
    if (!load.assumed || load.part <= least) return;
    texts.push_back(
        fmt::format("{} the beam is {}, by which {} = {:.3g}; [[beam.restraints]] "
                    "with holds = [\"{}\"] say otherwise",
                    way, load.held, part, load.part, key));
  };
  say(in_space ? "along z" : "in the plane of motion", "along z", of.in_plane, no_buckling_below,
      "N/N_cr");
  if (of.across)
    say(in_space ? "along y" : "across the plane of motion", "along y", *of.across,
        no_buckling_below, "N/N_cr");
  if (of.twisting)
    say("against twisting", "turning over", *of.twisting, no_buckling_below, "N/N_cr");
  if (of.lateral)
    say("against turning over", "turning over", *of.lateral, no_turning_over_below, "M/M_cr");
  return texts;
}

std::string lateral_text(const LateralLoad& of) {
  // Of a beam that nothing turns over nobody has asked how it is held.
  if (!(of.part > 0.0)) return "lateral torsional buckling: nothing turns the beam over";
  return fmt::format(
      "lateral torsional buckling: M/M_cr = {:.3g} at most, the beam {}, forces at the edge where "
      "they turn it over",
      of.part, of.held);
}

std::string second_order_text(const SecondOrderEstimate& of) {
  constexpr double none = 1e-9;
  if (of.in_plane.part < none && of.change && *of.change < none) {
    return "second order changes nothing, for the beam bears no axial force";
  }
  std::string text = of.change ? fmt::format("second order is estimated to change it by {}",
                                             percent_text(*of.change))
                               : std::string("the beam buckles");
  if (of.in_plane.part > 0.0) {
    text += fmt::format(", N/N_cr = {:.3g} at most in the plane", of.in_plane.part);
  }
  if (of.across && of.across->part > 0.0)
    text += fmt::format(", {:.3g} across it", of.across->part);
  return text;
}

}  // namespace boxbeam
