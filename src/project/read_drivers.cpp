#include <algorithm>
#include <tuple>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Coordinate;
using planar::Driven;
using planar::Mechanism;

constexpr FunctionOf length{wanted::length, "m", "stroke", "the driver does not move", true};
constexpr FunctionOf angle{wanted::angle, "rad", "angle", "the driver does not move", true};

/// The angle of one body against another.
Driven read_relative_angle(TableReader& table, const Mechanism& mechanism) {
  Driven driven;
  driven.coordinate = Coordinate::angle;
  const std::size_t before = table.problems().size();
  const std::vector<std::string> references = table.texts("points", true);
  if (table.problems().size() != before) return driven;
  if (std::find(references.begin(), references.end(), "ground") != references.end()) {
    table.problem("points", "an angle against the ground is no relative angle",
                  "write coordinate = \"angle\" and point = \"body.point\"");
    return driven;
  }
  std::tie(driven.point, driven.other) = ends_in(
      table, {{"points", "the two bodies, \"body.point\""}, "a relative angle", false}, mechanism);
  return driven;
}

/// The distance of two points; the first of them is on a body.
Driven read_length(TableReader& table, const Mechanism& mechanism) {
  auto [a, b] = ends_in(
      table, {{"points", "two points whose distance is driven"}, "a driven length"}, mechanism);
  if (a.body == planar::ground) std::swap(a, b);
  return {a, Coordinate::length, {}, b};
}

/// What is driven, still without its function; nothing where the coordinate is not known.
std::optional<Driven> read_driven(TableReader& table, const Mechanism& mechanism) {
  const std::size_t before = table.problems().size();
  const std::size_t coordinate =
      table.kind({"coordinate", "what is driven"}, {"x", "y", "angle", "relative angle", "length"});
  if (table.problems().size() != before) return std::nullopt;
  constexpr Coordinate of_a_point[] = {Coordinate::x, Coordinate::y, Coordinate::angle};
  switch (coordinate) {
    case 3: return read_relative_angle(table, mechanism);
    case 4: return read_length(table, mechanism);
    default:
      return Driven{
          attachment_of(table, {"point", "whose coordinate or body is driven, \"body.point\""},
                        mechanism),
          of_a_point[coordinate],
          {},
          {}};
  }
}

}  // namespace

void read_drivers(TableReader& root, Mechanism& mechanism, TimeTables& tables) {
  TableReader drivers = root.table({"drivers", "functions of time that move the mechanism"}, false);
  for (auto& [name, table] : drivers.named_tables()) {
    check_name(table, name, "driver", mechanism);
    std::optional<Driven> driven = read_driven(table, mechanism);
    const bool turns = driven && driven->coordinate == Coordinate::angle;
    std::optional<Driver> function;
    if (driven) function = read_function(table, turns ? angle : length, tables);
    if (function) {
      driven->driver = std::move(*function);
      table.finish();
    }
    mechanism.joints.push_back({name, driven.value_or(Driven{})});
  }
}

}  // namespace boxbeam::readers
