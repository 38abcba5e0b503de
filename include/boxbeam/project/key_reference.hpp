#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/key_record.hpp"

namespace boxbeam {

/// A key of a table, and in which kinds of the table it is known.
struct KeyDescription {
  /// `key` of the table is one of `words`.
  struct Only {
    std::string key;
    std::vector<std::string> words;

    friend bool operator==(const Only&, const Only&) = default;
  };

  AskedKey key;            ///< required: wherever it is known
  std::vector<Only> only;  ///< all of them hold; none: always known
};

/// Several ways to say one thing, and in which kinds of the table.
struct WaysDescription {
  KeyWays ways;
  std::vector<KeyDescription::Only> only;
};

/// All keys of a table, in the order in which the reader asks for them. A key that means something
/// else in another kind of the table stands once for each.
struct TableDescription {
  std::string pattern;  ///< "bodies.*"
  std::vector<KeyDescription> keys;
  std::vector<WaysDescription> ways;
};

/// The kinds of a case.
const std::vector<std::string>& case_kinds();

/// All tables of a case of a kind, as its reader asks for them while it reads the examples that are
/// part of the program. A word of a choice that no example writes is not described; the tests look
/// for one.
const std::vector<TableDescription>& key_reference_of(const std::string& case_kind);

}  // namespace boxbeam
