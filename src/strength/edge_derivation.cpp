#include <cmath>

#include "boxbeam/strength/hole_concentration.hpp"
#include "hole_formulas.hpp"

namespace boxbeam {
namespace {

constexpr double round_off = 1e-9;

/// Whether N and M_y of a section are apart: its centroid on the axis, its axes principal ones.
bool is_plain(const SectionProperties& of) {
  constexpr double nothing = 1e-12;
  return std::abs(of.centroid_y.value()) < nothing && std::abs(of.centroid_z.value()) < nothing &&
         std::abs(of.I_yz.value()) <= nothing * of.I_y.value();
}

/// What the factors of an edge are made of.
struct Membrane {
  Traced a, K_g;
};

Membrane derive_membrane(Derivation& steps, const EdgeBasis& basis) {
  const Traced d = steps.known("d", basis.diameter), w = steps.known("w", basis.plate_width);
  const Traced a = steps.define("a", d / w, "hole diameter over width of its plate");
  const Traced K_t = hole::membrane_concentration(steps, a);
  steps.note([] { return "Peterson, chart 4.1, on the net section"; });
  return {a, steps.define("K_g", hole::on_gross(K_t, a), "on the gross section")};
}

/// I_y,net/I_y,eff, or one.
Traced derive_lag(Derivation& steps, const EdgeBasis& basis) {
  if (basis.net.I_y == basis.effective_I) return 1.0;
  return steps.define(
      "k_lag", steps.known("I_y,net", basis.net.I_y) / steps.known("I_y,eff", basis.effective_I),
      "shear lag raises all stress of bending alike");
}

/// The stresses of a wall at the centre of its hole per cut force; nothing where they are not.
struct AtCentre {
  Traced sigma_0 = 0.0, tau_0 = 0.0, slope = 0.0, radius = 0.0;
};

/// The edge of a hole in a wall.
class WallEdge {
 public:
  WallEdge(Derivation& steps, const EdgeBasis& basis)
      : steps_(&steps), basis_(&basis), plain_(is_plain(basis.gross) && is_plain(basis.net)) {}

  void derive() {
    const Membrane membrane = derive_membrane(*steps_, *basis_);
    const Traced theta = steps_->given("theta", basis_->angle, {ValueKind::angle},
                                       "place on the edge, from the axis of the beam");
    const auto in_words = [&](const char* symbol) { return steps_->known(symbol, 1.0); };
    steps_->state(
        "sigma_edge",
        hole::edge_stress(hole::edge_factors(membrane.K_g, theta, membrane.a, in_words("r")),
                          in_words("sigma_0"), in_words("tau_0"), in_words("d/du(sigma)")),
        "by the stresses of the gross section at the hole's centre and the slope of the "
        "direct stress across it, that of moments on the net section; Kirsch");
    const Traced lag = derive_lag(*steps_, *basis_);
    const auto coefficient = [&](const char* symbol, const AtCentre& at, const Traced& times) {
      const Traced of =
          hole::edge_stress(hole::edge_factors(membrane.K_g, theta, membrane.a, at.radius),
                            at.sigma_0, at.tau_0, at.slope);
      const double size = std::abs(at.sigma_0.value()) + std::abs(at.tau_0.value()) +
                          std::abs(at.slope.value() * at.radius.value());
      if (std::abs(of.value()) > round_off * size) steps_->define(symbol, times * of);
    };
    coefficient("k_N", per_N(), 1.0);
    coefficient(basis_->in_space ? "k_My" : "k_M", per_M(), lag);
    if (!basis_->in_space) coefficient("k_V", per_V(), 1.0);
  }

 private:
  /// A value at the centre as a step of its own; nothing where it is round-off.
  Traced given(Symbol symbol, double value, ValueKind kind, double beside, const char* what) {
    if (std::abs(value) <= round_off * std::abs(beside)) return 0.0;
    return steps_->given(symbol, value, {kind}, what);
  }

  /// The shear of a taper.
  Traced tau_per(const char* symbol, cut_force::Index force, ValueKind kind, const char* what) {
    const AroundHole& around = *basis_->around;
    return given(symbol, around.middle.shear[force], kind, around.middle.normal[force], what);
  }

  AtCentre per_N() {
    const AroundHole& around = *basis_->around;
    const double sigma = around.middle.normal[cut_force::N];
    AtCentre at;
    if (plain_) {
      at.sigma_0 = 1.0 / steps_->given("A", basis_->gross.area, "gross section");
    } else {
      at.sigma_0 = steps_->given("s_N", sigma, {ValueKind::per_area},
                                 "stress of the gross section per N at the hole's centre");
      at.slope = given("g_N", around.gradient[cut_force::N], ValueKind::per_volume,
                       sigma / around.radius, "its slope across the hole");
      if (at.slope.value() != 0.0) at.radius = radius();
    }
    at.tau_0 = tau_per("c_N", cut_force::N, ValueKind::per_area,
                       "shear stress of the gross section per N there, in the taper");
    return at;
  }

  AtCentre per_M() {
    const AroundHole& around = *basis_->around;
    const double sigma = around.middle.normal[cut_force::M_y];
    const double slope = around.gradient[cut_force::M_y];
    const bool web = basis_->walls == HoleWalls::webs;
    AtCentre at;
    if (plain_ && web) {
      at.radius = radius();
      if (basis_->position.value() != 0.0) {
        const Traced z_0 = steps_->given("z_0", basis_->position, "level of its centre");
        at.sigma_0 = z_0 / steps_->given("I_y", basis_->gross.I_y, "gross section");
      }
      at.slope = 1.0 / steps_->given("I_y,net", basis_->net.I_y);
    } else if (plain_) {
      const Traced z = steps_->known("z", basis_->z);
      at.sigma_0 = z / steps_->given("I_y", basis_->gross.I_y, "gross section");
    } else {
      at.sigma_0 = given("s_M", sigma, ValueKind::per_volume, slope * around.radius,
                         "stress of the gross section per M at the hole's centre");
      if (std::abs(slope * around.radius) > round_off * std::abs(sigma)) {
        at.radius = radius();
        at.slope = 1.0 / steps_->given("I_M", 1.0 / slope, {ValueKind::second_moment},
                                       "of the net section: stress across the hole per M");
      }
    }
    at.tau_0 = tau_per("c_M", cut_force::M_y, ValueKind::per_volume,
                       "shear stress of the gross section per M there, in the taper");
    return at;
  }

  AtCentre per_V() {
    const double tau = basis_->around->middle.shear[cut_force::V_z];
    AtCentre at;
    if (tau == 0.0 || std::abs(std::sin(2.0 * basis_->angle)) < round_off) return at;
    at.tau_0 = steps_->given("c_0", tau, {ValueKind::per_area},
                             "shear stress of the gross section per V at the hole's centre");
    return at;
  }

  Traced radius() {
    return steps_->given("r", si<Length>(basis_->around->radius), "radius of the hole");
  }

  Derivation* steps_;
  const EdgeBasis* basis_;
  bool plain_;
};

/// Of a nominal stress times a factor: what N and M_y make of it.
void derive_nominal(Derivation& steps, const EdgeBasis& basis, const Traced& factor,
                    const Traced& area, const Traced& inertia) {
  steps.define("k_N", factor / area);
  const Traced lag = derive_lag(steps, basis);
  steps.define("k_M", lag * factor * steps.known("z", basis.z) / inertia);
}

void derive_flange_edge(Derivation& steps, const EdgeBasis& basis) {
  const Traced K_g = derive_membrane(steps, basis).K_g;
  if (!is_plain(basis.gross)) return;
  derive_nominal(steps, basis, K_g, steps.known("A", basis.gross.area),
                 steps.known("I_y", basis.gross.I_y));
}

void derive_flat_plate_edge(Derivation& steps, const EdgeBasis& basis) {
  const Membrane membrane = derive_membrane(steps, basis);
  hole::plate_bending_concentration(
      steps, Traced(steps.known("d", basis.diameter) / steps.known("h", basis.plate)), membrane.a);
  steps.note([] { return "bending of the plate, on 6 M/((1 - a) w h^2)"; });
}

void derive_published_edge(Derivation& steps, const EdgeBasis& basis) {
  const Traced K_t = hole::published_concentration(
      steps, Traced(steps.known("d", basis.diameter) / steps.known("w", basis.plate_width)));
  steps.note([] { return "as published, on the net section"; });
  if (!is_plain(basis.net)) return;
  derive_nominal(steps, basis, K_t, steps.known("A_net", basis.net.area),
                 steps.known("I_y,net", basis.net.I_y));
}

}  // namespace

void derive_edge_stress(Derivation& steps, const EdgeBasis& basis) {
  if (basis.around) return WallEdge(steps, basis).derive();
  switch (basis.hole_case) {
    case HoleCase::in_plane_bending:
    case HoleCase::membrane_tension: return derive_flange_edge(steps, basis);
    case HoleCase::out_of_plane_bending: return derive_flat_plate_edge(steps, basis);
    case HoleCase::published_exponential: return derive_published_edge(steps, basis);
  }
}

}  // namespace boxbeam
