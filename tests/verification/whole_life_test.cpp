// Long records: the same history looked at instant by instant, by the rules for long records, and
// by a loop of this test over all places and instants.

#include "boxbeam/verification/whole_life.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "fatigue/plain_rainflow.hpp"
#include "support/program.hpp"

namespace whole_life_test {

using namespace boxbeam;

namespace {

constexpr std::size_t channels = 6;
constexpr double category = 71e6, gamma_Mf = 1.35;
/// Where F_x, F_z, M_y of the tip and F_z of three places act [m].
constexpr double length = 10.0, third = 7.0, second = 4.0, first = 2.0;

const char* const case_text = R"([case]
name = "long"
kind = "loads"
[files.record]
path = "record.csv"
[loads.tip]
station = "10 m"
columns = { F_x = "a", F_z = "b", M_y = "c" }
[loads.third]
station = "7 m"
columns = { F_z = "d" }
[loads.second]
station = "4 m"
columns = { F_z = "e" }
[loads.first]
station = "2 m"
columns = { F_z = "f" }
[balance]
station = "0 m"
name = "root"
[sections.root]
kind = "box"
width = "300 mm"
height = "600 mm"
flange = "14 mm"
web = "12 mm"
[sections.tip]
kind = "box"
width = "300 mm"
height = "200 mm"
flange = "14 mm"
web = "12 mm"
[beam]
density = "7850 kg/m^3"
[[beam.segments]]
name = "whole"
length = "10 m"
from = "root"
to = "tip"
[material]
steel = "S355"
[strength]
required = 1.5
shear_lag = false
[fatigue]
category = 71
cycles = 100
loading = "spectrum"
gamma_Mf = 1.35
required = 1.0
)";

using Values = std::vector<std::vector<double>>;  ///< of each channel

struct Kind {
  const char* name;
  std::function<Values(std::size_t)> make;
};

Values noise(std::size_t n) {
  Values values(channels);
  for (std::size_t k = 0; k < channels; ++k) {
    std::mt19937 random(11 + static_cast<unsigned>(k));
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < n; ++i) values[k].push_back(normal(random));
  }
  return values;
}

Values narrow_band(std::size_t n) {
  Values values = noise(n);
  for (std::size_t k = 0; k < channels; ++k) {
    const double w = 0.25 + 0.05 * static_cast<double>(k), d = 0.03;
    double x = 0.0, v = 0.0;
    for (double& value : values[k]) {
      v += -2.0 * d * w * v - w * w * x + std::sqrt(4.0 * d * w * w * w) * value;
      x += v;
      value = x;
    }
  }
  return values;
}

/// Sines of unlike frequencies, and single instants far out in one channel each.
Values sines_with_spikes(std::size_t n) {
  Values values(channels);
  for (std::size_t k = 0; k < channels; ++k) {
    const double w = 0.11 + 0.037 * static_cast<double>(k);
    for (std::size_t i = 0; i < n; ++i)
      values[k].push_back(std::sin(w * static_cast<double>(i) + static_cast<double>(k)));
    values[k][n / 7 * (k + 1)] += k % 2 == 0 ? 3.0 : -4.0;
  }
  return values;
}

/// Two channels that change, and four that do not.
Values mostly_constant(std::size_t n) {
  Values values = noise(n);
  for (const std::size_t k : {0, 2, 3, 5}) std::fill(values[k].begin(), values[k].end(), 0.5);
  return values;
}

const Kind kinds[] = {{"noise", noise},
                      {"narrow band", narrow_band},
                      {"sines with spikes", sines_with_spikes},
                      {"constant channels", mostly_constant}};

/// In the units of the file: kN and kN m, as rounded there.
void scale(Values& values) {
  const double scales[channels] = {40.0, 3.0, 8.0, 6.0, 10.0, 25.0};
  for (std::size_t k = 0; k < channels; ++k) {
    for (double& value : values[k]) value = std::round(value * scales[k] * 1e4) * 1e-4;
  }
}

void write_record(const test::TemporaryFolder& folder, const char* name, const Values& values) {
  std::string text = "time [s], a [kN], b [kN], c [kN m], d [kN], e [kN], f [kN]\n";
  for (std::size_t i = 0; i < values.front().size(); ++i) {
    text += fmt::format("{:.2f}", 0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < channels; ++k) text += fmt::format(",{:.4f}", values[k][i]);
    text += "\n";
  }
  folder.write(name, text);
}

Project read_case(const test::TemporaryFolder& folder, const Values& values) {
  write_record(folder, "record.csv", values);
  return read_project(folder.write("case.toml", case_text));
}

/// Loads as if their record were a long one.
void make_long(AnyMechanism& mechanism) {
  recorded::ChannelLoads& loads = std::get<recorded::Loads>(mechanism).acting;
  std::vector<recorded::RecordColumn> columns;
  for (const std::vector<double>& values : loads.channels->values) columns.push_back({values, 0.0});
  const auto record =
      std::make_shared<const recorded::Record>(0.0, 0.0, loads.channels->times, std::move(columns));
  recorded::Channels some = recorded::at_instants(record, {0, record->instants() - 1});
  some.outer =
      std::make_shared<const recorded::OuterInstants>(recorded::outer_instants_of(*record));
  loads.channels = std::make_shared<const recorded::Channels>(std::move(some));
}

Project as_long(Project project) {
  make_long(project.mechanism);
  for (Situation& situation : project.situations) {
    if (situation.changed) make_long(*situation.changed);
  }
  return project;
}

/// Instant by instant and as a long record: the governing checks agree to what is stated, all
/// others to `elsewhere`.
void check_alike(const Project& project, double elsewhere) {
  const Verification each = verify(project), whole = verify(as_long(project));
  CHECK(each.search.whole.instants == 0);
  CHECK(whole.search.whole.counted > 0);
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue, Criterion::shear_fatigue,
                                    Criterion::combined_fatigue, Criterion::stress_range}) {
    INFO(to_text(criterion));
    const CheckResult* const a = governing_of(each.checks, criterion);
    const CheckResult* const b = governing_of(whole.checks, criterion);
    REQUIRE(a != nullptr);
    REQUIRE(b != nullptr);
    CHECK(b->check.utilisation() ==
          Approx(a->check.utilisation()).epsilon(whole.search.tolerance + 1e-4));
    CHECK(b->check.situation == a->check.situation);
  }
  std::size_t alike = 0;
  for (const CheckResult& of : each.checks) {
    const auto other =
        std::find_if(whole.checks.begin(), whole.checks.end(),
                     [&](const CheckResult& at) { return at.check.id == of.check.id; });
    if (other == whole.checks.end()) continue;
    ++alike;
    INFO(of.check.id);
    CHECK(other->check.utilisation() == Approx(of.check.utilisation()).epsilon(elsewhere));
  }
  CHECK(alike > 10);
}

/// EN 1993-1-9, figure 7.1: cycles to failure of a range, with the partial factor.
double endured(double range) {
  const double C = category / gamma_Mf;
  const double D = C * std::cbrt(2.0 / 5.0), L = D * std::pow(5.0 / 100.0, 0.2);
  if (range <= L) return std::numeric_limits<double>::infinity();
  return range > D ? 2e6 * std::pow(C / range, 3.0) : 5e6 * std::pow(D / range, 5.0);
}

/// The largest direct stress, and the use of the life: one over the factor on the ranges at which
/// Miner's sum is 1 after 100 repetitions.
struct Place {
  double use = 0.0, largest = 0.0;
};

/// By sigma = N/A + M z/I of the box as it is at a station, clamped at the start: V and M of what
/// acts beyond.
Place place_at(const Values& kN, double s, double sign) {
  const double h = 0.6 - 0.4 * s / length, b = 0.3, f = 0.014, w = 0.012;
  const double A = b * h - (b - 2 * w) * (h - 2 * f);
  const double I = (b * h * h * h - (b - 2 * w) * std::pow(h - 2 * f, 3)) / 12.0;
  const double z = sign * 0.5 * h;
  std::vector<double> stresses;
  Place place;
  for (std::size_t i = 0; i < kN.front().size(); ++i) {
    // A force up beyond s bends the end up: compression at +z, M_y < 0.
    double M = kN[2][i] - kN[1][i] * (length - s);
    if (s < third) M -= kN[3][i] * (third - s);
    if (s < second) M -= kN[4][i] * (second - s);
    if (s < first) M -= kN[5][i] * (first - s);
    stresses.push_back(1e3 * (kN[0][i] / A + M * z / I));
    place.largest = std::max(place.largest, std::abs(stresses.back()));
  }
  // Of a history that repeats: from its highest point once round.
  std::rotate(stresses.begin(), std::max_element(stresses.begin(), stresses.end()), stresses.end());
  stresses.push_back(stresses.front());
  std::vector<double> ranges;
  std::vector<double> stack;
  for (const double turn : plain::turning_points(stresses)) {
    stack.push_back(turn);
    while (stack.size() >= 4) {  // four points: the inner range closes
      const std::size_t n = stack.size();
      const double inner = std::abs(stack[n - 2] - stack[n - 3]);
      if (inner > std::abs(stack[n - 1] - stack[n - 2]) ||
          inner > std::abs(stack[n - 3] - stack[n - 4]))
        break;
      ranges.push_back(inner);
      stack.erase(stack.end() - 3, stack.end() - 1);
    }
  }
  // Highest, lowest, highest are left: one cycle.
  if (stack.size() == 3) ranges.push_back(std::abs(stack[0] - stack[1]));
  if (ranges.empty()) return place;
  const auto damage = [&](double factor) {
    double sum = 0.0;
    for (const double range : ranges) sum += 100.0 / endured(factor * range);
    return sum;
  };
  double low = 1e-3, high = 1e3;
  for (int i = 0; i < 45; ++i) {
    const double middle = std::sqrt(low * high);
    (damage(middle) <= 1.0 ? low : high) = middle;
  }
  place.use = 1.0 / low;
  return place;
}

WholePlace place_of(std::vector<double> factors) { return {std::move(factors), false}; }

}  // namespace

TEST_CASE("no place is used more than the governing one of a long record", "[whole life]") {
  constexpr std::size_t n = 100'000;
  for (const Kind& kind : kinds) {
    INFO(kind.name);
    const test::TemporaryFolder folder;
    Values values = kind.make(n);
    scale(values);
    const Project project = as_long(read_case(folder, values));
    const Verification verification = verify(project);
    REQUIRE(verification.search.whole.instants == n);
    const CheckResult* const fatigue = governing_of(verification.checks, Criterion::fatigue);
    REQUIRE(fatigue != nullptr);
    const double own = fatigue->check.station.s.value();
    const double sign = fatigue->basis->point.z.value() > 0.0 ? 1.0 : -1.0;
    REQUIRE(std::abs(fatigue->basis->point.z.value()) == Approx(0.3 - 0.2 * own / length));
    const double governing = place_at(values, own, sign).use;
    // Counted in full; classes of ranges cost 2e-5.
    CHECK(fatigue->check.utilisation() == Approx(governing).epsilon(5e-5));
    double most = 0.0, largest = 0.0;
    for (int j = 0; j < 10; ++j) {
      for (const double side : {1.0, -1.0}) {
        const Place at = place_at(values, j, side);
        most = std::max(most, at.use);
        largest = std::max(largest, at.largest);
      }
    }
    const double tolerance = verification.search.tolerance;
    CHECK(tolerance < 0.02);
    CHECK(most <= fatigue->check.utilisation() * (1.0 + tolerance) * (1.0 + 5e-5));
    // Shear adds nothing at a fibre: the equivalent stress is the direct one.
    const CheckResult* const yield = governing_of(verification.checks, Criterion::yield);
    REQUIRE(yield != nullptr);
    CHECK(yield->check.acting.value() >= largest * (1.0 - 1e-9));
  }
}

TEST_CASE("a record is judged alike as a long one and instant by instant", "[whole life]") {
  for (const Kind& kind : kinds) {
    INFO(kind.name);
    const test::TemporaryFolder folder;
    Values values = kind.make(3000);
    scale(values);
    check_alike(read_case(folder, values), 0.05);
  }
}

TEST_CASE("long records of situations one after the other, and where compression counts less",
          "[whole life]") {
  const test::TemporaryFolder folder;
  Values calm = narrow_band(2000), rough = noise(3000);
  scale(calm);
  scale(rough);
  for (double& value : calm[1]) value += 5.0;  // one after the other they make a cycle of their own
  write_record(folder, "calm.csv", calm);
  std::string text = case_text;
  const std::string situations =
      "[[situations]]\nname = \"rough\"\ncycles = 20\n"
      "[[situations]]\nname = \"calm\"\ncycles = 50\n"
      "set = { \"files.record.path\" = \"calm.csv\" }\n"
      "[[situations]]\nname = \"both\"\nsequence = [\"calm\", \"rough\"]\ncycles = 30\n"
      "[[situations]]\nname = \"change\"\nbetween = [\"calm\", \"rough\"]\n"
      "spectrum = [{ share = 1.0, cycles = 400 }, { share = 0.7, cycles = 4000 }]\n";
  const std::size_t at = text.find("cycles = 100\n");
  text.erase(at, std::string("cycles = 100\n").size());
  write_record(folder, "record.csv", rough);
  check_alike(read_project(folder.write("case.toml", text + situations)), 0.05);
  const std::size_t fatigue = text.find("category = 71\n");
  text.insert(fatigue, "stress_relieved = true\n");
  // Estimates of what is little used are rougher where the mean has a say.
  check_alike(read_project(folder.write("case.toml", text + situations)), 0.25);
}

TEST_CASE("places are counted the same together and one by one", "[whole life]") {
  const test::TemporaryFolder folder;
  Values values = narrow_band(20'000);
  scale(values);
  const Project project = as_long(read_case(folder, values));
  const std::deque<SituationRun> runs = run_situations(project);
  const WholePlace a = place_of({0.0, 1e3, 2e3, 0.0, -1e3, 0.0, 5e2});
  const WholePlace b = place_of({1e5, 0.0, 2e3, 1e3, 0.0, -3e3, 0.0});
  const WholePlace c = place_of({0.0, 0.0, 0.0, 7e2, 0.0, 0.0, 1e3});
  WholeLife together(project, runs), apart(project, runs);
  together.count({a, b, c});
  for (const WholePlace& place : {c, a, b}) apart.count({place});
  const SnCurve curve = en_1993_1_9_direct(71.0);
  for (const WholePlace& place : {a, b, c}) {
    const std::vector<Cycle> x = together.cycles_of(place, curve).front().cycles;
    const std::vector<Cycle> y = apart.cycles_of(place, curve).front().cycles;
    REQUIRE(x.size() == y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      CHECK(x[i].range == y[i].range);
      CHECK(x[i].count == y[i].count);
    }
  }
  // A multiple of a place needs no counting: its ranges are as many times as large.
  WholePlace twice = a;
  for (double& factor : twice.factors) factor *= 2.0;
  CHECK(together.is_counted(twice));
  CHECK(together.factor_of(std::vector{std::pair{twice, curve}}) ==
        Approx(0.5 * together.factor_of(std::vector{std::pair{a, curve}})).epsilon(1e-9));
  // As many cycles, and the same sum of fifth powers, as counted one by one.
  std::vector<double> stresses;
  const recorded::Record& record = *runs.front().loads.recorded_channels()->record;
  for (std::size_t i = 0; i < record.instants(); ++i) {
    double sum = b.factors[0];
    for (std::size_t k = 0; k < channels; ++k) sum += b.factors[k + 1] * record.value(k, i);
    stresses.push_back(sum);
  }
  const auto moments = [](const std::vector<Cycle>& cycles) {
    std::pair<double, double> sums;
    for (const Cycle& cycle : cycles) {
      sums.first += cycle.count;
      sums.second += cycle.count * std::pow(cycle.range.value(), 5.0);
    }
    return sums;
  };
  const auto [count, power] = moments(count_cycles(stresses, {Counting::periodic}));
  const auto [classes, power_of_classes] = moments(together.cycles_of(b, curve).front().cycles);
  CHECK(classes == Approx(100.0 * count).epsilon(1e-12));
  CHECK(power_of_classes == Approx(100.0 * power).epsilon(2e-5));
}

TEST_CASE("outer instants have the extremes that they prove", "[whole life]") {
  std::size_t proved = 0;
  for (const Kind& kind : kinds) {
    Values values = kind.make(400'000);
    scale(values);
    std::vector<recorded::RecordColumn> columns;
    for (const std::vector<double>& of : values) columns.push_back({of, 0.0});
    const recorded::Record record(0.0, 0.01, {}, std::move(columns));
    const recorded::OuterInstants outer = recorded::outer_instants_of(record);
    CHECK(outer.instants.size() < record.instants() / 2);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 20; ++trial) {
      Eigen::VectorXd sum(static_cast<Eigen::Index>(channels));
      for (double& of : sum) of = normal(random);
      double largest = -std::numeric_limits<double>::infinity(), found = largest;
      for (std::size_t i = 0; i < record.instants(); ++i) {
        double at = 0.0;
        for (std::size_t k = 0; k < channels; ++k) {
          const auto j = static_cast<Eigen::Index>(k);
          at += sum[j] * (values[k][i] - outer.centre[j]);
        }
        largest = std::max(largest, at);
      }
      for (std::size_t i = 0; i < outer.instants.size(); ++i) {
        double at = 0.0;
        for (std::size_t k = 0; k < channels; ++k)
          at += sum[static_cast<Eigen::Index>(k)] * outer.values[k][i];
        found = std::max(found, at);
      }
      if (!outer.proves(sum, found)) continue;
      ++proved;
      CHECK(found == Approx(largest).epsilon(1e-12));
    }
  }
  CHECK(proved > 30);
}

TEST_CASE("of a long record the instant is looked at that is worst for plates that buckle") {
  // Webs of 1200 x 8: N weighs A/A_eff = 2.05 times as much as on the gross section, M_y 1.34
  // times. The last event has neither the most N nor the most M_y, nor the highest stress there.
  const std::string text =
      "[case]\nname = \"long\"\nkind = \"loads\"\n[sections.a]\nkind = \"box\"\nwidth = \"600 "
      "mm\"\n"
      "height = \"1224 mm\"\nflange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = \"7850 "
      "kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"4 m\"\nsection = \"a\"\n[files.f]\npath = \"events.csv\"\n"
      "[loads.tip]\nstation = \"4 m\"\ncolumns = { F_x = \"Fx\", M_y = \"My\" }\n"
      "[[beam.restraints]]\nstation = \"0 m\"\nholds = [\"along y\", \"along z\", \"turning "
      "over\"]\n"
      "[[beam.restraints]]\nstation = \"4 m\"\nholds = [\"along y\", \"along z\", \"turning "
      "over\"]\n"
      "[balance]\nstation = \"0 m\"\nname = \"root\"\n[material]\nsteel = \"S355\"\n"
      "[strength]\nrequired = 1.0\nshear_lag = false\n";
  const test::TemporaryFolder folder;
  std::string csv = "time [s],Fx [kN],My [kN m]\n";
  const std::array<std::array<double, 2>, 3> events{
      {{-4000.0, 0.0}, {0.0, -3000.0}, {-2600.0, -2000.0}}};
  for (int i = 0; i < 400; ++i) {
    std::array<double, 2> at{-10.0 - i % 7, -5.0 - i % 11};
    if (i % 100 == 51 && i < 300) at = events[static_cast<std::size_t>(i / 100)];
    csv += fmt::format("{:.2f},{},{}\n", 0.01 * i, at[0], at[1]);
  }
  folder.write("events.csv", csv);
  const Project project = read_project(folder.write("case.toml", text));
  const auto use = [](const Verification& of) {
    const CheckResult* const at = governing_of(of.checks, Criterion::effective_section);
    REQUIRE(at != nullptr);
    return at->check.utilisation();
  };
  const double all = use(verify(project));
  CHECK(all > 1.0);
  CHECK(use(verify(as_long(project))) == Approx(all).epsilon(1e-6));
}

}  // namespace whole_life_test
