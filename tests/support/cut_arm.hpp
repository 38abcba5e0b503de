#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <numbers>
#include <string>
#include <utility>

#include "support/space_arm.hpp"

/// An arm in space of one beam or of several that are joined, each of which may be verified.
namespace test::cut_arm {

using space_arm::Moved;

inline constexpr double pi = std::numbers::pi, E = 210e9, G = 81e9;

inline const std::string sections = R"(
[sections.root]
kind = "box"
width = "120 mm"
height = "160 mm"
flange = "8 mm"
web = "6 mm"
[sections.thin]
kind = "box"
width = "100 mm"
height = "120 mm"
flange = "6 mm"
web = "5 mm"
)";

inline const std::string demands = R"(
[material]
steel = "S355"
[strength]
required = 1.0
)";

inline std::string body(const char* name, double length) {
  return fmt::format(
      "[bodies.{}]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"{} m\", \"0 m\", \"0 m\"] "
      "}}\n",
      name, length);
}

inline std::string segment(double length, const char* section) {
  return fmt::format("[[beam.segments]]\nlength = \"{} m\"\nsection = \"{}\"\n", length, section);
}

inline std::string beam(const char* name, const std::string& segments) {
  return fmt::format(
             "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\nstart = \"A\"\naxis = \"x\"\nz = \"z\"\n"
             "density = \"7850 kg/m^3\"\nrotary_inertia = true\n",
             name) +
         segments;
}

inline std::string mechanism(double gravity) {
  return fmt::format(
      "[case]\nname = \"arm\"\nkind = \"spatial\"\n[mechanism]\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-{} m/s^2\"]\n",
      gravity);
}

inline std::string hinge(const Eigen::Vector3d& axis, double amplitude, double frequency) {
  return fmt::format(R"(
[joints.heel]
kind = "revolute"
connect = ["ground", "inner.A"]
at = ["0 m", "0 m", "0 m"]
axis = [{:.15g}, {:.15g}, {:.15g}]
[drivers.turning]
joint = "heel"
kind = "harmonic"
mean = "0 rad"
amplitude = "{:.15g} rad"
frequency = "{:.15g} Hz"
)",
                     axis.x(), axis.y(), axis.z(), amplitude, frequency);
}

inline const std::string clamp = R"(
[joints.heel]
kind = "fixed"
connect = ["ground", "inner.A"]
at = ["0 m", "0 m", "0 m"]
)";

/// A body beside the tip, in axes of its own.
inline std::string load_at(const char* tip) {
  return fmt::format(R"(
[bodies.load]
mass = "80 kg"
centre = ["0.1 m", "0.6 m", "-0.3 m"]
inertia = [["9 kg m^2", "1 kg m^2", "-2 kg m^2"], ["1 kg m^2", "6 kg m^2", "0.5 kg m^2"], ["-2 kg m^2", "0.5 kg m^2", "11 kg m^2"]]
points = {{ c = ["0 m", "0 m", "0 m"] }}
[joints.tip]
kind = "fixed"
connect = ["{}", "load.c"]
turn = [["z", "40 deg"]]
)",
                     tip);
}

inline std::string push_at(const char* tip, const char* direction, double mean, double amplitude) {
  return fmt::format(R"(
[forces.push]
kind = "force"
point = "{}"
direction = {}
law = {{ kind = "harmonic", mean = "{:.15g} N", amplitude = "{:.15g} N", frequency = "1 Hz" }}
)",
                     tip, direction, mean, amplitude);
}

inline const char* tip_of(bool cut) { return cut ? "outer.B" : "inner.B"; }

/// An arm of 4 m along x, of `root` to its middle and `thin` beyond, as one beam or as two that are
/// joined rigidly, with what else is said.
inline std::string arm(bool cut, const std::string& around, const char* inner = "root",
                       const char* outer = "thin", const std::string& more = "",
                       double gravity = 9.81) {
  std::string text = mechanism(gravity) + body("inner", cut ? 2.0 : 4.0);
  if (cut) {
    text += body("outer", 2.0) +
            "[joints.cut]\nkind = \"fixed\"\nconnect = [\"inner.B\", \"outer.A\"]\n";
  }
  text += around + sections;
  text += cut ? beam("inner", segment(2.0, inner)) + beam("outer", segment(2.0, outer))
              : beam("inner", segment(2.0, inner) + segment(2.0, outer));
  return text + demands + more;
}

inline Moved moved(const std::string& text, std::size_t beam = 0) {
  return Moved(boxbeam::parse_beams("arm.toml", text)[beam]);
}

/// The other beams count as rigid bodies.
inline Moved alone(const std::string& text, std::size_t beam = 0) {
  boxbeam::Project project = boxbeam::parse_beams("arm.toml", text)[beam];
  project.elastic_beside.clear();
  return Moved(std::move(project));
}

inline constexpr double first_length = 4.0, second_length = 3.0;

/// An L: the second beam leaves the tip of the first, turned out of all planes.
inline std::string bent_arm(const std::string& around, const std::string& more = "") {
  return mechanism(0.0) + body("inner", first_length) + body("outer", second_length) + around + R"(
[joints.knee]
kind = "fixed"
connect = ["inner.B", "outer.A"]
turn = [["z", "70 deg"], ["x", "35 deg"]]
)" + sections +
         beam("inner", segment(first_length, "root")) +
         beam("outer", segment(second_length, "thin")) + demands + more;
}

}  // namespace test::cut_arm
