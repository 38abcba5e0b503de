#include "boxbeam/project/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/project/limits.hpp"
#include "node_kinds.hpp"

namespace boxbeam {
namespace {

/// The number that a text is, with or without a unit behind it, as it would stand by itself; "" of
/// anything else.
std::string number_in_quotes(const Node& node) {
  if (node.kind != Node::Kind::text) return "";
  const std::size_t end =
      std::min(node.text.find_first_not_of("0123456789+-.eE"), node.text.size());
  const std::string number = node.text.substr(0, end);
  const auto parsed = parse_quantity(number);
  return std::holds_alternative<ParsedQuantity>(parsed) ? number : "";
}

template <class Number>
std::string text_of(std::optional<Number> value) {
  return value ? fmt::format("{:g}", static_cast<double>(*value)) : "";
}

}  // namespace

double TableReader::bare_number(std::string_view key, std::optional<double> fallback,
                                bool above_zero, const char* example) {
  const Node* node = take(key, !fallback, "a number");
  if (node == nullptr) return fallback.value_or(std::nan(""));
  const std::string hint = fmt::format("write {} = {}", key, example);
  if (node->kind != Node::Kind::number) {
    const std::string number = number_in_quotes(*node);
    if (number.empty()) {
      problem(key, fmt::format("\"{}\" is a number without unit, not {}", key, kind_name(*node)),
              hint);
    } else {
      problem(key, fmt::format("\"{}\" is a number, which stands without quotation marks", key),
              fmt::format("write {} = {}", key, number));
    }
    return std::nan("");
  }
  const double value = node->number;
  const double size = std::abs(value);
  if (!std::isfinite(value)) {
    problem(key, fmt::format("\"{}\" must be finite", key), hint);
    return std::nan("");
  }
  if (above_zero && value <= 0.0) {
    problem(key, fmt::format("\"{}\" is {:g}, but must be above zero", key, value), hint);
    return std::nan("");
  }
  if (size > limits::largest_number || (size > 0.0 && size < smallest_number)) {
    problem(key, fmt::format("\"{}\" is too {} to be meant", key, size > 1.0 ? "large" : "small"),
            hint);
    return std::nan("");
  }
  return value;
}

double TableReader::number(const Key& of, std::optional<double> fallback, const char* example) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::number, {.required = !fallback, .fallback = text_of(fallback)});
  return bare_number(key, fallback, true, example);
}

double TableReader::any_number(const Key& of, std::optional<double> fallback) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::any_number, {.required = !fallback, .fallback = text_of(fallback)});
  return bare_number(key, fallback, false, "2.0");
}

int TableReader::whole_number(const Key& of, std::optional<int> fallback,
                              const std::vector<std::string>& known) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::whole_number,
         {.required = !fallback, .fallback = text_of(fallback), .words = known});
  const Node* node = take(key, !fallback, "a whole number");
  if (node == nullptr) return fallback.value_or(0);
  if (node->kind != Node::Kind::number || !node->whole || std::abs(node->number) > 1e9) {
    problem(key,
            fmt::format("\"{}\" is a whole number without unit, not {}", key,
                        node->kind == Node::Kind::number ? "a fraction" : kind_name(*node)),
            fmt::format("write {} = 100", key));
    return 0;
  }
  return static_cast<int>(node->number);
}

bool TableReader::boolean(const Key& of, bool fallback) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::boolean, {.fallback = fallback ? "true" : "false"});
  const Node* node = take(key, false, "");
  if (node == nullptr) return fallback;
  if (node->kind != Node::Kind::boolean) {
    problem(key, fmt::format("\"{}\" is true or false, not {}", key, kind_name(*node)),
            fmt::format("write {} = true or {} = false", key, key));
  }
  return node->boolean;
}

std::string TableReader::text(const Key& of, std::optional<std::string> fallback) {
  const std::string_view key = of.name;
  if (recording())
    note(of, KeyShape::text, {.required = !fallback, .fallback = fallback.value_or("")});
  const Node* node = take(key, !fallback, "\"...\"");
  if (node == nullptr) return fallback.value_or("");
  if (node->kind != Node::Kind::text) {
    problem(key, fmt::format("\"{}\" is a text, not {}", key, kind_name(*node)),
            fmt::format("write {} = \"...\"", key));
    return "";
  }
  if (node->text.empty() && !fallback) {
    problem(key, fmt::format("\"{}\" must not be empty", key),
            fmt::format("write {} = \"...\"", key));
  }
  return node->text;
}

std::vector<std::string> TableReader::texts(const Key& of, bool required) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::texts, {.required = required});
  std::vector<std::string> result;
  const Node* node = take(key, required, "[\"...\", \"...\"]");
  if (node == nullptr) return result;
  const bool all_text = node->kind == Node::Kind::array &&
                        std::all_of(node->items.begin(), node->items.end(),
                                    [](const Node& item) { return item.kind == Node::Kind::text; });
  if (!all_text) {
    problem(key, fmt::format("\"{}\" is a list of texts", key),
            fmt::format("write {} = [\"...\", \"...\"]", key));
    return result;
  }
  static_cast<void>(is_too_long(name_below(key), node->place, node->items.size()));
  for (const Node& item : node->items) result.push_back(item.text);
  return result;
}

std::size_t TableReader::choice(const Key& of, const std::vector<std::string>& words,
                                std::optional<std::size_t> fallback) {
  const std::string_view key = of.name;
  if (recording()) {
    note(of, KeyShape::choice,
         {.required = !fallback, .fallback = fallback ? words[*fallback] : "", .words = words});
  }
  const std::string list = fmt::format("\"{}\"", fmt::join(words, "\", \""));
  const Node* node = take(key, !fallback, fmt::format("\"{}\"", fmt::join(words, "\" or \"")));
  if (node == nullptr) return fallback.value_or(0);
  if (node->kind == Node::Kind::text) {
    const auto found = std::find(words.begin(), words.end(), node->text);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    const std::string near = nearest_word(node->text, words);
    problem(key, fmt::format("\"{}\" cannot be \"{}\"", key, node->text),
            near.empty() ? fmt::format("one of {}", list)
                         : fmt::format("did you mean \"{}\"? One of {}", near, list));
  } else {
    problem(key, fmt::format("\"{}\" is a text, not {}", key, kind_name(*node)),
            fmt::format("one of {}", list));
  }
  return fallback.value_or(0);
}

std::size_t TableReader::kind(const Key& key, const std::vector<std::string>& words) {
  const std::size_t index = choice(key, words);
  if (recording()) {
    (*problems_->recorder)[problems_->recorder->visit_of(*table_, pattern_)].choices.emplace_back(
        key.name, words[index]);
  }
  return index;
}

}  // namespace boxbeam
