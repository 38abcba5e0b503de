#include "boxbeam/project/case_source.hpp"

#include <fmt/format.h>

#include <functional>
#include <future>
#include <random>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/random_design.hpp"

namespace case_source_test {

using namespace boxbeam;

namespace {

/// Every digit of the results, or what is wrong.
std::string outcome_of(const std::function<std::vector<Project>()>& read) {
  return test::outcome_of([&] { return verify_beams(read()); });
}

using test::is_result;

/// Some numbers of the case by other ones.
std::vector<std::string> random_design(const std::vector<test::WrittenNumber>& numbers,
                                       std::mt19937& random) {
  std::vector<std::string> set;
  const std::size_t count = 1 + random() % 3;
  for (std::size_t k = 0; k < count; ++k)
    set.push_back(test::changed(numbers[random() % numbers.size()], random));
  return set;
}

constexpr const char* signals = "time [s], V [kN], M [kN m]\n0, 0, 0\n1, 60, -180\n2, 0, 0\n";

constexpr const char* cut_forces = R"(
[case]
name = "girder"
kind = "loads"
[sections.box]
kind = "box"
width = "200 mm"
height = "400 mm"
flange = "16 mm"
web = "12 mm"
[beam]
density = "7850 kg/m^3"
[[beam.segments]]
length = "3 m"
section = "box"
[files.forces]
path = "forces.csv"
[[cut_forces]]
station = "0 m"
columns = { V_z = "V", M_y = "M" }
[[cut_forces]]
station = "3 m"
[material]
steel = "S355"
[strength]
required = 1.5
[fatigue]
category = 71
loading = "spectrum"
cycles = 1e6
gamma_Mf = 1.35
required = 1.0
)";

}  // namespace

TEST_CASE("a case that has been read before is read as if it had not been") {
  for (const char* file :
       {"sections/sledge-rig/rig.toml", "sections/templates/loads.toml",
        "sections/templates/static.toml", "sections/scissor-lift/lift.toml",
        "sections/excavator-boom/measured.toml", "sections/landing-gear/gear.toml"}) {
    CAPTURE(file);
    const std::string path = test::project_file(file);
    const CaseSource source(path);
    const std::vector<test::WrittenNumber> numbers = test::numbers_in(path);
    REQUIRE(numbers.size() > 10);
    std::mt19937 random(22);
    int verified = 0;
    for (int i = 0; i < 10; ++i) {
      const std::vector<std::string> set = random_design(numbers, random);
      CAPTURE(set);
      const std::string outcome = outcome_of([&] { return source.read_beams(set); });
      if (is_result(outcome)) ++verified;
      CHECK(outcome == outcome_of([&] { return read_beams(path, set); }));
    }
    CHECK(verified > 3);
  }
}

TEST_CASE("what a case is made of is what its files held when it was read first") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("girder.toml", cut_forces);
  folder.write("forces.csv", signals);
  folder.write("other.csv", "time [s], V [kN], M [kN m]\n0, 0, 0\n1, 30, -90\n2, 0, 0\n");
  const std::string before = outcome_of([&] { return read_beams(path); });
  const std::vector<std::string> other{"files.forces.path=other.csv"};
  const std::string of_other = outcome_of([&] { return read_beams(path, other); });
  REQUIRE(is_result(before));
  REQUIRE(is_result(of_other));
  CHECK(before != of_other);

  const CaseSource source(path);
  CHECK(outcome_of([&] { return source.read_beams(); }) == before);
  CHECK(outcome_of([&] { return source.read_beams(other); }) == of_other);
  folder.write("girder.toml", "no case");
  folder.write("forces.csv", "no signals");
  folder.write("other.csv", "");
  CHECK(outcome_of([&] { return source.read_beams(); }) == before);
  CHECK(outcome_of([&] { return source.read_beams(other); }) == of_other);
}

TEST_CASE("units that a case gives to its files are part of what they hold") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("girder.toml", cut_forces);
  folder.write("forces.csv", "time [s], V, M\n0, 0, 0\n1, 60, -180\n2, 0, 0\n");
  const CaseSource source(path);
  const auto in_units = [](const char* force, const char* moment) {
    return std::vector<std::string>{fmt::format("files.forces.force_unit={}", force),
                                    fmt::format("files.forces.moment_unit={}", moment)};
  };
  for (const std::vector<std::string>& set :
       {in_units("1 kN", "1 kN m"), in_units("2 kN", "2 kN m"), in_units("1 kN", "1 kN m"),
        in_units("1 m", "1 kN m"), std::vector<std::string>{}}) {
    CHECK(outcome_of([&] { return source.read_beams(set); }) ==
          outcome_of([&] { return read_beams(path, set); }));
  }
}

TEST_CASE("a file that is missing is looked for again") {
  const test::TemporaryFolder folder;
  const CaseSource source(folder.write("girder.toml", cut_forces));
  CHECK_THROWS_AS(source.read_beams(), InputError);
  folder.write("forces.csv", signals);
  CHECK(source.read_beams().size() == 1);
}

TEST_CASE("several threads may read a case at once") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("girder.toml", cut_forces);
  folder.write("forces.csv", signals);
  const CaseSource source(path);
  const auto set_of = [](int i) {
    return std::vector<std::string>{fmt::format("sections.box.web={} mm", 10 + i)};
  };
  std::vector<std::future<std::string>> found;
  for (int i = 0; i < 8; ++i)
    found.push_back(std::async(std::launch::async, [&, i] {
      return outcome_of([&] { return source.read_beams(set_of(i)); });
    }));
  for (int i = 0; i < 8; ++i) {
    const std::string outcome = found[static_cast<std::size_t>(i)].get();
    CHECK(is_result(outcome));
    CHECK(outcome == outcome_of([&] { return read_beams(path, set_of(i)); }));
  }
}

}  // namespace case_source_test
