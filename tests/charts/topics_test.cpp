#include "charts/topics.hpp"

#include <set>
#include <string>

#include "catch.hpp"
#include "support/program.hpp"

namespace topics_test {

using namespace boxbeam;
using namespace boxbeam::charts;

TEST_CASE("every topic is found by its name, and no other word is one", "[charts]") {
  std::set<std::string> names;
  for (const Topic& topic : topics()) {
    CHECK(names.insert(topic.name).second);
    CHECK(topic_named(topic.name)->run == topic.run);
    CHECK(std::string(topic.title).size() > 5);
  }
  for (const char* asked :
       {"kinematics", "reactions", "cut-forces", "critical-instants", "rfem", "response",
        "integration", "rainflow", "section", "precision", "model", "stability"}) {
    CHECK(names.contains(asked));
  }
  CHECK(topic_named("all") == nullptr);
  CHECK(topic_named("") == nullptr);
}

TEST_CASE("a case stands for the scenes of its own kind only", "[charts]") {
  const auto scenes = [](const std::string& path) {
    return scenes_of(read_project(test::project_file("sections/" + path)));
  };
  const Scenes planar = scenes("slider-crank-press/press.toml");
  CHECK(planar.planar.has_value());
  CHECK_FALSE(planar.flexible.has_value());
  CHECK(planar.beam->name == planar.planar->name);
  const Scenes elastic = scenes("drill-truck/truck.toml");
  CHECK_FALSE(elastic.planar.has_value());
  CHECK(elastic.flexible.has_value());
  const Scenes space = scenes("landing-gear/retraction.toml");
  CHECK_FALSE(space.planar.has_value());
  CHECK_FALSE(space.flexible.has_value());
  CHECK(space.missing.find("in space") != std::string::npos);
  for (const char* nothing_moves : {"crane-girder/girder.toml", "excavator-boom/measured.toml"}) {
    const Scenes still = scenes(nothing_moves);
    CHECK_FALSE(still.planar.has_value());
    CHECK_FALSE(still.flexible.has_value());
    CHECK_FALSE(kinematics(still, {true}).not_applicable.empty());
    CHECK_NOTHROW(stability(still, {true}));
  }
  // The reference cases are those of the folders, byte for byte.
  const Scenes own = reference_scenes();
  CHECK(own.planar->sha256 ==
        read_project(test::project_file("sections/sledge-rig/rig.toml")).sha256);
  CHECK(own.flexible->sha256 ==
        read_project(test::project_file("sections/drill-truck/truck.toml")).sha256);
}

}  // namespace topics_test
