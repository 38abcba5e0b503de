#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "boxbeam/mechanism/spatial/friction.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using spatial::Body;
using spatial::Mechanism;

/// Notes an inertia that no distribution of mass has: principal moments are not below zero, and
/// none is above the sum of the other two.
void check_inertia(TableReader& table, const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  const Eigen::Vector3d& moments = principal.eigenvalues();
  const double slack = 1e-9 * moments.cwiseAbs().maxCoeff();
  if (moments[0] >= -slack && moments[2] <= moments[0] + moments[1] + slack) return;
  table.problem("inertia",
                fmt::format("no body has these principal moments of inertia: {:.4g}, {:.4g} and "
                            "{:.4g} kg m^2",
                            moments[0], moments[1], moments[2]),
                "each is zero or more, and at most the sum of the other two");
}

/// The centre and inertia of a thin rod between two points of the body.
void read_rod(TableReader& table, Body& body) {
  const std::size_t before = table.problems().size();
  const std::vector<std::string> names = table.texts(
      {"uniform_rod", "a uniform thin rod between two of its points: gives centre and inertia"},
      true);
  if (table.problems().size() != before) return;
  std::vector<Eigen::Vector3d> ends;
  for (const std::string& name : names) {
    for (const spatial::BodyPoint& point : body.points) {
      if (point.name == name) ends.push_back(point.p);
    }
  }
  if (names.size() != 2 || ends.size() != 2) {
    table.problem("uniform_rod", "a rod lies between two points of its body",
                  names.size() == 2
                      ? "known: " + fmt::format("{}", fmt::join(names_of(body.points), ", "))
                      : "write uniform_rod = [\"B\", \"C\"]");
    return;
  }
  const Eigen::Vector3d along = ends[1] - ends[0];
  if (along.norm() == 0.0) {
    table.problem("uniform_rod", "the rod has no length: both points are at one place",
                  "name two points apart");
  }
  body.centre = 0.5 * (ends[0] + ends[1]);
  body.inertia = body.mass / 12.0 *
                 (along.squaredNorm() * Eigen::Matrix3d::Identity() - along * along.transpose());
}

void read_mass(TableReader& table, Body& body) {
  body.mass = table.not_negative({"mass", "of the body"}, wanted::mass, 0.0);
  static_cast<void>(table.says_one_of({{{"uniform_rod"}}, {{"centre", "inertia"}, false}, {}}));
  if (table.has("uniform_rod")) {
    if (table.has("centre") || table.has("inertia")) {
      table.problem("uniform_rod", "the rod gives centre and inertia",
                    "remove \"centre\" and \"inertia\", or \"uniform_rod\"");
      table.accept_all();
    }
    read_rod(table, body);
    return;
  }
  body.centre = table.triple({"centre", "centre of mass"}, wanted::length, Eigen::Vector3d::Zero());
  if (table.has("inertia")) {
    body.inertia = table.symmetric(
        {"inertia", "about the centre of mass: xx, yy, zz, or three rows"}, wanted::inertia);
    check_inertia(table, body.inertia);
    if (body.mass == 0.0 && body.inertia.allFinite() && !body.inertia.isZero(0.0)) {
      table.problem("inertia", "a body with inertia has a mass", "write \"mass\"");
    }
  }
}

Body read_body(const std::string& name, TableReader& table, bool is_beam) {
  Body body;
  body.name = name;
  if (name == "ground" || name == "world" || name.empty()) {
    table.problem("",
                  name.empty() ? std::string("a body has a name")
                               : fmt::format("\"{}\" is the world and no body", name),
                  "give the body another name");
  }
  TableReader points = table.table({"points", "of the body, by name, in its own axes"}, false);
  points.accept_all();
  for (const Node::Member& member : points.members("a point")) {
    body.points.push_back(
        {member.key,
         points.triple_in(member.value, fmt::format("point \"{}\"", member.key), wanted::length)});
  }
  if (is_beam)
    refuse_mass(table);
  else
    read_mass(table, body);
  table.finish();
  return body;
}

/// The joints with dry friction of which a case gives no creep velocity.
std::vector<std::size_t> joints_without_creep(const TableReader& root, const Mechanism& mechanism) {
  std::vector<std::size_t> found;
  const Node* const joints = root.peek("joints");
  if (joints == nullptr) return found;
  for (const spatial::FrictionContact& contact : spatial::friction_contacts_of(mechanism)) {
    if (contact.law.coulomb == 0.0) continue;
    const std::string& name = name_of_contact(mechanism, contact);
    // "shaft.2" slides in "shaft".
    const Node* at = joints->find(name);
    if (at == nullptr) at = joints->find(name.substr(0, name.rfind('.')));
    if (at != nullptr) at = at->find("friction");
    if (at != nullptr && at->find("creep") == nullptr) found.push_back(contact.joint);
  }
  return found;
}

}  // namespace

ChainDraft read_chain(TableReader& root, const std::vector<std::string>& beam_bodies,
                      TimeTables& tables) {
  ChainDraft chain;
  Mechanism& mechanism = chain.mechanism;
  TableReader general = root.table({"mechanism", "general"});
  mechanism.gravity =
      general.triple({"gravity", "acceleration of free fall, world axes"}, wanted::acceleration);
  general.finish();
  mechanism.duration = read_duration(root);
  for (auto& [name, table] :
       root.table({"bodies", "rigid bodies; one joint carries each"}).named_tables()) {
    mechanism.bodies.push_back(read_body(
        name, table, std::find(beam_bodies.begin(), beam_bodies.end(), name) != beam_bodies.end()));
  }
  if (!read_chain_joints(root, chain, tables)) return chain;
  const auto forced =
      std::find_if(mechanism.joints.begin(), mechanism.joints.end(), spatial::is_forced);
  if (forced != mechanism.joints.end() && !(mechanism.duration.length > 0.0) &&
      root.problems().empty()) {
    root.table("joints").problem(
        forced->name.substr(0, forced->name.find('.')),
        fmt::format("forces move joint \"{}\": how long is not known", forced->name),
        "write [motion] with duration = \"2 s\", and settle = \"1 s\" for a time before it");
  }
  read_chain_loads(root, mechanism, tables);
  read_chain_branches(root, mechanism);
  check_functions(root, functions_of(mechanism), mechanism.duration, {"joints", "forces"});
  if (root.problems().empty()) fit_creep(mechanism, joints_without_creep(root, mechanism));
  return chain;
}

}  // namespace boxbeam::readers
