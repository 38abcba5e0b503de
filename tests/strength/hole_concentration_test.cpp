#include "boxbeam/strength/hole_concentration.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include "catch.hpp"

namespace hole_concentration_test {

using namespace boxbeam;

namespace {

Length m(double x) { return si<Length>(x); }

/// A plate of depth D and thickness t, bent in its plane: two webs of t/2 whose flanges are a
/// billionth of it.
Section plate(double depth, double thickness) {
  const double sliver = 1e-9;
  return {
      symmetric_box(m(thickness * (1 + sliver)), m(depth), m(depth * sliver), m(0.5 * thickness)),
      {}};
}

Hole web_hole(double diameter, double level) {
  return {"hole", m(diameter), HoleWalls::webs, m(level)};
}

Hole flange_hole(double diameter, double y) {
  return {"hole", m(diameter), HoleWalls::flanges, m(y)};
}

// The 600 mm box of the sledge rig: clear 300 x 500 mm, A = 90e-3 m^2, I = 4.075e-3 m^4.
const Section box{symmetric_box(m(0.4), m(0.6), m(0.05), m(0.05)), {}};

}  // namespace

namespace {

/// The place at the top (+90 degrees) or bottom of a web hole's edge.
const HoleEdge& at_angle(const std::vector<HoleEdge>& edges, double degrees) {
  for (const HoleEdge& edge : edges) {
    if (std::abs(edge.angle - degrees * std::numbers::pi / 180.0) < 1e-9) return edge;
  }
  throw std::runtime_error("no place at this angle");
}

}  // namespace

TEST_CASE("in-plane bending of a plate: twice 12 M r over t (D^3 - d^3) at the hole, Roark 17.1") {
  const double D = 0.5, t = 0.02;
  for (const double d : {0.025, 0.05, 0.1, 0.2}) {
    const Hole hole = web_hole(d, 0.0);
    const auto edges = hole_edges_of(plate(D, t), {hole}, {}, hole, HoleCase::in_plane_bending);
    const double expected = 2 * 12 * 0.5 * d / (t * (D * D * D - d * d * d));
    CAPTURE(d);
    CHECK(at_angle(edges, 90.0).z.value() == Approx(0.5 * d).epsilon(1e-12));
    CHECK(at_angle(edges, 270.0).z.value() == Approx(-0.5 * d).epsilon(1e-12));
    CHECK(at_angle(edges, 90.0).influence.normal[cut_force::M_y] == Approx(expected).epsilon(1e-6));
    CHECK(at_angle(edges, 270.0).influence.normal[cut_force::M_y] ==
          Approx(-expected).epsilon(1e-6));
  }
}

TEST_CASE("axial force at a web hole is membrane tension of the clear depth") {
  const Hole hole = web_hole(0.1, 0.0);
  // d/w = 100/500 mm; on the gross area with K_t/(1 - a).
  const double expected = membrane_concentration(0.2) / 0.8 / 0.09;
  const auto edges = hole_edges_of(box, {hole}, {}, hole, HoleCase::in_plane_bending);
  CHECK(at_angle(edges, 90.0).influence.normal[cut_force::N] == Approx(expected).epsilon(1e-12));
  CHECK(at_angle(edges, 270.0).influence.normal[cut_force::N] == Approx(expected).epsilon(1e-12));
  // Kirsch: a third of it as pressure at the sides.
  CHECK(at_angle(edges, 0.0).influence.normal[cut_force::N] ==
        Approx(-expected / 3.0).epsilon(1e-12));
}

TEST_CASE("a web hole off mid-height adds the membrane part of the bending at its centre") {
  const Hole hole = web_hole(0.1, 0.15);
  const auto edges = hole_edges_of(box, {hole}, {}, hole, HoleCase::in_plane_bending);
  CHECK(at_angle(edges, 90.0).z.value() == Approx(0.2).epsilon(1e-12));
  CHECK(at_angle(edges, 270.0).z.value() == Approx(0.1).epsilon(1e-12));
  // The mean of both edges is K_g M z_0/I, the gradient drops out.
  const double mean = 0.5 * (at_angle(edges, 90.0).influence.normal[cut_force::M_y] +
                             at_angle(edges, 270.0).influence.normal[cut_force::M_y]);
  CHECK(mean == Approx(membrane_concentration(0.2) / 0.8 * 0.15 / 4.075e-3).epsilon(1e-12));
  CHECK(at_angle(edges, 90.0).influence.normal[cut_force::M_y] >
        at_angle(edges, 270.0).influence.normal[cut_force::M_y]);
}

TEST_CASE("shear at a web hole: four times the nominal shear at 45 degrees, Kirsch") {
  const Hole hole = web_hole(0.01, 0.0);
  const auto edges = hole_edges_of(box, {hole}, {}, hole, HoleCase::in_plane_bending);
  // V S/(I b) of the 400 x 600 x 50 box by hand, and a = 10/500 mm.
  const double nominal = 8.625e-3 / (4.075e-3 * 0.1);
  CHECK(at_angle(edges, 135.0).influence.normal[cut_force::V_z] ==
        Approx(4.0 / 0.98 * nominal).epsilon(1e-12));
  CHECK(at_angle(edges, 45.0).influence.normal[cut_force::V_z] ==
        Approx(-4.0 / 0.98 * nominal).epsilon(1e-12));
  CHECK(std::abs(at_angle(edges, 90.0).influence.normal[cut_force::V_z]) < 1e-12 * nominal);
}

TEST_CASE("the hoop stress around a web hole is in balance: its moments of cos and sin vanish") {
  // A free edge under self-balanced stress: the first harmonics of sigma(theta) that would push the
  // disc cut out (cos theta for N and V, cos theta for bending) are zero; sin theta of the gradient
  // is what bends it.
  const Hole hole = web_hole(0.1, 0.1);
  const auto edges = hole_edges_of(box, {hole}, {}, hole, HoleCase::in_plane_bending);
  double N = 0.0, V = 0.0, M = 0.0;
  for (const HoleEdge& edge : edges) {
    N += edge.influence.normal[cut_force::N] * std::cos(edge.angle);
    V += edge.influence.normal[cut_force::V_z] * std::cos(edge.angle);
    M += edge.influence.normal[cut_force::M_y] * std::cos(edge.angle);
  }
  CHECK(std::abs(N) < 1e-9);
  CHECK(std::abs(V) < 1e-9);
  CHECK(std::abs(M) < 1e-9);
}

TEST_CASE("flange hole: K_g times N/A + M z/I at the outer fibre of both flanges") {
  const Hole hole = flange_hole(0.06, 0.0);
  const auto edges = hole_edges_of(box, {hole}, {}, hole, HoleCase::membrane_tension);
  const double K_g = membrane_concentration(0.06 / 0.3) / (1 - 0.06 / 0.3);
  CHECK(edges[0].z.value() == Approx(0.3).epsilon(1e-12));
  CHECK(edges[1].z.value() == Approx(-0.3).epsilon(1e-12));
  CHECK(edges[0].influence.normal[cut_force::N] == Approx(K_g / 0.09).epsilon(1e-12));
  CHECK(edges[1].influence.normal[cut_force::N] == Approx(K_g / 0.09).epsilon(1e-12));
  CHECK(edges[0].influence.normal[cut_force::M_y] == Approx(K_g * 0.3 / 4.075e-3).epsilon(1e-12));
  CHECK(edges[1].influence.normal[cut_force::M_y] == Approx(-K_g * 0.3 / 4.075e-3).epsilon(1e-12));
}

TEST_CASE("published case: the factor times the nominal net stress M z/I_net at the edge") {
  const Section pivot{symmetric_box(m(0.4), m(1.0), m(0.05), m(0.05)), {}};
  const Hole hub = web_hole(0.145, 0.0);
  const auto edges = hole_edges_of(pivot, {hub}, {}, hub, HoleCase::published_exponential);
  const double I_net = (0.4 - 0.3 * std::pow(0.9, 3) - 0.1 * std::pow(0.145, 3)) / 12;
  // d/w with the whole height, 145/1000.
  const double K = 2.68750 * std::exp(-0.7128 * 0.145);
  CHECK(edges[0].influence.normal[cut_force::M_y] == Approx(K * 0.0725 / I_net).epsilon(1e-12));
  CHECK(edges[0].influence.normal[cut_force::N] == Approx(K / (0.13 - 0.0145)).epsilon(1e-12));
}

TEST_CASE("the plate a hole lies in: clear depth, clear width or half of it") {
  CHECK(plate_width_of(box, {web_hole(0.1, 0)}, web_hole(0.1, 0), HoleCase::in_plane_bending)
            .value() == Approx(0.5).epsilon(1e-14));
  CHECK(plate_width_of(box, {flange_hole(0.1, 0)}, flange_hole(0.1, 0), HoleCase::membrane_tension)
            .value() == Approx(0.3).epsilon(1e-14));
  CHECK(plate_width_of(box, {flange_hole(0.1, 0.08)}, flange_hole(0.1, 0.08),
                       HoleCase::membrane_tension)
            .value() == Approx(0.15).epsilon(1e-14));
  CHECK(plate_width_of(box, {web_hole(0.1, 0)}, web_hole(0.1, 0), HoleCase::published_exponential)
            .value() == Approx(0.6).epsilon(1e-14));
}

TEST_CASE("the cases have names of their own") {
  CHECK(std::string(to_text(HoleCase::in_plane_bending)) == "in-plane bending");
  CHECK(std::string(to_text(HoleCase::membrane_tension)) == "membrane tension");
  CHECK(std::string(to_text(HoleCase::published_exponential)) == "published exponential");
}

TEST_CASE(
    "a hole along z in a solid plate that lies flat: plate bending and membrane, both faces") {
  // Plate 200 x 10 mm, hole of 20 mm: d/h = 2, d/w = 0.1. Nominal 6M/[(w - d) h^2], factor of plate
  // bending; N/A with Peterson's net factor over 1 - d/w.
  const Section flat{Plate{0.2 * metre, 0.01 * metre}, {}};
  const Hole hole{"bolt", 0.02 * metre, HoleWalls::flanges, Length{}};
  const auto edges = hole_edges_of(flat, {hole}, {}, hole, HoleCase::out_of_plane_bending);
  REQUIRE(edges.size() == 2);
  const double nominal = 6.0 / (0.18 * 0.01 * 0.01);
  const double factor = plate_bending_concentration(2.0, 0.1).value();
  CHECK(edges[0].influence.normal[cut_force::M_y] == Approx(factor * nominal).epsilon(1e-12));
  CHECK(edges[1].influence.normal[cut_force::M_y] == Approx(-factor * nominal).epsilon(1e-12));
  const double membrane = membrane_concentration(0.1) / 0.9 / (0.2 * 0.01);
  for (const HoleEdge& edge : edges)
    CHECK(edge.influence.normal[cut_force::N] == Approx(membrane).epsilon(1e-12));
  // From d/w = 0.3 on the factor is not known.
  const Hole wide{"port", 0.07 * metre, HoleWalls::flanges, Length{}};
  CHECK(hole_edges_of(flat, {wide}, {}, wide, HoleCase::out_of_plane_bending).empty());
}

TEST_CASE("a web hole under all six cut forces: Kirsch with each web's own stress and shear") {
  const Hole hole = web_hole(0.01, 0.0);
  const auto walls = holes_in_walls_of(box, {hole}, {}, hole);
  REQUIRE(walls.size() == 2);
  CHECK(walls[0].side == "+y");
  CHECK(walls[1].side == "-y");
  const double a = 0.01 / 0.5;
  const double K_g = membrane_concentration(a) / (1 - a);
  const double I_z = (0.6 * std::pow(0.4, 3) - 0.5 * std::pow(0.3, 3)) / 12;
  const double V_z = 8.625e-3 / (4.075e-3 * 0.1);
  // Bredt: T/(2 A_m t), and less than 25 % of it more on the outer face of walls so thick.
  const double T = 1 / (2 * 0.35 * 0.55 * 0.05);
  for (const std::size_t k : {0, 1}) {
    const double side = k == 0 ? 1.0 : -1.0;
    const StressInfluence top = at_angle(walls[k].edges, 90.0).influence;
    CAPTURE(side);
    CHECK(at_angle(walls[k].edges, 90.0).y.value() == Approx(side * 0.2).epsilon(1e-12));
    CHECK(top.normal[cut_force::N] == Approx(K_g / 0.09).epsilon(1e-12));
    CHECK(top.normal[cut_force::M_z] == Approx(-side * K_g * 0.2 / I_z).epsilon(1e-12));
    const StressInfluence at_45 = at_angle(walls[k].edges, 135.0).influence;
    CHECK(at_45.normal[cut_force::V_z] == Approx(4.0 / 0.98 * V_z).epsilon(1e-9));
    // At mid-height V_y leaves the webs free of shear; the torque runs up on the left, down on the
    // right.
    CHECK(std::abs(at_45.normal[cut_force::V_y]) < 1e-9 * V_z);
    CHECK(side * at_45.normal[cut_force::T] > 4.0 / 0.98 * T);
    CHECK(side * at_45.normal[cut_force::T] < 1.3 * 4.0 / 0.98 * T);
  }
  // N, V_z and M_y as in the plane.
  const auto plane = hole_edges_of(box, {hole}, {}, hole, HoleCase::in_plane_bending);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    for (const std::size_t force : {cut_force::N, cut_force::V_z, cut_force::M_y}) {
      CHECK(walls[0].edges[i].influence.normal[force] ==
            Approx(plane[i].influence.normal[force]).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("a hole in a flange is a hole in the web of the box turned by 90 degrees") {
  // Turned, y becomes z and z becomes -y: the left web of the one is the top flange of the other,
  // and along it +z is -y.
  const Section upright{symmetric_box(m(0.16), m(0.24), m(0.008), m(0.006)), {}};
  const Section turned{symmetric_box(m(0.24), m(0.16), m(0.006), m(0.008)), {}};
  const Hole in_web = web_hole(0.05, 0.0), in_flange = flange_hole(0.05, 0.0);
  const auto webs = holes_in_walls_of(upright, {in_web}, {}, in_web);
  const auto flanges = holes_in_walls_of(turned, {in_flange}, {}, in_flange);
  REQUIRE(flanges.size() == 2);
  CHECK(flanges[0].side == "+z");
  for (const std::size_t wall : {0, 1}) {
    for (std::size_t i = 0; i < webs[wall].edges.size(); ++i) {
      const auto& web = webs[wall].edges[i].influence.normal;
      // theta counts from +x towards +y in the flange: the other way round.
      const auto& mirrored = flanges[wall].edges[(120 - i) % 120].influence.normal;
      const auto same = [](double value) { return Approx(value).epsilon(1e-9).margin(1e-6); };
      CHECK(mirrored[cut_force::N] == same(web[cut_force::N]));
      // The walls' own torsion counts the corners to the flanges: of order (t/b)^3.
      CHECK(mirrored[cut_force::T] == same(web[cut_force::T]).epsilon(1e-4));
      // V_z becomes -V_y, M_y puts +z in tension and then -y, as M_z does; M_z puts -y in tension
      // and then -z, as -M_y does.
      CHECK(mirrored[cut_force::V_y] == same(-web[cut_force::V_z]));
      CHECK(mirrored[cut_force::V_z] == same(web[cut_force::V_y]));
      CHECK(mirrored[cut_force::M_z] == same(web[cut_force::M_y]));
      CHECK(mirrored[cut_force::M_y] == same(-web[cut_force::M_z]));
    }
  }
}

TEST_CASE("two holes in a flange are looked at in each of four places") {
  const Hole hole = flange_hole(0.04, 0.08);
  const auto walls = holes_in_walls_of(box, {hole}, {}, hole);
  REQUIRE(walls.size() == 4);
  const double a = 0.04 / 0.15;
  const double K_g = membrane_concentration(a) / (1 - a);
  const double I_z = (0.6 * std::pow(0.4, 3) - 0.5 * std::pow(0.3, 3)) / 12;
  for (const auto& [k, side, y, z] : {std::tuple{0, "+z +y", 0.08, 0.3},
                                      {1, "+z -y", -0.08, 0.3},
                                      {2, "-z +y", 0.08, -0.3},
                                      {3, "-z -y", -0.08, -0.3}}) {
    const HoleInWall& wall = walls[static_cast<std::size_t>(k)];
    CHECK(wall.side == side);
    // The mean of both edges is K_g times the stress at the centre; the gradient drops out.
    const auto& one = at_angle(wall.edges, 90.0).influence.normal;
    const auto& other = at_angle(wall.edges, 270.0).influence.normal;
    CHECK(0.5 * (one[cut_force::M_z] + other[cut_force::M_z]) ==
          Approx(-K_g * y / I_z).epsilon(1e-12));
    CHECK(0.5 * (one[cut_force::M_y] + other[cut_force::M_y]) ==
          Approx(K_g * z / 4.075e-3).epsilon(1e-12));
  }
}

TEST_CASE("holes in space are known in boxes and rectangular tubes, by their own cases") {
  const Section solid{Plate{m(0.05), m(0.2)}, {}};
  CHECK_FALSE(unknown_hole_stress_of(box, HoleCase::in_plane_bending));
  CHECK(unknown_hole_stress_of(box, HoleCase::published_exponential));
  CHECK(unknown_hole_stress_of(solid, HoleCase::in_plane_bending));
  CHECK(unknown_hole_stress_of(solid, HoleCase::out_of_plane_bending));
}

}  // namespace hole_concentration_test
