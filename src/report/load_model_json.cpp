#include "load_model_json.hpp"

namespace boxbeam {
namespace {

Json vector_json(const Eigen::Vector3d& v) {
  return Json::array({finite(v.x()), finite(v.y()), finite(v.z())});
}

Json force_json(const Eigen::Vector2d& force) {
  return {{"fx", finite(force.x())}, {"fy", finite(force.y())}};
}

}  // namespace

Json mechanism_json(const Project& project) {
  if (is_flexible(project)) return {};
  Json gravity = Json::array();
  Json bodies = Json::object();
  if (in_space(project)) {
    for (const double g : spatial_of(project).gravity) gravity.push_back(finite(g));
    for (const spatial::Body& body : spatial_of(project).bodies) {
      bodies[body.name] = {{"mass", finite(body.mass)}, {"inertia", Json()}};
    }
  } else {
    for (const double g : planar_of(project).gravity) gravity.push_back(finite(g));
    for (const Body& body : planar_of(project).bodies) {
      bodies[body.name] = {{"mass", finite(body.mass)}, {"inertia", finite(body.inertia)}};
    }
  }
  return {{"gravity", std::move(gravity)}, {"bodies", std::move(bodies)}};
}

Json freedom_json(const Verification& verification) {
  const auto& closure = verification.motions.front().closure;
  if (!closure) return {};
  return {{"gruebler", closure->freedom.gruebler}, {"by_rank", closure->freedom.by_rank}};
}

Json equivalent_mass_json(const Project& project, const Verification& verification) {
  if (!verification.equivalent_mass) return {};
  return {{"given", finite(verification.equivalent_mass->given)},
          {"per_mass", finite(verification.equivalent_mass->per_mass)},
          {"wanted", finite(project.equivalent_mass->wanted.value())},
          {"needed", finite(verification.equivalent_mass->needed)}};
}

Json newton_chain_json(const Verification& verification) {
  if (!verification.chain) return {};
  const ChainComparison& chain = *verification.chain;
  const bool both = !chain.rigorous_first.isZero() || !chain.rigorous_second.isZero();
  Json rigorous;
  if (both) {
    rigorous = {{"first", force_json(chain.rigorous_first)},
                {"second", force_json(chain.rigorous_second)}};
  }
  return {{"time", finite(chain.time.value())},
          {"first", force_json(chain.chain_first)},
          {"second", force_json(chain.chain_second)},
          {"sought_mass", finite(chain.chain_mass.value())},
          {"moment_gap", finite(chain.moment_gap.value())},
          {"rigorous", std::move(rigorous)}};
}

Json loads_json(const Project& project, const Verification& verification) {
  Json loads = Json::array();
  for (const BeamLoadRow& row : verification.loads) {
    loads.push_back({{"by", row.name},
                     {"situation", project.situations[row.situation].name},
                     {"time", finite(row.time.value())},
                     {"s", finite(row.s.value())},
                     {"world", vector_json(row.world)},
                     {"force", vector_json(row.force)},
                     {"moment", vector_json(row.moment)}});
  }
  return loads;
}

}  // namespace boxbeam
