#pragma once

#include <vector>

#include "boxbeam/mechanism/flexible/structure.hpp"

namespace boxbeam::flexible {

/// What a node itself resists, in (u, w, phi) of the link's axes: K_g - square M of a rigid
/// element.
template <class Scalar>
struct NodeStiffness {
  Scalar uu{}, up{}, ww{}, wp{}, pp{};
};

/// What lies between two neighbouring nodes, as a spring at a place: flexibilities to a force along
/// the axis, a force across it and a couple there, and the levers from the nodes to the place.
template <class Scalar>
struct PartFlexibility {
  Scalar axial{}, f11{}, f12{}, f22{};
  Scalar from_start{}, from_end{};
};

/// A link at one frequency: nodes, and the parts between them.
template <class Scalar>
struct LinkStiffness {
  std::vector<NodeStiffness<Scalar>> nodes;
  std::vector<PartFlexibility<Scalar>> parts;
};

/// The seam between the equations of a structure and the form of its links. Classical and
/// corrected: rigid elements and springs as they are divided. Exact: the dynamic stiffness of the
/// continuous link between its nodes, which has this shape as well. `omega`: of the damping;
/// `square` = omega^2, or a shift. Precondition: an exact structure is resolved at the
/// square.
template <class Scalar>
LinkStiffness<Scalar> link_stiffness_of(const Structure& structure, std::size_t link, double square,
                                        double omega);

}  // namespace boxbeam::flexible
