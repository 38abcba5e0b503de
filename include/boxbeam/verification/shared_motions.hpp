#pragma once

#include <map>
#include <memory>
#include <typeindex>
#include <utility>

namespace boxbeam {

/// Motions that the beams of one case have in common: what moves or holds them is the same for all,
/// and is solved once for each situation. Copies share what they know.
class SharedMotions {
 public:
  /// What `solve` gives, which only the first to ask in a situation of this index calls; later ones
  /// ask for the same of the same case.
  template <class T, class Solve>
  std::shared_ptr<const T> once(std::size_t situation, const Solve& solve) const {
    std::shared_ptr<const void>& known = (*solved_)[{situation, typeid(T)}];
    // Made where it stays: parts of it may look at others.
    if (!known) known = std::shared_ptr<const T>(new T(solve()));
    return std::static_pointer_cast<const T>(known);
  }

 private:
  using Solved = std::map<std::pair<std::size_t, std::type_index>, std::shared_ptr<const void>>;
  std::shared_ptr<Solved> solved_ = std::make_shared<Solved>();
};

}  // namespace boxbeam
