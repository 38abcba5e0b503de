#include "key_documents.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/project/key_reference.hpp"

namespace boxbeam::report {
namespace {

std::string quoted(const std::vector<std::string>& words) {
  return fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

/// What stands behind a key, in words.
std::string value_text(const AskedKey& key) {
  const std::string example = key.example.substr(0, key.example.find(" or "));
  const auto each = [&](const char* words) {
    return fmt::format("{}, each {} as {}", words, key.dimension, example);
  };
  switch (key.shape) {
    case KeyShape::quantity: return fmt::format("{}, {}", key.dimension, example);
    case KeyShape::positive: return fmt::format("{} above zero, {}", key.dimension, example);
    case KeyShape::not_negative: return fmt::format("{}, zero or more, {}", key.dimension, example);
    case KeyShape::not_zero: return fmt::format("{}, not zero, {}", key.dimension, example);
    case KeyShape::pair: return each("[x, y]");
    case KeyShape::pairs: return each("[[y, z], ..]");
    case KeyShape::lists_of_pairs: return each("lists of [y, z]");
    case KeyShape::triple: return each("[x, y, z]");
    case KeyShape::symmetric: return each("[xx, yy, zz] or three rows");
    case KeyShape::direction: return "\"x\", \"-z\" or three numbers";
    case KeyShape::directions: return "three directions";
    case KeyShape::turns: return "[[\"x\", \"10 deg\"], ..]";
    case KeyShape::quantities: return each("a list");
    case KeyShape::each_quantity:
      return fmt::format("a list, {} and per s, s^2, ..", key.dimension);
    case KeyShape::per_direction:
      return fmt::format("{}, or one for each direction, {}{}", key.dimension, example,
                         key.words.empty() ? "" : ", or " + quoted(key.words));
    case KeyShape::number: return "a number above zero";
    case KeyShape::any_number: return "a number";
    case KeyShape::whole_number:
      return key.words.empty() ? "a whole number" : fmt::format("{}", fmt::join(key.words, ", "));
    case KeyShape::boolean: return "true or false";
    case KeyShape::text: return "a text";
    case KeyShape::texts: return "a list of texts";
    case KeyShape::choice: return quoted(key.words);
    case KeyShape::table: return "a table";
    case KeyShape::tables: return "tables";
    case KeyShape::table_or_tables: return "a table, or tables";
    case KeyShape::as_in_case: return "as in the case";
    case KeyShape::unknown: return "";
  }
  return "";
}

std::string only_text(const std::vector<KeyDescription::Only>& only) {
  std::string text;
  for (const KeyDescription::Only& each : only)
    text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", each.key, quoted(each.words));
  return text;
}

/// A bar would end the cell.
std::string markdown_cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

std::string rows_of(const TableDescription& table) {
  const bool kinds = std::any_of(table.keys.begin(), table.keys.end(),
                                 [](const KeyDescription& key) { return !key.only.empty(); });
  std::string text =
      kinds ? "| key | value | where not said | meaning | only with |\n|---|---|---|---|---|\n"
            : "| key | value | where not said | meaning |\n|---|---|---|---|\n";
  for (const KeyDescription& of : table.keys) {
    const AskedKey& key = of.key;
    const std::string fallback = key.required           ? "required"
                                 : key.fallback.empty() ? ""
                                                        : "`" + key.fallback + "`";
    text += fmt::format("| {} | {} | {} | {} |", key.name == "*" ? "a name" : "`" + key.name + "`",
                        markdown_cell(value_text(key)), markdown_cell(fallback),
                        markdown_cell(key.meaning));
    if (kinds) text += fmt::format(" {} |", markdown_cell(only_text(of.only)));
    text += "\n";
  }
  for (const WaysDescription& several : table.ways) {
    std::vector<std::string> words;
    bool may_be_silent = false;
    for (const KeyWay& way : several.ways) {
      if (way.keys.empty())
        may_be_silent = true;
      else
        words.push_back(fmt::format("`{}`", fmt::join(way.keys, way.all ? "` and `" : "`, `")));
    }
    text += fmt::format("\n{} of {}{}.\n", may_be_silent ? "At most one" : "One",
                        fmt::join(words, ", or "),
                        several.only.empty() ? "" : ", with " + only_text(several.only));
  }
  return text;
}

/// "[bodies.NAME.points]".
std::string title_of(const std::string& pattern) {
  if (pattern.empty()) return "The tables of a case";
  std::string title = pattern;
  for (std::size_t at; (at = title.find('*')) != std::string::npos;) title.replace(at, 1, "NAME");
  const bool list = title.ends_with("[]");
  for (std::size_t at; (at = title.find("[]")) != std::string::npos;) title.erase(at, 2);
  return list ? "[[" + title + "]]" : "[" + title + "]";
}

}  // namespace

std::string key_reference_text() {
  std::string text =
      "# Keys of a case\n\nWritten by `boxbeam schema keys` from what the program reads. Every "
      "dimensional value is text with its unit. NAME is a name of your own; [[..]] may stand "
      "several times.\n";
  // Where a table is the same in several kinds of case, it stands once.
  struct Section {
    std::string pattern, rows;
    std::vector<std::string> kinds;
  };
  std::vector<Section> sections;
  for (const std::string& kind : case_kinds()) {
    for (const TableDescription& table : key_reference_of(kind)) {
      const bool only_names =
          std::all_of(table.keys.begin(), table.keys.end(), [](const KeyDescription& key) {
            return key.key.name == "*" && key.key.shape == KeyShape::table;
          });
      if (only_names) continue;
      const std::string rows = rows_of(table);
      const auto same = std::find_if(sections.begin(), sections.end(), [&](const Section& each) {
        return each.pattern == table.pattern && each.rows == rows;
      });
      if (same != sections.end())
        same->kinds.push_back(kind);
      else
        sections.push_back({table.pattern, rows, {kind}});
    }
  }
  std::stable_sort(sections.begin(), sections.end(),
                   [](const Section& a, const Section& b) { return a.pattern < b.pattern; });
  for (const Section& section : sections) {
    const std::string kinds = section.kinds.size() == case_kinds().size()
                                  ? ""
                                  : fmt::format(" ({})", fmt::join(section.kinds, ", "));
    text += fmt::format("\n## {}{}\n\n{}", title_of(section.pattern), kinds, section.rows);
  }
  return text;
}

}  // namespace boxbeam::report
