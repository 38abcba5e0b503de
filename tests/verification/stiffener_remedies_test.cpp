// Flats and diaphragms that make slender plates pass: written into the case by other words than
// the program's own they pass, and the next lesser ones do not.

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/report/verdict_sentence.hpp"
#include "boxbeam/verification/remedies.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/slender_cases.hpp"

namespace stiffener_remedies_test {

using namespace boxbeam;
using namespace slender_cases;

namespace {

Project read(const std::string& text, const std::vector<std::string>& set = {}) {
  return parse_project("slender.toml", text, set);
}

Verification advised(const std::string& text, const std::vector<std::string>& set = {}) {
  return verify(read(text, set), Figures::without, Advice::with);
}

bool passes(const std::string& text, const std::vector<std::string>& set = {}) {
  return verify(read(text, set)).verdict == Verdict::pass;
}

const Remedy* find(const Verification& of, Remedy::What what, const std::string& words = "") {
  for (const Remedy& remedy : of.remedies.found) {
    if (remedy.what == what && remedy.name.find(words) != std::string::npos) return &remedy;
  }
  return nullptr;
}

bool says(const std::vector<std::string>& texts, const std::string& words) {
  return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
    return text.find(words) != std::string::npos;
  });
}

struct Size {
  double depth, thickness;  // mm
};

/// The deepest flats of S355 in whole centimetres that do not twist (9.2.1(8)): with r = d/t,
/// I_T/I_p = 1/(r^2 + 1/4) >= 5.3 f_y/E, r <= 10.55.
std::vector<Size> sizes() {
  const double r = std::sqrt(210e3 / (5.3 * 355.0) - 0.25);
  std::vector<Size> all;
  for (const double t : {8.0, 10.0, 12.0, 15.0, 20.0})
    all.push_back({10.0 * std::floor(r * t / 10.0), t});
  return all;
}

/// The least of them with which a case passes that `with` writes; nothing where none does.
template <class Write>
std::optional<Size> least(const Write& with) {
  for (const Size& size : sizes())
    if (passes(with(size))) return size;
  return std::nullopt;
}

std::string name_of(const Size& size) {
  return fmt::format(" {:.6g} x {:.6g} mm ", size.depth, size.thickness);
}

}  // namespace

TEST_CASE("a compressed flange that buckles: the least flat in its middle", "[remedies]") {
  const auto beam = [](const std::string& more) {
    return cantilever(box("a", 1000.0, 1000.0, 12.0, 24.0, more),
                      segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -580.0));
  };
  const Verification of = advised(beam(""));
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::effective_section);
  const Remedy* const flat = find(of, Remedy::What::stiffeners);
  REQUIRE(flat != nullptr);
  CHECK(flat->name.starts_with("a flat of "));
  CHECK(flat->name.find("along the bottom flange (in its middle)") != std::string::npos);
  const auto hand = least([&](const Size& size) {
    return beam(flats("a", "bottom flange", {0.0}, size.depth, size.thickness));
  });
  REQUIRE(hand);
  CHECK(flat->name.find(name_of(*hand)) != std::string::npos);
  CHECK(flat->value == Approx(1e-3 * hand->thickness));
  CHECK(flat->set == std::vector<std::string>{fmt::format(
                         "sections.a.stiffeners=[{{on = \"bottom flange\", at = \"0 mm\", depth = "
                         "\"{:.6g} mm\", thickness = \"{:.6g} mm\"}}]",
                         hand->depth, hand->thickness)});
  const Verification with = verify(read(beam(""), flat->set));
  CHECK(with.verdict == Verdict::pass);
  CHECK(with.checks.front().check.utilisation() == Approx(flat->utilisation).epsilon(1e-9));
  CHECK(verdict_sentence_of(read(beam("")), of).find(flat->name) != std::string::npos);
  // Webs of 976/24 = 40.7 need none: c/t up to 42 eps counts as stout.
  CHECK(find(of, Remedy::What::stiffeners, "webs") == nullptr);
  CHECK_FALSE(says(of.remedies.in_vain, "flats"));
}

TEST_CASE("webs that bend: flats on both, a fifth of their depth from the compressed edge",
          "[remedies]") {
  const auto beam = [](const std::string& more) {
    return cantilever(box("a", 600.0, 1224.0, 20.0, 6.0, more),
                      segment(10.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0, 10.0}),
                      tip(10.0, 555.0));
  };
  // Upwards: the top flange is compressed. Clear depth 1184: 592 - 0.2 1184 = 355.2.
  const Verification of = advised(beam(""));
  REQUIRE(of.verdict == Verdict::fail);
  const Remedy* const flat = find(of, Remedy::What::stiffeners, "webs");
  REQUIRE(flat != nullptr);
  CHECK(flat->name.find("a fifth of their depth below the top flange") != std::string::npos);
  const auto hand = least([&](const Size& size) {
    return beam(flats("a", "left web", {355.0}, size.depth, size.thickness) +
                flats("a", "right web", {355.0}, size.depth, size.thickness));
  });
  REQUIRE(hand);
  CHECK(flat->name.find(name_of(*hand)) != std::string::npos);
  const Project changed = read(beam(""), flat->set);
  const auto& bars = std::get<Box>(changed.beam.segments[0].from.outer).stiffeners;
  REQUIRE(bars.size() == 2);
  CHECK(bars[0].plate == BoxPlate::left_web);
  CHECK(bars[1].plate == BoxPlate::right_web);
  CHECK(verify(changed).verdict == Verdict::pass);
}

TEST_CASE("webs in shear: flats in their middle, diaphragms, thicker webs", "[remedies]") {
  const auto beam = [](const std::string& more, const std::string& across = "") {
    return cantilever(box("a", 600.0, 1224.0, 30.0, 8.0, more), segment(2.0, "a") + across,
                      tip(2.0, -1700.0));
  };
  const Verification of = advised(beam(""));
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::shear_buckling);
  const Remedy* const flat = find(of, Remedy::What::stiffeners);
  REQUIRE(flat != nullptr);
  const auto both = [&](const std::vector<double>& at, const Size& size) {
    return beam(flats("a", "left web", at, size.depth, size.thickness) +
                flats("a", "right web", at, size.depth, size.thickness));
  };
  // Clear depth 1164, in the middle or +-194.
  for (const Size& size : sizes()) {
    const bool middle = passes(both({0.0}, size)), thirds = passes(both({-194.0, 194.0}, size));
    if (!middle && !thirds) continue;
    CHECK(flat->name.find(name_of(size)) != std::string::npos);
    CHECK(flat->name.ends_with(middle ? "(in their middle)" : "(in their thirds)"));
    break;
  }
  CHECK(passes(beam(""), flat->set));
  const Remedy* const across = find(of, Remedy::What::diaphragms);
  REQUIRE(across != nullptr);
  CHECK(passes(beam(""), across->set));
  const double panels = 2.0 / across->value;
  CHECK(panels == Approx(std::round(panels)));
  const auto divided = [&](int n) {
    std::vector<double> at;
    for (int i = 0; i <= n; ++i) at.push_back(2.0 * i / n);
    return beam("", diaphragms(at, 30.0));
  };
  CHECK(passes(divided(static_cast<int>(std::lround(panels)))));
  if (panels > 1.5) CHECK_FALSE(passes(divided(static_cast<int>(std::lround(panels)) - 1)));
}

TEST_CASE("diaphragms divide the panel that fails, where that is enough", "[remedies]") {
  // V = 1600 kN up to 3 m, 100 kN behind.
  const std::string loads =
      tip(9.0, -100.0) +
      "[loads.mid]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-1600 kN\"]\n";
  const auto beam = [&](const std::vector<double>& at) {
    return cantilever(box("a", 600.0, 1224.0, 40.0, 8.0), segment(9.0, "a") + diaphragms(at),
                      loads);
  };
  const Verification of = advised(beam({0.0, 3.0, 9.0}));
  REQUIRE(of.verdict == Verdict::fail);
  const Remedy* const found = find(of, Remedy::What::diaphragms);
  REQUIRE(found != nullptr);
  REQUIRE(found->value < 3.0);
  const int panels = static_cast<int>(std::lround(3.0 / found->value));
  const auto divided = [&](int n) {
    std::vector<double> at{9.0};
    for (int i = 0; i <= n; ++i) at.push_back(3.0 * i / n);
    return beam(at);
  };
  CHECK(passes(divided(panels)));
  CHECK_FALSE(passes(divided(panels - 1)));
  // Nothing is added behind 3 m.
  const Project changed = read(beam({0.0, 3.0, 9.0}), found->set);
  CHECK(changed.beam.diaphragms.size() == static_cast<std::size_t>(panels) + 2);
  CHECK(verify(changed).checks.front().check.utilisation() ==
        Approx(found->utilisation).epsilon(1e-9));
}

TEST_CASE("in a taper both sections get their flats, each at its own place", "[remedies]") {
  const std::string text =
      cantilever(box("a", 1000.0, 1200.0, 12.0, 29.0) + box("b", 1000.0, 800.0, 12.0, 29.0),
                 segment(2.0, "a") + taper(6.0, "a", "b") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}),
                 tip(8.0, -800.0));
  const Verification of = advised(text);
  REQUIRE(of.verdict == Verdict::fail);
  const Remedy* const flat = find(of, Remedy::What::stiffeners, "bottom flange");
  REQUIRE(flat != nullptr);
  REQUIRE(flat->set.size() == 2);
  CHECK(flat->set[0].starts_with("sections.a.stiffeners=["));
  CHECK(flat->set[1].starts_with("sections.b.stiffeners=["));
  CHECK(passes(text, flat->set));
}

TEST_CASE("where there are flats, larger ones take their place", "[remedies]") {
  const auto beam = [](const Size& size) {
    return cantilever(box("a", 1000.0, 1000.0, 12.0, 24.0,
                          flats("a", "bottom flange", {-163.0, 163.0}, size.depth, size.thickness)),
                      segment(8.0, "a"), tip(8.0, -600.0));
  };
  const std::string text = beam({80.0, 8.0});
  const Verification of = advised(text);
  REQUIRE(of.verdict == Verdict::fail);
  const Remedy* const flat = find(of, Remedy::What::stiffeners);
  REQUIRE(flat != nullptr);
  CHECK(flat->name.ends_with("(in place of those that are there)"));
  const auto hand = least(beam);
  REQUIRE(hand);
  CHECK(flat->name.find(name_of(*hand)) != std::string::npos);
  const Project changed = read(text, flat->set);
  const auto& bars = std::get<Box>(changed.beam.segments[0].from.outer).stiffeners;
  REQUIRE(bars.size() == 2);
  CHECK(bars[1].place.value() == Approx(0.163));
  CHECK(verify(changed).verdict == Verdict::pass);
}

TEST_CASE("reduced stresses judge no flats, and that is said", "[remedies]") {
  const Verification of =
      advised(cantilever(box("a", 600.0, 1224.0, 12.0, 8.0), segment(10.0, "a"), tip(10.0, -400.0),
                         "", "plates = \"reduced stresses\"\n"));
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::reduced_stress);
  CHECK(find(of, Remedy::What::stiffeners) == nullptr);
  CHECK(says(of.remedies.not_searched, "stiffeners (reduced stresses do not judge them)"));
}

TEST_CASE("welds of flats and diaphragms count in fatigue where they are weaker", "[remedies]") {
  const auto beam = [](const std::string& demands) {
    return cantilever(box("a", 1000.0, 1000.0, 12.0, 24.0) + box("b", 1000.0, 1000.0, 25.0, 24.0),
                      segment(2.0, "b") + segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}),
                      tip(8.0, -770.0) +
                          "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n"
                          "[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n"
                          "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\n"
                          "cycles = 1e4\n",
                      "", demands);
  };
  const std::string category =
      "[fatigue]\ncategory = {}\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n";
  const std::string plain = beam("");
  const Verification without = advised(plain);
  REQUIRE(without.verdict == Verdict::fail);
  REQUIRE(without.checks.front().check.criterion == Criterion::effective_section);
  REQUIRE(find(without, Remedy::What::stiffeners) != nullptr);
  CHECK(find(without, Remedy::What::stiffeners)->set.size() == 1);

  const std::string better = beam(fmt::format(fmt::runtime(category), 160));
  const Verification of = advised(better);
  const Remedy* const flat = find(of, Remedy::What::stiffeners);
  REQUIRE(flat != nullptr);
  const Project changed = read(better, flat->set);
  // Along the flat from 2 m to the end by 100, and where it ends at 2 m by 56.
  REQUIRE(changed.fatigue.details.size() == 2);
  const BeamDetail& along = changed.fatigue.details[0];
  const BeamDetail& end = changed.fatigue.details[1];
  CHECK(curve_of(along.detail).reference.value() == Approx(100e6));
  CHECK(along.from.value() == Approx(2.0));
  CHECK(along.to.value() == Approx(8.0));
  CHECK(curve_of(end.detail).reference.value() == Approx(56e6));
  CHECK(end.from.value() == Approx(2.0));
  CHECK(end.to == end.from);
  CHECK(along.on == DetailPlace::fibres);
  const Verification with = verify(changed);
  CHECK(with.verdict == Verdict::pass);
  CHECK(with.checks.front().check.utilisation() == Approx(flat->utilisation).epsilon(1e-9));

  // A beam of 50 is weaker than any of them.
  const Verification weak = advised(beam(fmt::format(fmt::runtime(category), 50)));
  if (const Remedy* const same = find(weak, Remedy::What::stiffeners)) CHECK(same->set.size() == 1);
}

}  // namespace stiffener_remedies_test
