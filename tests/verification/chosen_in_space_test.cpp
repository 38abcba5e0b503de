// What is chosen for scenes and starts in space by chance, against many modes, parts and statics of
// the second order.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/space_arm.hpp"

namespace chosen_in_space_test {

using namespace boxbeam;
using namespace test::space_arm;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

/// Numbers and texts by chance, from a seed.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  std::string axis() {
    Vector3d of(between(-1, 1), between(-1, 1), between(-1, 1));
    of.normalize();
    return fmt::format("axis = [{:.15g}, {:.15g}, {:.15g}]\n", of.x(), of.y(), of.z());
  }
  /// At the arm's tip.
  std::string load() {
    return fmt::format(R"(
[bodies.load]
mass = "{} kg"
centre = ["{} m", "{} m", "{} m"]
inertia = ["{} kg m^2", "{} kg m^2", "{} kg m^2"]
points = {{ c = ["0 m", "0 m", "0 m"] }}
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
)",
                       between(20, 250), between(-0.2, 0.4), between(-0.5, 0.5), between(-0.5, 0.5),
                       between(4, 8), between(5, 8), between(6, 9));
  }
  /// The arm with what holds and loads it, damped.
  std::string arm(const std::string& joints, double gravity = 0.0) {
    return test::space_arm::arm(
        joints, "density = \"7850 kg/m^3\"\n",
        fmt::format("[model]\ntolerance = 0.02\ndamping = {{ ratio = {}, at = \"6 Hz\" }}\n",
                    between(0.01, 0.03)),
        gravity);
  }

 private:
  std::mt19937 engine_;
};

/// A column that slews about an axis that is still to be said; `more`: further points of it.
std::string column(const std::string& more = "") {
  return R"(
[bodies.column]
mass = "80 kg"
centre = ["0 m", "0 m", "0.5 m"]
inertia = ["5 kg m^2", "6 kg m^2", "2 kg m^2"]
points = { a = ["0 m", "0 m", "0 m"], b = ["0 m", "0 m", "1 m"])" +
         more + R"( }
[joints.slew]
kind = "revolute"
connect = ["ground", "column.a"]
at = ["0 m", "0 m", "0 m"]
)";
}
const std::string heel =
    "[joints.heel]\nkind = \"revolute\"\nconnect = [\"column.b\", \"arm.heel\"]\n";

/// A scene by chance: an arm at the end of driven joints, or luffed by a driven strut in a loop;
/// some with a spring beside it, softer or stiffer than the arm.
struct Scene {
  std::string text;
  bool closed = false, sprung = false;
};

Scene scene_by_chance(unsigned seed) {
  Drawn drawn(seed);
  const auto between = [&](double low, double high) { return drawn.between(low, high); };
  Scene scene;
  scene.closed = between(0, 1) < 0.4;
  const double base = between(0.2, 0.8);
  const auto swings = [&](const char* name, const char* joint, double amplitude) {
    return fmt::format(
        "[drivers.{}]\njoint = \"{}\"\nkind = \"harmonic\"\nmean = \"{} rad\"\namplitude = \"{} "
        "rad\"\nfrequency = \"{:.12g} Hz\"\nphase = \"{} rad\"\n",
        name, joint, between(-0.3, 0.3), amplitude, base * (between(0, 1) < 0.3 ? 2.0 : 1.0),
        between(0.0, 6.0));
  };
  std::string joints = column(fmt::format(", s = [\"{:.3f} m\", \"{:.3f} m\", \"0 m\"]",
                                          between(0.3, 0.9), between(-0.2, 0.2))) +
                       drawn.axis() + swings("slewing", "slew", between(0.05, 0.4));
  if (scene.closed) {
    joints += fmt::format(R"(
[joints.heel]
kind = "revolute"
connect = ["column.b", "arm.heel"]
axis = "-y"
start = "{} rad"
[joints.strut]
kind = "distance"
connect = ["column.s", "arm.mid"]
[drivers.luffing]
joint = "strut"
kind = "harmonic"
mean = "{} m"
amplitude = "{} m"
frequency = "{:.12g} Hz"
phase = "{} rad"
)",
                          between(0.1, 0.5), between(1.35, 1.6), between(0.01, 0.08), base,
                          between(0.0, 6.0));
  } else {
    joints += heel + drawn.axis() + swings("heel", "heel", between(0.05, 0.3));
  }
  joints += drawn.load();
  scene.sprung = between(0, 1) < 0.4;
  if (scene.sprung) {
    const bool grounded = between(0, 1) < 0.5;
    joints += fmt::format(R"(
[forces.stay]
kind = "spring"
connect = ["{}", "arm.{}"]
stiffness = "{} N/m"
free_length = "{} m"
damping = "{} N s/m"
)",
                          grounded ? "ground" : "column.s", between(0, 1) < 0.7 ? "tip" : "mid",
                          std::pow(10.0, between(3.0, 5.0)), between(2.0, 4.0),
                          between(0, 1) < 0.5 ? 0.0 : between(0.0, 500.0));
    if (grounded)
      joints += fmt::format("at = [\"{} m\", \"{} m\", \"{} m\"]\n", between(1, 4), between(-2, 2),
                            between(-3, -2));
  }
  scene.text = drawn.arm(joints);
  return scene;
}

/// Largest difference of stresses and of their ranges, as a model is judged.
double apart(const MatrixXd& model, const MatrixXd& better) {
  const MatrixXd difference = model - better;
  return std::max(difference.cwiseAbs().maxCoeff() / better.cwiseAbs().maxCoeff(),
                  largest_range(difference) / largest_range(better));
}

struct Judged {
  int rigid = 0, modal = 0, unproven = 0, closed = 0, sprung = 0, near_buckling = 0;
  double worst = 0.0;
};

/// What `auto` chooses, against twelve modes, four times the parts and statics of the second order;
/// all loads in balance.
void judge(unsigned seed, Judged& sum) {
  const Scene scene = scene_by_chance(seed);
  const Moved of(scene.text);
  const ModelledRuns chosen = run_by_chosen_model(of.project);
  INFO("seed " << seed << (scene.closed ? ", closed: " : ", open: ") << chosen.model.reason);
  const SituationRun& run = chosen.runs.front();
  for (int i = 0; i < 7; ++i) {
    const double part = std::fmod(0.37 * i + 0.011 * seed, 1.0);
    CHECK(imbalance(run.loads.loads_at(of.at(part)), 4.0) < 1e-9);
  }
  // Nearer to buckling no verdict is given.
  constexpr double proven = 0.7;
  const SecondOrderEstimate& second = chosen.model.second_order;
  if (std::max(second.in_plane.part, second.across ? second.across->part : 0.0) > proven) {
    ++sum.near_buckling;
    return;
  }
  const bool rigid = chosen.model.chosen.level == ModelLevel::rigid;
  const std::vector<Gate> gates = model_gates_of(of.project, chosen.model);
  if (std::any_of(gates.begin(), gates.end(), [](const Gate& gate) { return gate.blocks; }) ||
      (rigid && (chosen.model.weighed.empty() || chosen.model.weighed.front().error > 0.02))) {
    ++sum.unproven;
    return;
  }
  ++(rigid ? sum.rigid : sum.modal);
  sum.closed += scene.closed ? 1 : 0;
  sum.sprung += scene.sprung ? 1 : 0;
  LoadSpan span = of.rigid().span();
  const ElasticMotionInSpace best = of.bent_by(12, 32);
  const LoadHistory better(span, [&](Time time) { return best.loads_at(time); });
  const double error = apart(stress_history_in_space(run.loads, of.project.beam),
                             stress_history_in_space(better, of.project.beam));
  sum.worst = std::max(sum.worst, error);
  CHECK(error < 0.02);
}

}  // namespace

TEST_CASE("what is chosen for scenes by chance is within the tolerance", "[elastic_motion]") {
  Judged sum;
  for (unsigned seed = 1; seed <= 3; ++seed) judge(seed, sum);
  CHECK(sum.rigid + sum.modal > 0);
}

// Takes minutes.
TEST_CASE("what is chosen for two hundred scenes by chance is within the tolerance",
          "[.][two_hundred_scenes]") {
  Judged sum;
  for (unsigned seed = 1; seed <= 200; ++seed) judge(seed, sum);
  WARN(sum.rigid << " rigid, " << sum.modal << " by modes, " << sum.closed << " of them closed, "
                 << sum.sprung << " with a spring, " << sum.near_buckling << " near buckling, "
                 << sum.unproven << " without a model; worst " << sum.worst);
  CHECK(sum.modal >= 50);
  CHECK(sum.closed >= 30);
  CHECK(sum.sprung >= 30);
  CHECK(sum.unproven <= 10);
}

namespace {

/// An arm at the end of two driven joints, that starts or stops by chance.
std::string start_by_chance(unsigned seed) {
  Drawn drawn(seed);
  const auto between = [&](double low, double high) { return drawn.between(low, high); };
  const double end = 0.4 * std::exp(between(0.0, 3.0));
  const auto driven = [&](const char* name, const char* joint, double most) {
    const double turn = between(0.1, most), begin = between(0.0, 0.4) * end;
    return fmt::format(
        "[drivers.{}]\njoint = \"{}\"\nkind = \"smooth step\"\nfrom = \"{} rad\"\nto = \"{} "
        "rad\"\nbegin = \"{} s\"\nend = \"{} s\"\n",
        name, joint, -0.5 * turn, 0.5 * turn, begin, end);
  };
  std::string joints = column() + drawn.axis() + driven("slewing", "slew", 0.8) + heel +
                       drawn.axis() + driven("luffing", "heel", 0.6);
  joints += drawn.load();
  const bool stops = between(0, 1) < 0.4;
  // Under way at once, and at rest at its end.
  if (!stops) return drawn.arm(joints, 9.81);
  return drawn.arm(joints) +
         fmt::format("[motion]\nsettle = \"{0} s\"\nduration = \"{0} s\"\n", 0.5 * end);
}

}  // namespace

// Takes minutes.
TEST_CASE("random starts in space are as near to many modes as the tolerance says",
          "[.][random_starts_in_space]") {
  int rigid = 0, modal = 0, unproven = 0;
  double most = 0.0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Moved of(start_by_chance(seed));
    const ModelledRuns chosen = run_by_chosen_model(of.project);
    INFO("seed " << seed << ": " << chosen.model.reason);
    const SituationRun& run = chosen.runs.front();
    const ElasticMotionInSpace best = of.bent_by(12, 32);
    const bool by_rigid = chosen.model.chosen.level == ModelLevel::rigid;
    if (by_rigid && vibration_missed_in_space(of.project, chosen.model) > 0.02) {
      ++unproven;
      continue;
    }
    ++(by_rigid ? rigid : modal);
    const double looked = run.loads.period() / of.rigid().period();
    for (int i = 1; i < 8; ++i)
      CHECK(imbalance(run.loads.loads_at(of.at(0.14 * i * looked)), 4.0) < 1e-9);
    // Up to where both look.
    const double begin = run.loads.begin().value();
    double last = best.transient()->times().back();
    if (!by_rigid) last = std::min(last, begin + run.loads.period().value());
    const LoadHistory better({run.loads.begin(), si<Time>(last - begin), 2000, false},
                             [&](Time time) { return best.loads_at(time); });
    const MatrixXd of_better = stress_history_in_space(better, of.project.beam);
    const double error =
        apart(stress_history_in_space(run.loads, of.project.beam, better.span()), of_better);
    most = std::max(most, error);
    INFO(error);
    CHECK(error < 0.02);
  }
  WARN(rigid << " rigid, " << modal << " by modes, " << unproven << " without a model; worst "
             << most);
  CHECK(modal >= 4);
  CHECK(unproven <= 3);
}

}  // namespace chosen_in_space_test
