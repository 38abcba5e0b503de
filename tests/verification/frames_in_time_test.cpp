// Beams and frames at rest under forces over time: closed forms of a beam on two supports and of a
// cantilever, finite elements of the test's own, and what must hold of every frame.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "catch.hpp"
#include "src/verification/frame_vibration.hpp"
#include "src/verification/vibrating_frame.hpp"
#include "src/verification/vibration_in_space.hpp"

namespace frames_in_time_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi, E = 2.1e11, L = 6.0, rho = 7850.0;
constexpr double A = 0.06 * 0.08 - 0.052 * 0.072;
const double I = (0.06 * std::pow(0.08, 3) - 0.052 * std::pow(0.072, 3)) / 12.0;

const std::string pinned =
    "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
    "[supports.right]\nkind = \"roller\"\nat = \"6 m\"\n";
const std::string clamped = "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n";

/// A beam of 6 m along x in the plane, without weight.
std::string beam(const std::string& supports, const std::string& loads,
                 const std::string& more = "", const std::string& place = "angle = \"0 deg\"") {
  return "[case]\nname = \"girder\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
         "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
         "flange = \"4 mm\"\nweb = \"4 mm\"\n"
         "[beam]\nfrom = [\"0 m\", \"0 m\"]\n" +
         place +
         "\ndensity = \"7850 kg/m^3\"\npoints = { M = [\"3 m\", \"0 m\"] }\n"
         "[[beam.segments]]\nlength = \"6 m\"\nsection = \"box\"\n" +
         supports + loads + more + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

std::string driven(const char* at, const char* direction, const std::string& law) {
  return fmt::format(
      "[loads.push]\nkind = \"driven\"\nat = \"{}\"\ndirection = \"{}\"\nlaw = {{ {} }}\n", at,
      direction, law);
}

std::string harmonic(double amplitude, double frequency) {
  return fmt::format(
      "kind = \"harmonic\", mean = \"0 N\", amplitude = \"{} N\", frequency = \"{:.17g} Hz\"",
      amplitude, frequency);
}

/// A case with its loads by statics. Shear does not count.
struct Solved {
  explicit Solved(const std::string& text)
      : project(slender(text)), runs(run_situations(project)) {}

  static Project slender(const std::string& text) {
    Project project = parse_project("girder.toml", text);
    project.model.youngs_modulus = E;
    auto& structure = std::get<frame::Structure>(project.mechanism);
    for (frame::Member& member : structure.members) {
      member.youngs_modulus = E;
      member.shear_modulus = 1e6 * 8.1e10;
    }
    return project;
  }

  const frame::Structure& structure() const { return frame_of(project); }
  const LoadHistory& slowly() const { return runs.front().loads; }
  FrameResponse response(std::size_t modes, int parts) const {
    return {project,         structure(),
            slowly().span(), [this](Time time) { return slowly().loads_at(time); },
            modes,           parts};
  }
  double estimated() const {
    const FrameVibration of = estimate_vibration_of_frame(project, runs.front());
    REQUIRE(of.obstacle.empty());
    return of.estimate.without_modes.front();
  }

  Project project;
  std::deque<SituationRun> runs;
};

double moment_at(const BeamLoads& loads, double s) {
  return cut_forces_of(loads).at({si<Length>(s), Side::behind}).M_y.value();
}

/// omega_n of a beam on two supports [1/s].
double omega_of(int n) { return std::pow(n * pi / L, 2) * std::sqrt(E * I / (rho * A)); }

}  // namespace

// w(x, t) = sin(Omega t) sum 2 P sin(n pi c/L) sin(n pi x/L)/(m L (omega_n^2 - Omega^2)); M = -E I
// w'': Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974), section 5.10.
TEST_CASE("a beam on two supports under a harmonic force", "[frames_in_time]") {
  constexpr double P = 100.0, c = 3.0;
  for (const double r : {0.3, 0.7, 1.4}) {
    const double Omega = r * omega_of(1);
    const Solved of(beam(pinned, driven("beam.M", "-90 deg", harmonic(P, Omega / (2 * pi)))));
    const FrameResponse response = of.response(4, 32);
    CHECK(response.lowest_frequency() == Approx(omega_of(1) / (2 * pi)).epsilon(1e-5));
    // Beyond statics, which converges fast.
    const auto beyond = [&](double x) {
      double sum = 0.0;
      for (int n = 1; n < 400; ++n) {
        const double square = std::pow(omega_of(n), 2);
        sum += 2.0 * P / (rho * A * L) * std::sin(n * pi * c / L) * std::sin(n * pi * x / L) * E *
               I * std::pow(n * pi / L, 2) * (1.0 / (square - Omega * Omega) - 1.0 / square);
      }
      return sum;
    };
    for (const double part : {0.1, 0.25, 0.7}) {
      const Time time = of.slowly().begin() + part * of.slowly().period();
      const double now = std::sin(2 * pi * part);
      for (const double s : {1.2, 2.9}) {
        CAPTURE(r, part, s);
        const double by_statics = moment_at(of.slowly().loads_at(time), s);
        CHECK(std::abs(by_statics) == Approx(0.5 * P * s * std::abs(now)).epsilon(1e-8));
        const double sign = by_statics * now >= 0.0 ? 1.0 : -1.0;
        CHECK(moment_at(response.loads_at(time), s) - by_statics ==
              Approx(sign * beyond(s) * now).margin(2e-3 * std::abs(beyond(2.9))));
        // The start turns by the slopes of the same modes.
        double slope = 0.0;
        for (int n = 1; n < 400; ++n)
          slope +=
              2.0 * P / (rho * A * L) * std::sin(n * pi * c / L) * n * pi / L *
              (1.0 / (std::pow(omega_of(n), 2) - Omega * Omega) - 1.0 / std::pow(omega_of(n), 2));
        CHECK(std::abs(response.start_at(time)[4]) == Approx(std::abs(slope * now)).epsilon(2e-3));
        CHECK(response.start_at(time).head<3>().norm() < 1e-9 * std::abs(slope * L));
        const Imbalance left = imbalance_of(response.loads_at(time));
        CHECK(left.force.norm() < 1e-6 * P);
        CHECK(left.moment.norm() < 1e-6 * P * L);
      }
    }
    // At the middle, of the moment P L/4.
    CHECK(of.estimated() == Approx(std::abs(beyond(3.0)) / (0.25 * P * L)).epsilon(0.02));
  }
}

// 1 - cos of a force that is there at once and stays: of a cantilever under P at its end the first
// mode has 4 P L/z^2 of the root moment of statics, by phi(L) = 2/sqrt(m L) and phi''(0) = 2
// (z/L)^2/sqrt(m L), of modal mass one.
TEST_CASE("a step of a force counts twice", "[frames_in_time]") {
  constexpr double P = 50.0;
  const double f = std::pow(1.8751040687119612 / L, 2) * std::sqrt(E * I / (rho * A)) / (2 * pi);
  // A rise far shorter than the period.
  const double rise = 0.01 / f;
  const Solved of(beam(
      clamped,
      driven("beam.end", "-90 deg",
             fmt::format("kind = \"smooth step\", from = \"0 N\", to = \"{} N\", begin = \"{:.9g} "
                         "s\", end = \"{:.9g} s\"",
                         P, 0.0, rise))));
  const FrameResponse response = of.response(1, 24);
  const LoadSpan span = response.span_of(of.slowly().span());
  double largest = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const Time time = span.begin + span.period * (i / 400.0);
    largest = std::max(largest, std::abs(moment_at(response.loads_at(time), 0.0)));
  }
  const double z = 1.8751040687119612;
  CHECK(largest == Approx(P * L * (1.0 + 4.0 / (z * z))).epsilon(2e-3));
  CHECK(of.estimated() > 0.9);
}

// A force that runs over a beam on two supports, P sin(n pi v t/L): Fryba, Vibration of Solids and
// Structures under Moving Loads (1972), chapter 1: w = sum w_n sin(n pi x/L), w_n = 2 P/(m L)
// (sin(k t) - k/omega sin(omega t))/(omega^2 - k^2), k = n pi v/L.
TEST_CASE("a wheel that runs over a beam on two supports", "[frames_in_time]") {
  constexpr double P = 200.0;
  const double v = 0.4 * omega_of(1) * L / pi;
  const Solved of(beam(
      pinned,
      fmt::format("[loads.wheel]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 N\", \"{} N\"] }}]\n"
                  "from = \"0 m\"\nto = \"6 m\"\nspeed = \"{:.17g} m/s\"\n",
                  -P, v)));
  const FrameResponse response = of.response(5, 24);
  for (const double part : {0.3, 0.62, 0.85}) {
    const double t = part * L / v;
    for (const double x : {2.0, 4.1}) {
      double beyond = 0.0;
      for (int n = 1; n <= 5; ++n) {
        const double omega = omega_of(n), k = n * pi * v / L;
        const double w = (std::sin(k * t) - k / omega * std::sin(omega * t)) /
                         (omega * omega - k * k),
                     still = std::sin(k * t) / (omega * omega);
        beyond += 2.0 * P / (rho * A * L) * (w - still) * std::sin(n * pi * x / L) * E * I *
                  std::pow(n * pi / L, 2);
      }
      const Time time = si<Time>(t);
      const double by_statics = moment_at(of.slowly().loads_at(time), x),
                   statics = P * std::min(x, v * t) * (L - std::max(x, v * t)) / L;
      CAPTURE(part, x);
      CHECK(std::abs(by_statics) == Approx(statics).epsilon(1e-6));
      const double sign = by_statics < 0.0 ? -1.0 : 1.0;
      CHECK(moment_at(response.loads_at(time), x) - by_statics ==
            Approx(sign * beyond).margin(3e-3 * P * L / 4.0));
    }
  }
  CHECK(of.estimated() > 0.2);
}

// f^2 falls by N/N_cr of a pinned beam that is pressed: the axial force of statics softens it.
TEST_CASE("a frame's axial force softens its vibration", "[frames_in_time]") {
  const double N_cr = pi * pi * E * I / (L * L);
  const std::string push = driven("beam.M", "-90 deg", harmonic(1.0, 1.0));
  const auto first = [&](double part) {
    const std::string press =
        part == 0.0 ? ""
                    : fmt::format(
                          "[loads.press]\nkind = \"force\"\nat = \"beam.end\"\nforce = "
                          "[\"{:.17g} N\", \"0 N\"]\n",
                          -part * N_cr);
    const Solved of(beam(pinned, push + press));
    return VibratingFrame(of.project, of.structure(), 24).modes(0.0, 1).front().frequency;
  };
  CHECK(std::pow(first(0.6) / first(0.0), 2) == Approx(0.4).epsilon(1e-4));
  CHECK_THROWS_AS(first(1.05), AnalysisError);
}

// At its first frequency eta is p/omega^2 times (1 + 2 i zeta)/(2 i zeta) with its viscous part,
// less the static one 1/(2 zeta): of a mode that has 2 P L/pi^2 of the moment in the middle.
TEST_CASE("a frame in resonance is held by its damping", "[frames_in_time]") {
  constexpr double P = 10.0, zeta = 0.02;
  const double f = omega_of(1) / (2 * pi);
  const Solved of(
      beam(pinned, driven("beam.M", "-90 deg", harmonic(P, f)),
           fmt::format("[model]\ndamping = {{ ratio = {}, at = \"{:.17g} Hz\" }}\n", zeta, f)));
  const FrameResponse response = of.response(1, 32);
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Time time = of.slowly().begin() + of.slowly().period() * (i / 200.0);
    largest = std::max(largest, std::abs(moment_at(response.loads_at(time), 3.0) -
                                         moment_at(of.slowly().loads_at(time), 3.0)));
  }
  CHECK(largest == Approx(2.0 * P * L / (pi * pi) / (2.0 * zeta)).epsilon(2e-3));
}

// Invariant: however the frame lies in its plane.
TEST_CASE("a frame that is turned vibrates alike", "[frames_in_time]") {
  const double f = 0.6 * omega_of(1) / (2 * pi);
  const Solved of(beam(clamped, driven("beam.M", "-90 deg", harmonic(10.0, f))));
  const Solved turned(beam(clamped, driven("beam.M", "-36.86989764584402 deg", harmonic(10.0, f)),
                           "", "angle = \"53.13010235415598 deg\""));
  const FrameResponse one = of.response(3, 12), other = turned.response(3, 12);
  for (const double part : {0.1, 0.6}) {
    const Time time = of.slowly().begin() + part * of.slowly().period();
    CHECK(moment_at(other.loads_at(time), 1.0) ==
          Approx(moment_at(one.loads_at(time), 1.0)).epsilon(1e-8));
  }
}

namespace {

/// A cantilever of 6 m in space, as one beam or as a beam and a member that are joined rigidly.
std::string in_space(bool cut, double frequency) {
  const std::string half = cut ? "3" : "6";
  return "[case]\nname = \"girder\"\nkind = \"static\"\n[frame]\nspace = true\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
         "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
         "flange = \"4 mm\"\nweb = \"4 mm\"\n"
         "[beam]\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\nz = \"z\"\n"
         "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"" +
         half + " m\"\nsection = \"box\"\n[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n" +
         (cut ? "[members.second]\nfrom = [\"3 m\", \"0 m\", \"0 m\"]\nto = [\"6 m\", \"0 m\", "
                "\"0 m\"]\nz = \"y\"\nsection = \"turned\"\n[joints.cut]\nkind = \"rigid\"\n"
                "connect = [\"second.start\", \"beam.end\"]\n"
                "[sections.turned]\nkind = \"box\"\nwidth = \"80 mm\"\nheight = \"60 mm\"\n"
                "flange = \"4 mm\"\nweb = \"4 mm\"\n"
              : "") +
         fmt::format(
             "[loads.push]\nkind = \"driven\"\nat = \"{}.end\"\ndirection = [0, 0.6, -0.8]\n"
             "law = {{ kind = \"harmonic\", mean = \"0 N\", amplitude = \"10 N\", frequency = "
             "\"{} Hz\" }}\n",
             cut ? "second" : "beam", frequency) +
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

}  // namespace

// Invariant: cut into the same pieces; the member's section lies on its side, turned back by its z.
TEST_CASE("a cantilever of a beam and a member in space vibrates as one beam", "[frames_in_time]") {
  for (const double frequency : {0.7, 3.0}) {
    const Solved whole(in_space(false, frequency)), cut(in_space(true, frequency));
    const VibratingFrame one(whole.project, whole.structure(), 16),
        other(cut.project, cut.structure(), 8);
    const auto expected = one.modes(0.0, 6), found = other.modes(0.0, 6);
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(found[k].frequency == Approx(expected[k].frequency).epsilon(1e-8));
    const FrameResponse by_one = whole.response(6, 16), by_other = cut.response(6, 8);
    for (const double part : {0.15, 0.6}) {
      const Time time = whole.slowly().begin() + part * whole.slowly().period();
      for (const double s : {0.0, 1.7}) {
        const CutForces a = cut_forces_of(by_one.loads_at(time)).at({si<Length>(s), Side::behind}),
                        b = cut_forces_of(by_other.loads_at(time))
                                .at({si<Length>(s), Side::behind});
        CHECK(b.M_y.value() == Approx(a.M_y.value()).epsilon(1e-7));
        CHECK(b.M_z.value() == Approx(a.M_z.value()).epsilon(1e-7));
        CHECK(b.V_z.value() == Approx(a.V_z.value()).epsilon(1e-7));
        CHECK(std::abs(a.M_z.value()) > 1.0);
      }
    }
    CHECK(estimate_vibration_of_frame(cut.project, cut.runs.front(), 8)
              .estimate.without_modes.front() ==
          Approx(estimate_vibration_of_frame(whole.project, whole.runs.front(), 16)
                     .estimate.without_modes.front())
              .epsilon(1e-5));
  }
}

TEST_CASE("what loads over time add to a frame stands in its model and its verdict",
          "[frames_in_time]") {
  const auto choose = [](double r, ModelDemand demand = ModelDemand::automatic) {
    Project project = Solved::slender(
        beam(pinned, driven("beam.M", "-90 deg", harmonic(100.0, r * omega_of(1) / (2 * pi)))));
    project.model.demand = demand;
    ModelledRuns of = run_by_chosen_model(project);
    return std::pair(of.model, unestimated_vibration_of(project, of.model, of.runs));
  };
  // Slow: r^2/(1 - r^2) is 0.25 %.
  const auto [slow, nothing] = choose(0.05);
  CHECK_THAT(slow.reason, Catch::Contains("loads act slowly"));
  CHECK(slow.chosen.level == ModelLevel::flexible);
  CHECK(nothing.empty());
  const auto [fast, none] = choose(0.5);
  CHECK(fast.chosen.level == ModelLevel::modal);
  CHECK(fast.frequencies.front() == Approx(omega_of(1) / (2 * pi)).epsilon(1e-4));
  CHECK(none.empty());
  const auto [demanded, said] = choose(0.5, ModelDemand::rigid);
  CHECK(demanded.chosen.level == ModelLevel::flexible);
  REQUIRE(said.size() == 1);
  CHECK_THAT(said.front().reason, Catch::Contains("loads act slowly"));
}

// Without damping the free vibration behind a step does not die out.
TEST_CASE("what a frame does behind its loads is said where fatigue is asked", "[frames_in_time]") {
  const double f = omega_of(1) / (2 * pi);
  const auto said = [&](const std::string& model) {
    const Project project = Solved::slender(
        beam(pinned,
             driven("beam.M", "-90 deg",
                    fmt::format("kind = \"smooth step\", from = \"0 N\", to = \"100 N\", begin = "
                                "\"0 s\", end = \"{:.9g} s\"",
                                0.2 / f)),
             model + "[fatigue]\ncategory = 71\ncycles = 1e4\nloading = \"spectrum\"\n"
                     "gamma_Mf = 1.35\nrequired = 1.0\n"));
    const ModelledRuns of = run_by_chosen_model(project);
    REQUIRE(of.model.chosen.level == ModelLevel::modal);
    return unestimated_vibration_of(project, of.model, of.runs);
  };
  const std::vector<NotJudged> free = said("");
  REQUIRE(free.size() == 1);
  CHECK(free.front().what == "vibration behind the motion");
  CHECK(said(fmt::format("[model]\ndamping = {{ ratio = 0.3, at = \"{:.9g} Hz\" }}\n", f)).empty());
}

}  // namespace frames_in_time_test
