#include <exception>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "charts/known_motions.hpp"
#include "peers/answers.hpp"
#include "peers/simbody_linkage.hpp"

namespace peers {
namespace {

using namespace boxbeam;
using namespace boxbeam::planar;

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
  const Mechanism mechanism = four ? charts::n_four_bar(2) : charts::simple_pendulum();
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
