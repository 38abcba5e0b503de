// Writes a long record and a case for it: six channels of seeded noise and sines, as OpenFAST
// writes them, on a tapered cantilever.
//
//     long_record FOLDER [INSTANTS [doubles]]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr std::size_t channels = 6;
constexpr double step = 0.01;

const char* const case_text = R"([case]
name = "long-record"
title = "Tapered cantilever under six long recorded channels"
kind = "loads"

[files.record]
path = "record.outb"

[loads.tip]
station = "10 m"
columns = { F_x = "TipFx", F_z = "TipFz", M_y = "TipMy" }

[loads.third]
station = "7 m"
columns = { F_z = "ThirdFz" }

[loads.second]
station = "4 m"
columns = { F_z = "SecondFz" }

[loads.first]
station = "2 m"
columns = { F_z = "FirstFz" }

[balance]
station = "0 m"
name = "root"

[sections.root]
kind = "box"
width = "300 mm"
height = "600 mm"
flange = "14 mm"
web = "12 mm"

[sections.middle]
kind = "box"
width = "300 mm"
height = "420 mm"
flange = "14 mm"
web = "12 mm"

[sections.tip]
kind = "box"
width = "300 mm"
height = "240 mm"
flange = "12 mm"
web = "10 mm"

[beam]
density = "7850 kg/m^3"

[[beam.segments]]
name = "inner"
length = "5 m"
from = "root"
to = "middle"

[[beam.segments]]
name = "outer"
length = "5 m"
from = "middle"
to = "tip"

[material]
steel = "S355"

[strength]
required = 1.5
shear_lag = false

[fatigue]
category = 71
cycles = 1
loading = "spectrum"
gamma_Mf = 1.35
required = 1.0
)";

class File {
 public:
  explicit File(const std::filesystem::path& path) : to_(path, std::ios::binary) {}

  template <class Number>
  void put(Number number) {
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    to_.write(bytes, sizeof bytes);
  }
  void word(std::string text) {
    text.resize(10, ' ');
    to_.write(text.data(), 10);
  }
  void rows(const std::vector<char>& bytes) {
    to_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  bool good() const { return to_.good(); }

 private:
  std::ofstream to_;
};

/// Noise that remembers, with a spectrum around one frequency, and sines.
class Channel {
 public:
  explicit Channel(std::size_t k)
      : random_(2024 + static_cast<unsigned>(k)), frequency_(0.3 + 0.37 * static_cast<double>(k)) {}

  /// In multiples of its scale, far below 6.
  double next(std::size_t instant) {
    // A damped oscillator under white noise: x'' + 2 d w x' + w^2 x.
    const double w = 2.0 * std::numbers::pi * (2.0 + 1.7 * frequency_), d = 0.08;
    v_ += step * (-2.0 * d * w * v_ - w * w * x_) + std::sqrt(step) * force(w, d);
    x_ += step * v_;
    const double t = step * static_cast<double>(instant);
    return 0.7 * x_ + 0.15 * normal_(random_) +
           0.5 * std::sin(2.0 * std::numbers::pi * frequency_ * t) +
           0.3 * std::sin(2.0 * std::numbers::pi * 0.01 * frequency_ * t);
  }

 private:
  /// White noise under which x has a standard deviation of one.
  double force(double w, double d) { return std::sqrt(4.0 * d * w * w * w) * normal_(random_); }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  double frequency_, x_ = 0.0, v_ = 0.0;
};

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::cerr << "long_record FOLDER [INSTANTS [doubles]]\n";
    return 2;
  }
  const std::filesystem::path folder = words[1];
  const std::size_t instants = count > 2 ? std::strtoull(words[2], nullptr, 10) : 10'000'000;
  const bool doubles = count > 3 && std::string(words[3]) == "doubles";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << case_text;
  const char* const names[channels] = {"TipFx", "TipFz", "TipMy", "ThirdFz", "SecondFz", "FirstFz"};
  const double scales[channels] = {20e3, 4e3, 8e3, 6e3, 8e3, 15e3};
  File file(folder / "record.outb");
  file.put(static_cast<std::int16_t>(doubles ? 3 : 2));
  file.put(static_cast<std::int32_t>(channels));
  file.put(static_cast<std::int32_t>(instants));
  file.put(0.0);
  file.put(step);
  if (!doubles) {
    for (const double scale : scales) file.put(static_cast<float>(32000.0 / (8.0 * scale)));
    for (std::size_t k = 0; k < channels; ++k) file.put(0.0F);
  }
  file.put(std::int32_t{0});
  file.word("Time");
  for (const char* name : names) file.word(name);
  file.word("(s)");
  for (std::size_t k = 0; k < channels; ++k) file.word(k == 2 ? "(N-m)" : "(N)");
  std::vector<Channel> of;
  for (std::size_t k = 0; k < channels; ++k) of.emplace_back(k);
  std::vector<char> bytes;
  for (std::size_t i = 0; i < instants; ++i) {
    for (std::size_t k = 0; k < channels; ++k) {
      const double value = std::min(8.0, std::max(-8.0, of[k].next(i)));
      const auto add = [&](auto number) {
        char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        bytes.insert(bytes.end(), raw, raw + sizeof number);
      };
      if (doubles)
        add(value * scales[k]);
      else
        add(static_cast<std::int16_t>(std::lround(value * 4000.0)));
    }
    if (bytes.size() < (std::size_t{1} << 20U) && i + 1 < instants) continue;
    file.rows(bytes);
    bytes.clear();
  }
  return file.good() ? 0 : 4;
}
