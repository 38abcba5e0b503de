// Elastic bodies beside the verified beam: a beam cut in two, whose halves are bodies joined
// rigidly, is the whole beam, whichever half is verified.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/slender_beam.hpp"

namespace beams_beside_test {

using namespace boxbeam;
namespace slender = test::slender;
using slender::E;
using slender::G;
using slender::L;

namespace {

constexpr double pi = std::numbers::pi;
constexpr int parts = 16;  ///< of the whole beam
/// The halves are divided each by itself, not where the whole is: third frequency 4e-4 apart.
constexpr double divided = 5e-4;

/// The shaken beam of `slender::shaken` in two bodies of half its length.
struct Halves {
  std::array<TaperedBeam, 2> beams;
  planar::Mechanism mechanism;
  planar::Motion motion;
  std::shared_ptr<planar::StateFinder> finder;

  explicit Halves(const slender::Beam& whole) {
    mechanism.gravity = whole.mechanism.gravity;
    for (std::size_t k = 0; k < 2; ++k) {
      TaperedBeam& beam = beams[k] = whole.beam;
      beam.segments.front().length = si<Length>(0.5 * L);
      const MassProperties properties = mass_properties_of(beam);
      Body& of = mechanism.bodies.emplace_back();
      of.name = k == 0 ? "inner" : "outer";
      of.mass = properties.mass.value();
      of.inertia = properties.inertia.value();
      of.sketch.centre = {(0.25 + 0.5 * static_cast<double>(k)) * L, 0.0};
    }
    const planar::Attachment start{0, {-0.25 * L, 0.0}};
    for (planar::Joint joint : whole.mechanism.joints) {
      if (auto* base = std::get_if<planar::Slider>(&joint.kind)) base->point = start;
      if (auto* drive = std::get_if<planar::Driven>(&joint.kind)) drive->point = start;
      mechanism.joints.push_back(joint);
    }
    planar::Rigid joined;
    joined.a = {0, {0.25 * L, 0.0}};
    joined.b = {1, {-0.25 * L, 0.0}};
    mechanism.joints.push_back({"cut", joined});
    motion = planar::solve_motion(mechanism, static_cast<int>(whole.motion.states.size()));
    finder = std::make_shared<planar::StateFinder>(mechanism, motion);
  }

  planar::BeamBody body(std::size_t half) const {
    return planar::beam_body_of(beams[half], static_cast<int>(half));
  }
  RigidMotion rigid(std::size_t half) const {
    return {&mechanism, &motion, &beams[half], [this, half](Time time) {
              return planar::beam_loads_of(mechanism, finder->at(time.value()), body(half));
            }};
  }
  ElasticBody elastic(std::size_t half, double retardation, bool beside = true) const {
    ElasticBody of{static_cast<int>(half),
                   0.25 * L,
                   0.5 * L,
                   link_stretches_of(beams[half], E, G),
                   retardation,
                   parts / 2};
    of.laid_out = body(half);
    if (beside) of.beside = {elastic(1 - half, retardation, false)};
    return of;
  }
  LoadHistory history(std::size_t half) const {
    return {{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(), motion.closed},
            rigid(half).loads};
  }
};

slender::Beam shaken(double r) {
  slender::Beam of;
  planar::Slider slider;
  slider.point = of.start();
  slider.direction = pi / 2;
  of.mechanism.gravity = {-2.0, -9.81};
  of.mechanism.joints = {{"base", slider}};
  of.mechanism.joints.push_back(
      slender::driven(of, planar::Coordinate::y,
                      HarmonicDriver{0.0, 0.01, 2 * pi * r * slender::first_frequency(), 0.0}));
  of.solve(48);
  return of;
}

/// The same cut forces on a half as on the whole, within a part of the largest.
void check_same(const CutForceDiagram& half, const CutForceDiagram& whole, double from,
                double within) {
  double force = 0.0, moment = 0.0;
  for (int i = 0; i <= 40; ++i) {
    const CutForces cut = whole.at({si<Length>(i * L / 40), Side::before});
    force = std::max({force, std::abs(cut.N.value()), std::abs(cut.V_z.value())});
    moment = std::max(moment, std::abs(cut.M_y.value()));
  }
  for (int i = 1; i < 20; ++i) {
    const double s = i * 0.5 * L / 20;
    const CutForces of_half = half.at({si<Length>(s), Side::before}),
                    of_whole = whole.at({si<Length>(from + s), Side::before});
    CAPTURE(from, s);
    CHECK(of_half.N.value() == Approx(of_whole.N.value()).margin(within * force));
    CHECK(of_half.V_z.value() == Approx(of_whole.V_z.value()).margin(within * force));
    CHECK(of_half.M_y.value() == Approx(of_whole.M_y.value()).margin(within * moment));
  }
}

}  // namespace

TEST_CASE("a beam in two bodies that both bend vibrates as the whole", "[beams_beside]") {
  const double tau = 0.02 / (pi * slender::first_frequency());
  for (const double r : {0.2, 0.8, 1.7}) {
    const slender::Beam whole = shaken(r);
    const Halves halves(whole);
    ElasticBody one = whole.elastic(E, G, tau);
    one.parts = parts;
    const ElasticMotion expected(whole.rigid(), one, 2);
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
      CAPTURE(r, half);
      const ElasticMotion found(halves.rigid(half), halves.elastic(half, tau), 2);
      CHECK(found.lowest_frequency() == Approx(expected.lowest_frequency()).epsilon(divided));
      for (const double part : {0.0, 0.13, 0.5, 0.81}) {
        const Time time = si<Time>(part * whole.motion.period);
        check_same(cut_forces_of(found.loads_at(time)), cut_forces_of(expected.loads_at(time)),
                   half == 0 ? 0.0 : 0.5 * L, divided);
      }
    }
  }
}

TEST_CASE("what rigid bodies miss of a beam in two bodies is what they miss of the whole",
          "[beams_beside]") {
  const slender::Beam whole = shaken(0.3);
  const Halves halves(whole);
  ElasticBody one = whole.elastic();
  one.parts = parts;
  const VibrationEstimate expected = estimate_vibration(whole.rigid(), one, whole.history());
  const VibrationEstimate both =
      estimate_vibration(halves.rigid(0), halves.elastic(0, 0.0), halves.history(0));
  const VibrationEstimate alone =
      estimate_vibration(halves.rigid(0), halves.elastic(0, 0.0, false), halves.history(0));
  REQUIRE(both.frequencies.size() == expected.frequencies.size());
  for (std::size_t i = 0; i < both.frequencies.size(); ++i)
    CHECK(both.frequencies[i] == Approx(expected.frequencies[i]).epsilon(divided));
  // The largest stress, at the base, and the largest range are on the inner half.
  CHECK(both.without_modes.front() == Approx(expected.without_modes.front()).epsilon(1e-3));
  // Half a beam with the other half as a rigid mass at its end is stiffer.
  CHECK(alone.frequencies.front() > 1.02 * both.frequencies.front());
  CHECK(alone.without_modes.front() < both.without_modes.front());
}

TEST_CASE("a beam in two bodies bends under its axial force as the whole", "[beams_beside]") {
  const slender::Beam whole = shaken(0.05);
  const Halves halves(whole);
  ElasticBody one = whole.elastic();
  one.parts = parts;
  const LoadsAt expected = bent_statically(whole.rigid(), one);
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
    const LoadsAt found = bent_statically(halves.rigid(half), halves.elastic(half, 0.0));
    const Time time = si<Time>(0.3 * whole.motion.period);
    check_same(cut_forces_of(found(time)), cut_forces_of(expected(time)), half == 0 ? 0.0 : 0.5 * L,
               divided);
  }
}

namespace {

/// An arm of 4 m that its pivot swings, as one beam or as two that are joined rigidly.
std::string swung(bool cut) {
  const std::string section =
      "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
      "flange = \"4 mm\"\nweb = \"4 mm\"\n";
  const auto beam = [](const char* name, const char* length) {
    return fmt::format(
        "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\ndensity = \"7850 kg/m^3\"\n"
        "[[beam.segments]]\nlength = \"{1} m\"\nsection = \"box\"\n",
        name, length);
  };
  const auto body = [](const char* name, const char* length, const char* at) {
    return fmt::format(
        "[bodies.{}]\npoints = {{ A = [\"0 m\", \"0 m\"], B = [\"{} m\", \"0 m\"] }}\n"
        "sketch = {{ at = [\"{} m\", \"0 m\"], angle = \"0 rad\" }}\n",
        name, length, at);
  };
  std::string text =
      "[case]\nname = \"swung\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n" +
      body("inner", cut ? "2" : "4", "0") + (cut ? body("outer", "2", "2") : "") +
      "[joints.pivot]\nkind = \"pin\"\nconnect = [\"inner.A\", \"ground\"]\n"
      "at = [\"0 m\", \"0 m\"]\n" +
      (cut ? "[joints.cut]\nkind = \"rigid\"\nconnect = [\"inner.B\", \"outer.A\"]\n" : "") +
      "[drivers.swing]\ncoordinate = \"angle\"\npoint = \"inner.A\"\nkind = \"harmonic\"\n"
      "mean = \"0 rad\"\namplitude = \"0.05 rad\"\nfrequency = \"1.2 Hz\"\n" +
      section + beam("inner", cut ? "2" : "4") + (cut ? beam("outer", "2") : "");
  return text +
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.5\n"
         "[fatigue]\ncategory = 71\ncycles = 1e5\nloading = \"spectrum\"\ngamma_Mf = 1.35\n"
         "required = 1.0\n";
}

double largest_stress(const ModelledRuns& of, const TaperedBeam& beam) {
  return stress_history(of.runs.front().loads, compared_places_of(beam)).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("beams of one case bend with each other", "[beams_beside]") {
  const std::vector<Project> whole = parse_beams("whole.toml", swung(false)),
                             cut = parse_beams("cut.toml", swung(true));
  REQUIRE(whole.size() == 1);
  REQUIRE(cut.size() == 2);
  const ModelledRuns expected = run_by_chosen_model(whole[0]), found = run_by_chosen_model(cut[0]);
  CHECK(found.model.frequencies.front() ==
        Approx(expected.model.frequencies.front()).epsilon(divided));
  CHECK(found.model.chosen.level == expected.model.chosen.level);
  CHECK(largest_stress(found, cut[0].beam) ==
        Approx(largest_stress(expected, whole[0].beam)).epsilon(1e-3));
  CHECK(found.model.reason.find("outer") != std::string::npos);
  // Of either half.
  CHECK(run_by_chosen_model(cut[1]).model.frequencies.front() ==
        Approx(expected.model.frequencies.front()).epsilon(divided));
}

}  // namespace beams_beside_test
