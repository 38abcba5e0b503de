#pragma once

#include <cstddef>
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

/// A link at one frequency: nodes, and the parts between them. Looks at the divided link, whose
/// elements and springs they are unless the form is exact.
template <class Scalar>
struct LinkStiffness {
  const DividedLink* divided = nullptr;
  double square = 0.0;
  Scalar flexible{1.0};  ///< of elasticities that are damped: 1/(1 + i omega tau)
  std::vector<NodeStiffness<Scalar>> exact_nodes = {};
  std::vector<PartFlexibility<Scalar>> exact_parts = {};

  std::size_t nodes() const { return divided->elements.size(); }

  NodeStiffness<Scalar> node(std::size_t i) const {
    if (!exact_nodes.empty()) return exact_nodes[i];
    const RigidElement& of = divided->elements[i];
    return {-square * of.mass, square * of.first_moment.y(), -square * of.mass,
            -square * of.first_moment.x(), of.turning - square * of.inertia};
  }

  PartFlexibility<Scalar> part(std::size_t i) const {
    if (!exact_parts.empty()) return exact_parts[i];
    const SpringElement& of = divided->springs[i];
    return {flexible * of.axial,
            flexible * of.bending(0, 0),
            flexible * of.bending(0, 1),
            flexible * of.bending(1, 1),
            of.reach * (of.place - divided->elements[i].node),
            of.reach * (of.place - divided->elements[i + 1].node)};
  }
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
