// Of a long record few instants are looked at: those at which forces near each other press a web
// most are among them. The same events with rests between them, and without.

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace pressing_sums_test {

using namespace boxbeam;

namespace {

/// Random events of four forces, each followed by so many instants without any. At one of them two
/// near each other press down together, which neither any one force nor a cut force shows.
std::string events(std::size_t rests) {
  constexpr int count = 3000;
  std::mt19937_64 random(5);
  const auto force = [&] {
    return 230.0 * (2e-9 * static_cast<double>(random() % 1'000'000'001) - 1.0);
  };
  std::string text = "t [s],F1 [kN],F2 [kN],G [kN],K [kN]\n0,0,0,0,0\n";
  std::size_t row = 0;
  const auto add = [&](double F1, double F2, double G, double K) {
    text += fmt::format("{:.2f},{:.3f},{:.3f},{:.3f},{:.3f}\n", 0.01 * static_cast<double>(++row),
                        F1, F2, G, K);
  };
  for (int i = 0; i < count; ++i) {
    double F1 = -225.0, F2 = -225.0, G = 100.0, K = 120.0;
    while (i != count / 2) {
      F1 = force(), F2 = force(), G = force(), K = force();
      if (std::abs(F1 + F2) <= 390.0) break;
    }
    add(F1, F2, G, K);
    for (std::size_t k = 0; k < rests; ++k) add(0.0, 0.0, 0.0, 0.0);
  }
  return text;
}

double patch_use(const test::TemporaryFolder& folder, const std::string& record) {
  folder.write("events.csv", record);
  const Verification of = verify(read_project(folder.write(
      "case.toml",
      "[case]\nname = \"events\"\nkind = \"loads\"\n[files.a]\npath = \"events.csv\"\n"
      "[loads.l0]\nstation = \"2 m\"\ncolumns = { F_z = \"F1\" }\n"
      "[loads.l1]\nstation = \"2.2 m\"\ncolumns = { F_z = \"F2\" }\n"
      "[loads.l2]\nstation = \"2.6 m\"\ncolumns = { F_z = \"G\" }\n"
      "[loads.l3]\nstation = \"3 m\"\ncolumns = { F_z = \"K\" }\n"
      "[balance]\nstation = \"0 m\"\n[sections.s]\nkind = \"box\"\nwidth = \"400 mm\"\n"
      "height = \"500 mm\"\nflange = \"20 mm\"\nweb = \"5 mm\"\n[beam]\n"
      "density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"3 m\"\nsection = \"s\"\n"
      "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"1.5 m\"\ninto = \"webs\"\n"
      "[[beam.load_introductions]]\nfrom = \"1.5 m\"\nto = \"2.5 m\"\nstiff_length = \"60 mm\"\n"
      "[[beam.load_introductions]]\nfrom = \"2.5 m\"\nto = \"3 m\"\ninto = \"webs\"\n"
      "[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"12 mm\"\n"
      "[[beam.diaphragms]]\nstation = \"3 m\"\nthickness = \"12 mm\"\n"
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n")));
  const CheckResult* const patch = of.governing(Criterion::patch_loading);
  REQUIRE(patch != nullptr);
  return patch->check.utilisation();
}

}  // namespace

TEST_CASE("webs under forces of a long record are used as by the same events without rests",
          "[recorded][patch]") {
  const test::TemporaryFolder folder;
  const double all = patch_use(folder, events(1));
  const double some = patch_use(folder, events(102));
  CHECK(some == Approx(all).epsilon(0.01));
  CHECK(some <= all * (1.0 + 1e-9));
}

}  // namespace pressing_sums_test
