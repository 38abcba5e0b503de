// A case whose exciter is a force: integrated, verified, against the closed form of the oscillator.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "catch.hpp"
#include "support/program.hpp"
#include "support/shaken_beam.hpp"

namespace exciter_force_test {

using Json = nlohmann::json;

TEST_CASE("an exciter's force instead of its motion: amplitude, stress and range by hand") {
  // Steady state of m x'' + c x' + k x = F sin(omega t): amplitude F/sqrt((k - m omega^2)^2 +
  // (c omega)^2); after 8 s the start has decayed by exp(-c t/(2 m)) < 1e-60. In the middle each
  // half of the beam is a cantilever under its own inertia: M = (m/2) a (1 m/2), sigma = M/W. Shear
  // lag, EN 1993-1-5 table 3.1: b_0 = 45 mm of L_e = 2 m, a peak of the moment in the middle.
  const double area = 0.1 * 0.1 - 0.08 * 0.08;
  const double mass = 7850.0 * area * 2.0;
  const double omega = 2.0 * std::numbers::pi * 5.0;
  const double amplitude = 3000.0 / std::hypot(200e3 - mass * omega * omega, 2000.0 * omega);
  const double kappa = 0.045 / 2.0;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  const double idle = (1.0 - beta) * 0.09 * (std::pow(0.1, 3) - std::pow(0.08, 3));
  const double W = (std::pow(0.1, 4) - std::pow(0.08, 4) - idle) / 12.0 / 0.05;
  const double sigma = 0.5 * mass * amplitude * omega * omega * 0.5 / W;

  const test::TemporaryFolder folder;
  const std::string path = folder.write("shaken.toml", test::shaken_beam);
  const test::ProgramResult result =
      test::run_program({"verify", path, "--json", "-", "--no-plots", "--no-pdf", "--out",
                         (folder.path() / "out").string()});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const Json document = Json::parse(result.out);
  const Json& fatigue = document["governing"]["fatigue"];
  CHECK(fatigue["station"].get<double>() == Approx(1.0));
  CHECK(fatigue["acting"].get<double>() == Approx(2.0 * sigma).epsilon(1e-6));
  // Of the fibre; the flange's end has some shear as well and governs.
  double fibre = 0.0;
  for (const Json& check : document["checks"]) {
    if (check["criterion"] == "yield" && check["point"].get<std::string>().starts_with("fibre"))
      fibre = std::max(fibre, check["acting"].get<double>());
  }
  CHECK(fibre == Approx(sigma).epsilon(1e-6));
  CHECK(document["governing"]["yield"]["acting"].get<double>() >= sigma * (1.0 - 1e-6));

  // Phase: tan = c omega/(k - m omega^2) behind the force.
  const double phase = std::atan2(2000.0 * omega, 200e3 - mass * omega * omega);
  const test::ProgramResult motion =
      test::run_program({"motion", path, "--at", "8.05", "--json", "-"});
  REQUIRE(motion.exit_code == 0);
  const Json state = Json::parse(motion.out)["states"][0];
  CHECK(state["bodies"]["beam"]["y"].get<double>() ==
        Approx(amplitude * std::sin(omega * 8.05 - phase)).epsilon(1e-8));
}

TEST_CASE("what lasts no longer than asked for is not shown beyond") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("shaken.toml", test::shaken_beam);
  const test::ProgramResult motion = test::run_program({"motion", path, "--at", "9"});
  CHECK(motion.exit_code == 3);
  CHECK(motion.err.find("the motion lasts from 8 s to 8.4 s") != std::string::npos);
}

}  // namespace exciter_force_test
