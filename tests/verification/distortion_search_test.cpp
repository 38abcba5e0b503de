// The search for the places that distortion uses most, beside all points of all places at all
// instants, one by one.

#include "src/verification/distortion_search.hpp"

#include <algorithm>
#include <random>
#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/torques_in.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace distortion_search_test {

using namespace boxbeam;

namespace {

/// A shipped case whose beam is one stretch of boxes, with the loads of rigid bodies.
struct Shipped {
  explicit Shipped(const std::string& file)
      : project(read_project(test::project_file("sections/" + file))),
        runs(run_situations(project)),
        zones(bending_zones_of(project, runs)),
        torques(torques_in(project, runs)),
        segments{0, project.beam.segments.size() - 1},
        stretch(project, runs, torques, segments, {}) {}

  std::vector<DistortedPoint> points(std::size_t place) const {
    return distorted_points_at(project, zones, stretch, place);
  }
  std::vector<std::vector<CutForces>> cuts(std::size_t place) const {
    std::vector<std::vector<CutForces>> cuts;
    for (const SituationRun& run : runs)
      cuts.push_back(run.loads.cuts_at(stretch.places()[place].station));
    return cuts;
  }

  Project project;
  std::deque<SituationRun> runs;
  std::vector<BendingZone> zones;
  std::vector<std::vector<TorquesIn>> torques;
  BoxStretch segments;
  DistortedStretch stretch;
};

const CheckResult* check_of(const std::vector<CheckResult>& checks, Criterion criterion,
                            bool across = false) {
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const CheckResult& of) {
    return of.check.criterion == criterion && of.distortion->across == across;
  });
  return found == checks.end() ? nullptr : &*found;
}

constexpr DistortionStresses any_size{1.0, 1.0};

}  // namespace

TEST_CASE("what cut forces do lies within what the most of each does", "[distortion]") {
  std::minstd_rand numbers;
  std::uniform_real_distribution<double> size(-1.0, 1.0);
  const auto some = [&] {
    std::array<double, cut_force::count> of{};
    for (double& value : of) value = size(numbers);
    return of;
  };
  for (int scene = 0; scene < 100; ++scene) {
    std::vector<CutForces> cuts;
    CutForceHull hull;
    for (int i = 0; i < 20; ++i) {
      const auto c = some();
      cuts.push_back({si<Force>(c[0]), si<Force>(c[1]), si<Force>(c[2]), si<Moment>(c[3]),
                      si<Moment>(c[4]), si<Moment>(c[5])});
      hull.take(cuts.back());
    }
    const auto factors = some();
    const CutForceHull::Bounds all = hull.of(factors);
    for (const CutForces& cut : cuts) {
      REQUIRE(stress_of(factors, cut) >= all.lowest);
      REQUIRE(stress_of(factors, cut) <= all.highest);
    }
  }
  // Of one cut force they are what it does.
  CutForceHull hull;
  for (const double M : {-3.0, 2.0}) hull.take({{}, {}, {}, {}, si<Moment>(M), {}});
  std::array<double, cut_force::count> factors{};
  factors[cut_force::M_y] = -2.0;
  CHECK(hull.of(factors).lowest == Approx(-4.0));
  CHECK(hull.of(factors).highest == Approx(6.0));
  // What is not known counts where that force is there.
  factors[cut_force::T] = std::numeric_limits<double>::quiet_NaN();
  CHECK(hull.of(factors).highest == Approx(6.0));
  hull.take({{}, {}, {}, si<Moment>(1.0), {}, {}});
  CHECK(std::isnan(hull.of(factors).highest));
}

TEST_CASE("the point that distortion uses most is the most of all points at all instants",
          "[distortion]") {
  for (const std::string file : {"landing-gear/retraction.toml", "stewart-rig/rig.toml"}) {
    INFO(file);
    const Shipped of(file);
    double most = 0.0;
    for (std::size_t place = 0; place < of.stretch.places().size(); ++place) {
      const std::vector<DistortedPoint> points = of.points(place);
      const std::vector<std::vector<CutForces>> cuts = of.cuts(place);
      for (std::size_t r = 0; r < cuts.size(); ++r) {
        for (std::size_t i = 0; i < cuts[r].size(); ++i) {
          for (const DistortedPoint& point : points) {
            if (point.resisting == 0.0) continue;
            most = std::max(
                most, use_of(point, stress_at(point.point.influence, cuts[r][i]),
                             of.stretch.size_at(place, r, i), of.runs[r].situation->load_factor)
                          .use());
          }
        }
      }
    }
    DistortionSearch search(of.project, of.runs, of.zones, of.stretch, of.segments);
    const std::vector<CheckResult> checks = search.checks();
    const CheckResult* const found = check_of(checks, Criterion::distortion);
    REQUIRE(found != nullptr);
    // Beside the worst instant it may be a little more.
    CHECK(1.0 / found->check.safety_factor >= (1.0 - 1e-12) * most);
    CHECK(1.0 / found->check.safety_factor <= 1.01 * most);
  }
}

TEST_CASE("the fatigue of a distorted stretch is that of its worst point, whichever comes first",
          "[distortion][fatigue]") {
  for (const std::string file : {"landing-gear/retraction.toml", "stewart-rig/rig.toml"}) {
    INFO(file);
    const Shipped of(file);
    std::vector<std::size_t> order;
    for (std::size_t place = 0; place < of.stretch.places().size(); ++place) order.push_back(place);
    const DistortionRanges fresh(of.project, of.runs, of.stretch);
    double along = std::numeric_limits<double>::infinity(), across = along;
    for (const std::size_t place : order) {
      const std::vector<std::vector<CutForces>> cuts = of.cuts(place);
      for (const DistortedPoint& point : of.points(place)) {
        DistortionRanges alone = fresh;
        alone.look_at(place, {point}, cuts, any_size, 0.0);
        for (const CheckResult& check : alone.checks()) {
          double& least = check.distortion->across ? across : along;
          least = std::min(least, check.check.safety_factor);
        }
      }
    }
    std::optional<std::vector<CheckResult>> first;
    for (int way = 0; way < 3; ++way) {
      DistortionRanges ranges = fresh;
      for (const std::size_t place : order)
        ranges.look_at(place, of.points(place), of.cuts(place), any_size, 0.0);
      const std::vector<CheckResult> checks = ranges.checks();
      const CheckResult* const by_along = check_of(checks, Criterion::distortion_fatigue);
      const CheckResult* const by_across = check_of(checks, Criterion::distortion_fatigue, true);
      REQUIRE(by_along != nullptr);
      REQUIRE(by_across != nullptr);
      CHECK(by_along->check.safety_factor == along);
      CHECK(by_across->check.safety_factor == across);
      if (!first) first = checks;
      for (std::size_t k = 0; k < checks.size(); ++k)
        CHECK(checks[k].check.id == (*first)[k].check.id);
      if (way == 0)
        std::reverse(order.begin(), order.end());
      else
        std::shuffle(order.begin(), order.end(), std::minstd_rand());
    }
  }
}

}  // namespace distortion_search_test
