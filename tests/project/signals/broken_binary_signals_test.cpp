#include <cstring>
#include <limits>

#include "project/signals/broken_signals.hpp"

namespace broken_binary_signals_test {

using namespace boxbeam;

namespace {

std::string sample_bytes(const std::string& name) {
  return test::read_file(test::project_file("tests/project/signals/samples/" + name));
}

/// A number written over bytes of a file, as this machine and the files have it: little-endian.
template <class Number>
std::string patched(std::string bytes, std::size_t at, Number number) {
  REQUIRE(at + sizeof number <= bytes.size());
  std::memcpy(bytes.data() + at, &number, sizeof number);
  return bytes;
}

/// A record of an RPC III head with another value; without one where `value` is empty.
std::string with_record(std::string bytes, const std::string& key, const std::string& value) {
  const std::string field = key + std::string(32 - key.size(), '\0');
  const std::size_t at = bytes.find(field);
  REQUIRE(at != std::string::npos);
  if (value.empty()) {
    bytes.replace(at, 1, "_");
    return bytes;
  }
  return bytes.replace(at + 32, 96, value + std::string(96 - value.size(), '\0'));
}

struct Broken {
  std::string bytes;
  const char* message;
  std::vector<WantedSignal> wanted = {};
};

void check_broken_bytes(const std::string& name, const std::vector<Broken>& rows) {
  const test::TemporaryFolder folder;
  for (const Broken& row : rows) {
    INFO("expected: " << row.message);
    const std::string path = folder.write(name, row.bytes);
    const Problem problem = test::signal_problem_of({path}, row.wanted);
    INFO(problem.message << " / " << problem.hint);
    CHECK(problem.file == path);
    CHECK(problem.line == 0);
    CHECK(test::has_part(problem.message, row.message));
    CHECK_FALSE(problem.hint.empty());
  }
}

}  // namespace

TEST_CASE("what is wrong in OpenFAST's binary files is named with its byte", "[bad_input]") {
  // Places in the head of ids 1 and 2: id 0, channels 2, instants 6, time 10 and 18, scales 26,
  // offsets 38, length of the description 50, the description of 17 bytes, names 71, units 111;
  // 151.
  const std::string one = sample_bytes("openfast-id1.outb");
  const std::string two = sample_bytes("openfast-id2.outb");
  const std::string three = sample_bytes("openfast-id3.outb");  // rows of doubles behind 127
  const std::string four = sample_bytes("openfast-id4.outb");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_broken_bytes(
      "a.outb",
      {
          {"", "the file is empty"},
          {two.substr(0, 1), "byte 0: the file ends before its id"},
          {patched<std::int16_t>(two, 0, 7), "byte 0: the id is 7, it can be 1 to 4"},
          {"Time\tA\n", "byte 0: the id is 26964"},
          {two.substr(0, 8), "byte 6: the file ends before the number of instants"},
          {two.substr(0, 20), "byte 18: the file ends before the time"},
          {two.substr(0, 30), "byte 26: the file ends before the scales of the channels"},
          {two.substr(0, 60), "byte 54: the file ends before the end of its description"},
          {two.substr(0, 100), "byte 71: the file ends before the names and units"},
          {two.substr(0, two.size() - 1),
           "100 instants of 3 channels want 751 bytes, the file has 750"},
          {two + "x", "byte 751: 100 instants of 3 channels want 751 bytes, the file has 752"},
          {patched<std::int32_t>(two, 2, 0), "byte 2: the number of channels is 0"},
          {patched<std::int32_t>(two, 2, -3), "byte 2: the number of channels is -3"},
          {patched<std::int32_t>(two, 2, 2'000'000'000), "the number of channels is 2000000000"},
          {patched<std::int32_t>(two, 2, 99'000), "ends before the scales"},
          {patched<std::int32_t>(two, 6, 0), "byte 6: the number of instants is 0"},
          {patched<std::int32_t>(two, 6, -1), "byte 6: the number of instants is -1"},
          // 2^31 - 1 instants: no memory is taken for them.
          {patched<std::int32_t>(two, 6, 2147483647),
           "2147483647 instants of 3 channels want 12884902033 bytes"},
          {patched<double>(two, 18, 0.0), "byte 10: the time begins at 0 s and has steps of 0 s"},
          {patched<double>(two, 18, -0.1), "has steps of -0.1 s"},
          {patched<double>(two, 10, nan), "the time begins at nan s"},
          {patched<double>(two, 10, 1e18), "the time 1e+18 s does not come after 1e+18 s"},
          {patched<float>(two, 26, 0.0F), "byte 26: \"RootMyc1\" has the scale 0"},
          {patched<float>(two, 30, static_cast<float>(nan)),
           "byte 30: \"RootFxc1\" has the scale nan"},
          {patched<std::int32_t>(two, 50, -1), "byte 50: a description of -1 characters"},
          {patched<std::int32_t>(two, 50, 2147483647), "ends before the end of its description"},
          {patched<char>(two, 112, 'k'), "byte 111: the unit of the time is \"k\""},
          {patched<double>(one, 10, 0.0), "byte 10: the time has the scale 0"},
          {patched<std::int32_t>(one, 151 + 4 * 60, 0), "byte 391: instant 61: the time 0.0005 s"},
          {patched<std::int16_t>(four, 2, 0), "byte 2: names of 0 characters"},
          {patched<std::int16_t>(four, 2, 999), "ends before the names and units"},
          {patched<double>(three, 127 + 8 * (3 * 50 + 2), nan),
           "byte 1343: \"TipDxc1\" at instant 51: nan is not finite"},
          {patched<double>(three, 127 + 8 * (3 * 50 + 2), 1e30),
           "byte 1343: \"TipDxc1\" at instant 51: 1e+30 is not finite, or too large"},
          {two, "the file has no channel \"RootMyc2\"", {{"RootMyc2"}}},
          {two, "\"RootMyc1\" is to be a force", {{"RootMyc1", wanted::force}}},
          {two.substr(0, 81) + two.substr(81, 10) + two.substr(81, 10) + two.substr(101),
           "\"RootMyc1\" is the name of 2 channels, 1 and 2",
           {{"RootMyc1"}}},
          {patched<char>(two, 122, 'x'),
           "\"RootMyc1\": \"xN\" is not a unit known here",
           {{"RootMyc1", wanted::moment}}},
          {patched<char>(
               patched<char>(patched<char>(patched<char>(two, 122, ' '), 123, ' '), 124, ' '), 125,
               ' '),
           "the file gives no unit for \"RootMyc1\"",
           {{"RootMyc1", wanted::moment}}},
      });
}

TEST_CASE("what is not wanted of a binary file may be wrong", "[bad_input]") {
  const std::string two = patched<float>(sample_bytes("openfast-id2.outb"), 26, 0.0F);
  const test::TemporaryFolder folder;
  CHECK(read_signal_file({folder.write("a.outb", two)}, {{"TipDxc1"}}).time.count == 100);
}

TEST_CASE("what is wrong in RPC III files is named with its byte", "[bad_input]") {
  const std::string good = sample_bytes("rpc-integers.rsp");
  const std::string floats = sample_bytes("rpc-floats.rsp");
  const std::string big = sample_bytes("rpc-big-endian.rsp");
  const std::size_t data_of_floats = floats.size() - std::size_t{2} * 64 * 3 * 4;
  const float infinite = std::numeric_limits<float>::infinity();
  const auto with = [&](const char* key, const char* value) {
    return with_record(good, key, value);
  };
  check_broken_bytes(
      "a.rsp",
      {
          {"", "the file is empty"},
          {good.substr(0, 100), "byte 100: the file ends within its head"},
          {good.substr(0, 700), "the head is to have"},
          {good.substr(0, good.size() - 1),
           "2 groups of 64 points of 3 channels are due, the file "
           "ends in group 2"},
          {good.substr(0, good.size() - 400), "the file ends in group 1"},
          {"x" + good, "byte 0: the keyword FORMAT is due, here is \"xFORMAT\""},
          {good.substr(0, 128) + good.substr(256),
           "byte 128: the keyword NUM_HEADER_BLOCKS is due"},
          {with("FORMAT", "ASCII"),
           "byte 32: FORMAT is \"ASCII\", it can be BINARY_IEEE_LITTLE_END"},
          {with("NUM_HEADER_BLOCKS", "0"), "byte 160: NUM_HEADER_BLOCKS is 0, it can be 1 to 4096"},
          {with("NUM_HEADER_BLOCKS", "4000"), "the head is to have 2048000 bytes"},
          {with("NUM_HEADER_BLOCKS", "99999999999999999999"), "it can be 1 to 4096"},
          {with("NUM_PARAMS", "many"), "NUM_PARAMS is \"many\", no number"},
          {with("NUM_PARAMS", "999999"), "NUM_PARAMS is 999999, it can be 3 to"},
          {with("CHANNELS", ""), "the head has no CHANNELS"},
          {with("CHANNELS", "0"), "CHANNELS is 0, it can be 1 to"},
          {with("CHANNELS", "2.5"), "CHANNELS is 2.5, it can be 1 to"},
          {with("CHANNELS", "4"), "the head has no DESC.CHAN_4"},
          {with("DELTA_T", ""), "the head has no DELTA_T"},
          {with("DELTA_T", "0"), "the time step is 0 s"},
          {with("DELTA_T", "-1"), "the time step is -1 s"},
          {with("DELTA_T", "nan"), "DELTA_T is \"nan\", no number"},
          {with("PTS_PER_GROUP", "0"), "PTS_PER_GROUP is 0, it can be 1 to"},
          {with("PTS_PER_GROUP", "1e15"), "PTS_PER_GROUP is 1e15, it can be 1 to"},
          {with("PTS_PER_FRAME", "60"), "PTS_PER_GROUP is 64, no multiple of PTS_PER_FRAME, 60"},
          {with("FRAMES", "0"), "FRAMES is 0, it can be 1 to"},
          {with("FRAMES", "1e9"), "FRAMES is 1e9, it can be 1 to"},
          {with("SAMPLES", "129"), "SAMPLES is 129, it can be 1 to 128"},
          {with("HALF_FRAMES", "1"), "HALF_FRAMES is \"1\", it can be 0"},
          {with("FILE_TYPE", "SPECTRAL"), "FILE_TYPE is \"SPECTRAL\", it can be TIME_HISTORY"},
          {with("DATA_TYPE", "DOUBLE"), "DATA_TYPE is \"DOUBLE\", it can be SHORT_INTEGER"},
          {with("INT_FULL_SCALE", ""), "the head has no INT_FULL_SCALE"},
          {with("INT_FULL_SCALE", "40000"), "INT_FULL_SCALE is 40000, it can be 1 to 32768"},
          {with("SCALE.CHAN_2", "0"), "SCALE.CHAN_2 is 0"},
          {with("SCALE.CHAN_2", "x"), "SCALE.CHAN_2 is \"x\", no number"},
          {with("UNITS.CHAN_3", ""), "the head has no UNITS.CHAN_3"},
          {with_record(big, "FRAMES", "7"), "4 groups of 40 points of 3 channels are due"},
          {patched<float>(floats, data_of_floats + 4 * (64 + 5), infinite),
           "\"RootFxc1\" at point 6: inf is not finite"},
          {patched<float>(floats, data_of_floats + 4 * (3 * 64 + 2), 1e30F),
           "\"RootMyc1\" at point 67: 1e+30 is not finite, or too large"},
          {with("DESC.CHAN_2", "RootMyc1"),
           "\"RootMyc1\" is the name of 2 channels, 1 and 2",
           {{"RootMyc1"}}},
          {with("UNITS.CHAN_1", "kips"),
           "\"kips\" is not a unit known here",
           {{"RootMyc1", wanted::moment}}},
          {good, "the file has no channel \"Force\"", {{"Force"}}},
          {good, "\"TipDxc1\" is to be a force", {{"TipDxc1", wanted::force}}},
      });
  const test::TemporaryFolder folder;
  SignalSource stepped{folder.write("a.rsp", good), {}, 0.01};
  CHECK(test::has_part(test::signal_problem_of(stepped).message, "the file has its own time"));
  stepped.time_step = -1.0;
  CHECK_THROWS_AS(list_signals(stepped), InputError);
}

TEST_CASE("a time that was written with too few digits to ascend is found far down",
          "[bad_input]") {
  // The step is below the spacing of doubles near the start of the time: 2^-52 2^33 s = 1.9e-6 s.
  std::string bytes = sample_bytes("openfast-id3.outb");
  bytes = patched<double>(patched<double>(bytes, 10, 8589934592.0), 18, 4e-7);
  const test::TemporaryFolder folder;
  const Problem problem = test::signal_problem_of({folder.write("a.outb", bytes)});
  CHECK(test::has_part(problem.message, "instant 2: the time 8589934592 s does not come after"));
}

TEST_CASE("what is wrong in NetCDF files is said with its instant and channel", "[bad_input]") {
  // Classic, big-endian: number of instants at 4; of the variable "time" its name at 60, unit at
  // 100, type at 104; records of 212 bytes from 748 on: time 8, step 4, timestep 8, force of
  // joint 2.
  const std::string good = sample_bytes("mbdyn-classic.nc");
  const auto with = [&](std::size_t at, const std::string& bytes) {
    std::string broken = good;
    return broken.replace(at, bytes.size(), bytes);
  };
  using namespace std::string_literals;
  const auto record = [](std::size_t i) { return 748 + 212 * i; };
  const std::string not_a_number = "\x7f\xf8\0\0\0\0\0\0"s, endless = "\x7f\xf0\0\0\0\0\0\0"s;
  check_broken_bytes(
      "broken.nc",
      {{with(4, "\0\0\0\0"s), "the file holds no instant"},
       {with(60, "tame"), "the file has no variable \"time\""},
       {with(100, "N"), "the unit of \"time\" is \"N\""},
       {with(104, "\0\0\0\2"s), "\"time\" holds no numbers"},
       {with(record(1) + 20, not_a_number), "instant 2, \"elem.joint.2.f.x\""},
       {with(record(41) + 28, endless), "instant 42, \"elem.joint.2.f.y\""},
       {with(record(2), "\0\0\0\0\0\0\0\0"s), "instant 3, \"time\""},
       {with(record(7), not_a_number), "instant 8, \"time\""},
       {good.substr(0, record(60)), "truncated"},
       {good.substr(0, good.size() - 4), "truncated"},
       {good.substr(0, 300), "libnetcdf says"},
       {"CDF\1\0\0"s, "libnetcdf says"},
       {"\x89HDF\r\n\x1a\nrest"s, "libnetcdf says"},
       {sample_bytes("mbdyn.nc").substr(0, 30000), "libnetcdf says"},
       {good, "no channel \"elem.joint.2.g.x\"", {{"elem.joint.2.g.x", wanted::force}}},
       {good, "its unit \"N\" is that of", {{"elem.joint.2.f.x", wanted::moment}}}});
  const test::TemporaryFolder folder;
  SignalSource stepped{folder.write("a.nc", good)};
  stepped.time_step = 0.01;
  CHECK(test::has_part(test::signal_problem_of(stepped).message, "has its own time"));
  // By content, whatever its name; and what only begins alike is text.
  CHECK(list_signals({folder.write("a.csv", good)}).format == SignalFormat::netcdf);
  CHECK(list_signals({folder.write("b.csv", "CDF [s],b [N]\n0,1\n1,2\n")}).format ==
        SignalFormat::csv);
}

}  // namespace broken_binary_signals_test
