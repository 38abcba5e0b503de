// Vibration of a damped beam in a motion: what its viscosity bears is part of its cut forces.

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"

namespace viscous_vibration_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 2.1e11, G = 8.1e16;  // as good as rigid in shear
constexpr double L = 3.0, tip = 200.0;
constexpr double w = 0.08, h = 0.1, plate = 0.005;
constexpr double I =
    (w * h * h * h - (w - 2 * plate) * (h - 2 * plate) * (h - 2 * plate) * (h - 2 * plate)) / 12.0;
constexpr double swing = 0.01;

/// A beam next to without mass, its base driven across its axis, with a mass on its tip: one degree
/// of freedom of stiffness 3 E I/L^3.
struct DrivenBase {
  double omega_1 = std::sqrt(3.0 * E * I / (L * L * L * tip));
  double r = 1.0;
  TaperedBeam beam;
  planar::Mechanism mechanism;
  planar::Motion motion;
  planar::BeamBody body;
  std::shared_ptr<planar::StateFinder> finder;

  explicit DrivenBase(double frequency_ratio) : r(frequency_ratio) {
    const Section box{symmetric_box(w * metre, h * metre, plate * metre, plate * metre), {}};
    beam.density = si<Density>(1e-3);
    beam.segments = {{"", Length{}, si<Length>(L), box, box}};
    const MassProperties properties = mass_properties_of(beam);
    Body of, end;
    of.name = "beam";
    of.mass = properties.mass.value();
    of.inertia = properties.inertia.value();
    of.sketch.centre = {0.5 * L, 0.0};
    end.name = "tip";
    end.mass = tip;
    end.inertia = 1e-6;
    end.sketch.centre = {L, 0.0};
    mechanism.bodies = {of, end};
    planar::Slider base;
    base.point = {0, {-0.5 * L, 0.0}};
    base.direction = pi / 2;
    planar::Driven shake;
    shake.point = base.point;
    shake.coordinate = planar::Coordinate::y;
    shake.driver = HarmonicDriver{0.0, swing, r * omega_1, 0.0};
    planar::Rigid weld;
    weld.a = {0, {0.5 * L, 0.0}};
    weld.b = {1, {0.0, 0.0}};
    mechanism.joints = {{"base", base}, {"shake", shake}, {"weld", weld}};
    body = planar::beam_body_of(beam, 0);
    motion = planar::solve_motion(mechanism, 96);
    finder = std::make_shared<planar::StateFinder>(mechanism, motion);
  }

  RigidMotion rigid() const {
    return {&mechanism, &motion, &beam, [this](Time time) {
              return planar::beam_loads_of(mechanism, finder->at(time.value()), body);
            }};
  }

  /// Kelvin and Voigt: zeta = omega_1 tau/2.
  ElasticBody elastic(double zeta) const {
    return {0, 0.5 * L, L, link_stretches_of(beam, E, G), 2.0 * zeta / omega_1, 8};
  }

  /// The tip's acceleration over the base's: what spring and damper bear together, by the mass.
  std::complex<double> transmissibility(double zeta) const {
    const std::complex<double> damper(0.0, 2.0 * zeta * r);
    return (1.0 + damper) / (1.0 - r * r + damper);
  }
};

}  // namespace

// Source: den Hartog, Mechanical Vibrations (1956), section 2.10: transmissibility of a driven
// base.
TEST_CASE("V and M of a damped beam on a driven base contain the viscous part",
          "[elastic_motion]") {
  for (const double r : {0.6, 1.5, 2.5}) {
    const DrivenBase of(r);
    for (const double zeta : {0.0, 0.02, 0.05, 0.1}) {
      const ElasticMotion elastic(of.rigid(), of.elastic(zeta), 2);
      const std::complex<double> T = of.transmissibility(zeta);
      const double omega = r * of.omega_1;
      const double size = tip * swing * omega * omega * std::abs(T);
      double largest = 0.0;
      for (int i = 0; i < 48; ++i) {
        const double time = of.motion.period * (i + 0.3) / 48.0;
        const CutForces root =
            cut_forces_of(elastic.loads_at(si<Time>(time))).at({Length{}, Side::behind});
        // The part behind the cut needs tip times its acceleration; V on its near face is -V.
        const double acceleration =
            (-swing * omega * omega * T * std::polar(1.0, omega * time)).imag();
        INFO("r = " << r << ", zeta = " << zeta << ", t = " << time);
        CHECK(root.V_z.value() == Approx(-tip * acceleration).margin(2e-5 * size));
        CHECK(std::abs(root.M_y.value()) ==
              Approx(tip * std::abs(acceleration) * L).margin(2e-5 * size * L));
        largest = std::max(largest, std::abs(root.V_z.value()));
      }
      CHECK(largest == Approx(size).epsilon(3e-3));  // the instants are not those of the peak
    }
  }
}

TEST_CASE("what rigid bodies are estimated to miss contains the viscous part", "[elastic_motion]") {
  const DrivenBase of(1.5);
  const LoadHistory history({si<Time>(of.motion.begin), si<Time>(of.motion.period),
                             of.motion.states.size(), of.motion.closed},
                            of.rigid().loads);
  const double zeta = 0.1;
  const VibrationEstimate estimate = estimate_vibration(of.rigid(), of.elastic(zeta), history);
  CHECK(estimate.without_modes.front() ==
        Approx(std::abs(of.transmissibility(zeta) - 1.0)).epsilon(1e-3));
}

}  // namespace viscous_vibration_test
