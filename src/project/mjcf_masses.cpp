#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "mjcf_elements.hpp"

namespace boxbeam::robots {
namespace {

/// Mass of a shape about its own centre, in its own axes.
struct ShapeMass {
  double volume = 0.0;                                 ///< [m^3]
  Eigen::Vector3d per_mass = Eigen::Vector3d::Zero();  ///< principal moments [m^2]
};

/// Shapes of MJCF by their sizes: radius, half lengths along z or x, y, z [m]. Source: moments of
/// inertia of solids, e.g. Meriam and Kraige, Dynamics, table D/4; of the capsule the sum of its
/// cylinder and of two hemispheres, each 83/320 m r^2 across its axis about its centre, which lies
/// 3/8 r from its flat side.
std::optional<ShapeMass> shape_mass(const std::string& type, const Eigen::Vector3d& size) {
  constexpr double pi = std::numbers::pi;
  const double x2 = size.x() * size.x(), y2 = size.y() * size.y(), z2 = size.z() * size.z();
  if (type == "sphere")
    return ShapeMass{4.0 / 3.0 * pi * size.x() * x2, Eigen::Vector3d::Constant(0.4 * x2)};
  if (type == "ellipsoid")
    return ShapeMass{4.0 / 3.0 * pi * size.prod(),
                     0.2 * Eigen::Vector3d(y2 + z2, x2 + z2, x2 + y2)};
  if (type == "box")
    return ShapeMass{8.0 * size.prod(), Eigen::Vector3d(y2 + z2, x2 + z2, x2 + y2) / 3.0};
  const double r = size.x(), h = size.y();
  if (type == "cylinder") {
    const double across = x2 / 4.0 + y2 / 3.0;
    return ShapeMass{2.0 * pi * x2 * h, {across, across, 0.5 * x2}};
  }
  if (type == "capsule") {
    const double tube = 2.0 * pi * x2 * h, balls = 4.0 / 3.0 * pi * r * x2;
    const double share = tube / (tube + balls);
    const double across =
        share * (x2 / 4.0 + y2 / 3.0) + (1.0 - share) * (0.4 * x2 + y2 + 0.75 * h * r);
    const double along = share * 0.5 * x2 + (1.0 - share) * 0.4 * x2;
    return ShapeMass{tube + balls, {across, across, along}};
  }
  return {};
}

/// How many sizes a shape has where it is no plane, mesh or field; else 0.
std::size_t sizes_of(const std::string& type, bool from_to) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return from_to ? 1 : 2;
  if (type == "box" || type == "ellipsoid") return from_to ? 1 : 3;
  return 0;
}

/// One body of several that move alike.
Inertial joined(const std::vector<Inertial>& parts) {
  Inertial whole;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Inertial& part : parts) {
    whole.mass += part.mass;
    moment += part.mass * part.centre;
  }
  if (whole.mass > 0.0) whole.centre = moment / whole.mass;
  for (const Inertial& part : parts) {
    const Eigen::Vector3d d = part.centre - whole.centre;
    whole.inertia += part.inertia + part.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() -
                                                 d * d.transpose());
  }
  return whole;
}
Inertial written_inertial(MjcfElements& elements, const MjcfChild& child) {
  const MjcfElement in{{child.element, called(*child.element)}, child.element->attributes};
  Inertial inertial;
  if (!in.attribute("mass")) elements.problem(in.of, "it has no mass", "write mass=\"...\", in kg");
  inertial.mass = elements.number(in, "mass", 0.0);
  if (inertial.mass < 0.0)
    elements.problem(in.of, fmt::format("its mass is {} kg", inertial.mass),
                     "no mass is below zero");
  const Pose pose = child.frame * elements.pose_in(in);
  inertial.centre = pose.p;
  Eigen::Matrix3d I = elements.triple(in, "diaginertia").asDiagonal();
  if (const auto full = elements.numbers(in, "fullinertia", 6, 6)) {
    const std::vector<double>& m = *full;
    if (in.attribute("diaginertia"))
      elements.problem(in.of, "it has diaginertia and fullinertia", "leave one of them");
    I << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
  }
  inertial.inertia = pose.R * I * pose.R.transpose();
  return inertial;
}

/// The mass of a shape in the body's frame, or nothing where it has none.
std::optional<Inertial> shape_inertial(MjcfElements& elements, const MjcfChild& child) {
  const MjcfElement in = elements.with_class(*child.element, child.childclass);
  const double group = elements.number(in, "group", 0.0);
  if (group < elements.settings().first_group || group > elements.settings().last_group) return {};
  const bool has_mass = in.attribute("mass") != nullptr;
  const double mass = elements.number(in, "mass", 0.0),
               density = elements.number(in, "density", 1000.0);
  if (mass < 0.0 || density < 0.0)
    elements.problem(in.of, "its mass is below zero", "no mass is below zero");
  if (has_mass ? mass == 0.0 : density == 0.0) return {};
  const std::string type = in.text("type", in.attribute("mesh") ? "mesh" : "sphere");
  if (type == "plane" || type == "hfield") return {};
  const auto ends = elements.numbers(in, "fromto", 6, 6);
  const std::size_t count = sizes_of(type, ends.has_value());
  if (count == 0 || in.text("shellinertia", "false") == "true") {
    elements.problem(in.of,
                     count == 0
                         ? fmt::format("the mass of a shape of type \"{}\" is not computed", type)
                         : "the mass of a shell is not computed",
                     "write <inertial> in its body, or mass=\"0\" in the shape");
    return {};
  }
  if (ends && type == "sphere") {
    elements.problem(in.of, "a sphere goes from nowhere to anywhere", "leave fromto out");
    return {};
  }
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  const auto sizes = elements.numbers(in, "size", count, 3);
  if (!sizes) {
    if (!in.attribute("size"))
      elements.problem(in.of, "it has no size", fmt::format("a {} has {}", type, count));
    return {};
  }
  for (std::size_t k = 0; k < sizes->size(); ++k) size[static_cast<Eigen::Index>(k)] = (*sizes)[k];
  Pose pose = elements.pose_in(in);
  if (ends) {
    const Eigen::Vector3d from((*ends)[0], (*ends)[1], (*ends)[2]);
    const Eigen::Vector3d along = Eigen::Vector3d((*ends)[3], (*ends)[4], (*ends)[5]) - from;
    if (!(along.norm() > 1e-9)) {
      elements.problem(in.of, "fromto names one place twice", "");
      return {};
    }
    pose.p = from + 0.5 * along;
    pose.R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix();
    if (type == "box" || type == "ellipsoid") {
      size.y() = size.x();
      size.z() = 0.5 * along.norm();
    } else {
      size.y() = 0.5 * along.norm();
    }
  }
  const std::size_t used = sizes_of(type, false);
  for (std::size_t k = 0; k < used; ++k)
    if (!(size[static_cast<Eigen::Index>(k)] > 0.0)) {
      elements.problem(in.of, "its sizes are not above zero", "");
      return {};
    }
  const ShapeMass shape = *shape_mass(type, size);
  pose = child.frame * pose;
  Inertial part;
  part.mass = has_mass ? mass : density * shape.volume;
  part.centre = pose.p;
  part.inertia = pose.R * (part.mass * shape.per_mass).asDiagonal() * pose.R.transpose();
  return part;
}

}  // namespace

std::optional<Inertial> mass_of(MjcfElements& elements, const RobotElement& of,
                                const std::vector<MjcfChild>& inside) {
  const MjcfChild* given = nullptr;
  for (const MjcfChild& child : inside) {
    if (child.element->tag != "inertial") continue;
    if (given != nullptr)
      elements.problem(of, "<inertial> stands there twice", "leave one of them");
    given = &child;
  }
  const bool from_shapes =
      elements.settings().mass_from == MjcfSettings::MassFrom::shapes ||
      (elements.settings().mass_from == MjcfSettings::MassFrom::what_is_there && !given);
  if (!from_shapes && given == nullptr) return {};
  Inertial inertial;
  if (from_shapes) {
    std::vector<Inertial> parts;
    for (const MjcfChild& child : inside)
      if (child.element->tag == "geom")
        if (const auto part = shape_inertial(elements, child)) parts.push_back(*part);
    inertial = joined(parts);
  } else {
    inertial = written_inertial(elements, *given);
  }
  if (!(inertial.mass > 0.0) && elements.settings().least_mass == 0.0) return {};
  inertial.mass = std::max(inertial.mass, elements.settings().least_mass);
  if (elements.settings().least_moment > 0.0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertial.inertia);
    const Eigen::Vector3d moments =
        principal.eigenvalues().cwiseMax(elements.settings().least_moment);
    inertial.inertia =
        principal.eigenvectors() * moments.asDiagonal() * principal.eigenvectors().transpose();
  }
  inertial.inertia = 0.5 * (inertial.inertia + inertial.inertia.transpose()).eval();
  return inertial;
}

}  // namespace boxbeam::robots
