#include "boxbeam/verification/model_ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"

namespace boxbeam {
namespace {

using flexible::LinkKind;

constexpr std::array divisions{2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
/// The division by which rungs are estimated, with one half and one twice as fine.
constexpr int scout_parts = 8;
constexpr int fine_parts = 2 * scout_parts;
/// Of the better model by which one is verified, at least.
constexpr int better_parts = 32;
/// Estimates are sums of what may cancel: models up to so many tolerances are tried all the same.
constexpr double doubt = 2.0;
/// Natural frequencies that are said at most.
constexpr std::size_t most_frequencies = 12;

bool has_bending_links(const flexible::Mechanism& mechanism) {
  return std::any_of(mechanism.links.begin(), mechanism.links.end(),
                     [](const flexible::Link& link) { return link.kind == LinkKind::bending; });
}

/// Whether balance alone determines the forces in the joints.
bool is_determinate(const flexible::Mechanism& mechanism) {
  std::size_t forces = 0;
  for (const flexible::Joint& joint : mechanism.joints) {
    forces += static_cast<std::size_t>(std::count_if(joint.stiffness.begin(), joint.stiffness.end(),
                                                     [](double k) { return k > 0.0; }));
  }
  return forces == 3 * mechanism.links.size();
}

/// Whether rigid links have unique forces in their joints: joints that are all elastic, or as many
/// forces as balance determines.
bool rigid_links_determine_joints(const flexible::Mechanism& mechanism) {
  const bool elastic = std::all_of(
      mechanism.joints.begin(), mechanism.joints.end(), [](const flexible::Joint& joint) {
        return std::none_of(joint.stiffness.begin(), joint.stiffness.end(),
                            [](double k) { return std::isinf(k); });
      });
  return elastic || is_determinate(mechanism);
}

ElasticModel all_elements(int parts, bool axial) {
  return {ModelLevel::flexible, 0, parts, flexible::Element::corrected, axial};
}

/// Error of a division into n parts, error_8 (8/n)^order; of finer ones not better than the second
/// order, which shear and rotary inertia have in the end.
struct DivisionError {
  double at_scout = 0.0;
  double order = 2.0;

  double operator()(int parts) const {
    const double coarser = static_cast<double>(scout_parts) / parts;
    return at_scout * std::pow(coarser, coarser > 1.0 ? order : std::min(order, 2.0));
  }
};

/// From three divisions, each twice as fine as the one before (Richardson).
DivisionError division_error(double first_step, double second_step) {
  constexpr double round_off = 1e-11;
  if (second_step < round_off) return {second_step, 2.0};
  const double order = std::clamp(std::log2(first_step / second_step), 1.5, 4.0);
  return {second_step / (1.0 - std::pow(2.0, -order)), order};
}

/// What is known of a case before any model is chosen.
struct Scouting {
  std::vector<double> frequencies;  ///< [Hz]
  DivisionError division;           ///< of all elements
  double axial = 0.0;               ///< error of axially rigid bending links
  double shear = 0.0;               ///< error of links rigid in shear
  /// Error of rigid links on the joints as they are; nothing where joints without play repeat each
  /// other, which rigid links cannot share a load between.
  std::optional<double> rigid;
};

VibratingStress stresses_of(const LadderCase& of, const ModelResponse& by,
                            const flexible::Structure& structure,
                            const std::vector<ComparedPlace>& places) {
  return vibrating_stress_of(
      flexible::beam_response_of(structure, of.link, *of.beam, by.response, by.inertial), places);
}

/// The lowest natural frequencies by the finer division [Hz].
std::vector<double> frequencies_of(const LadderCase& of) {
  const flexible::Mechanism mechanism = modelled(*of.mechanism, all_elements(fine_parts, true));
  std::vector<double> frequencies;
  for (const flexible::Mode& mode :
       flexible::modes_of(flexible::structure_of(mechanism), most_frequencies))
    frequencies.push_back(mode.frequency);
  return frequencies;
}

/// The same links, as good as rigid in shear.
flexible::Mechanism rigid_in_shear(flexible::Mechanism mechanism) {
  for (flexible::Link& link : mechanism.links) {
    for (flexible::LinkStretch& stretch : link.stretches) stretch.GA = 1e6 * stretch.GA;
  }
  return mechanism;
}

Scouting scout(const LadderCase& of, const std::vector<ComparedPlace>& places) {
  const auto by = [&](int parts, bool axial) {
    return stresses_by(of, all_elements(parts, axial), places);
  };
  Scouting scouting;
  const VibratingStress coarse = by(scout_parts / 2, true);
  const VibratingStress middle = by(scout_parts, true);
  const VibratingStress fine = by(fine_parts, true);
  scouting.division =
      division_error(difference_between(coarse, middle), difference_between(middle, fine));
  if (rigid_links_determine_joints(*of.mechanism)) {
    scouting.rigid = difference_between(stresses_by(of, {}, places), fine);
  }
  if (has_bending_links(*of.mechanism)) {
    scouting.axial = difference_between(by(scout_parts, false), middle);
  }
  const flexible::Mechanism stiff = rigid_in_shear(*of.mechanism);
  scouting.shear = difference_between(
      stresses_by({&stiff, of.link, of.beam}, all_elements(scout_parts, true), places), middle);
  scouting.frequencies = frequencies_of(of);
  return scouting;
}

ModelEstimate estimate_of(const ElasticModel& model, const Scouting& scouting) {
  ModelEstimate estimate;
  estimate.model = model;
  if (model.level == ModelLevel::rigid) {
    estimate.error = *scouting.rigid;
    estimate.basis = "rigid links against elastic ones";
    return estimate;
  }
  const double division = scouting.division(model.parts);
  const double axial = model.axial ? 0.0 : scouting.axial;
  estimate.error = division + axial;
  estimate.basis = fmt::format("division {}", percent_text(division));
  if (axial > 0.0) estimate.basis += fmt::format(", axial rigidity {}", percent_text(axial));
  return estimate;
}

/// All models, cheapest first.
std::vector<ElasticModel> rungs_of(const LadderCase& of, const Scouting& scouting) {
  std::vector<ElasticModel> rungs;
  if (scouting.rigid) rungs.push_back({});
  const bool both_kinds = has_bending_links(*of.mechanism);
  for (const int parts : divisions) {
    if (both_kinds) rungs.push_back(all_elements(parts, false));
    rungs.push_back(all_elements(parts, both_kinds));
  }
  return rungs;
}

/// What a model costs: its rigid elements, over which its equations are eliminated once.
double cost_of(const LadderCase& of, const ElasticModel& model) {
  const flexible::Mechanism mechanism = modelled(*of.mechanism, model);
  return static_cast<double>(flexible::structure_of(mechanism).elements());
}

std::string reason_of(const ModelChoice& choice, const LadderCase& of, const Scouting& scouting) {
  const ModelEstimate& chosen = choice.weighed.back();
  std::string reason = fmt::format(
      "{}: error of the governing stress estimated {} ({}), found {} against all "
      "elements of a finer division, tolerance {}",
      describe(chosen.model), percent_text(chosen.error), chosen.basis, percent_text(*chosen.found),
      percent_text(choice.tolerance));
  if (choice.weighed.size() > 1) {
    const ModelEstimate& cheaper = choice.weighed[choice.weighed.size() - 2];
    reason += fmt::format("; the next cheaper, {}, would miss by {}", describe(cheaper.model),
                          percent_text(cheaper.found.value_or(cheaper.error)));
  }
  if (chosen.model.parts > 0) {
    ElasticModel better = chosen.model;
    better.parts *= 2;
    const double more = cost_of(of, better) / cost_of(of, chosen.model);
    reason += fmt::format("; twice as many parts would cost {:.2g} times as much", more);
  }
  if (of.mechanism->frequency > 0.0 && !scouting.frequencies.empty()) {
    reason += fmt::format("; the load's {:.4g} Hz stand against natural frequencies of",
                          of.mechanism->frequency);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, scouting.frequencies.size()); ++i) {
      reason += fmt::format("{} {:.4g}", i == 0 ? "" : ",", scouting.frequencies[i]);
    }
    reason += " Hz";
  }
  if (has_bending_links(*of.mechanism)) {
    reason += fmt::format(
        "; bending links taken as rigid along their axes would change it by "
        "{}",
        percent_text(scouting.axial));
  }
  reason += fmt::format("; links rigid in shear by {}", percent_text(scouting.shear));
  return reason;
}

/// Why no model is good enough, with what to do.
std::string why_none(const LadderCase& of, const Scouting& scouting) {
  const double drive = of.mechanism->frequency;
  if (drive == 0.0) {
    return fmt::format("{} parts of every link run out before; ask for a larger tolerance",
                       divisions.back());
  }
  constexpr double near = 0.05;
  for (const double frequency : scouting.frequencies) {
    if (std::abs(drive - frequency) > near * frequency) continue;
    return fmt::format(
        "the load's {:.6g} Hz are too near the natural frequency of {:.6g} Hz for this; ask for a "
        "larger tolerance, or give damping",
        drive, frequency);
  }
  std::vector<std::string> frequencies;
  for (const double frequency : scouting.frequencies) {
    frequencies.push_back(fmt::format("{:.4g}", frequency));
  }
  return fmt::format(
      "at {:.6g} Hz, with natural frequencies of {} Hz, {} parts of every link run out before; ask "
      "for a larger tolerance",
      drive, fmt::join(frequencies, ", "), divisions.back());
}

}  // namespace

std::string percent_text(double fraction) {
  const double percent = 100.0 * fraction;
  return percent < 100.0 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string describe(const ElasticModel& model) {
  std::string text = to_text(model.level);
  if (model.level == ModelLevel::modal) {
    text += fmt::format(", {} mode{}", model.modes, model.modes == 1 ? "" : "s");
  }
  if (model.parts > 0) text += fmt::format(", {} parts per link", model.parts);
  if (model.axial) text += ", elastic along the axes as well";
  return text;
}

std::vector<ComparedPlace> places_of(const LadderCase& of) {
  std::vector<Length> joints;
  const auto add = [&](const flexible::Attachment& at) {
    if (at.link == of.link) joints.push_back(si<Length>(at.p.x()));
  };
  for (const flexible::Joint& joint : of.mechanism->joints) {
    add(joint.a);
    add(joint.b);
  }
  for (const flexible::Load& load : of.mechanism->loads) add(load.at);
  return compared_places_of(*of.beam, joints);
}

VibratingStress stresses_by(const LadderCase& of, const ElasticModel& model,
                            const std::vector<ComparedPlace>& places) {
  const flexible::Mechanism mechanism = modelled(*of.mechanism, model);
  const flexible::Structure structure = flexible::structure_of(mechanism);
  return stresses_of(of, response_of(structure, model), structure, places);
}

double error_of(const LadderCase& of, const ElasticModel& model) {
  constexpr int finer = 64;
  const std::vector<ComparedPlace> places = places_of(of);
  return difference_between(stresses_by(of, model, places),
                            stresses_by(of, all_elements(finer, true), places));
}

ModelChoice climb_ladder(const LadderCase& of, double tolerance) {
  const std::vector<ComparedPlace> places = places_of(of);
  const Scouting scouting = scout(of, places);
  ModelChoice choice;
  choice.tolerance = tolerance;
  choice.frequencies = scouting.frequencies;
  if (of.mechanism->frequency > 0.0) choice.harmonics = {{of.mechanism->frequency, 1.0}};
  for (const ElasticModel& rung : rungs_of(of, scouting)) {
    ModelEstimate& estimate = choice.weighed.emplace_back(estimate_of(rung, scouting));
    if (estimate.error > doubt * tolerance) continue;
    const int better = std::max(2 * rung.parts, better_parts);
    estimate.found = difference_between(stresses_by(of, rung, places),
                                        stresses_by(of, all_elements(better, true), places)) +
                     2.0 * scouting.division(better);
    if (*estimate.found > tolerance) continue;
    choice.chosen = rung;
    choice.reason = reason_of(choice, of, scouting);
    return choice;
  }
  throw AnalysisError({fmt::format("no model of the elastic links is known to be within {} of the "
                                   "governing stress: {}",
                                   percent_text(tolerance), why_none(of, scouting)),
                       "",
                       {},
                       choice.weighed.back().found});
}

}  // namespace boxbeam
