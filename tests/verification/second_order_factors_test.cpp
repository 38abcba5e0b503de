// A load factor and a safety factor that is asked for are the loads times them, where second order
// makes effects grow faster than loads: members, deflections, limits of theory; and what vibrates.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"

namespace second_order_factors_test {

using namespace boxbeam;

namespace {

/// Box 200 x 100 x 6, b and h its outer sizes.
struct Box {
  double b, h, t;

  double area() const { return b * h - (b - 2.0 * t) * (h - 2.0 * t); }
  double second_moment() const {
    return (b * std::pow(h, 3) - (b - 2.0 * t) * std::pow(h - 2.0 * t, 3)) / 12.0;
  }
  double critical(double L) const {
    return std::pow(std::numbers::pi / L, 2) * 210e9 * second_moment();
  }
};
constexpr Box flat{0.2, 0.1, 0.006};

std::string section(const Box& of) {
  return fmt::format(
      "[sections.s]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\nflange = \"{} mm\"\n"
      "web = \"{} mm\"\n",
      1e3 * of.b, 1e3 * of.h, 1e3 * of.t, 1e3 * of.t);
}

std::string beam(double L, const char* held) {
  return fmt::format(
      "[beam]\n{}density = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"{} m\"\nsection = \"s\"\n"
      "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"{} m\"\ninto = \"webs\"\n",
      held, L, L);
}

/// How loads are asked to be borne: times a load factor, by a safety factor, or larger themselves.
struct Asked {
  double loads = 1.0, load_factor = 1.0, required = 1.0;
};

std::string demands(const Asked& of) {
  return fmt::format(
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = {}\n[[situations]]\nname = \"a\"\n"
      "load_factor = {}\n",
      of.required, of.load_factor);
}

/// A beam on two pins in the plane, 6 m, pressed by P and loaded across by Q in its middle.
std::string in_the_plane(double P, double Q, const Asked& of) {
  return "[case]\nname = \"a\"\nkind = \"planar\"\n[mechanism]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[bodies.b]\npoints = { A = [\"0 m\", \"0 m\"], "
         "M = [\"3 m\", \"0 m\"], B = [\"6 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] }\n"
         "[joints.A]\nkind = \"pin\"\nconnect = [\"b.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
         "[joints.B]\nkind = \"pin in slot\"\npoint = \"b.B\"\nthrough = [\"6 m\", \"0 m\"]\n"
         "direction = \"0 deg\"\n[forces.P]\nkind = \"force\"\npoint = \"b.B\"\n"
         "direction = \"180 deg\"\n" +
         fmt::format("size = \"{:.17g} kN\"\n", of.loads * P) +
         "[forces.Q]\nkind = \"force\"\npoint = \"b.M\"\ndirection = \"-90 deg\"\n" +
         fmt::format("size = \"{:.17g} kN\"\n[motion]\nduration = \"1 s\"\n", of.loads * Q) +
         section(flat) + beam(6.0, "body = \"b\"\n") + demands(of);
}

/// The same by given loads.
std::string given(const Box& box, double L, double P, double Q, const Asked& of) {
  return "[case]\nname = \"a\"\nkind = \"loads\"\n" + section(box) + beam(L, "") +
         fmt::format(
             "[loads.A]\nstation = \"0 m\"\nforce = [\"{0:.17g} kN\", \"0 kN\", "
             "\"{1:.17g} kN\"]\n[loads.Q]\nstation = \"{3} m\"\nforce = [\"0 kN\", "
             "\"0 kN\", \"{2:.17g} kN\"]\n[loads.B]\nstation = \"{4} m\"\n"
             "force = [\"{5:.17g} kN\", \"0 kN\", \"{1:.17g} kN\"]\n",
             of.loads * P, 0.5 * of.loads * Q, -of.loads * Q, 0.5 * L, L, -of.loads * P) +
         fmt::format(
             "[[beam.restraints]]\nstation = \"0 m\"\n{0}[[beam.restraints]]\n"
             "station = \"{1} m\"\n{0}",
             "holds = [\"along y\", \"along z\", \"turning over\"]\n", L) +
         demands(of);
}

Verification verified(const std::string& text) { return verify(parse_project("c.toml", text)); }

double use_of(const Verification& of, Criterion criterion) {
  const CheckResult* const result = of.governing(criterion);
  REQUIRE(result != nullptr);
  return result->check.utilisation();
}

/// N/(chi A f_y) + M/(W f_y), M = Q L/4 grown by 1/(1 - N/N_cr), all under `factor` times the
/// loads.
double member_by_hand(const Box& box, double L, double P, double Q, double factor) {
  const double N = factor * P * 1e3, N_y = box.area() * 355e6, N_cr = box.critical(L);
  const double M = factor * Q * 1e3 * L / 4.0, W = box.second_moment() / (0.5 * box.h);
  return N / (test::chi_of(std::sqrt(N_y / N_cr)) * N_y) + M / (W * 355e6) / (1.0 - N / N_cr);
}

}  // namespace

// tan(u)/u, u = pi/2 sqrt(N/N_cr), times the moment of a force in the middle. Source: Timoshenko,
// Gere, Theory of Elastic Stability (1961), equation 1-12.
TEST_CASE("what presses a beam for a moment bends it, much or little, as it does at its highest",
          "[second_order]") {
  // Up and down once a second: at a tenth of what a member feels fewer instants are looked at.
  for (const double part : {0.002, 0.2}) {
    CAPTURE(part);
    const double P = part * flat.critical(6.0) / 1e3, Q = 3.0;
    std::string text = in_the_plane(P, Q, {});
    const std::string size = fmt::format("size = \"{:.17g} kN\"", P);
    const std::size_t at = text.find(size);
    REQUIRE(at != std::string::npos);
    text.replace(
        at, size.size(),
        fmt::format("law = {{ kind = \"harmonic\", mean = \"0 kN\", amplitude = \"{:.17g} kN\", "
                    "frequency = \"1 Hz\", phase = \"37 deg\" }}",
                    P));
    const Project project = parse_project("c.toml", text);
    const SecondOrderEstimate found = estimate_second_order(project, run_situations(project, {}));
    // Shear makes it more, by no more than N_cr/(G A) of the webs. Source: the same, section 2.17.
    const double webs = 2.0 * flat.t * (flat.h - 2.0 * flat.t);
    CHECK(found.in_plane.part > part);
    CHECK(found.in_plane.part < part * (1.0 + flat.critical(6.0) / (80e9 * webs)));
    const double u = 0.5 * std::numbers::pi * std::sqrt(part);
    const double M = 0.25 * Q * 1e3 * 6.0, grown = M * std::tan(u) / u;
    const double W = flat.second_moment() / (0.5 * flat.h);
    const double highest = P * 1e3 / flat.area() + grown / W;
    REQUIRE(found.change);
    CHECK(*found.change >= (grown - M) / W / highest * 0.97);
  }
}

TEST_CASE("a load factor and a required factor are the loads times them in a member's check",
          "[second_order]") {
  constexpr double f = 1.8, P = 100.0, Q = 3.0;
  const double by_hand = member_by_hand(flat, 6.0, P, Q, f);
  CHECK(by_hand > 1.0);
  for (const Asked& of : {Asked{f, 1.0, 1.0}, Asked{1.0, f, 1.0}, Asked{1.0, 1.0, f},
                          Asked{1.0, std::sqrt(f), std::sqrt(f)}}) {
    CAPTURE(of.loads, of.load_factor, of.required);
    for (const std::string& text :
         {in_the_plane(P, Q, of),
          given(flat, 6.0, 0.3 * P, 1.3 * Q, {f * of.loads / f, of.load_factor, of.required})}) {
      const Verification verification = verified(text);
      const bool plane = text.find("planar") != std::string::npos;
      const double hand = plane ? by_hand : member_by_hand(flat, 6.0, 0.3 * P, 1.3 * Q, f);
      CHECK(use_of(verification, Criterion::member) == Approx(hand).epsilon(5e-3));
    }
    CHECK(verified(in_the_plane(P, Q, of)).verdict == Verdict::fail);
  }
}

TEST_CASE(
    "whether a member may buckle and theory of the first order holds is asked of its design loads",
    "[second_order]") {
  // N/N_cr = 0.04 is 13.8 kN, 0.1 is 34.5 kN.
  const double N_cr = 1e-3 * flat.critical(6.0);
  const auto counts = [](const Verification& of) {
    return of.governing(Criterion::member) != nullptr;
  };
  for (const Asked& of : {Asked{2.0}, Asked{1.0, 2.0}, Asked{1.0, 1.0, 2.0}}) {
    CHECK(counts(verified(given(flat, 6.0, 0.021 * N_cr, 1.0, of))));
    CHECK_FALSE(counts(verified(given(flat, 6.0, 0.019 * N_cr, 1.0, of))));
  }
}

TEST_CASE("stress under second order of loads times one is no proof of stress under design loads",
          "[second_order]") {
  // Of a force in the middle M = Q L/4 tan(u)/u, u = pi/2 sqrt(N/N_cr) (Timoshenko, Gere, 1.3).
  constexpr double P = 150.0, f = 2.0;
  const Verification times = verified(in_the_plane(P, 1.0, {1.0, f, 1.0}));
  CHECK(times.verdict != Verdict::pass);
  CHECK(verified(in_the_plane(P, 1.0, {f, 1.0, 1.0})).verdict != Verdict::pass);
  const auto bent = [](double part) {
    const double u = 0.5 * std::numbers::pi * std::sqrt(part);
    return 1e3 * 6.0 / 4.0 / (flat.second_moment() / (0.5 * flat.h)) * std::tan(u) / u;
  };
  const double n = P * 1e3 / flat.critical(6.0), axial = P * 1e3 / flat.area();
  const double grows = second_order_growth_at(times.model.second_order, si<Length>(3.0), false);
  CHECK(1.0 + grows == Approx((axial + bent(f * n)) / (axial + bent(n))).epsilon(0.03));
}

TEST_CASE("a deflection times its load factor is that of the loads times it", "[second_order]") {
  constexpr double f = 1.5;
  const std::string limit = "[deflection]\nlimit = \"25 mm\"\nload_factor = true\n";
  const Verification times = verified(in_the_plane(100.0, 3.0, {1.0, f, 1.0}) + limit);
  const Verification larger = verified(in_the_plane(100.0, 3.0, {f, 1.0, 1.0}) + limit);
  CHECK(use_of(times, Criterion::deflection) ==
        Approx(use_of(larger, Criterion::deflection)).epsilon(5e-3));
  // P L^3/(48 E I)/(1 - N/N_cr), shear aside.
  const double n = f * 100e3 / flat.critical(6.0);
  const double w = f * 3e3 * 216.0 / (48.0 * 210e9 * flat.second_moment()) / (1.0 - n);
  CHECK(use_of(times, Criterion::deflection) == Approx(w / 0.025).epsilon(0.02));
}

TEST_CASE("given loads deflect a compressed beam by 1/(1 - N/N_cr) more", "[second_order]") {
  constexpr Box stout{0.2, 0.1, 0.012};
  const std::string limit =
      "[deflection]\nagainst = \"chord\"\nfrom = \"0 m\"\nto = \"4 m\"\nlimit = \"1.4 mm\"\n";
  const auto use = [&](double P) {
    return use_of(verified(given(stout, 4.0, P, 2.0, {}) + limit), Criterion::deflection);
  };
  const double N_cr = 1e-3 * stout.critical(4.0);
  const double straight = use(0.0);
  // Shear, which makes N_cr 0.2 % less, aside.
  for (const double part : {0.03, 0.097})
    CHECK(use(part * N_cr) / straight == Approx(1.0 / (1.0 - part)).epsilon(1e-3));
  CHECK(use(-0.097 * N_cr) == Approx(straight).epsilon(1e-9));
}

TEST_CASE(
    "compression makes elastic links softer, and near a resonance that is far more than statics",
    "[second_order]") {
  // A clamped link, f_1 = 3.516/(2 pi) sqrt(EI/(m L^4)), pressed by a force along it: f_1^2 becomes
  // f_1^2 (1 - N/N_cr) within 1 % (Timoshenko, Young, Weaver, section 5.12).
  constexpr Box box{0.15, 0.15, 0.008};
  constexpr double L = 3.0, f = 17.3, N = 82e3, zeta = 0.005;
  const double EI = 210e9 * box.second_moment(), mass = 7850.0 * box.area();
  const double f_1 = 3.516 / (2.0 * std::numbers::pi) * std::sqrt(EI / (mass * std::pow(L, 4)));
  const double n = N / (0.25 * box.critical(L));
  CHECK(n == Approx(0.093).epsilon(5e-3));
  const auto amplification = [&](double frequency) {
    const double r = f / frequency;
    return 1.0 / std::hypot(1.0 - r * r, 2.0 * zeta * r);
  };
  const auto pressed = [&](double kN) {
    return "[case]\nname = \"a\"\nkind = \"flexible\"\n[mechanism]\n"
           "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[motion]\nfrequency = \"17.3 Hz\"\n[model]\n"
           "damping = { ratio = 0.005, at = \"17.3 Hz\" }\n[links.boom]\nkind = \"bending\"\n"
           "origin = [\"0 m\", \"0 m\"]\nangle = \"0 deg\"\nparts = 8\n[joints.foot]\n"
           "kind = \"revolute\"\nconnect = [\"boom.start\", \"ground\"]\nstiffness = \"rigid\"\n"
           "turning_stiffness = \"rigid\"\n[loads.s]\non = \"boom.end\"\n"
           "amplitude_force = [\"0 N\", \"1.5 kN\"]\n" +
           fmt::format("force = [\"{} kN\", \"0 kN\"]\n", kN) + section(box) +
           beam(L, "link = \"boom\"\n") + demands({});
  };
  const Verification free = verified(pressed(0.0));
  CHECK(free.verdict == Verdict::pass);
  const Verification under = verified(pressed(-1e-3 * N));
  CHECK(under.verdict != Verdict::pass);
  // Nearly all of the range is the first mode's, whose frequency is known to 0.2 %.
  const double grown = amplification(f_1 * std::sqrt(1.0 - n)) / amplification(f_1);
  CHECK(1.0 + second_order_growth_at(under.model.second_order, Length{}, true) ==
        Approx(grown).epsilon(0.1));
}

TEST_CASE("a member that bends about both axes is the same beam turned by a right angle",
          "[second_order]") {
  // Sum of N/(chi A f_y), M_y/(W_y f_y)/(1 - n_z) and M_z/(W_z f_y)/(1 - n_y).
  const auto turned = [](bool upright) {
    const Box box = upright ? Box{0.12, 0.2, 0.006} : Box{0.2, 0.12, 0.006};
    const auto support = [&](const char* name, const char* at, const char* kind, const char* more) {
      return fmt::format("[supports.{}]\nkind = \"{}\"\nat = \"{}\"\n{}", name, kind, at, more);
    };
    return "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\nspace = true\n"
           "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
           section(box) + beam(6.0, "") + support("a", "0 m", "pinned", "fork = true\n") +
           support("b", "6 m", "roller", "fork = true\ndirection = \"z\"\n") +
           support("c", "6 m", "roller", "direction = \"y\"\n") +
           "[loads.P]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"-40 kN\", \"0 kN\", \"0 kN\"]\n"
           "[loads.Q]\nkind = \"force\"\nat = \"3 m\"\nforce = " +
           (upright ? "[\"0 kN\", \"-16 kN\", \"-1 kN\"]\n"
                    : "[\"0 kN\", \"-1 kN\", \"-16 kN\"]\n") +
           "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
  };
  const double lying = use_of(verified(turned(false)), Criterion::member);
  const double upright = use_of(verified(turned(true)), Criterion::member);
  CHECK(lying == Approx(upright).epsilon(5e-3));
  const Box weak{0.2, 0.12, 0.006}, strong{0.12, 0.2, 0.006};
  const double one = member_by_hand(weak, 6.0, 40.0, 16.0, 1.0);
  const double other = 1e3 * 6.0 / 4.0 / (strong.second_moment() / 0.1 * 355e6) /
                       (1.0 - 40e3 / strong.critical(6.0));
  CHECK(upright == Approx(one + other).epsilon(1e-2));
}

}  // namespace second_order_factors_test
