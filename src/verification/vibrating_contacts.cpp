#include "vibrating_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "modal_motion.hpp"

namespace boxbeam {

std::vector<const spatial::Spring*> contacts_of(const spatial::Mechanism& mechanism) {
  std::vector<const spatial::Spring*> contacts;
  for (const spatial::Spring& spring : mechanism.springs)
    if (begins_at_length(law_of(spring))) contacts.push_back(&spring);
  return contacts;
}

void check_contacts(const spatial::Chain& chain, const spatial::StatesAround& states,
                    const TransientResponse& response, const GapsAt& gaps_at, double tolerance) {
  const std::vector<const spatial::Spring*> contacts = contacts_of(chain.mechanism());
  if (contacts.empty()) return;
  const auto count = static_cast<Eigen::Index>(response.times().size());
  // How far each is beyond its length, in the rigid motion and by vibration.
  const auto columns = static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd rigid(count, columns), vibrating(count, columns);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double time = response.times()[static_cast<std::size_t>(i)];
    const spatial::State state = states.at(time);
    const ModalState modal = response.at(time);
    const Eigen::VectorXd longer = gaps_at(time, modal.eta.size()).transpose() * modal.eta;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const LineLaw law = law_of(*contacts[c]);
      const double length = (spatial::position_of(state, contacts[c]->b) -
                             spatial::position_of(state, contacts[c]->a))
                                .norm();
      const auto at = static_cast<Eigen::Index>(c);
      rigid(i, at) = inward(law, length - law.free_length);
      vibrating(i, at) = inward(law, longer[at]);
    }
  }
  const auto force_of = [&](Eigen::Index c, double beyond) {
    const LineLaw law = law_of(*contacts[static_cast<std::size_t>(c)]);
    return law.stiffness * std::pow(beyond, law.impact ? law.impact->exponent : 1.0);
  };
  const Eigen::VectorXd pressed = rigid.colwise().maxCoeff().cwiseMax(0.0).transpose();
  double largest = 0.0;
  for (Eigen::Index c = 0; c < columns; ++c) largest = std::max(largest, force_of(c, pressed[c]));
  for (Eigen::Index c = 0; c < columns; ++c) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const double before = rigid(i, c), now = before + vibrating(i, c), beyond = std::abs(now);
      if ((before > 0.0) == (now > 0.0)) continue;
      const double share = beyond < pressed[c] ? beyond / pressed[c] : 1.0;
      if (share * force_of(c, beyond) <= tolerance * largest) continue;
      refuse_vibration(
          fmt::format("vibration itself {} {}, by {:.3g} mm, which the modes of the rigid motion's "
                      "contacts do not follow",
                      before > 0.0 ? "lifts off" : "closes",
                      contacts[static_cast<std::size_t>(c)]->name, 1e3 * std::abs(now)),
          response.times()[static_cast<std::size_t>(i)]);
    }
  }
}

}  // namespace boxbeam
