#include <fmt/format.h>

#include <algorithm>

#include "readers.hpp"

namespace boxbeam::readers {

void refuse_mass(TableReader& table) {
  for (const char* key : {"mass", "inertia", "uniform_rod", "centre"}) {
    if (!table.is_there(key) || !table.has(key)) continue;
    table.problem(key,
                  fmt::format("the mass properties of the beam come from its sections; \"{}\" "
                              "has no place here",
                              key),
                  "remove this line");
  }
}

namespace {

void read_mass(TableReader& table, Body& body, Eigen::Vector2d& centre) {
  body.mass = table.not_negative({"mass", "of the body"}, wanted::mass);
  centre = table.pair({"centre", "centre of mass, where it is not the origin"}, wanted::length,
                      Eigen::Vector2d::Zero());
  static_cast<void>(table.says_one_of({{{"uniform_rod"}}, {{"inertia"}}, {}}));
  if (table.has("uniform_rod")) {
    const double length = table.positive(
        {"uniform_rod", "a uniform bar of this length: gives the inertia"}, wanted::length);
    body.inertia = body.mass * length * length / 12.0;
    if (table.has("inertia")) {
      table.problem("inertia", "\"uniform_rod\" gives the inertia, and \"inertia\" gives it too",
                    "leave out one of the two");
    }
  } else {
    body.inertia =
        table.not_negative({"inertia", "about the centre of mass"}, wanted::inertia, 0.0);
  }
}

/// Rough position and velocity, of the origin of the body's axes until the centre is known.
void read_sketch(TableReader sketch, Body& body) {
  body.sketch.centre = sketch.pair({"at", "where its axes lie"}, wanted::length);
  body.sketch.angle = sketch.quantity({"angle", "how they are turned"}, wanted::angle, 0.0);
  body.start_velocity.head<2>() = sketch.pair({"velocity", "of its origin; for free motions"},
                                              wanted::velocity, Eigen::Vector2d::Zero());
  body.start_velocity.z() = sketch.quantity({"angular_velocity", "of the body; for free motions"},
                                            wanted::angular_velocity, 0.0);
  sketch.finish();
}

Body read_body(const std::string& name, TableReader& table, bool is_beam, Eigen::Vector2d& centre) {
  Body body;
  body.name = name;
  if (name == "ground") {
    table.problem("", "\"ground\" is the world and no body", "give the body another name");
  }
  if (is_beam) {
    refuse_mass(table);
  } else {
    read_mass(table, body, centre);
  }
  TableReader points = table.table({"points", "of the body, by name, in its own axes"});
  points.accept_all();
  for (const Node::Member& member : points.members("a point")) {
    body.points.push_back(
        {member.key,
         points.pair_in(member.value, fmt::format("point \"{}\"", member.key), wanted::length)});
  }
  read_sketch(table.table({"sketch", "roughly where it stands in the beginning"}), body);
  table.finish();
  return body;
}

}  // namespace

void read_bodies(TableReader& root, const std::vector<std::string>& beam_bodies,
                 MechanismDraft& draft) {
  TableReader bodies = root.table({"bodies", "rigid bodies"});
  const std::string& beam_body = beam_bodies.front();
  const bool beam_known = root.has("beam") && (beam_body.empty() || bodies.is_there(beam_body));
  for (auto& [name, table] : bodies.named_tables()) {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    const bool is_beam =
        std::find(beam_bodies.begin(), beam_bodies.end(), name) != beam_bodies.end() ||
        (!beam_known && !table.is_there("mass"));
    draft.mechanism.bodies.push_back(read_body(name, table, is_beam, centre));
    draft.centres.push_back(centre);
  }
}

}  // namespace boxbeam::readers
