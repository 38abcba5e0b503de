// Forces that come into webs: from the case to the verdict, against hand values and against all
// instants looked at one by one.

#include "boxbeam/verification/patch_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace patch_checks_test {

using namespace boxbeam;

namespace {

const std::string slender =
    "[sections.a]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1224 mm\"\n"
    "flange = \"12 mm\"\nweb = \"8 mm\"\n";
const std::string taper =
    "[sections.b]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"824 mm\"\n"
    "flange = \"12 mm\"\nweb = \"8 mm\"\n";

std::string diaphragm(double at, double thickness = 10.0) {
  return fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"{} mm\"\n", at,
                     thickness);
}

std::string introduction(const std::string& where, double stiff_length) {
  return fmt::format("[[beam.load_introductions]]\n{}\nstiff_length = \"{} mm\"\n", where,
                     stiff_length);
}

std::string stretch(double from, double to) {
  return fmt::format("from = \"{} m\"\nto = \"{} m\"", from, to);
}
std::string place(double at) { return fmt::format("station = \"{} m\"", at); }

std::string force(const std::string& name, double at, double kN, const std::string& more = "") {
  return fmt::format(
      "[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\n{}", name, at,
      kN, more);
}

/// A weightless beam of 9 m on two supports.
std::string beam(
    const std::string& more, const std::string& loads, double gamma_M1 = 1.0,
    const std::string& segments = "[[beam.segments]]\nlength = \"9 m\"\nsection = \"a\"\n") {
  return "[case]\nname = \"patch\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         slender + taper + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + more +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
         loads + "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n" +
         fmt::format("[strength]\nrequired = 1.0\nshear_lag = false\ngamma_M1 = {}\n", gamma_M1);
}

Project project_of(const std::string& text) { return parse_project("patch.toml", text); }

const CheckResult* patch_at(const Verification& of, const std::string& under) {
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::patch_loading &&
        result.check.point.ends_with(" under " + under))
      return &result;
  }
  return nullptr;
}

const Gate* gate_of(const Verification& of, const std::string& name) {
  for (const Gate& gate : of.gates) {
    if (gate.blocks && gate.finding.find("\"" + name + "\"") != std::string::npos) return &gate;
  }
  return nullptr;
}

const std::string ends = diaphragm(0.0) + diaphragm(9.0);

}  // namespace

TEST_CASE("a force on a slender web: its resistance by hand, half of it for each web", "[patch]") {
  // a = 9 m: k_F = 6 + 2 (1.2/9)^2 = 6.0356, F_cr = 0.9 6.0356 210 000 512/1200 = 486.7 kN, b_f = 8
  // + 15 0.8136 12 = 154.5 mm, m_1 = 19.31, m_2 = 200, l_y = 200 + 24 (1 + 14.809) = 579.4 mm,
  // lambda_F = 1.839, chi_F = 0.2719, F_Rd = 447.4 kN; of 400 kN each web takes 200.
  const Verification of =
      verify(project_of(beam(ends + introduction(place(4.5), 200.0), force("hook", 4.5, -400.0))));
  const CheckResult* const hook = patch_at(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK(hook->patch->resistance.value() == Approx(447.4e3).epsilon(5e-4));
  CHECK(hook->patch->share == Approx(0.5));
  // eta_1 of 900 kN m by the effective section alone is what "effective section" says there.
  const CheckResult* const section = governing_of(of.checks, Criterion::effective_section);
  const CheckResult* const yield = governing_of(of.checks, Criterion::yield);
  const double eta_1 =
      section != nullptr ? section->check.utilisation() : yield->check.utilisation();
  const double eta_2 = 200.0 / 447.4;
  CHECK(hook->check.utilisation() ==
        Approx(std::max(eta_2, (eta_2 + 0.8 * eta_1) / 1.4)).epsilon(2e-3));
  CHECK(of.verdict == Verdict::pass);
  // The ends stand on diaphragms, which bear 200 kN as columns.
  REQUIRE(patch_at(of, "left") != nullptr);
  CHECK(std::holds_alternative<BearingStiffener>(patch_at(of, "left")->patch->bears));
  CHECK(patch_at(of, "left")->patch->force.value() == Approx(200e3));
}

TEST_CASE("where nothing is known of how a force comes in, a slender web has no verdict",
          "[patch]") {
  const Verification of = verify(project_of(beam(ends, force("hook", 4.5, -800.0))));
  CHECK(of.verdict == Verdict::not_applicable);
  REQUIRE(gate_of(of, "hook") != nullptr);
  CHECK(gate_of(of, "hook")->finding.find("[[beam.load_introductions]]") != std::string::npos);
  // What holds even under an edge does not keep the verdict back.
  const Verification little = verify(project_of(beam(ends, force("hook", 4.5, -100.0))));
  CHECK(gate_of(little, "hook") == nullptr);
  CHECK(little.verdict == Verdict::pass);
  // Supports are forces as well.
  const Verification bare = verify(project_of(beam("", force("hook", 4.5, -800.0))));
  CHECK(gate_of(bare, "left") != nullptr);
  CHECK(gate_of(bare, "right") != nullptr);
  // A diaphragm takes it, bosses lead it into the webs.
  CHECK(verify(project_of(beam(ends + diaphragm(4.5), force("hook", 4.5, -800.0)))).verdict ==
        Verdict::pass);
  CHECK(verify(project_of(beam(ends + "[[beam.load_introductions]]\nstation = \"4.5 m\"\n"
                                      "into = \"webs\"\n",
                               force("hook", 4.5, -800.0))))
            .verdict == Verdict::pass);
}

TEST_CASE("a diaphragm too thin for the force fails as a column", "[patch]") {
  const Verification of =
      verify(project_of(beam(ends + diaphragm(4.5, 8.0), force("hook", 4.5, -2000.0))));
  REQUIRE(patch_at(of, "hook") != nullptr);
  // 15 eps of 8 mm and the web's strips: (2 97.6 + 8) 8 + 97.6 8 = 2406 mm^2, 854 kN at most.
  CHECK(patch_at(of, "hook")->patch->resistance.value() < 854e3);
  CHECK_FALSE(patch_at(of, "hook")->check.passes());
  CHECK(of.verdict == Verdict::fail);
  // 36.6 mm of a plate of 3 mm, 7e4 mm^4, are no stiffener: 0.75 x 1200 x 8^3 = 4.6e5 (9.3.3).
  CHECK(verify(project_of(beam(ends + diaphragm(4.5, 3.0), force("hook", 4.5, -1500.0)))).verdict !=
        Verdict::pass);
}

TEST_CASE("a stout web is looked at where the case says how a force comes in", "[patch]") {
  const std::string stout =
      "[sections.c]\nkind = \"box\"\nwidth = \"300 mm\"\nheight = \"400 mm\"\n"
      "flange = \"12 mm\"\nweb = \"10 mm\"\n";
  const auto text = [&](const std::string& more) {
    return "[case]\nname = \"patch\"\nkind = \"static\"\n[frame]\n"
           "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
           stout +
           "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"9 m\"\n"
           "section = \"c\"\n" +
           more +
           "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
           "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
           force("hook", 4.5, -100.0) +
           "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
  };
  CHECK(governing_of(verify(project_of(text(""))).checks, Criterion::patch_loading) == nullptr);
  const Verification of = verify(project_of(text(introduction(place(4.5), 50.0))));
  CHECK(patch_at(of, "hook") != nullptr);
  CHECK(patch_at(of, "left") == nullptr);
}

TEST_CASE("near an end without a diaphragm a web bears less", "[patch]") {
  // s_s = 100 mm at the very end: c = 0 on the end's side, k_F = 2 + 6 100/1200 = 2.5.
  const auto resistance = [](const std::string& diaphragms) {
    const Verification of = verify(project_of(
        beam(diaphragms + introduction(stretch(0.0, 9.0), 100.0), force("hook", 0.05, -100.0))));
    const CheckResult* const hook = patch_at(of, "hook");
    REQUIRE(hook != nullptr);
    return hook->patch;
  };
  const auto free = resistance(diaphragm(9.0));
  CHECK(std::get<PatchedWeb>(free->bears).entry == ForceEntry::near_end);
  CHECK(std::get<PatchedWeb>(free->bears).to_end.value() == Approx(0.0).margin(1e-12));
  const auto held = resistance(ends);
  CHECK(std::get<PatchedWeb>(held->bears).entry == ForceEntry::one_flange);
  CHECK(free->resistance < held->resistance);
}

TEST_CASE("a long bearing at a free end has its one hinge all the same: type c", "[patch]") {
  // c = 0 at the end, s_s = 801 mm, webs 1200 x 8: k_F = 6, F_cr = 0.9 x 6 x 210 000 x 512/1200 =
  // 483.8 kN, l_e = 6 x 210 000 x 64/(2 x 355 x 1200) = 94.6 mm; m_1 = 154.5/8, m_2 = 200: l_y
  // = 94.6
  // + 12 sqrt(219.3) = 272.3 mm, F_Rd = 0.5 sqrt(272.3 x 8 x 355 x 483.8e3) = 305.8 kN.
  const auto resistance = [](double stiff_length) {
    const Verification of =
        verify(project_of(beam(diaphragm(9.0) + introduction(stretch(0.0, 1.0), stiff_length),
                               force("hook", 0.5e-3 * stiff_length, -100.0))));
    const CheckResult* const hook = patch_at(of, "hook");
    REQUIRE(hook != nullptr);
    return hook->patch->resistance.value();
  };
  CHECK(resistance(801.0) == Approx(305.8e3).epsilon(2e-3));
  CHECK(resistance(801.0) == Approx(resistance(799.0)).epsilon(2e-3));
}

TEST_CASE("forces close together are judged together, opposed ones as passing through", "[patch]") {
  const Verification of = verify(
      project_of(beam(ends + introduction(stretch(1.0, 8.0), 100.0),
                      force("a", 4.2, -150.0) + force("b", 4.8, -150.0) + force("c", 7.0, -50.0))));
  const CheckResult* const both = patch_at(of, "a and b");
  REQUIRE(both != nullptr);
  CHECK(both->patch->force.value() == Approx(300e3));
  // From one to the other: 600 mm.
  CHECK(std::get<PatchedWeb>(both->patch->bears).stiff_length.value() == Approx(0.6));
  CHECK(patch_at(of, "b and c") == nullptr);
  const Verification through =
      verify(project_of(beam(ends + introduction(stretch(1.0, 8.0), 100.0),
                             force("a", 4.5, -150.0) + force("b", 4.5, 120.0))));
  REQUIRE(patch_at(through, "a") != nullptr);
  CHECK(std::get<PatchedWeb>(patch_at(through, "a")->patch->bears).entry ==
        ForceEntry::both_flanges);
}

TEST_CASE("very many forces close together are judged as soon, no milder than few", "[patch]") {
  // 480 kN over 0.4 m of an unstiffened web, in 24 forces, of which every group is looked at, and
  // more, of which groups of some numbers are, each on the length of a smaller one.
  const auto use_of = [](int count) {
    std::string loads;
    for (int i = 0; i < count; ++i)
      loads += force("f" + std::to_string(i), 4.0 + 0.4 * i / (count - 1), -480.0 / count);
    const Verification of =
        verify(parse_project("patch.toml", beam(introduction(stretch(3.0, 6.0), 0.0), loads)));
    double most = 0.0;
    for (const CheckResult& result : of.checks)
      if (result.check.criterion == Criterion::patch_loading)
        most = std::max(most, result.check.utilisation());
    return most;
  };
  const double exact = use_of(24);
  REQUIRE(exact > 0.3);
  for (const int count : {30, 60, 150}) {
    CAPTURE(count);
    CHECK(use_of(count) >= 0.98 * exact);
    CHECK(use_of(count) <= 1.15 * exact);
  }
}

TEST_CASE("an eccentric force loads one web more, by the lever between both", "[patch]") {
  // 200 mm from the axis, the webs' middles 296 mm: (296 + 200)/592 of it.
  const auto share = [](const std::string& at, const std::string& force) {
    const Verification of = verify(project_of(
        "[case]\nname = \"patch\"\nkind = \"static\"\n"
        "[frame]\nspace = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
        slender +
        "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\n"
        "z = \"z\"\npoints = { hook = " +
        at + " }\n[[beam.segments]]\nlength = \"6 m\"\nsection = \"a\"\n" +
        introduction(place(3.0), 200.0) + "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n" +
        "[loads.hook]\nkind = \"force\"\nat = \"beam.hook\"\nforce = " + force +
        "\n[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
        "1.0\n"));
    const CheckResult* const hook = patch_at(of, "hook");
    REQUIRE(hook != nullptr);
    return std::pair(hook->patch->share, hook->check.point);
  };
  const std::string down = "[\"0 N\", \"0 N\", \"-300 kN\"]";
  const std::string across = "[\"0 N\", \"-300 kN\", \"0 N\"]";
  const auto left = share("[\"3 m\", \"0.2 m\", \"0 m\"]", down);
  CHECK(left.first == Approx(496.0 / 592.0));
  CHECK(left.second == "left web under hook");
  CHECK(share("[\"3 m\", \"-0.2 m\", \"0 m\"]", down).second == "right web under hook");
  // Across the beam the flanges are the webs, 1212 mm apart.
  const auto top = share("[\"3 m\", \"0 m\", \"0.3 m\"]", across);
  CHECK(top.first == Approx(906.0 / 1212.0));
  CHECK(top.second == "top flange under hook");
  CHECK(share("[\"3 m\", \"0 m\", \"-0.3 m\"]", across).second == "bottom flange under hook");
}

TEST_CASE("wheels: no instant between those looked at is worse", "[patch]") {
  std::mt19937 engine(3);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 6; ++i) {
    const double behind = in(0.4, 2.5), P = in(50.0, 150.0), Q = in(50.0, 150.0);
    const std::string wheels = fmt::format(
        "[loads.crab]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", \"{} kN\"] }}, {{ behind "
        "= \"{} m\", force = [\"0 kN\", \"{} kN\"] }}]\nfrom = \"{} m\"\nto = \"9 m\"\nspeed = "
        "\"1 m/s\"\n",
        -P, behind, -Q, behind);
    const Project project = project_of(
        beam(ends + (i % 2 == 0 ? diaphragm(in(2.0, 4.0)) + diaphragm(in(5.0, 7.0)) : "") +
                 introduction(stretch(0.0, 9.0), in(50.0, 250.0)),
             wheels, 1.1,
             "[[beam.segments]]\nlength = \"5 m\"\nfrom = \"a\"\nto = \"b\"\n"
             "[[beam.segments]]\nlength = \"4 m\"\nsection = \"b\"\n"));
    const Verification of = verify(project);
    double reported = 0.0, alone = 0.0;
    for (const CheckResult& result : of.checks) {
      if (result.check.criterion != Criterion::patch_loading ||
          result.check.point.find("crab") == std::string::npos)
        continue;
      reported = std::max(reported, result.check.utilisation());
      // At 5 m the flanges kink, which presses with the wheels.
      if (result.check.point.find("kink") == std::string::npos)
        alone = std::max(alone, result.check.utilisation());
    }
    // By hand, instant by instant: two wheels on a beam on two supports.
    const auto runs = run_situations(project, of.model.chosen);
    const auto zones = bending_zones_of(project, runs);
    double most = 0.0;
    const double duration = runs.front().loads.period().value();
    for (int k = 1; k < 4000; ++k) {
      const double t = duration * k / 4000.0;
      const double front = behind + t;
      for (const bool first : {true, false}) {
        const double s = first ? front : front - behind;
        if (s <= 0.0 || s >= 9.0) continue;
        bool on_diaphragm = false;
        for (const Diaphragm& d : project.beam.diaphragms)
          on_diaphragm = on_diaphragm || std::abs(d.s.value() - s) < 1e-3;
        if (on_diaphragm) continue;
        const Station station{si<Length>(s), Side::both};
        const auto plates = slender_plates_at(project, zones, station);
        REQUIRE(plates);
        const CutForces cut = runs.front().loads.diagram_at(si<Time>(t)).at(station);
        const BoxWall& web = plates->box.box().of(BoxPlate::left_web);
        const BoxWall& flange = plates->box.box().of(BoxPlate::top_flange);
        double below = 0.0, above = 9.0;
        for (const Diaphragm& d : project.beam.diaphragms) {
          if (d.s.value() < s) below = std::max(below, d.s.value());
          if (d.s.value() > s) above = std::min(above, d.s.value());
        }
        // EN 1993-1-5, 6.4 and 6.5, written out.
        const double h = web.clear().value(), tw = 0.008, f = 355e6, tf = 0.012;
        const double s_s = std::min(project.beam.introductions.front().stiff_length->value(), h);
        const double k_F = 6.0 + 2.0 * std::pow(h / (above - below), 2);
        const double F_cr = 0.9 * k_F * 210e9 * tw * tw * tw / h;
        const double b_f =
            tw + std::min(0.5 * flange.clear().value(), 15.0 * std::sqrt(235.0 / 355.0) * tf);
        const double l_y =
            std::min(s_s + 2.0 * tf * (1.0 + std::sqrt(b_f / tw + 0.02 * std::pow(h / tf, 2))),
                     above - below);
        const double lambda = std::sqrt(l_y * tw * f / F_cr);
        REQUIRE(lambda > 0.5);
        const double F_Rd = 0.5 / lambda * f * l_y * tw / 1.1;
        const double eta_2 = 0.5e3 * (first ? P : Q) / F_Rd;
        const double eta_1 = plates->box.use(cut);
        most = std::max({most, eta_2, (eta_2 + 0.8 * eta_1) / 1.4});
      }
    }
    CAPTURE(i, behind, P, Q);
    CHECK(most > 0.1);
    CHECK(most <= reported * (1.0 + 1e-6));
    // Nor is more reported than is there, but where both wheels count together.
    if (behind > 1.2) CHECK(alone <= most * (1.0 + 2e-3));
  }
}

TEST_CASE("twice the force, twice the use by it", "[patch]") {
  const auto use = [](double kN) {
    const Verification of =
        verify(project_of(beam(ends + introduction(place(4.5), 200.0), force("hook", 4.5, kN))));
    return patch_at(of, "hook")->check.utilisation();
  };
  // Both eta_1 and eta_2 are linear in the load, whichever governs.
  CHECK(use(-300.0) == Approx(2.0 * use(-150.0)).epsilon(1e-9));
  // From below as from above: the box is alike.
  CHECK(use(300.0) == Approx(use(-300.0)).epsilon(1e-9));
}

TEST_CASE("what would bear a force that a web does not: a thicker web, a diaphragm", "[patch]") {
  const std::string text = beam(ends + introduction(place(4.5), 50.0), force("hook", 4.5, -900.0));
  const Project project = project_of(text);
  const Verification of = verify(project, Figures::without, Advice::with);
  REQUIRE(of.verdict == Verdict::fail);
  REQUIRE(of.checks.front().check.criterion == Criterion::patch_loading);
  const auto find = [&](Remedy::What what) -> const Remedy* {
    for (const Remedy& remedy : of.remedies.found)
      if (remedy.what == what) return &remedy;
    return nullptr;
  };
  const Remedy* const web = find(Remedy::What::webs);
  REQUIRE(web != nullptr);
  const auto verdict_with = [&](double thickness) {
    return verify(
               parse_project("patch.toml", text, {fmt::format("sections.a.web={} mm", thickness)}))
        .verdict;
  };
  CHECK(verdict_with(1e3 * web->value) == Verdict::pass);
  CHECK(verdict_with(1e3 * web->value - 1.0) != Verdict::pass);
  const Remedy* const diaphragms = find(Remedy::What::diaphragms);
  REQUIRE(diaphragms != nullptr);
  // One below the force is enough: the panel between the ends stays.
  CHECK(diaphragms->value == Approx(9.0));
  CHECK(diaphragms->name.find("at 4.5 m") != std::string::npos);
  CHECK(verify(project_of(beam(ends + diaphragm(4.5), force("hook", 4.5, -900.0)))).verdict ==
        Verdict::pass);
}

TEST_CASE("a force that pushes to and fro is one check, by the worse flange", "[patch]") {
  const std::string both =
      "[[situations]]\nname = \"down\"\nloads = { hook = 1.0 }\n"
      "[[situations]]\nname = \"up\"\nloads = { hook = -0.8 }\n";
  const Verification of = verify(project_of(
      beam(ends + introduction(place(4.5), 200.0), force("hook", 4.5, -300.0), 1.0) + both));
  const auto count = std::count_if(of.checks.begin(), of.checks.end(), [](const auto& result) {
    return result.check.id == "patch-loading/4.5/web-under-hook";
  });
  CHECK(count == 1);
  REQUIRE(patch_at(of, "hook") != nullptr);
  CHECK(patch_at(of, "hook")->check.situation == "down");
}

TEST_CASE("introductions that cannot be are refused", "[patch]") {
  const auto said = [](const std::string& lines) -> std::string {
    try {
      static_cast<void>(project_of(beam(lines, force("hook", 4.5, -100.0))));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(said(introduction(place(4.5), 0.0)).empty());
  CHECK(said("[[beam.load_introductions]]\nstation = \"1 m\"\n").find("how the forces come in") !=
        std::string::npos);
  CHECK(said("[[beam.load_introductions]]\nstiff_length = \"1 mm\"\n")
            .find("where the forces come in") != std::string::npos);
  CHECK(said(introduction(stretch(3.0, 2.0), 10.0)).find("ends before it begins") !=
        std::string::npos);
  CHECK(said(introduction(place(9.5), 10.0)).find("behind the end of the beam") !=
        std::string::npos);
}

TEST_CASE("a load introduction to which no force comes says that it is not judged", "[patch]") {
  const Verification of =
      verify(project_of(beam(ends + introduction(place(3.0), 50.0) + introduction(place(4.5), 50.0),
                             force("hook", 4.5, -100.0))));
  REQUIRE(of.not_judged.size() == 1);
  CHECK(of.not_judged.front().what == "load introduction at 3 m");
}

TEST_CASE("a load introduction where no box is says that it is not judged", "[patch]") {
  const std::string text =
      "[case]\nname = \"patch\"\nkind = \"static\"\n[frame]\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[sections.tube]\nkind = \"round tube\"\ndiameter = \"200 mm\"\nwall = \"8 mm\"\n"
      "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"9 m\"\n"
      "section = \"tube\"\n" +
      introduction(place(4.5), 50.0) +
      "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
      "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
      force("hook", 4.5, -10.0) + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
  const Verification of = verify(project_of(text));
  REQUIRE(of.not_judged.size() == 1);
  CHECK(of.not_judged.front().by == Criterion::patch_loading);
}

}  // namespace patch_checks_test
