// What meets at one place: kinks of both flanges at a diaphragm, kinks and loads along the beam,
// forces opposed to many small ones, forces beside each other between the webs, torque and a thin
// diaphragm.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace met_at_one_place_test {

using namespace pressed_beams;

namespace {

std::string line(double from, double to, double kN_per_m) {
  return fmt::format(
      "[loads.q]\nkind = \"line\"\nfrom = \"{} m\"\nto = \"{} m\"\nforce_per_length = [\"0 kN/m\", "
      "\"{} kN/m\"]\n",
      from, to, kN_per_m);
}

/// A box that bears a moment, on whose way both flanges turn off by 75 mm in 600 mm.
struct Turning {
  Beam beam;
  double turned = 0.0;  ///< what both flanges turn off together, a half in each web [N]

  Turning(double kN_m, double thickness, double weld) {
    const Sizes low{900, 300, 25, 14, 0.0}, high{900, 450, 25, 14, 0.0};
    beam.pieces = {{2.0, low, low}, {0.6, low, high}, {1.4, high, high}};
    beam.diaphragms = {2.0};
    beam.thickness = thickness;
    beam.weld = weld;
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    beam.forces = {{"m", 0.0, 0.0, 0.0, 0.0, -kN_m}, {"n", 4.0, 0.0, 0.0, 0.0, kN_m}};
    // The flange's force at its mid-line, by how steep it is; each web has half of both.
    const double I = 2.0 * (900.0 * 25.0 * 137.5 * 137.5 + 900.0 * std::pow(25.0, 3) / 12.0) +
                     2.0 * 14.0 * std::pow(250.0, 3) / 12.0;
    turned = kN_m * 1e6 * 137.5 / I * 900.0 * 25.0 * (75.0 / 600.0);
  }
};

}  // namespace

TEST_CASE("kinks of both flanges go through one weld of their diaphragm with the web", "[patch]") {
  const Turning of(1100.0, 8.0, 3.0);
  const double bears = 2.0 * 3.0 * (250.0 - 6.0) * 490.0 / (std::sqrt(3.0) * 0.9 * 1.25);
  const Verification verified = of.beam.verified();
  CHECK(use_at(verified, Criterion::weld,
               "weld of web and diaphragm under the kink of the top flange and") ==
        Approx(of.turned / bears).epsilon(0.02));
  CHECK(verified.verdict == Verdict::fail);
}

TEST_CASE("and so they do at every cycle", "[patch]") {
  Turning of(150.0, 20.0, 4.0);
  of.beam.more = cycles(2e6, "m = 1.0, n = 1.0", "m = 0.0, n = 0.0");
  const double range = of.turned / (2.0 * 4.0 * (250.0 - 8.0));
  CHECK(use_at(of.beam.verified(), Criterion::patch_fatigue,
               "weld of web and diaphragm under the kink") ==
        Approx(range / (36.0 / 1.35)).epsilon(0.02));
}

TEST_CASE("a couple at a border by another sum of lengths stands on it", "[patch]") {
  // 1.72 + 1.25 is not 2.97 in binary digits, and the flanges are not as thick on both sides.
  Beam beam;
  const Sizes thick{415, 780, 29, 15, 6.0}, high{415, 780, 16, 15, 17.0},
      low{415, 460, 16, 15, 18.0};
  beam.pieces = {{1.45, thick, thick}, {1.25, high, low}, {1.72, low, low}};
  beam.diaphragms = {0.0, 4.42};
  beam.supports = {{0.0, 0.0}, {4.42, 0.0}};
  beam.forces = {{"f", 1.41, 334.31}, {"m", 1.45, 0.0, 0.0, 0.0, -70.07}};
  beam.more = introduced(0.2, 4.22, 3.0);
  Beam image = beam.mirrored();
  image.more = beam.more;
  image.forces[1].at = 2.97;
  const double one = use_of(beam.verified(), Criterion::patch_loading);
  CHECK(one > 0.1);
  CHECK(use_of(image.verified(), Criterion::patch_loading) == Approx(one).epsilon(1e-6));
}

TEST_CASE("a load along the beam meets the larger kink, whichever flange has it", "[patch]") {
  const auto use = [](double q) {
    Beam beam;
    const Sizes low{200, 500, 40, 6, 0.0}, high{200, 800, 40, 6, 0.0};
    beam.pieces = {{1.0, low, low}, {1.0, low, high}, {0.5, high, high}};
    beam.diaphragms = {0.0, 2.0, 2.5};
    beam.supports = {{2.5, 0.0}, {0.0, 0.0}};
    beam.more = line(0.9, 1.1, q) +
                "[loads.n]\nkind = \"force\"\nat = \"0 m\"\nforce = [\"-1500 kN\", \"0 kN\"]\n";
    return use_at(beam.verified(), Criterion::patch_loading, "a load along the beam and the kink");
  };
  CHECK(use(-3600.0) == Approx(use(3600.0)).epsilon(1e-6));
  // Without the kink 0.859, the larger one alone 0.485 less what its stiff length spares.
  CHECK(use(-3600.0) > 1.0);
}

TEST_CASE("a force is opposed by a load along the beam, and by many small forces", "[patch]") {
  // EN 1993-1-5, 6.2: type b of a web 950 x 10, a = 4 m, flange 25 x 200: k_F = 3.613, F_cr = 718.8
  // kN, l_y = 599.6 mm, chi_F = 0.2906, F_Rd = 618.5 kN.
  constexpr double F_Rd = 618.5;
  const Sizes section{400, 1000, 25, 10, 10.0};
  Beam beam = {};
  beam.pieces = {{4.0, section, section}};
  beam.diaphragms = {0.0, 4.0};
  beam.thickness = 20.0;
  beam.weld = 8.0;
  beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
  beam.forces = {{"up", 2.0, -1350.0}};
  beam.more = introduced(0.1, 3.9, 200.0) + line(1.6, 2.4, -1350.0 / 0.8);
  CHECK(use_at(beam.verified(), Criterion::patch_loading, "under up") ==
        Approx(675.0 / F_Rd).epsilon(2e-3));
  beam.forces = {{"up", 2.0, -700.0}};
  for (int i = 0; i < 20; ++i)
    beam.forces.push_back({fmt::format("d{}", i), 1.6 + 0.8 * i / 19.0, 35.0});
  beam.more = introduced(0.1, 3.9, 200.0);
  CHECK(use_at(beam.verified(), Criterion::patch_loading, "under up") ==
        Approx(350.0 / F_Rd).epsilon(2e-3));
}

TEST_CASE("two forces at one place between the webs press a diaphragm as one does", "[patch]") {
  const auto use = [](int pieces, double apart) {
    const Sizes section{600, 800, 20, 12, 0.0};
    Beam beam;
    beam.space = true;
    beam.pieces = {{4.0, section, section}};
    beam.diaphragms = {0.0, 2.0, 4.0};
    beam.weld = 4.0;
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    for (int i = 0; i < pieces; ++i)
      beam.forces.push_back(
          {fmt::format("f{}", i), 2.0, 600.0 / pieces, apart * (i - 0.5 * (pieces - 1)), 0.4});
    beam.more = introduced(1.99, 2.01, 100.0);
    return use_at(beam.verified(), Criterion::weld,
                  "flange and diaphragm beside left web under f0");
  };
  // Over 100 + 2 x 20 mm, on both faces, at 45 degrees to the throat: sqrt(2) 600e3/(2 x 4 x 140)
  // of 490/(0.9 x 1.25) MPa.
  CHECK(use(1, 0.0) ==
        Approx(std::sqrt(2.0) * 600e3 / (8.0 * 140.0) / (490.0 / 1.125)).epsilon(5e-3));
  for (const int pieces : {2, 3}) CHECK(use(pieces, 0.0) == Approx(use(1, 0.0)).epsilon(1e-6));
  // Apart by more than that each has its own.
  CHECK(use(2, 0.15) == Approx(0.5 * use(1, 0.0)).epsilon(0.12));
  // Above the webs none stands between them.
  CHECK(use(2, 0.588) < 0.5 * use(1, 0.0));
}

TEST_CASE("a diaphragm that keeps a box in shape bears what shears it", "[patch]") {
  const auto of = [](double thickness, double torque, double weld) {
    const Sizes section{800, 800, 16, 12, 16.0};
    Beam beam;
    beam.space = true;
    beam.pieces = {{6.0, section, section}};
    beam.diaphragms = {3.0};
    beam.thickness = thickness;
    beam.weld = weld;
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"t", 3.0, 0.0, 0.0, 0.0, 0.0, torque}};
    beam.more = introduced(0.1, 5.9, 300.0);
    return beam.verified();
  };
  // T/(2 b) = 190 kN on 784 x 788 x 2 mm: lambda_w = 4.15, chi_w = 0.20, 64 kN.
  CHECK(stops(of(2.0, 300.0, 0.0), "keeps its shape under torque"));
  CHECK_FALSE(stops(of(12.0, 300.0, 0.0), "keeps its shape under torque"));
  // 900 kN m: 571 kN in two throats of 3 mm, 121 MPa of 251; four times as much is too much.
  CHECK_FALSE(stops(of(20.0, 900.0, 3.0), "keeps its shape under torque"));
  CHECK(stops(of(30.0, 2400.0, 3.0), "shear its fillets"));
}

TEST_CASE("a thousandth of a newton along the beam chooses no strength", "[plates]") {
  const auto use = [](double N) {
    const Sizes section{500, 1200, 12, 6, 0.0};
    Beam beam;
    beam.pieces = {{6.0, section, section}};
    beam.diaphragms = {0.0, 1.5, 3.0, 4.5, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", 3.0, 500.0}};
    beam.more = fmt::format(
        "[loads.n]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"{} N\", \"0 "
        "kN\"]\n[[part_materials]]\nsteel = \"S235\"\nplates = [\"left web\", \"right web\"]\n",
        N);
    const Verification of = beam.verified();
    return std::max(use_of(of, Criterion::yield), use_of(of, Criterion::effective_section));
  };
  CHECK(use(-1e-3) == Approx(use(1e-3)).epsilon(1e-6));
  CHECK(use(1e-3) > 0.2);
}

}  // namespace met_at_one_place_test
