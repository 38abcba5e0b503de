#include "boxbeam/project/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/project/limits.hpp"
#include "node_kinds.hpp"

namespace boxbeam {
namespace {

/// The unit of an example, "m" of "\"0.25 m\" or \"250 mm\"".
std::string unit_of(std::string_view example) {
  const std::size_t begin = example.find(' ');
  if (begin == std::string_view::npos) return "";
  return std::string(example.substr(begin + 1, example.find('"', begin) - begin - 1));
}

/// A default value as a case would write it.
std::string text_of(std::optional<double> value, const WantedDimension& wanted) {
  if (!value) return "";
  const std::string unit = unit_of(wanted.example);
  const auto one = parse_quantity("1 " + unit);
  const auto* size = std::get_if<ParsedQuantity>(&one);
  if (size == nullptr) return fmt::format("{:g}", *value);
  return fmt::format("\"{:g} {}\"", *value / size->value, unit);
}

}  // namespace

double TableReader::quantity_in(const Node& node, const std::string& what,
                                const WantedDimension& wanted) {
  const std::string hint = fmt::format("write it as text with its unit, {}", wanted.example);
  if (node.kind != Node::Kind::text) {
    problems_->add(node.place, fmt::format("{} is {}, not {}", what, wanted.name, kind_name(node)),
                   hint);
    return std::nan("");
  }
  const auto parsed = parse_quantity(node.text);
  if (const auto* trouble = std::get_if<std::string>(&parsed)) {
    problems_->add(node.place, fmt::format("{}: {}", what, *trouble), hint);
    return std::nan("");
  }
  const auto& quantity = std::get<ParsedQuantity>(parsed);
  if (!is_of(quantity.exponents, wanted)) {
    problems_->add(node.place,
                   fmt::format("{} is {}, but \"{}\" is {}", what, wanted.name, node.text,
                               name_of(quantity.exponents)),
                   hint);
    return std::nan("");
  }
  if (const limits::Range range = limits::range_of(wanted);
      std::abs(quantity.value) > range.largest) {
    problems_->add(
        node.place, fmt::format("{}: {} is too large to be meant", what, node.text),
        fmt::format("at most {}; write for example {}", range.largest_text, wanted.example));
    return std::nan("");
  }
  return quantity.value;
}

double TableReader::quantity(const Key& of, const WantedDimension& wanted,
                             std::optional<double> fallback) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::quantity,
         {.required = !fallback, .wanted = &wanted, .fallback = text_of(fallback, wanted)});
  const Node* node = take(key, !fallback, wanted.example);
  if (node == nullptr) return fallback.value_or(std::nan(""));
  return quantity_in(*node, fmt::format("\"{}\"", key), wanted);
}

double TableReader::positive(const Key& of, const WantedDimension& wanted,
                             std::optional<double> fallback) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::positive,
         {.required = !fallback, .wanted = &wanted, .fallback = text_of(fallback, wanted)});
  const double value = quantity(of, wanted, fallback);
  if (value < limits::range_of(wanted).smallest) {
    problem(key,
            value <= 0.0 ? fmt::format("\"{}\" must be above zero", key)
                         : fmt::format("\"{}\" is too small to be meant", key),
            fmt::format("write for example {}", wanted.example));
    return std::nan("");
  }
  return value;
}

double TableReader::not_negative(const Key& of, const WantedDimension& wanted,
                                 std::optional<double> fallback) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::not_negative,
         {.required = !fallback, .wanted = &wanted, .fallback = text_of(fallback, wanted)});
  const double value = quantity(of, wanted, fallback);
  if (value < 0.0) {
    problem(key, fmt::format("\"{}\" must not be below zero", key),
            fmt::format("write zero or more, for example {}", wanted.example));
    return std::nan("");
  }
  if (value > 0.0 && value < limits::range_of(wanted).smallest) {
    problem(key, fmt::format("\"{}\" is too small to be meant", key),
            fmt::format("write zero, or for example {}", wanted.example));
    return std::nan("");
  }
  return value;
}

Eigen::Vector2d TableReader::pair_in(const Node& node, const std::string& what,
                                     const WantedDimension& wanted) {
  if (recording() && own_names_) note("*", KeyShape::pair, {.wanted = &wanted});
  if (node.kind != Node::Kind::array || node.items.size() != 2) {
    problems_->add(node.place, fmt::format("{} wants two values, x and y", what),
                   "write it as [\"0.5 m\", \"0 m\"] with the units that belong there");
    return Eigen::Vector2d::Constant(std::nan(""));
  }
  return {quantity_in(node.items[0], what + " x", wanted),
          quantity_in(node.items[1], what + " y", wanted)};
}

Eigen::Vector2d TableReader::pair(const Key& of, const WantedDimension& wanted,
                                  std::optional<Eigen::Vector2d> fallback) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::pair, {.required = !fallback, .wanted = &wanted});
  const Node* node = take(key, !fallback, "[x, y] with units");
  if (node == nullptr) return fallback.value_or(Eigen::Vector2d::Constant(std::nan("")));
  return pair_in(*node, fmt::format("\"{}\"", key), wanted);
}

Eigen::Vector3d TableReader::triple_in(const Node& node, const std::string& what,
                                       const WantedDimension& wanted) {
  if (recording() && own_names_) note("*", KeyShape::triple, {.wanted = &wanted});
  if (node.kind != Node::Kind::array || node.items.size() != 3) {
    problems_->add(node.place, fmt::format("{} wants three values, x, y and z", what),
                   "write it as [\"0.5 m\", \"0 m\", \"0 m\"] with the units that belong there");
    return Eigen::Vector3d::Constant(std::nan(""));
  }
  return {quantity_in(node.items[0], what + " x", wanted),
          quantity_in(node.items[1], what + " y", wanted),
          quantity_in(node.items[2], what + " z", wanted)};
}

Eigen::Vector3d TableReader::triple(const Key& of, const WantedDimension& wanted,
                                    std::optional<Eigen::Vector3d> fallback) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::triple, {.required = !fallback, .wanted = &wanted});
  const Node* node = take(key, !fallback, "[x, y, z] with units");
  if (node == nullptr) return fallback.value_or(Eigen::Vector3d::Constant(std::nan("")));
  return triple_in(*node, fmt::format("\"{}\"", key), wanted);
}

Eigen::Matrix3d TableReader::symmetric(const Key& of, const WantedDimension& wanted) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::symmetric, {.required = true, .wanted = &wanted});
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Constant(std::nan(""));
  const Node* node = take(key, true, "[xx, yy, zz] with units");
  if (node == nullptr) return matrix;
  const std::string what = fmt::format("\"{}\"", key);
  const bool rows = node->kind == Node::Kind::array && node->items.size() == 3 &&
                    node->items[0].kind == Node::Kind::array;
  if (!rows) return triple_in(*node, what, wanted).asDiagonal();
  for (int i = 0; i < 3; ++i) {
    matrix.row(i) = triple_in(node->items[static_cast<std::size_t>(i)],
                              fmt::format("{}, row {},", what, i + 1), wanted);
  }
  const double size = matrix.cwiseAbs().maxCoeff();
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) {
    problem(key, fmt::format("{} is not symmetric", what),
            "the same product stands above and below the diagonal: xy = yx");
  }
  return 0.5 * (matrix + matrix.transpose());
}

Eigen::Vector3d TableReader::direction_in(const Node& node, const std::string& what) {
  const char* hint = "write \"x\", \"-z\" or three numbers, [0.6, 0, 0.8]";
  if (node.kind == Node::Kind::text) {
    const bool minus = node.text.starts_with('-');
    const std::string letter = minus ? node.text.substr(1) : node.text;
    for (int k = 0; k < 3; ++k) {
      if (letter == std::string(1, "xyz"[k]))
        return (minus ? -1.0 : 1.0) * Eigen::Vector3d::Unit(k);
    }
    problems_->add(node.place, fmt::format("{} cannot be \"{}\"", what, node.text), hint);
    return Eigen::Vector3d::UnitX();
  }
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  bool numbers = node.kind == Node::Kind::array && node.items.size() == 3;
  for (int k = 0; k < 3 && numbers; ++k) {
    const Node& item = node.items[static_cast<std::size_t>(k)];
    numbers = item.kind == Node::Kind::number && std::abs(item.number) < limits::largest_number;
    vector[k] = item.number;
  }
  if (!numbers || !(vector.norm() > smallest_number)) {
    problems_->add(node.place, fmt::format("{} is no direction", what), hint);
    return Eigen::Vector3d::UnitX();
  }
  return vector.normalized();
}

Eigen::Vector3d TableReader::direction(const Key& of, std::optional<Eigen::Vector3d> fallback) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::direction, {.required = !fallback});
  const Node* node = take(key, !fallback, "\"x\", \"-z\" or three numbers");
  if (node == nullptr) return fallback.value_or(Eigen::Vector3d::UnitX());
  return direction_in(*node, fmt::format("\"{}\"", key));
}

std::vector<Eigen::Vector3d> TableReader::directions(const Key& of, std::size_t count) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::directions, {.required = true});
  std::vector<Eigen::Vector3d> directions;
  const std::vector<Node>* items = list_of(key, "\"x\", \"y\", \"z\"");
  if (items == nullptr) return directions;
  if (items->size() != count) {
    problem(key, fmt::format("\"{}\" wants {} directions", key, count),
            "each \"x\", \"-y\" or three numbers");
    return directions;
  }
  for (const Node& item : *items) {
    directions.push_back(
        direction_in(item, fmt::format("\"{}\", item {},", key, directions.size() + 1)));
  }
  return directions;
}

std::vector<std::pair<Eigen::Vector3d, double>> TableReader::turns(const Key& of) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::turns, {});
  std::vector<std::pair<Eigen::Vector3d, double>> turns;
  const Node* node = take(key, false, "");
  if (node == nullptr) return turns;
  const std::string what = fmt::format("\"{}\"", key);
  const auto is_turn = [](const Node& item) {
    return item.kind == Node::Kind::array && item.items.size() == 2 &&
           item.items[1].kind == Node::Kind::text;
  };
  const auto add = [&](const Node& item) {
    const Eigen::Vector3d axis = direction_in(item.items[0], what + ", axis,");
    turns.emplace_back(axis, quantity_in(item.items[1], what + ", angle,", wanted::angle));
  };
  const bool list = node->kind == Node::Kind::array &&
                    std::all_of(node->items.begin(), node->items.end(), is_turn);
  if (is_turn(*node)) {
    add(*node);
  } else if (list) {
    for (const Node& item : node->items) add(item);
  } else {
    problem(key, fmt::format("{} wants turns about axes, one after the other", what),
            fmt::format("write {} = [[\"x\", \"10 deg\"], [\"z\", \"5 deg\"]]", key));
  }
  return turns;
}

double TableReader::not_zero(const Key& of, const WantedDimension& wanted) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::not_zero, {.required = true, .wanted = &wanted});
  const double value = quantity(of, wanted);
  if (std::abs(value) < limits::range_of(wanted).smallest) {
    problem(key,
            value == 0.0 ? fmt::format("\"{}\" must not be zero", key)
                         : fmt::format("\"{}\" is too small to be meant", key),
            fmt::format("write for example {}", wanted.example));
    return std::nan("");
  }
  return value;
}

bool TableReader::is_too_long(const std::string& name, const Place& place, std::size_t count) {
  const std::size_t most = limits::most_entries(name);
  if (count <= most) return false;
  problems_->add(place, fmt::format("{} has {} entries", name, count),
                 fmt::format("at most {} are possible; split the case", most));
  return true;
}

const std::vector<Node>* TableReader::list_of(std::string_view key, const char* example) {
  const Node* node = take(key, true, "a list of values with units");
  if (node == nullptr) return nullptr;
  if (node->kind == Node::Kind::array) {
    return is_too_long(name_below(key), node->place, node->items.size()) ? nullptr : &node->items;
  }
  problem(key, fmt::format("\"{}\" wants a list", key),
          fmt::format("write {} = [{}]", key, example));
  return nullptr;
}

std::vector<double> TableReader::quantities(const Key& of, const WantedDimension& wanted) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::quantities, {.required = true, .wanted = &wanted});
  std::vector<double> values;
  const std::vector<Node>* items = list_of(key, wanted.example);
  if (items == nullptr) return values;
  for (const Node& item : *items) {
    values.push_back(quantity_in(item, fmt::format("\"{}\"", key), wanted));
  }
  return values;
}

std::vector<Eigen::Vector2d> TableReader::pairs(const Key& of, const WantedDimension& wanted) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::pairs, {.required = true, .wanted = &wanted});
  std::vector<Eigen::Vector2d> values;
  const std::vector<Node>* items = list_of(key, "[\"0 mm\", \"0 mm\"]");
  if (items == nullptr) return values;
  for (const Node& item : *items) {
    values.push_back(
        pair_in(item, fmt::format("\"{}\", item {},", key, values.size() + 1), wanted));
  }
  return values;
}

std::vector<std::vector<Eigen::Vector2d>> TableReader::lists_of_pairs(
    const Key& of, const WantedDimension& wanted) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::lists_of_pairs, {.wanted = &wanted});
  std::vector<std::vector<Eigen::Vector2d>> lists;
  if (!has(of)) return lists;
  const std::vector<Node>* items = list_of(key, "[[\"0 mm\", \"0 mm\"], ...]");
  if (items == nullptr) return lists;
  for (const Node& list : *items) {
    const std::string what = fmt::format("\"{}\", item {},", key, lists.size() + 1);
    lists.emplace_back();
    if (is_too_long(name_below(key), list.place, list.items.size())) return lists;
    for (const Node& item : list.items) lists.back().push_back(pair_in(item, what, wanted));
  }
  return lists;
}

std::vector<double> TableReader::quantities(const Key& of, std::span<const WantedDimension> each) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::each_quantity, {.required = true, .wanted = &each.front()});
  std::vector<double> values;
  const std::vector<Node>* items = list_of(key, each.front().example);
  if (items == nullptr) return values;
  if (items->size() > each.size()) {
    problem(key, fmt::format("\"{}\" takes at most {} values", key, each.size()),
            fmt::format("take away {}", items->size() - each.size()));
    return values;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    values.push_back(
        quantity_in((*items)[i], fmt::format("\"{}\", value {},", key, i + 1), each[i]));
  }
  return values;
}

std::vector<double> TableReader::per_direction(const Key& of, std::size_t count,
                                               const WantedDimension& wanted,
                                               std::string_view infinite,
                                               std::optional<double> fallback) {
  const std::string_view key = of.name;
  if (recording()) {
    note(of, KeyShape::per_direction,
         {.required = !fallback,
          .wanted = &wanted,
          .fallback = text_of(fallback, wanted),
          .words = infinite.empty() ? std::vector<std::string>{}
                                    : std::vector<std::string>{std::string(infinite)}});
  }
  const std::string or_infinite =
      infinite.empty() ? std::string() : fmt::format(", or \"{}\"", infinite);
  const Node* node =
      take_or_say(key, !fallback, fmt::format("write {} = {}{}", key, wanted.example, or_infinite));
  if (node == nullptr) return std::vector<double>(count, fallback.value_or(std::nan("")));
  const auto value_of = [&](const Node& item) {
    if (!infinite.empty() && item.kind == Node::Kind::text && item.text == infinite) {
      return std::numeric_limits<double>::infinity();
    }
    const double value = quantity_in(item, fmt::format("\"{}\"", key), wanted);
    if (value < 0.0) {
      problem(key, fmt::format("\"{}\" must not be below zero", key),
              fmt::format("write for example {}{}", wanted.example, or_infinite));
    }
    return value;
  };
  if (node->kind != Node::Kind::array) return std::vector<double>(count, value_of(*node));
  if (node->items.size() != count) {
    problem(key,
            count == 1
                ? fmt::format("\"{}\" is one value", key)
                : fmt::format("\"{}\" is one value, or one for each of {} directions", key, count),
            fmt::format("write for example {0} = {1}", key, wanted.example));
    return std::vector<double>(count, std::nan(""));
  }
  std::vector<double> values;
  for (const Node& item : node->items) values.push_back(value_of(item));
  return values;
}

}  // namespace boxbeam
