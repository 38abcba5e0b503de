#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>

/// What random cases are drawn with.
namespace oracle {

/// Random numbers, alike on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 1049) {
    engine_.discard(8);
  }

  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  /// Small and large ones alike.
  double logarithmic(double low, double high) { return low * std::pow(high / low, real(0, 1)); }
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double part) { return real(0, 1) < part; }
  template <class T>
  T one_of(std::initializer_list<T> of) {
    return *(of.begin() + whole(0, static_cast<int>(of.size()) - 1));
  }

 private:
  std::mt19937_64 engine_;
};

/// A length in millimetres, whole ones.
inline std::string mm(double metres) { return fmt::format("\"{:.0f} mm\"", metres * 1e3); }
inline double round_mm(double metres) { return std::round(metres * 1e3) * 1e-3; }
inline std::string m(double metres) { return fmt::format("\"{:.4g} m\"", metres); }
inline std::string kN(double newtons) { return fmt::format("\"{:.4g} kN\"", newtons * 1e-3); }

}  // namespace oracle
