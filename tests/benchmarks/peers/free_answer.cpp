#include <cmath>
#include <exception>
#include <string>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "peers/answers.hpp"
#include "peers/simbody_linkage.hpp"

namespace peers {
namespace {

using namespace boxbeam;
using namespace boxbeam::planar;

constexpr double g = 9.81;

/// A01 of the IFToMM library of computational benchmark problems: a point of 1 kg at 1 m from the
/// pin, let go at rest from (-1, 0).
Mechanism pendulum() {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {Body{"point", 1.0, 0.0, {}, {{-1.0, 0.0}, 0.0}}};
  mechanism.joints = {{"pin", Pin{{0, {1.0, 0.0}}, {ground, {0.0, 0.0}}}}};
  return mechanism;
}

/// A02 with N = 2: cranks first, couplers behind, all of 1 m and 1 kg; upright, 1 m/s to the right.
Mechanism four_bars() {
  constexpr int N = 2;
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  for (int i = 0; i <= N; ++i) {
    mechanism.bodies.push_back({"crank " + std::to_string(i),
                                1.0,
                                1.0 / 12.0,
                                {},
                                {{i, 0.5}, std::acos(0.0)},
                                {0.5, 0.0, -1.0}});
    mechanism.joints.push_back(
        {"A" + std::to_string(i), Pin{{i, {-0.5, 0.0}}, {ground, {i, 0.0}}}});
  }
  for (int i = 0; i < N; ++i) {
    const int coupler = N + 1 + i;
    mechanism.bodies.push_back({"coupler " + std::to_string(i),
                                1.0,
                                1.0 / 12.0,
                                {},
                                {{i + 0.5, 1.0}, 0.0},
                                {1.0, 0.0, 0.0}});
    mechanism.joints.push_back(
        {"left " + std::to_string(i), Pin{{i, {0.5, 0.0}}, {coupler, {-0.5, 0.0}}}});
    mechanism.joints.push_back(
        {"right " + std::to_string(i), Pin{{i + 1, {0.5, 0.0}}, {coupler, {0.5, 0.0}}}});
  }
  return mechanism;
}

bench::LinkageResult run_boxbeam(const Mechanism& mechanism, const Attachment& looked_at,
                                 const Json& request) {
  // Without a tolerance asked for, the one that the program takes.
  FreeSolver solver = request.contains("accuracy")
                          ? FreeSolver(mechanism, request.at("accuracy").get<double>())
                          : FreeSolver(mechanism);
  const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const State last = solver.advance(request.at("time"), first);
  const Eigen::Vector2d p = position_of(looked_at, last.q);
  return {p.x(), p.y(), solver.evaluations()};
}

}  // namespace

Json answer_free(const Json& request) {
  const bool four = request.at("system") == "four-bars";
  const bool simbody = request.at("way") == "simbody";
  const double time = request.at("time");
  const int turns = request.value("turns", 1);
  const Mechanism mechanism = four ? four_bars() : pendulum();
  const Attachment looked_at{0, {four ? 0.5 : 0.0, 0.0}};
  const bench::SimbodyLinkage linkage(four ? bench::Linkage::four_bars : bench::Linkage::pendulum);
  try {
    bench::LinkageResult result;
    const double begin = processor_time();
    for (int i = 0; i < turns; ++i) {
      result = simbody ? linkage.run(time, request.at("accuracy"))
                       : run_boxbeam(mechanism, looked_at, request);
    }
    return {{"seconds", (processor_time() - begin) / turns},
            {"place", {result.x, result.y}},
            {"evaluations", result.evaluations}};
  } catch (const std::exception& error) {
    return {{"refused", error.what()}};
  }
}

}  // namespace peers
