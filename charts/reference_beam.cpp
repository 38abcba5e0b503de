#include "charts/reference_beam.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace boxbeam::charts {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

flexible::Mechanism unit_cantilever(int parts, flexible::Element element, double retardation) {
  flexible::Link link;
  link.name = "cantilever";
  link.kind = flexible::LinkKind::bending;
  link.parts = parts;
  link.retardation = retardation;
  link.length = 1.0;
  flexible::LinkStretch stretch;
  stretch.length = 1.0;
  stretch.EA.c[0] = 1.0;
  stretch.GA.c[0] = 1e30;
  stretch.EI.c[0] = 1.0;
  stretch.mass.c[0] = 1.0;
  link.stretches = {stretch};
  flexible::Joint clamp;
  clamp.name = "root";
  clamp.a = {0, {0.0, 0.0}};
  clamp.stiffness = {infinite, infinite, infinite};
  const Eigen::Vector3d across(0.0, 1.0, 0.0);
  flexible::Mechanism mechanism;
  mechanism.element = element;
  mechanism.links = {link};
  mechanism.joints = {clamp};
  mechanism.loads = {{"end", {0, {1.0, 0.0}}, across, across, 0.0}};
  return mechanism;
}

long double cantilever_root(int k) {
  // cos(x) + 1/cosh(x) = 0, from the zeros of the cosine.
  long double x =
      k == 1 ? 1.875L : (static_cast<long double>(k) - 0.5L) * std::numbers::pi_v<long double>;
  for (int step = 0; step < 20; ++step) {
    const long double cosh = std::cosh(x);
    const long double slope = -std::sin(x) - std::sinh(x) / (cosh * cosh);
    x -= (std::cos(x) + 1.0L / cosh) / slope;
  }
  return x;
}

long double cantilever_root_moment(long double omega) {
  const long double x = std::sqrt(omega);
  return (std::sinh(x) + std::sin(x)) / (x * (1.0L + std::cosh(x) * std::cos(x)));
}

ChainReference::ChainReference(const flexible::Structure& structure)
    : link_(&structure.links.front()),
      retardation_(structure.mechanism->links.front().retardation),
      load_(structure.mechanism->loads.front().amplitude.y()) {}

ChainReference::State ChainReference::balance(long double omega, const State& root,
                                              long double load) const {
  const long double square = omega * omega;
  const Number viscous(1.0L, omega * retardation_);
  // Motion of an element; force and couple in the spring behind it, at the spring.
  State state = root;
  for (std::size_t i = 0; i < link_->springs.size(); ++i) {
    const flexible::SpringElement& spring = link_->springs[i];
    const flexible::RigidElement& next = link_->elements[i + 1];
    const long double before = static_cast<long double>(spring.place) - link_->elements[i].node;
    const long double behind = static_cast<long double>(next.node) - spring.place;
    const Eigen::Matrix2d& F = spring.bending;
    const Number shift = (static_cast<long double>(F(0, 0)) * state.force +
                          static_cast<long double>(F(0, 1)) * state.couple) /
                         viscous;
    const Number turn = (static_cast<long double>(F(1, 0)) * state.force +
                         static_cast<long double>(F(1, 1)) * state.couple) /
                        viscous;
    const Number at_spring = state.w + before * state.phi + shift;
    state.phi += turn;
    state.w = at_spring + behind * state.phi;
    // Balance of the next element gives what acts on it from behind, about its node.
    const auto S = static_cast<long double>(next.first_moment.x());
    const bool last = i + 1 == link_->springs.size();
    const Number force = state.force -
                         square * (static_cast<long double>(next.mass) * state.w + S * state.phi) -
                         (last ? load : 0.0L);
    const Number couple =
        state.couple - behind * state.force -
        square * (S * state.w + static_cast<long double>(next.inertia) * state.phi);
    state.force = force;
    state.couple = couple;
    if (last) break;
    const long double to_next = static_cast<long double>(link_->springs[i + 1].place) - next.node;
    state.couple -= to_next * force;
  }
  return state;
}

ChainReference::Number ChainReference::root_moment(long double omega) const {
  const State by_load = balance(omega, {}, load_);
  const State by_force = balance(omega, {{}, {}, 1.0L, {}}, 0.0L);
  const State by_couple = balance(omega, {{}, {}, {}, 1.0L}, 0.0L);
  const Number det = by_force.force * by_couple.couple - by_force.couple * by_couple.force;
  const Number force = (by_couple.force * by_load.couple - by_couple.couple * by_load.force) / det;
  const Number couple = (by_force.couple * by_load.force - by_force.force * by_load.couple) / det;
  const long double arm =
      static_cast<long double>(link_->springs.front().place) - link_->elements.front().node;
  return -(couple + arm * force);  // what the clamp does to the beam is opposite to the spring
}

long double ChainReference::first_omega(long double guess) const {
  const auto determinant = [&](long double omega) {
    const State by_force = balance(omega, {{}, {}, 1.0L, {}}, 0.0L);
    const State by_couple = balance(omega, {{}, {}, {}, 1.0L}, 0.0L);
    return (by_force.force * by_couple.couple - by_force.couple * by_couple.force).real();
  };
  long double a = guess, b = guess * (1.0L + 1e-6L);
  long double at_a = determinant(a), at_b = determinant(b);
  for (int step = 0; step < 40 && at_b != at_a; ++step) {
    const long double c = b - at_b * (b - a) / (at_b - at_a);
    a = b, at_a = at_b;
    b = c, at_b = determinant(b);
  }
  return b;
}

}  // namespace boxbeam::charts
