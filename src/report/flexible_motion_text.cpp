#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using layout::Table;

/// Six digits; zero for what is round-off beside `size`, and never "-0".
std::string number(double value, double size) {
  return fmt::format("{:.6g}", std::abs(value) <= 1e-12 * size ? 0.0 : value);
}

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

std::string static_tables(const FlexibleMotionResult& motion) {
  double size = 0.0;
  for (const JointVibration& joint : motion.joints) size = std::max(size, joint.force.magnitude);
  std::vector<std::string> header{"joint", "on", "fx [N]", "fy [N]"};
  const bool moments = turns(motion);
  if (moments) header.emplace_back("moment [N m]");
  header.insert(header.end(), {"magnitude [N]", "stated error [N]"});
  Table joints(header);
  for (const JointVibration& joint : motion.joints) {
    const Eigen::Vector3d& force = joint.force.constant;
    std::vector<std::string> row{joint.name, joint.on, number(force.x(), size),
                                 number(force.y(), size)};
    if (moments) row.push_back(number(force.z(), size));
    row.push_back(number(joint.force.magnitude, size));
    row.push_back(error_text(joint.force.constant_error, size));
    joints.row(row);
  }
  double far = 0.0;
  for (const PointVibration& point : motion.points) far = std::max(far, point.motion.magnitude);
  Table points({"point", "x [mm]", "y [mm]", "stated error [mm]"});
  for (const PointVibration& point : motion.points) {
    const Eigen::Vector2d at = 1e3 * point.motion.constant;
    DiscretisationError error = point.motion.constant_error;
    error.error *= 1e3;
    points.row({point.name, number(at.x(), 1e3 * far), number(at.y(), 1e3 * far),
                error_text(error, 1e3 * far)});
  }
  return joints.text() + "\n" + points.text();
}

std::string harmonic_tables(const FlexibleMotionResult& motion) {
  double size = 0.0;
  for (const JointVibration& joint : motion.joints) size = std::max(size, joint.force.largest);
  std::vector<std::string> header{"joint", "on", "fx [N]", "fy [N]"};
  const bool moments = turns(motion);
  if (moments) header.emplace_back("moment [N m]");
  header.insert(header.end(), {"largest [N]", "stated error [N]"});
  Table joints(header);
  for (const JointVibration& joint : motion.joints) {
    const Eigen::Vector3cd& force = joint.force.amplitude;
    std::vector<std::string> row{joint.name, joint.on, phase_text(force.x(), size),
                                 phase_text(force.y(), size)};
    if (moments) row.push_back(phase_text(force.z(), size));
    row.push_back(number(joint.force.largest, size));
    row.push_back(error_text(joint.force.amplitude_error, size));
    joints.row(row);
  }
  double far = 0.0;
  for (const PointVibration& point : motion.points) far = std::max(far, point.motion.largest);
  Table points({"point", "x [mm]", "y [mm]", "largest [mm]", "stated error [mm]"});
  for (const PointVibration& point : motion.points) {
    const Eigen::Vector2cd at = 1e3 * point.motion.amplitude;
    DiscretisationError error = point.motion.amplitude_error;
    error.error *= 1e3;
    points.row({point.name, phase_text(at.x(), 1e3 * far), phase_text(at.y(), 1e3 * far),
                number(1e3 * point.motion.largest, 1e3 * far), error_text(error, 1e3 * far)});
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
  out += "\n" + layout::heading("Weight and constant loads") + static_tables(motion);
  if (motion.frequency == 0.0) return out;
  out += "\n" + layout::heading(fmt::format("Harmonic loads at {:.6g} Hz", motion.frequency));
  out += layout::paragraph(
      "Size and phase of each component against sin(2 pi f t); \"largest\" is the longest that the "
      "vector gets in a period.");
  out += harmonic_tables(motion);
  return out;
}

}  // namespace boxbeam
