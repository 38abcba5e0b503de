#pragma once

#include <array>
#include <memory>
#include <vector>

/// A row of closed loops in Simbody. Plain values, for Simbody's headers are C++17.
namespace bench {

using Triple = std::array<double, 3>;

struct ClosedRow {
  /// Turns about an axis of the body that carries it, -1 for the ground.
  struct Body {
    int parent;
    Triple at, axis;
    double mass;
    Triple centre;
    std::array<double, 6> inertia;  ///< xx yy zz xy xz yz about the centre
  };
  /// A place of body b on one of body a.
  struct Ball {
    int a, b;
    Triple p_a, p_b;
  };
  Triple gravity;
  double swing, frequency;  ///< of the first body's joint: swing sin(frequency t) [rad, rad/s]
  std::vector<Body> bodies;
  std::vector<Ball> balls;
};

struct SimbodyAnswer {
  std::vector<double> coordinates, rates, accelerations;
  std::vector<Triple> forces;  ///< of joints on the bodies that they carry, of balls on b
  double drive;
};

class SimbodyRow {
 public:
  /// `accuracy`: to which positions and rates are projected.
  SimbodyRow(const ClosedRow& row, double accuracy);
  ~SimbodyRow();

  void start(const std::vector<double>& coordinates, const std::vector<double>& rates);
  void solve(double time);
  SimbodyAnswer answer() const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace bench
