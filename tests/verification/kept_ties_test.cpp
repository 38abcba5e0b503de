// Statics of the second order of a mechanism of many loops in space, from posture to posture.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <string>

#include "support/bent_in_space.hpp"

namespace kept_ties_test {

using namespace boxbeam;
using namespace test::bent;

namespace {

/// Four-bars in a row, so many: the first crank is driven and is the beam.
std::string four_bars(int count) {
  const std::string rod =
      "mass = \"300 kg\"\nuniform_rod = [\"O\", \"A\"]\n"
      "points = { O = [\"0 m\", \"0 m\", \"0 m\"], A = [\"1 m\", \"0 m\", \"0 m\"] }\n";
  std::string text = header({0.0, 0.0, -9.81}) + sections + R"(
[drivers.motor]
joint = "crank-0"
kind = "harmonic"
mean = "0 deg"
amplitude = "10 deg"
frequency = "0.7 Hz"
[bodies.lever]
points = { O = ["0 m", "0 m", "0 m"], A = ["1 m", "0 m", "0 m"] }
[beam]
body = "lever"
start = "O"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "1 m"
section = "arm"
)";
  for (int i = 0; i <= count; ++i) {
    const std::string crank = i == 0 ? "lever" : fmt::format("rod-{}", i);
    if (i > 0) text += fmt::format("[bodies.{}]\n{}", crank, rod);
    text += fmt::format(
        "[joints.crank-{}]\nkind = \"revolute\"\nconnect = [\"ground\", \"{}.O\"]\nat = [\"{} m\", "
        "\"0 m\", \"0 m\"]\nturn = [\"y\", \"-90 deg\"]\naxis = [{}, 1, 0]\n",
        i, crank, i, i % 2 == 0 ? 0.1 : -0.1);
    if (i == 0) continue;
    text += fmt::format("[bodies.coupler-{}]\n{}", i, rod);
    text += fmt::format(
        "[joints.left-{0}]\nkind = \"universal\"\nconnect = [\"{1}.A\", \"coupler-{0}.O\"]\nturn = "
        "[\"y\", \"90 deg\"]\naxis = \"y\"\nsecond_axis = \"z\"\n[joints.right-{0}]\nkind = "
        "\"spherical\"\ncloses = true\nconnect = [\"coupler-{0}.A\", \"{2}.A\"]\n",
        i, i == 1 ? "lever" : fmt::format("rod-{}", i - 1), crank);
  }
  return text + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

}  // namespace

// Independent computation: the ties of every posture eliminated by themselves.
TEST_CASE("the order of ties that is kept from posture to posture changes no bending",
          "[second_order]") {
  const Bent of(four_bars(40));
  const spatial::Chain& chain = chain_of(of.rigid.front());
  const LoadHistory& loads = of.rigid.front().loads;
  BentInSpace kept(of.project, chain);
  for (const std::size_t part : {0, 1, 3, 2, 4}) {
    const Time time = loads.time_of(part * (loads.instants() - 1) / 4);
    CAPTURE(time.value());
    const auto bent_by = [&](BentInSpace& in) {
      return in.at(chain.at(time.value()), cut_forces_of(loads.loads_at(time)), 1.0).value();
    };
    BentInSpace once(of.project, chain);
    const frame::BentScene found = bent_by(kept), anew = bent_by(once);
    REQUIRE_FALSE(anew.critical);
    REQUIRE_FALSE(found.critical);
    CHECK(anew.turn > 1e-6);
    CHECK(found.turn == Approx(anew.turn).epsilon(1e-8));
    const double largest = anew.motion.cwiseAbs().maxCoeff();
    CHECK((found.motion - anew.motion).cwiseAbs().maxCoeff() < 1e-8 * largest);
    const Vector6 cut = cuts_at(cut_forces_of(anew.loads), 0.3);
    CHECK((cuts_at(cut_forces_of(found.loads), 0.3) - cut).norm() < 1e-7 * cut.norm());
  }
}

}  // namespace kept_ties_test
