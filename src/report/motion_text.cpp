#include "boxbeam/report/motion_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boxbeam/core/code_points.hpp"
#include "text_layout.hpp"

namespace boxbeam {

using layout::Table;

std::string motion_text(const Project& project, const AnyMotionResult& motion) {
  return std::visit([&](const auto& of_kind) { return motion_text(project, of_kind); }, motion);
}

std::string motion_text(const Project& project, const MotionResult& motion) {
  std::string out = layout::line(fmt::format(
      "{}: {} degree{} of freedom (Gruebler {}, rank {}), {} driver{}", visible(project.title),
      motion.freedom.by_rank, motion.freedom.by_rank == 1 ? "" : "s", motion.freedom.gruebler,
      motion.freedom.by_rank, motion.freedom.drivers, motion.freedom.drivers == 1 ? "" : "s"));
  if (!motion.redundant.empty()) {
    out += layout::line(
        fmt::format("redundant: {} repeat each other; how they share their load is not determined "
                    "by rigid bodies",
                    fmt::join(motion.redundant, ", ")));
  }
  for (const double time : motion.change_points) {
    out += layout::line(fmt::format(
        "change point at t = {:.6g} s: two branches cross, the smooth one is followed", time));
  }
  for (const StickingContact& contact : motion.sticking) out += layout::line(to_text(contact));
  const auto f = [](double x) { return fmt::format("{:.6g}", x == 0.0 ? 0.0 : x); };  // no "-0"
  for (const InstantResult& state : motion.states) {
    std::string about = fmt::format("t = {:.6g} s: branch", state.time);
    for (const auto& [loop, sign] : state.branch)
      about += fmt::format(" {} {}", loop, sign > 0 ? "+" : "-");
    about += fmt::format("; joints closed to {:.1e}", state.residual);
    if (state.condition > 0.0) {
      about += fmt::format(", condition {:.3g}, {:.0f} digits of velocities left", state.condition,
                           std::floor(state.digits));
    }
    out += "\n" + layout::line(about);
    Table bodies({"body", "x [m]", "y [m]", "angle [rad]", "vx [m/s]", "vy [m/s]", "omega [rad/s]",
                  "ax [m/s^2]", "ay [m/s^2]", "alpha [rad/s^2]"});
    for (const BodyMotion& body : state.bodies) {
      std::vector<std::string> row{body.name};
      for (const Eigen::Vector3d* values : {&body.position, &body.velocity, &body.acceleration}) {
        for (const double value : *values) row.push_back(f(std::abs(value) < 1e-14 ? 0.0 : value));
      }
      bodies.row(row);
    }
    Table joints({"reaction of", "on", "Fx [N]", "Fy [N]", "moment [N m]"});
    for (const JointReaction& reaction : state.reactions) {
      const auto unique = [&](double value) { return reaction.unique ? f(value) : "not unique"; };
      joints.row({reaction.joint, reaction.on, unique(reaction.force.x()),
                  unique(reaction.force.y()), unique(reaction.moment)});
    }
    out += bodies.text() + "\n" + joints.text();
  }
  return out;
}

std::string assemblies_text(const Project& project, const std::vector<AssemblyResult>& assemblies,
                            double time) {
  std::string out = layout::line(
      fmt::format("{}: {} {} found at t = {:.6g} s", visible(project.title), assemblies.size(),
                  assemblies.size() == 1 ? "assembly" : "assemblies", time));
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    out += fmt::format("\nassembly {}", i + 1);
    bool wanted = !assemblies[i].branch.empty();
    for (std::size_t k = 0; k < assemblies[i].branch.size(); ++k) {
      const auto& [loop, sign] = assemblies[i].branch[k];
      out += fmt::format("   loop {} {}", loop, sign > 0 ? "+" : (sign < 0 ? "-" : "0"));
      wanted = wanted && sign == planar_of(project).loops[k].sign;
    }
    out += wanted ? "   (the one the case asks for)\n" : "\n";
    Table bodies({"body", "x [m]", "y [m]", "angle [deg]"});
    for (const auto& [name, at] : assemblies[i].bodies) {
      const auto f = [](double x) { return fmt::format("{:.6g}", std::abs(x) < 1e-10 ? 0.0 : x); };
      bodies.row({name, f(at.x()), f(at.y()), f(at.z() * 180.0 / std::numbers::pi)});
    }
    out += bodies.text();
  }
  return out;
}

}  // namespace boxbeam
