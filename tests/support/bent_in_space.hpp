#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <deque>
#include <string>
#include <utility>
#include <variant>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "src/verification/bent_in_space.hpp"
#include "src/verification/load_numbers.hpp"

/// Cases of mechanisms in space whose beams bend by statics of the second order.
namespace test::bent {

using namespace boxbeam;
using Eigen::Vector3d;

inline constexpr double E = 210e9, G = 81e9;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// By statics of the second order.
inline ElasticModel bent_by(int parts) { return {ModelLevel::quasi_static, 0, parts, {}, false}; }

inline std::string vector_text(const Vector3d& of) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", of.x(), of.y(), of.z());
}

/// Of lasting direction.
inline std::string force_text(const std::string& name, const std::string& point,
                              const Vector3d& force) {
  return fmt::format(
      "[forces.{}]\nkind = \"force\"\npoint = \"{}\"\ndirection = {}\nsize = \"{:.17g} N\"\n", name,
      point, vector_text(force.normalized()), force.norm());
}

inline const std::string sections = R"(
[sections.arm]
kind = "box"
width = "100 mm"
height = "150 mm"
flange = "8 mm"
web = "6 mm"
[sections.tip]
kind = "box"
width = "80 mm"
height = "90 mm"
flange = "8 mm"
web = "6 mm"
)";

inline const std::string demands = R"(
[material]
steel = "S355"
[strength]
required = 1.0
[motion]
duration = "1 s"
)";

inline std::string header(const Vector3d& gravity = Vector3d::Zero()) {
  return fmt::format(
      "[case]\nname = \"s\"\nkind = \"spatial\"\n[mechanism]\ngravity = [\"{:.17g} m/s^2\", "
      "\"{:.17g} m/s^2\", \"{:.17g} m/s^2\"]\n",
      gravity.x(), gravity.y(), gravity.z());
}

/// The six cut forces.
inline Vector6 cuts_at(const CutForceDiagram& diagram, double s, Side side = Side::both) {
  const CutForces cut = diagram.at({si<Length>(s), side});
  Vector6 of;
  of << cut.N.value(), cut.V_y.value(), cut.V_z.value(), cut.T.value(), cut.M_y.value(),
      cut.M_z.value();
  return of;
}

/// A case with its rigid bodies, and bent at its first instant.
struct Bent {
  Project project;
  std::deque<SituationRun> rigid;
  int parts;

  explicit Bent(Project of, int divided = 16)
      : project(std::move(of)), rigid(run_situations(project)), parts(divided) {}
  explicit Bent(const std::string& text, int divided = 16)
      : Bent(parse_project("bent.toml", text), divided) {}
  Bent(const Bent&) = delete;

  const Section& section() const { return project.beam.segments.front().from; }
  Time time() const { return rigid.front().loads.time_of(0); }
  CutForceDiagram straight() const { return rigid.front().loads.diagram(0); }
  frame::BentScene scene(double factor = 1.0) const {
    const spatial::Chain& chain = chain_of(rigid.front());
    return BentInSpace(project, chain, parts)
        .at(chain.at(time().value()), straight(), factor)
        .value();
  }
  CutForceDiagram diagram() const {
    if (std::holds_alternative<planar::Mechanism>(project.mechanism))
      return run_situations(project, bent_by(parts)).front().loads.diagram(0);
    const frame::BentScene of = scene();
    REQUIRE_FALSE(of.critical);
    BeamLoads loads = rigid.front().loads.loads_at(time());
    add_bending(of.loads, loads);
    return cut_forces_of(loads);
  }
};

}  // namespace test::bent
