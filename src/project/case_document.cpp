#include "boxbeam/project/case_document.hpp"

#include <fmt/format.h>
#include <sha256.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "case_text.hpp"
#include "text_file.hpp"
#include "toml_hint.hpp"

namespace boxbeam {
namespace {

/// toml++ recurses once per part of a dotted key and overflows the stack on very many.
constexpr int most_key_parts = 32;

/// The place where a dotted key gets too many parts, or npos. Strings and comments are passed over.
std::size_t find_overlong_key(const std::string& text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '"' || c == '\'') {
      const std::string fence(text.compare(i, 3, std::string(3, c)) == 0 ? 3U : 1U, c);
      std::size_t end = i + fence.size();
      while (end < text.size() && text.compare(end, fence.size(), fence) != 0) {
        if (fence.size() == 1 && text[end] == '\n') break;
        end += c == '"' && text[end] == '\\' ? 2 : 1;
      }
      i = std::min(end + fence.size(), text.size()) - 1;
    } else if (c == '.') {
      if (++dots >= most_key_parts) return i;
    } else if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-' &&
               c != ' ' && c != '\t') {
      dots = 0;
    }
  }
  return std::string::npos;
}

/// Where the part of a key ends that begins here: at this character outside quotes, or at the end.
std::size_t end_of_part(std::string_view text, char at) {
  char fence = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (fence != '\0')
      fence = c == fence ? '\0' : fence;
    else if (c == at)
      return i;
    else if (c == '"' || c == '\'')
      fence = text.find(c, i + 1) == std::string_view::npos ? '\0' : c;
  }
  return text.size();
}

/// A part of a key without blanks around it and without its quotes.
std::string part_in(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') &&
                      text.find(text.front(), 1) == text.size() - 1;
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

class TreeBuilder {
 public:
  explicit TreeBuilder(std::string_view file) : file_(file) {}

  Node node(const toml::node& source) const {
    Node result;
    result.place = place(source.source());
    if (const auto* table = source.as_table()) {
      result.kind = Node::Kind::table;
      for (const auto& [key, value] : *table) {
        result.members.push_back({std::string(key.str()), place(key.source()), node(value)});
      }
      std::stable_sort(result.members.begin(), result.members.end(),
                       [](const Node::Member& a, const Node::Member& b) {
                         return std::pair(a.key_place.line, a.key_place.column) <
                                std::pair(b.key_place.line, b.key_place.column);
                       });
    } else if (const auto* array = source.as_array()) {
      result.kind = Node::Kind::array;
      for (const auto& item : *array) result.items.push_back(node(item));
    } else if (const auto text = source.value_exact<std::string>()) {
      result.kind = Node::Kind::text;
      result.text = *text;
    } else if (const auto integer = source.value_exact<std::int64_t>()) {
      result.kind = Node::Kind::number;
      result.number = static_cast<double>(*integer);
      result.whole = true;
    } else if (const auto number = source.value_exact<double>()) {
      result.kind = Node::Kind::number;
      result.number = *number;
    } else if (const auto boolean = source.value_exact<bool>()) {
      result.kind = Node::Kind::boolean;
      result.boolean = *boolean;
    } else {
      result.kind = Node::Kind::other;
      result.text = "a date or time";
    }
    return result;
  }

 private:
  Place place(const toml::source_region& region) const {
    return {file_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
  }

  std::string_view file_;
};

/// Parses one text and adds its lines to the document.
Node parse_text(CaseDocument& document, const std::string& name, const std::string& text) {
  const auto entry = document.lines.insert_or_assign(name, split_lines(text)).first;
  const std::string_view file = entry->first;
  const auto fail = [&](LineColumn at, std::string message, std::string hint) {
    throw InputError(
        {document.problem_at({file, at.line, at.column}, std::move(message), std::move(hint))});
  };
  if (const std::size_t at = find_not_utf8(text); at != std::string::npos) {
    fail(position_of(text, at), "the file is not UTF-8 text", "save it with UTF-8 encoding");
  }
  if (const std::size_t at = find_overlong_key(text); at != std::string::npos) {
    fail(position_of(text, at), fmt::format("a key of more than {} parts", most_key_parts),
         "no key of a case has that many dots");
  }
  try {
    return TreeBuilder(file).node(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    Problem problem =
        document.problem_at({file, static_cast<int>(at.line), static_cast<int>(at.column)},
                            fmt::format("not valid TOML: {}", error.description()));
    problem.hint = toml_hint(problem.source_line, problem.column, error.description());
    throw InputError({std::move(problem)});
  }
}

template <class AnyNode>
AnyNode* step_into(AnyNode& node, const std::string& part) {
  if (node.kind == Node::Kind::array) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    const bool whole = error == std::errc{} && end == part.data() + part.size();
    return whole && index < node.items.size() ? &node.items[index] : nullptr;
  }
  for (auto& member : node.members) {
    if (member.key == part) return &member.value;
  }
  return nullptr;
}

constexpr const char* array_hint =
    "items of an array go by their number from 0: beam.segments.0.length";

/// An override stands in the one line of its own.
void put_at(Node& node, const Place& place) {
  node.place = place;
  for (Node& item : node.items) put_at(item, place);
  for (Node::Member& member : node.members) {
    member.key_place = place;
    put_at(member.value, place);
  }
}

/// Whether a value is a number with a unit behind it, "16 mm": no TOML, whatever follows.
bool is_quantity_text(const std::string& value) {
  const std::size_t space = value.find_first_not_of("+-.0123456789eE");
  return space != 0 && space < value.size() && value[space] == ' ' && space + 1 < value.size() &&
         std::isalpha(static_cast<unsigned char>(value[space + 1])) != 0 &&
         std::isalpha(static_cast<unsigned char>(value[0])) == 0;
}

/// What stands behind KEY=: a number, true, a quoted text or an array as TOML; anything else is
/// the text itself.
Node override_value(const std::string& source, const std::string& value) {
  Node text;
  text.kind = Node::Kind::text;
  text.text = value;
  if (is_quantity_text(value)) return text;
  try {
    CaseDocument scratch;
    const Node table = parse_text(scratch, source, "value = " + value + "\n");
    if (table.members.size() == 1 && table.members.front().value.kind != Node::Kind::other)
      return table.members.front().value;
  } catch (const InputError&) {
  }
  return text;
}

void apply_override(CaseDocument& document, const std::string& override_text) {
  const std::string source = "--set " + override_text;
  const std::size_t equals = end_of_part(override_text, '=');
  if (find_not_utf8(override_text) != std::string::npos) {
    throw InputError("the text behind --set is not UTF-8", "write it with UTF-8 encoding");
  }
  const std::vector<std::string> parts =
      key_parts(equals == override_text.size() ? "" : override_text.substr(0, equals));
  const bool empty_part = std::find(parts.begin(), parts.end(), "") != parts.end();
  if (parts.empty() || empty_part || parts.size() > most_key_parts) {
    throw InputError(fmt::format("--set wants KEY=VALUE, not \"{}\"", override_text),
                     "--set bodies.sledge.mass=\"20 t\"");
  }
  Node parsed = override_value(source, override_text.substr(equals + 1));
  const auto entry = document.lines.insert_or_assign(source, std::vector{source}).first;
  const Place place{entry->first, 1, static_cast<int>(std::string("--set ").size() + equals + 2)};
  const Place key_place{entry->first, 1, static_cast<int>(std::string("--set ").size()) + 1};
  put_at(parsed, place);

  if (const auto trouble = set_value(document.root, parts, key_place, parsed)) {
    throw InputError({document.problem_at(key_place, *trouble, array_hint)});
  }
}

}  // namespace

std::string sha256_of(const std::string& bytes) {
  char digest[SHA256_DIGEST_STRING_LENGTH];
  SHA256Data(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), digest);
  return digest;
}

std::vector<std::string> key_parts(const std::string& key) {
  std::vector<std::string> parts;
  std::string_view rest = key;
  while (true) {
    const std::size_t end = end_of_part(rest, '.');
    parts.push_back(part_in(rest.substr(0, end)));
    if (end == rest.size()) return parts;
    rest.remove_prefix(end + 1);
  }
}

const Node* value_at(const Node& root, const std::string& key) {
  const Node* node = &root;
  for (const std::string& part : key_parts(key)) {
    node = step_into(*node, part);
    if (node == nullptr) return nullptr;
  }
  return node;
}

std::optional<std::string> set_value(Node& root, const std::vector<std::string>& parts,
                                     const Place& key_place, const Node& value) {
  Node* node = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    Node* next = step_into(*node, parts[i]);
    if (next == nullptr && node->kind == Node::Kind::table) {
      node->members.push_back({parts[i], key_place, Node{}});
      next = &node->members.back().value;
      next->place = key_place;
    }
    if (next == nullptr || (next->kind != Node::Kind::table && next->kind != Node::Kind::array)) {
      return fmt::format("the case has no \"{}\" to set something in", parts[i]);
    }
    node = next;
  }
  if (Node* old = step_into(*node, parts.back())) {
    *old = value;
  } else if (node->kind == Node::Kind::table) {
    node->members.push_back({parts.back(), key_place, value});
  } else if (parts.back() == std::to_string(node->items.size())) {
    node->items.push_back(value);
  } else {
    return fmt::format("there is no item {} to set", parts.back());
  }
  return std::nullopt;
}

const Node* Node::find(std::string_view key) const {
  for (const Member& member : members) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

Problem CaseDocument::problem_at(const Place& place, std::string message, std::string hint) const {
  Problem problem{std::string(place.file), place.line,     place.column, {},
                  std::move(message),      std::move(hint)};
  const auto found = lines.find(place.file);
  const auto index = static_cast<std::size_t>(place.line) - 1;
  if (found != lines.end() && place.line > 0 && index < found->second.size()) {
    problem.source_line = found->second[index];
  }
  return problem;
}

void CaseDocument::add_file(const std::string& written, const std::string& resolved,
                            const std::string& text) {
  lines.insert_or_assign(resolved, split_lines(text));
  files.push_back({written, resolved, sha256_of(text)});
}

void CaseDocument::add_large_file(const std::string& written, const std::string& resolved) {
  if (std::any_of(files.begin(), files.end(),
                  [&](const InputFile& file) { return file.resolved == resolved; })) {
    return;
  }
  char digest[SHA256_DIGEST_STRING_LENGTH];
  if (SHA256File(resolved.c_str(), digest) == nullptr)
    throw InputError(fmt::format("{}: cannot be read", resolved));
  files.push_back({written, resolved, digest});
}

std::string CaseDocument::sha256_of_input() const {
  if (files.empty()) return sha256;
  std::string hashes = sha256 + "\n";
  for (const InputFile& file : files) hashes += file.sha256 + "\n";
  return sha256_of(hashes);
}

std::string read_case_text(const std::string& path) {
  FileText file = read_text_file(path);
  const auto hint = [&]() -> std::string {
    switch (file.trouble) {
      case FileText::Trouble::missing: return "give the path of a case file (.toml)";
      case FileText::Trouble::folder: return "give a case file in it (.toml)";
      case FileText::Trouble::too_large: return "a case file is a few kB of TOML";
      default: return "";
    }
  };
  if (file.trouble != FileText::Trouble::none) {
    throw InputError({Problem{path, 0, 0, {}, file.why, hint()}});
  }
  return std::move(file.text);
}

void apply_overrides(CaseDocument& document, const std::string& text,
                     const std::vector<std::string>& overrides) {
  std::string hashed = text;
  for (const std::string& override_text : overrides) {
    apply_override(document, override_text);
    hashed += "\n--set " + override_text;
  }
  document.sha256 = sha256_of(hashed);
}

CaseDocument parse_document(const std::string& path, const std::string& text,
                            const std::vector<std::string>& overrides) {
  CaseDocument document;
  document.path = path;
  document.root = parse_text(document, path, text);
  apply_overrides(document, text, overrides);
  return document;
}

CaseDocument read_document(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_document(path, read_case_text(path), overrides);
}

}  // namespace boxbeam
