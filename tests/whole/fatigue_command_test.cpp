// boxbeam fatigue as a user runs it: a stress history and a detail, damage and life.

#include <fmt/format.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace fatigue_command_test {

using Json = nlohmann::ordered_json;

namespace {

/// A table of normal stress [MPa]: so many waves of each range from zero.
std::string waves(const std::vector<std::pair<int, int>>& range_and_number) {
  std::string text = "sigma [MPa]\n0\n";
  for (const auto& [range, number] : range_and_number) {
    for (int i = 0; i < number; ++i) text += std::to_string(range) + "\n0\n";
  }
  return text;
}

/// 1e5 of 90, 1e6 of 60 and 1e7 of 40 MPa are this block 1e5 times.
const std::string miner_block = waves({{90, 1}, {60, 10}, {40, 100}});

Json judged(const std::string& history, std::vector<std::string> more, int exit_code) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments{"fatigue", folder.write("history.csv", history), "--json",
                                     "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const test::ProgramResult result = test::run_program(arguments);
  INFO(result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(result.err.empty());
  return Json::parse(result.out);
}

void check_refused(const std::vector<std::string>& arguments, const std::string& said) {
  const test::ProgramResult result = test::run_program(arguments);
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(result.err.find(said) != std::string::npos);
}

bool holds(const Json& object, const std::string& key) { return object.contains(key); }

}  // namespace

TEST_CASE("fatigue: the documented keys, in SI units") {
  const Json document = judged(waves({{100, 2}}), {"--detail", "71"}, 0);
  CHECK(document["schema"] == "boxbeam.fatigue/1");
  for (const char* key : {"cycles", "damage", "equivalent_range", "life", "curve"}) {
    INFO(key);
    CHECK(holds(document, key));
  }
  REQUIRE(document["cycles"].size() == 1);
  const Json& cycle = document["cycles"][0];
  CHECK(cycle["range"].get<double>() == Approx(100e6).epsilon(1e-12));
  CHECK(cycle["mean"].get<double>() == Approx(50e6).epsilon(1e-12));
  CHECK(cycle["count"].get<double>() == 2.0);
  const double once = 2.0 / (2e6 * std::pow(0.71, 3));
  CHECK(document["damage"].get<double>() == Approx(once).epsilon(1e-12));
  CHECK(document["life"].get<double>() == Approx(1.0 / once).epsilon(1e-12));
  CHECK(document["equivalent_range"].get<double>() ==
        Approx(100e6 * std::cbrt(1e-6)).epsilon(1e-12));
  CHECK(document["curve"]["name"] == "71");
  CHECK(document["curve"]["reference"].get<double>() == 71e6);
}

TEST_CASE("fatigue: the published Miner sums 2.5 (category 56) and 0.33 (category 90)") {
  // To more digits from the equations of EN 1993-1-9, 7.1; a damage above 1 fails.
  const Json weak = judged(miner_block, {"--detail", "56", "--repetitions", "1e5"}, 1);
  CHECK(weak["damage"].get<double>() == Approx(2.535004).margin(1e-6));
  CHECK(weak["verdict"] == "fail");
  CHECK(weak["life"].get<double>() == Approx(1e5 / 2.535004).epsilon(1e-6));
  const Json strong = judged(miner_block, {"--detail", "90", "--repetitions", "1e5"}, 0);
  CHECK(strong["damage"].get<double>() == Approx(0.331002).margin(1e-6));
  CHECK(strong["verdict"] == "pass");
  const Json safe =
      judged(miner_block, {"--detail", "90", "--repetitions", "1e5", "--gamma-Mf", "1.35"}, 1);
  CHECK(safe["damage"].get<double>() == Approx(1.203694).margin(1e-6));
}

TEST_CASE("fatigue: every way of counting agrees on waves from zero") {
  for (const auto& counting :
       std::vector<std::vector<std::string>>{{"--count", "astm"},
                                             {"--count", "4-point"},
                                             {"--count", "4-point", "--residue", "repeated"},
                                             {"--count", "periodic"}}) {
    std::vector<std::string> options{"--detail", "56", "--repetitions", "1e5"};
    options.insert(options.end(), counting.begin(), counting.end());
    INFO(counting.back());
    CHECK(judged(miner_block, options, 1)["damage"].get<double>() == Approx(2.535004).margin(1e-6));
  }
}

TEST_CASE(
    "fatigue: a row of the tables, a curve of another code, constant amplitude, compression") {
  // 8.3/1 has category 112; DNV D: log N = 12.164 - 3 log S.
  const std::string one = waves({{100, 1}});
  CHECK(judged(one, {"--detail", "8.3/1"}, 0)["damage"].get<double>() ==
        Approx(1.0 / (2e6 * std::pow(1.12, 3))).epsilon(1e-12));
  CHECK(judged(one, {"--detail", "DNV-RP-C203 air:D"}, 0)["damage"].get<double>() ==
        Approx(std::pow(10.0, 6.0 - 12.164)).epsilon(1e-9));
  // Below the limit of category 100, 73.7 MPa.
  const std::string small = waves({{70, 3}});
  CHECK(judged(small, {"--detail", "100"}, 0)["damage"].get<double>() > 0.0);
  const Json constant = judged(small, {"--detail", "100", "--loading", "constant"}, 0);
  CHECK(constant["damage"].get<double>() == 0.0);
  CHECK(constant["life"].is_null());
  const Json relieved =
      judged("sigma [MPa]\n80\n-60\n80\n", {"--detail", "100", "--stress-relieved"}, 0);
  CHECK(relieved["cycles"][0]["range"].get<double>() == Approx(116e6).epsilon(1e-12));
}

TEST_CASE(
    "fatigue: the size effect of a row where the thickness is known, a remark where it is not") {
  // 8.3/5: category 90, (25/40)^0.2 on it at 40 mm; damage rises with the third power.
  const std::string one = waves({{100, 1}});
  const Json thick = judged(one, {"--detail", "8.3/5", "--thickness", "40 mm"}, 0);
  const double k_s = std::pow(25.0 / 40.0, 0.2);
  CHECK(thick["damage"].get<double>() ==
        Approx(1.0 / (2e6 * std::pow(0.9 * k_s, 3))).epsilon(1e-12));
  CHECK(thick["resistance"]["size_factor"].get<double>() == Approx(k_s).epsilon(1e-12));
  const Json unknown = judged(one, {"--detail", "8.3/5"}, 0);
  CHECK(unknown["damage"].get<double>() == Approx(1.0 / (2e6 * 0.729)).epsilon(1e-12));
  CHECK(unknown["resistance"]["not_applied"].get<std::string>().find("--thickness") !=
        std::string::npos);
}

TEST_CASE("fatigue: IIW allows half of the damage sum to ranges of many sizes, and it is said") {
  // FAT 90, above its knee: N S^3 = 2e6 90^3; once 100, 80 and 60 MPa.
  const std::string many = waves({{100, 1}, {80, 1}, {60, 1}});
  const double sum = (1e6 + 512e3 + 216e3) / (2e6 * 729e3);
  const auto at = [&](const std::string& history, double damage, double one, int exit_code) {
    return judged(history,
                  {"--detail", "IIW:FAT 90", "--thickness", "25 mm", "--repetitions",
                   fmt::format("{:.12g}", damage / one)},
                  exit_code);
  };
  const Json beyond = at(many, 0.51, sum, 1);
  CHECK(beyond["damage"].get<double>() == Approx(0.51).epsilon(1e-9));
  CHECK(beyond["damage_limit"].get<double>() == 0.5);
  CHECK(beyond["use"].get<double>() == Approx(1.02).epsilon(1e-9));
  CHECK(beyond["life"].get<double>() == Approx(0.5 / sum).epsilon(1e-9));
  at(many, 0.49, sum, 0);
  // One size is what the curves were measured with.
  CHECK(at(waves({{100, 3}}), 0.99, 3e6 / (2e6 * 729e3), 0)["damage_limit"].get<double>() == 1.0);
  // EN 1993-1-9, 8(2), allows the whole sum.
  CHECK(judged(many, {"--detail", "90"}, 0)["damage_limit"].get<double>() == 1.0);
}

TEST_CASE("fatigue: a recalled row is marked") {
  const Json document = judged(waves({{50, 1}}), {"--detail", "8.1/11"}, 0);
  CHECK(document["curve"]["unconfirmed"] == true);
}

TEST_CASE(
    "fatigue: a range above 1.5 f_y fails, and without f_y that it is not looked at is said") {
  // One range of 600 MPa damages 8.3e-3 of category 160 (2e6 (160/600)^3 = 37926 cycles), but is
  // above 1.5 x 355 = 532.5 MPa; S355 of 20 mm has 345 MPa by EN 10025-2.
  const std::string one = waves({{600, 1}});
  const Json free = judged(one, {"--detail", "160"}, 0);
  CHECK(free["resistance"]["range_limit"].is_null());
  CHECK(free["remarks"].dump().find("1.5 f_y") != std::string::npos);
  const Json limited = judged(one, {"--detail", "160", "--yield", "355 MPa"}, 1);
  CHECK(limited["verdict"] == "fail");
  CHECK(limited["resistance"]["range_limit"].get<double>() == Approx(532.5e6));
  const Json steel =
      judged(waves({{500, 1}}), {"--detail", "160", "--steel", "S355", "--thickness", "20 mm"}, 0);
  CHECK(steel["resistance"]["range_limit"].get<double>() == Approx(1.5 * 345e6));
}

TEST_CASE("fatigue: ranges that endure fewer than 1e4 cycles are named") {
  // Category 36 under 250 MPa: 2e6 (36/250)^3 = 5972 cycles.
  const Json document = judged(waves({{250, 1}}), {"--detail", "36"}, 0);
  CHECK(document["remarks"].dump().find("endures 5.97e+03 cycles") != std::string::npos);
  CHECK(document["remarks"].dump().find("fewer than the 1e4") != std::string::npos);
}

TEST_CASE("fatigue: the history from standard input, the result into a file") {
  const test::TemporaryFolder folder;
  const std::string history = folder.write("history.csv", miner_block);
  const std::string out = (folder.path() / "result.json").string();
  const std::string command = "'" + test::program() +
                              "' fatigue - --detail 56 --repetitions 1e5 --json '" + out + "' < '" +
                              history + "' > /dev/null";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  const Json document = Json::parse(test::read_file(out));
  CHECK(document["damage"].get<double>() == Approx(2.535004).margin(1e-6));
  CHECK(document["history"] == "-");
}

TEST_CASE("fatigue: the text says damage, life and the curve") {
  const test::TemporaryFolder folder;
  const test::ProgramResult result =
      test::run_program({"fatigue", folder.write("history.csv", miner_block), "--detail", "56",
                         "--repetitions", "1e5"});
  CHECK(result.exit_code == 1);
  CHECK(result.out.find("FAIL") == 0);
  CHECK(result.out.find("damage 2.535") != std::string::npos);
  CHECK(result.out.find("EN 1993-1-9") != std::string::npos);
}

TEST_CASE("fatigue: what is wrong is said, with exit code 2", "[bad_input]") {
  const test::TemporaryFolder folder;
  const std::string good = folder.write("good.csv", miner_block);
  const std::string bad = folder.write("bad.csv", "sigma [MPa]\n0\nnan\n5\n");
  check_refused({"fatigue", bad, "--detail", "56"}, bad + ":3:1: error: \"nan\" is not finite");
  check_refused({"fatigue", good, "--detail", "57"}, "no direct curve \"57\"");
  check_refused({"fatigue", good, "--detail", "8.3/99"}, "there is no row \"8.3/99\"");
  check_refused({"fatigue", good, "--detail", "DVN:C"}, "there are no curves \"DVN\"");
  check_refused({"fatigue", good, "--detail", "56", "--thickness", "20"}, "--thickness");
  check_refused({"fatigue", good, "--detail", "56", "--steel", "S355"}, "plate's thickness");
  check_refused({"fatigue", good, "--detail", "56", "--steel", "X1", "--thickness", "9 mm"},
                "there is no steel");
  check_refused({"fatigue", good}, "--detail");
  check_refused({"fatigue", good, "--detail", "56", "--repetitions", "0"}, "--repetitions");
  check_refused({"fatigue", "-", "--detail", "56"}, "empty");
  const std::string shear = folder.write("shear.csv", "sigma [MPa], tau [MPa]\n0, 0\n9, 9\n0, 0\n");
  check_refused({"fatigue", shear, "--detail", "56"}, "no detail resists it");
}

}  // namespace fatigue_command_test
