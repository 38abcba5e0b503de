#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/common/driver.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "src/verification/bent_in_space.hpp"
#include "src/verification/elastic_motion_in_space.hpp"

/// An arm in mechanisms of space, and what its loads are compared by.
namespace test::space_arm {

/// An arm of 4 m along x, a box, with what `joints` say around it. `points`: further ones of it;
/// `gravity`: down along z.
inline std::string arm(const std::string& joints, const std::string& beam,
                       const std::string& model = "", double gravity = 0.0,
                       const std::string& points = "") {
  return fmt::format(R"([case]
name = "arm"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "{:.15g} m/s^2"]
[bodies.arm]
points = {{ heel = ["0 m", "0 m", "0 m"], mid = ["1.5 m", "0 m", "0 m"], tip = ["4 m", "0 m", "0 m"]{} }}
)",
                     0.0 - gravity, points) +
         joints +
         R"(
[sections.arm]
kind = "box"
width = "120 mm"
height = "160 mm"
flange = "8 mm"
web = "6 mm"
[beam]
body = "arm"
start = "heel"
axis = "x"
z = "z"
)" + beam +
         R"(
[[beam.segments]]
length = "4 m"
section = "arm"
[material]
steel = "S355"
[strength]
required = 1.0
)" + model;
}

inline const std::string steel = "density = \"7850 kg/m^3\"\nrotary_inertia = true\n";
inline const std::string light = "density = \"1e-3 kg/m^3\"\n";

/// A body beside the tip: with the arm it makes an L that leans.
inline const std::string beside = R"(
[bodies.load]
mass = "120 kg"
centre = ["0.1 m", "1.2 m", "-0.4 m"]
inertia = [["9 kg m^2", "1 kg m^2", "-2 kg m^2"], ["1 kg m^2", "6 kg m^2", "0.5 kg m^2"], ["-2 kg m^2", "0.5 kg m^2", "11 kg m^2"]]
points = { c = ["0 m", "0 m", "0 m"] }
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
)";

/// The keys of a driver that swings.
inline std::string swinging(double amplitude, double frequency, double mean = 0.0) {
  return fmt::format(
      "kind = \"harmonic\"\nmean = \"{:.15g} rad\"\namplitude = \"{:.15g} rad\"\nfrequency = "
      "\"{:.15g} Hz\"\n",
      mean, amplitude, frequency);
}

/// Those of one that turns once, from rest to rest; `unit`: of what it moves.
inline std::string stepping(double to, double end, const std::string& unit = "rad") {
  return fmt::format(
      "kind = \"smooth step\"\nfrom = \"0 {0}\"\nto = \"{1:.15g} {0}\"\nend = \"{2:.15g} s\"\n",
      unit, to, end);
}

/// The heel on the ground, a hinge about any axis.
inline std::string hinge(const Eigen::Vector3d& axis, const std::string& driver) {
  return fmt::format(R"(
[joints.heel]
kind = "revolute"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = [{:.15g}, {:.15g}, {:.15g}]
[drivers.turning]
joint = "heel"
{})",
                     axis.x(), axis.y(), axis.z(), driver);
}

inline std::string hinge(const Eigen::Vector3d& axis, double amplitude, double frequency) {
  return hinge(axis, swinging(amplitude, frequency));
}

/// The heel on a column that turns about an axis that lies as it will, on a ground that is turned.
inline std::string slewing(const std::string& ground_turn, const std::string& driver) {
  return fmt::format(R"(
[bodies.base]
points = {{ o = ["0 m", "0 m", "0 m"] }}
[bodies.column]
mass = "50 kg"
centre = ["0 m", "0 m", "0.5 m"]
inertia = ["4 kg m^2", "4 kg m^2", "1 kg m^2"]
points = {{ a = ["0 m", "0 m", "0 m"], b = ["0 m", "0 m", "1 m"] }}
[joints.base]
kind = "fixed"
connect = ["ground", "base.o"]
at = ["1 m", "-2 m", "3 m"]
{}
[joints.slew]
kind = "revolute"
connect = ["base.o", "column.a"]
axis = [0.48, -0.6, 0.64]
[joints.root]
kind = "fixed"
connect = ["column.b", "arm.heel"]
turn = [["y", "-20 deg"], ["x", "30 deg"]]
[drivers.slewing]
joint = "slew"
{})",
                     ground_turn, driver);
}

/// A case whose rigid bodies have moved.
struct Moved {
  explicit Moved(const std::string& text) : Moved(boxbeam::parse_project("arm.toml", text)) {}
  explicit Moved(boxbeam::Project of)
      : project(std::move(of)), runs(boxbeam::run_situations(project)) {}

  const boxbeam::LoadHistory& rigid() const { return runs.front().loads; }
  const boxbeam::spatial::Chain& chain() const { return boxbeam::chain_of(runs.front()); }
  boxbeam::ElasticMotionInSpace by(std::size_t modes, int parts, std::size_t instants = 0) const {
    boxbeam::LoadSpan span = rigid().span();
    if (instants > 0) span.instants = instants;
    return {project, chain(), span, [this](boxbeam::Time time) { return rigid().loads_at(time); },
            modes,   parts};
  }
  /// The same with statics of the second order.
  boxbeam::ElasticMotionInSpace bent_by(std::size_t modes, int parts,
                                        std::size_t instants = 0) const {
    boxbeam::LoadSpan span = rigid().span();
    if (instants > 0) span.instants = instants;
    const auto of_rigid = [this](boxbeam::Time time) { return rigid().loads_at(time); };
    return {project, chain(), span, of_rigid, modes, parts, bent(parts)};
  }
  boxbeam::LoadsAt bent(int parts) const {
    const boxbeam::LoadSpan& span = rigid().span();
    const auto states = std::make_shared<const boxbeam::spatial::StatesAround>(
        chain(), boxbeam::spatial::Motion{span.begin.value(), span.period.value(), span.closed,
                                          span.instants});
    return boxbeam::bent_statically_in_space(
        project, chain(), [states](double time) { return states->at(time); }, parts,
        [this](boxbeam::Time time) { return rigid().loads_at(time); });
  }
  std::vector<boxbeam::frame::BeamMode> modes(int parts, std::size_t count) const {
    boxbeam::StoppedVibration stopped(project, chain(), parts);
    const double begin = rigid().begin().value();
    return stopped.modes(chain().at(begin), rigid().diagram_at(boxbeam::si<boxbeam::Time>(begin)),
                         count);
  }
  boxbeam::Time at(double part) const { return rigid().begin() + part * rigid().period(); }

  boxbeam::Project project;
  std::deque<boxbeam::SituationRun> runs;
};

using Cuts = Eigen::Matrix<double, 6, 1>;

inline Cuts cuts_of(const boxbeam::BeamLoads& loads, double s,
                    boxbeam::Side side = boxbeam::Side::behind) {
  return boxbeam::cuts_at(boxbeam::cut_forces_of(loads), {{boxbeam::si<boxbeam::Length>(s), side}});
}

/// What is left over beside the largest loads, forces times the beam's length.
inline double imbalance(const boxbeam::BeamLoads& loads, double length) {
  double largest = 0.0;
  for (const boxbeam::PointLoad& load : loads.points)
    largest = std::max({largest, load.force.norm() * length, load.moment.norm()});
  const boxbeam::Imbalance of = boxbeam::imbalance_of(loads);
  return std::max(of.force.norm() * length, of.moment.norm()) / largest;
}

/// Forces, then moments, of the same size.
inline void check_alike(const Cuts& found, const Cuts& expected, const Cuts& size, double within) {
  const double force = size.head<3>().norm(), moment = size.tail<3>().norm();
  INFO("found " << found.transpose() << "\nexpected " << expected.transpose());
  CHECK((found - expected).head<3>().norm() < within * force);
  CHECK((found - expected).tail<3>().norm() < within * moment);
}

/// A tapered box beam of 12 m on a hinge; sizes of its tip [mm], shear modulus [GPa].
inline std::string slender(const Eigen::Vector3d& axis, const std::string& driver, int width,
                           int height, double G) {
  return fmt::format(R"([case]
name = "shaken"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.arm]
points = {{ heel = ["0 m", "0 m", "0 m"] }}
[joints.base]
kind = "revolute"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = [{:.15g}, {:.15g}, {:.15g}]
[drivers.turning]
joint = "base"
{}[sections.root]
kind = "box"
width = "80 mm"
height = "100 mm"
flange = "5 mm"
web = "5 mm"
[sections.tip]
kind = "box"
width = "{} mm"
height = "{} mm"
flange = "5 mm"
web = "5 mm"
[beam]
body = "arm"
start = "heel"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "12 m"
from = "root"
to = "tip"
[material]
steel = "S355"
[strength]
required = 1.0
[model]
youngs_modulus = "210 GPa"
shear_modulus = "{} GPa"
)",
                     axis.x(), axis.y(), axis.z(), driver, width, height, G);
}

/// A point mass at the tip of an arm without mass, rigid in shear, that swings far about an axis
/// through its heel, in its own axes:
///
///     m (u'' + 2 w x u' + w' x u + w x (w x u)) + K u + d K_0 u' = -m (w' x r + w x (w x r))
///
/// K = diag(EA/L, k_z, k_y), k = N/(L (1 - tanh(x)/x)), x = L (N/EI)^(1/2), in compression of tan,
/// of the pull N of the rigid motion; by Runge and Kutta, periodic from the start that repeats.
/// Sources: Goldstein, Classical Mechanics (1980), 4-10; Timoshenko, Gere, Theory of Elastic
/// Stability (1961), 1.
struct SwungMass {
  using State = Eigen::Matrix<double, 6, 1>;
  double m, L, EA, EI_y, EI_z, delay;
  Eigen::Vector3d axis;
  boxbeam::Driver angle;
  static constexpr int steps = 9600;

  double stiffness(double EI, double N) const {
    const double x = L * std::sqrt(std::abs(N) / EI);
    if (x < 1e-4) return 3.0 * EI / (L * L * L) + 1.2 * N / L;
    return N / (L * (1.0 - (N > 0.0 ? std::tanh(x) : std::tan(x)) / x));
  }
  State rate(double t, const State& y, double load) const {
    const boxbeam::DriverState at = boxbeam::driver_at(angle, t);
    const Eigen::Vector3d w = axis * at.rate, change = axis * at.acceleration, r(L, 0.0, 0.0),
                          u = y.head<3>(), v = y.tail<3>();
    const Eigen::Vector3d rigid = change.cross(r) + w.cross(w.cross(r));
    const double N = -m * rigid.x();
    const Eigen::Vector3d K(EA / L, stiffness(EI_z, N), stiffness(EI_y, N)),
        K_0(EA / L, 3.0 * EI_z / (L * L * L), 3.0 * EI_y / (L * L * L));
    State of;
    of.head<3>() = v;
    of.tail<3>() = -load * rigid - 2.0 * w.cross(v) - change.cross(u) - w.cross(w.cross(u)) -
                   (K.cwiseProduct(u) + delay * K_0.cwiseProduct(v)) / m;
    return of;
  }
  /// From t = 0 in so many steps.
  std::vector<State> path(const State& start, double load, double length) const {
    std::vector<State> states{start};
    const double h = length / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = h * i;
      const State y = states.back(), a = rate(t, y, load),
                  b = rate(t + 0.5 * h, y + 0.5 * h * a, load),
                  c = rate(t + 0.5 * h, y + 0.5 * h * b, load), d = rate(t + h, y + h * c, load);
      states.push_back(y + h / 6.0 * (a + 2.0 * b + 2.0 * c + d));
    }
    return states;
  }
  std::vector<State> periodic(double period) const {
    Eigen::Matrix<double, 6, 6> free;
    for (int i = 0; i < 6; ++i) free.col(i) = path(State::Unit(i), 0.0, period).back();
    const State forced = path(State::Zero(), 1.0, period).back();
    const Eigen::Matrix<double, 6, 6> open = Eigen::Matrix<double, 6, 6>::Identity() - free;
    return path(open.lu().solve(forced), 1.0, period);
  }
};

}  // namespace test::space_arm
