#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "catch.hpp"

/// What it means that a beam has a hole: definitions, which hold for whatever holes.
namespace beam_holes_test {

using namespace boxbeam;

namespace {

BeamHole hole(const std::string& name, double s, double level = 0.0) {
  BeamHole of;
  of.s = si<Length>(s);
  of.hole.name = name;
  of.hole.diameter = si<Length>(0.03);
  of.hole.position = si<Length>(level);
  return of;
}

/// A beam of 2 m with these holes, added in their order.
Project with(const std::vector<BeamHole>& holes) {
  Project project;
  const Section box{
      symmetric_box(si<Length>(0.2), si<Length>(0.4), si<Length>(0.01), si<Length>(0.01)), {}};
  project.beam.segments = {{"S1", si<Length>(0.0), si<Length>(2.0), box, box}};
  for (const BeamHole& of : holes) add_hole(project, of);
  return project;
}

/// The names of the holes at a station, sorted.
std::vector<std::string> names_at(const Project& project, Length s) {
  std::vector<std::string> names;
  for (const Hole& of : holes_at(project, s)) names.push_back(of.name);
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;
using Places = std::vector<Length>;

}  // namespace

TEST_CASE("a hole marks the beam at its station, which is a place of it from then on") {
  Project project = with({});
  CHECK(project.beam.marks.empty());
  CHECK(places_of(project.beam) == Places{si<Length>(0.0), si<Length>(2.0)});
  add_hole(project, hole("port", 0.7));
  CHECK(project.beam.marks == Places{si<Length>(0.7)});
  CHECK(places_of(project.beam) == Places{si<Length>(0.0), si<Length>(0.7), si<Length>(2.0)});
  REQUIRE(project.holes.size() == 1);
  CHECK(project.holes.front().hole.name == "port");
}

TEST_CASE("a hole is found at its station and nowhere else, however near") {
  const Project project = with({hole("port", 0.7)});
  const Length s = si<Length>(0.7);
  CHECK(names_at(project, s) == Names{"port"});
  // Stations meet places exactly (place_near): within the hole, but beside its centre, is beside
  // it.
  CHECK(names_at(project, si<Length>(std::nextafter(0.7, 1.0))).empty());
  CHECK(names_at(project, si<Length>(std::nextafter(0.7, 0.0))).empty());
  CHECK(names_at(project, s + si<Length>(0.01)).empty());
  for (const Length& place : places_of(project.beam)) {
    CHECK(names_at(project, place).empty() == (place != s));
  }
  // What is computed to within round-off of the hole is brought to it.
  const Length computed = si<Length>(0.8 - 0.1);
  CHECK(names_at(project, computed).empty());
  CHECK(names_at(project, place_near(places_of(project.beam), computed)) == Names{"port"});
}

TEST_CASE("in which order holes are added does not matter") {
  std::vector<BeamHole> holes{hole("a", 0.3), hole("b", 1.2), hole("c", 1.2, 0.1), hole("d", 1.9)};
  const Project first = with(holes);
  std::vector<std::size_t> order{0, 1, 2, 3};
  do {
    std::vector<BeamHole> changed;
    for (const std::size_t i : order) changed.push_back(holes[i]);
    const Project project = with(changed);
    CHECK(places_of(project.beam) == places_of(first.beam));
    for (const Length& place : places_of(first.beam)) {
      CHECK(names_at(project, place) == names_at(first, place));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(names_at(first, si<Length>(0.3)) == Names{"a"});
  CHECK(names_at(first, si<Length>(1.9)) == Names{"d"});
}

TEST_CASE("two holes at one station are both there, and their station is one place") {
  const Project project = with({hole("upper", 1.2, 0.1), hole("lower", 1.2, -0.1)});
  CHECK(names_at(project, si<Length>(1.2)) == Names{"lower", "upper"});
  CHECK(project.holes.size() == 2);
  CHECK(places_of(project.beam) == Places{si<Length>(0.0), si<Length>(1.2), si<Length>(2.0)});
}

}  // namespace beam_holes_test
