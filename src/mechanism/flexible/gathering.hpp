#pragma once

#include <algorithm>
#include <cstddef>

#include "boxbeam/mechanism/flexible/link_stiffness.hpp"

/// How the elements of a link are gathered, one after the other, at the one that stays.
namespace boxbeam::flexible {

/// Between two neighbouring elements: the part, and from the nodes of both to its spring.
template <class Scalar>
struct Between {
  PartFlexibility<Scalar> part;
  Scalar to_place;    ///< lever from the node of the element that is gathered
  Scalar from_other;  ///< and from the node of the other
};

/// `i` is gathered towards `next`, its neighbour.
template <class Scalar>
Between<Scalar> between(const LinkStiffness<Scalar>& link, std::size_t i, std::size_t next) {
  const PartFlexibility<Scalar> part = link.part(std::min(i, next));
  if (i < next) return {part, part.from_start, part.from_end};
  return {part, part.from_end, part.from_start};
}

/// The elements of a link in the order in which they are gathered, with the neighbour each goes to.
template <class Function>
void inward(std::size_t elements, std::size_t retained, const Function& f) {
  for (std::size_t i = 0; i < retained; ++i) f(i, i + 1);
  for (std::size_t i = elements - 1; i > retained; --i) f(i, i - 1);
}

/// From the one that stays, in the opposite order.
template <class Function>
void outward(std::size_t elements, std::size_t retained, const Function& f) {
  for (std::size_t i = retained; i-- > 0;) f(i, i + 1);
  for (std::size_t i = retained + 1; i < elements; ++i) f(i, i - 1);
}

}  // namespace boxbeam::flexible
