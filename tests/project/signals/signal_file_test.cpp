#include "boxbeam/project/signal_file.hpp"

#include <cmath>
#include <cstring>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "project/signals/written_table.hpp"
#include "support/program.hpp"

namespace signal_file_test {

using namespace boxbeam;

namespace {

std::string sample(const std::string& name) {
  return test::project_file("tests/project/signals/samples/" + name);
}

/// The signals of the samples, as make_samples.py has them: SI, in the order of `sample_wanted`.
constexpr int sample_rows = 100;
double sample_time(int i) { return 0.01 * i; }
double sample_value(std::size_t signal, double t) {
  constexpr double turn = 2.0 * std::numbers::pi;
  switch (signal) {
    case 0: return 1e3 * (944.1 + 250.0 * std::sin(turn * 1.3 * t));
    case 1: return 1e3 * (-35.0 + 12.0 * std::cos(turn * 0.7 * t));
    default: return 1.5 + 0.25 * std::sin(turn * 0.4 * t);
  }
}

/// The difference between the largest and the smallest value of a signal, and the largest size.
struct Extent {
  double range = 0.0;
  double size = 0.0;
};
Extent extent_of(std::size_t signal) {
  double low = 1e300, high = -1e300;
  for (int i = 0; i < sample_rows; ++i) {
    low = std::min(low, sample_value(signal, sample_time(i)));
    high = std::max(high, sample_value(signal, sample_time(i)));
  }
  return {high - low, std::max(std::abs(low), std::abs(high))};
}

std::vector<WantedSignal> sample_wanted(const std::vector<std::string>& names) {
  return {{names[0], wanted::moment}, {names[1], wanted::force}, {names[2], wanted::length}};
}

/// Compares with the signals; `share` and `of_size` of range and size may be missing.
void check_sample(const SignalTable& table, double share, double of_size, double of_time = 1e-12) {
  REQUIRE(table.columns.size() == 3);
  REQUIRE(table.time.count == sample_rows);
  for (std::size_t k = 0; k < 3; ++k) {
    INFO(table.names[k]);
    REQUIRE(table.columns[k].size() == sample_rows);
    const Extent extent = extent_of(k);
    const double allowed = share * extent.range + of_size * extent.size;
    for (int i = 0; i < sample_rows; ++i) {
      const auto row = static_cast<std::size_t>(i);
      INFO("row " << i);
      CHECK(std::abs(table.time[row] - sample_time(i)) <= of_time);
      CHECK(std::abs(table.columns[k][row] - sample_value(k, sample_time(i))) <= allowed);
    }
  }
}

SignalTable read_text(const std::string& text, const std::vector<WantedSignal>& wanted = {},
                      const std::string& name = "signals.csv") {
  const test::TemporaryFolder folder;
  return read_signal_file({folder.write(name, text)}, wanted);
}

const std::vector<std::string> plain_names{"RootMyc1", "RootFxc1", "TipDxc1"};

}  // namespace

TEST_CASE("OpenFAST's binary files hold the signals to a step of their integers") {
  // weio cuts integers off, make_samples.py rounds them; scale and offset are single precision.
  for (const auto& [name, steps] : {std::pair("openfast-id1.outb", 0.52),
                                    {"openfast-id2.outb", 1.02},
                                    {"openfast-id4.outb", 1.02}}) {
    INFO(name);
    const SignalTable table = read_signal_file({sample(name)}, sample_wanted(plain_names));
    CHECK(table.format == "OpenFAST binary");
    CHECK(table.units == std::vector<std::string>{"kN-m", "kN", "m"});
    check_sample(table, steps / 65535.0, 2e-7);
    CHECK(table.columns[0].is_single());
  }
  // Times as integers of microseconds are kept one by one, equal steps as such.
  CHECK(read_signal_file({sample("openfast-id1.outb")}).time.instants.size() == sample_rows);
  CHECK(read_signal_file({sample("openfast-id2.outb")}).time.instants.empty());
}

TEST_CASE("OpenFAST's binary files of id 3 hold the signals as they are") {
  const SignalTable table =
      read_signal_file({sample("openfast-id3.outb")}, sample_wanted(plain_names));
  check_sample(table, 0.0, 4e-15);
  CHECK_FALSE(table.columns[0].is_single());
}

TEST_CASE("OpenFAST's text files hold the signals to their digits, whoever wrote them") {
  const std::string text = test::read_file(sample("openfast.out"));
  const auto check = [&](const std::string& changed) {
    const SignalTable table = read_text(changed, sample_wanted(plain_names), "run.out");
    CHECK(table.format == "OpenFAST text");
    check_sample(table, 0.0, 6e-6);
  };
  check(text);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    for (std::size_t at = changed.find(from); at != std::string::npos;
         at = changed.find(from, at + to.size())) {
      changed.replace(at, from.size(), to);
    }
    return changed;
  };
  check(replaced("\n", "\r\n"));
  check(replaced("\t", "  "));
  check(replaced("(s)", "(sec)"));
  check(replaced("(kN-m)", "(kN\xB7m)"));      // Latin-1
  check(replaced("(kN-m)", "(kN\xC2\xB7m)"));  // UTF-8
  check(text + "\n\nThis simulation ended normally.\nTotal time 3 s\n");
  for (const auto encoding :
       {test::Writing::Encoding::utf16_little, test::Writing::Encoding::utf16_big,
        test::Writing::Encoding::utf16_unmarked}) {
    check(test::encoded(text, encoding));
  }
}

TEST_CASE("RPC III files hold the signals to a step of their integers, or to single precision") {
  const std::vector<WantedSignal> wanted = sample_wanted(plain_names);
  const SignalTable integers = read_signal_file({sample("rpc-integers.rsp")}, wanted);
  CHECK(integers.format == "RPC III");
  CHECK(integers.columns[0].is_single());
  check_sample(integers, 0.0, 0.51 / 32752.0);
  check_sample(read_signal_file({sample("rpc-floats.rsp")}, wanted), 0.0, 1.3e-7);
  // Big-endian, groups of two frames, the last half filled.
  check_sample(read_signal_file({sample("rpc-big-endian.rsp")}, wanted), 0.0, 0.52 / 32752.0);
}

TEST_CASE("an Exudyn sensor file holds the force of a mass on a spring") {
  const SignalHead head = list_signals({sample("exudyn-force.txt")});
  CHECK(name_of(head.format) == "Exudyn sensor");
  REQUIRE(head.channels.size() == 3);
  CHECK(head.channels[0].name == "Force.x");
  CHECK(head.channels[0].unit.empty());
  const SignalTable table =
      read_signal_file({sample("exudyn-force.txt")}, {{"Force.x", wanted::force, 1.0}});
  REQUIRE(table.time.count == 21);
  for (std::size_t i = 0; i < table.time.count; ++i) {
    CHECK(table.time[i] == Approx(0.02 * static_cast<double>(i)).margin(1e-12));
    // F = k v0/omega sin(omega t); the integration has 4000 steps.
    CHECK(table.columns[0][i] == Approx(20.0 * std::sin(10.0 * table.time[i])).margin(1e-4));
  }
}

TEST_CASE("MBDyn's files take their time from the .out file, or a step that is given") {
  const auto scaled = [](const std::vector<std::string>& names) {
    std::vector<WantedSignal> wanted = sample_wanted(names);
    wanted[0].scale = wanted[1].scale = 1e3;  // the samples are in kN
    wanted[2].scale = 1.0;
    return wanted;
  };
  const auto joints = scaled({"2.local.My", "2.local.Fx", "3.local.Fx"});
  check_sample(read_signal_file({sample("mbdyn.jnt")}, joints), 0.0, 1e-14);
  check_sample(read_signal_file({sample("mbdyn.jnt"), {}, 0.01}, joints), 0.0, 1e-14);
  CHECK(list_signals({sample("mbdyn.jnt")}).channels.back().name == "3.c16");
  const test::TemporaryFolder alone;
  const std::string joints_alone = alone.write("a.jnt", test::read_file(sample("mbdyn.jnt")));
  CHECK(list_signals({joints_alone}).channels.size() == 12 + 15);  // without a time

  const SignalTable beam =
      read_signal_file({sample("mbdyn.act")}, {{"7.I.Fx", wanted::force, 1e3},
                                               {"7.II.Fx", wanted::force, 1e3},
                                               {"7.I.My", wanted::moment, 1e3}});
  const SignalTable force =
      read_signal_file({sample("mbdyn.frc")},
                       {{"5@1002.Fx", wanted::force, 1e3}, {"5@1002.My", wanted::moment, 1e3}});
  for (std::size_t i = 0; i < sample_rows; ++i) {
    const double t = sample_time(static_cast<int>(i));
    CHECK(beam.columns[0][i] == Approx(sample_value(1, t)).epsilon(1e-14));
    CHECK(beam.columns[1][i] == Approx(2.0 * sample_value(1, t)).epsilon(1e-14));
    CHECK(beam.columns[2][i] == Approx(sample_value(0, t)).epsilon(1e-14));
    CHECK(force.columns[0][i] == Approx(sample_value(1, t)).epsilon(1e-14));
    CHECK(force.columns[1][i] == Approx(sample_value(0, t)).epsilon(1e-14));
  }
}

TEST_CASE("NetCDF files of MBDyn, classic and NetCDF-4") {
  for (const char* name : {"mbdyn.nc", "mbdyn-classic.nc"}) {
    INFO(name);
    const SignalHead head = list_signals({sample(name)});
    CHECK(head.format == SignalFormat::netcdf);
    CHECK(head.rows == sample_rows);
    // Two numbers and five vectors over the time; no matrices, no tables without time.
    CHECK(head.channels.size() == 2 + 5 * 3);
    CHECK(head.channels.front().name == "run.step");
    CHECK(head.channels.back().name == "node.struct.1002.X.z");
    for (const char* element : {"elem.joint.2.m.y", "elem.beam.7.M_I.y"}) {
      const std::string moment = element;
      std::string force = moment;
      force.replace(force.find(moment[5] == 'j' ? ".m.y" : ".M_I.y"), std::string::npos,
                    moment[5] == 'j' ? ".f.x" : ".F_I.x");
      check_sample(
          read_signal_file({sample(name)}, sample_wanted({moment, force, "node.struct.1002.X.x"})),
          0.0, 1e-14);
    }
    // All channels at once are the same numbers.
    const SignalTable all = read_signal_file({sample(name)}, {});
    REQUIRE(all.columns.size() == head.channels.size());
    CHECK(all.columns[2][3] == Approx(sample_value(1, sample_time(3))).epsilon(1e-14));
    CHECK(all.columns[3][3] == Approx(sample_time(3)).epsilon(1e-14));
  }
}

TEST_CASE("requests of Adams and RecurDyn, as a table and step by step") {
  std::vector<WantedSignal> wanted = sample_wanted({"FY", "FX", "FZ"});
  wanted[0].scale = wanted[1].scale = 1e3;
  wanted[2].scale = 1.0;
  // With the head of a page in between.
  check_sample(read_signal_file({sample("request.tab")}, wanted), 0.0, 6e-7);
  wanted[0].name = "4711.TY";
  wanted[1].name = "4711.FX";
  wanted[2].name = "4712.1";
  check_sample(read_signal_file({sample("request.req")}, wanted), 0.0, 6e-7);
}

TEST_CASE("a table keeps the steps of integers that are far from zero") {
  // The first channel at 1000 km, of steps of 1 mm: value = (integer - offset)/scale [m], scale
  // 1000 and offset -1e9, both floats. Single precision at 1e6 m has steps of 62.5 mm.
  std::string bytes = test::read_file(sample("openfast-id2.outb"));
  const auto put = [&](std::size_t at, float number) {
    std::memcpy(bytes.data() + at, &number, sizeof number);
  };
  put(26, 1000.0F);
  put(38, -1e9F);
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.outb", bytes);
  const SignalTable far = read_signal_file({path});
  CHECK_FALSE(far.columns[0].is_single());
  CHECK(far.columns[1].is_single());
  const std::size_t rows_at = bytes.size() - std::size_t{100} * 3 * 2;
  std::int16_t first = 0, second = 0;
  std::memcpy(&first, bytes.data() + rows_at, 2);
  std::memcpy(&second, bytes.data() + rows_at + 6, 2);
  CHECK(far.columns[0][1] - far.columns[0][0] == Approx(1e-3 * (second - first)).epsilon(1e-6));
}

TEST_CASE("channels are found by name, each trouble with the channel that it belongs to") {
  const test::TemporaryFolder folder;
  const SignalHead head = list_signals(
      {folder.write("a.csv",
                    "time [s],RootMyc1 [kN-m],RootFxc1 [kN],load,odd [kip],twice [N],twice [N]\n"
                    "0,1,2,3,4,5,6\n")});
  CHECK(head.channels.size() == 6);
  CHECK(head.names_line == 1);
  CHECK(head.names_text.starts_with("time [s],RootMyc1"));
  const ChosenSignals good = choose_signals(head, {{"odd", wanted::force, 4448.0},
                                                   {"RootMyc1", wanted::moment},
                                                   {"load", wanted::force, 2.0},
                                                   {"load"}});
  CHECK(good.troubles.empty());
  CHECK(good.columns == std::vector<std::size_t>{3, 0, 2, 2});
  CHECK(good.factors == std::vector<double>{4448.0, 1e3, 2.0, 1.0});

  const ChosenSignals bad = choose_signals(head, {{"RootFxc1", wanted::force},
                                                  {"RootMyc2", wanted::moment},
                                                  {"RootMyc1", wanted::force},
                                                  {"load", wanted::force},
                                                  {"odd", wanted::force},
                                                  {"twice", wanted::force},
                                                  {"RootFxc1", wanted::force, 2.0},
                                                  {"entirely different", wanted::force}});
  REQUIRE(bad.troubles.size() == 7);
  const auto check = [&](std::size_t i, const char* message, const char* hint) {
    INFO(bad.troubles[i].message << " / " << bad.troubles[i].hint);
    CHECK(bad.troubles[i].wanted == i + 1);
    CHECK(bad.troubles[i].message.find(message) != std::string::npos);
    CHECK(bad.troubles[i].hint.find(hint) != std::string::npos);
  };
  check(0, "the file has no channel \"RootMyc2\"", "did you mean \"RootMyc1\"?");
  check(1, "is to be a force, but its unit \"kN-m\" is that of a moment", "choose a channel");
  check(2, "the file gives no unit for \"load\"", "say what one of it is");
  check(3, "\"kip\" is not a unit known here", "say what one of it is");
  check(4, "\"twice\" is the name of 2 channels, 5 and 6", "names of their own");
  check(5, "the file gives the unit of \"RootFxc1\", \"kN\"", "take the unit");
  check(6, "the file has no channel \"entirely different\"", "it has \"RootMyc1\", \"RootFxc1\"");
}

TEST_CASE("a stream of blocks is the table, and no block is long") {
  std::string text = "time [s];F [kN];M [N m]\n";
  const std::size_t rows = 30000;
  for (std::size_t i = 0; i < rows; ++i) {
    text += fmt::format("{};{};{}\n", i, (i * 7919) % 1009, -0.5 * static_cast<double>(i));
  }
  const test::TemporaryFolder folder;
  const std::string path = folder.write("long.csv", text);
  const std::vector<WantedSignal> wanted{{"M", wanted::moment}, {"F", wanted::force}};
  std::size_t seen = 0;
  std::size_t wrong = 0;
  const SignalSummary summary = read_signals({path}, wanted, [&](const SignalRows& part) {
    REQUIRE(part.values.size() == 2);
    CHECK(part.time.size() <= 16384);
    for (std::size_t i = 0; i < part.time.size(); ++i, ++seen) {
      wrong += part.time[i] != static_cast<double>(seen);
      wrong += part.values[0][i] != -0.5 * static_cast<double>(seen);
      wrong += part.values[1][i] != 1e3 * static_cast<double>((seen * 7919) % 1009);
    }
  });
  CHECK(wrong == 0);
  CHECK(seen == rows);
  CHECK(summary.rows == rows);
  CHECK(summary.first_time == 0.0);
  CHECK(summary.last_time == 29999.0);
  const SignalTable table = read_signal_file({path}, wanted);
  CHECK(table.columns[0].size() == rows);
  CHECK(table.columns[0][29999] == -14999.5);
}

TEST_CASE("a format that is asked for is taken, whatever the name of the file") {
  const test::TemporaryFolder folder;
  const std::string table = test::read_file(sample("request.tab"));
  CHECK(list_signals({folder.write("a.dat", table), SignalFormat::request_table}).channels.size() ==
        4);
  const std::string joints = folder.write("joints.txt", test::read_file(sample("mbdyn.jnt")));
  const SignalHead head = list_signals({joints, SignalFormat::mbdyn, 0.01});
  CHECK(head.channels.front().name == "2.c2");
  for (const SignalFormat format : all_signal_formats) {
    CHECK_FALSE(word_of(format).empty());
    CHECK_FALSE(name_of(format).empty());
  }
}

}  // namespace signal_file_test
