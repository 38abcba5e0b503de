#pragma once

#include <array>
#include <memory>

/// The force-driven benchmarks in Simbody, moved by its time stepper with the integrator that it
/// recommends (Runge-Kutta-Merson of order 4(5), projection to a tenth of the accuracy). Plain
/// numbers, as in simbody_rig.hpp and for the same reason.
namespace bench {

enum class Linkage { pendulum, four_bars };

struct LinkageResult {
  double x = 0.0, y = 0.0;  ///< of the point that is looked at [m]
  int evaluations = 0;      ///< of the accelerations
};

class SimbodyLinkage {
 public:
  explicit SimbodyLinkage(Linkage linkage);
  ~SimbodyLinkage();
  SimbodyLinkage(const SimbodyLinkage&) = delete;
  SimbodyLinkage& operator=(const SimbodyLinkage&) = delete;

  /// From the start to a time. Throws where the integrator gives up.
  LinkageResult run(double time, double accuracy) const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace bench
