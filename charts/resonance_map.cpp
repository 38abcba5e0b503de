#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "charts/digits_left.hpp"
#include "charts/reference_beam.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

using flexible::Complex;
using flexible::Structure;

constexpr int parts = 8;
constexpr std::size_t modes = 4;
/// Where the row without damping is drawn.
constexpr double no_damping = 1e-16;

/// Half decades in full, decades where it is to be quick.
std::vector<double> powers(double from, double to, double step) {
  std::vector<double> values;
  const long steps = std::lround((to - from) / step);
  for (long i = 0; i <= steps; ++i) {
    values.push_back(std::pow(10.0, from + step * static_cast<double>(i)));
  }
  return values;
}

double error_of(Complex value, const ChainReference::Number& exact) {
  const ChainReference::Number of(value.real(), value.imag());
  return static_cast<double>(std::abs(of / exact - 1.0L));
}

Cell trial(double distance, double damping, const ChainReference::Number& exact,
           const std::function<Complex()>& root_moment) {
  try {
    return digits_cell(distance, damping, error_of(root_moment(), exact));
  } catch (const AnalysisError& error) {
    return {distance, damping, Outcome::refused, {}, error.failure().what};
  }
}

}  // namespace

Map resonance_map(const Scenes&, const Effort& effort) {
  Map map;
  map.name = "stability-resonance";
  map.title = "Digits left near resonance";
  map.scene = fmt::format("root moment of a cantilever of {} parts", parts);
  map.reference = "the same elements by initial values, long double";
  map.x = {"distance from the first natural frequency, 1 - r", true};
  map.y = {"damping over the critical (lowest row: none)", true};
  map.value = "digits left";
  map.panels = {{"direct", {}, false},
                {fmt::format("{} modes with static correction", modes), {}, false},
                {fmt::format("{} modes alone", modes), {}, true}};
  const double step = effort.quick ? 1.0 : 0.5;
  const flexible::Mechanism undamped = unit_cantilever(parts, flexible::Element::corrected);
  const Structure undamped_structure = structure_of(undamped);
  const long double first =
      ChainReference(undamped_structure).first_omega(std::pow(cantilever_root(1), 2));
  // None of them is the millionth at which boxbeam begins to refuse, where round-off decides.
  std::vector<double> dampings = powers(-14.5, -1.5, 2.0 * step);
  dampings.insert(dampings.begin(), no_damping);
  std::vector<double> distances = powers(-12.75, -1.25, step);
  distances.push_back(0.9);
  for (const double damping : dampings) {
    const bool damped = damping > no_damping;
    // zeta = omega tau/2.
    const double retardation = damped ? static_cast<double>(2.0L * damping / first) : 0.0;
    const flexible::Mechanism mechanism =
        unit_cantilever(parts, flexible::Element::corrected, retardation);
    const Structure structure = structure_of(mechanism);
    const ChainReference reference(structure);
    const flexible::ModalModel model = flexible::modal_model_of(structure, modes);
    for (const double distance : distances) {
      constexpr long double full_turn = 2.0L * std::numbers::pi_v<long double>;
      const auto frequency = static_cast<double>(first * (1.0L - distance) / full_turn);
      const ChainReference::Number exact = reference.root_moment(full_turn * frequency);
      const auto root = [&](const flexible::Deformation<Complex>& of) {
        return joint_force(structure, 0, of).z();
      };
      const auto add = [&](std::size_t panel, const std::function<Complex()>& root_moment) {
        map.panels[panel].cells.push_back(trial(distance, damping, exact, root_moment));
      };
      add(0, [&] { return root(flexible::harmonic_response(structure, frequency)); });
      add(1, [&] { return root(flexible::harmonic_response(model, frequency)); });
      add(2, [&] { return root(flexible::harmonic_response(model, frequency, false)); });
    }
  }
  map.lesson = fmt::format(
      "boxbeam refuses a resonance that is met within a millionth with less than a millionth of "
      "the "
      "critical damping ({} of {} trials) and is silently wrong in {}: digits fall with the "
      "distance, none is lost unsaid. Modes without static correction miss what a strength check "
      "needs in {}.",
      map.panels[0].count(Outcome::refused), map.panels[0].cells.size(),
      map.panels[0].count(Outcome::wrong) + map.panels[1].count(Outcome::wrong),
      map.panels[2].count(Outcome::wrong));
  return map;
}

}  // namespace boxbeam::charts
