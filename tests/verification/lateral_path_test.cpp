// How open sections turn over: where loads act in them, where nodes lie, how they are cut.

#include <fmt/format.h>

#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace lateral_path_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace path_cases;

namespace {

/// M/M_cr of a beam of one section between forks at its ends.
double part_of(const ThinWalled& path, double length, const std::string& loads,
               const std::string& gravity = "0 m/s^2") {
  const Verification of = verified(simple_beam(length, section("a", path), segment(length, "a"),
                                               held(length, 1), loads, gravity));
  REQUIRE(of.model.second_order.lateral.has_value());
  return of.model.second_order.lateral->part;
}

}  // namespace

// Girders and Ts of plates, 8 m and 6 m between forks. Expected: Ritz, ten sines, of
//     int G I_T phi'^2 + E I_w phi''^2 + M int sigma r^2 dA/M phi'^2 - M^2 (1/(E I_z) - 1/(E I_y))
//     phi^2 - F e phi^2,
// sections by hand on mid-lines, e from the shear centre to the edge; by a script of its own.
TEST_CASE("the place of the nodes in a section changes nothing of how it turns over",
          "[lateral_path]") {
  const auto girder = [](double by, double up) {
    return path({{80, by + up * 400},
                 {0, by + up * 400},
                 {-80, by + up * 400},
                 {200, by - up * 400},
                 {0, by - up * 400},
                 {-200, by - up * 400}},
                {{0, 1, 16}, {1, 2, 16}, {1, 4, 8}, {3, 4, 25}, {4, 5, 25}}, 8.0, 12.5, 2);
  };
  const auto tee = [](double by, double up) {
    return path({{100, by}, {0, by}, {-100, by}, {0, by - up * 250}},
                {{0, 1, 15}, {1, 2, 15}, {1, 3, 12}}, 7.5, 0.0, 2);
  };
  for (const double by : {0.0, -400.0, 400.0, 37.3}) {
    CAPTURE(by);
    const auto alike = [&](const auto& made, double up, double length, double kN,
                           double close = 2e-4) {
      const std::string load = force("p", length / 2, fmt::format("[\"0 kN\", \"{} kN\"]", kN));
      CHECK(part_of(made(by, up), length, load) ==
            Approx(part_of(made(0.0, up), length, load)).epsilon(close));
    };
    alike(girder, 1.0, 8.0, -100.0);
    alike(tee, 1.0, 6.0, -10.0);
    // I_w of a T is none or round-off, by which its elements are linear or cubic.
    alike(tee, -1.0, 6.0, -10.0, 6e-3);
    const auto of = [&](const ThinWalled& section, double length, double kN) {
      return part_of(section, length,
                     force("p", length / 2, fmt::format("[\"0 kN\", \"{} kN\"]", kN)));
    };
    CHECK(of(girder(by, 1.0), 8.0, -100.0) == Approx(0.59358).epsilon(5e-3));
    // On the flange, hanging from the stem's tip, on the stem's tip.
    CHECK(of(tee(by, 1.0), 6.0, -10.0) == Approx(0.061428).epsilon(5e-3));
    CHECK(of(tee(by, 1.0), 6.0, 10.0) == Approx(0.19501).epsilon(3e-2));
    CHECK(of(tee(by, -1.0), 6.0, -10.0) == Approx(0.19501).epsilon(3e-2));
    // Upside down with its load it is the same beam.
    CHECK(of(girder(-by, -1.0), 8.0, 100.0) ==
          Approx(of(girder(by, 1.0), 8.0, -100.0)).epsilon(1e-4));
  }
}

TEST_CASE("a load along a beam turns it over as the forces that it is made of", "[lateral_path]") {
  const ThinWalled alike =
      path({{100, 300}, {0, 300}, {-100, 300}, {100, -300}, {0, -300}, {-100, -300}},
           {{0, 1, 16}, {1, 2, 16}, {1, 4, 10}, {3, 4, 16}, {4, 5, 16}}, 8.0, 8.0, 2);
  const auto line = [](double kN) {
    return fmt::format("[loads.q]\nkind = \"line\"\nforce_per_length = [\"0 N/m\", \"{} N/m\"]\n",
                       -1e3 * kN);
  };
  // The same Ritz solution: at the edge 0.67013, at the axis 0.4795.
  const double whole = part_of(alike, 8.0, line(20.0));
  CHECK(whole == Approx(0.67013).epsilon(3e-3));
  std::string points;
  for (int i = 0; i < 40; ++i)
    points += force(fmt::format("p{}", i), (i + 0.5) * 0.2, "[\"0 kN\", \"-4 kN\"]");
  CHECK(part_of(alike, 8.0, points) == Approx(whole).epsilon(1e-3));
  // As it does pulled up at the other edge.
  CHECK(part_of(alike, 8.0, line(-20.0)) == Approx(whole).epsilon(1e-4));
  // Weight acts at the centroid, here the shear centre: 9.81 m/s^2 and 7850 kg/m^3 times A.
  const double weight = 7850.0 * 9.81 * properties_of({alike, {}}).area.value();
  const double at_axis = part_of(alike, 8.0, "", "-9.81 m/s^2");
  CHECK(at_axis == Approx(0.47948 / 20e3 * weight).epsilon(3e-3));
  CHECK(part_of(alike, 8.0, line(1e-3 * weight)) > 1.3 * at_axis);
}

TEST_CASE("what rights a beam at one height does not do so at another", "[lateral_path]") {
  const ThinWalled alike =
      path({{100, 300}, {0, 300}, {-100, 300}, {100, -300}, {0, -300}, {-100, -300}},
           {{0, 1, 16}, {1, 2, 16}, {1, 4, 10}, {3, 4, 16}, {4, 5, 16}}, 8.0, 8.0, 2);
  const auto line = [](const char* name, double kN) {
    return fmt::format("[loads.{}]\nkind = \"line\"\nforce_per_length = [\"0 N/m\", \"{} N/m\"]\n",
                       name, 1e3 * kN);
  };
  const auto points = [](const std::string& name, double kN) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
      text += force(fmt::format("{}{}", name, i), (i + 0.5) * 0.2,
                    fmt::format("[\"0 kN\", \"{} kN\"]", 0.2 * kN));
    }
    return text;
  };
  // Weight of 10 kN/m, by gravity as large as that takes, against 15 kN/m that pull up at the lower
  // edge: as by forces, each of which is at its edge by itself. Of the difference at that edge less
  // than three quarters were left.
  const double mass = 7850.0 * properties_of({alike, {}}).area.value();
  const std::string gravity = fmt::format("{} m/s^2", -10e3 / mass);
  const double against = part_of(alike, 8.0, line("q", 15.0), gravity);
  CHECK(part_of(alike, 8.0, points("p", 15.0), gravity) == Approx(against).epsilon(1e-3));
  CHECK(against > 1.3 * part_of(alike, 8.0, line("q", 5.0)));
  // Two lines, each at its edge.
  const double both = part_of(alike, 8.0, line("q", 15.0) + line("r", -10.0));
  CHECK(part_of(alike, 8.0, points("p", 15.0) + points("n", -10.0)) == Approx(both).epsilon(1e-3));
  CHECK(both >= against);
}

TEST_CASE("how a beam is cut into segments changes nothing of it as a member", "[lateral_path]") {
  const ThinWalled alike =
      path({{100, 300}, {0, 300}, {-100, 300}, {100, -300}, {0, -300}, {-100, -300}},
           {{0, 1, 16}, {1, 2, 16}, {1, 4, 10}, {3, 4, 16}, {4, 5, 16}}, 8.0, 8.0, 2);
  const std::string loads =
      force("p", 1.1, "[\"0 kN\", \"-66 kN\"]") + force("n", 10.0, "[\"-200 kN\", \"0 kN\"]");
  const auto of = [&](const std::string& segments) {
    return verified(simple_beam(10.0, section("a", alike), segments, held(10.0, 1), loads));
  };
  const Verification one = of(segment(10.0, "a"));
  for (const Verification& cut : {of(segment(1.1, "a") + segment(8.9, "a")),
                                  of(segment(0.4, "a") + segment(3.3, "a") + segment(6.3, "a"))}) {
    CHECK(cut.model.second_order.lateral->part ==
          Approx(one.model.second_order.lateral->part).epsilon(1e-3));
    CHECK(cut.model.second_order.bending == Approx(one.model.second_order.bending).epsilon(1e-4));
    CHECK(use_of(cut, "member-buckling/sideways") ==
          Approx(use_of(one, "member-buckling/sideways")).epsilon(1e-3));
  }
  // By hand: M = P a b/L over W f_y, at the force, grown by N/N_cr.
  const double W = properties_of({alike, {}}).W_y.value();
  CHECK(one.model.second_order.bending >= 66e3 * 1.1 * 8.9 / 10.0 / W / 355e6 * (1.0 - 1e-6));
}

TEST_CASE("E I_w ends where a section meets its mirror image", "[lateral_path]") {
  const auto channel = [](double t, double width) {
    return path({{width, 145}, {0, 145}, {0, -145}, {width, -145}},
                {{0, 1, t}, {1, 2, 8}, {2, 3, t}});
  };
  const std::string turn = force("m1", 0.0, "[\"0 kN\", \"0 kN\"]", "-20 kN m") +
                           force("m2", 6.0, "[\"0 kN\", \"0 kN\"]", "20 kN m");
  const auto of = [&](const ThinWalled& a, const ThinWalled& b) {
    const Verification verification =
        verified(simple_beam(6.0, section("a", a) + section("b", b),
                             segment(3.0, "a") + segment(3.0, "b"), held(6.0, 1), turn));
    return verification.model.second_order.lateral->part;
  };
  const double whole = part_of(channel(10, 100), 6.0, turn);
  CHECK(of(channel(10, 100), channel(10, 100)) == Approx(whole).epsilon(1e-4));
  // As where its width differs by a hundredth of a millimetre, by which I_w no longer is the same.
  const double mirrored = of(channel(10, 100), channel(10, -100));
  CHECK(mirrored == Approx(of(channel(10, 100), channel(10, -100.01))).epsilon(1e-3));
  CHECK(mirrored > 1.05 * whole);
}

}  // namespace lateral_path_test
