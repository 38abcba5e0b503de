// What comes into webs at one place, or nearly so, comes in together: torques with forces, loads
// along the beam with each other, what reaches over a border, what stands beside a diaphragm.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace pressed_together_test {

using namespace pressed_beams;

namespace {

/// Of 6 m in space, webs 590 mm apart.
Beam in_space(const std::vector<Load>& forces, double thickness = 16.0) {
  Beam beam;
  beam.space = true;
  beam.pieces = {{6.0, {600, 1000, 25, 10, 0.0}, {600, 1000, 25, 10, 0.0}}};
  beam.diaphragms = {0.0, 6.0};
  beam.thickness = thickness;
  beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
  beam.forces = forces;
  beam.more = introduced(0.0, 6.0, 200.0);
  return beam;
}

double patch_use_of(const Beam& beam) { return use_of(beam.verified(), Criterion::patch_loading); }

/// The largest use of patches with a text in their names.
double uses_of(const Verification& of, const std::string& text) {
  double most = 0.0;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::patch_loading &&
        result.check.point.find(text) != std::string::npos)
      most = std::max(most, result.check.utilisation());
  }
  return most;
}

std::string spread(const std::string& name, double from, double to, double kN_per_m) {
  return fmt::format(
      "[loads.{}]\nkind = \"line\"\nfrom = \"{:.6g} m\"\nto = \"{:.6g} "
      "m\"\nforce_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
      name, from, to, -kN_per_m);
}

/// In the plane, 600 x 1000 x 25 x 8, 6 m.
Beam under_lines(const std::string& lines) {
  Beam beam;
  beam.pieces = {{6.0, {600, 1000, 25, 8, 0.0}, {600, 1000, 25, 8, 0.0}}};
  beam.diaphragms = {0.0, 6.0};
  beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
  beam.more = lines + introduced(0.0, 6.0, 100.0);
  return beam;
}

}  // namespace

TEST_CASE("torques at one place are one torque, and press with the forces there", "[patch]") {
  const double one = patch_use_of(in_space({{"t", 3.0, 0.0, 0.0, 0.0, 0.0, 300.0}}));
  const double two = patch_use_of(
      in_space({{"t", 3.0, 0.0, 0.0, 0.0, 0.0, 150.0}, {"u", 3.0, 0.0, 0.0, 0.0, 0.0, 150.0}}));
  CHECK(two == Approx(one).epsilon(1e-6));
  CHECK(one > 0.2);
  // Over the left web the force presses it alone; the torque adds T/b to it, and lifts the other
  // web by as much: 118 kN m over 590 mm.
  const double both = patch_use_of(
      in_space({{"f", 3.0, 200.0, 0.295, 0.5}, {"t", 3.0, 0.0, 0.0, 0.0, 0.0, -118.0}}));
  const double as_forces =
      patch_use_of(in_space({{"f", 3.0, 400.0, 0.295, 0.5}, {"g", 3.0, -200.0, -0.295, 0.5}}));
  CHECK(both == Approx(as_forces).epsilon(1e-6));
  CHECK(both > 1.5 * patch_use_of(in_space({{"f", 3.0, 200.0, 0.295, 0.5}})));
}

TEST_CASE("a small force does not hide what a torque does to flanges", "[patch]") {
  const auto of = [](double kN) {
    return uses_of(in_space({{"t", 3.0, kN, 0.0, 0.0, 0.0, 600.0}}).verified(),
                   "flange under the torque of");
  };
  CHECK(of(0.0) > 0.1);
  CHECK(of(0.1) == Approx(of(0.0)).epsilon(2e-3));
}

TEST_CASE("a torque of a load comes into flanges as one beside it does", "[patch]") {
  const auto of = [](const std::vector<Load>& loads) {
    return uses_of(in_space(loads).verified(), "flange under the torque of");
  };
  // As a moment it is less than 900 kN could have as their lever somewhere on the section.
  const double in_one = of({{"t", 3.0, 900.0, 0.0, 0.0, 0.0, 250.0}}),
               beside = of({{"f", 3.0, 900.0}, {"t", 3.0, 0.0, 0.0, 0.0, 0.0, 250.0}});
  CHECK(in_one > 0.1);
  CHECK(in_one == Approx(beside).epsilon(1e-6));
  // The lever of the force itself is none.
  CHECK(of({{"t", 3.0, 900.0, 0.25}}) == 0.0);
}

TEST_CASE("a side force in the same load does not move a force", "[patch]") {
  const auto of = [](const std::vector<Load>& loads) {
    Beam beam = in_space(loads);
    beam.pieces = {{6.0, {600, 600, 20, 30, 0.0}, {600, 600, 20, 30, 0.0}}};
    return beam.verified();
  };
  // On the upper flange between the webs, which it bends; 60 kN beside it would put it over a web,
  // were they its lever.
  const Verification split =
                         of({{"f", 3.0, 200.0, 0.18, 0.3}, {"g", 3.0, 0.0, 0.0, 0.3, 0, 0, 60}}),
                     joint = of({{"f", 3.0, 200.0, 0.18, 0.3, 0.0, 0.0, 60.0}});
  CHECK(stops(split, "mm beside the webs"));
  CHECK(stops(joint, "mm beside the webs"));
  CHECK(use_of(joint, Criterion::patch_loading) ==
        Approx(use_of(split, Criterion::patch_loading)).epsilon(1e-6));
  // Over a web it bends nothing, whatever stands beside it.
  CHECK_FALSE(stops(of({{"f", 3.0, 200.0, 0.285, 0.3, 0.0, 0.0, 60.0}}), "mm beside the webs"));
}

TEST_CASE("a force that reaches over a border is borne by the weaker side", "[patch]") {
  const auto of = [](double at, double kN, double stiff_length) {
    Beam beam;
    beam.pieces = {{2.0, {400, 800, 25, 20, 6.0}, {400, 800, 25, 20, 6.0}},
                   {2.0, {400, 800, 25, 6, 6.0}, {400, 800, 25, 6, 6.0}}};
    beam.diaphragms = {0.0, 4.0};
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    beam.forces = {{"f", at, kN}};
    beam.more = introduced(0.0, 4.0, stiff_length) + cycles(1e5, "f = 1");
    return beam.verified();
  };
  const Verification before = of(1.999, 600.0, 200.0), at = of(2.0, 600.0, 200.0),
                     away = of(1.5, 600.0, 200.0);
  // Of 250 mm that are loaded 124 mm lie on the thin web, 99 mm of them stiff.
  const Verification part = of(2.1, 600.0 * 124.0 / 250.0, 99.0);
  CHECK(use_of(before, Criterion::patch_loading) ==
        Approx(use_of(part, Criterion::patch_loading)).epsilon(0.03));
  CHECK(use_of(away, Criterion::patch_loading) < 0.8 * use_of(before, Criterion::patch_loading));
  // What it loads of seams and webs is as much per length wherever it is.
  for (const Criterion criterion : {Criterion::weld, Criterion::patch_fatigue})
    CHECK(use_of(before, criterion) == Approx(use_of(at, criterion)).epsilon(5e-3));
  CHECK(use_of(away, Criterion::patch_fatigue) < 0.8 * use_of(at, Criterion::patch_fatigue));
  // A hair beyond the border is none.
  CHECK(use_of(of(1.876, 600.0, 200.0), Criterion::patch_loading) ==
        Approx(use_of(away, Criterion::patch_loading)).epsilon(0.1));
}

TEST_CASE("torques press with loads along the beam, and shear diaphragms with forces", "[patch]") {
  const auto spread_in_space = [](double kNm) {
    Beam beam = in_space({});
    if (kNm != 0.0) beam.forces = {{"t", 3.0, 0.0, 0.0, 0.0, 0.0, kNm}};
    beam.more +=
        "[loads.q]\nkind = \"line\"\nfrom = \"2.5 m\"\nto = \"3.5 m\"\n"
        "force_per_length = [\"0 kN/m\", \"0 kN/m\", \"-600 kN/m\"]\n";
    return patch_use_of(beam);
  };
  CHECK(spread_in_space(200.0) > 1.3 * spread_in_space(0.0));
  CHECK(spread_in_space(-200.0) == Approx(spread_in_space(200.0)).epsilon(1e-6));
  // Half of the force, and half of the torque over the webs' distance, by the diaphragm's plate.
  const auto of = [](const std::vector<Load>& loads) {
    Beam beam = in_space(loads, 12.0);
    beam.pieces = {{6.0, {1000, 1000, 30, 30, 0.0}, {1000, 1000, 30, 30, 0.0}}};
    beam.diaphragms = {0.0, 3.0, 6.0};
    beam.more = introduced(0.0, 6.0, 400.0);
    return stops(beam.verified(), "uses its plate in shear");
  };
  const Load force{"f", 3.0, 2550.0}, torque{"t", 3.0, 0.0, 0.0, 0.0, 0.0, 2550.0};
  CHECK_FALSE(of({force}));
  CHECK_FALSE(of({torque}));
  CHECK(of({force, torque}));
  CHECK_FALSE(of({{"f", 3.0, 1600.0, 0.0, 0.0, 0.0, 1600.0}}));
}

TEST_CASE("loads along the beam add up, whatever the case writes between them", "[patch]") {
  const double one = patch_use_of(under_lines(spread("q", 2.4, 3.6, 1500.0)));
  CHECK(one > 0.3);
  CHECK(patch_use_of(under_lines(spread("q", 2.4, 2.999, 1500.0) +
                                 spread("r", 3.001, 3.6, 1500.0))) == Approx(one).epsilon(5e-3));
  CHECK(patch_use_of(under_lines(spread("q", 2.4, 3.0, 1500.0) + spread("r", 3.0, 3.6, 1500.0))) ==
        Approx(one).epsilon(1e-6));
  // Unlike ones: between that of the smaller and that of the larger, however unlike.
  const double small = patch_use_of(under_lines(spread("q", 2.4, 3.6, 700.0)));
  for (const double other : {690.0, 710.0, 740.0, 760.0}) {
    const double use =
        patch_use_of(under_lines(spread("q", 2.4, 3.0, 1500.0) + spread("r", 3.0, 3.6, other)));
    CHECK(use > small);
    CHECK(use < one);
    // All of the larger one on 600 of the 950 mm that the webs are deep.
    CHECK(use == Approx((600.0 * 1500.0 + 350.0 * other) / (950.0 * 1500.0) * one).epsilon(0.03));
  }
  // A force just beyond the end as one just before it.
  const auto with = [](double at) {
    Beam beam = under_lines(spread("q", 2.4, 3.0, 1000.0));
    beam.forces = {{"f", at, 400.0}};
    return patch_use_of(beam);
  };
  CHECK(with(3.005) == Approx(with(2.995)).epsilon(0.02));
}

TEST_CASE("what webs hardly feel of a load along the beam counts beside a force", "[patch]") {
  // Stout webs; the load alone is below what is looked at.
  const auto of = [](double kN_per_m) {
    Beam beam;
    beam.pieces = {{6.0, {600, 600, 25, 20, 0.0}, {600, 600, 25, 20, 0.0}}};
    beam.diaphragms = {0.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", 3.0, 1500.0}};
    beam.more = introduced(0.0, 6.0, 100.0);
    if (kN_per_m > 0.0) beam.more = spread("q", 2.6, 3.4, kN_per_m) + beam.more;
    return patch_use_of(beam);
  };
  CHECK(of(700.0) > 1.05 * of(0.0));
}

TEST_CASE("loads along the beam that are in balance pass through the webs", "[patch]") {
  Beam beam = under_lines(spread("q", 2.5, 3.5, 2500.0) + spread("r", 2.5, 3.5, -2500.0));
  beam.forces = {{"f", 1.0, 1.0}};
  const Verification of = beam.verified();
  CHECK(use_of(of, Criterion::patch_loading) > 1.0);
}

TEST_CASE("a diaphragm under a pad beside it takes the force", "[patch]") {
  const auto of = [](double at) {
    Beam beam;
    beam.pieces = {{6.0, {600, 1000, 25, 12, 0.0}, {600, 1000, 25, 12, 0.0}}};
    beam.diaphragms = {0.0, 3.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    beam.forces = {{"f", at, 900.0}};
    beam.more = introduced(0.5, 5.5, 200.0);
    std::string text = beam.text();
    const std::string plate = "station = \"3 m\"\n";
    text.insert(text.find(plate) + plate.size(), "throat = \"4 mm\"\n");
    return verify(parse_project("beside.toml", text));
  };
  CHECK(use_of(of(3.001), Criterion::weld) ==
        Approx(use_of(of(3.0), Criterion::weld)).epsilon(1e-6));
  CHECK(use_of(of(3.3), Criterion::weld) < 0.5 * use_of(of(3.0), Criterion::weld));
}

TEST_CASE("fillets of a diaphragm under a force at every cycle: root, by hand", "[patch]") {
  // 500 kN, a quarter of it in each weld with the flange: half a web's on either face.
  Beam beam;
  beam.pieces = {{2.0, {400, 600, 40, 16, 14.0}, {400, 600, 40, 16, 14.0}}};
  beam.diaphragms = {0.0, 1.0, 2.0};
  beam.supports = {{0.0, 0.0}, {2.0, 0.0}};
  beam.forces = {{"f", 1.0, 500.0}};
  beam.more = cycles(2e6, "f = 1");
  std::string text = beam.text();
  for (const char* const at : {"0 m", "1 m", "2 m"}) {
    const std::string plate = fmt::format("station = \"{}\"\n", at);
    text.insert(text.find(plate) + plate.size(), "throat = \"4 mm\"\n");
  }
  const Verification of = verify(parse_project("fillets.toml", text));
  const CheckResult* const worst = of.governing(Criterion::patch_fatigue);
  REQUIRE(worst != nullptr);
  CHECK(worst->check.point == "weld of flange and diaphragm beside web under f");
  // 368 mm between the webs, half of it beside each: 184 mm less two throats, on both faces.
  const double stress = 250e3 / (2.0 * 4.0 * (184.0 - 8.0));
  CHECK(worst->check.utilisation() == Approx(stress / (36.0 / 1.35)).epsilon(1e-6));
}

TEST_CASE("a force on the flange below is judged by that flange", "[patch]") {
  const auto of = [](double top, double bottom, double z) {
    Beam beam = in_space({{"hook", 2.5, 100.0, 0.0, z}});
    std::string text = beam.text();
    for (std::size_t at = 0; (at = text.find("flange = \"25 mm\"", at)) != std::string::npos; ++at)
      text.replace(at, 16,
                   fmt::format("top_flange = \"{} mm\"\nbottom_flange = \"{} mm\"", top, bottom));
    return verify(parse_project("hook.toml", text));
  };
  CHECK(stops(of(40.0, 10.0, -0.5), "flange under hook"));
  CHECK(stops(of(10.0, 40.0, 0.5), "flange under hook"));
  CHECK_FALSE(stops(of(40.0, 40.0, -0.5), "flange under hook"));
}

TEST_CASE("bosses in webs lead no force across into them", "[patch]") {
  const auto of = [](const std::string& into) {
    Beam beam;
    beam.space = true;
    beam.pieces = {{6.0, {600, 600, 20, 8, 0.0}, {600, 600, 20, 8, 0.0}}};
    beam.diaphragms = {0.0, 6.0};
    beam.supports = {{0.0, 0.0}, {6.0, 0.0}};
    std::string text = beam.text();
    text +=
        "[loads.f]\nkind = \"force\"\nat = [\"3 m\", \"0 m\", \"0 m\"]\nforce = [\"0 kN\", "
        "\"400 kN\", \"0 kN\"]\n";
    if (!into.empty())
      text.insert(text.find("[supports.a]"),
                  "[[beam.load_introductions]]\nfrom = \"2.9 m\"\nto = \"3.1 m\"\n" + into);
    return verify(parse_project("lateral.toml", text));
  };
  CHECK(of("").verdict == Verdict::not_applicable);
  CHECK(of("into = \"webs\"\n").verdict == Verdict::not_applicable);
}

TEST_CASE("what is not judged beside webs is said", "[patch]") {
  // A couple between the ends, as that of a bracket.
  Beam bracket = under_lines("");
  bracket.forces = {{"bracket", 3.0, 0.0, 0.0, 0.0, 900.0}};
  CHECK(says(bracket.verified(), "its moment, 900 kN m, is not judged as forces"));
  // Slender webs held without a diaphragm.
  Beam bare = under_lines("");
  bare.diaphragms.clear();
  bare.forces = {{"f", 3.0, 10.0}};
  CHECK(says(bare.verified(), "no diaphragm where they are held"));
  bare.diaphragms = {0.0, 6.0};
  CHECK_FALSE(says(bare.verified(), "no diaphragm where they are held"));
}

TEST_CASE("a diaphragm between unlike webs is firm or not from either end", "[patch]") {
  for (const double thickness : {5.0, 7.0, 9.0}) {
    Beam beam;
    beam.pieces = {{2.0, {400, 800, 25, 20, 0.0}, {400, 800, 25, 20, 0.0}},
                   {2.0, {400, 800, 25, 6, 0.0}, {400, 800, 25, 6, 0.0}}};
    beam.diaphragms = {2.0};
    beam.thickness = thickness;
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    beam.forces = {{"f", 2.0, 300.0}};
    CHECK(beam.verified().verdict == beam.mirrored().verified().verdict);
  }
}

TEST_CASE("where a box goes on as a tube its flanges end", "[patch]") {
  Beam beam;
  beam.pieces = {{2.0, {400, 600, 20, 10, 0.0}, {400, 600, 20, 10, 0.0}}};
  beam.supports = {{0.0, 0.0}};
  std::string text = beam.text();
  text.insert(text.find("[beam]\n"),
              "[sections.t]\nkind = \"round tube\"\ndiameter = \"500 mm\"\nwall = \"20 mm\"\n");
  text.insert(text.find("[supports.a]"), "[[beam.segments]]\nlength = \"2 m\"\nsection = \"t\"\n");
  text +=
      "[supports.end]\nkind = \"roller\"\nat = \"4 m\"\n[loads.f]\nkind = \"force\"\nat = \"2 "
      "m\"\nforce = [\"0 kN\", \"-300 kN\"]\n";
  CHECK(stops(verify(parse_project("tube.toml", text)), "it ends where none goes on"));
}

}  // namespace pressed_together_test
