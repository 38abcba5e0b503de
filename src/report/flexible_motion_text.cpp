#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using layout::number_beside;
using layout::Table;

/// "2.1e-05 (order 2.0)"; a word where it is round-off beside `size`, or no order is seen.
std::string error_text(const DiscretisationError& of, double size) {
  if (of.error <= 1e-9 * size) return "round-off";
  if (!of.order) return fmt::format("{:.1e} (order not seen)", of.error);
  return fmt::format("{:.1e} (order {:.1f})", of.error, *of.order);
}

std::string phase_text(const std::complex<double>& value, double size) {
  if (std::abs(value) <= 1e-12 * size) return "0";
  // From above -180 to 180, and no "-0".
  double degrees = std::round(std::arg(value) * 180.0 / std::numbers::pi * 1e2) * 1e-2;
  if (degrees <= -180.0) degrees += 360.0;
  return fmt::format("{:.6g} at {:.5g} deg", std::abs(value), degrees == 0.0 ? 0.0 : degrees);
}

std::string frequencies_table(const FlexibleMotionResult& motion) {
  Table table({"", "frequency [Hz]", "stated error [Hz]"});
  int index = 0;
  for (const NaturalFrequency& of : motion.frequencies) {
    table.row({fmt::format("{}", ++index), fmt::format("{:.6g}", of.frequency),
               error_text(of.error, of.frequency)});
  }
  return table.text();
}

bool turns(const FlexibleMotionResult& motion) {
  return std::any_of(motion.joints.begin(), motion.joints.end(), [](const JointVibration& joint) {
    return joint.force.constant.z() != 0.0 || joint.force.amplitude.z() != 0.0;
  });
}

/// Of what stands still, or of what vibrates: a component, how large it is and its error.
struct Shown {
  bool vibrates = false;

  template <int Size>
  std::string component(const Vibration<Size>& of, int i, double scale, double size) const {
    return vibrates ? phase_text(scale * of.amplitude[i], size)
                    : number_beside(scale * of.constant[i], size);
  }
  template <int Size>
  double length(const Vibration<Size>& of) const {
    return vibrates ? of.largest : of.magnitude;
  }
  template <int Size>
  DiscretisationError error(const Vibration<Size>& of) const {
    return vibrates ? of.amplitude_error : of.constant_error;
  }
};

std::string tables_of(const FlexibleMotionResult& motion, const Shown& shown) {
  double size = 0.0, far = 0.0;
  for (const JointVibration& joint : motion.joints)
    size = std::max(size, shown.length(joint.force));
  std::vector<std::string> header{"joint", "on", "fx [N]", "fy [N]"};
  const bool moments = turns(motion);
  if (moments) header.emplace_back("moment [N m]");
  header.insert(header.end(),
                {shown.vibrates ? "largest [N]" : "magnitude [N]", "stated error [N]"});
  Table joints(header);
  for (const JointVibration& joint : motion.joints) {
    std::vector<std::string> row{joint.name, joint.on};
    for (int i = 0; i < (moments ? 3 : 2); ++i)
      row.push_back(shown.component(joint.force, i, 1.0, size));
    row.push_back(number_beside(shown.length(joint.force), size));
    row.push_back(error_text(shown.error(joint.force), size));
    joints.row(row);
  }
  for (const PointVibration& point : motion.points)
    far = std::max(far, 1e3 * shown.length(point.motion));
  header = {"point", "x [mm]", "y [mm]"};
  if (shown.vibrates) header.emplace_back("largest [mm]");
  header.emplace_back("stated error [mm]");
  Table points(header);
  for (const PointVibration& point : motion.points) {
    DiscretisationError error = shown.error(point.motion);
    error.error *= 1e3;
    std::vector<std::string> row{point.name, shown.component(point.motion, 0, 1e3, far),
                                 shown.component(point.motion, 1, 1e3, far)};
    if (shown.vibrates) row.push_back(number_beside(1e3 * point.motion.largest, far));
    row.push_back(error_text(error, far));
    points.row(row);
  }
  return joints.text() + "\n" + points.text();
}

}  // namespace

std::string motion_text(const Project& project, const FlexibleMotionResult& motion) {
  std::string out = layout::line(visible(project.title) + ":");
  const bool exact = flexible_of(project).element == flexible::Element::exact;
  out += layout::paragraph(fmt::format(
      "{} {}, {} degrees of freedom", motion.elements,
      exact ? "nodes of continuous links" : "rigid finite elements", motion.degrees_of_freedom));
  out += layout::paragraph(
      "Forces are what a joint does to the link that is named, in world axes; displacements are "
      "from the unstressed posture. The stated error is what the division of the links leaves, "
      "with a margin: every value is computed again with each part cut into 2 and into 4 (factor "
      "1.25 on Richardson's estimate; 3 on the largest difference where no order of convergence "
      "is seen). It says nothing of the model's own error.");
  if (project.situations.size() > 1) {
    out += layout::paragraph(
        "This is the case as it stands; what its situations change is not part of it.");
  }
  out += "\n" + layout::heading("Natural frequencies, undamped") + frequencies_table(motion);
  out += "\n" + layout::heading("Weight and constant loads") + tables_of(motion, {false});
  if (motion.frequency == 0.0) return out;
  out += "\n" + layout::heading(fmt::format("Harmonic loads at {:.6g} Hz", motion.frequency));
  out += layout::paragraph(
      "Size and phase of each component against sin(2 pi f t); \"largest\" is the longest that the "
      "vector gets in a period.");
  out += tables_of(motion, {true});
  return out;
}

}  // namespace boxbeam
