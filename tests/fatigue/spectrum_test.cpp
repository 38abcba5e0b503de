#include "boxbeam/fatigue/spectrum.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

namespace spectrum_test {

using namespace boxbeam;

namespace {

/// Adds cycles of ranges and means [MPa].
void add(SpectrumCollector& collector, const std::vector<double>& ranges,
         const std::vector<double>& means, double count = 1.0) {
  std::vector<double> range, mean;
  for (const double x : ranges) range.push_back(x * 1e6);
  for (const double x : means) mean.push_back(x * 1e6);
  collector.add({range, mean, count});
}

std::vector<Cycle> cycles_of(const std::vector<SpectrumBin>& spectrum) {
  std::vector<Cycle> cycles;
  for (const SpectrumBin& bin : spectrum) cycles.push_back({bin.range, bin.mean, bin.count});
  return cycles;
}

double sum_of(const std::vector<SpectrumBin>& spectrum, double SpectrumBin::*what) {
  double sum = 0.0;
  for (const SpectrumBin& bin : spectrum) sum += bin.*what;
  return sum;
}

const SnCurve curve = en_1993_1_9_direct(56);

}  // namespace

TEST_CASE("equal cycles are put together, the largest range first, as often as asked") {
  SpectrumCollector collector(curve, {}, false);
  add(collector, {60, 90, 60, 60}, {10, 20, 10, 30});
  add(collector, {60}, {10}, 0.5);
  const std::vector<SpectrumBin> spectrum = collector.spectrum(4.0);
  REQUIRE(spectrum.size() == 3);
  CHECK(spectrum[0].range.value() == 90e6);
  CHECK(spectrum[0].count == 4.0);
  CHECK(spectrum[1].mean.value() == 30e6);
  CHECK(spectrum[2].mean.value() == 10e6);
  CHECK(spectrum[2].count == 10.0);
  CHECK(collector.count() == 4.5);
  CHECK(collector.largest().value() == 90e6);
  CHECK_FALSE(collector.binned());
}

TEST_CASE("the damage is Miner's sum of the cycles that are listed, with the factors") {
  for (const FatigueDemand& demand :
       {FatigueDemand{}, FatigueDemand{Loading::spectrum, 1.1, 1.35}}) {
    SpectrumCollector collector(curve, demand, false);
    std::mt19937 random(3);
    std::uniform_int_distribution<int> any(1, 200);
    for (int i = 0; i < 3000; ++i) {
      add(collector, {static_cast<double>(any(random))}, {0.0}, i % 3 == 0 ? 0.5 : 1.0);
    }
    const std::vector<SpectrumBin> spectrum = collector.spectrum();
    CHECK(spectrum.size() <= 200);
    CHECK(collector.damage() ==
          Approx(damage_of(cycles_of(spectrum), curve, demand)).epsilon(1e-12));
    CHECK(sum_of(spectrum, &SpectrumBin::damage) == Approx(collector.damage()).epsilon(1e-12));
    CHECK(sum_of(spectrum, &SpectrumBin::count) == Approx(collector.count()).epsilon(1e-12));
  }
}

TEST_CASE("too many sizes are sorted into bins that keep count and damage") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0.0, 300.0);
  SpectrumCollector collector(curve, {Loading::spectrum, 1.0, 1.15}, false);
  std::vector<Cycle> all;
  for (int i = 0; i < 100000; ++i) {
    const double range = any(random);
    add(collector, {range}, {0.5 * range}, i % 2 == 0 ? 1.0 : 0.5);
    all.push_back({si<Stress>(range * 1e6), {}, i % 2 == 0 ? 1.0 : 0.5});
  }
  REQUIRE(collector.binned());
  const std::vector<SpectrumBin> spectrum = collector.spectrum();
  CHECK(spectrum.size() <= SpectrumCollector::most_bins);
  CHECK(spectrum.size() > SpectrumCollector::most_bins / 2);
  const double exact = damage_of(all, curve, {Loading::spectrum, 1.0, 1.15});
  CHECK(collector.damage() == Approx(exact).epsilon(1e-10));
  CHECK(sum_of(spectrum, &SpectrumBin::damage) == Approx(exact).epsilon(1e-10));
  CHECK(sum_of(spectrum, &SpectrumBin::count) == Approx(75000.0).epsilon(1e-12));
  CHECK(spectrum.front().largest == collector.largest());
  // Every bin's mean range lies above that of the next, and the mean stresses follow them here.
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    CHECK(spectrum[i].range <= spectrum[i].largest);
    CHECK(spectrum[i].mean.value() == Approx(0.5 * spectrum[i].range.value()).epsilon(1e-9));
    if (i > 0) CHECK(spectrum[i].largest < spectrum[i - 1].range);
  }
}

TEST_CASE("bins put together when a larger range comes keep cycles, damage and means") {
  // Many small ranges are in bins when the largest comes last, which halves the number of bins of
  // the others several times. EN 1993-1-9, category 56: knee 56 (2/5)^(1/3) MPa, slopes 3 and 5.
  SpectrumCollector collector(curve, {}, false);
  const double knee = 56.0 * std::cbrt(0.4);
  double exact = 0.0, ranges = 0.0, means = 0.0, cycles = 0.0;
  const auto put = [&](double range, double mean, double count) {
    add(collector, {range}, {mean}, count);
    exact += count / (5e6 * std::pow(knee / range, range < knee ? 5.0 : 3.0));
    ranges += count * range * 1e6;
    means += count * mean * 1e6;
    cycles += count;
  };
  for (int i = 0; i < 20000; ++i) put(25.0 + i * 1e-3, i * 1e-4, i % 3 == 0 ? 0.5 : 1.0);
  REQUIRE(collector.binned());
  const std::size_t fine = collector.spectrum().size();
  for (const double range : {100.0, 400.0}) put(range, -7.0, 1.0);
  const std::vector<SpectrumBin> spectrum = collector.spectrum();
  CHECK(spectrum.size() < fine);
  CHECK(spectrum.front().range.value() == Approx(400e6).epsilon(1e-12));
  double range_sum = 0.0, mean_sum = 0.0;
  for (const SpectrumBin& bin : spectrum) {
    range_sum += bin.count * bin.range.value();
    mean_sum += bin.count * bin.mean.value();
  }
  CHECK(sum_of(spectrum, &SpectrumBin::damage) == Approx(exact).epsilon(1e-10));
  CHECK(sum_of(spectrum, &SpectrumBin::count) == Approx(cycles).epsilon(1e-12));
  CHECK(range_sum == Approx(ranges).epsilon(1e-10));
  CHECK(mean_sum == Approx(means).epsilon(1e-10));
  CHECK(collector.damage() == Approx(exact).epsilon(1e-10));
}

TEST_CASE("a spectrum asked for between two gatherings changes nothing") {
  SpectrumCollector asked(curve, {}, false), left(curve, {}, false);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(1.0, 250.0);
  for (int i = 0; i < 20000; ++i) {
    const double range = any(random);
    add(asked, {range}, {0.0});
    add(left, {range}, {0.0});
    if (i % 4321 == 0) CHECK(sum_of(asked.spectrum(), &SpectrumBin::count) == i + 1);
  }
  CHECK(asked.damage() == left.damage());
  CHECK(asked.spectrum().size() == left.spectrum().size());
}

TEST_CASE("constant amplitude: nothing while all ranges are below the limit, then all of them") {
  // EN 1993-1-9, 7.1(2) and (3): category 56, limit 56 (2/5)^(1/3) = 41.26 MPa.
  const FatigueDemand constant{Loading::constant_amplitude, 1.0, 1.0};
  SpectrumCollector collector(curve, constant, false);
  add(collector, {41, 30}, {0, 0});
  CHECK(collector.damage() == 0.0);
  add(collector, {42}, {0});
  const double knee = 56.0 * std::cbrt(0.4);
  const double expected = 1.0 / (2e6 * std::pow(56.0 / 42.0, 3)) +
                          1.0 / (5e6 * std::pow(knee / 41.0, 5)) +
                          1.0 / (5e6 * std::pow(knee / 30.0, 5));
  CHECK(collector.damage() == Approx(expected).epsilon(1e-12));
  CHECK(collector.damage() ==
        Approx(damage_of(cycles_of(collector.spectrum()), curve, constant)).epsilon(1e-12));
}

TEST_CASE("compression counts 60 %: +80/-60 MPa as 116, EN 1993-1-9 7.2.1") {
  SpectrumCollector collector(curve, {}, true);
  add(collector, {140}, {10});
  const std::vector<SpectrumBin> spectrum = collector.spectrum();
  REQUIRE(spectrum.size() == 1);
  CHECK(spectrum.front().range.value() == Approx(116e6).epsilon(1e-12));
  CHECK(collector.damage() == Approx(1.0 / (2e6 * std::pow(56.0 / 116.0, 3))).epsilon(1e-12));
}

TEST_CASE("without cycles there is no damage and no spectrum") {
  const SpectrumCollector collector(curve, {}, false);
  CHECK(collector.damage() == 0.0);
  CHECK(collector.spectrum().empty());
  CHECK(collector.largest().value() == 0.0);
}

}  // namespace spectrum_test
