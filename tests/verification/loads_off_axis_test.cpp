// A load beside the axis of a beam in space is verified on both sides of where it acts, as one on
// the axis is: the jib of the template by hand.

#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace loads_off_axis_test {

using namespace boxbeam;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

/// The template's jib, as good as standing still, with 25 kN at a lug in the middle, `z` above the
/// axis.
std::string jib_with_lug(const std::string& z) {
  std::string text = test::read_file(test::project_file("sections/templates/spatial.toml"));
  text = replaced(text, "D = [\"4 m\", \"0 m\", \"0 m\"] }",
                  "D = [\"4 m\", \"0 m\", \"0 m\"], lug = [\"2 m\", \"0 m\", \"" + z + "\"] }");
  text = replaced(text, "amplitude = \"60 deg\"", "amplitude = \"1e-7 deg\"");
  text = replaced(text, "required = 1.5 ", "required = 1.5\nshear_lag = false ");
  return replaced(text, "[forces.hook]",
                  "[forces.lift]\nkind = \"force\"\npoint = \"jib.lug\"\naxes = \"jib\"\n"
                  "direction = [0.5, 0, 0.866]\nsize = \"25 kN\"\n\n[forces.hook]");
}

Verification verified(const std::string& text) { return verify(parse_project("jib.toml", text)); }

/// The jib by hand, in its own axes: x along it, raised by 10 deg, z up. Boxes of 120 mm with 6 mm
/// all round, 200 mm high at the root and 120 mm at the tip.
struct Hand {
  static constexpr double g = 9.81, raised = 10.0 * std::numbers::pi / 180.0;
  double N = 0.0, V = 0.0, M = 0.0;

  static double height(double s) { return 0.2 - 0.02 * s; }
  static double area(double s) { return 0.12 * height(s) - 0.108 * (height(s) - 0.012); }
  static double inertia(double s) {
    const double h = height(s);
    return (0.12 * h * h * h - 0.108 * std::pow(h - 0.012, 3)) / 12.0;
  }

  /// Cut forces from what acts behind the cut, with the lug's force in it or not.
  Hand(double s, double lug, bool with_lug) {
    const double x = -std::sin(raised), z = -std::cos(raised);  // of gravity
    const double tip = (600.0 * g + 500.0);
    N = tip * x;
    V = tip * z;
    // The load's weight stands 0.5 m before the tip, level; the hook pulls at the tip.
    M = -tip * z * (4.0 - s) + 0.5 * 600.0 * g;
    // Own weight: area linear in s.
    const double l = 4.0 - s, a = area(s), b = area(4.0);
    const double weight = 7850.0 * g * 0.5 * (a + b) * l;
    const double arm = l / 3.0 * (a + 2.0 * b) / (a + b);
    N += weight * x;
    V += weight * z;
    M += -weight * z * arm;
    if (!with_lug) return;
    // The direction is made a unit vector.
    const double unit = 25e3 / std::hypot(0.5, 0.866);
    N += 0.5 * unit;
    V += 0.866 * unit;
    M += 0.5 * unit * lug - 0.866 * unit * (2.0 - s);
  }
  double corner(double s) const {
    return std::abs(N / area(s)) + std::abs(M / inertia(s)) * height(s) / 2;
  }
};

const StationEnvelope& record_at(const Verification& result, double s, Side side) {
  for (const StationEnvelope& station : result.stations) {
    if (station.station.s.value() == s && station.station.side == side) return station;
  }
  FAIL("no record at " << s << to_text(side));
  return result.stations.front();
}

}  // namespace

TEST_CASE("a lug beside the axis of the jib: both sides have their records, as one on the axis") {
  for (const auto& [text, z] : {std::pair{"0 mm", 0.0}, {"-1 mm", -1e-3}, {"50 mm", 0.05}}) {
    CAPTURE(text);
    const Verification result = verified(jib_with_lug(text));
    const Hand before(2.0, z, true), behind(2.0, z, false);
    for (const auto& [side, hand] : {std::pair{Side::before, before}, {Side::behind, behind}}) {
      const StationEnvelope& record = record_at(result, 2.0, side);
      for (const Extreme& extreme :
           {record.of[cut_force::N].smallest, record.of[cut_force::N].largest}) {
        CHECK(extreme.value == Approx(hand.N).epsilon(1e-9));
      }
      for (const Extreme& extreme :
           {record.of[cut_force::V_z].smallest, record.of[cut_force::V_z].largest}) {
        CHECK(std::abs(extreme.value) == Approx(std::abs(hand.V)).epsilon(1e-9));
      }
      for (const Extreme& extreme :
           {record.of[cut_force::M_y].smallest, record.of[cut_force::M_y].largest}) {
        CHECK(std::abs(extreme.value) == Approx(std::abs(hand.M)).epsilon(1e-9));
      }
    }
    // Just before the lug N is highest: the corner there governs, on the side where N pulls as M.
    const CheckResult* yield = result.governing(Criterion::yield);
    REQUIRE(yield != nullptr);
    CHECK(yield->check.station == Station{2.0 * metre, Side::before});
    REQUIRE(yield->basis);
    const PointStress& stress = yield->basis->stress_at_time;
    CHECK(std::abs(stress.normal.value()) == Approx(before.corner(2.0)).epsilon(1e-9));
    // The shear flow beside the web adds less than a hundredth.
    CHECK(yield->check.acting.value() > before.corner(2.0));
    CHECK(yield->check.acting.value() < 1.01 * before.corner(2.0));
  }
}

TEST_CASE("the jib that slews: a millimetre beside the axis changes its factor by a thousandth") {
  // Figures of an independent calculation at z = 0: 122.9 MPa at s = 2-, factor 2.889.
  for (const char* z : {"0 mm", "-1 mm"}) {
    CAPTURE(z);
    std::string text =
        replaced(jib_with_lug(z), "amplitude = \"1e-7 deg\"", "amplitude = \"60 deg\"");
    text = replaced(text, "required = 1.5\nshear_lag = false", "required = 1.5");
    const Verification result = verified(text);
    const CheckResult* yield = result.governing(Criterion::yield);
    REQUIRE(yield != nullptr);
    CHECK(yield->check.station == Station{2.0 * metre, Side::before});
    CHECK(yield->check.acting.value() == Approx(122.9e6).epsilon(2e-3));
    CHECK(yield->check.safety_factor == Approx(2.889).epsilon(2e-3));
  }
}

TEST_CASE("what holds a beam beside its axis, and nothing else: a hung beam of one joint") {
  // Half of the jib's weight on each side of a bearing 50 mm above the axis, in the middle.
  std::string text = jib_with_lug("50 mm");
  text =
      replaced(text, "B = [\"0 m\", \"0 m\", \"0 m\"], D", "B = [\"2 m\", \"0 m\", \"50 mm\"], D");
  text = replaced(text, "start = \"B\"", "# from the origin\n#");
  const Verification result = verified(text);
  const Hand behind(2.0, 0.05, false);
  const StationEnvelope& record = record_at(result, 2.0, Side::behind);
  CHECK(std::abs(record.of[cut_force::M_y].largest.value) ==
        Approx(std::abs(behind.M)).epsilon(1e-9));
  CHECK(record.of[cut_force::N].largest.value == Approx(behind.N).epsilon(1e-9));
}

}  // namespace loads_off_axis_test
