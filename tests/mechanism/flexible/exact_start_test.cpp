// Sudden starts by modes of the exact form: against series in closed form, and as what corrected
// elements tend to.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/mechanism/flexible/start_loads.hpp"
#include "boxbeam/verification/sudden_start.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"

namespace exact_start_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using Eigen::Index;
using Eigen::MatrixXd;
using test::Bar;
using test::Chance;

namespace {

constexpr double full = 2.0 * std::numbers::pi;

/// Roots of cos x cosh x = -1.
double cantilever_root(int j) {
  double x = (j - 0.5) * std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double f = std::cos(x) + 1.0 / std::cosh(x);
    const double slope = -std::sin(x) - std::sinh(x) / std::pow(std::cosh(x), 2);
    x -= f / slope;
  }
  return x;
}

/// phi'' of a cantilever's mode with mass one, mu = EI = L = 1, over root^2.
double bend_of(double root, double s) {
  // cosh x - sigma sinh x = e^-x + (1 - sigma) sinh x, which cancels nothing.
  const double sigma = (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
  const double less =
      (std::sin(root) - std::cos(root) - std::exp(-root)) / (std::sinh(root) + std::sin(root));
  const double x = root * s;
  return std::exp(-x) + less * std::sinh(x) + std::cos(x) - sigma * std::sin(x);
}

/// The moment at s of a cantilever after F sin(omega t) at its end: static, and the accelerations
/// of so many modes.
double moment_after(double F, double omega, double s, double t, int modes) {
  double M = F * (1.0 - s) * std::sin(omega * t);
  for (int j = 1; j <= modes; ++j) {
    const double root = cantilever_root(j), own = root * root;
    const double p = F * (j % 2 == 1 ? 2.0 : -2.0);
    const double acceleration =
        p / (own * own - omega * omega) *
        (own * omega * std::sin(own * t) - omega * omega * std::sin(omega * t));
    M -= own * bend_of(root, s) * acceleration / (own * own);
  }
  return M;
}

/// All links and joints damp alike.
void damp_alike(Mechanism& mechanism, double retardation) {
  for (Link& link : mechanism.links) link.retardation = retardation;
  for (Joint& joint : mechanism.joints) {
    for (const std::size_t axis : {0U, 1U, 2U}) {
      joint.damping[axis] =
          std::isfinite(joint.stiffness[axis]) ? retardation * joint.stiffness[axis] : 0.0;
    }
  }
}

Mechanism by_elements(Mechanism mechanism, int parts) {
  mechanism.element = Element::corrected;
  for (Link& link : mechanism.links) link.parts = parts;
  return mechanism;
}

}  // namespace

TEST_CASE("exact starts: the moments of a cantilever are their series", "[exact][start]") {
  Mechanism mechanism = test::cantilever_of(Bar{}, 1, Element::exact);
  mechanism.frequency = 9.0 / full;
  mechanism.loads = {test::load_at(1.0, {0.0, 0.0, 0.0}, {0.0, 3.0, 0.0})};
  const VibratingModes of = modes_beyond_drive(mechanism);
  const auto count = static_cast<int>(of.modal.modes.size());
  REQUIRE(count >= 24);
  const TaperedBeam beam = test::beam_of_length(1.0);
  const StartLoads after(*of.structure, 0, beam, SuddenStartModes(of.modal));
  for (const double t : {0.013, 0.2, 0.71, 3.3}) {
    const BeamLoads loads = after.at(t);
    CHECK(imbalance_of(loads).force.norm() < 1e-8);
    CHECK(imbalance_of(loads).moment.norm() < 1e-8);
    const CutForceDiagram diagram = cut_forces_of(loads);
    for (const double s : {1e-9, 0.25, 0.5, 0.837}) {
      CAPTURE(t, s);
      const double M = diagram.at({si<Length>(s), Side::both}).M_y.value();
      // Hogging is positive in the series, as the force is.
      CHECK(std::abs(-M - moment_after(3.0, 9.0, s, t, count)) < 3e-6);
    }
  }
}

TEST_CASE("exact starts: what all damps alike damps each mode alone", "[exact][start]") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Mechanism mechanism =
        test::random_elastic(chance, {3, seed % 2 == 0, false, false, true, Element::exact});
    mechanism.frequency = test::power_of_ten(chance, 0.0, 1.5);
    constexpr double retardation = 1e-4;
    damp_alike(mechanism, retardation);
    const ModalModel model = modes_beyond_drive(mechanism).modal;
    const auto count = static_cast<Index>(model.modes.size());
    for (Index i = 0; i < count; ++i) {
      const double omega = full * model.modes[static_cast<std::size_t>(i)].frequency;
      for (Index j = 0; j < count; ++j) {
        const double other = full * model.modes[static_cast<std::size_t>(j)].frequency;
        CAPTURE(i, j);
        const double expected = i == j ? retardation * omega * omega : 0.0;
        CHECK(std::abs(model.damping(i, j) - expected) < 1e-5 * retardation * omega * other);
      }
    }
  }
}

TEST_CASE("exact starts: of many modes near each other none holds a part of another",
          "[exact][start]") {
  // A dozen cantilevers, each a little longer than the one before, their ends tied by springs;
  // where all damps alike C couples no two modes that are what they should be.
  const Bar bar = test::steel_bar(2.0, 0.2, 0.1);
  constexpr double retardation = 1e-4;
  for (const double longer : {5e-4, 2e-3, 4e-3}) {
    for (const double tie : {1e3, 1e5}) {
      CAPTURE(longer, tie);
      Mechanism mechanism = test::cantilever_of(bar, 1, Element::exact);
      for (int i = 1; i < 12; ++i) {
        Link link = mechanism.links.front();
        link.length = link.stretches.front().length = bar.L * (1.0 + longer * i);
        mechanism.links.push_back(link);
        Joint clamp = mechanism.joints.front();
        clamp.a.link = i;
        mechanism.joints.push_back(clamp);
        Joint spring;
        spring.name = "tie";
        spring.a = {i - 1, {bar.L, 0.0}};
        spring.b = {i, {bar.L, 0.0}};
        spring.stiffness = {0.0, tie, 0.0};
        mechanism.joints.push_back(spring);
      }
      damp_alike(mechanism, retardation);
      constexpr std::size_t count = 24;
      const auto omega_of = [](const Mode& mode) { return full * mode.frequency; };
      const double last = omega_of(modes_of(structure_of(mechanism), count).back());
      const Structure structure = structure_of(mechanism, 1.001 * last * last);
      const ModalModel model = modal_model_of(structure, count);
      REQUIRE(model.modes.size() == count);
      double coupled = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
          const double size = retardation * omega_of(model.modes[i]) * omega_of(model.modes[j]);
          const double C = model.damping(static_cast<Index>(i), static_cast<Index>(j));
          coupled = std::max(coupled, std::abs(C / size - (i == j ? 1.0 : 0.0)));
        }
      }
      CHECK(coupled < 1e-5);
    }
  }
}

TEST_CASE("exact starts: what corrected elements tend to, links damped unlike", "[exact][start]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Mechanism mechanism =
        test::random_elastic(chance, {3, seed % 2 == 0, true, false, true, Element::exact});
    const Structure coarse = structure_of(mechanism);
    mechanism.frequency = 0.8 * modes_of(coarse, 2).back().frequency;
    const VibratingModes exact = modes_beyond_drive(mechanism);
    // As many modes as lie clearly below the next, so that both forms have the same.
    const std::vector<Mode>& all = exact.modal.modes;
    std::size_t count = 12;
    const auto gap = [&](std::size_t i) { return all[i].frequency / all[i - 1].frequency; };
    for (std::size_t i = 13; i <= 20; ++i) {
      if (gap(i) > gap(count)) count = i;
    }
    const auto lowest = [&](ModalModel model) {
      const auto n = static_cast<Index>(count);
      model.modes.resize(count);
      model.damping = model.damping.topLeftCorner(n, n).eval();
      return model;
    };
    const double length = 3.0 / mechanism.frequency;
    const auto forces_of = [&](const ModalModel& model) {
      constexpr std::size_t steps = 90;
      const SuddenStart start = sudden_start_of(model, length, steps);
      Eigen::MatrixXd forces(2 * static_cast<Index>(start.joints.size()), Index{steps} + 1);
      for (Index j = 0; 2 * j < forces.rows(); ++j) {
        for (Index i = 0; i < forces.cols(); ++i) {
          forces.col(i).segment<2>(2 * j) =
              start.joints[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].head<2>();
        }
      }
      return forces;
    };
    const MatrixXd expected = forces_of(lowest(exact.modal));
    const auto difference = [&](int parts) {
      const Mechanism divided = by_elements(mechanism, parts);
      const Structure structure = structure_of(divided);
      const MatrixXd forces = forces_of(modal_model_of(structure, count));
      return (forces - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
    };
    const double rough = difference(40), fine = difference(160);
    CAPTURE(rough, fine, count);
    // Between the first and the second order.
    CHECK(fine < 0.15 * rough + 1e-7);
    CHECK(fine < 2e-3);
  }
}

TEST_CASE("exact starts: damped ones end in the harmonic response of the exact form",
          "[exact][start]") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Mechanism mechanism =
        test::random_elastic(chance, {2, seed % 2 == 0, false, false, true, Element::exact});
    constexpr double retardation = 2e-3;
    damp_alike(mechanism, retardation);
    const double first = modes_of(structure_of(mechanism), 1).front().frequency;
    mechanism.frequency = 0.7 * first;
    const VibratingModes of = modes_beyond_drive(mechanism);
    const double slowest = std::pow(full * first, 2) * retardation / 2.0;
    const double length = 40.0 / std::min(slowest, 0.5 / retardation);
    const SuddenStart start = sudden_start_of(of.modal, length, 400);
    const Structure structure = structure_of(mechanism);
    const Deformation<double> still = static_response(structure);
    // Without any mode: the links' own stiffness at the frequency, damped.
    const Deformation<Complex> harmonic = harmonic_response(structure, mechanism.frequency);
    const Complex turn = std::polar(1.0, full * mechanism.frequency * length);
    double largest = 0.0, apart = 0.0;
    for (std::size_t j = 0; j < start.joints.size(); ++j) {
      const Eigen::Vector3d expected =
          joint_force(structure, j, still) + (turn * joint_force(structure, j, harmonic)).imag();
      largest = std::max(largest, expected.head<2>().norm());
      apart = std::max(apart, (start.joints[j].back() - expected).head<2>().norm());
    }
    CAPTURE(apart / largest);
    CHECK(apart < 1e-4 * largest);
  }
}

}  // namespace exact_start_test
