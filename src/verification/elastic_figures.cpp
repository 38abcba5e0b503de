#include "boxbeam/verification/elastic_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/elastic_posture.hpp"
#include "boxbeam/verification/flexible_motion_result.hpp"
#include "boxbeam/verification/sudden_start.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t modes_drawn = 6;

JointLines named_lines(const flexible::Mechanism& mechanism) {
  JointLines lines;
  for (const flexible::Joint& joint : mechanism.joints) lines.names.push_back(joint.name);
  lines.force.resize(lines.names.size());
  return lines;
}

std::vector<PostureFigure> mode_figures(const Project& project,
                                        const flexible::Structure& structure,
                                        const std::vector<flexible::Mode>& modes) {
  constexpr double part = 0.1;
  std::vector<PostureFigure> figures;
  for (std::size_t i = 0; i < std::min(modes_drawn, modes.size()); ++i) {
    const double largest = largest_displacement(modes[i].shape.motion);
    const DeformedPosture posture{&structure, modes[i].shape,
                                  magnification_of(structure, largest, part)};
    figures.push_back(
        posture_figure(project, posture, fmt::format("{:.4g} Hz", modes[i].frequency)));
  }
  return figures;
}

/// Frequencies from near zero to beyond the drive and the modes drawn, none of them a natural one,
/// where an undamped amplitude has no limit.
std::vector<double> swept_frequencies(double drive, const std::vector<flexible::Mode>& modes) {
  constexpr int count = 800;
  double top = 1.8 * drive;
  if (!modes.empty()) {
    top = std::max(top, 1.1 * modes[std::min(modes_drawn, modes.size()) - 1].frequency);
  }
  std::vector<double> frequencies;
  for (int i = 1; i <= count; ++i) {
    double frequency = top * i / count;
    for (const flexible::Mode& mode : modes) {
      const bool near = std::abs(frequency - mode.frequency) < 1e-4 * mode.frequency;
      if (near) frequency = (1.0 + 2e-4) * mode.frequency;
    }
    frequencies.push_back(frequency);
  }
  return frequencies;
}

/// By the exact form at every frequency.
JointLines exact_lines_over_frequency(const flexible::Structure& structure,
                                      const std::vector<flexible::Mode>& modes) {
  JointLines lines = named_lines(*structure.mechanism);
  lines.at = swept_frequencies(structure.mechanism->frequency, modes);
  for (const double frequency : lines.at) {
    const auto response = flexible::harmonic_response(structure, frequency);
    for (std::size_t j = 0; j < lines.names.size(); ++j) {
      const Eigen::Vector3cd force = flexible::joint_force(structure, j, response);
      lines.force[j].push_back(flexible::largest_length(force.x(), force.y()));
    }
  }
  return lines;
}

JointLines lines_over_frequency(const flexible::ModalModel& model) {
  const flexible::Mechanism& mechanism = *model.structure->mechanism;
  JointLines lines = named_lines(mechanism);
  const flexible::Sweep sweep =
      flexible::sweep_of(model, swept_frequencies(mechanism.frequency, model.modes));
  lines.at = sweep.frequencies;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    for (const Eigen::Vector3cd& force : sweep.joints[j]) {
      lines.force[j].push_back(flexible::largest_length(force.x(), force.y()));
    }
  }
  return lines;
}

JointLines lines_over_period(const FlexibleMotion& motion) {
  constexpr int count = 200;
  JointLines lines = named_lines(*motion.mechanism);
  for (int i = 0; i <= count; ++i) {
    const double time = i / (count * motion.response.frequency);
    const auto now = flexible::at(motion.response, time);
    lines.at.push_back(time);
    for (std::size_t j = 0; j < lines.names.size(); ++j) {
      lines.force[j].push_back(flexible::joint_force(*motion.structure, j, now).head<2>().norm());
    }
  }
  return lines;
}

/// Without instants where the start is not resolved: what is not asked for hinders no verdict.
JointLines lines_after_start(const flexible::ModalModel& model) {
  const flexible::Mechanism& mechanism = *model.structure->mechanism;
  JointLines lines = named_lines(mechanism);
  if (model.damping.size() == 0) return lines;
  constexpr double most_steps = 4000.0;  // drawn; it ends sooner
  const StartSpan span = start_span_of(model);
  if (!span.is_resolved) return lines;
  const double shown = std::min(1.0, most_steps / span.steps);
  const flexible::SuddenStart start = flexible::sudden_start_of(
      model, shown * span.length, static_cast<std::size_t>(std::lround(shown * span.steps)));
  lines.at = start.times;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    for (const Eigen::Vector3d& force : start.joints[j]) {
      lines.force[j].push_back(force.head<2>().norm());
    }
  }
  return lines;
}

/// Of the exact form as many modes as a start has; where they are not found, what is not asked for
/// hinders no verdict: those that are drawn, without damping.
VibratingModes modes_to_draw(const flexible::Mechanism& mechanism) {
  try {
    return modes_beyond_drive(mechanism);
  } catch (const AnalysisError&) {
    if (mechanism.element != flexible::Element::exact) throw;
    VibratingModes of;
    of.mechanism = std::make_shared<const flexible::Mechanism>(mechanism);
    of.structure =
        std::make_shared<const flexible::Structure>(flexible::structure_of(*of.mechanism));
    of.modal = {of.structure.get(), flexible::modes_of(*of.structure, modes_drawn), {}};
    return of;
  }
}

}  // namespace

ElasticFigures elastic_figures_of(const Project& project, const SituationRun& run,
                                  const ElasticModel& model) {
  Project as_solved = project;
  flexible_of(as_solved) = with_all_elements(flexible_in(project, *run.situation), model);
  const FlexibleMotion motion =
      flexible_motion_of(flexible_of(as_solved), {ModelLevel::flexible, 0, 0, {}, false});
  const flexible::Structure& structure = *motion.structure;
  ElasticFigures figures;
  figures.motion = flexible_motion_of(as_solved);
  figures.rest =
      posture_figure(project, {&structure, {flexible::no_loads<double>(structure), {}}, 1.0}, "");
  const VibratingModes of = modes_to_draw(*motion.mechanism);
  figures.modes = mode_figures(project, *of.structure, of.modal.modes);
  if (motion.response.frequency == 0.0) return figures;
  figures.over_frequency = motion.mechanism->element == flexible::Element::exact
                               ? exact_lines_over_frequency(structure, of.modal.modes)
                               : lines_over_frequency(of.modal);
  figures.after_start = lines_after_start(of.modal);
  figures.over_period = lines_over_period(motion);
  return figures;
}

}  // namespace boxbeam
