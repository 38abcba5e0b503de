#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/quantity_text.hpp"

/// What the reader of a case asks for. The reading functions are the one place where a key, its
/// kind, its unit, its default and its meaning stand; schema and reference are written from what
/// they ask.
namespace boxbeam {

/// A key of a table, and in a few words what it means.
struct Key {
  std::string_view name;
  std::string_view meaning;

  Key(const char* key, std::string_view what = {}) : name(key), meaning(what) {}
  Key(std::string_view key, std::string_view what = {}) : name(key), meaning(what) {}
  Key(const std::string& key, std::string_view what = {}) : name(key), meaning(what) {}
};

/// What stands behind a key.
enum class KeyShape {
  unknown,  ///< only whether it is there has been asked
  quantity,
  positive,      ///< a quantity above zero
  not_negative,  ///< a quantity, zero or more
  not_zero,      ///< a quantity, but not zero
  pair,          ///< two quantities
  pairs,         ///< any number of pairs
  lists_of_pairs,
  triple,
  symmetric,   ///< a symmetric matrix: its diagonal, or three rows
  direction,   ///< "x", "-y" or three numbers
  directions,  ///< three of them
  turns,       ///< turns about axes, one after the other
  quantities,
  each_quantity,  ///< each of a dimension of its own
  per_direction,  ///< one quantity, or one for each direction
  number,         ///< above zero
  any_number,
  whole_number,
  boolean,
  text,
  texts,
  choice,
  table,
  tables,
  table_or_tables,  ///< one, or any number of them
  as_in_case,       ///< what stands under this key in the case itself, or a part of it
};

/// A key as it was asked for.
struct AskedKey {
  std::string name;  ///< "*": a name of the user's own
  KeyShape shape = KeyShape::unknown;
  std::string dimension, example;  ///< "a length", "\"0.25 m\""; of the first of several
  DimensionExponents exponents;
  std::vector<std::string> words;  ///< of a choice; of a quantity what may stand instead of one
  std::string fallback;            ///< what holds where the key is missing; "" nothing is said
  bool required = false;
  /// Keys and words of theirs with which it is required: "connect" with "ground".
  std::vector<std::pair<std::string, std::string>> required_with;
  std::string meaning;
};

/// A way to say something, by its keys.
struct KeyWay {
  std::vector<std::string> keys;  ///< none: it is not said at all
  bool all = true;                ///< all of them are wanted, not only one

  friend bool operator==(const KeyWay&, const KeyWay&) = default;
};

/// Several ways to say one thing, of which a table has exactly one.
using KeyWays = std::vector<KeyWay>;

/// One table that was read.
struct TableVisit {
  std::string pattern;  ///< "beam.segments[]", "bodies.*.points", "" of the whole case
  std::vector<std::pair<std::string, std::string>> choices;  ///< that decide the other keys
  std::vector<AskedKey> keys;
  std::vector<KeyWays> ways;

  const AskedKey* find(std::string_view key) const;
};

/// Every table that was read, in the order of reading.
class KeyRecorder {
 public:
  /// Begins another case, whose tables may stand where those of the last one stood.
  void begin_case() { known_.clear(); }
  /// The visit of a table, begun where there is none yet.
  std::size_t visit_of(const Node& table, const std::string& pattern);
  TableVisit& operator[](std::size_t visit) { return visits_[visit]; }
  const std::vector<TableVisit>& visits() const { return visits_; }

 private:
  std::vector<TableVisit> visits_;
  std::map<std::pair<const Node*, std::string>, std::size_t> known_;
};

/// Reads a case and notes all that its reader asks for. Throws InputError as parse_project.
void record_keys(const std::string& path, const std::string& text, KeyRecorder& recorder);

}  // namespace boxbeam
