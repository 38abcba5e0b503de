// What diaphragms make of slender webs: panels, rigid end posts, and where there are none.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"
#include "support/slender_cases.hpp"
#include "support/uniform.hpp"

namespace diaphragm_panels_test {

using namespace boxbeam;
using namespace slender_cases;

namespace {

/// The web at a station of a case.
ShearedPlate web_at(const std::string& text, const Station& station) {
  const Project project = parse_project("slender.toml", text);
  const auto plates = slender_plates_at(project, {}, station);
  REQUIRE(plates != nullptr);
  for (const ShearedPlate& plate : plates->sheared)
    if (!is_flange(plate.plate)) return plate;
  FAIL("no web");
  return {};
}

}  // namespace

TEST_CASE("diaphragms make panels of a web, and two at each end rigid end posts", "[plates]") {
  const auto resistance = [](const std::vector<double>& at, double thickness, double opening) {
    return shear_resistance_in(verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                   segment(9.6, "a") + diaphragms(at, thickness, opening), tip(9.6, -400.0))));
  };
  // Web 1200 x 8, S355, a = 3 m: k_tau = 5.34 + 4 (1.2/3)^2 = 5.98, lambda_w = 2.016; 810 kN, with
  // rigid end posts 993 kN, by hand.
  CHECK(resistance({0.0, 3.0, 6.0, 9.0, 9.6}, 10.0, 0.0) == Approx(810e3).epsilon(1e-3));
  const std::vector<double> posts{0.0, 0.3, 3.3, 6.3, 9.3, 9.6};
  CHECK(resistance(posts, 10.0, 0.0) == Approx(993e3).epsilon(1e-3));
  // 4 h_w t^2/e = 1024 mm^2; 15 eps t_d^2 = 1220 mm^2 of 10 mm, 781 mm^2 of 8 mm; beside an access
  // hole of 460 mm 62 mm are left.
  CHECK(resistance(posts, 8.0, 0.0) == Approx(810e3).epsilon(1e-3));
  CHECK(resistance(posts, 10.0, 460.0) == Approx(810e3).epsilon(1e-3));
  // 42 mm beside one of 500 mm are too weak to bound panels: 10 x 42^3/12 + 1642 x 420/2062 x 25^2
  // = 271e3 mm^4, 0.75 x 1200 x 512 = 461e3 are asked for.
  CHECK(resistance(posts, 10.0, 500.0) == Approx(810e3 * std::sqrt(5.34 / 5.98)).epsilon(1e-3));
  // Only at one end.
  CHECK(resistance({0.0, 0.3, 3.3, 6.3, 9.3}, 10.0, 0.0) < 811e3);
  // Beyond the last diaphragm nothing shortens the panel: k_tau = 5.34.
  CHECK(resistance({0.0, 3.0, 6.0}, 10.0, 0.0) ==
        Approx(810e3 * std::sqrt(5.34 / 5.98)).epsilon(1e-3));
}

TEST_CASE("a panel that tapers is judged by the depth at each place, on both sides of a diaphragm",
          "[plates]") {
  const std::string text =
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0) + box("b", 600.0, 824.0, 12.0, 8.0),
                 taper(6.0, "a", "b") + diaphragms({0.0, 4.0, 6.0}), tip(6.0, -400.0));
  const auto slenderness = [](double depth, double length) {
    const double ratio = depth / length;
    const double k = ratio <= 1.0 ? 5.34 + 4.0 * ratio * ratio : 4.0 + 5.34 * ratio * ratio;
    return depth / 8.0 / (37.4 * std::sqrt(235.0 / 355.0) * std::sqrt(k));
  };
  const ShearedPlate shallow = web_at(text, {4.5 * metre});
  CHECK(shallow.panel.depth.value() == Approx(0.9));
  CHECK(shallow.resists.lambda_w == Approx(slenderness(900.0, 2000.0)).epsilon(1e-9));
  CHECK(shallow.resists.resistance.value() ==
        Approx(0.83 / slenderness(900.0, 2000.0) * 355e6 / std::sqrt(3.0) * 0.9 * 0.008)
            .epsilon(1e-9));
  const double deep = 1200.0 - 400.0 * 4.0 / 6.0;
  CHECK(web_at(text, {0.0 * metre}).resists.lambda_w ==
        Approx(slenderness(1200.0, 4000.0)).epsilon(1e-9));
  CHECK(web_at(text, {4.0 * metre, Side::before}).resists.lambda_w ==
        Approx(slenderness(deep, 4000.0)).epsilon(1e-9));
  CHECK(web_at(text, {4.0 * metre, Side::behind}).resists.lambda_w ==
        Approx(slenderness(deep, 2000.0)).epsilon(1e-9));
  // Without a side that of both together.
  CHECK(web_at(text, {4.0 * metre}).resists.lambda_w ==
        Approx(slenderness(deep, 6000.0)).epsilon(1e-9));
}

TEST_CASE("one more diaphragm never takes from a beam, a panel that is longer gives nothing",
          "[plates]") {
  test::Uniform in(11);
  for (int i = 0; i < 10; ++i) {
    const std::string sections =
        box("a", 600.0, in(900.0, 1300.0), 12.0, 8.0) + box("b", 600.0, 700.0, 12.0, 8.0);
    const double force = -in(200.0, 500.0);
    std::vector<double> at;
    double before = 1e9;
    for (int k = 0; k < 4; ++k) {
      const double use = use_of(
          verified(cantilever(sections, taper(8.0, "a", "b") + diaphragms(at), tip(8.0, force))),
          Criterion::shear_buckling);
      CHECK(use <= before * (1.0 + 1e-9));
      before = use;
      at.push_back(in(0.5, 7.5));
    }
  }
}

TEST_CASE("diaphragms that cannot be are refused", "[plates]") {
  const auto said = [](const std::string& more) {
    return test::refusal_of([&] {
      return parse_project("slender.toml", cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                                                      segment(6.0, "a") + more, tip(6.0, -400.0)));
    });
  };
  CHECK(said(diaphragms({0.0, 6.0})).empty());
  CHECK(said(diaphragms({3.0, 3.0})).find("there is already a diaphragm at this station") !=
        std::string::npos);
  CHECK(said(diaphragms({3.0}, 10.0, 600.0)).find("the access hole is as wide as the beam") !=
        std::string::npos);
  CHECK(said(diaphragms({6.5})).find("lies behind the end of the beam") != std::string::npos);
}

TEST_CASE("a flat that ends inside a panel holds nothing of it: no verdict", "[plates]") {
  const auto with = [](const std::vector<double>& at) {
    const std::string more = flats("a", "top flange", {0.0}, 100.0, 12.0) +
                             flats("a", "bottom flange", {0.0}, 100.0, 12.0);
    return verified(
        cantilever(box("a", 900.0, 1000.0, 10.0, 20.0, more) + box("b", 900.0, 1000.0, 10.0, 20.0),
                   segment(2.0, "a") + segment(4.0, "b") + diaphragms(at), tip(6.0, -50.0)));
  };
  CHECK(has_gate(with({0.0, 6.0}), "ends at s = 2 m, inside its panel"));
  CHECK_FALSE(has_gate(with({0.0, 2.0, 6.0}), "inside its panel"));
}

TEST_CASE("the excavator's slender webs get a verdict between diaphragms alone", "[plates]") {
  Project project = read_project(test::project_file("sections/excavator-boom/boom.toml"));
  const Verification of = verify(project);
  CHECK(of.verdict == Verdict::pass);
  // Nothing says what bears the forces that come into slender webs.
  project.beam.diaphragms.clear();
  CHECK(verify(project).verdict == Verdict::not_applicable);
  // By hand, N and mm, as README.md of the case: N = -22 kN and M = 128.15 kN m where the force of
  // the cylinder comes in; webs of 500 x 8 under N alone.
  const CheckResult* const effective = of.governing(Criterion::effective_section);
  REQUIRE(effective != nullptr);
  const double lambda_p = 62.5 / (28.4 * std::sqrt(235.0 / 355.0) * 2.0);
  const double idle = (1.0 - (lambda_p - 0.22) / (lambda_p * lambda_p)) * 500.0;
  CHECK(1e-6 * effective->check.acting.value() ==
        Approx(22e3 / (14240.0 - 2.0 * idle * 8.0) + 128.15e6 * 256.0 / 5.753e8).epsilon(1e-3));
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  // The clear depth falls from 500 by 284 over the 3100 of the upper panel.
  const double depth = 500.0 - 284.0 * (shear->check.station.s.value() - 2.1) / 3.1;
  const double k_tau = 5.34 + 4.0 * std::pow(depth / 3100.0, 2);
  const double lambda = depth / 8.0 / (37.4 * std::sqrt(235.0 / 355.0) * std::sqrt(k_tau));
  const double chi = std::min(1.2, 0.83 / lambda);
  CHECK(shear->check.resisting.value() ==
        Approx(chi * 355.0 * depth * 8.0 / std::sqrt(3.0)).epsilon(5e-3));
  // Little shear, most of it bending: no more than a tenth of what the webs bear.
  CHECK(shear->check.utilisation() < 0.1);
}

}  // namespace diaphragm_panels_test
