#include <limits>
#include <string>

#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "peers/answers.hpp"

namespace peers {
namespace {

using namespace boxbeam::flexible;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A rectangular bar of constant width whose height goes linearly from h_0 to h_1.
LinkStretch stretch_of(const Json& beam) {
  const double L = beam.at("L"), b = beam.at("b"), E = beam.at("E"), rho = beam.at("rho");
  const double G = E / 2.0;  // no lateral contraction
  const double h = beam.at("h_0");
  const double rise = (beam.at("h_1").get<double>() - h) / L;
  const double I = b / 12.0;
  LinkStretch stretch;
  stretch.length = L;
  stretch.EA.c = {E * b * h, E * b * rise};
  stretch.GA.c = {G * b * h * 5.0 / 6.0, G * b * rise * 5.0 / 6.0};
  stretch.mass.c = {rho * b * h, rho * b * rise};
  stretch.EI.c = {E * I * h * h * h, 3.0 * E * I * h * h * rise, 3.0 * E * I * h * rise * rise,
                  E * I * rise * rise * rise};
  for (std::size_t i = 0; i < 4; ++i) stretch.rotary.c[i] = stretch.EI.c[i] * rho / E;
  return stretch;
}

Mechanism mechanism_of(const Json& request) {
  const Json& beam = request.at("beam");
  Mechanism mechanism;
  mechanism.element =
      request.at("element") == "classical" ? Element::classical : Element::corrected;
  Link link;
  link.name = "beam";
  link.kind = LinkKind::bending;
  link.length = beam.at("L");
  link.parts = request.at("parts");
  link.stretches = {stretch_of(beam)};
  mechanism.links = {link};
  const Attachment start{0, {0.0, 0.0}};
  const Attachment end{0, {link.length, 0.0}};
  mechanism.joints = {
      {"clamp", start, {ground, {0.0, 0.0}}, 0.0, {infinite, infinite, infinite}, {}}};
  if (beam.at("propped")) {
    mechanism.joints.push_back(
        {"prop", end, {ground, {link.length, 0.0}}, 0.0, {0.0, infinite, 0.0}, {}});
  }
  if (request.at("what") == "harmonic") {
    Load load;
    load.name = "load";
    load.at = {0, {beam.at("load_at").get<double>(), 0.0}};
    load.amplitude = {0.0, 1.0, 0.0};
    mechanism.loads = {load};
  }
  return mechanism;
}

/// The lowest frequency, or what the prop does to the beam under a unit load.
Json results_of(const Mechanism& mechanism, const Json& request) {
  const std::string what = request.at("what");
  const Structure structure = structure_of(mechanism);
  if (what == "frequency") return {{"value", modes_of(structure, 1).front().frequency}};
  const double frequency = request.at("frequency");
  const Deformation<Complex> motion =
      request.contains("modes")
          ? harmonic_response(modal_model_of(structure, request.at("modes")), frequency,
                              request.value("static_correction", true))
          : harmonic_response(structure, frequency);
  const std::size_t prop = mechanism.joints.size() - 1;
  return {{"value", joint_force(structure, prop, motion)[1].real()}};
}

}  // namespace

Json answer_beam(const Json& request) {
  const Mechanism mechanism = mechanism_of(request);
  const int turns = request.value("turns", 1);
  Json result;
  const double begin = processor_time();
  for (int i = 0; i < turns; ++i) result = results_of(mechanism, request);
  result["seconds"] = (processor_time() - begin) / turns;
  return result;
}

}  // namespace peers
