#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"

namespace boxbeam {

/// Where something stands in a text.
struct Place {
  std::string_view file;  ///< kept alive by the document
  int line = 0;
  int column = 0;
};

/// A value of a case file with its place; independent of the TOML library.
struct Node {
  enum class Kind { table, array, text, number, boolean, other };
  struct Member;

  Kind kind = Kind::table;
  Place place;
  std::string text;  ///< of a text; of `other` the kind of TOML value ("a date")
  double number = 0.0;
  bool whole = false;  ///< whether the number is written as an integer
  bool boolean = false;
  std::vector<Member> members;  ///< of a table, in the order of the file
  std::vector<Node> items;      ///< of an array

  const Node* find(std::string_view key) const;
};

struct Node::Member {
  std::string key;
  Place key_place;
  Node value;
};

/// The SHA-256 of bytes, 64 hexadecimal digits.
std::string sha256_of(const std::string& bytes);

/// A file that a case names besides its own.
struct InputFile {
  std::string written;   ///< its path as it stands in the case
  std::string resolved;  ///< its path from the working folder, as in messages
  std::string sha256;    ///< of its bytes
};

/// A case file as read: its tree, its text for messages, and the hash that identifies the input.
struct CaseDocument {
  std::string path;
  Node root;
  std::map<std::string, std::vector<std::string>, std::less<>> lines;  ///< by file
  std::string
      sha256;  ///< of the file's bytes, and of a line "--set KEY=VALUE" per override behind it

  std::vector<InputFile> files;  ///< in the order in which the case is read, each once

  /// Takes the lines of a further file for messages, and its bytes for the hash.
  void add_file(const std::string& written, const std::string& resolved, const std::string& text);

  /// The same of a file that is not kept, for it may be large: its bytes for the hash, once.
  /// Throws InputError where it cannot be read.
  void add_large_file(const std::string& written, const std::string& resolved);

  /// Identifies the input with all its files: `sha256` where there are none, else the hash of the
  /// lines of hashes, `sha256` and one per file (sha256sum | cut -c1-64 | sha256sum).
  std::string sha256_of_input() const;

  Problem problem_at(const Place& place, std::string message, std::string hint = {}) const;
};

/// The parts of a dotted key, "beam.segments.0.length"; an empty one where a dot has none beside
/// it. A part with dots of its own stands in quotes: situations.1.set."drivers.crank.speed".
std::vector<std::string> key_parts(const std::string& key);

/// What stands under a dotted key, items of arrays by their number; nullptr where nothing does.
const Node* value_at(const Node& root, const std::string& key);

/// Puts a value under a key of a tree; tables on the way that are missing are made, and the item
/// behind the last one of an array is added. Returns what is wrong where the key leads into no
/// table or array item. Precondition: at least one part.
std::optional<std::string> set_value(Node& root, const std::vector<std::string>& parts,
                                     const Place& key_place, const Node& value);

/// Reads a TOML file and applies overrides "key.path=value"; items of arrays go by their number
/// from 0 ("beam.segments.0.length=2 m"), and the one behind the last is added. A value that is not
/// TOML is taken as text. Throws InputError: file missing, over 8 MB, not UTF-8, keys of more than
/// 32 parts, TOML syntax.
CaseDocument read_document(const std::string& path, const std::vector<std::string>& overrides);

/// The same for text in memory (the built-in catalogue, tests).
CaseDocument parse_document(const std::string& path, const std::string& text,
                            const std::vector<std::string>& overrides);

}  // namespace boxbeam
