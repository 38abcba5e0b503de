#include "boxbeam/section/warping.hpp"

#include <cmath>

#include "catch.hpp"
#include "support/paths.hpp"

namespace warping_test {

using namespace boxbeam;
using namespace paths;

TEST_CASE("warping constants of I, channel, Z and angle: closed forms of mid-lines", "[twisting]") {
  // I_z of both flanges h^2/4: h = 1212, I_z = 2 12 400^3/12.
  const double I = *warping_constant_of(i_section(400.0, 12.0, 1200.0, 6.0));
  CHECK(I * 1e18 ==
        Approx(2.0 * 12.0 * std::pow(400.0, 3) / 12.0 * 1212.0 * 1212.0 / 4.0).epsilon(1e-6));
  // Unequal flanges: h^2 I_1 I_2/(I_1 + I_2), h = 1208.
  const double I_1 = 12.0 * std::pow(400.0, 3) / 12.0, I_2 = 4.0 * std::pow(200.0, 3) / 12.0;
  CHECK(*warping_constant_of(i_section(400.0, 12.0, 1200.0, 6.0, 4.0, 200.0)) * 1e18 ==
        Approx(1208.0 * 1208.0 * I_1 * I_2 / (I_1 + I_2)).epsilon(1e-4));
  // Channel of mid-lines b, h: t_f b^3 h^2/12 (3 b t_f + 2 h t_w)/(6 b t_f + h t_w), Timoshenko.
  const double b = 100.0, h = 290.0, t_w = 6.0, t_f = 10.0;
  CHECK(*warping_constant_of(channel(300.0, 100.0, t_w, t_f)) * 1e18 ==
        Approx(t_f * std::pow(b, 3) * h * h / 12.0 * (3.0 * b * t_f + 2.0 * h * t_w) /
               (6.0 * b * t_f + h * t_w))
            .epsilon(1e-6));
  // Z of one thickness: b^3 h^2 t (b + 2 h)/(12 (2 b + h)), Timoshenko, Gere, table A-3.
  ThinWalled zed;
  const std::size_t high = add_node(zed, mm_place(0.0, 145.0)),
                    low = add_node(zed, mm_place(0.0, -145.0));
  add_wall(zed, add_node(zed, mm_place(100.0, 145.0)), high, 6.0);
  add_wall(zed, high, low, 6.0);
  add_wall(zed, low, add_node(zed, mm_place(-100.0, -145.0)), 6.0);
  CHECK(
      *warping_constant_of(zed) * 1e18 ==
      Approx(std::pow(b, 3) * h * h * 6.0 * (b + 2.0 * h) / (12.0 * (2.0 * b + h))).epsilon(1e-6));
  // Walls that meet in one line do not warp on their mid-lines, about that line: next to nothing of
  // the A^3/144 by which they warp across their thickness (Timoshenko and Gere, table A-3).
  ThinWalled angle;
  const std::size_t heel = add_node(angle, mm_place(0.0, 0.0));
  add_wall(angle, heel, add_node(angle, mm_place(100.0, 0.0)), 8.0);
  add_wall(angle, heel, add_node(angle, mm_place(0.0, 150.0)), 8.0);
  CHECK(*warping_constant_of(angle) < 0.01 * std::pow(250.0 * 8.0e-6, 3) / 144.0);
}

TEST_CASE("warping constants do not depend on where nodes lie, and cells have none", "[twisting]") {
  const ThinWalled whole = channel(300.0, 100.0, 6.0, 10.0);
  CHECK(*warping_constant_of(split(split(whole, 0, 0.3), 1, 0.6)) ==
        Approx(*warping_constant_of(whole)).epsilon(1e-9));
  CHECK_FALSE(warping_constant_of(box_path(600.0, 1224.0, 12.0, 8.0)));
  CHECK_FALSE(warping_constant_of(Plate{mm(10.0), mm(100.0)}));
}

// Of an I with equal flanges h apart: omega = y z on them, none on the web.
TEST_CASE("omega of an I is y z on its flanges", "[twisting]") {
  const Warping of = *warping_of(i_section(400.0, 12.0, 1200.0, 6.0));
  const double sign = omega_near(of, {0.2, 0.606}) < 0.0 ? -1.0 : 1.0;
  CHECK(sign * omega_near(of, {0.2, 0.606}) == Approx(0.2 * 0.606).epsilon(1e-9));
  CHECK(sign * omega_near(of, {-0.1, 0.7}) == Approx(-0.1 * 0.606).epsilon(1e-9));
  CHECK(sign * omega_near(of, {0.1, -0.606}) == Approx(-0.1 * 0.606).epsilon(1e-9));
  CHECK(omega_near(of, {0.05, 0.1}) == Approx(0.0).margin(1e-12));
  CHECK(of.largest == Approx(0.2 * 0.606).epsilon(1e-9));
}

}  // namespace warping_test
