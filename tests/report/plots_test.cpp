// The figures: drawn without a word of gnuplot, legible, with the results' numbers in them.

#include "boxbeam/report/plots.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/format.hpp"
#include "catch.hpp"
#include "src/report/drawing_forms.hpp"
#include "support/program.hpp"
#include "support/rig.hpp"
#include "support/shown_figures.hpp"
#include "support/svg_text.hpp"

namespace plots_test {

using namespace boxbeam;
using test::has;
using test::SvgText;
using test::texts_of;
using test::words_of_gnuplot;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> shipped{
    "sections/sledge-rig/rig.toml",          "sections/sledge-rig/rig-detailed.toml",
    "sections/sledge-rig/published.toml",    "sections/sledge-rig/friction.toml",
    "sections/sledge-rig/slender.toml",      "sections/landing-gear/gear.toml",
    "sections/landing-gear/retraction.toml", "sections/drill-truck/truck.toml",
    "sections/four-bar-rocker/rocker.toml",  "sections/pump-jack/beam.toml",
    "sections/scissor-lift/lift.toml",       "sections/slider-crank-press/press.toml"};

Project shipped_case(const std::string& path) {
  std::optional<Dynamics> dynamics;
  if (path.find("published") != std::string::npos) dynamics = Dynamics::newton_chain;
  return read_project(test::project_file(path), {}, dynamics);
}

/// A case and its figures, drawn into a folder of their own.
struct Drawn {
  explicit Drawn(Project of)
      : project(std::move(of)), verification(verify(project, Figures::with)) {
    files = draw_figures(project, verification, folder.path().string(),
                         (folder.path() / "tex").string());
  }
  std::string svg(const std::string& name) const {
    return test::read_file(folder.path() / (name + ".svg"));
  }

  test::TemporaryFolder folder;
  Project project;
  Verification verification;
  std::vector<std::string> files;
};

/// Every shipped case, drawn once.
const Drawn& drawn(const std::string& path) {
  static std::map<std::string, Drawn> cases;
  const auto found = cases.find(path);
  return found != cases.end() ? found->second
                              : cases.try_emplace(path, shipped_case(path)).first->second;
}

/// The error of drawing the rig with programs of another folder, before those of the path or
/// instead of them. Leaves nothing behind.
std::string words_of_draw_with(const std::string& tools, bool also_path = true) {
  const test::TemporaryFolder folder;
  const Project project = shipped_case("sections/sledge-rig/rig.toml");
  const Verification verification = verify(project);
  const char* const set = std::getenv("PATH");
  const std::string path = set != nullptr ? set : "/usr/bin:/bin";
  setenv("PATH", (also_path ? tools + ":" + path : tools).c_str(), 1);
  std::string message;
  try {
    draw_figures(project, verification, folder.path().string());
  } catch (const OutputError& error) {
    message = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  CHECK(fs::is_empty(folder.path()));
  return message;
}

}  // namespace

TEST_CASE("every figure of every case is drawn without a warning, and its script draws it again",
          "[unsanitized]") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Drawn& figures = drawn(path);
    std::vector<std::string> expected;
    for (const std::string& name : test::shown_figures(figures.project, figures.verification)) {
      CAPTURE(name);
      expected.push_back(name + ".svg");
      const std::string before = figures.svg(name);
      const std::string tex = test::read_file(figures.folder.path() / "tex" / (name + ".tex"));
      // Those of the first page stand abreast.
      const bool half = name == "sketch" || name == "use";
      CHECK(tex.starts_with(half ? "\\begin{drawing}{310}" : "\\begin{drawing}{620}"));
      if (!fs::exists(figures.folder.path() / "plots" / (name + ".gp"))) continue;
      CHECK(words_of_gnuplot(figures.folder.path(), name).empty());
      CHECK(plot::svg_of(plot::drawing_of_gnuplot(figures.svg(name))) == before);
      std::ofstream(figures.folder.path() / (name + ".svg")) << before;  // as it was
    }
    CHECK(figures.files == expected);
    // Nothing but the figures and their scripts stays.
    for (const fs::directory_entry& entry : fs::directory_iterator(figures.folder.path())) {
      const std::string name = entry.path().filename().string();
      CHECK((name.ends_with(".svg") || name == "plots" || name == "tex"));
    }
  }
}

TEST_CASE("every kind of case has its figures, in the order of a report") {
  using Names = std::vector<std::string>;
  const auto names = [](const std::string& path) {
    return test::shown_figures(drawn(path).project, drawn(path).verification);
  };
  CHECK(names("sections/sledge-rig/rig.toml") == Names{"sketch", "use", "mechanism", "motion",
                                                       "cut-forces", "utilisation", "section",
                                                       "stress", "sn"});
  CHECK(names("sections/sledge-rig/published.toml") ==
        Names{"sketch", "mechanism", "motion", "cut-forces", "sn"});
  CHECK(names("sections/landing-gear/retraction.toml") ==
        Names{"sketch", "use", "mechanism", "motion", "cut-forces", "loads", "utilisation",
              "section", "stress", "sn", "spectrum"});
  CHECK(names("sections/drill-truck/truck.toml") ==
        Names{"sketch", "use", "mechanism", "motion", "cut-forces", "utilisation", "section",
              "stress", "sn", "spectrum", "modes", "frequency-response", "joint-forces",
              "sudden-start"});
}

TEST_CASE("a spatial figure shows the three most telling instants and says how many there are") {
  const Drawn& leg = drawn("sections/landing-gear/retraction.toml");
  Verification more = leg.verification;
  REQUIRE(more.pictures.postures.size() == 4);  // one at the beginning
  for (int i = 0; i < 3; ++i) {
    PostureFigure posture = more.pictures.postures.back();
    posture.time = si<Time>(0.011 * (i + 1));
    posture.weight = i == 1 ? 5.0 : 0.001;
    more.pictures.postures.push_back(posture);
  }
  const test::TemporaryFolder folder;
  draw_figures(leg.project, more, folder.path().string());
  const std::string svg = test::read_file(folder.path() / "mechanism.svg");
  const std::vector<SvgText> texts = texts_of(svg);
  CHECK(has(texts, "3 of 6 instants"));
  const auto shown = std::count_if(texts.begin(), texts.end(), [](const SvgText& text) {
    return text.text.starts_with("(") && text.text.find(") t = ") != std::string::npos;
  });
  CHECK(shown == 3);
  CHECK(has(texts, "(5) t = 0.0220 s"));
  CHECK_FALSE(has(texts, "(4) t = "));
  CHECK_FALSE(has(texts, "(6) t = "));
  test::check_legible(svg);
  // High enough for a page without being made smaller: 0.7 of 252 mm where 620 px are 468 pt.
  const std::size_t box = svg.find("viewBox=\"0 0 620 ");
  REQUIRE(box != std::string::npos);
  CHECK(std::stod(svg.substr(box + 17)) <= 0.7 * 252.0 / 25.4 * 72.0 * 620.0 / 468.0);
}

TEST_CASE("figures of cases whose names are long stay legible") {
  for (const auto& [path, joint] : {std::pair{"sections/templates/spatial.toml", "joints.root"},
                                    {"sections/templates/planar.toml", "joints.B"},
                                    {"sections/templates/flexible.toml", "joints.jack"}}) {
    CAPTURE(path);
    std::string text = test::read_file(test::project_file(path));
    const std::size_t at = text.find(joint);
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string(joint).size(),
                 "joints.hinge_of_the_upper_bracket_on_the_left_side");
    const Drawn figures(parse_project("long.toml", text));
    for (const std::string& name : test::shown_figures(figures.project, figures.verification)) {
      CAPTURE(name);
      test::check_legible(figures.svg(name));
    }
  }
}

TEST_CASE("a couple on the beam stands in the figure with its force and its size") {
  const Drawn& jack = drawn("sections/pump-jack/beam.toml");
  const std::vector<SvgText> texts = texts_of(jack.svg("mechanism"));
  std::size_t couples = 0;
  for (std::size_t k = 1; k < jack.verification.pictures.postures.size(); ++k) {
    for (const BeamLoadRow& row : jack.verification.pictures.postures[k].loads) {
      CAPTURE(row.name);
      const std::string force = row.name + "  " + text::kN(row.world.norm());
      CHECK(has(texts, force));
      if (row.name != "H") continue;  // rigidly joined: the others are pins
      ++couples;
      CHECK(row.couple.norm() > 1e3);
      CHECK(has(texts, force + ", " + text::kNm(row.couple.norm())));
    }
  }
  CHECK(couples == jack.verification.pictures.postures.size() - 1);
}

TEST_CASE("an axis that does not begin at zero says so") {
  const std::vector<SvgText> texts = texts_of(drawn("sections/sledge-rig/rig.toml").svg("motion"));
  // The exciter goes from 0.25 to 0.75 m and back: position above zero, speed on both sides.
  CHECK(has(texts, "x [mm]  (axis not from 0)"));
  CHECK_FALSE(has(texts, "v [m/s]  (axis not from 0)"));
}

TEST_CASE("no text of a figure leaves it, is small, or lies on another", "[unsanitized]") {
  for (const std::string& path : shipped) {
    for (const std::string& name :
         test::shown_figures(drawn(path).project, drawn(path).verification)) {
      CAPTURE(path, name);
      test::check_legible(drawn(path).svg(name));
    }
  }
}

TEST_CASE("the values at the extremes are those of the results") {
  const Drawn& rig = drawn("sections/sledge-rig/rig.toml");
  const Verification& verification = rig.verification;
  const std::vector<SvgText> cut = texts_of(rig.svg("cut-forces"));
  const std::vector<SvgText> motion = texts_of(rig.svg("motion"));
  const std::vector<SvgText> mechanism = texts_of(rig.svg("mechanism"));
  for (const CriticalInstant& instant : verification.critical_instants) {
    if (instant.quantity() != "M") continue;
    CHECK(has(cut, text::significant(1e-3 * instant.value) + " ("));
    CHECK(has(cut, "t = " + text::seconds(instant.time.value())));
    CHECK(has(motion, text::seconds(instant.time.value())));
    CHECK(has(mechanism, "t = " + text::seconds(instant.time.value())));
  }
  for (const BeamLoadRow& row : verification.pictures.loads) {
    CHECK(has(mechanism, row.name + "  " + text::kN(row.world.norm())));
  }
  const DriverLine& exciter = verification.pictures.drivers.front();
  CHECK(has(motion, exciter.name));
  CHECK(has(motion, text::significant(
                        1e-3 * *std::max_element(exciter.force.begin(), exciter.force.end()))));
  const CheckResult& worst = *verification.governing(Criterion::fatigue);
  const std::vector<SvgText> along = texts_of(rig.svg("utilisation"));
  CHECK(has(along, text::percent(worst.check.utilisation()) + ": fatigue at s = " +
                       to_text(worst.check.station) + " m, " + worst.check.point));
  const std::vector<SvgText> section = texts_of(rig.svg("section"));
  CHECK(has(section, worst.check.point));
  CHECK(has(section, text::MPa(worst.basis->stress_at_time.normal.value())));
  const std::vector<SvgText> stress = texts_of(rig.svg("stress"));
  CHECK(has(stress, "range " + text::MPa(worst.check.acting.value())));
  CHECK(has(stress, text::MPa(worst.basis->highest.value) + " at " +
                        text::seconds(worst.basis->highest.time.value())));
  CHECK(has(stress, text::MPa(worst.basis->lowest.value) + " at " +
                        text::seconds(worst.basis->lowest.time.value())));
  const std::vector<SvgText> sn = texts_of(rig.svg("sn"));
  // EN 1993-1-9, 7.1: the knee of category 100 at 73.7 MPa, its cut-off at 40.5 MPa.
  CHECK(has(sn, "knee 73.7 MPa"));
  CHECK(has(sn, "cut-off 40.5 MPa"));
  CHECK(has(sn, "m = 3"));
  CHECK(has(sn, "m = 5"));
  CHECK(has(sn, "EN 1993-1-9:2005+AC:2009, category 100"));
}

TEST_CASE("no two lines of a legend are called alike") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    std::set<std::string> names;
    for (const CutForceLine& line : drawn(path).verification.pictures.lines) {
      CHECK(names.insert(text::seconds(line.time.value()) + line.why).second);
    }
  }
}

TEST_CASE("the same case draws the same bytes") {
  const Drawn& first = drawn("sections/sledge-rig/rig.toml");
  const Drawn second(shipped_case("sections/sledge-rig/rig.toml"));
  for (const std::string& name : test::shown_figures(first.project, first.verification)) {
    CAPTURE(name);
    CHECK(first.svg(name) == second.svg(name));
    const fs::path tex = fs::path("tex") / (name + ".tex");
    CHECK(test::read_file(first.folder.path() / tex) ==
          test::read_file(second.folder.path() / tex));
  }
}

TEST_CASE("names stand in figures as the user wrote them, whatever gnuplot would make of them",
          "[unsanitized]") {
  const test::TemporaryFolder folder;
  const std::string touched = (folder.path() / "touched").string();
  // What a shell, gnuplot's strings, its enhanced text, formats or XML would take apart.
  const std::vector<std::string> hostile{"`touch " + touched + "`",
                                         "'; system('touch " + touched + "') #",
                                         "a_b^c{x}@d&e~f",
                                         "100 % %g \\n \\\\",
                                         "<b>&amp;\"q\"",
                                         "''",
                                         "'a''b'",
                                         "\xC3\xB8\xC5\x82\xCE\xA3 @GPVAL_TERM"};
  for (const std::string& name : hostile) {
    CAPTURE(name);
    Project project = test::rig();
    project.situations.front().name = name;
    for (BeamPoint& point : project.beam.points) point.name = name;
    for (planar::Joint& joint : planar_of(project).joints) joint.name = name;
    const Drawn figures(std::move(project));
    CHECK_FALSE(fs::exists(touched));
    // The driver's name stands by itself; where it is too long for its line, its beginning does.
    const std::vector<SvgText> motion = texts_of(figures.svg("motion"));
    CHECK(has(motion, name));
    CHECK(has(texts_of(figures.svg("cut-forces")), name.substr(0, 8)));
    CHECK(has(texts_of(figures.svg("stress")), name));
  }
}

TEST_CASE("what figures leave in a folder is known by name") {
  const test::TemporaryFolder folder;
  const Project project = shipped_case("sections/sledge-rig/rig.toml");
  const Verification verification = verify(project, Figures::with);
  draw_figures(project, verification, folder.path().string());
  CHECK_FALSE(fs::exists(folder.path() / "tex"));
  CHECK(fs::exists(folder.path() / "motion.svg"));
  const std::vector<std::string> known = files_of_figures();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path())) {
    const std::string name = entry.path().lexically_relative(folder.path()).string();
    CAPTURE(name);
    CHECK((entry.is_directory() || std::find(known.begin(), known.end(), name) != known.end()));
  }
}

TEST_CASE("without figures in the verification those that rest on it alone are drawn") {
  const test::TemporaryFolder folder;
  const Project project = shipped_case("sections/sledge-rig/rig.toml");
  const Verification verification = verify(project);
  const std::vector<std::string> files =
      draw_figures(project, verification, folder.path().string());
  CHECK(files == std::vector<std::string>{"sketch.svg", "use.svg", "mechanism.svg",
                                          "cut-forces.svg", "utilisation.svg", "stress.svg",
                                          "sn.svg"});
}

TEST_CASE("where gnuplot is missing the package is named") {
  const test::TemporaryFolder nothing;
  CHECK(words_of_draw_with(nothing.path().string(), false).find("gnuplot-nox") !=
        std::string::npos);
}

TEST_CASE("where gnuplot can write a part only, that is said and nothing is left") {
  const test::TemporaryFolder tools;
  // As on a full disk: half a drawing, and no complaint.
  const std::string fake = tools.write(
      "gnuplot", "#!/bin/sh\nfor f in mechanism cut-forces; do echo '<svg' > $f.svg; done\n");
  fs::permissions(fake, fs::perms::owner_all);
  CHECK(words_of_draw_with(tools.path().string()).find("only a part") != std::string::npos);
}

TEST_CASE("where gnuplot fails its first words are told and nothing is left") {
  const test::TemporaryFolder tools;
  const std::string fake =
      tools.write("gnuplot", "#!/bin/sh\necho 'no terminal today' >&2\nexit 3\n");
  fs::permissions(fake, fs::perms::owner_all);
  CHECK(words_of_draw_with(tools.path().string()).find("no terminal today") != std::string::npos);
}

}  // namespace plots_test
