// Details that lie at one place and are of unlike curves, and details of webs and seams: against
// hand formulas, and a path against the box that it is.

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace unlike_details_test {

using namespace boxbeam;

namespace {

const std::string tail =
    "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
    "1.0\nshear_lag = false\n";

/// A beam of 4 m on two supports under a force in its middle that comes and goes, gamma_Mf = 1.35.
std::string lifted(const std::string& section, double kN, double cycles, const std::string& beam,
                   const std::string& fatigue) {
  return "[case]\nname = \"d\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
         "m/s^2\"]\n[sections.s]\n" +
         section +
         "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = "
         "\"s\"\n[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"4 m\"\nstiff_length = \"150 "
         "mm\"\n" +
         beam +
         fmt::format(
             "[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n[supports.z]\nkind = "
             "\"roller\"\nat = \"4 m\"\n[loads.f]\nkind = \"force\"\nat = \"2 m\"\nforce = "
             "[\"0 kN\", \"-{} kN\"]\n[[situations]]\nname = \"off\"\nloads = {{ }}\n"
             "[[situations]]\nname = \"on\"\nloads = {{ f = 1.0 }}\n[[situations]]\nname = "
             "\"change\"\nbetween = [\"off\", \"on\"]\ncycles = {}\n",
             kN, cycles) +
         "[fatigue]\nloading = \"spectrum\"\ngamma_Mf = 1.35\nrequired = 1.0\n" + fatigue + tail;
}

/// The largest use by direct stress in fatigue at a station.
double use_at(const std::string& text, double s) {
  const Project project = parse_project("d.toml", text);
  double most = 0.0;
  for (const CheckResult& of : verify(project).checks) {
    if (of.check.criterion == Criterion::fatigue && std::abs(of.check.station.s.value() - s) < 1e-6)
      most = std::max(most, of.check.utilisation());
  }
  return most;
}

const std::string small_box =
    "kind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 mm\"\nflange = \"8 mm\"\nweb = \"8 mm\"\n";
const std::string diaphragms =
    "[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"40 mm\"\nthroat = \"15 mm\"\n"
    "[[beam.diaphragms]]\nstation = \"2 m\"\nthickness = \"30 mm\"\nthroat = \"12 mm\"\n"
    "[[beam.diaphragms]]\nstation = \"4 m\"\nthickness = \"40 mm\"\nthroat = \"15 mm\"\n";
const std::string node =
    "[[fatigue.details]]\nname = \"node\"\nfrom = \"1.5 m\"\nto = \"2.5 m\"\nrow = \"8.7/1\"\n"
    "facts = { part = \"lattice node\", tube = \"circular\", braces = \"gap\", thickness_ratio = "
    "2.5, thickness = \"8 mm\" }\n";

/// Box girder 400 x 600 with flanges of 20 and webs of 12 mm, as a path by its mid-lines.
const std::string girder_path =
    "kind = \"thin-walled\"\nnodes = { tl = [\"194 mm\", \"290 mm\"], tr = [\"-194 mm\", \"290 "
    "mm\"], bl = [\"194 mm\", \"-290 mm\"], br = [\"-194 mm\", \"-290 mm\"] }\nwalls = [\n"
    "{ from = \"tl\", to = \"tr\", thickness = \"20 mm\" },\n"
    "{ from = \"bl\", to = \"br\", thickness = \"20 mm\" },\n"
    "{ from = \"tl\", to = \"bl\", thickness = \"12 mm\" },\n"
    "{ from = \"tr\", to = \"br\", thickness = \"12 mm\" }]\n";

std::string on(const char* where, double category = 36.0) {
  return fmt::format(
      "[[fatigue.details]]\nname = \"k\"\nfrom = \"1 m\"\nto = \"1.5 m\"\non = \"{}\"\ncategory = "
      "{}\n",
      where, category);
}

std::string complaint_of(const std::string& section, const char* where) {
  try {
    parse_project("d.toml", lifted(section, 10.0, 1e6, "", "category = 112\n" + on(where)));
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    CHECK(error.problems().front().line > 0);
    return error.problems().front().message;
  }
  return "";
}

}  // namespace

// The diaphragm's 8.4/8 is 71 with m = 3, the node's 8.7/1 is 90 with m = 5: at 2e4 cycles 330
// against 226 MPa, at 2e6 cycles 71 against 90.
TEST_CASE("of details of unlike slope at one place each is judged", "[details]") {
  const double I = (std::pow(0.2, 4) - std::pow(0.184, 4)) / 12.0;
  const double range = 80e3 * 4.0 / 4.0 * 0.1 / I;
  const std::string fatigue = "category = 160\n" + node;
  const double by_node = range * 1.35 / (90e6 * std::pow(2e6 / 2e4, 1.0 / 5.0));
  CHECK(use_at(lifted(small_box, 80.0, 2e4, diaphragms, fatigue), 2.0) ==
        Approx(by_node).epsilon(1e-3));
  const double few = 20.0 / 80.0 * range * 1.35 / (71e6 * std::pow(2e6 / 1e6, 1.0 / 3.0));
  CHECK(use_at(lifted(small_box, 20.0, 1e6, diaphragms, fatigue), 2.0) ==
        Approx(few).epsilon(1e-3));
}

// At 1.5 m, sigma = F s/2 z/I; the webs' mid-lines end at those of the flanges.
TEST_CASE("walls of paths along z have the details of webs", "[details]") {
  const double I = 2.0 * (0.388 * 0.02 * 0.29 * 0.29 + 0.388 * std::pow(0.02, 3) / 12.0 +
                          0.012 * std::pow(0.58, 3) / 12.0);
  const double range = 300e3 * 1.5 / 2.0 / I;
  const auto by = [&](double z, double category) {
    return range * z * 1.35 / (category * 1e6 * std::pow(2.0, 1.0 / 3.0));
  };
  const auto used = [&](const std::string& details) {
    return use_at(lifted(girder_path, 300.0, 1e6, "", "category = 112\n" + details), 1.5);
  };
  // One that is stronger than the beam's own on webs leaves the flanges to that.
  CHECK(used(on("webs", 160.0)) == Approx(by(0.3, 112.0)).epsilon(2e-3));
  CHECK(used(on("webs")) == Approx(by(0.29, 36.0)).epsilon(2e-3));
  // Where they meet the flanges, up to half of both thicknesses from their mid-lines.
  CHECK(used(on("seams")) == Approx(by(0.29, 36.0)).epsilon(0.05));
  // Walls of paths stay fibres besides.
  CHECK(used(on("fibres")) == Approx(by(0.3, 36.0)).epsilon(2e-3));
  CHECK(used(on("webs", 160.0) + on("fibres")) == Approx(by(0.3, 36.0)).epsilon(2e-3));
}

TEST_CASE("a detail of webs or seams where there are none is refused", "[details]") {
  const std::string round = "kind = \"round tube\"\ndiameter = \"200 mm\"\nwall = \"8 mm\"\n";
  const std::string plate = "kind = \"plate\"\nwidth = \"40 mm\"\nheight = \"200 mm\"\n";
  // A tee's stem has a free end.
  const std::string tee =
      "kind = \"thin-walled\"\nnodes = { a = [\"100 mm\", \"50 mm\"], t = [\"0 mm\", \"50 mm\"], c "
      "= [\"-100 mm\", \"50 mm\"], d = [\"0 mm\", \"-100 mm\"] }\nwalls = [\n"
      "{ from = \"a\", to = \"t\", thickness = \"10 mm\" },\n"
      "{ from = \"t\", to = \"c\", thickness = \"10 mm\" },\n"
      "{ from = \"t\", to = \"d\", thickness = \"10 mm\" }]\n";
  for (const std::string& section : {round, plate, tee}) {
    CHECK_THAT(complaint_of(section, "webs"), Catch::Contains("has no webs"));
    CHECK_THAT(complaint_of(section, "seams"), Catch::Contains("has no seams"));
    CHECK(complaint_of(section, "section").empty());
  }
  CHECK(complaint_of(girder_path, "webs").empty());
  CHECK(complaint_of(small_box, "seams").empty());
}

}  // namespace unlike_details_test
