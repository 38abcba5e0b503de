#include "boxbeam/strength/member_buckling.hpp"

#include <cmath>
#include <utility>

#include "boxbeam/core/derivation.hpp"
#include "catch.hpp"
#include "support/uniform.hpp"

namespace member_buckling_test {

using namespace boxbeam;

TEST_CASE("a member under compression and bending, by hand") {
  // N = 0.2 A f_y = 0.16 N_cr, M = 0.3 W f_y: lambda = sqrt(0.8) = 0.8944, curve c: phi = 0.5 (1 +
  // 0.49 0.6944 + 0.8) = 1.0701, chi = 1/(1.0701 + sqrt(1.1451 - 0.8)) = 0.6033; 0.2/0.6033 =
  // 0.3315.
  const MemberLoad load{0.2, 0.3, 0.16};
  CHECK(flexural_use(load, BucklingCurve::c, 1.0) == Approx(0.6315).margin(1e-4));
  CHECK(flexural_use(load, BucklingCurve::c, 1.1) == Approx(1.1 * 0.6315).margin(1e-4));
  // Turning over: alpha_ult = 2, lambda = sqrt(2 0.16) = 0.5657, curve d: phi = 0.5 (1 + 0.76
  // 0.3657 + 0.32) = 0.7990, chi = 1/(0.7990 + sqrt(0.6383 - 0.32)) = 0.7335: 0.5/0.7335 = 0.6817.
  CHECK(lateral_use(load, BucklingCurve::d, 1.0) == Approx(0.6817).margin(2e-4));
}

TEST_CASE("equations 6.61 and 6.62 by hand") {
  // n = 0.2, N/N_cr,y = 0.16, N/N_cr,z = 0.05; m_y = 0.25, m_z = 0.1, gamma_M1 = 1.1. As above
  // chi_y = 0.6033 at lambda_y = 0.8944, n_y = 1.1 0.2/0.6033 = 0.3647, k_yy = 1 + 0.6 0.8944
  // 0.3647 = 1.1957. lambda_z = 0.5: phi = 0.5 (1 + 0.49 0.3 + 0.25) = 0.6985, chi_z = 1/(0.6985 +
  // sqrt(0.4879 - 0.25)) = 0.8430, n_z = 0.2610, k_zz = 1 + 0.6 0.5 0.2610 = 1.0783.
  MemberLoad load{0.2, 0.0, 0.16};
  MemberLoad::Straight& of = load.straight;
  of.m_y = 0.25;
  of.m_z = 0.1;
  of.other = 0.05;
  const auto use = [&] { return flexural_use(load, BucklingCurve::c, 1.1); };
  // 0.3647 + 1.1 (1.1957 0.25 + 1.0783 0.1) = 0.8121.
  CHECK(use() == Approx(0.8121).margin(2e-4));
  // The bent beam counts where it is bent more.
  load.bent = 0.45;
  CHECK(use() == Approx(0.3647 + 1.1 * 0.45).margin(2e-4));
  load.bent = 0.35;
  // C_my = 0.6: 0.3647 + 1.1 max(0.35, 0.6 0.2989 + 0.1078) = 0.7497.
  of.C_my = 0.6;
  CHECK(use() == Approx(0.7497).margin(2e-4));
  of.C_my = 1.0;
  // M_y/M_cr = 0.09: lambda_LT = 0.6, curve d: phi = 0.5 (1 + 0.76 0.4 + 0.36) = 0.8320, chi_LT =
  // 1/(0.8320 + sqrt(0.6922 - 0.36)) = 0.7100: 0.3647 + 1.1 (0.2989/0.7100 + 0.1078) = 0.9464.
  of.turning = 0.09;
  CHECK(use() == Approx(0.9464).margin(2e-4));
  of.turning = 0.04;
  CHECK(use() == Approx(0.8121).margin(2e-4));
  // In the other plane N/N_cr is too little to count: chi_z = 1, lambda_z = sqrt(0.03/0.2) =
  // 0.3873, k_zz = 1 + 0.6 0.3873 0.22 = 1.0511.
  of.other = 0.03;
  CHECK(use() == Approx(0.3647 + 1.1 * (0.2989 + 0.1051)).margin(2e-4));
  // Across, 6.62: 0.2610 + 1.1 (0.8 1.1957 0.25 + 1.0783 0.1) = 0.6426; of open walls k_zy = 1.
  load.critical = 0.05;
  load.bent = 0.0;
  of.other = 0.16;
  of.about_z = true;
  CHECK(use() == Approx(0.6426).margin(2e-4));
  of.twists = true;
  CHECK(use() == Approx(0.6546).margin(2e-4));
  // What is printed is what counts.
  for (const bool twists : {false, true})
    for (const bool about_z : {false, true}) {
      of.twists = twists;
      of.about_z = about_z;
      of.turning = 0.09;
      Derivation steps;
      CHECK(derive_flexural_use(steps, load, BucklingCurve::c, 1.1).value() ==
            Approx(use()).epsilon(1e-14));
    }
}

// Invariant: the letters of the axes are of no matter.
TEST_CASE("a member that lies is used as one that stands") {
  test::Uniform in(90);
  for (int i = 0; i < 2000; ++i) {
    MemberLoad stands{in(0.001, 1.0), in(0.0, 1.0), in(0.001, 0.99)};
    MemberLoad::Straight& of = stands.straight;
    of = {i % 2 == 0,    i % 3 == 0,    false,        in(0.0, 1.0), in(0.0, 1.0),
          in(0.0, 0.99), in(0.0, 0.99), in(0.4, 1.0), in(0.4, 1.0)};
    MemberLoad lies = stands;
    lies.straight.lies = true;
    lies.straight.about_z = !of.about_z;
    std::swap(lies.straight.m_y, lies.straight.m_z);
    std::swap(lies.straight.C_my, lies.straight.C_mz);
    CAPTURE(i);
    CHECK(flexural_use(lies, BucklingCurve::c, 1.1) ==
          Approx(flexural_use(stands, BucklingCurve::c, 1.1)).epsilon(1e-14));
    Derivation steps;
    CHECK(derive_flexural_use(steps, lies, BucklingCurve::c, 1.1).value() ==
          Approx(flexural_use(lies, BucklingCurve::c, 1.1)).epsilon(1e-14));
  }
}

TEST_CASE("equations 6.61 and 6.62 never give less for more of anything") {
  // What lets the largest of each term stand for all places and instants; by the curves of members.
  test::Uniform in(662);
  for (int i = 0; i < 20000; ++i) {
    MemberLoad load{in(0.001, 1.0), in(0.0, 1.0), in(0.001, 0.99)};
    MemberLoad::Straight& of = load.straight;
    of = {i % 2 == 0,   i % 3 == 0,    i % 5 < 2,    in(0.0, 1.0),
          in(0.0, 1.0), in(0.0, 0.99), in(0.0, 0.99)};
    of.C_my = in(0.4, 1.0);
    of.C_mz = in(0.4, 1.0);
    CAPTURE(i, load.compressed, load.critical, of.other, of.turning);
    const auto use = [](const MemberLoad& by, BucklingCurve curve) {
      return flexural_use(by, curve, 1.1);
    };
    for (const BucklingCurve curve : {BucklingCurve::c, BucklingCurve::d}) {
      const double before = use(load, curve);
      // Never milder than without them.
      MemberLoad bent_alone = load;
      bent_alone.straight = {};
      CHECK(before >= use(bent_alone, curve));
      const auto grows = [&](auto&& change) {
        MemberLoad more = load;
        change(more);
        return use(more, curve) >= before * (1.0 - 1e-12);
      };
      CHECK(grows([](MemberLoad& more) { more.compressed *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.critical *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.bent *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.straight.m_y *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.straight.m_z *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.straight.other *= 1.02; }));
      CHECK(grows([](MemberLoad& more) { more.straight.turning *= 1.02; }));
    }
  }
}

TEST_CASE("a published column: chi = 0.878, 2297 kN") {
  // xcfem/xc, verif/tests/materials/ec3/test_buckling_resistance_02.py: CHS 244.5 x 10, S355, 4 m,
  // curve a. A = 73.67 cm^2, I = 5073 cm^4: N_cr = 6571 kN.
  const double pi = 3.14159265358979323846;
  const double A = pi / 4.0 * (0.2445 * 0.2445 - 0.2245 * 0.2245);
  const double I = pi / 64.0 * (std::pow(0.2445, 4) - std::pow(0.2245, 4));
  const double N_cr = pi * pi * 210e9 * I / 16.0, N = 2297e3;
  const MemberLoad load{N / (A * 355e6), 0.0, N / N_cr};
  CHECK(flexural_use(load, BucklingCurve::a, 1.0) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("where other bodies are compressed the beam's bending counts, and its sheet is finite") {
  // N/N_cr of the mechanism, none of it in the beam.
  const MemberLoad load{0.0, 0.3, 0.16};
  CHECK(flexural_use(load, BucklingCurve::c, 1.1) == Approx(1.1 * 0.3));
  Derivation steps;
  CHECK(derive_flexural_use(steps, load, BucklingCurve::c, 1.1).value() == Approx(1.1 * 0.3));
  for (const DerivationStep& step : steps.steps()) CHECK(std::isfinite(step.value.value()));
}

TEST_CASE("properties of members that hold for every load") {
  test::Uniform in(11);
  for (int i = 0; i < 2000; ++i) {
    const MemberLoad load{in(0.0, 1.0), in(0.0, 1.0), in(0.001, 0.99)};
    CAPTURE(i, load.compressed, load.bent, load.critical);
    const double f = in(0.1, 5.0);
    const MemberLoad more{f * load.compressed, f * load.bent, f * load.critical};
    for (const auto& use : {flexural_use, lateral_use}) {
      const double of = use(load, BucklingCurve::c, 1.0);
      // Linear where all grow alike; never less than yielding; never less for more of anything.
      CHECK(use(more, BucklingCurve::c, 1.0) == Approx(f * of).epsilon(1e-12));
      CHECK(of >= (load.compressed + load.bent) * (1.0 - 1e-12));
      MemberLoad other = load;
      other.compressed *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      other = load;
      other.bent *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      other = load;
      other.critical *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      CHECK(use(load, BucklingCurve::d, 1.0) >= of);
    }
  }
  // What does not compress bends only.
  CHECK(flexural_use({0.0, 0.4, 0.0}, BucklingCurve::c, 1.1) == Approx(0.44));
  CHECK(lateral_use({0.0, 0.0, 0.0}, BucklingCurve::d, 1.0) == 0.0);
}

}  // namespace member_buckling_test
