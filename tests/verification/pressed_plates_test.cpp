// Stout webs under forces of which the case does not say how they come in: nothing that a check
// with a stiff length of zero would find is left out.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace pressed_plates_test {

using namespace boxbeam;

namespace {

struct Sizes {
  double width, height, flange, web, throat;

  std::string text(const std::string& name, double other_height = 0.0) const {
    return fmt::format(
        "[sections.{}]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\nflange = \"{} "
        "mm\"\nweb = \"{} mm\"\n{}",
        name, width, other_height > 0.0 ? other_height : height, flange, web,
        throat > 0.0 ? fmt::format("seam_throat = \"{} mm\"\n", throat) : "");
  }
};

std::string force(const std::string& name, double at, double kN) {
  return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\n",
                     name, at, kN);
}

std::string on_an_edge(double at) {
  return fmt::format("[[beam.load_introductions]]\nstation = \"{} m\"\nstiff_length = \"0 mm\"\n",
                     at);
}

std::string plain_segment(double length) {
  return fmt::format("[[beam.segments]]\nlength = \"{} m\"\nsection = \"a\"\n", length);
}

/// A weightless beam on two supports.
std::string beam(double length, const std::string& sections, const std::string& segments,
                 const std::string& more) {
  return "[case]\nname = \"pressed\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + more +
         fmt::format(
             "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
             "[supports.right]\nkind = \"roller\"\nat = \"{} m\"\n",
             length) +
         "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = 1.0\n";
}

Verification verified(const std::string& text) {
  return verify(parse_project("pressed.toml", text));
}

const CheckResult* under(const Verification& of, const std::string& name, bool seam) {
  for (const CheckResult& result : of.checks) {
    if (result.patch && (result.check.criterion == Criterion::weld) == seam &&
        result.check.point.ends_with(" under " + name))
      return &result;
  }
  return nullptr;
}

bool stops(const Verification& of, const std::string& part) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const Gate& gate) {
    return gate.blocks && (gate.plate + " " + gate.finding).find(part) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("a stout web under a force: resistance by hand, no verdict where it does not hold",
          "[patch]") {
  // 300 x 480, flanges 12, webs 10: h_w/t = 45.6. A force in the middle of 1.2 m.
  const Sizes box{300, 480, 12, 10, 0};
  const auto of = [&](double kN) {
    return verified(beam(1.2, box.text("a"), plain_segment(1.2), force("f", 0.6, -kN)));
  };
  // Type a far from diaphragms: k_F = 6, F_cr = 0.9 6 210e3 10^3/456 = 2487 kN; b_f half the clear
  // flange (140 < 15 0.814 12 = 146) and the web: m_1 = 150/10, m_2 = 0.02 (456/12)^2 = 28.9; l_y =
  // 2 12 (1 + sqrt(43.9)) = 183 mm; lambda_F = sqrt(183 10 355/2487e3) = 0.511.
  const double l_y = 24.0 * (1.0 + std::sqrt(15.0 + 0.02 * 38.0 * 38.0));
  const double F_cr = 0.9 * 6.0 * 210.0 * 1000.0 / 456.0, F_y = 0.355 * 10.0 * l_y;
  const double F_Rd = 0.5 / std::sqrt(F_y / F_cr) * F_y;
  const CheckResult* const held = under(of(0.5 * 2.0 * F_Rd), "f", false);
  REQUIRE(held != nullptr);
  CHECK(held->patch->resistance.value() == Approx(1e3 * F_Rd).epsilon(1e-9));
  CHECK(stops(of(1.01 * 2.0 * F_Rd), "\"f\""));
  CHECK_FALSE(stops(of(0.99 * 2.0 * F_Rd), "\"f\""));
  // A small force is not listed, nor anything not said of it.
  const Verification small = of(0.1 * 2.0 * F_Rd);
  CHECK(under(small, "f", false) == nullptr);
  CHECK(small.not_judged.empty());
}

TEST_CASE("random stout boxes: a force of which nothing is said is judged as on an edge",
          "[patch]") {
  std::mt19937 numbers(20);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(numbers);
  };
  int listed = 0, stopped = 0, silent = 0;
  for (int i = 0; i < 150; ++i) {
    Sizes box{};
    box.flange = std::round(between(6.0, 40.0));
    box.web = std::round(between(6.0, 30.0));
    // Both kinds of plates below 33 eps and 40 eps of their thickness.
    box.width = std::round(2.0 * box.web + between(10.0, 26.0) * box.flange);
    box.height = std::round(2.0 * box.flange + between(10.0, 38.0) * box.web);
    box.throat = i % 3 == 0 ? 0.0 : std::round(between(3.0, 0.7 * box.web + 3.0));
    const double at = between(0.2, 3.0);
    const double kN = std::pow(10.0, between(0.3, 3.2));
    const std::string load = force("f", at, i % 2 == 0 ? kN : -kN);
    const Verification asked =
        verified(beam(6.0, box.text("a"), plain_segment(6.0), load + on_an_edge(at)));
    const Verification plain = verified(beam(6.0, box.text("a"), plain_segment(6.0), load));
    for (const bool seam : {false, true}) {
      const CheckResult* const right = under(asked, "f", seam);
      if (right == nullptr) continue;
      CAPTURE(i, kN, at, seam, right->check.utilisation());
      const CheckResult* const found = under(plain, "f", seam);
      if (right->check.utilisation() > 1.0) {
        CHECK(stops(plain, "\"f\""));
        ++stopped;
      } else if (found != nullptr) {
        CHECK(found->check.utilisation() == Approx(right->check.utilisation()).epsilon(1e-9));
        ++listed;
      } else {
        // What is left out asks less than another check of the same verdict.
        const PatchBasis& basis = *&*right->patch;
        if (seam)
          CHECK(right->check.utilisation() <= 0.3);
        else
          CHECK(basis.share * basis.force <= 0.3 * basis.resistance);
        ++silent;
      }
    }
  }
  CHECK(listed > 20);
  CHECK(stopped > 20);
  CHECK(silent > 20);
}

TEST_CASE("the kink of a stout box presses its webs and bends its flange", "[patch]") {
  // 400 x 600 to 400 x 300 in 0.8 m between two straight parts, flanges 20, webs 20.
  const Sizes box{400, 600, 20, 20, 0};
  const std::string segments =
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"a\"\n"
      "[[beam.segments]]\nlength = \"0.8 m\"\nfrom = \"a\"\nto = \"b\"\n"
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n";
  const auto of = [&](double kN) {
    return verified(
        beam(4.8, box.text("a") + box.text("b", 300.0), segments, force("f", 2.4, -kN)));
  };
  // At s = 2.8 m M = F/2 2 m; the flange's force by the stress in its middle, and what of it the
  // slope of 150/800 turns off: 1.3 F/(4 pi) 6/t^2 across the flange, f_y = 355.
  const double I = (400.0 * std::pow(300.0, 3) - 360.0 * std::pow(260.0, 3)) / 12.0;
  const double kN = 100.0, M = 0.5 * kN * 1e3 * 2000.0;
  const double turned = M * 140.0 / I * 360.0 * 20.0 * 150.0 / 800.0;
  const double use =
      1.3 * 0.915965594 * turned / (std::acos(-1.0) * std::acos(-1.0)) * 6.0 / 400.0 / 355.0;
  const std::string words = fmt::format("by about {:.2g} of their strength at s = 2.8 m", use);
  const Verification found = of(kN);
  int said = 0;
  for (const NotJudged& note : found.not_judged)
    said += note.reason.find(words) != std::string::npos ? 1 : 0;
  CHECK(said == 1);  // of the top and of the bottom flange
  // Six times the load is more than the flange bears, beside what it has along the beam.
  CHECK(stops(of(6.0 * kN), "the kink of the top flange"));
}

bool says(const Verification& of, const std::string& words) {
  return std::any_of(of.not_judged.begin(), of.not_judged.end(), [&](const NotJudged& note) {
    return note.reason.find(words) != std::string::npos;
  });
}

/// Straight, tapered over 0.8 m to half of its depth, straight.
const std::string kinked_segments =
    "[[beam.segments]]\nlength = \"2 m\"\nsection = \"a\"\n"
    "[[beam.segments]]\nlength = \"0.8 m\"\nfrom = \"a\"\nto = \"b\"\n"
    "[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n";

Verification kinked(const ThinWalled& a, const ThinWalled& b, double kN) {
  return verified(beam(4.8, path_cases::section("a", a) + path_cases::section("b", b),
                       kinked_segments, force("f", 2.4, -kN) + path_cases::held(4.8, 8)));
}

TEST_CASE("the kink of a path: its web is pressed, its flange bent across, each half by its own",
          "[patch]") {
  // 600 to 300 deep, flanges 200 x 20, web 12. Each half of a flange is a cantilever that bears
  // what it turns off at its edge at worst: 0.509 F 6/t^2; both together press the web.
  const auto of = [](double kN) {
    return kinked(paths::i_section(200.0, 20.0, 560.0, 12.0),
                  paths::i_section(200.0, 20.0, 260.0, 12.0), kN);
  };
  const double I =
      2.0 * (4000.0 * 140.0 * 140.0 + 200.0 * 8000.0 / 12.0) + 12.0 * std::pow(260.0, 3) / 12.0;
  const double kN = 60.0, M = 0.5 * kN * 1e3 * 2000.0;
  const double half = M * 140.0 / I * (100.0 - 6.0) * 20.0 * 150.0 / 800.0;
  const std::string words = fmt::format("by about {:.2g} of their strength at s = 2.8 m",
                                        0.509 * half * 6.0 / 400.0 / 355.0);
  const Verification found = of(kN);
  CHECK(says(found, words));
  CHECK(stops(of(4.0 * kN), "the kink of wall 1 and wall 2"));
  // Under a force that hardly turns off nothing is said.
  CHECK_FALSE(says(of(0.05 * kN), "bent across"));
}

TEST_CASE("the kinks of a box and of the same box as a path are alike", "[patch]") {
  const Sizes box{400, 600, 20, 20, 0};
  for (const double kN : {100.0, 600.0}) {
    const Verification as_box =
        verified(beam(4.8, box.text("a") + box.text("b", 300.0), kinked_segments,
                      force("f", 2.4, -kN) + path_cases::held(4.8, 8)));
    const Verification as_path = kinked(paths::box_path(400.0, 600.0, 20.0, 20.0),
                                        paths::box_path(400.0, 300.0, 20.0, 20.0), kN);
    const bool bears = kN < 200.0;
    CHECK(stops(as_box, "the kink of the top flange") == !bears);
    CHECK(stops(as_path, "the kink of wall 1") == !bears);
    const auto words_of = [](const Verification& of, const std::string& name) {
      for (const NotJudged& note : of.not_judged)
        if (note.reason.find("bent across") != std::string::npos) return note.reason;
      for (const Gate& gate : of.gates) {
        const std::size_t from = gate.finding.find("how it is bent");
        if (gate.finding.find(name) != std::string::npos && from != std::string::npos)
          return gate.finding.substr(from);
      }
      return std::string("nothing");
    };
    CHECK(words_of(as_path, "the kink of wall 1") ==
          words_of(as_box, "the kink of the top flange"));
    CHECK(words_of(as_path, "the kink of wall 2") ==
          words_of(as_box, "the kink of the bottom flange"));
    CHECK(words_of(as_box, "the kink of the top flange") != "nothing");
  }
}

TEST_CASE("where a flange of a path ends and the next one lies elsewhere there is no verdict",
          "[patch]") {
  const std::string two =
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"a\"\n"
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n";
  const auto of = [&](const std::string& a, const std::string& b, double kN) {
    return verified(beam(4.0, a + b, two, force("f", 2.0, -kN) + path_cases::held(4.0, 8)));
  };
  const auto text = [](const char* name, double depth) {
    return path_cases::section(name, paths::i_section(200.0, 20.0, depth - 40.0, 12.0));
  };
  CHECK(stops(of(text("a", 600.0), text("b", 400.0), 200.0),
              "it ends where the next one lies 100 mm away"));
  CHECK_FALSE(stops(of(text("a", 600.0), text("b", 597.0), 200.0), "it ends where"));
  CHECK_FALSE(stops(of(text("a", 600.0), text("b", 400.0), 10.0), "it ends where"));
  // Nor where one side is a box: by its plates, of which none goes on beyond an I.
  const Sizes box{400, 600, 20, 20, 0};
  const auto path = [](double height) {
    return path_cases::section("b", paths::box_path(400.0, height, 20.0, 20.0));
  };
  CHECK(
      stops(of(box.text("a"), path(400.0), 500.0), "it ends where the next one lies 100 mm away"));
  CHECK_FALSE(stops(of(box.text("a"), path(600.0), 500.0), "it ends where"));
}

TEST_CASE("where a flange ends and the next one lies elsewhere there is no verdict", "[patch]") {
  const Sizes box{400, 600, 20, 20, 0};
  const auto of = [&](double height, double kN) {
    return verified(beam(4.0, box.text("a") + box.text("b", height),
                         "[[beam.segments]]\nlength = \"2 m\"\nsection = \"a\"\n"
                         "[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n",
                         force("f", 2.0, -kN)));
  };
  CHECK(stops(of(400.0, 500.0), "it ends where the next one lies 100 mm away"));
  // Within a tenth of its thickness a plate goes on; next to nothing asks nothing.
  CHECK_FALSE(stops(of(597.0, 500.0), "it ends where"));
  CHECK(stops(of(570.0, 500.0), "it ends where"));
  CHECK_FALSE(stops(of(400.0, 20.0), "it ends where"));
}

}  // namespace pressed_plates_test
