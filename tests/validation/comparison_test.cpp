// The table "published / recomputed / reason" of sections/sledge-rig/README.md: every recomputed
// number in it is computed here and must agree with what is printed there.

#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/newton_chain.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/csv.hpp"
#include "support/rig.hpp"

namespace comparison_test {

using namespace boxbeam;

namespace {

struct Row {
  std::string key, quantity, published, recomputed, reason;
};

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// The rows of the table whose first column is a key in backticks.
std::vector<Row> rows_of_readme() {
  std::vector<Row> rows;
  std::istringstream text(test::read_file(test::project_file("sections/sledge-rig/README.md")));
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::istringstream cells(line.substr(1));
    std::vector<std::string> parts;
    for (std::string cell; std::getline(cells, cell, '|');) parts.push_back(trimmed(cell));
    REQUIRE(parts.size() == 5);
    rows.push_back(
        {parts[0].substr(1, parts[0].size() - 2), parts[1], parts[2], parts[3], parts[4]});
  }
  return rows;
}

/// Half a unit of the last digit of a printed number: what rounding may have taken.
double rounding_of(const std::string& number) {
  const auto exponent_at = number.find('e');
  const std::string mantissa = number.substr(0, exponent_at);
  const auto point = mantissa.find('.');
  const int decimals =
      point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  const int exponent =
      exponent_at == std::string::npos ? 0 : std::stoi(number.substr(exponent_at + 1));
  return 0.5 * std::pow(10.0, exponent - decimals);
}

double largest_deviation(const std::string& table_name, double time,
                         Eigen::VectorXd planar::State::*values) {
  static const Project project =
      read_project(test::project_file("sections/sledge-rig/published.toml"));
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_" + table_name + ".csv"));
  planar::InstantSolver solver(planar_of(project));
  double largest = 0.0;
  for (const std::vector<double>& row : table.rows) {
    if (time >= 0.0 && row[0] != time) continue;
    const planar::State state =
        solver.solve_from_sketch(row[0], planar::sketch_of(planar_of(project)));
    for (std::size_t k = 0; k < 18; ++k) {
      largest =
          std::max(largest, std::abs((state.*values)[static_cast<Eigen::Index>(k)] - row[k + 1]));
    }
  }
  return largest;
}

planar::ChainForces published_chain() {
  const Project project = read_project(test::project_file("sections/sledge-rig/published.toml"));
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_accelerations.csv"));
  std::vector<Eigen::Vector2d> accelerations;
  for (const std::size_t body : {3, 2, 1, 4, 5, 6}) {
    accelerations.emplace_back(table.rows[2][3 * (body - 1) + 1],
                               table.rows[2][3 * (body - 1) + 2]);
  }
  return planar::chain_of(*project.chain, accelerations);
}

/// The chain's moments n_i = J_i alpha_i + n_(i-1) with the published accelerations.
std::vector<double> published_moments() {
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_accelerations.csv"));
  const std::vector<double>& row = table.rows[2];
  const double n2 = 7.43 * row[6];
  const double n1 = 4825.0 * row[3] + n2;
  const double n4 = 5346.0 * row[12] + n1;
  return {n2, n1, n4, 18.0 * row[15]};
}

Section box(double height) {
  return {symmetric_box(0.4 * metre, si<Length>(height), 0.05 * metre, 0.05 * metre), {}};
}

const Section& rig_tube() { return test::rig().beam.segments.back().from; }

double area(const Section& section) { return properties_of(section).area.value(); }

double weight(double area_m2, double gravity) { return 7800.0 * area_m2 * gravity; }

Eigen::Vector2d rigorous_force(const char* joint, int lower_branch) {
  Project project = test::rig();
  planar_of(project).loops[1].sign = lower_branch;
  planar::InstantSolver solver(planar_of(project));
  const planar::State state =
      solver.solve_from_sketch(1.071, planar::sketch_of(planar_of(project)));
  for (const planar::Reaction& r :
       planar::reactions_per_joint(planar_of(project), state, project.beam_body)) {
    if (planar_of(project).joints[static_cast<std::size_t>(r.joint)].name == joint) return r.force;
  }
  return Eigen::Vector2d::Zero();
}

/// The rig with flanges of their whole width, as the published calculation has them.
const Verification& rig() {
  static const Verification verification = [] {
    Project project = test::rig();
    project.strength.shear_lag = false;
    return verify(project);
  }();
  return verification;
}

/// The rig as its case has it, with shear lag.
const Verification& rig_with_lag() {
  static const Verification verification = verify(test::rig());
  return verification;
}

const ShearLag& governing_lag() {
  return *rig_with_lag().governing(Criterion::fatigue)->basis->point.lag;
}

const Check& check(const std::string& id) {
  for (const CheckResult& result : rig().checks) {
    if (result.check.id == id) return result.check;
  }
  throw std::runtime_error("no check " + id);
}

double mass_between(double from, double to) {
  return mass_properties_of(test::rig().beam, si<Length>(from), si<Length>(to)).mass.value();
}

double centre_from_pivot(double from, double to) {
  return std::abs(
      mass_properties_of(test::rig().beam, si<Length>(from), si<Length>(to)).centre.value() - 3.2);
}

const std::vector<Hole>& pivot_holes() {
  static const std::vector<Hole> holes = holes_at(test::rig(), 3.2 * metre);
  return holes;
}

/// Bending moment at the pivot from the published end force and its arm, and what follows.
double moment_from_published_ends() { return 102885.0 * 3.0; }

std::map<std::string, std::function<double()>> computed() {
  const double pi_row[] = {0.357, 0.714, 1.071, 1.428, 1.785, 2.142};
  std::map<std::string, std::function<double()>> values;
  values["E.1"] = [] { return largest_deviation("positions", -1.0, &planar::State::q); };
  for (const double t : pi_row) {
    std::ostringstream name;
    name << t;
    values["E.2 " + name.str()] = [t] {
      return largest_deviation("velocities", t, &planar::State::v);
    };
    values["E.3 " + name.str()] = [t] {
      return largest_deviation("accelerations", t, &planar::State::a);
    };
  }
  values["dof"] = [] { return 1.0 * rig().motions.front().closure->freedom.by_rank; };
  values["g"] = [] { return -planar_of(test::rig()).gravity.y(); };
  values["d/w"] = [] { return -std::log(2.66 / 2.68750) / 0.7128; };
  values["J1"] = [] { return 2427 * 1.410 * 1.410; };
  values["J2"] = [] { return planar_of(test::rig()).bodies[1].inertia; };
  values["J4"] = [] { return 3097 * 1.314 * 1.314; };
  values["J5"] = [] { return planar_of(test::rig()).bodies[3].inertia; };
  values["J beam"] = [] { return rig().beam_mass.inertia.value(); };
  values["F3"] = [] { return published_chain().g[0].x() / 1e3; };
  values["g2 x"] = [] { return published_chain().g[1].x() / 1e3; };
  values["g2 y"] = [] { return published_chain().g[1].y(); };
  values["g2 n"] = [] { return published_moments()[0]; };
  values["g1 x"] = [] { return published_chain().g[2].x(); };
  values["g1 y"] = [] { return published_chain().g[2].y(); };
  values["g1 n"] = [] { return published_moments()[1]; };
  values["g4 x"] = [] { return published_chain().g[3].x(); };
  values["g4 y"] = [] { return published_chain().g[3].y(); };
  values["g4 n"] = [] { return published_moments()[2]; };
  values["g5 x"] = [] { return published_chain().g[4].x() / 1e3; };
  values["g5 y"] = [] { return published_chain().g[4].y(); };
  values["g5 n"] = [] { return published_moments()[3]; };
  values["m6"] = [] { return published_chain().sought_mass; };
  values["m6 exact"] = [] {
    const Project project = read_project(test::project_file("sections/sledge-rig/published.toml"));
    return verify(project).chain->chain_mass.value();
  };
  values["m_eq"] = [] { return rig().equivalent_mass->given; };
  values["m6 for 20 t"] = [] { return rig().equivalent_mass->needed; };
  values["B x"] = [] { return rigorous_force("B", 1).x() / 1e3; };
  values["C x"] = [] { return rigorous_force("C", 1).x() / 1e3; };
  values["C y drawn"] = [] { return rigorous_force("C", 1).y() / 1e3; };
  values["C y flipped"] = [] { return rigorous_force("C", -1).y() / 1e3; };
  values["A1"] = [] { return area(box(0.6)) * 1e3; };
  values["A2"] = [] { return area(box(1.0)) * 1e3; };
  values["A_tube"] = [] { return area(rig_tube()) * 1e3; };
  values["q1"] = [] { return weight(0.090, 9.815) / 1e3; };
  values["q2"] = [] { return weight(0.130, 9.815) / 1e3; };
  values["q5"] = [] { return weight(0.090 + 0.0749, 9.815) / 1e3; };
  values["q6"] = [] { return weight(0.0749, 9.815) / 1e3; };
  values["m upper"] = [] { return mass_between(3.2, 6.2); };
  values["m lower"] = [] { return mass_between(0.0, 3.2); };
  values["c upper"] = [] { return centre_from_pivot(3.2, 6.2); };
  values["c lower"] = [] { return centre_from_pivot(0.0, 3.2); };
  values["R_x"] = [] { return (102.885 + 96.350); };
  values["R_x rigorous"] = [] { return -rigorous_force("O", 1).x() / 1e3; };
  values["R_y"] = [] { return (mass_between(0.0, 6.2)) * 9.815 / 1e3; };
  values["R_y rigorous"] = [] { return rigorous_force("O", 1).y() / 1e3; };
  values["A_holes"] = [] {
    return (area(box(1.0)) - properties_of(box(1.0), pivot_holes()).area.value()) * 1e6;
  };
  values["A_net"] = [] { return properties_of(box(1.0), pivot_holes()).area.value() * 1e6; };
  values["I"] = [] { return properties_of(box(1.0)).I_y.value() * 1e3; };
  values["I net"] = [] { return properties_of(box(1.0), pivot_holes()).I_y.value() * 1e3; };
  values["Q_B"] = [] { return first_moment_beyond(box(1.0), {}, 0.475 * metre, {}).value() * 1e3; };
  values["M pivot"] = [] { return moment_from_published_ends() / 1e3; };
  values["M pivot rigorous"] = [] {
    double largest = 0.0;
    for (const CriticalInstant& c : rig().critical_instants) {
      if (c.quantity() == "M") largest = std::max(largest, c.value);
    }
    return largest / 1e3;
  };
  values["sigma_A"] = [] { return moment_from_published_ends() * 0.5 / 15.1e-3 / 1e6; };
  values["sigma_A rigorous"] = [] { return check("yield/3.2+/thesis-A").acting.value() / 1e6; };
  values["sigma_B"] = [] { return moment_from_published_ends() * 0.475 / 15.1e-3 / 1e6; };
  values["tau_B wall"] = [] { return 102.5e3 * 4.88e-3 / (15.1e-3 * 0.1) / 1e6; };
  values["tau_B width"] = [] { return 102.5e3 * 4.88e-3 / (15.1e-3 * 0.4) / 1e6; };
  values["sigma_vm B"] = [] { return std::hypot(5.43, std::sqrt(3.0) * 0.84); };
  values["K_t"] = [] { return published_concentration(0.145); };
  values["K_t sigma_A"] = [] { return 2.66 * 6.14; };
  values["K_t sigma_B"] = [] { return 2.66 * 5.62; };
  values["second instant"] = [] {
    // The chain's end force at 1.785 s from the published accelerations, over that at 1.071 s.
    const test::CsvTable table =
        test::read_csv(test::project_file("tests/validation/data/thesis_accelerations.csv"));
    const std::vector<double>& row = table.rows[4];
    const double end = 20000.0 * row[7] + 119.0 * row[4] + 2427.0 * row[1];
    return 2.66 * 6.14 * std::abs(end) / published_chain().g[2].x();
  };
  values["f_y"] = [] {
    return yield_strength_of(test::rig().material, 0.05 * metre)->value() / 1e6;
  };
  values["N_y"] = [] { return 335.0 / 16.3; };
  values["N_y unrounded"] = [] { return 335.0 / (2.66 * 6.14); };
  values["N_y rigorous"] = [] { return rig().governing(Criterion::yield)->check.safety_factor; };
  values["S-N step"] = [] { return 100.0 * std::pow(5e6 / 1e8, 0.2); };
  values["S-N EN"] = [] {
    return strength_at(en_1993_1_9_direct(100), 1e8, Loading::spectrum).value() / 1e6;
  };
  values["knee"] = [] { return knee_of(en_1993_1_9_direct(100)).value() / 1e6; };
  values["range"] = [] { return 16.3 + 16.1; };
  values["range rigorous"] = [] {
    return rig().governing(Criterion::fatigue)->check.acting.value() / 1e6;
  };
  values["N_ud"] = [] { return 54.9 / (16.3 + 16.1); };
  values["N_ud unrounded"] = [] { return 100.0 * std::pow(5e6 / 1e8, 0.2) / (16.3 + 16.1); };
  values["N_ud rigorous"] = [] { return rig().governing(Criterion::fatigue)->check.safety_factor; };
  values["N_ud constant"] = [] {
    return rig().governing(Criterion::fatigue)->basis->constant_amplitude_factor;
  };
  values["b_0"] = [] { return governing_lag().b_0.value() * 1e3; };
  values["L_e"] = [] { return governing_lag().effective_length.value(); };
  values["kappa"] = [] { return governing_lag().kappa; };
  values["beta"] = [] { return governing_lag().beta; };
  values["range lag"] = [] {
    return rig_with_lag().governing(Criterion::fatigue)->check.acting.value() / 1e6;
  };
  values["N_y lag"] = [] {
    return rig_with_lag().governing(Criterion::yield)->check.safety_factor;
  };
  values["N_ud lag"] = [] {
    return rig_with_lag().governing(Criterion::fatigue)->check.safety_factor;
  };
  values["N_ud lag constant"] = [] {
    return rig_with_lag().governing(Criterion::fatigue)->basis->constant_amplitude_factor;
  };
  values["hub edge"] = [] { return check("fatigue/3.2+/hole-hub-edge").acting.value() / 1e6; };
  values["4.2 m"] = [] {
    return check("fatigue/4.2-/fibre+z").acting / check("fatigue/3.2+/thesis-A").acting;
  };
  return values;
}

}  // namespace

TEST_CASE("the comparison table of the rig's README is complete and right") {
  const auto values = computed();
  std::map<std::string, int> seen;
  for (const Row& row : rows_of_readme()) {
    INFO("row `" << row.key << "`");
    ++seen[row.key];
    CHECK_FALSE(row.published.empty());
    CHECK_FALSE(row.reason.empty());
    const auto found = values.find(row.key);
    REQUIRE(found != values.end());
    const double value = found->second();
    CHECK(std::abs(std::stod(row.recomputed) - value) <= 1.01 * rounding_of(row.recomputed));
  }
  for (const auto& [key, value] : values) {
    INFO("key " << key << " = " << value());
    CHECK(seen[key] == 1);
  }
}

}  // namespace comparison_test
