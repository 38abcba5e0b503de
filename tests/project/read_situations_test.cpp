#include <numbers>

#include "project/small_case.hpp"
#include "support/changed_rig.hpp"

namespace read_situations_test {

using namespace boxbeam;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// The small case with an arm that swings, without the cycles of [fatigue], and these situations.
std::string case_with(const std::string& situations, bool cycles_in_fatigue = false) {
  std::string text = small_case::bodies;
  const std::string cycles = "cycles = 1e6\n";
  if (!cycles_in_fatigue) text.erase(text.find(cycles), cycles.size());
  return text + small_case::pivot +
         "[drivers.swing]\nkind = \"harmonic\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\n"
         "mean = \"0 deg\"\namplitude = \"5 deg\"\nfrequency = \"1 Hz\"\n" +
         small_case::for_a_second + situations;
}

Project read(const std::string& situations) {
  return parse_project("small.toml", case_with(situations));
}

const HarmonicDriver& swing_in(const Project& project, std::size_t situation) {
  const planar::Mechanism& mechanism = planar_in(project, project.situations[situation]);
  const auto& driven = std::get<planar::Driven>(mechanism.joints.back().kind);
  return std::get<HarmonicDriver>(driven.driver);
}

void check_refused(const std::string& situations, const std::string& at, const std::string& message,
                   const std::string& hint) {
  test::check_refused(case_with(situations), at, message, hint);
}

const std::string run = "[[situations]]\nname = \"run\"\ncycles = 1e6\n";

}  // namespace

TEST_CASE("a case without situations has one without a name, with the cycles of [fatigue]") {
  const Project project = parse_project("small.toml", case_with("", true));
  REQUIRE(project.situations.size() == 1);
  const Situation& only = project.situations.front();
  CHECK(only.name.empty());
  CHECK(only.cycles == 1e6);
  CHECK(only.load_factor == 1.0);
  CHECK(only.between.empty());
  CHECK(&planar_in(project, only) == &planar_of(project));
}

TEST_CASE("situations: name, cycles, load factor and what differs, in the order of the file") {
  const Project project =
      read(run +
           "[[situations]]\nname = \"storm\"\ncycles = 20\nload_factor = 1.35\n"
           "set = { \"drivers.swing.frequency\" = \"2 Hz\", \"bodies.rod.mass\" = \"30 kg\" }\n"
           "[[situations]]\nname = \"start and stop\"\ncycles = 5000\nbetween = [\"storm\", "
           "\"run\"]\n");
  REQUIRE(project.situations.size() == 3);
  CHECK(project.situations[0].name == "run");
  CHECK(project.situations[0].cycles == 1e6);
  CHECK(project.situations[0].load_factor == 1.0);
  CHECK_FALSE(project.situations[0].changed);
  const Situation& storm = project.situations[1];
  CHECK(storm.cycles == 20.0);
  CHECK(storm.load_factor == 1.35);
  CHECK(storm.set ==
        std::vector<std::string>{"drivers.swing.frequency = 2 Hz", "bodies.rod.mass = 30 kg"});
  CHECK(swing_in(project, 0).omega == Approx(turn).epsilon(1e-14));
  CHECK(swing_in(project, 1).omega == Approx(2.0 * turn).epsilon(1e-14));
  CHECK(planar_in(project, storm).bodies[small_case::rod].mass == 30.0);
  CHECK(planar_of(project).bodies[small_case::rod].mass == 10.0);
  // The beam is where and what it was.
  CHECK(planar_in(project, storm).bodies[small_case::arm].mass ==
        planar_of(project).bodies[small_case::arm].mass);
  CHECK(project.situations[2].between == std::vector<std::size_t>{1, 0});
  CHECK(most_cycles_of(project) == 1e6);
}

TEST_CASE("a situation without cycles counts for the strength only") {
  const Project project =
      read(run +
           "[[situations]]\nname = \"crash\"\nset = { drivers = { swing = { amplitude = "
           "\"9 deg\" } } }\n");
  CHECK(project.situations[1].cycles == 0.0);
  CHECK(swing_in(project, 1).amplitude == Approx(9.0 * turn / 360.0).epsilon(1e-14));
}

TEST_CASE("a situation may have a force of its own") {
  const Project project =
      read(run +
           "[[situations]]\nname = \"pushed\"\n[situations.set.forces.push]\nkind = \"force\"\n"
           "point = \"arm.B\"\ndirection = \"90 deg\"\nsize = \"1 kN\"\n");
  CHECK(planar_in(project, project.situations[0]).forces.empty());
  REQUIRE(planar_in(project, project.situations[1]).forces.size() == 1);
  CHECK(planar_in(project, project.situations[1]).forces.front().name == "push");
}

TEST_CASE("what differs may stand in quoted keys, dotted keys or tables: the same") {
  const std::string head = run + "[[situations]]\nname = \"fast\"\n";
  for (const std::string& set :
       {std::string("set = { \"drivers.swing.frequency\" = \"3 Hz\" }\n"),
        std::string("set.drivers.swing.frequency = \"3 Hz\"\n"),
        std::string("set = { drivers.swing = { frequency = \"3 Hz\" } }\n"),
        std::string("[situations.set]\n\"drivers.swing.frequency\" = \"3 Hz\"\n"),
        std::string("[situations.set.drivers.swing]\nfrequency = \"3 Hz\"\n")}) {
    INFO(set);
    const Project project = read(head + set);
    CHECK(swing_in(project, 1).omega == Approx(3.0 * turn).epsilon(1e-14));
    CHECK(project.situations[1].set == std::vector<std::string>{"drivers.swing.frequency = 3 Hz"});
  }
}

TEST_CASE("a change that cannot be is refused at its key") {
  const auto set = [](const std::string& line) {
    return "[[situations]]\nname = \"run\"\ncycles = 1\n[situations.set]\n" + line + "\n";
  };
  const auto refused = [&](const std::string& line, const std::string& message,
                           const std::string& hint) {
    INFO(line);
    check_refused(set(line), line, message, hint);
  };
  refused("frequency = \"2 Hz\"", "a situation cannot change \"frequency\"", "with the full key");
  refused("\"material.steel\" = \"S235\"", "a situation cannot change \"material.steel\"",
          "one of mechanism, bodies, joints, drivers, forces, loops, motion");
  refused("\"fatigue.category\" = 36", "a situation cannot change \"fatigue.category\"",
          "how the mechanism runs");
  refused("\"bodies.arm.points.B\" = [\"2 m\", \"0 m\"]",
          "a situation cannot change the beam itself", "a case of its own");
  refused("\"drivers.swng.frequency\" = \"2 Hz\"",
          "the case has no [drivers.swng] that could change", "swing");
  refused("\"drivers.swing.frequnecy\" = \"2 Hz\"", "frequnecy", "frequency");
  // A value of the wrong kind is refused where it stands.
  refused("\"drivers.swing.frequency\" = \"2 m\"", "\"2 m\" is a length", "0.7 Hz");
}

TEST_CASE("situations that cannot be are refused at their place") {
  check_refused(run + "[[situations]]\nname = \"run\"# twice\ncycles = 2\n", "# twice",
                "there is already a situation \"run\"", "a name of its own");
  check_refused(run + "[[situations]]\nname = \"stop\"\ncycles = 5\nbetween = [\"run\", \"rnu\"]\n",
                "between", "no situation above is \"rnu\"", "run");
  check_refused(run + "[[situations]]\nname = \"stop\"\nbetween = [\"run\"]\n", "between",
                "this one never happens", "cycles = 5000");
  check_refused(
      run + "[[situations]]\nname = \"stop\"\ncycles = 5\nload_factor = 1.2\nbetween = [\"run\"]\n",
      "between", "no loads of its own", "in the situations that it is made of");
  // A change between changes is none.
  const std::string change = "[[situations]]\nname = \"stop\"\ncycles = 5\nbetween = [\"run\"]\n";
  check_refused(run + change +
                    "[[situations]]\nname = \"again\"\ncycles = 5\nbetween = [\"stop\"] "
                    "# of a change\n",
                "# of a change", "no situation above is \"stop\"", "run");
  check_refused("[[situations]]\nname = \"run\"\n[[situations]]\nname = \"other\"\n",
                "[[situations]]\nname = \"run\"", "no situation ever happens",
                "its repetitions in the wanted life");
  check_refused(run + "load_fcator = 1.2\n", "load_fcator", "load_fcator", "load_factor");
}

TEST_CASE("cycles stand in [fatigue] or in the situations, not in both") {
  test::check_refused(case_with(run, true), "cycles = 1e6\nloading",
                      "the cycles of a case with situations belong to each of them",
                      "move \"cycles\" to [[situations]]");
}

TEST_CASE("the published chain knows one situation only") {
  test::check_refused(
      test::rig_text(
          {{"cycles = 1e8\n", ""}, {"dynamics = \"rigorous\"", "dynamics = \"newton-chain\""}},
          "\n" + run + "[[situations]]\nname = \"other\"\ncycles = 1\n"),
      "[[situations]]\nname = \"run\"", "knows one situation only", "use rigorous dynamics");
}

TEST_CASE("levels of a change: shares up to the whole, cycles of each, repetitions of all") {
  const std::string two =
      run + "[[situations]]\nname = \"rest\"\n[[situations]]\nname = \"change\"\n";
  const std::string change = two + "between = [\"rest\", \"run\"]\n";
  const Project project = read(change +
                               "cycles = 10\nspectrum = [{ share = 1.0, cycles = 500 }, { share = "
                               "0.25, cycles = 0.5 }]\n");
  const Situation& of = project.situations.back();
  REQUIRE(of.spectrum.size() == 2);
  CHECK(of.spectrum[0].share == 1.0);
  CHECK(of.spectrum[0].cycles == 5000.0);
  CHECK(of.spectrum[1].share == 0.25);
  CHECK(of.spectrum[1].cycles == 5.0);
  CHECK(of.cycles == 5005.0);
  check_refused(change + "spectrum = [{ share = 1.2, cycles = 500 }]\n", "spectrum = [",
                "1.2 of the change is more than the whole",
                "let the situations be the largest change, which strength knows, and write shares "
                "of that");
  check_refused(change + "spectrum = [{ share = 0.8, cycles = 5 }, { share = 0.4, cycles = 9 }]\n",
                "[{ share = 0.8", "the largest share is 0.8",
                "let the situations be the largest change and divide the shares by 0.8, so that it "
                "has the share 1");
  check_refused(change + "spectrum = []\n", "spectrum = [", "the spectrum has no level",
                "write for example spectrum = [{ share = 1.0, cycles = 5000 }]");
  check_refused(two +
                    "sequence = [\"rest\", \"run\"]\ncycles = 3\nspectrum = [{ share = 1.0, "
                    "cycles = 500 }]\n",
                "spectrum = [", "a sequence of situations is counted, it has no levels",
                "write the levels in a change: between = [...]");
  check_refused(run + "spectrum = [{ share = 1.0, cycles = 500 }]\n", "spectrum = [",
                "only a change between situations has levels",
                "write a situation for it: between = [\"empty\", \"lifting\"]");
}

}  // namespace read_situations_test
