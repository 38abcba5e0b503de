#include "boxbeam/mechanism/flexible/modal_response.hpp"

#include <Eigen/LU>
#include <cmath>

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// What damps: a spring of a link or a joint. Its force is c times the rate of its strain, which is
/// the sum of G q over the elements it takes hold of.
struct Damper {
  struct End {
    std::size_t link, element;
    Matrix3d G;
  };
  Matrix3d c = Matrix3d::Zero();
  std::vector<End> ends;
  bool is_joint = false;
  std::size_t joint = 0;
};

void add_dampers_of_link(const Structure& structure, std::size_t k, std::vector<Damper>& dampers) {
  const double retardation = structure.mechanism->links[k].retardation;
  if (retardation == 0.0) return;
  const DividedLink& link = structure.links[k];
  for (std::size_t i = 0; i < link.springs.size(); ++i) {
    const SpringElement& spring = link.springs[i];
    Damper damper;
    if (spring.axial > 0.0) damper.c(0, 0) = retardation / spring.axial;
    if (!spring.bending.isZero(0.0)) {
      damper.c.bottomRightCorner<2, 2>() = retardation * spring.bending.inverse();
    }
    for (const std::size_t element : {i, i + 1}) {
      Matrix3d G = Matrix3d::Identity();
      G(1, 2) = spring.place - link.elements[element].node;
      damper.ends.push_back({k, element, element == i ? Matrix3d(-G) : G});
    }
    dampers.push_back(damper);
  }
}

void add_damper_of_joint(const Structure& structure, std::size_t j, std::vector<Damper>& dampers) {
  const Joint& joint = structure.mechanism->joints[j];
  const Structure::Ends& ends = structure.joints[j];
  Damper damper;
  damper.is_joint = true;
  damper.joint = j;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const auto at = static_cast<Index>(axis);
    if (std::isfinite(joint.stiffness[axis])) damper.c(at, at) = joint.damping[axis];
  }
  if (damper.c.isZero(0.0)) return;
  for (const auto& [grip, sign] : {std::pair(&ends.a, -1.0), std::pair(&ends.b, 1.0)}) {
    if (grip->link == ground) continue;
    damper.ends.push_back(
        {static_cast<std::size_t>(grip->link), grip->element, sign * ends.axes * grip->motion});
  }
  dampers.push_back(damper);
}

std::vector<Damper> dampers_of(const Structure& structure) {
  std::vector<Damper> dampers;
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    add_dampers_of_link(structure, k, dampers);
  }
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    add_damper_of_joint(structure, j, dampers);
  }
  return dampers;
}

Vector3d strain_of(const Structure& structure, const Damper& damper,
                   const Deformation<double>& mode) {
  Vector3d strain = Vector3d::Zero();
  for (const Damper::End& end : damper.ends) {
    strain += end.G * mode.motion[end.link].col(static_cast<Index>(end.element));
  }
  if (!damper.is_joint) return strain;
  // The gap of a stiff joint is better known from its force.
  const Joint& joint = structure.mechanism->joints[damper.joint];
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const double stiffness = joint.stiffness[axis];
    if (stiffness == 0.0) continue;
    const auto at = static_cast<Index>(axis);
    strain[at] = mode.joints(at, static_cast<Index>(damper.joint)) / stiffness;
  }
  return strain;
}

}  // namespace

ModalModel modal_model_of(const Structure& structure, std::size_t count) {
  ModalModel model{&structure, modes_of(structure, count), {}};
  const auto size = static_cast<Index>(model.modes.size());
  model.damping = MatrixXd::Zero(size, size);
  Eigen::Matrix3Xd strains(3, size);
  for (const Damper& damper : dampers_of(structure)) {
    for (Index j = 0; j < size; ++j) {
      strains.col(j) = strain_of(structure, damper, model.modes[static_cast<std::size_t>(j)].shape);
    }
    model.damping += strains.transpose() * damper.c * strains;
  }
  return model;
}

}  // namespace boxbeam::flexible
