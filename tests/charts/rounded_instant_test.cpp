// The thesis' arithmetic. Its tables E.2 and E.3 lose digits next to the turning points of the
// blade; what that comes from is seen by calculating with so many digits.
// Source: tests/validation/data/thesis_*.csv (supplement to a bachelor thesis, Aalborg University).

#include "charts/rounded_instant.hpp"

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "support/csv.hpp"

namespace rounded_instant_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

const planar::Mechanism& published() {
  static const Project project =
      read_project(test::project_file("sections/sledge-rig/published.toml"));
  return planar_of(project);
}

HarmonicDriver exciter() {
  for (const planar::Joint& joint : published().joints) {
    if (const auto* driven = std::get_if<planar::Driven>(&joint.kind)) {
      return std::get<HarmonicDriver>(driven->driver);
    }
  }
  return {};
}

struct Compared {
  double published = 0.0;  ///< largest difference of the table from the exact values
  double rounded = 0.0;    ///< largest difference of five digits throughout
  double three = 0.0;      ///< of five digits with omega t to three
  double left = 0.0;       ///< of the table from the last of these
  double largest = 0.0;    ///< exact value
};

Compared compared_at(const std::string& table_name, double time) {
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_" + table_name + ".csv"));
  planar::InstantSolver solver(published());
  const planar::State exact = solver.solve_from_sketch(time, sketch_of(published()));
  const bool velocities = table_name == "velocities";
  const auto values = [&](const DriverState& driver) {
    const auto instant = rounded_instant<Decimal<5>>(published(), {driver}, exact.q);
    REQUIRE(instant);
    const InstantIn<double> in_double = instant->in<double>();
    return velocities ? in_double.v : in_double.a;
  };
  const Eigen::VectorXd five = values(rounded_state<Decimal<5>>(exciter(), time));
  const Eigen::VectorXd three = values(rounded_state<Decimal<5>, Decimal<3>>(exciter(), time));
  const Eigen::VectorXd& right = velocities ? exact.v : exact.a;
  Compared result;
  result.largest = right.lpNorm<Eigen::Infinity>();
  result.rounded = (five - right).lpNorm<Eigen::Infinity>();
  result.three = (three - right).lpNorm<Eigen::Infinity>();
  for (const std::vector<double>& row : table.rows) {
    if (row[0] != time) continue;
    for (Eigen::Index k = 0; k < 18; ++k) {
      const double printed = row[static_cast<std::size_t>(k) + 1];
      result.published = std::max(result.published, std::abs(printed - right[k]));
      result.left = std::max(result.left, std::abs(printed - three[k]));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("the argument of a driver rounded to three digits: 4.396 * 0.357 = 1.569372 (by hand)") {
  const DriverState five = rounded_state<Decimal<5>>(exciter(), 0.357);
  const DriverState three = rounded_state<Decimal<5>, Decimal<3>>(exciter(), 0.357);
  // 0.25 * 4.396 = 1.0990 times cos 1.5694 = 0.0013963 and cos 1.57 = 0.00079633.
  CHECK(five.rate == Approx(0.0015345).epsilon(1e-4));
  CHECK(three.rate == Approx(0.00087517).epsilon(1e-4));
}

TEST_CASE("thesis E.2 next to turning points: lost as by omega t to three digits") {
  for (const double time : {0.357, 1.071}) {
    const Compared found = compared_at("velocities", time);
    INFO("t = " << time);
    // The table is wrong by more than half of what moves at all; three digits of omega t are wrong
    // by as much, and leave of the difference what the printed digits do.
    CHECK(found.published > 0.3 * found.largest);
    CHECK(found.three == Approx(found.published).epsilon(0.05));
    CHECK(found.left < 2.5e-5);  // two units of the table's last decimal
    // Five digits throughout lose far less: the loss is the argument's, not the elimination's.
    CHECK(found.rounded < 0.1 * found.published);
    CHECK(found.rounded > 1e-3 * found.largest);
  }
}

TEST_CASE("thesis E.2 at 1.785 s: an argument of 7.83 for 7.84686") {
  // dx3 = 0.0264 printed: cos^-1(0.0264/1.099) before 5 pi/2 is 7.830.
  planar::InstantSolver solver(published());
  const planar::State exact = solver.solve_from_sketch(1.785, sketch_of(published()));
  const HarmonicDriver driver = exciter();
  const DriverState state{driver.mean + driver.amplitude * std::sin(7.83),
                          driver.amplitude * driver.omega * std::cos(7.83), 0.0};
  const auto instant = rounded_instant<double>(published(), {state}, exact.q);
  REQUIRE(instant);
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_velocities.csv"));
  for (const std::vector<double>& row : table.rows) {
    if (row[0] != 1.785) continue;
    for (Eigen::Index k = 0; k < 18; ++k) {
      INFO("column " << k);
      // Of 0.028, printed and calculated with three digits; the table is wrong by up to 0.02.
      CHECK(std::abs(row[static_cast<std::size_t>(k) + 1] - instant->v[k]) < 2e-4);
    }
  }
  // Three digits of the right product, 7.85, lose less: this row has a slip beside the rounding.
  const Compared found = compared_at("velocities", 1.785);
  CHECK(found.three < 0.3 * found.published);
}

TEST_CASE("thesis E.3 next to turning points: lost as by omega to two digits") {
  // 4.4 rad/s for 4.396: accelerations wrong by 2 * 0.004/4.396 = 0.18 %, 9e-3 of 5.12 m/s^2; five
  // digits lose less than a tenth of that.
  for (const double time : {0.357, 1.785}) {
    INFO("t = " << time);
    HarmonicDriver driver = exciter();
    driver.omega = 4.4;
    const Compared found = compared_at("accelerations", time);
    CHECK(found.rounded < 0.2 * found.published);
    const DriverState state = rounded_state<Decimal<5>, Decimal<3>>(driver, time);
    // The blade's acceleration, as printed.
    CHECK(state.acceleration == Approx(-4.84).epsilon(1e-4));
  }
}

}  // namespace rounded_instant_test
