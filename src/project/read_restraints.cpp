#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxbeam/beam/tapered_beam.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// A way in which a beam is held, by its word.
struct WayToHold {
  const char* word;
  bool Restraint::*holds;
};

constexpr std::array ways_to_hold{WayToHold{"along y", &Restraint::along_y},
                                  WayToHold{"along z", &Restraint::along_z},
                                  WayToHold{"turning over", &Restraint::turning}};

Restraint read_restraint(TableReader table, const TaperedBeam& beam) {
  Restraint restraint;
  restraint.s = station_of(table, {"station", "along the beam"}, beam);
  constexpr const char* hint =
      "holds = [\"along y\", \"along z\", \"turning over\"], those that hold; z lies in the plane "
      "of motion, y across it";
  for (const std::string& word :
       table.texts({"holds", "\"along y\", \"along z\", \"turning over\" about the axis"}, true)) {
    const auto way = std::find_if(ways_to_hold.begin(), ways_to_hold.end(),
                                  [&](const WayToHold& of) { return of.word == word; });
    if (way == ways_to_hold.end())
      table.problem("holds", fmt::format("a beam is not held \"{}\"", word), hint);
    else
      restraint.*way->holds = true;
  }
  restraint.clamped =
      table.boolean({"clamped", "along y and z the direction of its axis is held, too"}, false);
  const bool bends = restraint.along_y || restraint.along_z;
  if (table.problems().empty() && !bends && !restraint.turning)
    table.problem("holds", "nothing is held", hint);
  if (table.problems().empty() && restraint.clamped && !bends)
    table.problem("clamped", "a clamp holds along y or z, not against turning over alone",
                  "remove it: warping is free everywhere");
  table.finish();
  return restraint;
}

/// Notes what is said twice, and bending in which the beam could move as a whole.
void check_way(TableReader& table, const TaperedBeam& beam, const WayToHold& way,
               const std::vector<Restraint>& restraints) {
  std::vector<Restraint> of;
  for (const Restraint& restraint : restraints)
    if (restraint.*way.holds) of.push_back(restraint);
  if (of.empty()) return;
  for (std::size_t i = 1; i < of.size(); ++i) {
    if (of[i].s != of[i - 1].s) continue;
    table.problem(
        "restraints",
        fmt::format("at s = {:.6g} m the beam is held {} twice", of[i].s.value(),
                    way.word == ways_to_hold.back().word ? "against turning over" : way.word),
        "write it once");
    return;
  }
  if (way.holds == &Restraint::turning) return;
  const bool clamped =
      std::any_of(of.begin(), of.end(), [](const Restraint& each) { return each.clamped; });
  // Pins so near each other hold as a clamp, by how stiff the beam is between them.
  constexpr double near = 0.02;
  if (!clamped && of.back().s - of.front().s < near * beam.length()) {
    table.problem("restraints",
                  fmt::format("what holds the beam {} lets it turn: one pin, or pins nearer to "
                              "each other than {} of its length",
                              way.word, near),
                  "write all that holds it so, also where the mechanism does; or clamped = true");
  }
}

}  // namespace

std::vector<Restraint> read_restraints(TableReader& table, const TaperedBeam& beam) {
  std::vector<Restraint> restraints;
  for (TableReader& one : table.tables(
           {"restraints",
            "what holds it against buckling, all of a way that one of them has; where none "
            "has it, what carries the beam is taken for it"}))
    restraints.push_back(read_restraint(one, beam));
  if (!table.problems().empty()) return restraints;
  std::stable_sort(restraints.begin(), restraints.end(),
                   [](const Restraint& a, const Restraint& b) { return a.s < b.s; });
  for (const WayToHold& way : ways_to_hold) check_way(table, beam, way, restraints);
  return restraints;
}

}  // namespace boxbeam::readers
