// A beam is judged by its geometry: the same beam cut into more segments has the same verdict and
// the same utilisations.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace cut_into_segments_test {

using namespace boxbeam;

namespace {

/// Width, height, top and bottom flange, left and right web [mm].
using Sizes = std::array<double, 6>;

Sizes between(const Sizes& from, const Sizes& to, double part) {
  Sizes at{};
  for (std::size_t k = 0; k < at.size(); ++k) at[k] = from[k] + part * (to[k] - from[k]);
  return at;
}

std::string section_text(const std::string& name, const Sizes& of) {
  return fmt::format(
      "[sections.{}]\nkind = \"box\"\nwidth = \"{:.17g} mm\"\nheight = \"{:.17g} mm\"\n"
      "top_flange = \"{:.17g} mm\"\nbottom_flange = \"{:.17g} mm\"\nleft_web = \"{:.17g} mm\"\n"
      "right_web = \"{:.17g} mm\"\n",
      name, of[0], of[1], of[2], of[3], of[4], of[5]);
}

/// A lever pinned at 0, held by a cylinder at 1.2 m: straight up to there, then `taper` long to a
/// deeper tip; each of both parts in so many segments. `load` at 1.5 m and `behind`: further
/// tables.
std::string lever(const Sizes& root, const Sizes& tip, double taper, double load, int pieces,
                  const std::string& behind = "") {
  std::string sections, segments;
  const auto part = [&](const std::string& name, const Sizes& from, const Sizes& to,
                        double length) {
    for (int k = 0; k < pieces; ++k) {
      sections += section_text(fmt::format("{}{}a", name, k), between(from, to, 1.0 * k / pieces));
      sections +=
          section_text(fmt::format("{}{}b", name, k), between(from, to, (k + 1.0) / pieces));
      segments += fmt::format(
          "[[beam.segments]]\nlength = \"{:.17g} m\"\nfrom = \"{}{}a\"\nto = \"{}{}b\"\n",
          length / pieces, name, k, name, k);
    }
  };
  part("r", root, root, 1.2);
  part("t", root, tip, taper);
  const auto forces = [&](const char* key, double by) {
    return fmt::format("\"{}.force\" = [\"0 kN\", \"0 kN\", \"{:.17g} kN\"]\n", key, by);
  };
  return "[case]\nname = \"lever\"\nkind = \"loads\"\n" + sections +
         "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + behind +
         fmt::format(
             "[loads.load]\nstation = \"1.5 m\"\nforce = [\"0 kN\", \"0 kN\", \"{:.17g} kN\"]\n"
             "[loads.cylinder]\nstation = \"1.2 m\"\n"
             "force = [\"0 kN\", \"0 kN\", \"{:.17g} kN\"]\n",
             -load, 1.25 * load) +
         "[balance]\nstation = \"0 m\"\nname = \"pin\"\nheld = [\"0 m\", \"1.2 m\"]\n"
         "[[situations]]\nname = \"loaded\"\n[[situations]]\nname = \"down\"\n[situations.set]\n" +
         forces("loads.load", -0.4 * load) + forces("loads.cylinder", 0.5 * load) +
         "[[situations]]\nname = \"lifting\"\nbetween = [\"loaded\", \"down\"]\ncycles = 1e4\n"
         "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.5\n"
         "[fatigue]\ncategory = 71\nloading = \"spectrum\"\ngamma_Mf = 1.35\nrequired = 1.0\n";
}

struct Judged {
  Verdict verdict = Verdict::pass;
  std::map<Criterion, double> uses;
};

Judged judged(const std::string& text) {
  const Verification of = verify(parse_project("lever.toml", text));
  Judged judged{of.verdict, {}};
  for (const CheckResult& result : of.checks) {
    double& most = judged.uses[result.check.criterion];
    most = std::max(most, result.check.utilisation());
  }
  return judged;
}

template <class Case>
void check_alike(const Case& in_pieces) {
  const Judged whole = judged(in_pieces(1));
  for (const int pieces : {2, 5, 20}) {
    CAPTURE(pieces);
    const Judged cut = judged(in_pieces(pieces));
    CHECK(cut.verdict == whole.verdict);
    CHECK(cut.uses.size() == whole.uses.size());
    for (const auto& [criterion, use] : whole.uses) {
      CAPTURE(to_text(criterion));
      REQUIRE(cut.uses.count(criterion) == 1);
      CHECK(cut.uses.at(criterion) == Approx(use).epsilon(1e-3));
    }
  }
}

const Sizes stout{349, 163, 14, 5, 6, 6}, deep{393, 539, 14, 14, 6, 6};

}  // namespace

TEST_CASE("a taper from stout to slender webs is judged alike in any number of segments",
          "[segments]") {
  // c/t of the webs: (163 - 19)/6 = 24 at the cylinder, (539 - 28)/6 = 85 at the tip; 72 eps/eta is
  // 48.8, of S355.
  check_alike([](int pieces) { return lever(stout, deep, 1.8, 110.0, pieces); });
}

TEST_CASE("a force is looked at where the web within its reach is slender, wherever segments end",
          "[segments]") {
  // At 1.5 m the web is that of a deeper root, (440 - 19)/6 = 70 and more.
  const Sizes root{349, 440, 14, 5, 6, 6};
  const auto in_pieces = [&](int pieces) { return lever(root, deep, 1.8, 300.0, pieces); };
  CHECK(judged(in_pieces(1)).verdict == Verdict::not_applicable);
  check_alike(in_pieces);
}

TEST_CASE("a hole keeps the plates of its panel from being judged, wherever segments end",
          "[segments]") {
  // From 1.28 m to 2.46 m; its web is stout at the hole, c/t 45, and slender at its end, 50.
  std::string tables;
  for (const char* s : {"0", "1.28", "2.46", "3"})
    tables += fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"10 mm\"\n", s);
  tables +=
      "[[beam.holes]]\nname = \"h\"\ndiameter = \"40 mm\"\nstation = \"2.143 m\"\n"
      "through = \"webs\"\nlevels = [\"0 mm\"]\nconcentration = \"in-plane bending\"\n";
  const Sizes from{216, 322, 9, 9, 10, 13}, to{145, 615, 13, 13, 10, 13};
  const auto in_pieces = [&](int pieces) { return lever(from, to, 1.8, 60.0, pieces, tables); };
  CHECK(judged(in_pieces(1)).verdict == Verdict::not_applicable);
  check_alike(in_pieces);
}

TEST_CASE("a steep taper is a rectangle as wide as it becomes, wherever segments end",
          "[segments]") {
  // 376 mm in 0.8 m: 25 degrees at either edge together, above 10.
  check_alike([](int pieces) { return lever(stout, deep, 0.8, 60.0, pieces); });
}

}  // namespace cut_into_segments_test
