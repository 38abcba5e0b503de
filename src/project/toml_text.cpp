#include "boxbeam/project/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace boxbeam {

std::string toml_quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + "\"";
}

std::string toml_key(const std::string& key) {
  const bool bare = !key.empty() && key.find_first_not_of(
                                        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789-_") == std::string::npos;
  return bare ? key : toml_quoted(key);
}

namespace {

std::string number_text(const Node& node) {
  if (node.whole) return fmt::format("{:.0f}", node.number);
  if (std::isnan(node.number)) return "nan";
  if (std::isinf(node.number)) return node.number > 0.0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", node.number);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

/// A value in one line.
std::string value_text(const Node& node) {
  switch (node.kind) {
    case Node::Kind::number: return number_text(node);
    case Node::Kind::boolean: return node.boolean ? "true" : "false";
    case Node::Kind::text:
    case Node::Kind::other: return toml_quoted(node.text);
    case Node::Kind::array: {
      std::string text;
      for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + value_text(item);
      return "[" + text + "]";
    }
    case Node::Kind::table: break;
  }
  std::string text;
  for (const Node::Member& member : node.members)
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", toml_key(member.key),
                        value_text(member.value));
  return text.empty() ? "{}" : "{" + text + " }";
}

bool is_tables(const Node& node) {
  return node.kind == Node::Kind::array && !node.items.empty() &&
         std::all_of(node.items.begin(), node.items.end(),
                     [](const Node& item) { return item.kind == Node::Kind::table; });
}

bool has_heading(const Node& node) { return node.kind == Node::Kind::table || is_tables(node); }

void write_table(const Node& table, const std::string& name, std::string& text) {
  for (const Node::Member& member : table.members) {
    if (!has_heading(member.value))
      text += fmt::format("{} = {}\n", toml_key(member.key), value_text(member.value));
  }
  for (const Node::Member& member : table.members) {
    if (!has_heading(member.value)) continue;
    const std::string whole =
        name.empty() ? toml_key(member.key) : name + "." + toml_key(member.key);
    if (member.value.kind == Node::Kind::table) {
      // A table that only holds others needs no heading.
      const bool bare = !member.value.members.empty() &&
                        std::all_of(member.value.members.begin(), member.value.members.end(),
                                    [](const Node::Member& of) { return has_heading(of.value); });
      if (!bare) text += fmt::format("\n[{}]\n", whole);
      write_table(member.value, whole, text);
    } else {
      for (const Node& item : member.value.items) {
        text += fmt::format("\n[[{}]]\n", whole);
        write_table(item, whole, text);
      }
    }
  }
}

}  // namespace

std::string toml_text(const Node& root) {
  std::string text;
  write_table(root, "", text);
  return text;
}

}  // namespace boxbeam
