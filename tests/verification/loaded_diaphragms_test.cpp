// What a force between the webs of a box does to the diaphragm under it: by hand.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace loaded_diaphragms_test {

using namespace pressed_beams;

namespace {

/// 2400 kN in the middle of a box 600 x 600 x 20 x 12, on a diaphragm of 8 mm.
Beam on_thin_diaphragm(double opening) {
  Beam beam;
  beam.space = true;
  beam.pieces = {{4.0, {}, {}}};
  beam.diaphragms = {0.0, 4.0};
  beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
  beam.forces = {{"f", 2.0, 2400.0}};
  beam.more = fmt::format(
      "[[beam.diaphragms]]\nstation = \"2 m\"\nthickness = \"8 mm\"\nopening = \"{} mm\"\n",
      opening);
  return beam;
}

/// How far the plate of a diaphragm is said to be used in shear; 0 where it is not.
double said_of_plate(const Verification& of) {
  const std::string words = "uses its plate in shear by ";
  for (const Gate& gate : of.gates) {
    const std::size_t at = gate.finding.find(words);
    if (at != std::string::npos && gate.blocks)
      return std::stod(gate.finding.substr(at + words.size()));
  }
  return 0.0;
}

}  // namespace

// Half of the force goes to each web. EN 1993-1-5, 5.2 and 5.3, of a plate 576 long between webs
// and 560 deep: k_tau = 5.34 + 4 (560/576)^2, lambda_w = h_w/(37.4 t eps sqrt(k_tau)),
// chi_w = 0.83/lambda_w; an access hole is taken as deep as it is wide.
TEST_CASE("a force between webs shears what an access hole leaves of its diaphragm", "[patch]") {
  const double h = 560.0, t = 8.0, f_y = 355.0;
  const double k_tau = 5.34 + 4.0 * std::pow(h / 576.0, 2);
  const double lambda = h / (37.4 * t * std::sqrt(235.0 / f_y) * std::sqrt(k_tau));
  REQUIRE(lambda > 0.83 / 1.2);
  const double gamma_M1 =
      parse_project("pressed.toml", on_thin_diaphragm(50.0).text()).strength.gamma_M1;
  const double V = 1e-3 * 0.83 / lambda * f_y * h * t / (std::sqrt(3.0) * gamma_M1);
  for (const double opening : {50.0, 140.0, 280.0}) {
    CAPTURE(opening);
    CHECK(said_of_plate(on_thin_diaphragm(opening).verified()) ==
          Approx(1200.0 / (V * (1.0 - opening / h))).epsilon(5e-3));
  }
}

}  // namespace loaded_diaphragms_test
