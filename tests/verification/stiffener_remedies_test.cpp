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

TEST_CASE("a compressed flange that buckles: the least flats in its middle or its thirds",
          "[remedies]") {
  const auto beam = [](const std::string& more) {
    return cantilever(box("a", 1000.0, 1000.0, 12.0, 28.0, more),
                      segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -750.0));
  };
  const Verification of = advised(beam(""));
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::effective_section);
  const Remedy* const flat = find(of, Remedy::What::stiffeners);
  REQUIRE(flat != nullptr);
  CHECK(flat->name.find("along the bottom flange") != std::string::npos);
  // Clear width 944: in the middle, or 157 on both sides of it.
  const auto with = [&](const std::vector<double>& at, const Size& size) {
    return beam(flats("a", "bottom flange", at, size.depth, size.thickness));
  };
  bool found = false;
  for (const Size& size : sizes()) {
    const bool middle = passes(with({0.0}, size)), thirds = passes(with({-157.0, 157.0}, size));
    if (!middle && !thirds) continue;
    CHECK(flat->name.find(name_of(size)) != std::string::npos);
    CHECK(flat->name.ends_with(middle ? "(in its middle)" : "(in its thirds)"));
    CHECK(flat->value == Approx(1e-3 * size.thickness));
    CHECK(flat->set.size() == 1);
    CHECK(flat->set.front().starts_with("sections.a.stiffeners=["));
    found = true;
    break;
  }
  CHECK(found);
  const Verification changed = verify(read(beam(""), flat->set));
  CHECK(changed.verdict == Verdict::pass);
  CHECK(changed.checks.front().check.utilisation() == Approx(flat->utilisation).epsilon(1e-9));
  CHECK(verdict_sentence_of(read(beam("")), of).find(flat->name) != std::string::npos);
  // Webs of 976/28 = 34.9 may buckle in even compression, above 42 eps = 34.2.
  CHECK((find(of, Remedy::What::stiffeners, "webs") != nullptr) !=
        says(of.remedies.in_vain, "along the webs"));
}

TEST_CASE("plates that would not buckle get no flats", "[remedies]") {
  // Webs of 976/30 = 32.5, below 42 eps.
  const Verification of = advised(
      cantilever(box("a", 1000.0, 1000.0, 12.0, 30.0),
                 segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -780.0)));
  REQUIRE(of.verdict == Verdict::fail);
  CHECK(find(of, Remedy::What::stiffeners, "webs") == nullptr);
  CHECK_FALSE(says(of.remedies.in_vain, "along the webs"));
  CHECK_FALSE(says(of.remedies.not_searched, "webs"));
}

TEST_CASE("webs that bend: flats on both, a fifth of their depth from the compressed edge",
          "[remedies]") {
  const auto beam = [](const std::string& more) {
    return cantilever(box("a", 600.0, 1224.0, 20.0, 6.0, more),
                      segment(10.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0, 10.0}),
                      tip(10.0, 590.0));
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
  const auto beam = [](const std::string& more, const std::vector<double>& across = {0.0, 2.0}) {
    return cantilever(box("a", 600.0, 1224.0, 30.0, 8.0, more),
                      segment(2.0, "a") + diaphragms(across, 30.0), tip(2.0, -1900.0));
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
  // Clear depth 1164: in the middle, or 194 on both sides of it.
  bool found = false;
  for (const Size& size : sizes()) {
    const bool middle = passes(both({0.0}, size)), thirds = passes(both({-194.0, 194.0}, size));
    if (!middle && !thirds) continue;
    CHECK(flat->name.find(name_of(size)) != std::string::npos);
    CHECK(flat->name.ends_with(middle ? "(in their middle)" : "(in their thirds)"));
    found = true;
    break;
  }
  CHECK(found);
  CHECK(passes(beam(""), flat->set));
  const Remedy* const across = find(of, Remedy::What::diaphragms);
  REQUIRE(across != nullptr);
  CHECK(across->name == "a 30 mm diaphragm at 1 m");
  CHECK(across->value == Approx(1.0));
  CHECK(across->set.size() == 1);
  CHECK(passes(beam(""), across->set));
  CHECK(passes(beam("", {0.0, 1.0, 2.0})));
  const Remedy* const webs = find(of, Remedy::What::webs);
  REQUIRE(webs != nullptr);
  CHECK(passes(beam(""), webs->set));
}

TEST_CASE("a diaphragm that does not bear its force gets thicker", "[remedies]") {
  const auto beam = [](double thickness) {
    return cantilever(
        box("a", 600.0, 1224.0, 30.0, 8.0),
        segment(2.0, "a") + diaphragms({2.0}, thickness) + diaphragms({0.0, 1.0}, 12.0),
        tip(2.0, -1900.0));
  };
  const std::string text = beam(10.0);
  const Verification of = advised(text);
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::patch_loading);
  const Remedy* const found = find(of, Remedy::What::diaphragm);
  REQUIRE(found != nullptr);
  const double mm = std::round(1e3 * found->value);
  // The case writes it before the others.
  CHECK(found->set ==
        std::vector<std::string>{fmt::format("beam.diaphragms.0.thickness={:.0f} mm", mm)});
  CHECK(passes(beam(mm)));
  CHECK_FALSE(passes(beam(mm - 1.0)));
  CHECK(passes(text, found->set));
  CHECK(find(of, Remedy::What::diaphragms) == nullptr);
}

TEST_CASE("diaphragms divide the panel that fails, where that is enough", "[remedies]") {
  // V = 1600 kN up to 3 m, 100 kN behind.
  const std::string loads =
      tip(9.0, -100.0) +
      "[loads.mid]\nkind = \"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"-1600 kN\"]\n";
  const auto beam = [&](const std::vector<double>& at) {
    return cantilever(box("a", 600.0, 1224.0, 40.0, 8.0), segment(9.0, "a") + diaphragms(at, 20.0),
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
                 tip(8.0, -1060.0));
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
                      segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -830.0));
  };
  const std::string text = beam({100.0, 10.0});
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

TEST_CASE("welds of flats count in fatigue where they are weaker", "[remedies]") {
  const auto beam = [](const char* cycles, int category) {
    const std::string fatigue =
        category == 0 ? ""
                      : fmt::format(
                            "[fatigue]\ncategory = {}\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
                            "required = 1.0\ndiaphragms = {{ category = 160 }}\n",
                            category);
    return cantilever(box("a", 1000.0, 1000.0, 12.0, 24.0) + box("b", 1000.0, 1000.0, 25.0, 24.0),
                      segment(2.0, "b") + segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}),
                      tip(8.0, -945.0) +
                          "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n"
                          "[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n"
                          "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\n"
                          "cycles = " +
                          cycles + "\n",
                      "", fatigue);
  };
  const char* const words = "along the bottom flange";
  const Verification without = advised(beam("1e4", 0));
  REQUIRE(without.verdict == Verdict::fail);
  REQUIRE(without.checks.front().check.criterion == Criterion::effective_section);
  const Remedy* const bare = find(without, Remedy::What::stiffeners, words);
  REQUIRE(bare != nullptr);
  CHECK(bare->set.size() == 1);

  const Verification of = advised(beam("1e4", 160));
  const Remedy* const flat = find(of, Remedy::What::stiffeners, words);
  REQUIRE(flat != nullptr);
  const Project changed = read(beam("1e4", 160), flat->set);
  CHECK(flat->set.size() == 1);
  const Verification with = verify(changed);
  CHECK(with.verdict == Verdict::pass);
  CHECK(with.checks.front().check.utilisation() == Approx(flat->utilisation).epsilon(1e-9));

  // 2e5 cycles: category 56 bears 56 10^(1/3) = 121 MPa, 160 bears 345 MPa. By the end of the
  // flats it fails, which with as good a detail there would pass.
  const Verification often = advised(beam("2e5", 160));
  REQUIRE(often.verdict == Verdict::fail);
  CHECK(find(often, Remedy::What::stiffeners, words) == nullptr);
  CHECK(says(often.remedies.in_vain, words));
  std::vector<std::string> good = bare->set;
  good.emplace_back("fatigue.flat_ends={category = 160}");
  good.emplace_back("fatigue.flats={category = 160}");
  CHECK(passes(beam("2e5", 160), good));

  // A beam of 50 is weaker than any of them.
  const Verification weak = advised(beam("1e3", 50));
  const Remedy* const same = find(weak, Remedy::What::stiffeners, words);
  REQUIRE(same != nullptr);
  CHECK(same->set.size() == 1);
}

TEST_CASE("welds of diaphragms count in fatigue where they are weaker", "[remedies]") {
  // b/t = 97: they do not breathe.
  const auto beam = [](const std::string& fatigue) {
    return cantilever(box("a", 600.0, 1224.0, 30.0, 12.0),
                      segment(1.4, "a") + diaphragms({0.0, 1.4}, 30.0),
                      tip(1.4, -4600.0) +
                          "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n"
                          "[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n"
                          "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\n"
                          "cycles = 1e3\n",
                      "", fatigue);
  };
  const std::string others = "loading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n";
  const std::string strong = beam("[fatigue]\ncategory = 112\n" + others);
  const Verification of = advised(strong);
  const Remedy* const found = find(of, Remedy::What::diaphragms);
  REQUIRE(found != nullptr);
  const Project changed = read(strong, found->set);
  REQUIRE(changed.beam.diaphragms.size() == 3);
  // 30 mm with fillets on both sides are longer than 50 mm: 71 in place of 112 (8.4/8).
  const Verification with = verify(changed);
  CHECK(with.verdict == Verdict::pass);
  CHECK(with.checks.front().check.utilisation() == Approx(found->utilisation).epsilon(1e-9));
  const auto at_middle =
      std::find_if(with.checks.begin(), with.checks.end(), [](const CheckResult& one) {
        return one.check.criterion == Criterion::fatigue && one.check.station.s.value() == 0.7;
      });
  REQUIRE(at_middle != with.checks.end());
  CHECK(at_middle->basis->curves.front().reference.value() == Approx(71e6));
}

}  // namespace stiffener_remedies_test
