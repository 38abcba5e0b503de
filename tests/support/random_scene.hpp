#pragma once

#include <string>

namespace test {

/// A planar mechanism by chance with a slender tapered box beam in it, as a case file: a four-bar
/// whose coupler or rocker it is, a slider-crank whose rod, or a rocker with three joints that
/// drives a further pair of links. The same seed gives the same case.
struct RandomScene {
  std::string kind;
  std::string text;
};
RandomScene random_scene(unsigned seed);

}  // namespace test
