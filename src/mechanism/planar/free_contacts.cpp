// Contacts without a creep velocity, which stick or slide.
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"
#include "free_step.hpp"

namespace boxbeam::planar {

bool FreeSolver::contacts_go_on(const State& state) const {
  const std::vector<FrictionContact>& contacts = equations_.contacts();
  const auto count = static_cast<Eigen::Index>(contacts.size());
  Eigen::VectorXd velocity(count), pressure(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts[static_cast<std::size_t>(j)];
    velocity[j] = sliding_velocity_of(contact, state.q, state.v);
    pressure[j] = pressure_on(contact, state.lambda);
  }
  return slips_go_on(laws_, state.slips, velocity, state.friction, pressure, turning_back * rest_);
}

double FreeSolver::contact_changes_within(const State& known, const Step& step) {
  // A step sees its stages only, and these roughly.
  constexpr int looks = 16;
  const double dt = step.end.time - known.time;
  if (step.change < 1.0) return step.change * dt;
  const bool any_sticks =
      std::find(known.slips.begin(), known.slips.end(), Slip::none) != known.slips.end();
  for (int i = 1; i < looks; ++i) {
    State at = interpolate(known.time + dt * i / looks, known, step.end);
    at.lambda = known.lambda;
    at.friction = known.friction;
    at.slips = known.slips;
    if (any_sticks && !equations_.solve_rates(at)) return 0.0;
    if (!contacts_go_on(at)) return at.time - known.time;
  }
  return 0.0;
}

void FreeSolver::decide_contacts(State& state) {
  FrictionResponse response;
  if (!equations_.friction_response(state, response)) return;
  const std::vector<char> stands = standing_contacts(laws_, state.slips, response.velocity, rest_);
  state.v += equations_.velocities_by(holding_impulses(response, stands));
  for (std::size_t j = 0; j < laws_.size(); ++j)
    if (stands[j] != 0) response.velocity[static_cast<Eigen::Index>(j)] = 0.0;
  state.slips = decide_sticking(laws_, response, stands, names_, state.time).slips;
}

void FreeSolver::settle_contacts(State& state) {
  const std::vector<Slip> before = state.slips;
  const auto velocity = [&](std::size_t j) {
    return sliding_velocity_of(equations_.contacts()[j], state.q, state.v);
  };
  if (contacts_go_on(state)) {
    bool slides = false;
    for (std::size_t j = 0; j < laws_.size(); ++j) {
      slides = slides || (can_stick(laws_[j]) && before[j] == Slip::none &&
                          std::abs(velocity(j)) > turning_back * rest_);
    }
    if (!slides) return;
  }
  for (std::size_t j = 0; j < laws_.size(); ++j) {
    if (!can_stick(laws_[j]) || static_cast<double>(before[j]) * velocity(j) >= -rest_) continue;
    throw AnalysisError(
        {"a contact with dry friction comes to rest where the mechanism passes a "
         "singular position; give it a creep velocity, which smooths its friction",
         "joint " + names_[j], state.time});
  }
  decide_contacts(state);
  static_cast<void>(equations_.solve_rates(state));
  // Ways begun at other instants lead to the same changes.
  note_changes(slip_changes_, changes_between(names_, before, state.slips, state.time),
               1e-9 * time_span_of(*mechanism_).length);
}

}  // namespace boxbeam::planar
