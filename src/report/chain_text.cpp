#include "chain_text.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "boxbeam/report/format.hpp"
#include "function_text.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using spatial::Mechanism;

/// Components; round-off beside the vector's length reads as 0.
std::string triple(const Eigen::Vector3d& v) {
  const auto component = [&](double x) { return plain(std::abs(x) <= 1e-12 * v.norm() ? 0.0 : x); };
  return fmt::format("({}, {}, {})", component(v.x()), component(v.y()), component(v.z()));
}

std::string body_name(const Mechanism& mechanism, int body) {
  if (body == spatial::ground) return "the ground";
  return mechanism.bodies[static_cast<std::size_t>(body)].name;
}

/// "z" for an axis of the body itself, else its components.
std::string direction_text(const Eigen::Vector3d& direction) {
  for (int k = 0; k < 3; ++k) {
    const double along = direction[k];
    if (std::abs(std::abs(along) - 1.0) > 1e-9) continue;
    return fmt::format("{}{}", along < 0.0 ? "-" : "", "xyz"[k]);
  }
  return triple(direction);
}

std::string axes_text(const Mechanism& mechanism, int axes) {
  return axes == spatial::ground ? "the world" : body_name(mechanism, axes);
}

/// "leg.B", or the components from the body's origin.
std::string place_text(const Mechanism& mechanism, const spatial::Attachment& at) {
  if (at.body == spatial::ground) return triple(at.p) + " m of the world";
  const spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(at.body)];
  const auto named = std::find_if(body.points.begin(), body.points.end(),
                                  [&](const auto& point) { return point.p == at.p; });
  if (named != body.points.end()) return body.name + "." + named->name;
  return fmt::format("{} at {} m", body.name, triple(at.p));
}

/// "0.1 rad about x".
std::string turn_text(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d turn = spatial::turn_of(R);
  const double angle = turn.norm();
  if (angle < 1e-12) return "-";
  return fmt::format("{} rad about {}", plain(angle), direction_text(turn / angle));
}

std::string joints_table(const Mechanism& mechanism) {
  layout::Table table(
      {"joint", "kind", "carries", "on", "at [m]", "axis, of the carried body", "turned at zero"});
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    const bool fixed = joint.kind == spatial::JointKind::fixed;
    table.row({joint.name, spatial::to_text(joint.kind), mechanism.bodies[i].name,
               body_name(mechanism, joint.parent), triple(joint.at),
               fixed ? "-" : direction_text(joint.turn.transpose() * joint.axis),
               turn_text(joint.turn)});
  }
  return table.text();
}

std::string bodies_table(const Mechanism& mechanism) {
  layout::Table table({"body", "mass [kg]", "centre, body axes [m]",
                       "principal inertias about the centre [kg m^2]"});
  for (const spatial::Body& body : mechanism.bodies) {
    if (body.mass == 0.0) {
      table.row({body.name, "0", "-", "- (a frame that turns or shifts what it carries)"});
      continue;
    }
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia, Eigen::EigenvaluesOnly)
            .eigenvalues();
    table.row(
        {body.name, text::significant(body.mass, 5), triple(body.centre),
         fmt::format("{}, {}, {}", text::significant(principal[2], 5),
                     text::significant(principal[1], 5), text::significant(principal[0], 5))});
  }
  return table.text();
}

}  // namespace

std::string chain_tables(const Mechanism& mechanism) {
  return joints_table(mechanism) + "\n" + bodies_table(mechanism);
}

std::string chain_inputs(const Mechanism& mechanism, const spatial::BeamPlacement& placement) {
  std::string out = layout::entry(
      "beam",
      fmt::format("in body {}: from {} m, x along {}, z along {} of its axes",
                  body_name(mechanism, placement.body), triple(placement.start),
                  direction_text(placement.axes.col(0)), direction_text(placement.axes.col(2))));
  for (const spatial::Joint& joint : mechanism.joints) {
    if (joint.kind == spatial::JointKind::fixed) continue;
    const bool turns = joint.kind == spatial::JointKind::revolute;
    out += layout::entry("driver", fmt::format("{}: {} = {}", joint.name, turns ? "angle" : "shift",
                                               function_text(joint.driver, turns ? "rad" : "m")));
  }
  for (const spatial::AppliedLoad& load : mechanism.loads) {
    const bool force = load.kind == spatial::LoadKind::force;
    out += layout::entry(
        "load", fmt::format("{}: {} on {}, {} {}, along {} of {}, = {}", load.name,
                            force ? "force" : "couple", body_name(mechanism, load.on),
                            force ? "acting at" : "entering at", place_text(mechanism, load.at),
                            direction_text(load.direction), axes_text(mechanism, load.axes),
                            function_text(load.size, force ? "N" : "N m")));
  }
  for (const spatial::LineForce& line : mechanism.line_forces) {
    out += layout::entry(
        "load",
        fmt::format("{}: force per length on {}, from {} to {}, along {} of {}, = {}", line.name,
                    body_name(mechanism, line.on), place_text(mechanism, {line.on, line.from}),
                    place_text(mechanism, {line.on, line.to}), direction_text(line.direction),
                    axes_text(mechanism, line.axes), function_text(line.size, "N/m")));
  }
  if (mechanism.duration.length > 0.0) {
    out += layout::entry(
        "motion", fmt::format("{} s looked at, after {} s left out",
                              plain(mechanism.duration.length), plain(mechanism.duration.settle)));
  }
  return out;
}

}  // namespace boxbeam
