// Turning over is looked at at every instant that could be the worst: against a look at each one by
// itself, and peaks wherever in a record they stand.

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <vector>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace lateral_instants_test {

using namespace boxbeam;

namespace {

struct Row {
  double tip, middle, across;  ///< [kN]
};

const std::string girder =
    "[sections.a]\nkind = \"thin-walled\"\nnodes = { a = [\"90 mm\", \"300 mm\"], t = [\"0 mm\", "
    "\"300 mm\"], b = [\"-90 mm\", \"300 mm\"], c = [\"60 mm\", \"-300 mm\"], u = [\"0 mm\", "
    "\"-300 "
    "mm\"], d = [\"-60 mm\", \"-300 mm\"] }\n"
    "walls = [{ from = \"a\", to = \"t\", thickness = \"16 mm\" },"
    " { from = \"t\", to = \"b\", thickness = \"16 mm\" },"
    " { from = \"c\", to = \"u\", thickness = \"16 mm\" },"
    " { from = \"u\", to = \"d\", thickness = \"16 mm\" },"
    " { from = \"t\", to = \"u\", thickness = \"10 mm\" }]\n";
const std::string plate =
    "[sections.a]\nkind = \"plate\"\nwidth = \"20 mm\"\nheight = \"300 mm\"\n";

/// M/M_cr at most of a cantilever of 6 m under forces at its tip, in its middle and across.
double largest_part(const std::string& section, const std::vector<Row>& rows) {
  const test::TemporaryFolder folder;
  std::string table = "time [s],T [kN],M [kN],A [kN]\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    table += fmt::format("{},{},{},{}\n", 0.01 * static_cast<double>(i), rows[i].tip,
                         rows[i].middle, rows[i].across);
  folder.write("f.csv", table);
  const Project project = read_project(folder.write(
      "case.toml",
      "[case]\nname = \"given\"\nkind = \"loads\"\n" + section +
          "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"6 m\"\nsection = "
          "\"a\"\n"
          "[files.f]\npath = \"f.csv\"\n"
          "[loads.tip]\nstation = \"6 m\"\ncolumns = { F_z = \"T\", F_y = \"A\" }\n"
          "[loads.middle]\nstation = \"3 m\"\ncolumns = { F_z = \"M\" }\n"
          "[balance]\nstation = \"0 m\"\nname = \"root\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n"));
  return verify(project).model.second_order.lateral->part;
}

}  // namespace

TEST_CASE("turning over: the largest of all instants is that of each by itself", "[lateral]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> of(-1.0, 1.0);
  for (const std::string& section : {plate, girder}) {
    const double scale = section == plate ? 1.5 : 12.0;
    for (int k = 0; k < 3; ++k) {
      std::vector<Row> rows;
      for (int i = 0; i < 130; ++i)
        rows.push_back({scale * of(random), 2.0 * scale * of(random), 0.2 * scale * of(random)});
      double most = 0.0;
      for (const Row& row : rows) most = std::max(most, largest_part(section, {row, row}));
      CAPTURE(k, section);
      REQUIRE(most > 0.1);
      // The search ends 1e-5 beside the load that turns it over; a force may stand at another node.
      CHECK(largest_part(section, rows) == Approx(most).epsilon(1e-4));
    }
  }
}

TEST_CASE("turning over: a peak is seen in whatever row it stands", "[lateral]") {
  const Row quiet{-0.3, 0.2, 0.0}, peak{-20.0, 0.0, 0.0};
  const double alone = largest_part(girder, {peak, peak});
  for (const std::size_t count : {60, 100, 1000, 10000}) {
    for (const double part : {0.137, 0.499, 0.501, 0.99}) {
      std::vector<Row> rows(count, quiet);
      rows[static_cast<std::size_t>(part * static_cast<double>(count))] = peak;
      CAPTURE(count, part);
      CHECK(largest_part(girder, rows) == Approx(alone).epsilon(1e-4));
    }
  }
}

}  // namespace lateral_instants_test
