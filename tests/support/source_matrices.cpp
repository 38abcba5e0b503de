#include "support/source_matrices.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

namespace test {

using namespace boxbeam::flexible;

namespace {

/// Coordinates of a link beyond (x, y, angle): of each further rigid element those in which it can
/// move against its neighbour.
std::vector<std::string> names_beyond_first(LinkKind kind) {
  switch (kind) {
    case LinkKind::rigid: return {};
    case LinkKind::bending: return {"eta", "phi"};
    case LinkKind::axial: return {"xi"};
    case LinkKind::full: return {"xi", "eta", "phi"};
  }
  return {};
}

std::vector<std::string> names_of(const Link& link, std::size_t elements) {
  std::vector<std::string> names{"x", "y"};
  if (link.kind == LinkKind::rigid) names.emplace_back("phi");
  if (link.kind == LinkKind::axial) names.emplace_back("delta");
  if (names.size() == 2) names.emplace_back("phi_0");
  for (std::size_t i = 1; i < elements; ++i) {
    for (const std::string& name : names_beyond_first(link.kind)) {
      names.push_back(fmt::format("{}_{}", name, i));
    }
  }
  for (std::string& name : names) name = fmt::format("{}.{}", link.name, name);
  return names;
}

Eigen::Matrix3d mass_of(const RigidElement& element) {
  const double m = element.mass;
  const double S_x = element.first_moment.x();
  const double S_y = element.first_moment.y();
  Eigen::Matrix3d M;
  M << m, 0.0, -S_y, 0.0, m, S_x, -S_y, S_x, element.inertia;
  return M;
}

/// How the two rigid elements at a spring move against each other there.
Eigen::MatrixXd strain_of(const DividedLink& divided, std::size_t spring,
                          const Eigen::MatrixXd& coordinates) {
  const auto motion_at_spring = [&](std::size_t element) -> Eigen::MatrixXd {
    Eigen::Matrix3d to_spring = Eigen::Matrix3d::Identity();
    to_spring(1, 2) = divided.springs[spring].place - divided.elements[element].node;
    return to_spring * coordinates.middleRows<3>(3 * static_cast<Eigen::Index>(element));
  };
  return motion_at_spring(spring + 1) - motion_at_spring(spring);
}

Eigen::MatrixXd stiffness_of(const Link& link, const DividedLink& divided,
                             const Eigen::MatrixXd& coordinates) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(coordinates.cols(), coordinates.cols());
  for (std::size_t i = 0; i < divided.springs.size(); ++i) {
    const SpringElement& spring = divided.springs[i];
    const Eigen::MatrixXd strain = strain_of(divided, i, coordinates);
    if (link.kind == LinkKind::axial || link.kind == LinkKind::full) {
      K += strain.row(0).transpose() * strain.row(0) / spring.axial;
    }
    if (link.kind == LinkKind::bending || link.kind == LinkKind::full) {
      const Eigen::MatrixXd across = strain.bottomRows<2>();
      K += across.transpose() * spring.bending.inverse() * across;
    }
  }
  return K;
}

}  // namespace

Eigen::MatrixXd coordinates_of(const Link& link, const DividedLink& divided) {
  const auto elements = static_cast<Eigen::Index>(divided.elements.size());
  const auto own = static_cast<Eigen::Index>(names_beyond_first(link.kind).size());
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3 * elements, 3 + own * (elements - 1));
  const double c = std::cos(link.angle);
  const double s = std::sin(link.angle);
  for (Eigen::Index i = 0; i < elements; ++i) {
    const Eigen::Index u = 3 * i;
    const Eigen::Index w = u + 1;
    const Eigen::Index phi = u + 2;
    B.block<2, 2>(u, 0) << c, s, -s, c;
    const bool turns_alone =
        i > 0 && (link.kind == LinkKind::bending || link.kind == LinkKind::full);
    if (!turns_alone) B(phi, 2) = 1.0;
    if (i == 0) continue;
    Eigen::Index q = 3 + own * (i - 1);
    if (link.kind == LinkKind::axial || link.kind == LinkKind::full) B(u, q++) = 1.0;
    if (turns_alone) {
      B(w, q++) = 1.0;
      B(phi, q) = 1.0;
    } else {
      B(w, 2) = divided.elements[static_cast<std::size_t>(i)].node - divided.elements[0].node;
    }
  }
  return B;
}

SourceMatrices matrices_of(const Structure& structure) {
  const Mechanism& mechanism = *structure.mechanism;
  SourceMatrices result;
  std::vector<Eigen::MatrixXd> coordinates;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    coordinates.push_back(coordinates_of(mechanism.links[k], structure.links[k]));
    result.link_start.push_back(static_cast<Eigen::Index>(result.names.size()));
    for (std::string& name : names_of(mechanism.links[k], structure.links[k].elements.size())) {
      result.names.push_back(std::move(name));
    }
  }
  const auto size = static_cast<Eigen::Index>(result.names.size());
  result.M = result.K = result.C = Eigen::MatrixXd::Zero(size, size);

  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    const Eigen::MatrixXd& B = coordinates[k];
    const auto block = [&](Eigen::MatrixXd& whole) {
      return whole.block(result.link_start[k], result.link_start[k], B.cols(), B.cols());
    };
    for (std::size_t i = 0; i < structure.links[k].elements.size(); ++i) {
      const Eigen::MatrixXd motion = B.middleRows<3>(3 * static_cast<Eigen::Index>(i));
      block(result.M) += motion.transpose() * mass_of(structure.links[k].elements[i]) * motion;
    }
    const Eigen::MatrixXd K = stiffness_of(mechanism.links[k], structure.links[k], B);
    block(result.K) += K;
    block(result.C) += mechanism.links[k].retardation * K;
  }

  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Structure::Ends& ends = structure.joints[j];
    Eigen::MatrixXd gap = Eigen::MatrixXd::Zero(3, size);
    const auto add = [&](const Grip& grip, double sign) {
      if (grip.link == ground) return;
      const auto k = static_cast<std::size_t>(grip.link);
      gap.middleCols(result.link_start[k], coordinates[k].cols()) +=
          sign * ends.axes * grip.motion *
          coordinates[k].middleRows<3>(3 * static_cast<Eigen::Index>(grip.element));
    };
    add(ends.b, 1.0);
    add(ends.a, -1.0);
    const Joint& joint = mechanism.joints[j];
    result.K += gap.transpose() * Eigen::Vector3d(joint.stiffness.data()).asDiagonal() * gap;
    result.C += gap.transpose() * Eigen::Vector3d(joint.damping.data()).asDiagonal() * gap;
  }
  return result;
}

}  // namespace test
