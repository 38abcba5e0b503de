// Cut forces at stations and instants that stand for a mechanism.

#include "boxbeam/verification/load_samples.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/recorded/channel_loads.hpp"
#include "boxbeam/project/given_loads_case.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace load_samples_test {

using namespace boxbeam;

namespace {

TaperedBeam plain_beam() {
  const Section section{
      symmetric_box(si<Length>(0.1), si<Length>(0.2), si<Length>(0.01), si<Length>(0.01)), {}};
  TaperedBeam beam;
  beam.segments = {{"1", si<Length>(0.0), si<Length>(2.0), section, section}};
  beam.density = si<Density>(7850.0);
  return beam;
}

const std::string given =
    "[case]\nname = \"given\"\nkind = \"loads\"\n[material]\nsteel = \"S355\"\n[strength]\n"
    "shear_lag = false\n"
    "required = 1.0\n[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
    "flange = \"10 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\n"
    "length = \"2 m\"\nsection = \"box\"\n[files.cuts]\npath = \"cuts.csv\"\n";

std::string station(const char* s, const char* shear, const char* moment) {
  return std::string("[[cut_forces]]\nstation = \"") + s + "\"\ncolumns = { V_z = \"" + shear +
         "\", M_y = \"" + moment + "\" }\n";
}

}  // namespace

TEST_CASE("loads_of_cuts: a station that stands twice is a point load") {
  // A beam of 2 m on its ends under P = 10 kN in the middle: V = +-P/2, M = P L/4, whatever way.
  const std::vector<double> stations{0.0, 1.0, 1.0, 2.0};
  const std::vector<recorded::SixForces> values{
      {0, 0, 5e3, 0, 0, 0}, {0, 0, 5e3, 0, 5e3, 0}, {0, 0, -5e3, 0, 5e3, 0}, {0, 0, -5e3, 0, 0, 0}};
  const BeamLoads loads = recorded::loads_of_cuts(plain_beam(), stations, values);
  const Imbalance open = imbalance_of(loads);
  CHECK(open.force.norm() < 1e-9);
  CHECK(open.moment.norm() < 1e-9);
  const auto middle = std::find_if(loads.points.begin(), loads.points.end(),
                                   [](const PointLoad& load) { return load.s.value() == 1.0; });
  REQUIRE(middle != loads.points.end());
  CHECK(middle->force.z() == Approx(10e3));  // V falls by what acts upwards: dV/ds = -q
  const CutForceDiagram diagram = cut_forces_of(loads);
  CHECK(diagram.at({si<Length>(1.0), Side::before}).V_z.value() == Approx(5e3));
  CHECK(diagram.at({si<Length>(1.0), Side::behind}).V_z.value() == Approx(-5e3));
  CHECK(diagram.at({si<Length>(0.5)}).M_y.value() == Approx(2.5e3));
  CHECK(diagram.at({si<Length>(1.5)}).M_y.value() == Approx(2.5e3));
}

TEST_CASE("given cut forces: a jump is read, and what cannot be one is refused") {
  const test::TemporaryFolder folder;
  folder.write("cuts.csv",
               "time [s],V1 [N],V2 [N],M0 [N m],M1 [N m]\n0,5000,-5000,0,5000\n"
               "1,2500,-2500,0,2500\n");
  const std::string first = station("0 m", "V1", "M0"), before = station("1 m", "V1", "M1"),
                    behind = station("1 m", "V2", "M1"), last = station("2 m", "V2", "M0");
  const Project project =
      read_project(folder.write("case.toml", given + first + before + behind + last));
  const Verification verification = verify(project);
  // In the middle of the flange, where no shear flows, M/W yields; W of 100 x 200 less 80 x 180 mm.
  const double W = (0.1 * 0.008 - 0.08 * 0.005832) / 12.0 / 0.1;
  std::size_t fibres = 0;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield || check.point != "fibre +z") continue;
    if (check.station.s.value() != 1.0) continue;
    CHECK(check.station.side != Side::both);
    CHECK(check.safety_factor == Approx(355e6 / (5e3 / W)));
    ++fibres;
  }
  CHECK(fibres == 2);
  const auto complaint = [&](const std::string& stations) -> std::string {
    try {
      read_project(folder.write("broken.toml", given + stations));
    } catch (const InputError& error) {
      return error.problems().front().message;
    }
    return "";
  };
  CHECK(complaint(first + before + behind + behind + last).find("ascend") != std::string::npos);
  CHECK(complaint(first + behind + first + last).find("ascend") != std::string::npos);
  CHECK(complaint(first + first + behind + last).find("twice") != std::string::npos);
  CHECK(complaint(first + before + last + last).find("twice") != std::string::npos);
}

TEST_CASE("load samples of the rig: every chord is within the stated error") {
  const Project& project = test::rig();
  const Verification verification = verify(project);
  const std::deque<SituationRun> runs = run_situations(project, verification.model.chosen);
  const LoadSamples samples = sample_loads(project, runs, verification);
  REQUIRE(!samples.slides);
  REQUIRE(samples.situations.size() == 1);
  const SampledSituation& of = samples.situations.front();
  CHECK(std::is_sorted(of.times.begin(), of.times.end()));
  // N and V jump where the pivot bears, and at no other place within the beam.
  std::vector<double> twice;
  for (std::size_t j = 1; j < samples.stations.size(); ++j)
    if (samples.stations[j].s == samples.stations[j - 1].s)
      twice.push_back(samples.stations[j].s.value());
  CHECK(twice == std::vector<double>{3.2});
  // At places and times of no importance the straight lines are as near as is said.
  const LoadHistory& loads = runs.front().loads;
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < loads.instants(); ++i)
    largest = std::max(largest, std::abs(loads.diagram(i).at({si<Length>(3.2)}).M_y.value()));
  for (int k = 1; k < 200; ++k) {
    const double time = of.times.front() + (of.times.back() - of.times.front()) * k / 200.3;
    const double s = 6.2 * (k * 37 % 200 + 0.41) / 201.0;
    const auto i = static_cast<std::size_t>(
        std::upper_bound(of.times.begin(), of.times.end(), time) - of.times.begin() - 1);
    std::size_t j = 0;
    while (samples.stations[j + 1].s.value() < s) ++j;
    const double p = (time - of.times[i]) / (of.times[i + 1] - of.times[i]);
    const double q = (s - samples.stations[j].s.value()) /
                     (samples.stations[j + 1].s - samples.stations[j].s).value();
    const auto M = [&](std::size_t a, std::size_t b) { return of.at[a][b].M_y.value(); };
    const double line = (1 - p) * ((1 - q) * M(i, j) + q * M(i, j + 1)) +
                        p * ((1 - q) * M(i + 1, j) + q * M(i + 1, j + 1));
    const double exact = loads.diagram_at(si<Time>(time)).at({si<Length>(s)}).M_y.value();
    worst = std::max(worst, std::abs(line - exact) / largest);
  }
  CHECK(worst > 0.0);
  CHECK(worst <= samples.error.moment);
  CHECK(samples.error.moment < 5e-5);
}

TEST_CASE("given loads: what cannot be carried over is named") {
  CHECK(obstacles_to_given_loads(test::rig()).empty());
  const std::vector<std::string> detailed = obstacles_to_given_loads(
      read_project(test::project_file("sections/sledge-rig/rig-detailed.toml")));
  const auto names = [&](const char* word) {
    return std::any_of(detailed.begin(), detailed.end(),
                       [&](const std::string& of) { return of.find(word) != std::string::npos; });
  };
  CHECK(names("pin"));
  CHECK(names("rod"));
}

}  // namespace load_samples_test
