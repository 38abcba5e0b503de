#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/common/driver.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
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

/// The heel on the ground, on a rail along z, and a point mass at the tip.
inline const std::string clamped = R"(
[joints.heel]
kind = "fixed"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
)";
inline std::string on_rail(const std::string& driver) {
  return R"(
[joints.heel]
kind = "prismatic"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = "z"
[drivers.lifting]
joint = "heel"
)" + driver;
}
inline std::string with_load(double mass, const std::string& more = "") {
  return fmt::format(R"(
[bodies.load]
mass = "{:.15g} kg"
{}points = {{ c = ["0 m", "0 m", "0 m"] }}
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
)",
                     mass, more);
}

/// Deflection of a clamped beam at its end along z under 1 N there, e beside its axis [m].
inline double give_of(const boxbeam::Section& section, double L, double e = 0.0) {
  constexpr double E = 210e9, G = 81e9;
  return std::pow(L, 3) / (3.0 * E * boxbeam::properties_of(section).I_y.value()) +
         L / (G * boxbeam::shear_areas_of(section).z.value()) +
         e * e * L / (G * boxbeam::torsion_properties_of(section).I_T->value());
}

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

/// Energy over a period of a small swing about an axis through the heel: what the drive does beyond
/// moving rigid bodies is what the material takes,
///
///     integral of M q' = retardation times the sum of omega_j^2 integral of eta_j'^2
///
/// for p_j is the work of inertia, and the heel's moment that of the modes. By sums over the even
/// instants, exact for few harmonics.
inline void check_dissipated(const Moved& of, const boxbeam::ElasticMotionInSpace& elastic,
                             const Eigen::Vector3d& axis, double amplitude, double frequency,
                             double retardation) {
  constexpr double full = 2.0 * std::numbers::pi;
  const Eigen::MatrixXd& eta = elastic.coordinates();
  const std::vector<boxbeam::frame::BeamMode> modes =
      of.modes(8, static_cast<std::size_t>(eta.cols()));
  const auto n = static_cast<double>(eta.rows());
  const double omega = full * frequency, period = of.rigid().period().value();
  double done = 0.0;
  Eigen::MatrixXcd first = Eigen::MatrixXcd::Zero(1, eta.cols());
  for (Eigen::Index i = 0; i < eta.rows(); ++i) {
    const double part = static_cast<double>(i) / n;
    const double rate = amplitude * omega * std::cos(full * part);
    const Cuts extra = cuts_of(elastic.loads_at(of.at(part)), 0.0) -
                       cuts_of(of.rigid().loads_at(of.at(part)), 0.0);
    // The cut behind the heel is what it does, reversed.
    done += -extra.tail<3>().dot(axis) * rate * period / n;
    first += std::exp(std::complex<double>(0.0, -full * part)) * eta.row(i) * (2.0 / n);
  }
  double dissipated = 0.0;
  for (Eigen::Index j = 0; j < eta.cols(); ++j) {
    const double natural = full * modes[static_cast<std::size_t>(j)].frequency;
    dissipated +=
        retardation * natural * natural * 0.5 * std::norm(first(0, j)) * omega * omega * period;
  }
  REQUIRE(dissipated > 0.0);
  CHECK(done == Approx(dissipated).epsilon(1e-5));
}

/// A tapered box beam of 12 m on a joint; sizes of its tip [mm].
inline std::string slender_on(const std::string& joint, int width, int height) {
  return R"([case]
name = "shaken"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[bodies.arm]
points = { heel = ["0 m", "0 m", "0 m"] }
)" + joint +
         R"([sections.root]
kind = "box"
width = "80 mm"
height = "100 mm"
flange = "5 mm"
web = "5 mm"
[sections.tip]
kind = "box"
flange = "5 mm"
web = "5 mm"
)" + fmt::format("width = \"{} mm\"\nheight = \"{} mm\"\n", width, height) +
         R"([beam]
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
)";
}

/// On a hinge; shear modulus [GPa].
inline std::string slender(const Eigen::Vector3d& axis, const std::string& driver, int width,
                           int height, double G) {
  return slender_on(hinge(axis, driver), width, height) +
         fmt::format("[model]\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"{} GPa\"\n", G);
}

/// What differs between a motion of the plane and the same in space at a place of the beam, over
/// `count` instants: moments about y, beyond those of the rigid one.
struct PlaneApart {
  double rigid = 0.0, vibrating = 0.0;  ///< the largest moments
  double apart = 0.0, across = 0.0;     ///< of those about y, and of what should be nothing

  template <class Expected, class Instant>
  PlaneApart(const Moved& of, const boxbeam::ElasticMotionInSpace& coarse,
             const boxbeam::ElasticMotionInSpace& fine, double s, int count,
             const Expected& expected_at, const Instant& instant) {
    for (int i = 0; i < count; ++i) {
      const boxbeam::Time time = instant(i);
      const Cuts expected = expected_at(time), stiff = cuts_of(of.rigid().loads_at(time), s);
      const auto beyond_rigid = [&](const boxbeam::ElasticMotionInSpace& by) -> Cuts {
        return cuts_of(by.loads_at(time), s) - stiff;
      };
      // Axial forces stand in the middles of pieces: the error falls with the square of these.
      const Cuts found = (4.0 * beyond_rigid(fine) - beyond_rigid(coarse)) / 3.0;
      apart = std::max(apart, std::abs(found[4] - expected[4]));
      across = std::max({across, std::abs(found[3]), std::abs(found[5])});
      rigid = std::max(rigid, std::abs(stiff[4]));
      vibrating = std::max(vibrating, std::abs(expected[4]));
    }
  }
};

}  // namespace test::space_arm
