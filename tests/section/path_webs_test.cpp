// Which walls of a path are webs, and where seams are.

#include "boxbeam/section/path_webs.hpp"

#include "catch.hpp"

namespace path_webs_test {

using namespace boxbeam;

namespace {

/// Nodes and walls in millimetres.
ThinWalled path_of(const std::vector<std::pair<double, double>>& nodes,
                   const std::vector<std::pair<std::size_t, std::size_t>>& walls) {
  ThinWalled path;
  for (const auto& [y, z] : nodes)
    path.nodes.push_back({si<Length>(1e-3 * y), si<Length>(1e-3 * z)});
  for (const auto& [from, to] : walls) path.walls.push_back({from, to, si<Length>(10e-3), {}, {}});
  return path;
}

using Numbers = std::vector<std::size_t>;

}  // namespace

TEST_CASE("webs of a path go from wall to wall", "[section]") {
  // Channel with lips: flanges 0 and 1, web 2 in two parts 2 and 3, lips 4 and 5.
  const ThinWalled channel =
      path_of({{0, 100}, {100, 100}, {0, 0}, {0, -100}, {100, -100}, {100, 70}, {100, -70}},
              {{0, 1}, {3, 4}, {0, 2}, {2, 3}, {1, 5}, {4, 6}});
  CHECK(webs_of(channel) == Numbers{2, 3});
  // An angle has none, nor a box with a short trough beneath its flange more than its sides.
  CHECK(webs_of(path_of({{0, 0}, {100, 0}, {0, 100}}, {{0, 1}, {0, 2}})).empty());
  const ThinWalled trough =
      path_of({{200, 200},
               {-200, 200},
               {-200, -200},
               {200, -200},
               {50, 200},
               {-50, 200},
               {30, 120},
               {-30, 120}},
              {{0, 4}, {4, 5}, {5, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 6}, {6, 7}, {7, 5}});
  CHECK(webs_of(trough) == Numbers{3, 5});
}

TEST_CASE("a seam is where a web meets another wall", "[section]") {
  const ThinWalled girder =
      path_of({{100, 200}, {0, 200}, {-100, 200}, {100, -200}, {0, -200}, {-100, -200}},
              {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {1, 4}});
  const auto webs = webs_of(girder);
  REQUIRE(webs == Numbers{4});
  const auto part = [&](double y, double z) {
    return part_in(girder, webs, si<Length>(1e-3 * y), si<Length>(1e-3 * z));
  };
  CHECK(part(5.0, 0.0) == SectionPart::web);
  CHECK(part(-5.0, 189.0) == SectionPart::web);
  CHECK(part(5.0, 195.0) == SectionPart::web_end);
  CHECK(part(0.0, 195.0) == SectionPart::web_end);
  CHECK(part(0.0, 206.0) == SectionPart::fibre);
  CHECK(part(50.0, 195.0) == SectionPart::fibre);
}

}  // namespace path_webs_test
