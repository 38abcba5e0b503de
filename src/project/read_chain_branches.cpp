#include <fmt/format.h>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// Places, "body.point".
std::vector<spatial::Attachment> places_of_branch(TableReader& table, const Key& key,
                                                  std::size_t count,
                                                  const spatial::Mechanism& mechanism) {
  const std::size_t before = table.problems().size();
  const std::vector<std::string> names = table.texts(key, true);
  std::vector<spatial::Attachment> places(count);
  if (table.problems().size() != before) return places;
  if (names.size() != count) {
    table.problem(key.name, fmt::format("{} points are wanted, not {}", count, names.size()),
                  "write each as \"body.point\"");
    return places;
  }
  for (std::size_t i = 0; i < count; ++i)
    places[i] = point_named(table, key.name, names[i], mechanism);
  return places;
}

spatial::Branch read_branch(const std::string& name, TableReader& table,
                            const spatial::Mechanism& mechanism) {
  spatial::Branch branch;
  branch.name = name;
  if (!table.says_one_of({{{"turn"}}, {{"along"}}})) {
    table.texts("turn", false);
    table.texts("along", false);
    table.problem("", fmt::format("loop \"{}\" wants either \"turn\" or \"along\"", name),
                  "turn = [three points] for their sense of turn about a direction, along = [two "
                  "points] for the sense of a vector along it");
  } else if (table.has("turn")) {
    const auto places = places_of_branch(
        table,
        {"turn",
         "three points, \"body.point\": \"+\" where the way over them turns about the direction, "
         "right-handed"},
        3, mechanism);
    branch.from = places[0];
    branch.via = places[1];
    branch.to = places[2];
  } else {
    const auto places = places_of_branch(
        table,
        {"along", "two points: \"+\" where the second lies from the first along the direction"}, 2,
        mechanism);
    branch.from = places[0];
    branch.to = places[1];
  }
  const Key axes{"axes", "\"world\", or the body in whose axes the direction is"};
  branch.axes =
      table.text(axes, "world") == "world" ? spatial::ground : body_of(table, axes, mechanism);
  branch.direction = table.direction({"direction", "of the sense, or about which they turn"});
  branch.sign =
      table.choice({"sign", "of the branch that is wanted at t = 0"}, {"+", "-"}) == 0 ? 1 : -1;
  table.finish();
  return branch;
}

}  // namespace

void read_chain_branches(TableReader& root, spatial::Mechanism& mechanism) {
  TableReader loops = root.table({"loops", "which way of assembly is meant"}, false);
  for (auto& [name, table] : loops.named_tables()) {
    // What a motion says of all equations together has this name.
    if (name == "loops") table.problem("", "no loop is called \"loops\"", "give it another name");
    mechanism.branches.push_back(read_branch(name, table, mechanism));
  }
}

}  // namespace boxbeam::readers
