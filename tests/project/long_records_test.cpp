// Records of more instants than are looked at one by one: what is kept of them, and their limit.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace long_records_test {

using namespace boxbeam;

namespace {

constexpr std::size_t instants = 300'005;

const std::string beam =
    "[case]\nname = \"long\"\nkind = \"loads\"\n"
    "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
    "flange = \"10 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
    "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n[material]\nsteel = \"S355\"\n"
    "[strength]\nrequired = 1.0\nshear_lag = false\n[balance]\nstation = \"0 m\"\n";

const std::string one = "[files.a]\npath = \"a.outb\"\n";
const std::string push =
    "[loads.push]\nstation = \"1 m\"\nfile = \"a\"\ncolumns = { F_z = \"Fz\" }\n";

std::int16_t integer(std::size_t i) {
  return static_cast<std::int16_t>(static_cast<int>(i * 7919 % 60001) - 30000);
}

/// OpenFAST's binary file of one channel: of integers times 1/2 N, or 1e9 N and a third of them.
void write_outb(const std::filesystem::path& path, bool doubles, double step,
                std::size_t rows = instants, bool filled = true) {
  std::ofstream to(path, std::ios::binary);
  const auto put = [&](auto number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    to.write(raw, sizeof raw);
  };
  put(static_cast<std::int16_t>(doubles ? 3 : 2));
  put(std::int32_t{1});
  put(static_cast<std::int32_t>(rows));
  put(0.0);
  put(step);
  if (!doubles) {
    put(2.0F);
    put(0.0F);
  }
  put(std::int32_t{0});
  to << "Time      Fz        (s)       (N)       ";
  for (std::size_t i = 0; i < rows && filled; ++i) {
    if (doubles)
      put(1e9 + integer(i) / 3.0);
    else
      put(integer(i));
  }
  to.close();
  if (!filled) std::filesystem::resize_file(path, std::filesystem::file_size(path) + 2 * rows);
}

std::string complaint(const std::string& path) {
  return test::complaints_of([&] { return read_project(path); });
}

const recorded::Channels& channels_of(const Project& project) {
  return *recorded_of(project).acting.channels;
}

}  // namespace

TEST_CASE("a long record keeps the values of its file and has few instants of its own",
          "[long records]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("case.toml", beam + one + push);
  const std::filesystem::path file = std::filesystem::path(path).parent_path() / "a.outb";
  for (const bool doubles : {false, true}) {
    write_outb(file, doubles, 0.01);
    const Project project = read_project(path);
    const recorded::Channels& channels = channels_of(project);
    REQUIRE(channels.record);
    REQUIRE(channels.record->instants() == instants);
    CHECK(channels.times.size() < 2000);
    CHECK(channels.times.front() == 0.0);
    CHECK(channels.times.back() == Approx(0.01 * (instants - 1)).epsilon(1e-12));
    // A float holds half a 16-bit integer; of doubles 2^-24 of the distance from the first.
    double worst = 0.0;
    for (std::size_t i = 0; i < instants; ++i) {
      const double exact = doubles ? 1e9 + integer(i) / 3.0 : 0.5 * integer(i);
      worst = std::max(worst, std::abs(channels.record->value(0, i) - exact));
    }
    CHECK(worst <= (doubles ? 20e3 * std::exp2(-24.0) + 1e9 * std::exp2(-52.0) : 0.0));
    const recorded::ChannelSource& source = recorded_of(project).sources.front();
    CHECK(source.low == Approx(doubles ? 1e6 - 10.0 : -15.0).epsilon(1e-9));
    CHECK(source.high == Approx(doubles ? 1e6 + 10.0 : 15.0).epsilon(1e-9));
  }
}

TEST_CASE("long records of unlike steps are put on all their instants", "[long records]") {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("case.toml", beam + one + "[files.b]\npath = \"b.csv\"\n" + push +
                                    "factor = 2.0\n[loads.other]\nstation = \"1 m\"\nfile = \"b\"\n"
                                    "columns = { F_z = \"wind\" }\nfactor = -0.5\n");
  const std::filesystem::path at = std::filesystem::path(path).parent_path();
  write_outb(at / "a.outb", false, 0.01);
  folder.write("b.csv", "time [s], wind [N]\n0, 0\n1000.005, 1000.005\n3000, -999.99\n");
  const Project project = read_project(path);
  const recorded::ChannelLoads& acting = recorded_of(project).acting;
  REQUIRE(acting.channels->record);
  const recorded::Record& record = *acting.channels->record;
  // The one of the file b in between, and all of a: b, which ends less than a step of its own
  // sooner, holds its last value.
  CHECK(record.instants() == 300'006);
  // What acts at the tip is the sum of both, each times its factor.
  for (const std::size_t i : {std::size_t{50}, std::size_t{100'001}, std::size_t{200'000}}) {
    double force = acting.constant.points[0].force.z() + acting.constant.points[1].force.z();
    for (std::size_t k = 0; k < 2; ++k) {
      for (const std::size_t p : {0, 1})
        force += record.value(k, i) * acting.units[k].points[p].force.z();
    }
    const double t = record.time_of(i);
    const double before = std::floor(t / 0.01 + 1e-6);
    const auto j = static_cast<std::size_t>(before);
    const double a = std::lerp(0.5 * integer(j), 0.5 * integer(j + 1), t / 0.01 - before);
    const double b = t <= 1000.005 ? t : 2000.01 - t;
    CHECK(force == Approx(2.0 * a - 0.5 * b).epsilon(1e-5));
  }
}

TEST_CASE("records that are too long are refused with the limit", "[long records]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("case.toml", beam + one + push);
  const std::filesystem::path file = std::filesystem::path(path).parent_path() / "a.outb";
  write_outb(file, false, 0.01, 20'000'001, false);
  const std::string said = complaint(path);
  INFO(said);
  CHECK(said.find("20000001 rows, 20000000 can be verified") != std::string::npos);
  write_outb(file, false, 0.01);
  const std::string moving = complaint(
      folder.write("moving.toml", beam + one + push +
                                      "[files.c]\npath = \"c.csv\"\n[motion]\nfile = \"c\"\n"
                                      "columns = { a_z = \"a\" }\n"));
  CHECK(moving.find("c.csv") != std::string::npos);  // there is none
  folder.write("c.csv", "time [s], a [m/s^2]\n0, 9.81\n3000, 9.81\n");
  const std::string refused = complaint(path.substr(0, path.rfind('/')) + "/moving.toml");
  INFO(refused);
  CHECK(refused.find("300000 can be verified of a beam that moves") != std::string::npos);
}

}  // namespace long_records_test
