// The section of the governing check as it is drawn.

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/pictures.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/cantilever.hpp"
#include "support/rig.hpp"

namespace section_figure_test {

using namespace boxbeam;

namespace {

Verification drawn(const Project& project) { return verify(project, Figures::with); }

/// Area of polygons by the shoelace formula; hollows turn clockwise and count negative.
double area_of(const SectionFigure& figure) {
  double twice = 0.0;
  for (const auto& loop : figure.outlines) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [y_a, z_a] = loop[i];
      const auto& [y_b, z_b] = loop[(i + 1) % loop.size()];
      twice += y_a * z_b - y_b * z_a;
    }
  }
  return 0.5 * twice;
}

const CheckResult& governing_of(const Verification& verification) {
  for (const CheckResult& result : verification.checks) {
    if (result.basis) return result;
  }
  throw std::runtime_error("no check rests on cut forces");
}

const std::vector<std::string> shipped{
    "sections/sledge-rig/rig.toml",           "sections/sledge-rig/rig-detailed.toml",
    "sections/four-bar-rocker/rocker.toml",   "sections/landing-gear/retraction.toml",
    "sections/slider-crank-press/press.toml", "sections/pump-jack/beam.toml"};

}  // namespace

TEST_CASE("the drawn outline encloses the area of the section") {
  for (const std::string& path : shipped) {
    CAPTURE(path);
    const Verification verification = drawn(read_project(test::project_file(path)));
    const SectionFigure& figure = *verification.pictures.section;
    const Section& section = governing_of(verification).basis->point.section;
    CHECK(area_of(figure) == Approx(properties_of(section).area.value()).epsilon(1e-12));
    CHECK(figure.station == governing_of(verification).check.station);
  }
}

TEST_CASE("arcs of a tube are drawn as chords: the area is that of the tube within their sagitta") {
  // A chord of at most 0.05 rad leaves 1 - sin(a)/a < 4.2e-4 of the sector's area.
  for (const std::string section :
       {"kind = \"round tube\"\ndiameter = \"200 mm\"\nwall = \"8 mm\"\n",
        "kind = \"rectangular tube\"\nwidth = \"100 mm\"\nheight = "
        "\"160 mm\"\nwall = \"8 mm\"\nouter_radius = \"12 mm\"\n"
        "inner_radius = \"4 mm\"\n"}) {
    CAPTURE(section);
    const Verification verification =
        drawn(test::cantilever(section, {{Eigen::Vector3d(1e3, 2e3, 3e3), 100.0}}));
    const double exact =
        properties_of(governing_of(verification).basis->point.section).area.value();
    CHECK(area_of(*verification.pictures.section) == Approx(exact).epsilon(4.2e-4));
    CHECK(verification.pictures.section->outlines.size() == 2);
  }
}

TEST_CASE("the stress across the height is N/A + M_y z/I_y between its instants") {
  const Verification verification = drawn(test::rig());
  const SectionFigure& figure = *verification.pictures.section;
  const CheckResult& governing = governing_of(verification);
  const SectionProperties& net = governing.basis->point.net;
  // At both instants of the governing range, by hand; the extremes reach at least so far, and at
  // the governing fibre they are these.
  for (const CutForces& cut : {governing.basis->cut_at_highest, governing.basis->cut_at_lowest}) {
    for (const SectionFigure::Level& level : figure.across) {
      const double z = level.z - net.centroid_z.value();
      const double stress =
          cut.N.value() / net.area.value() + cut.M_y.value() * z / net.I_y.value();
      CHECK(stress <= level.highest + 1.0);
      CHECK(stress >= level.lowest - 1.0);
    }
  }
  REQUIRE(governing.check.point == "fibre +z");
  CHECK(figure.across.back().highest == Approx(governing.basis->highest.value).epsilon(1e-9));
  CHECK(figure.across.back().lowest == Approx(governing.basis->lowest.value).epsilon(1e-9));
}

TEST_CASE("every checked place of the station is drawn once with its worst utilisation") {
  const Verification verification =
      drawn(read_project(test::project_file("sections/landing-gear/retraction.toml")));
  const SectionFigure& figure = *verification.pictures.section;
  std::size_t governs = 0;
  for (const SectionFigure::Point& point : figure.points) {
    double worst = 0.0;
    for (const CheckResult& result : verification.checks) {
      const bool here = result.basis && result.check.station == figure.station;
      if (here && result.check.point == point.name)
        worst = std::max(worst, result.check.utilisation());
    }
    CHECK(point.utilisation == worst);
    if (point.governs) ++governs;
  }
  CHECK(governs == 1);
  CHECK(figure.points.front().governs);
  CHECK(figure.points.front().stress ==
        governing_of(verification).basis->stress_at_time.normal.value());
}

TEST_CASE("holes are drawn as the strips they take out of the section") {
  const Project project =
      read_project(test::project_file("sections/slider-crank-press/press.toml"));
  const Verification verification = drawn(project);
  const SectionFigure& figure = *verification.pictures.section;
  const Section& section = governing_of(verification).basis->point.section;
  const std::vector<Hole> holes = holes_at(project, figure.station.s);
  REQUIRE(figure.holes.size() == 2);
  double strips = 0.0;
  for (const SectionFigure::Hole& hole : figure.holes) strips += hole.width * hole.height;
  const Area missing = properties_of(section).area - properties_of(section, holes).area;
  CHECK(strips == Approx(missing.value()).epsilon(1e-12));
}

TEST_CASE("without cut forces there is no section to draw, and without figures none is made") {
  const Project published = read_project(test::project_file("sections/sledge-rig/published.toml"),
                                         {}, Dynamics::newton_chain);
  CHECK_FALSE(drawn(published).pictures.section);
  const Verification plain = verify(test::rig());
  CHECK_FALSE(plain.pictures.section);
  CHECK(plain.pictures.cycles.empty());
  CHECK(plain.pictures.drivers.empty());
}

}  // namespace section_figure_test
