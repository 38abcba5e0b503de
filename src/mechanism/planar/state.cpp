#include "boxbeam/mechanism/planar/state.hpp"

namespace boxbeam::planar {

State interpolate(double time, const State& before, const State& behind) {
  const double h = behind.time - before.time;
  const double u = (time - before.time) / h;
  // In powers of u: q0 + v0 u + a0 u^2/2 + c3 u^3 + c4 u^4 + c5 u^5, times scaled by h.
  const Eigen::VectorXd v0 = h * before.v;
  const Eigen::VectorXd a0 = h * h * before.a;
  const Eigen::VectorXd q1 = behind.q - before.q - v0 - 0.5 * a0;
  const Eigen::VectorXd v1 = h * behind.v - v0 - a0;
  const Eigen::VectorXd a1 = h * h * behind.a - a0;
  const Eigen::VectorXd c3 = 10.0 * q1 - 4.0 * v1 + 0.5 * a1;
  const Eigen::VectorXd c4 = -15.0 * q1 + 7.0 * v1 - a1;
  const Eigen::VectorXd c5 = 6.0 * q1 - 3.0 * v1 + 0.5 * a1;
  State state;
  state.time = time;
  state.q = before.q + u * (v0 + u * (0.5 * a0 + u * (c3 + u * (c4 + u * c5))));
  state.v = (v0 + u * (a0 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))) / h;
  state.a = (a0 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))) / (h * h);
  return state;
}

}  // namespace boxbeam::planar
