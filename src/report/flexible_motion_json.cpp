#include "document_fields.hpp"

namespace boxbeam::report {
namespace {

/// A phasor as [re, im].
void put_phasor(Fields& to, const Field& field, const char* unit,
                const std::complex<double>& value) {
  const double parts[] = {value.real(), value.imag()};
  to.numbers(field, unit, parts, {"re", "im"});
}

void put_error(Fields& to, const DiscretisationError& error) {
  to.number("error", "1", error.error);
  to.number_or_null("order", "1", error.order);
}

std::string name_of_vibration(const auto& of) { return of.name; }

/// Errors of the forces and of the displacements, whichever `error` says.
template <class Error>
void put_errors(Fields& to, const FlexibleMotionResult& motion, const Error& error) {
  to.named("joints", motion.joints, name_of_vibration<JointVibration>,
           [&](Fields& of, const JointVibration& joint) { put_error(of, error(joint.force)); });
  to.named("points", motion.points, name_of_vibration<PointVibration>,
           [&](Fields& of, const PointVibration& point) { put_error(of, error(point.motion)); });
}

void put_static(Fields& to, const FlexibleMotionResult& motion) {
  to.named("joints", motion.joints, name_of_vibration<JointVibration>,
           [](Fields& of, const JointVibration& joint) {
             of.text("on", joint.on);
             of.number("fx", "N", joint.force.constant.x());
             of.number("fy", "N", joint.force.constant.y());
             of.number("moment", "N m", joint.force.constant.z());
             of.number("magnitude", "N", joint.force.magnitude);
           });
  to.named({"points", "displacements"}, motion.points, name_of_vibration<PointVibration>,
           [](Fields& of, const PointVibration& point) {
             of.number("x", "m", point.motion.constant.x());
             of.number("y", "m", point.motion.constant.y());
           });
}

void put_harmonic(Fields& to, const FlexibleMotionResult& motion) {
  to.number("frequency", "Hz", motion.frequency);
  to.named("joints", motion.joints, name_of_vibration<JointVibration>,
           [](Fields& of, const JointVibration& joint) {
             of.text("on", joint.on);
             put_phasor(of, "fx", "N", joint.force.amplitude.x());
             put_phasor(of, "fy", "N", joint.force.amplitude.y());
             put_phasor(of, "moment", "N m", joint.force.amplitude.z());
             of.number({"magnitude", "largest over the period"}, "N", joint.force.largest);
           });
  to.named("points", motion.points, name_of_vibration<PointVibration>,
           [](Fields& of, const PointVibration& point) {
             put_phasor(of, "x", "m", point.motion.amplitude.x());
             put_phasor(of, "y", "m", point.motion.amplitude.y());
             of.number("magnitude", "m", point.motion.largest);
           });
}

}  // namespace

void put_motion(Fields& to, const FlexibleMotionResult& motion) {
  const bool vibrates = to.is_describing() || motion.frequency > 0.0;
  to.constant("schema", "boxbeam.motion/1");
  to.constant("kind", "flexible");
  to.whole("degrees_of_freedom", motion.degrees_of_freedom, "1");
  std::vector<double> frequencies;
  for (const NaturalFrequency& of : motion.frequencies) frequencies.push_back(of.frequency);
  to.numbers({"frequencies", "natural, lowest first"}, "Hz", frequencies);
  to.object("static", [&](Fields& of) { put_static(of, motion); });
  if (vibrates) {
    to.optional().object(
        {"harmonic",
         "phasors of e^(i omega t), of which the imaginary part counts; only where loads vibrate"},
        [&](Fields& of) { put_harmonic(of, motion); });
  }
  to.object("discretisation", [&](Fields& all) {
    all.whole("elements", motion.elements, "1");
    all.wholes("compared_with", {2, 4});
    all.list("frequencies", "", motion.frequencies,
             [](Fields& of, const NaturalFrequency& at) { put_error(of, at.error); });
    all.object("static", [&](Fields& of) {
      put_errors(of, motion, [](const auto& at) { return at.constant_error; });
    });
    if (!vibrates) return;
    all.optional().object("harmonic", [&](Fields& of) {
      put_errors(of, motion, [](const auto& at) { return at.amplitude_error; });
    });
  });
}

}  // namespace boxbeam::report
